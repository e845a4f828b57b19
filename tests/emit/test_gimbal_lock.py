"""Loops at and near gimbal lock of links without inertia: right to the last places, or refused.

Three revolute joints through two links of no inertia have, at an angle from gimbal lock, the
inertia D = I sin(angle)^2 about the outermost axis. Eliminated in the joints' own axes D keeps all
its digits; where it is less than rounding, there is no answer, and none may be given. Joints of
links without mass are always eliminated so, those of point masses where a sweep in axes of the base
finds too few digits left, and is repeated.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.executor import interpret
from adagen.model import Inertia, Model
from adagen.model.kinds import FLOATING, REVOLUTE
from adagen.states import States, random_states, write_states
from adagen.studies.stability import robots
from tests.emitted import QUICK, ROUNDING, Builder, plan_of, text_of
from tests.models import AXES, POINT, Part, assemble, rod, three_axis_chain, vector
from tests.slow import spread

NEAR = (1e-3, 1e-5, 1e-7)
AT = (1e-9, 0.0)


def two_arms(between: Inertia | None = None) -> Model:
    """Return a floating body with two arms of two wrists each, of three axes and two links."""
    none = Inertia.zero() if between is None else between
    parts = [Part("body", None, FLOATING, rod(5.0, vector(0.0, 0.0, 0.4), 0.2))]
    for side, y in (("left", 0.3), ("right", -0.3)):
        above = "body"
        for i in range(2):
            for k, axis in enumerate("xyz"):
                body = rod(1.0, vector(0.3, 0.0, 0.0)) if k == 2 else none
                place = (0.0, y, 0.2) if i == k == 0 else (0.3 * (k == 0), 0.0, 0.0)
                name = f"{side}{i}{axis}"
                axes = vector(*AXES[axis])
                parts.append(Part(name, above, REVOLUTE, body, vector(*place), axis=axes))
                above = name
    return assemble("two_arms", parts, floating=True)


def tilted(model: Model, joint: int, angle: float) -> States:
    """Return a state in which a joint is an angle away from gimbal lock of its neighbours."""
    states = random_states(model, 1, seed=1)
    q = states.q.copy()
    q[:, model.q_start[joint]] = np.pi / 2 - angle
    return replace(states, q=q)


CASES: dict[str, tuple[Callable[[], Model], int, int, str]] = {
    "first ball": (lambda: three_axis_chain(2), 1, 1, "inward_turned<"),
    "last ball": (lambda: three_axis_chain(2), 4, 1, "inward_turned<"),
    "slender rods": (lambda: robots.three_axis(2), 4, 1, "inward_turned<"),
    "in lanes": (two_arms, 5, 1, "inward_group_turned<0"),
    "two processes": (two_arms, 5, 2, "inward_turned<"),
    "first ball, repeated": (lambda: three_axis_chain(2, POINT), 1, 1, "inward_turned.hpp"),
    "last ball, repeated": (lambda: three_axis_chain(2, POINT), 4, 1, "inward_turned.hpp"),
    "in lanes, repeated": (lambda: two_arms(POINT), 5, 1, "groups_turned.hpp"),
    "two processes, repeated": (lambda: two_arms(POINT), 5, 2, "inward_turned.hpp"),
}


@pytest.mark.parametrize("case", spread(CASES, 3))
def test_loops_are_right_near_gimbal_lock_or_refuse(
    case: str, builder: Builder, tmp_path: Path
) -> None:
    make, joint, processes, kernel = CASES[case]
    model = make()
    plan = plan_of(model, processes, meeting="gather")
    assert kernel in text_of(plan, shape="kernels")
    solver = builder.solver(plan, QUICK, shape="kernels")
    for angle in NEAR:
        states = tilted(model, joint, angle)
        assert solver.error(model, states, tmp_path) < ROUNDING["double"]
    given, result = tmp_path / "at.json", tmp_path / "none.json"
    for angle in AT:
        write_states(tilted(model, joint, angle), model, given)
        done = solver.run("--states", given, "--result", result)
        assert done.status == 1
        assert "factorization failed" in done.stderr
        assert not result.exists()


@pytest.mark.parametrize("case", spread(CASES, 3))
def test_straight_lines_are_right_down_to_gimbal_lock_and_refuse_there(
    case: str, builder: Builder, tmp_path: Path
) -> None:
    make, joint, processes, _ = CASES[case]
    model = make()
    plan = plan_of(model, processes, meeting="gather")
    solver = builder.solver(plan, QUICK, shape="unrolled")
    for angle in (*NEAR, 1e-9, 1e-12):
        states = tilted(model, joint, angle)
        assert solver.error(model, states, tmp_path) < ROUNDING["double"]
    given, result = tmp_path / "at.json", tmp_path / "none.json"
    states = tilted(model, joint, 0.0)
    write_states(states, model, given)
    done = solver.run("--states", given, "--result", result)
    assert done.status == 1
    assert "factorization failed" in done.stderr
    with pytest.raises(FloatingPointError, match="factorization failed"):
        interpret(plan, states.q[0], states.v[0], states.tau[0])
