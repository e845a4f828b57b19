"""What every family of plans computes, against the true answers of the shared robots."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from adagen.executor import interpret
from adagen.model import Model
from adagen.plan import Plan, can_gather, make_plan
from adagen.plan.clusters import fold_of
from adagen.schedule import load_profile
from adagen.search import named_schedule
from tests.reference.test_reference_truth import SHARED, loaded
from tests.slow import spread

PROFILE = load_profile("default")
CASES = [
    pytest.param(path, mode, id=f"{path.stem}-{mode}")
    for path in sorted(SHARED.glob("real/*.json"))
    for mode, told in json.loads(path.read_text())["modes"].items()
    if told["status"] == "ok"
] or [pytest.param(None, "", marks=pytest.mark.skip("no shared robots here"))]


def plans(model: Model, processes: int) -> list[Plan]:
    """Return a plan of each family."""
    found = []
    for form, meeting in (("segment", "join"), ("segment", "gather"), ("ada", "join")):
        seen = fold_of(model, form)
        names = named_schedule("balanced", seen.topology, processes, profile=PROFILE)
        # Nothing is inverted beside links without inertia, which the search sees to.
        massive = all(link.inertia.tensor.diagonal().min() > 0 for link in model.links[1:])
        if meeting == "join" or (can_gather(model) and massive):
            schedule = seen.unfold(names, PROFILE)
            found.append(make_plan(model, schedule, form=form, meeting=meeting))
    return found


@pytest.mark.parametrize(("path", "mode"), spread(CASES, 9))
def test_true_answers_on_up_to_four_processes(path: Path, mode: str, tmp_path: Path) -> None:
    model, states, truth, told = loaded(path, mode, tmp_path)
    reached = told["check"].get("rel_pin_crba_solve")
    tolerance = max(1e-9, 1000 * min(1e-6, reached if isinstance(reached, float) else 0.0))
    for processes in (1, 2, 3, 4):
        for plan in plans(model, processes):
            k = processes - 1  # another state each
            found = interpret(plan, states.q[k], states.v[k], states.tau[k], once=True)
            error = np.abs(found - truth[k]).max() / max(1.0, np.abs(truth[k]).max())
            assert error < tolerance, (plan.form, processes)
