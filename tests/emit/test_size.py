"""161 degrees of freedom on 4 processes: what is emitted stays small."""

from __future__ import annotations

import pytest

from adagen.emit import emit
from adagen.plan import FORMS, plan_from_json
from tests.emitted import plan_of
from tests.large import human161


@pytest.mark.parametrize("form", FORMS)
def test_a_robot_of_161_degrees_of_freedom_is_emitted_within_bounds(form: str) -> None:
    model = human161()
    assert model.nv == 161
    plan = plan_of(model, 4, form=form)
    files = emit(plan, name="human161")
    assert len(files["human161_p4.cpp"].encode()) < 2 * 2**20
    assert max(len(line) for line in files["human161_p4.cpp"].splitlines()) < 2000
    assert plan_from_json(files["human161_p4.plan.json"]) == plan
