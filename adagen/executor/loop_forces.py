"""Forces of closed loops, where they are asked for: of rows, then of loops and couplings.

The forces w of the kept rows follow from what moves. Rows that were left out follow from these by
F: any forces l with l_kept + F^T l_left_out = w do the same to the robot. Given are those of least
squares, l_kept = (1 + F^T F)^-1 w and l_left_out = F l_kept.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.front import Front
from adagen.executor.state import State
from adagen.graph import Expression, factorize, matrix_times, solved_by_reflections, total

Array = NDArray[Any]


def give_forces(state: State, front: Front, link: int) -> None:
    """Give the forces of a closure's loops and couplings, its unknowns being known.

    Args:
        state: whose process it is.
        front: the closure.
        link: its top.
    """
    forces = _forces_of_rows(state, front, link)
    zero = state.graph.constant(0)
    for k, rows in front.loops.items():
        parts: list[list[Expression]] = [[zero] for _ in range(6)]
        for unknown, linear, direction in rows:
            for i in range(3):  # f and m are told of link 2, whose side of a row counts as positive
                parts[i if linear else i + 3].append(-(forces[unknown] * direction[i]))
        state.forces[state.plan.entry_of_loop(k)] = np.array(list(map(total, parts)), dtype=object)
    for k, known in front.couplings.items():
        force = zero if known is None else -forces[known]
        state.forces[state.plan.entry_of_coupling(k)] = np.array([force], dtype=object)


def _forces_of_rows(state: State, front: Front, link: int) -> dict[int, Expression]:
    """The forces of all rows, by number."""
    pushed = front.pushed
    assert pushed is not None  # every closure is eliminated
    if pushed.rows is None:
        kept = np.array([[front.found[u][0]] for u in pushed.kept], dtype=object)
    elif pushed.kept:
        others = np.array([front.found[u][:1] for u in pushed.others], dtype=object)
        pull = pushed.bias[:, :1] + matrix_times(pushed.inertia, others)
        if link:
            pull = pull + matrix_times(pushed.across, state.memory["a", link][:, :1])
        kept = -solved_by_reflections(pushed.rows.T.copy(), pull)[0]
    else:
        return dict.fromkeys(pushed.left_out, state.graph.constant(0))
    if pushed.left_out:
        shares = matrix_times(pushed.by_kept.T, pushed.by_kept)
        whole = shares + state.constants(np.eye(len(pushed.kept)))
        kept = factorize(whole).solve(kept)
    left_out = matrix_times(pushed.by_kept, kept) if pushed.left_out else kept[:0]
    found = zip((*pushed.kept, *pushed.left_out), (*kept[:, 0], *left_out[:, 0]), strict=True)
    return dict(found)
