"""The graphs behind shape `unrolled`, evaluated in Python: values, and what they cost."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from adagen.emit.unrolled import Grouping, Simulated, pays_unrolled, simulate
from adagen.graph import Operations
from adagen.model import FLOATING, REVOLUTE, Inertia, Model
from adagen.plan import FORMS, Plan, make_plan
from adagen.plan.interpret import interpret
from adagen.states import random_states
from tests.emitted import plan_of
from tests.graph.evaluate import evaluate
from tests.models import Part, assemble, random_tree, rod, serial_chain, star, vector
from tests.schedules import random_schedule

Array = NDArray[np.float64]


class Inputs(dict[str, float]):
    """What a process's expressions read: the state, sines and cosines, others' messages.

    Each is found when it is asked for.
    """

    def __init__(
        self,
        p: int,
        plan: Plan,
        simulated: tuple[Simulated, ...],
        state: dict[str, Array],
        mail: dict[int, list[float]],
    ) -> None:
        super().__init__()
        self.p, self.plan, self.simulated = p, plan, simulated
        self.state, self.mail = state, mail

    def __missing__(self, name: str) -> float:
        word, *places = name.removesuffix("]").replace("]", "").split("[")
        if word == "w.from":
            number, place = map(int, places)
            if number not in self.mail:
                source = self.plan.messages[number].source
                sent = self.simulated[source].machine.sent[number]
                theirs = Inputs(source, self.plan, self.simulated, self.state, self.mail)
                self.mail[number] = evaluate(sent, theirs, rounded)
            return self.mail[number][place]
        if word in ("sine", "cosine"):
            angle = self.simulated[self.p].machine.angles[int(places[0])]
            (value,) = evaluate([angle], self, rounded)
            return math.sin(value) if word == "sine" else math.cos(value)
        return float(self.state[word][int(places[0])])


def rounded(value: object) -> float:
    return int(getattr(value, "p", 0)) / int(getattr(value, "q", 1))


def evaluated(plan: Plan, state: dict[str, Array], grouping: Grouping | None = None) -> Array:
    """Return the accelerations that the graphs of all processes give together."""
    simulated = simulate(plan, grouping)
    qdd = np.full(state["v"].shape, np.nan)
    mail: dict[int, list[float]] = {}
    for p, one in enumerate(simulated):
        machine = one.machine
        for j, values in machine.results.items():
            found = evaluate(values, Inputs(p, plan, simulated, state, mail), rounded)
            for k, value in enumerate(found):
                lanes = value if isinstance(value, tuple) else (value,) * 8
                for each, own in zip(machine.rows.own(j), lanes, strict=False):
                    qdd[plan.joints[each].v + k] = own
    return qdd


@pytest.mark.parametrize("form", FORMS)
@settings(max_examples=12, deadline=None)
@given(
    st.integers(1, 6),
    st.integers(1, 3),
    st.integers(0, 1),
    st.booleans(),
    st.booleans(),
    st.integers(0, 2**32 - 1),
)
def test_graphs_say_what_the_interpreter_says(
    form: str, joints: int, processes: int, mimics: int, floating: bool, aligned: bool, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(
        rng, joints, mimics=mimics, floating=floating, branching=0.5, coordinate_axes=aligned
    )
    plan = make_plan(model, random_schedule(model, processes, rng), form=form)
    states = random_states(model, 1, seed=seed % 1000)
    q, v, tau = states.q[0], states.v[0], states.tau[0]
    expected = interpret(plan, q, v, tau)
    found = evaluated(plan, {"q": q, "v": v, "tau": tau})
    size = max(1.0, float(np.abs(expected).max()))
    np.testing.assert_allclose(found / size, expected / size, atol=1e-12)


def operations(model: Model) -> Operations:
    """Return what one process needs for an evaluation."""
    (only,) = simulate(plan_of(model, 1))
    return only.operations


def test_a_planar_chain_costs_a_third_of_a_spatial_one() -> None:
    planar = operations(serial_chain(10, axes="y")).arithmetic
    assert 3 * planar <= operations(oblique(10)).arithmetic
    # Axes x, y, z in turn and bodies of revolution have structure enough of their own.
    assert 9 * planar <= 4 * operations(serial_chain(10, axes="xyz")).arithmetic


def oblique(n: int) -> Model:
    """Return a chain whose axes and inertias have no structure."""
    return random_tree(np.random.default_rng(1), n, [REVOLUTE], branching=0)


def test_what_nobody_feels_costs_nothing() -> None:
    # Turned about a vertical through its centre of mass, a body feels neither gravity nor speed.
    body = Inertia(2.0, np.zeros(3), np.diag([0.3, 0.2, 0.1]))
    count = operations(assemble("wheel", [Part("axle", None, REVOLUTE, body)]))
    assert (count.multiply, count.add, count.divide) == (1, 0, 0)


def test_gravity_reaches_a_floating_robot_once() -> None:
    model = serial_chain(4, floating=True)
    plan = plan_of(model, 1)
    light = plan.__class__(**{**plan.__dict__, "gravity": (0.0, 0.0, 0.0)})
    (with_it,), (without,) = simulate(plan), simulate(light)
    more = with_it.operations.arithmetic - without.operations.arithmetic
    assert 0 < more <= 25


def test_a_floating_body_of_its_own_needs_no_division_by_unknowns() -> None:
    part = Part("__base__", None, FLOATING, rod(1.0, vector(0.3, 0.0, 0.0)))
    assert operations(assemble("body", [part], floating=True)).divide == 1  # of the quaternion


def test_a_straight_line_pays_for_arms_and_not_for_crowds() -> None:
    assert pays_unrolled(plan_of(serial_chain(6), 1))
    assert not pays_unrolled(plan_of(oblique(7), 1))  # nothing to save
    assert not pays_unrolled(plan_of(serial_chain(30), 1))  # too long


@pytest.mark.parametrize(("arms", "joints", "pays"), [(4, 2, True), (2, 3, True), (4, 3, False)])
def test_a_straight_line_does_not_pay_where_most_limbs_lie_side_by_side(
    arms: int, joints: int, pays: bool
) -> None:
    assert pays_unrolled(plan_of(star(arms, joints), 1)) == pays


def test_form_ada_has_no_limbs_side_by_side() -> None:
    assert pays_unrolled(plan_of(serial_chain(2), 1, form="ada"))
