"""Carries an emitted straight line out once, and asks whether it solves the robot.

Straight lines are made for each robot anew, by limbs in SIMD lanes and by what is left out. What is
wrong in one of them, no test of other robots shows.
"""

from __future__ import annotations

import numpy as np

from adagen.executor import interpret
from adagen.model import Model
from adagen.plan import Plan
from adagen.program import Program
from adagen.reference import residual
from adagen.states import random_states

LIMIT = 1e-6
"""Residual, relative to the torques at work, beyond which rounding is no explanation."""


def check_answer(model: Model, plan: Plan, program: Program) -> None:
    """Check that a straight line's accelerations satisfy the equation of motion in a random state.

    It is carried out in double, its limbs in the lanes in which it is emitted. Nothing is checked
    of robots with loops, whose states must be closed and have poor poses, where not all
    accelerations are computed, and where a factorization fails in that state.

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
    q, v, tau = states.q[0], states.v[0], states.tau[0]
    try:
        found = interpret(plan, q, v, tau, lanes=program.slots.limbs)[: model.nv]
    except FloatingPointError:
        return
    if np.isnan(found).any():
        return
    left = residual(model, q, v, tau, found)
    if left > LIMIT:
        raise AssertionError(f"the straight line solves another robot: residual {left:.1e}")
