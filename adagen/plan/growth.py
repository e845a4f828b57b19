"""How many digits form `ada` will keep on a robot, told before it is emitted.

A link that is much lighter than its neighbours loses most of its mobility when they are attached:
Phi_C = Phi - Z^T Z then subtracts nearly equal numbers. With g the mobility that is lost, about
log10(g) digits go with it, in whatever order the joints are assembled.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import KINDS
from adagen.plan.interpret import execute
from adagen.plan.types import Join, Plan

EPSILON = {"double": 2.0**-53, "float": 2.0**-24}


@dataclass(frozen=True)
class Growth:
    """What assembly loses.

    Attributes:
        error: predicted relative forward error, eps times the sum of g over the joints.
        joint: the joint with the largest g.
        largest: that g.
    """

    error: float
    joint: int
    largest: float


def predicted_growth(plan: Plan) -> Growth:
    """Return the growth of a plan's joins, the larger of two generic configurations.

    g_i is the largest generalised eigenvalue of (M_i with bare links, M_i as assembled), where
    M_i = N_i (Phi_Ai + Phi_Bi) N_i^T; eps times the sum of g predicts the error.

    Raises:
        FloatingPointError: a factorization fails already here; the message names the joint.
    """
    return max((_growth(plan, seed) for seed in (1, 2)), key=lambda growth: growth.error)


def _growth(plan: Plan, seed: int) -> Growth:
    q = _configuration(plan, seed)
    zero = np.zeros(sum(KINDS[joint.kind].nv for joint in plan.joints))
    _, memories = execute(plan, q, zero, zero)
    values: dict[int, float] = {}
    for process, memory in zip(plan.processes, memories, strict=True):
        for step in process.steps:
            if isinstance(step, Join):
                phi = memory["join", step.joint][5]
                values[step.joint] = _lost(plan, step.joint, memory["X", step.joint], phi)
    worst = max(values, key=lambda joint: (values[joint], -joint))
    return Growth(EPSILON[plan.scalar] * sum(values.values()), worst, values[worst])


def _lost(plan: Plan, j: int, x: NDArray[np.float64], assembled: NDArray[np.float64]) -> float:
    rows = list(KINDS[plan.joints[j].kind].constrained)
    if not rows:
        return 1.0
    bare = np.array(plan.links[j + 1].phi)
    if plan.joints[j].parent > 0:
        bare = bare + x @ np.array(plan.links[plan.joints[j].parent].phi) @ x.T
    m = assembled[np.ix_(rows, rows)]
    scale = 1.0 / np.sqrt(np.diag(m))  # mixed units: rotations beside translations
    lower = np.linalg.cholesky(m * np.outer(scale, scale))
    half = np.linalg.solve(lower, bare[np.ix_(rows, rows)] * np.outer(scale, scale))
    return float(np.linalg.eigvalsh(np.linalg.solve(lower, half.T))[-1])


def _configuration(plan: Plan, seed: int) -> NDArray[np.float64]:
    """A generic configuration, the same everywhere: irrational steps round the circle."""
    result = []
    for j, joint in enumerate(plan.joints):
        kind = KINDS[joint.kind]
        values = np.sin(1.7 * (j + 1) * seed + np.arange(kind.nq))
        if kind.quaternion is not None:
            part = slice(kind.quaternion, None)
            values[part] /= np.linalg.norm(values[part])
        result.append(values)
    return np.concatenate(result)


__all__ = ["Growth", "predicted_growth"]
