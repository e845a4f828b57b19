"""The random states that an emitted program uses for its check and timing, generated in Python."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import KINDS
from adagen.plan.types import Plan

Array = NDArray[np.float64]
COUNT = 64
"""How many states a program draws."""
_WORD = (1 << 64) - 1


def program_states(plan: Plan, count: int = COUNT, seed: int = 1) -> tuple[Array, Array, Array]:
    """Return the states that the emitted program of a plan draws (random_states in session.hpp).

    Loops are not closed, and slaved joints are where they were drawn.

    Args:
        plan: of the robot.
        count: of states, S.
        seed: of the program's ``--seed``.

    Returns:
        q, shape (S, nq), rad and m; v, shape (S, nv), rad/s and m/s; tau, shape (S, nv), N m and N,
        with the numbers of outer forces behind them.
    """
    uniform = _uniform(seed)
    nq = sum(KINDS[joint.kind].nq for joint in plan.joints)
    ntau = plan.entry_of_wrench(len(plan.wrenches))
    q, v, tau = np.empty((count, nq)), np.zeros((count, plan.nv)), np.empty((count, ntau))
    for s in range(count):
        for joint in plan.joints:
            kind = KINDS[joint.kind]
            scale = np.pi if joint.kind == "revolute" else 1.0
            for k in range(kind.nq):
                q[s, joint.q + k] = scale * next(uniform)
            if kind.quaternion is not None:
                start = joint.q + kind.quaternion
                q[s, start : start + 4] = _quaternion(uniform)
            for k in range(kind.nv):
                if not plan.at_rest:
                    v[s, joint.v + k] = next(uniform)
                tau[s, joint.v + k] = next(uniform)
        tau[s, plan.nv :] = [next(uniform) for _ in range(ntau - plan.nv)]
    return q, v, tau


def _uniform(seed: int) -> Iterator[float]:
    """Numbers in [-1, 1) by splitmix64, the same on every machine."""
    while True:
        seed = (seed + 0x9E3779B97F4A7C15) & _WORD
        z = seed
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & _WORD
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & _WORD
        yield ((z ^ (z >> 31)) >> 11) * 2.0**-52 - 1


def _quaternion(uniform: Iterator[float]) -> Any:
    while True:
        p = np.array([next(uniform) for _ in range(4)])
        squared = float(p[0] ** 2 + p[1] ** 2 + p[2] ** 2 + p[3] ** 2)
        if 0.01 <= squared <= 1:
            return p / np.sqrt(squared)
