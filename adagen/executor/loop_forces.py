"""Constraint forces of closed loops, if requested: of rows, then of loops and couplings.

The forces w of the kept rows follow from the motion. Redundant rows follow from kept ones by F: any
forces l with l_kept + F^T l_redundant = w have the same effect. The result is the least-squares
solution, l_kept = (1 + F^T F)^-1 w and l_redundant = F l_kept.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.front import Front
from adagen.executor.state import State
from adagen.graph import Expression, factorize, matrix_times, total

Array = NDArray[Any]


def give_forces(state: State, front: Front, near: Array | None) -> None:
    """Output the forces of a closure's loops and couplings, its unknowns being known.

    Args:
        state: whose process it is.
        front: the closure.
        near: the acceleration of its top, shape (6, columns); None for the ground.
    """
    forces = _forces_of_rows(state, front, near)
    joints, loops = len(state.plan.joints), len(state.plan.loops)
    zero = state.graph.constant(0)
    for k, rows in front.loops.items():
        parts: list[list[Expression]] = [[zero] for _ in range(6)]
        for wide_unknown, linear, direction in rows:
            force = state.rows.joined([forces[unknown] for unknown in wide_unknown])
            for i in range(3):  # f and m act on link 2, whose side of a row counts as positive
                parts[i if linear else i + 3].append(-(force * direction[i]))
        whole = np.array(list(map(total, parts)), dtype=object)
        for lane, number in enumerate(front.lanes[joints + k]):
            state.forces[state.plan.entry_of_loop(number)] = state.rows.lane(whole, lane)
    for k, known in front.couplings.items():
        whole = np.array([zero if known is None else -forces[known]], dtype=object)
        for lane, number in enumerate(front.lanes[joints + loops + k]):
            state.forces[state.plan.entry_of_coupling(number)] = state.rows.lane(whole, lane)


def forces_of_kept(state: State, front: Front, near: Array | None) -> dict[int, Expression]:
    """Return the forces of a closure's kept rows by number, without redundant rows.

    Args:
        state: whose process it is.
        front: the closure, its unknowns being known.
        near: the acceleration of its top, shape (6, columns); None for the ground.
    """
    pushed = front.pushed
    found: dict[int, Expression] = {}
    assert pushed is not None  # every closure is eliminated
    if pushed.parts is None:
        return {u: front.found[u][0] for u in pushed.kept}
    for part in pushed.parts:
        each = ([front.found[u][:1] for u in wide_unknown] for wide_unknown in part.others)
        others = np.array([state.rows.together(own) for own in each], dtype=object)
        pull = part.bias[:, :1] + matrix_times(part.inertia, others)
        if near is not None:
            pull = pull + matrix_times(part.across, near[:, :1])
        for wide_unknown, force in zip(part.kept, -part.solve(pull), strict=True):
            lanes = state.rows.each(force, len(wide_unknown))
            found.update((u, own[0]) for u, own in zip(wide_unknown, lanes, strict=True))
    return {u: found[u] for u in pushed.kept}


def _forces_of_rows(state: State, front: Front, near: Array | None) -> dict[int, Expression]:
    """The forces of all rows, by number."""
    pushed = front.pushed
    assert pushed is not None  # every closure is eliminated
    if not pushed.kept:
        return dict.fromkeys(pushed.left_out, state.graph.constant(0))
    kept = np.array([[x] for x in forces_of_kept(state, front, near).values()], dtype=object)
    if pushed.left_out:
        shares = matrix_times(pushed.by_kept.T, pushed.by_kept)
        whole = shares + state.constants(np.eye(len(pushed.kept)))
        kept = factorize(whole).solve(kept)
    left_out = matrix_times(pushed.by_kept, kept) if pushed.left_out else kept[:0]
    found = zip((*pushed.kept, *pushed.left_out), (*kept[:, 0], *left_out[:, 0]), strict=True)
    return dict(found)
