"""Carries an emitted straight line out once, and asks whether it solves the robot.

Straight lines are made for each robot anew, by limbs in SIMD lanes and by what is left out. What is
wrong in one of them, no test of other robots shows.
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
from adagen.program import Program
from adagen.reference import residual
from adagen.states import random_states

Array = NDArray[np.float64]

LIMIT = {"double": 1e-6, "float": 1e-2}
"""Residual, relative to the torques at work, up to which nothing else is asked, by scalar:
constants of reproducible lines are rounded to it."""
_ALIKE = 100
"""How much larger it may be than without lanes: rounded constants are others there."""


def check_answer(model: Model, plan: Plan, program: Program) -> None:
    """Check that a straight line's accelerations satisfy the equation of motion in a random state.

    It is carried out in balls, its limbs in the lanes in which it is emitted. Where the residual is
    large, it must be so without lanes, too: the robot is one that rounded constants make another.
    Nothing is checked of robots with loops, whose states must be closed and have poor poses, where
    not all accelerations are computed, and where a factorization fails in that state.

    Args:
        model: the robot.
        plan: what is emitted.
        program: how.

    Raises:
        AssertionError: they do not: adagen is at fault.
    """
    if program.shape != "unrolled" or plan.form != "segment" or model.closed:
        return
    states = random_states(model, 1, seed=1)
    state = states.q[0], states.v[0], states.tau[0]
    try:
        found = _accelerations(plan, state, program.slots.limbs)[: model.nv]
        if np.isnan(found).any() or (left := residual(model, *state, found)) <= LIMIT[plan.scalar]:
            return
        alone = _accelerations(replace(plan, reproducible=False), state, False)[: model.nv]
    except FloatingPointError:
        return
    if left > _ALIKE * residual(model, *state, alone):
        raise AssertionError(f"the straight line solves another robot: residual {left:.1e}")


def _accelerations(plan: Plan, state: tuple[Array, Array, Array], lanes: bool | Grouping) -> Array:
    """The middle of what is found in balls."""
    q, v, tau = state
    return np.array([float(x) for x in interpret(plan, q, v, tau, BALLS, lanes=lanes)])
