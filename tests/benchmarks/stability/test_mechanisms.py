"""Random mechanisms of every family: no answer is wrong in silence."""

from __future__ import annotations

import pytest

from benchmarks.stability.mechanisms import FAMILIES, Outcome, audit, mechanisms
from tests.slow import spread


@pytest.mark.parametrize("family", spread(FAMILIES, 3))
def test_mechanisms_are_right_or_refused(family: str) -> None:
    outcome = Outcome()
    found = [model for name, model in mechanisms(2 * len(FAMILIES), seed=7) if name == family]
    assert len(found) == 2
    for model in found:
        audit(model, 4, outcome)
    assert (outcome.wrong, outcome.strange) == (0, 0)
    assert outcome.answered > 0
    assert outcome.worst < 1e-8
