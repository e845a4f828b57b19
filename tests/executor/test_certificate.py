"""Certificates as the executor carries them out: bounds beside true errors, and what they see."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from flint import ctx
from numpy.typing import NDArray

from adagen.errors import UsageError
from adagen.executor import certificate, shared_bound
from adagen.executor.allowance import Allowance
from adagen.executor.grouping import offered_groupings
from adagen.executor.inner_root import InnerRoot
from adagen.executor.lanes import Grouping
from adagen.executor.refine import WideLinks
from adagen.executor.run import lines_of
from adagen.executor.segments import Articulated, Segments
from adagen.executor.solve import Run
from adagen.graph import BALLS, DOUBLE, FLOAT, Algebra, Expression
from adagen.model import PRISMATIC, REVOLUTE, SPHERICAL, Frame, Model, Wrench
from adagen.model.kinds import KINDS
from adagen.plan import Plan, plan_from_json, plan_to_json
from adagen.plan.certificate import certified
from adagen.plan.limb_spread import spread
from adagen.plan.steps import Articulate, Certify
from adagen.program import check, lower
from adagen.reference import exact_forward_dynamics
from adagen.states import random_states
from adagen.studies.random_states import hard_states
from benchmarks.stability.adversary import FAMILIES, robots
from benchmarks.stability.bounds import certified_plan, plan_elsewhere
from tests.emitted import plan_of
from tests.models import human_figure, random_rotation, random_tree, serial_chain, star

Array = NDArray[np.float64]
FIGURES: dict[str, Callable[[], Model]] = {
    "chain": lambda: serial_chain(7),
    "balls": lambda: serial_chain(5, kind=SPHERICAL),
    "tree": lambda: random_tree(np.random.default_rng(4), 12),
    "floating tree": lambda: random_tree(np.random.default_rng(5), 9, floating=True),
    "floating star": lambda: star(4, 3, floating=True),
    "figure": human_figure,
}


def _squares(
    plan: Plan, state: tuple[Array, ...], algebra: Algebra = DOUBLE, lanes: Grouping | bool = False
) -> tuple[Array, float, float]:
    """Accelerations, and the squares of the norms of error and answer."""
    q, v, tau = state
    run = Run(plan, {"q": q, "v": v, "tau": tau}, algebra, lanes=lanes)
    run.check()
    error, answer = (float(x) for x in run.of(0, list(run.machines[0].certificate)))
    return np.array(run.accelerations(), dtype=float), error, answer


def _norm(plan: Plan, state: tuple[Array, ...], qdd: Array) -> float:
    chain = WideLinks(plan, state[0], state[1], np.longdouble)
    return float(np.sqrt(chain.energy(qdd.astype(np.longdouble))))


@pytest.mark.parametrize("name", FIGURES)
def test_the_norm_of_the_answer_is_that_of_its_links(name: str) -> None:
    model = FIGURES[name]()
    plan = certified(plan_of(model, 1))
    states = random_states(model, 4, seed=2)
    for state in states.each:
        qdd, _, answer = _squares(plan, state)
        assert np.sqrt(answer) == pytest.approx(_norm(plan, state, qdd), rel=1e-11)


@pytest.mark.parametrize("k", range(len(FAMILIES)), ids=lambda k: FAMILIES[k].__name__)
def test_hard_states_keep_their_bounds(k: int) -> None:
    for model in robots(3 * len(FAMILIES), seed=21)[k :: len(FAMILIES)]:
        plan = certified(plan_of(model, 1))
        states = hard_states(model, 6, seed=21)
        for state in states.each:
            try:
                qdd, error, answer = _squares(plan, state)
            except FloatingPointError:
                continue
            true = exact_forward_dynamics(model, *state, digits=25).value
            off = _norm(plan, state, qdd - true) / _norm(plan, state, true)
            assert off <= 3 * np.sqrt(error / answer), (model.name, off)


@pytest.mark.parametrize("floating", [False, True])
def test_outer_forces_and_what_a_scene_wants_are_certified(*, floating: bool) -> None:
    """Forces of 1e6 that hold each other up but for rounding; one joint that is asked for."""
    tree = random_tree(np.random.default_rng(5), 9, floating=floating)
    draw = np.random.default_rng(6)
    turns = [random_rotation(draw) for _ in range(2)]
    frames = [Frame("push", turn, np.zeros(3)) for turn in turns]
    model = replace(tree, wrenches=tuple(Wrench(6, frame) for frame in frames))
    plan = certified(plan_of(model, 1))
    part = certified(plan_of(replace(model, wanted=(3,)), 1))
    states = hard_states(model, 12, seed=4)
    push = 1e6 * draw.standard_normal((states.count, 3))
    pushes = np.zeros((states.count, 12))
    pushes[:, :3], pushes[:, 6:9] = push @ turns[0], -push @ turns[1]
    torques = np.concatenate([states.tau[:, : model.nv], pushes], axis=1)
    for state in zip(states.q, states.v, torques, strict=True):
        qdd, error, answer = _squares(plan, state)
        assert np.sqrt(answer) == pytest.approx(_norm(plan, state, qdd), rel=1e-9)
        true = exact_forward_dynamics(model, *state, digits=25).value
        off = _norm(plan, state, qdd - true) / _norm(plan, state, true)
        assert off <= 3 * np.sqrt(error / answer) < 1e-6
        given, in_part, _ = _squares(part, state)
        assert np.isfinite(given).sum() < model.nv and in_part == pytest.approx(error, rel=0.5)


def test_without_rounding_no_error_shows() -> None:
    """In balls of many digits nothing shows of an error: the allowance for rounding is left."""
    model = FIGURES["tree"]()
    plan = certified(plan_of(model, 1))
    states = random_states(model, 1, seed=1)
    state = (states.q[0], states.v[0], states.tau[0])
    _, in_balls, answer = _squares(plan, state, BALLS)
    _, in_float, _ = _squares(certified(plan_of(model, 1, scalar="float")), state, FLOAT)
    assert np.sqrt(in_balls / answer) < 1e-13
    assert 1e-7 < np.sqrt(in_float / answer) < 1e-4


def test_a_factor_that_is_off_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """With D^-1 U^T of a joint 1e-5 off answers are wrong by as much; the bound tells."""
    model = serial_chain(7)
    plan, states = certified(plan_of(model, 1)), random_states(model, 3, seed=3)
    articulate = Segments._articulate

    def spoilt(self: Segments, step: Articulate) -> None:
        articulate(self, step)
        if step.joint == 3:
            body: Articulated = self.memory["articulated", 3]
            off = body.scaled * self.state.graph.constant(1 + 1e-5)
            self.memory["articulated", 3] = replace(body, scaled=off)

    for articulates in (articulate, spoilt):
        monkeypatch.setattr(Segments, "_articulate", articulates)
        lines_of.cache_clear()
        for state in states.each:
            qdd, error, answer = _squares(plan, state)
            true = exact_forward_dynamics(model, *state).value
            off = _norm(plan, state, qdd - true) / _norm(plan, state, true)
            bound = np.sqrt(error / answer)
            assert off <= 3 * bound
            assert (off > 1e-8 and bound < 1e-3) if articulates is spoilt else bound < 1e-12
    lines_of.cache_clear()


def test_limbs_in_lanes_have_the_same_bounds() -> None:
    model = FIGURES["floating star"]()
    plan = certified(plan_of(model, 1))
    grouping = next(offer for offer in offered_groupings(plan) if any(offer))
    states = random_states(model, 3, seed=6)
    for state in states.each:
        _, error, answer = _squares(plan, state)
        _, in_lanes, answer_in_lanes = _squares(plan, state, lanes=grouping)
        assert np.sqrt(in_lanes / error) == pytest.approx(1, abs=0.5)
        assert answer_in_lanes == pytest.approx(answer, rel=1e-10)


def test_a_certified_plan_is_written_and_checked() -> None:
    plan = certified(plan_of(human_figure(), 1))
    assert plan.certified
    assert isinstance(plan.processes[0].steps[-1], Certify)
    assert plan_from_json(plan_to_json(plan)) == plan
    for shape in ("kernels", "unrolled"):
        check(lower(plan, shape))


@pytest.mark.parametrize(
    ("model", "options", "said"),
    [
        (serial_chain(8), {"form": "ada"}, "that is for form segment"),
        (random_tree(np.random.default_rng(1), 8, mimics=1), {}, "is slaved to another"),
    ],
)
def test_what_is_not_certified_is_refused(model: Model, options: dict[str, str], said: str) -> None:
    with pytest.raises(UsageError, match=said):
        certified(plan_of(model, 1, **options))


MOVING = (REVOLUTE, PRISMATIC, SPHERICAL)
SHARED: dict[str, Callable[[], Model]] = {
    "fixed tree": lambda: star(3, 2),
    "floating tree": lambda: random_tree(np.random.default_rng(5), 19, floating=True),
    "slides": lambda: random_tree(np.random.default_rng(3), 12, floating=True, kinds=MOVING),
    "figure": human_figure,
}


@pytest.mark.parametrize("name", SHARED)
def test_processes_that_share_a_robot_find_the_bound_of_one(name: str) -> None:
    model = SHARED[name]()
    one, states = certified_plan(model), random_states(model, 3, seed=6)
    for processes in (2, 3):
        plan = certified_plan(model, processes=processes)
        assert plan.certified
        assert plan_from_json(plan_to_json(plan)) == plan
        for shape in ("kernels", "unrolled"):
            check(lower(plan, shape))
        for state in states.each:
            _, error, answer = _squares(one, state)
            _, shared, as_large = _squares(plan, state)
            assert np.sqrt(shared / error) == pytest.approx(1, abs=0.3)  # by what rounding shows
            assert as_large == pytest.approx(answer, rel=1e-12)
            with ctx.workprec(200):  # nothing shows: what rounding is allowed is left
                allowed, together = (_squares(each, state, BALLS)[1] for each in (one, plan))
            assert together == pytest.approx(allowed, rel=1e-12)


ELSEWHERE: dict[str, Callable[[], Model]] = {
    "chain": lambda: serial_chain(14),
    "floating tree": lambda: random_tree(np.random.default_rng(5), 14, floating=True),
    "floating balls": lambda: random_tree(
        np.random.default_rng(3), 12, floating=True, kinds=MOVING
    ),
}


@pytest.mark.parametrize("name", ELSEWHERE)
def test_processes_that_gather_elsewhere_find_a_bound_like_that_of_one(name: str) -> None:
    model = ELSEWHERE[name]()
    one, plan, states = (
        certified_plan(model),
        plan_elsewhere(model),
        random_states(model, 3, seed=6),
    )
    assert plan_from_json(plan_to_json(plan)) == plan
    for shape in ("kernels", "unrolled"):
        check(lower(plan, shape))
    for state in states.each:
        _, error, answer = _squares(one, state)
        qdd, shared, as_large = _squares(plan, state)
        assert as_large == pytest.approx(answer, rel=1e-12)
        off = _norm(plan, state, qdd - exact_forward_dynamics(model, *state, digits=25).value)
        assert off <= 3 * np.sqrt(shared)  # the inverse of a mobility costs digits, which shows
        assert np.sqrt(shared) <= 30 * max(off, np.sqrt(error))


def test_how_a_held_link_moves_otherwise_is_part_of_the_bound(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The answer has it moving as the way to the ground does, and all beyond moves along."""
    model = serial_chain(14)
    plan, (state,) = plan_elsewhere(model), zip(*_one(model), strict=True)
    right = _squares(plan, state)[1]
    honest, parting = InnerRoot.apart, shared_bound.parting
    limbs: list[Expression] = []

    def kept(found: Allowance, apart: Array, own: list[Expression]) -> list[Expression]:
        limbs.extend(own)
        return parting(found, apart, own)

    monkeypatch.setattr(certificate, "parting", kept)
    monkeypatch.setattr(
        InnerRoot, "apart", lambda at: honest(at) + at.state.constants(np.full(6, 1e-6))
    )
    lines_of.cache_clear()
    _, bound, _ = _squares(plan, state)
    run = Run(plan, dict(zip(("q", "v", "tau"), state, strict=True)))
    turning, sliding = run.of(0, limbs)
    lines_of.cache_clear()
    assert bound - right == pytest.approx(27e-12 * (turning + sliding), rel=1e-6)


def test_limbs_that_move_otherwise_are_part_of_the_bound(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a process finds for the links that its limbs hang on may differ from the answer."""
    model = star(3, 2, floating=True)
    plan, (state,) = certified_plan(model, processes=2), zip(*_one(model), strict=True)
    honest, right = shared_bound.told, _squares(plan, state)[1]

    def off(found: Allowance, step: Certify, sums: list[Expression]) -> Array:
        found.memory["a", 1] = found.memory["a", 1] + found.state.constants(1e-6)
        return honest(found, step, sums)

    monkeypatch.setattr(certificate, "told", off)
    lines_of.cache_clear()
    beyond = [j for j in plan.processes[1].owns if j not in plan.processes[0].treated]
    limbs = spread(plan, beyond, 1)
    _, bound, _ = _squares(plan, state)
    lines_of.cache_clear()
    assert bound - right == pytest.approx(27e-12 * (limbs.turning + limbs.sliding), rel=1e-6)


def _one(model: Model) -> tuple[Array, Array, Array]:
    states = random_states(model, 1, seed=2)
    return states.parts


def test_what_limbs_take_is_no_more_than_their_spread() -> None:
    """Limbs of a floating base, whose joints do not accelerate while it does."""
    model = random_tree(np.random.default_rng(3), 9, kinds=MOVING, floating=True)
    plan, states = plan_of(model, 1), random_states(model, 20, seed=1)
    limbs, base = spread(plan, range(1, len(plan.joints)), 1), plan.links[1]
    rng = np.random.default_rng(4)
    for q, v in zip(states.q, states.v, strict=True):
        chain = WideLinks(plan, q, v, np.longdouble)
        turning = limbs.turning + sum(scale * q[k] ** 2 for k, scale in limbs.along)
        for x, y in rng.normal(size=(5, 2, 3)):
            qdd = np.zeros(len(v))
            qdd[list(KINDS["floating"].free).index(0) :][:3] = x
            qdd[list(KINDS["floating"].free).index(3) :][:3] = y
            at_centre = y + np.cross(x, base.com)
            own = base.mass * at_centre @ at_centre + x @ np.array(base.tensor) @ x
            taken = float(chain.energy(qdd.astype(np.longdouble)) - own)
            assert 0 < taken <= turning * x @ x + limbs.sliding * y @ y


@pytest.mark.parametrize(
    ("plan", "said"),
    [
        (lambda: plan_of(serial_chain(12), 2), "otherwise than by limbs of a link where they"),
        (lambda: plan_of(human_figure(), 2), "otherwise than by limbs of a link where they"),
    ],
)
def test_processes_that_are_joined_are_refused(plan: Callable[[], Plan], said: str) -> None:
    with pytest.raises(UsageError, match=said):
        certified(plan())
