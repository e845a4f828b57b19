"""Emitted straight lines in lanes compute what the executor does, to the last bit.

Sines and cosines are there those of the runtime (adagen/kernels/lanes.hpp), which are taken here
operation by operation, too.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

from adagen.executor import interpret, straight_line
from adagen.executor.grouping import groupings_of
from adagen.graph import DOUBLE, FLOAT
from adagen.model import PRISMATIC, REVOLUTE, SPHERICAL, JointKind, Mimic, Model, Passive
from adagen.plan import Plan
from adagen.plan.steps import (
    Articulate,
    HoldMobility,
    Join,
    SolveCoupling,
    SolveMobility,
    SolveRoot,
)
from adagen.states import random_states
from tests.emit.limbs import alike
from tests.emitted import EXACT, ROUNDING, Builder, forward_error, plan_of, truth_of
from tests.executor.plans import kinds_of
from tests.models import (
    Part,
    assemble,
    random_inertia,
    random_rotation,
    rod,
    serial_chain,
    vector,
)
from tests.scene.effects import with_wrenches


def affected(model: Model, seed: int = 3) -> Model:
    """Return a robot all of whose hinges and sliders have passive torques and rotors."""
    rng = np.random.default_rng(seed)
    joints = [
        replace(joint, passive=Passive(*rng.uniform(0.1, 1.0, size=6)))
        if joint.kind in (REVOLUTE, PRISMATIC)
        else joint
        for joint in model.joints
    ]
    return replace(model, joints=tuple(joints))


def slaved(model: Model) -> Model:
    """Return a robot whose joint "trunk3" follows "trunk2"."""
    number = {joint.name: j for j, joint in enumerate(model.joints)}
    joints = list(model.joints)
    follower = joints[number["trunk3"]]
    joints[number["trunk3"]] = replace(follower, mimic=Mimic(number["trunk2"], -1.5, 0.2))
    return replace(model, joints=tuple(joints))


def limbs(
    count: int, *kinds: JointKind, floating: bool = True, trunk: int = 2, beside: int = 2
) -> Model:
    """Return a robot with limbs that are alike, and outer forces."""
    rng = np.random.default_rng(0)
    robot = alike(rng, count, kinds, floating=floating, trunk=trunk, beside=beside)
    return with_wrenches(robot.model, rng)


def on_a_mast(joints: int, count: int) -> Model:
    """Return a chain that stands on the ground, with limbs of three hinges on its last links."""
    rng = np.random.default_rng(5)
    chain = serial_chain(joints)
    step = vector(0.2, 0.0, 0.0)
    parts = [
        Part(
            joint.name,
            chain.joints[j - 1].name if j else None,
            REVOLUTE,
            rod(0.5, step, 0.02),
            step if j else np.zeros(3),
            axis=np.eye(3)[j % 3],
        )
        for j, joint in enumerate(chain.joints)
    ]
    for n in range(count):
        above = parts[joints - 1 - n % 2].name
        for k in range(3):
            place = rng.uniform(-0.2, 0.2, size=3)
            inertia, turn = random_inertia(rng), random_rotation(rng)
            parts.append(Part(f"limb{n}_{k}", above, REVOLUTE, inertia, place, turn))
            above = parts[-1].name
    return assemble("mast", parts)


@dataclass(frozen=True)
class Case:
    """A robot, how it is planned, and a step that only such plans have."""

    model: Model
    processes: int = 1
    meeting: str = "join"
    scalar: str = "double"
    has: type = Articulate

    def plan(self) -> Plan:
        """Return the plan; some of its limbs share a straight line."""
        how = {"form": "segment", "meeting": self.meeting, "scalar": self.scalar}
        plan = plan_of(self.model, self.processes, **how)
        assert self.has in kinds_of(plan)
        assert in_lanes(plan)
        return plan


def in_lanes(plan: Plan) -> bool:
    return any(one.machine.rows.rows for one in straight_line(plan))


HINGES = (REVOLUTE, REVOLUTE, REVOLUTE)
CASES = {
    "four limbs": Case(limbs(4, REVOLUTE, SPHERICAL)),
    "four limbs in float": Case(limbs(4, REVOLUTE, SPHERICAL), scalar="float"),
    "three limbs with effects": Case(affected(limbs(3, REVOLUTE, PRISMATIC, REVOLUTE))),
    "limbs beside slaved joints": Case(
        slaved(limbs(4, *HINGES, trunk=4, beside=0)), has=SolveCoupling
    ),
    "joined by two": Case(limbs(8, *HINGES), 2, has=Join),
    "gathered by two": Case(limbs(8, *HINGES), 2, "gather", has=SolveRoot),
    "gathered by three": Case(limbs(8, *HINGES), 3, "gather", has=SolveRoot),
    "gathered on the ground": Case(
        limbs(8, *HINGES, floating=False), 3, "gather", has=SolveMobility
    ),
    "gathered on a ground that is held": Case(on_a_mast(12, 8), 3, "gather", has=HoldMobility),
}


SLOW = {
    *("four limbs", "joined by two", "gathered by three"),
    *("gathered on the ground", "gathered on a ground that is held"),
}


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=pytest.mark.slow if name in SLOW else ()) for name in CASES],
)
def test_a_straight_line_in_lanes_is_the_executor(
    name: str, builder: Builder, tmp_path: Path
) -> None:
    case = CASES[name]
    plan, states = case.plan(), random_states(case.model, 3, seed=4)
    solver = builder.solver(plan, EXACT, name="lane_bits", shape="unrolled")
    found = solver.solve(case.model, states, tmp_path, "--check")
    algebra = FLOAT if case.scalar == "float" else DOUBLE
    expected = np.array([interpret(plan, *row, algebra, lanes=True) for row in states.each])
    np.testing.assert_array_equal(found.astype(expected.dtype), expected)


@pytest.mark.parametrize("name", CASES)
def test_what_is_computed_in_lanes_is_true(name: str) -> None:
    case = CASES[name]
    plan, states = case.plan(), random_states(case.model, 3, seed=4)
    algebra = FLOAT if case.scalar == "float" else DOUBLE
    found = np.array([interpret(plan, *row, algebra, lanes=True) for row in states.each])
    assert forward_error(found, truth_of(case.model, states)) < ROUNDING[case.scalar]


def test_recovery_is_in_lanes() -> None:
    """The plan of what is done in a singular pose shares straight lines, too."""
    case = CASES["gathered on a ground that is held"]
    plan = case.plan().recovering()
    assert in_lanes(plan)
    states = random_states(case.model, 1, seed=4)
    row = states.q[0], states.v[0], states.tau[0]
    alone, together = (interpret(plan, *row, lanes=lanes) for lanes in (False, True))
    np.testing.assert_allclose(together, alone, rtol=1e-9, atol=1e-9)


def test_a_failure_names_the_joint_of_its_lane() -> None:
    """A limb without mass fails in the last lane's name."""
    model = limbs(4, REVOLUTE, beside=0)
    plan = plan_of(model, 1)
    (each,) = groupings_of(plan)[0]
    last = each[0].rows[0][-1]
    links = list(plan.links)
    nothing = ((0.0,) * 3,) * 3
    links[last + 1] = replace(links[last + 1], mass=0.0, com=(0.0,) * 3, tensor=nothing)
    states = random_states(model, 1, seed=1)
    row = states.q[0], states.v[0], states.tau[0]
    with pytest.raises(FloatingPointError, match=f'"{plan.joints[last].name}"'):
        interpret(replace(plan, links=tuple(links)), *row, lanes=True)
