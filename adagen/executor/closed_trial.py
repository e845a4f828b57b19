"""Predicted digits of a plan with closed loops, from a trial in a few states."""

from __future__ import annotations

from typing import Any

import numpy as np
from flint import ctx

from adagen.executor.solve import interpret
from adagen.executor.trial import Trial
from adagen.graph import BALLS, DOUBLE, FLOAT
from adagen.model import Model
from adagen.plan.closure_steps import nothing_moves
from adagen.plan.types import Plan
from adagen.reference.closed import closed_states

STATES = 4
BITS = (256, 1024, 4096)


def tried_closed(model: Model, plan: Plan) -> Trial:
    """Return the digits that a plan loses in states in which the robot's loops are closed.

    It is carried out in the plan's scalar and in many bits. Singular poses are left out. Where no
    joint can move, nothing is lost.

    Args:
        model: the robot.
        plan: its plan.

    Raises:
        FloatingPointError: no state can be solved; the message names what fails.
    """
    if nothing_moves(plan):
        return Trial(0.0, 0)
    rng = np.random.default_rng(1)
    algebra = FLOAT if plan.scalar == "float" else DOUBLE
    worst, failed = None, None
    for q, v in zip(*closed_states(model, STATES, seed=1), strict=True):
        tau = rng.uniform(-1.0, 1.0, model.ntau)
        try:
            found = np.asarray(interpret(plan, q, v, tau, algebra), dtype=float)
            truth = _truth(plan, q, v, tau)
        except FloatingPointError as error:
            failed = error
            continue
        off = np.abs(found - truth) / max(float(np.abs(truth).max()), 1e-300)
        place = int(np.argmax(off))
        joint = max(j for j, start in enumerate(model.v_start) if start <= place)
        if worst is None or off[place] > worst.error:
            worst = Trial(float(off[place]), joint)
    if worst is None:
        raise failed or FloatingPointError("no state in which its loops are closed")
    return worst


def _truth(plan: Plan, q: Any, v: Any, tau: Any) -> Any:
    """The accelerations in the precision that long chains need."""
    for bits in BITS:
        with ctx.workprec(bits):
            try:
                return np.array([float(x) for x in interpret(plan, q, v, tau, BALLS)])
            except FloatingPointError as error:
                failed = error
    raise failed
