"""Carries what is emitted out once, and asks whether it solves the robot.

Programs are made for each robot anew, by limbs in SIMD lanes, by the order of their steps, and by
what is left out. What is wrong in one of them, no test of other robots shows.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from adagen.executor import interpret
from adagen.executor.lanes import Grouping
from adagen.graph import BALLS
from adagen.model import Model
from adagen.plan import Plan
from adagen.plan.closures import sampled
from adagen.program import Program
from adagen.reference import forward_dynamics, residual
from adagen.reference.closed import closed_forward_dynamics
from adagen.states import random_states

Array = NDArray[np.float64]
State = tuple[Array, Array, Array]
"""q, v and tau."""

LIMIT = {"double": 1e-6, "float": 1e-2}
"""Residual, relative to the torques at work, up to which nothing else is asked, by scalar:
constants of reproducible lines are rounded to it."""
_ALIKE = 100
"""How much larger it may be than without lanes: rounded constants are others there."""
_LONGEST = 200
"""Joints up to which loops and calls are checked: of longer chains it takes as long as all else."""
_CLOSED = 3
"""States in which a robot with loops is looked at, if it seems wrong in those before."""
_SINGULAR = 1e-9
"""Singular values of J, beside the largest, that rounding makes."""


def check_answer(model: Model, plan: Plan, program: Program) -> None:
    """Check that accelerations satisfy the equation of motion in a random state.

    A straight line is carried out in balls, its limbs in the lanes in which it is emitted. Of other
    shapes the plan's steps are, in the order of the program's operations: in double, and in balls
    where digits are lost. Where the residual is large, it must be so of another way to solve, too:
    a straight line without lanes, as of a robot that rounded constants make another; all else by
    dense algebra. Loops may be in a poor pose, where all is done again in another way; they have to
    be wrong in several states. Nothing is checked where not all accelerations are wanted, where a
    factorization fails in all states, and of loops and calls of more than 200 joints.

    Args:
        model: the robot.
        plan: what is emitted.
        program: how.

    Raises:
        AssertionError: they do not: adagen is at fault.
    """
    if not all(map(plan.wants, range(len(plan.joints)))):
        return
    if len(plan.joints) > _LONGEST and not _is_line(plan, program):
        return
    found = []
    for state in _states(model):
        try:
            left = _left(model, plan, program, state)
        except FloatingPointError:
            continue
        if left is None:
            return
        found.append(left)
    if found:
        what = "straight line" if program.shape == "unrolled" else "program"
        raise AssertionError(f"the {what} solves another robot: residual {min(found):.1e}")


def _states(model: Model) -> list[State]:
    """Random states; with loops a few, in which these are closed and the robot can move.

    Of a robot that cannot move, accelerations are rounding alone, whatever is right.
    """
    if not model.closed:
        return list(random_states(model, 1, seed=1).each)
    q, jacobian = sampled(model)
    sizes = np.linalg.svd(jacobian, compute_uv=False)
    moving = (sizes > _SINGULAR * sizes[:, :1]).sum(axis=1) < model.nv
    q, jacobian = q[moving][:_CLOSED], jacobian[moving][:_CLOSED]
    rng = np.random.default_rng(1)
    v = rng.uniform(-1.0, 1.0, (len(q), model.nv, 1)) * (not model.at_rest)
    v = v - np.linalg.pinv(jacobian, rcond=_SINGULAR) @ jacobian @ v
    return list(zip(q, v[:, :, 0], rng.uniform(-1.0, 1.0, (len(q), model.ntau)), strict=True))


def _left(model: Model, plan: Plan, program: Program, state: State) -> float | None:
    """The residual in a state where it is larger than it can be; otherwise None.

    Raises:
        FloatingPointError: a factorization failed.
    """
    limit, in_lanes = LIMIT[plan.scalar], _is_line(plan, program)
    if in_lanes:
        found = _accelerations(plan, state, program.slots.limbs)
    else:
        ordered = _in_order(plan, program)
        found = interpret(ordered, *state, once=True)
        if residual(model, *state, found[: model.nv]) <= limit:
            return None
        found = _accelerations(ordered, state, False)
    left = residual(model, *state, found[: model.nv])
    if left <= limit:
        return None
    if model.closed:
        other = closed_forward_dynamics(model, *state)
    elif not in_lanes:
        other = forward_dynamics(model, *state)
    else:
        other = _accelerations(replace(plan, reproducible=False), state, False)[: model.nv]
    return None if left <= _ALIKE * residual(model, *state, other) else left


def _is_line(plan: Plan, program: Program) -> bool:
    """Whether it is a straight line with limbs in lanes."""
    return program.shape == "unrolled" and plan.form == "segment"


def _in_order(plan: Plan, program: Program) -> Plan:
    """The plan with the steps that its program carries out, in that order."""
    processes = [
        replace(process, steps=tuple(step for done in own.operations for step in done.steps))
        for process, own in zip(plan.processes, program.processes, strict=True)
    ]
    return replace(plan, processes=tuple(processes))


def _accelerations(plan: Plan, state: State, lanes: bool | Grouping) -> Array:
    """The middle of what is found in balls."""
    return np.array([float(x) for x in interpret(plan, *state, BALLS, lanes=lanes)])
