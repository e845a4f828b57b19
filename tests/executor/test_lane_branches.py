"""Limbs in SIMD lanes that hang on links of other lanes, in all ways: several may share a link."""

from __future__ import annotations

from itertools import combinations_with_replacement

import numpy as np
import pytest

from adagen.executor import Grouping, interpret, straight_line
from adagen.model import REVOLUTE, Model
from adagen.plan import Plan
from adagen.plan.simd_groups import Limbs
from adagen.states import random_states
from tests.emitted import ROUNDING, forward_error, plan_of, truth_of
from tests.models import Part, assemble, random_inertia, random_rotation

COUNTS = (2, 3, 4)


def branching(inner: int, hangs_on: tuple[int, ...], length: int = 1) -> Model:
    """Return hinges on the ground, and limbs of hinges that hang on the links of given ones."""
    rng = np.random.default_rng(3)

    def part(name: str, above: str | None) -> Part:
        place = rng.uniform(-0.3, 0.3, size=3)
        return Part(name, above, REVOLUTE, random_inertia(rng), place, random_rotation(rng))

    near = [part(f"inner{k}", None) for k in range(inner)]
    parts = near.copy()
    for n, k in enumerate(hangs_on):
        above = near[k].name
        for place in range(length):
            parts.append(part(f"outer{n}_{place}", above))
            above = parts[-1].name
    return assemble("branching", parts)


def grouping(plan: Plan) -> Grouping:
    """Return the inner hinges in lanes, and the outer ones."""
    rows = (
        tuple(j for j, joint in enumerate(plan.joints) if joint.name.startswith(name))
        for name in ("inner", "outer")
    )
    return (tuple(Limbs((row,)) for row in rows),)


@pytest.mark.parametrize("outer", COUNTS)
@pytest.mark.parametrize("inner", COUNTS)
def test_branches_from_lanes_are_true(inner: int, outer: int) -> None:
    for hangs_on in combinations_with_replacement(range(inner), outer):
        model = branching(inner, hangs_on)
        plan, states = plan_of(model, 1), random_states(model, 2, seed=1)
        found = [interpret(plan, *row, lanes=grouping(plan)) for row in states.each]
        error = forward_error(np.array(found), truth_of(model, states))
        assert error < ROUNDING["double"], hangs_on


def test_branches_are_reproducible_in_lanes() -> None:
    """A limb that hangs on the idle lane of a row reads there what the lane before holds."""
    model = branching(3, (0, 1, 2, 2), length=5)
    plan, states = plan_of(model, 1, reproducible=True), random_states(model, 2, seed=1)
    (line,) = straight_line(plan)
    assert {row.count for row in line.machine.rows.rows.values()} == {3, 4}
    alone, together = (
        [interpret(plan, *row, lanes=lanes) for row in states.each] for lanes in (False, True)
    )
    np.testing.assert_array_equal(alone, together)
    assert forward_error(np.array(alone), truth_of(model, states)) < ROUNDING["double"]
