"""Closures in SIMD lanes that are alike, but not what hangs on them, nor what they hang on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np
import pytest

from adagen.executor import Grouping, groupings, interpret
from adagen.model import REVOLUTE, Model, NamedCoupling
from adagen.plan import Plan
from adagen.plan.refine import corrected
from adagen.reference.closed import closed_forward_dynamics
from adagen.states import States
from tests.executor.plans import in_lanes_off
from tests.executor.test_closed_lanes import lanes_of
from tests.executor.test_closures import plan_of, worst
from tests.mechanisms import between, standing, states_of, with_loops
from tests.models import Part, assemble, random_inertia, random_rotation

COUNTS = (2, 3)
PAIR = ("near", "far")
"""Two hinges that are geared to each other: the smallest closure."""


def geared_pairs(
    hang_on: Sequence[str | None], beside: Sequence[tuple[str, str | None]] = ()
) -> Model:
    """Return pairs of geared hinges near0, far0, near1, ... and other hinges.

    Args:
        hang_on: what each pair hangs on: a hinge, or the ground.
        beside: other hinges, and what each of them hangs on.
    """
    rng = np.random.default_rng(5)

    def part(name: str, above: str | None) -> Part:
        place = rng.uniform(-0.3, 0.3, size=3)
        return Part(name, above, REVOLUTE, random_inertia(rng), place, random_rotation(rng))

    pairs = [
        part(name, above)
        for n, on in enumerate(hang_on)
        for name, above in ((f"near{n}", on), (f"far{n}", f"near{n}"))
    ]
    gears = [
        NamedCoupling(f"gear{n}", ((f"near{n}", 1.0), (f"far{n}", 2.0 + n)), 0.1)
        for n in range(len(hang_on))
    ]
    others = [part(name, above) for name, above in beside]
    made = {each.name: each for each in (*pairs, *others)}
    return with_loops(assemble("pairs", _inner_first(made)), (), tuple(gears))


def _inner_first(parts: dict[str, Part]) -> list[Part]:
    """Parts in an order in which each follows what it hangs on."""
    found: list[Part] = []
    while len(found) < len(parts):
        known = {None, *(each.name for each in found)}
        found += [p for p in parts.values() if p.name not in known and p.parent in known]
    return found


def off(model: Model, expected: list[int] | None = None) -> float:
    """Return the error of a robot in all groupings of its joints in lanes, by dense algebra."""
    plan, states = plan_of(model), states_of(model, 2)
    offers = groupings(plan)
    if expected is not None:
        assert expected in [lanes_of(plan, grouping) for grouping in offers]
    return max(_worst_in(model, plan, states, grouping) for grouping in offers)


def _worst_in(model: Model, plan: Plan, states: States, grouping: Grouping) -> float:
    errors = []
    for state in states.each:
        truth = closed_forward_dynamics(model, *state)
        found = interpret(plan, *state, lanes=grouping)
        errors.append(np.abs(found - truth).max() / np.abs(truth).max())
    return float(max(errors))


@pytest.mark.parametrize("count", COUNTS)
def test_a_limb_on_one_lane_of_closures(count: int) -> None:
    """Links of a closure move as one body only where nothing hangs on them in any lane."""
    for lane, name in product(range(count), PAIR):
        model = geared_pairs(["body"] * count, [("body", None), ("tail", f"{name}{lane}")])
        assert off(model, [count]) < 1e-12, (lane, name)


@pytest.mark.parametrize("count", COUNTS)
def test_some_closures_on_the_ground(count: int) -> None:
    """What closes on the ground hands nothing on: it shares no lanes with what does.

    Lanes are in the order of names.
    """
    for body in ("body", "trunk"):
        for hang_on in product((None, body), repeat=count):
            assert off(geared_pairs(hang_on, [(body, None)])) < 1e-12, hang_on


def test_closures_and_limbs_that_would_wait_for_each_other() -> None:
    """One hangs on the limb that shares lanes with what hangs on the other."""
    assert off(geared_pairs([None, "inner"], [("inner", None), ("outer", "far0")])) < 1e-12


@pytest.mark.parametrize("hang_on", ["near0", "far0"])
def test_closures_on_links_of_closures(hang_on: str) -> None:
    assert off(geared_pairs(["body", hang_on, "body"], [("body", None)])) < 1e-12


@pytest.mark.parametrize("hang_on", ["near0", "far0", "near1"])
def test_a_foot_on_the_ground_beyond_one_of_two_closures(hang_on: str) -> None:
    """What it is seen by is in no lanes; nor then is the closure that it hangs on."""
    leg = [("hip", hang_on), ("knee", "hip"), ("ankle", "knee"), ("toe", "ankle")]
    tree = geared_pairs(["body", "body"], [("body", None), *leg])
    held = replace(standing(tree, "point", "toe_link"), couplings=tree.couplings)
    assert off(held) < 1e-11


def test_a_loop_between_two_limbs_on_the_ground() -> None:
    """Both arms hold the ground and each other: rows depend on the joints of both."""
    rng = np.random.default_rng(2)
    parts = []
    for arm, j in product("ab", range(7)):
        above = f"{arm}{j - 1}" if j else None
        place, turn = rng.uniform(-0.3, 0.3, size=3), random_rotation(rng)
        parts.append(Part(f"{arm}{j}", above, REVOLUTE, random_inertia(rng), place, turn))
    tree = assemble("arms", parts)
    ground = tree.links[0].name
    ties = (
        ("point", "a6_link", ground),
        ("point", "b6_link", ground),
        ("point", "a6_link", "b6_link"),
    )
    model = between(tree, *ties)
    assert worst(model, plan_of(model), states_of(model, 3)) < 1e-9


def test_a_prescribed_joint_of_a_loop_is_left_as_it_is_by_corrections() -> None:
    model = geared_pairs(["body", "body"], [("body", None), ("tail", "far0")])
    joints = [replace(j, prescribed=j.name in ("body", "near1")) for j in model.joints]
    model = replace(model, joints=tuple(joints))
    plan, states = plan_of(model), states_of(model, 2)
    assert in_lanes_off(corrected(plan, 1), states, groupings(plan)[-1]) < 1e-12
