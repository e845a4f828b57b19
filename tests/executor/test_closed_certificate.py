"""Certificates of closed loops as the executor carries them out: bounds beside true errors."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from adagen.errors import UsageError
from adagen.executor import simulate
from adagen.executor.elimination import Elimination
from adagen.executor.front import Freed
from adagen.executor.grouping import groupings_of, offered_groupings
from adagen.executor.lanes import Grouping
from adagen.executor.refine import WideLinks
from adagen.executor.run import lines_of
from adagen.executor.solve import Run
from adagen.graph import BALLS, DOUBLE, Algebra
from adagen.model import Model
from adagen.plan import Plan, plan_from_json, plan_to_json
from adagen.plan.certificate import certified
from adagen.plan.steps import Certify, Correct
from adagen.program import check, lower
from adagen.reference import exact_forward_dynamics
from adagen.states import States
from adagen.studies.stability import linkages
from benchmarks.stability import mechanisms
from tests.executor.test_arms import CASES as ARMS
from tests.executor.test_arms import arms_of
from tests.executor.test_closed_lanes import linkages as limbs_with_loops
from tests.executor.test_closures import plan_of
from tests.mechanisms import four_bar, geared, quadruped, slider_crank, states_of, truss

Array = NDArray[np.float64]
State = tuple[Array, Array, Array]
MECHANISMS: dict[str, Callable[[], Model]] = {
    "four-bar, floating": lambda: four_bar(floating=True),
    "four-bar, coupler massless": lambda: four_bar(massless=True),
    "slider crank": slider_crank,
    "geared": geared,
    "quadruped": quadruped,
    "linkages on hips": lambda: limbs_with_loops(2, hips=1, geared=True),
}


def _squares(
    plan: Plan, state: State, algebra: Algebra = DOUBLE, lanes: Grouping | bool = False
) -> tuple[Array, float, float]:
    """Accelerations, and the squares of the norms of error and answer."""
    run = Run(plan, dict(zip(("q", "v", "tau"), state, strict=True)), algebra, lanes=lanes)
    run.check(digits=False)
    error, answer = (float(x) for x in run.of(0, list(run.machines[0].certificate)))
    return np.array(run.accelerations(), dtype=float), error, answer


def _ratio(plan: Plan, model: Model, state: State) -> float:
    """How much of its bound an error takes; the norm of the answer is looked at, too."""
    qdd, error, answer = _squares(plan, state)
    chain = WideLinks(plan, state[0], state[1], np.longdouble)
    true = exact_forward_dynamics(model, *state, digits=25).value
    off, whole, own = (
        float(chain.energy(x.astype(np.longdouble))) for x in (qdd - true, true, qdd)
    )
    assert answer == pytest.approx(own, rel=1e-6)
    return float(np.sqrt(off / whole) / np.sqrt(error / answer))


def _norm(plan: Plan, state: State, qdd: Array) -> float:
    """The energy norm of accelerations."""
    chain = WideLinks(plan, state[0], state[1], np.longdouble)
    return float(np.sqrt(float(chain.energy(qdd.astype(np.longdouble)))))


def _first_ratio(plans: Sequence[Plan], model: Model, state: State) -> float:
    """That of the first of some plans that answers; 0 where none does."""
    for plan in plans:
        with suppress(FloatingPointError):
            return _ratio(plan, model, state)
    return 0.0


def _rows(states: States) -> list[State]:
    return list(states.each)


@pytest.mark.parametrize("name", MECHANISMS)
def test_mechanisms_keep_their_bounds(name: str) -> None:
    model = MECHANISMS[name]()
    plans = certified(plan_of(model)).alternatives
    for state in _rows(states_of(model, 3)):
        assert _first_ratio(plans, model, state) <= 3


@pytest.mark.parametrize("k", range(len(mechanisms.FAMILIES)), ids=list(mechanisms.FAMILIES))
def test_states_near_singular_ones_keep_their_bounds(k: int) -> None:
    count = len(mechanisms.FAMILIES)
    for _, model in list(mechanisms.mechanisms(2 * count, 7))[k::count]:
        plans = certified(plan_of(model)).alternatives
        states = _rows(mechanisms.worst_states(model, 6))
        ratios = [_first_ratio(plans, model, state) for state in states]
        ratios += [_first_ratio(plans[1:], model, state) for state in states]
        assert max(ratios) <= 3
        assert sum(ratio > 0 for ratio in ratios) >= 3


def test_without_rounding_no_error_shows() -> None:
    model = four_bar(floating=True)
    plan = certified(plan_of(model))
    for state in _rows(states_of(model, 2)):
        _, in_balls, answer = _squares(plan, state, BALLS)
        assert 1e-16 < np.sqrt(in_balls / answer) < 1e-13


def test_a_factor_that_is_off_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """What the loops leave free has an inertia 1e-6 off; answers are, and the bound tells."""
    model = four_bar(floating=True)
    plan, solve_free = certified(plan_of(model)), Elimination._solve_free

    def spoilt(self: Elimination, *given: object) -> Freed:
        y, blamed, sizes, reduced, *rest = given
        off = reduced * self.state.graph.constant(1 + 1e-6)
        return solve_free(self, y, blamed, sizes, off, *rest)  # type: ignore[arg-type]

    monkeypatch.setattr(Elimination, "_solve_free", spoilt)
    lines_of.cache_clear()
    for state in _rows(states_of(model, 2)):
        qdd, error, answer = _squares(plan, state)
        true = exact_forward_dynamics(model, *state).value
        assert np.abs(qdd - true).max() > 1e-8 * np.abs(true).max()
        assert 1e-7 < np.sqrt(error / answer) < 1e-5
        assert _ratio(plan, model, state) <= 1.1
    lines_of.cache_clear()


def test_closures_in_lanes_have_the_same_bounds() -> None:
    model = limbs_with_loops(2, hips=1)
    plan = certified(plan_of(model))
    grouping = next(offer for offer in offered_groupings(plan) if any(offer))
    for state in _rows(states_of(model, 2)):
        _, error, answer = _squares(plan, state)
        _, in_lanes, answer_in_lanes = _squares(plan, state, lanes=grouping)
        assert np.sqrt(in_lanes / error) == pytest.approx(1, abs=0.5)
        assert answer_in_lanes == pytest.approx(answer, rel=1e-9)


@pytest.mark.parametrize("name", ARMS)
def test_arms_in_lanes_have_the_same_bounds(name: str) -> None:
    """What an arm leaves free for its own is weighed side by side; idle lanes are not."""
    make, _ = ARMS[name]
    model = make()
    for plan in certified(plan_of(model)).alternatives[:1]:
        (apart,), grouping = simulate(plan), groupings_of(plan)[0]
        (together,) = simulate(plan, grouping)
        assert arms_of(plan, grouping)
        assert together.operations.arithmetic < 0.8 * apart.operations.arithmetic
        for state in _rows(states_of(model, 2)):
            _, error, answer = _squares(plan, state)
            qdd, in_lanes, answer_in_lanes = _squares(plan, state, lanes=grouping)
            assert answer_in_lanes == pytest.approx(answer, rel=1e-9)
            assert np.sqrt(in_lanes / error) == pytest.approx(1, abs=0.5)
            _, rounding, _ = _squares(plan, state, BALLS)
            _, rounding_in_lanes, _ = _squares(plan, state, BALLS, lanes=grouping)
            assert rounding_in_lanes == pytest.approx(rounding, rel=1e-6)
            true = exact_forward_dynamics(model, *state, digits=25).value
            assert _norm(plan, state, qdd - true) <= 3 * np.sqrt(in_lanes)


def test_what_is_done_instead_in_poor_poses_is_certified_too() -> None:
    plan = certified(plan_of(quadruped()))
    assert plan.recovers
    for each in plan.alternatives:
        assert [type(step) for step in each.processes[0].steps[-2:]] == [Correct, Certify]
    assert plan_from_json(plan_to_json(plan)) == plan
    check(lower(plan, "unrolled"))


def test_what_is_not_certified_is_refused() -> None:
    with pytest.raises(UsageError, match="carries its loops through them"):
        certified(plan_of(linkages.ring(12)))
    with pytest.raises(UsageError, match="other outputs than all accelerations of closed loops"):
        certified(plan_of(replace(four_bar(), wanted=(0,))))
    with pytest.raises(UsageError, match="its loops let no joint move"):
        certified(plan_of(truss()))
