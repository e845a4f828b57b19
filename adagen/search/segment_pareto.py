"""Pareto fronts of the two sweeps' times, for parts of a schedule of form `segment`."""

from __future__ import annotations

from typing import NamedTuple

from adagen.schedule.chains import Chain, Chains
from adagen.schedule.sweeps import Sweeps
from adagen.schedule.tree_draft import Draft


class State(NamedTuple):
    """A chain on processes first .. first + processes - 1.

    Attributes:
        chain: the chain.
        first: its first process, 0 if all are equally fast.
        processes: how many.
        joined: positions of those of its boundary joints below that its process joins.
        beyond: kinematics towards joints that its process joins, outside the chain; ticks.
    """

    chain: Chain
    first: int
    processes: int
    joined: tuple[int, ...] = ()
    beyond: int = 0


class Label(NamedTuple):
    """One of the best ways to do a state, and what it takes.

    Attributes:
        time: in both sweeps.
        state: what it is a way to do.
        position: where the chain is cut; -1 if one process does it.
        here: the way of the side that stays on the first process.
        there: the way of the other side.
        root_here: whether the root side is the one that stays.
    """

    time: Sweeps
    state: State
    position: int = -1
    here: Label | None = None
    there: Label | None = None
    root_here: bool = True


def add(front: list[Label], label: Label) -> None:
    """Add a way to a front, by ascending time of assembly, unless another one is as good."""
    time = label.time
    for other in front:
        if _as_good(other.time, time):
            return
    front[:] = [other for other in front if not _as_good(time, other.time)]
    front.append(label)
    front.sort(key=lambda one: one.time.assembly)


def _as_good(a: Sweeps, b: Sweeps) -> bool:
    return (
        a.assembly <= b.assembly
        and a.disassembly <= b.disassembly
        and a.apart <= max(b.apart, b.assembly + b.disassembly)
    )


def covered(front: list[Label], total: int, assembly: int, disassembly: int) -> bool:
    """Return whether a front is as good as anything with these least times.

    The best that can be hoped for are the times (A, total - A) for A from ``assembly`` to
    ``total - disassembly``; a way is as good as those with A at least and D at least its own.
    """
    reached, last = assembly, total - disassembly
    for label in front:
        time = label.time
        if time.assembly > reached:
            return False
        if time.apart <= total and total - time.disassembly >= reached:
            reached = total - time.disassembly
            if reached >= last:
                return True
    return False


def draft_of(best: Label, chains: Chains) -> Draft:
    """Return the schedule of a way to do the whole robot."""
    draft = Draft(len(chains.original))
    stack: list[tuple[Label, int, int, bool]] = [(best, 0, -1, False)]
    while stack:
        label, first, above, is_end = stack.pop()
        chain, count = label.state.chain, label.state.processes
        if label.here is None or label.there is None:
            joint = put_segment(draft, chains, chain, (first, first + count))
        else:
            joint = chains.original[label.position]
            draft.ranges[joint] = (first, first + count)
            stack.append((label.here, first, joint, not label.root_here))
            second = first + label.here.state.processes
            stack.append((label.there, second, joint, label.root_here))
        draft.hang(above, joint, is_end)
    return draft


def put_segment(draft: Draft, chains: Chains, chain: Chain, processes: tuple[int, int]) -> int:
    """Put a chain of one process under its joint nearest to the ground; return that joint."""
    order = [chains.original[p] for p in reversed(chains.positions(chain))]
    for joint in order:
        draft.ranges[joint] = processes
    return draft.contract(chains.topology, order)
