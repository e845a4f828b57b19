"""Energy bounds of limbs that move as one body, beside the energies of such motions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import numpy as np
import pytest
from numpy.typing import NDArray

from adagen.executor import certificate, shared_bound
from adagen.executor.allowance import Allowance
from adagen.executor.grouping import offered_groupings
from adagen.executor.refine import WideLinks
from adagen.executor.run import lines_of
from adagen.executor.shared_bound import Heard
from adagen.executor.solve import Run
from adagen.graph import DOUBLE, Expression
from adagen.model import PRISMATIC, REVOLUTE, SPHERICAL, Model
from adagen.plan import Plan
from adagen.plan.limb_spread import Spread, beyond_held
from adagen.plan.steps import Certify
from adagen.states import random_states
from benchmarks.stability.bounds import certified_plan, plan_elsewhere
from tests.models import random_tree, serial_chain, star

Array = NDArray[np.float64]
MOVING = (REVOLUTE, PRISMATIC, SPHERICAL)
Told = tuple[Allowance, Spread, int, list[Expression]]


def _tree(seed: int, joints: int, *, floating: bool) -> Model:
    return random_tree(np.random.default_rng(seed), joints, floating=floating, kinds=MOVING)


CASES: dict[str, tuple[Callable[[], Model], Callable[[Model], Plan]]] = {
    "chain elsewhere": (lambda: serial_chain(30), plan_elsewhere),
    "longer chain elsewhere": (lambda: serial_chain(44), plan_elsewhere),
    "floating tree elsewhere": (lambda: _tree(7, 45, floating=True), plan_elsewhere),
    "long limbs": (lambda: star(4, 11, floating=True), partial(certified_plan, processes=2)),
    "long limbs of three": (lambda: star(6, 11), partial(certified_plan, processes=3)),
    "short tree": (lambda: _tree(6, 45, floating=True), partial(certified_plan, processes=2)),
    "short limbs": (lambda: star(3, 3, floating=True), partial(certified_plan, processes=2)),
}
BY_OFFSETS = {"short tree", "short limbs"}


@pytest.mark.parametrize("lanes", [False, True], ids=["single", "in lanes"])
@pytest.mark.parametrize("name", CASES)
def test_limbs_take_no_more_for_moving_as_one_body(
    name: str, lanes: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whole limbs are bounded, of other processes too, and by not much more than they can take."""
    robot, planned = CASES[name]
    model = robot()
    plan, told = planned(model), list[Told]()
    honest = shared_bound.spread_of

    def kept(
        found: Allowance, limbs: Spread, link: int, shares: Sequence[Heard] = ()
    ) -> list[Expression]:
        told.append((found, limbs, link, honest(found, limbs, link, shares)))
        return told[-1][-1]

    for module in (certificate, shared_bound):
        monkeypatch.setattr(module, "spread_of", kept)
    grouping = next((g for g in offered_groupings(plan) if any(g)), False) if lanes else False
    assert grouping or not lanes or "limbs" not in name
    lines_of.cache_clear()
    rng = np.random.default_rng(1)
    for q, v, tau in random_states(model, 4, seed=3).each:
        run = Run(plan, {"q": q, "v": v, "tau": tau}, DOUBLE, lanes=grouping)
        assert told
        for found, limbs, link, bounds in told:
            (p,) = (k for k, each in enumerate(run.machines) if each is found.state)
            turning, sliding = (float(x) for x in run.of(p, bounds))
            body = _composite(plan, (q, v), _moved(plan, p), link)
            for move in rng.normal(size=(20, 6)):
                energy, x, y = move @ body @ move, move[:3], move[3:]
                assert 0 < energy <= turning * x @ x + sliding * y @ y
            if limbs.distances or limbs.hears:
                assert turning <= 6 * np.trace(body[:3, :3])
                assert sliding <= 8 * body[3, 3] * (1 + 1e-12)
    lines_of.cache_clear()
    assert (name in BY_OFFSETS) != any(limbs.distances for _, limbs, _, _ in told)


def _moved(plan: Plan, p: int) -> Sequence[int]:
    """The joints whose links a process bounds: its own limbs', or all beyond a held link."""
    if p == 0:
        return beyond_held(plan, plan.processes[0].steps)
    (joints,) = (step.joints for step in plan.processes[p].steps_of(Certify))
    return joints


def _composite(plan: Plan, state: tuple[Array, Array], joints: Sequence[int], link: int) -> Array:
    """The inertia of links beyond joints that move as one body with a link, about its origin."""
    frames = WideLinks(plan, *state, np.float64)
    places = {link: (np.eye(3), np.zeros(3))}
    body = np.zeros((6, 6))
    for j in sorted(joints):
        if plan.joints[j].parent not in places:
            continue
        near, place = places[plan.joints[j].parent]
        axes, place = near @ frames.turn[j].T, place + near @ frames.shift[j]
        places[j + 1] = axes, place
        own = plan.links[j + 1]
        c = place + axes @ own.com
        lever = np.hstack([-_cross(c), np.eye(3)])  # of the centre of mass, by the link's motion
        body += own.mass * lever.T @ lever
        body[:3, :3] += axes @ np.array(own.tensor) @ axes.T
    return body


def _cross(x: Array) -> Array:
    """The matrix that crosses x with a vector."""
    return -np.cross(np.eye(3), x).T
