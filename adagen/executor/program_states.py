"""The random states that an emitted program uses for its check and timing, generated in Python."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count as count_from
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import KINDS
from adagen.plan.types import Plan

Array = NDArray[np.float64]
COUNT = 64
"""How many states a program draws."""
_WORD, _BLOCK = (1 << 64) - 1, 4096
_STEP, _FIRST, _SECOND = map(
    np.uint64, (0x9E3779B97F4A7C15, 0xBF58476D1CE4E5B9, 0x94D049BB133111EB)
)


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
    nq = sum(KINDS[joint.kind].nq for joint in plan.joints)
    ntau = plan.entry_of_wrench(len(plan.wrenches))
    q, v, tau = np.empty((count, nq)), np.zeros((count, plan.nv)), np.empty((count, ntau))
    uniform = _uniform(seed)
    if any(KINDS[joint.kind].quaternion is not None for joint in plan.joints):
        for s in range(count):  # one after the other: some need more numbers
            _fill(plan, (q[s : s + 1], v[s : s + 1], tau[s : s + 1]), uniform, uniform)
    else:
        each = nq + (1 if plan.at_rest else 2) * plan.nv + ntau - plan.nv
        drawn = np.array(list(islice(uniform, count * each)))
        _fill(plan, (q, v, tau), iter(drawn.reshape(count, each).T), uniform)
    return q, v, tau


def _fill(
    plan: Plan,
    states: tuple[Array, Array, Array],
    drawn: Iterator[Any],
    uniform: Iterator[float],
) -> None:
    """Fill states with what is drawn: a number, or an array of one for each state, at a time."""
    q, v, tau = states
    for joint in plan.joints:
        kind = KINDS[joint.kind]
        scale = np.pi if joint.kind == "revolute" else 1.0
        for k in range(joint.q, joint.q + kind.nq):
            q[:, k] = scale * next(drawn)
        if kind.quaternion is not None:
            start = joint.q + kind.quaternion
            q[:, start : start + 4] = _quaternion(uniform)
        for k in range(joint.v, joint.v + kind.nv):
            if not plan.at_rest:
                v[:, k] = next(drawn)
            tau[:, k] = next(drawn)
    for k in range(plan.nv, tau.shape[1]):
        tau[:, k] = next(drawn)


def _uniform(seed: int) -> Iterator[float]:
    """Numbers in [-1, 1) by splitmix64, the same on every machine."""
    first = np.uint64(seed & _WORD)
    for block in count_from(0, _BLOCK):
        z = first + np.arange(block + 1, block + _BLOCK + 1, dtype=np.uint64) * _STEP
        z = (z ^ (z >> np.uint64(30))) * _FIRST
        z = (z ^ (z >> np.uint64(27))) * _SECOND
        yield from (((z ^ (z >> np.uint64(31))) >> np.uint64(11)) * 2.0**-52 - 1).tolist()


def _quaternion(uniform: Iterator[float]) -> Any:
    while True:
        p = np.array([next(uniform) for _ in range(4)])
        squared = float(p[0] ** 2 + p[1] ** 2 + p[2] ** 2 + p[3] ** 2)
        if 0.01 <= squared <= 1:
            return p / np.sqrt(squared)
