"""Eq. (11) for a measured machine: the constants by which the search orders joins in form `ada`."""

from __future__ import annotations

import numpy as np

from adagen.calibrate.nnls import nnls
from adagen.schedule.costs import REPEATED, StepCosts
from adagen.schedule.profile import CostProfile

_MOST_HANDLES = 4
_TYPICAL = {1: "revolute", 3: "spherical", 6: "floating"}


def fit_equation11(name: str, costs: StepCosts) -> CostProfile:
    """Return the constants of Eq. (11) that come nearest to a machine's joins.

    A join with k joints around it is assumed to couple k handles and to update k (k + 1) / 2 blocks
    (all of one side: a quarter of the pairs across), and to have one bare link beside it.

    Args:
        name: of the profile.
        costs: the machine's coefficients.
    """
    rows, times = [], []
    for dofs, kind in _TYPICAL.items():
        for k in range(_MOST_HANDLES + 1):
            rows.append([k * k, k, -dofs, 1.0])
            times.append(join_time(costs, kind, k))
    weight = 1 / np.array(times)
    alpha, beta, minus_gamma, delta = nnls(
        np.array(rows, dtype=np.float64) * weight[:, None], np.ones(len(times))
    )
    # Whatever the fit says, a joint of six freedoms must cost something.
    minus_gamma = min(minus_gamma, delta / 8)
    return CostProfile(name, float(alpha), float(beta), float(-minus_gamma), float(delta))


def join_time(costs: StepCosts, kind: str, handles: int) -> float:
    """Return the time to assemble and disassemble a joint among handles, microseconds."""
    pairs = handles * (handles + 1) / 2
    across = handles * (handles - 1) / 4
    coupling = (costs[f"{REPEATED}.coupling_a"] + costs[f"{REPEATED}.coupling_b"]) / 2
    return (
        costs[f"{REPEATED}.{kind}"]
        + costs[f"disassemble.{kind}"]
        + costs[f"kinematics.{kind}"]
        + costs["link.bias"]
        + handles * (coupling + costs["disassemble.coupling"])
        + (pairs - across) * costs[f"{REPEATED}.block"]
        + across * costs[f"{REPEATED}.across"]
    )
