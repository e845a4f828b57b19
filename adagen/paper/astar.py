"""A* over sequences of joints (Section III-B and the Appendix), with two estimates.

A node of the search tree is a partial sequence: the schedule tree built so far, with *slots* that
wait for a joint, level by level and root side first. A slot on one process is not searched: III-D
fills it at once. ``Q`` is a heap, and ``T`` is implied by the links to the ascendants.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass
from typing import Literal

from adagen.paper.budget import Budget, OutOfBudget
from adagen.paper.successors import Option, Space
from adagen.paper.tie_break import Builder
from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.tree import Tie
from adagen.schedule.tree_draft import Draft

Estimate = Literal["paper", "admissible"]


@dataclass(frozen=True)
class Pending:
    """A slot: a partial chain on more than one process."""

    chain: Chain
    first: int
    last: int
    above: int
    is_end: bool


@dataclass(frozen=True)
class Step:
    """A node of the search tree.

    Attributes:
        active: total active time of each process, ticks.
        slots: what is left to do.
        joints: the sequence so far.
        work: total work so far and, on one process, of what is left.
        option: how the last joint was added, to which slot; None at the start.
        before: its ascendant.
        offspring: the chains that the last joint left to search, with the size of its range.
    """

    active: tuple[int, ...]
    slots: tuple[Pending, ...]
    joints: tuple[int, ...]
    work: int
    option: tuple[Pending, Option] | None = None
    before: Step | None = None
    offspring: tuple[Chain, ...] = ()

    def cost(self) -> int:
        """Return the total cost: the largest active time of a process."""
        return max(self.active)


class AStar:
    """The search of the Appendix.

    Args:
        space: the search space; two descendants always divide their range.
        estimate: ``paper``: AstarCost() as in III-B-3. It is *not* admissible, whatever the text
            says: it adds the remainder of one slot, which may be that of a process with little to
            do so far, to the time of the busiest one, so that the schedule found need not be the
            best. ``admissible``: the largest active time of a slot's first process plus a bound on
            the slot.
        improved: NextNodes() extends the first open slot only; the naive one extends every slot.
        tie: among equal estimates, the smallest sequence (``lex``) or the least work.
        budget: how many nodes may be expanded.
    """

    def __init__(
        self, space: Space, estimate: Estimate, improved: bool, tie: Tie, budget: Budget
    ) -> None:
        self.space = space
        self.estimate = estimate
        self.improved = improved
        self.tie = tie
        self.budget = budget
        self.lower = 0

    def search(self, processes: int) -> Step | None:
        """Return a goal, or None if the budget ran out.

        With the admissible estimate :attr:`lower` is then the least priority that was left, a
        proven bound.
        """
        start = self._add(
            Step((0,) * processes, (), (), self.space.single.work(WHOLE)),
            [Pending(WHOLE, 0, processes, -1, False)],
        )
        queue = [(self._priority(start), 0, start)]
        count = 0
        while queue:
            priority, _, step = heapq.heappop(queue)
            if self.estimate == "admissible":
                self.lower = max(self.lower, priority[0])
            if not step.slots:
                return step
            try:
                self.budget.spend()
                following = self._next_nodes(step)
            except OutOfBudget:
                return None
            for offspring in following:
                count += 1
                heapq.heappush(queue, (self._priority(offspring), count, offspring))
        raise AssertionError("a search over a finite set ends at a goal")

    def draft(self, goal: Step) -> Draft:
        """Return the schedule tree of a goal."""
        builder = Builder(self.space)
        path = []
        step: Step | None = goal
        while step is not None and step.option is not None:
            path.append(step.option)
            step = step.before
        for slot, option in reversed(path):
            processes = slot.last - slot.first
            starts = builder.node(option, slot.above, slot.is_end, slot.first, processes)
            joint = self.space.chains.original[option.position]
            if option.root_work and option.first == 1:
                builder.leaf(option.root, joint, False, (starts[0], starts[0] + 1))
            if option.end_work and option.second == 1:
                builder.leaf(option.end, joint, True, (starts[1], starts[1] + 1))
        if not path:
            builder.leaf(WHOLE, -1, False, (0, 1))
        return builder.draft

    def _priority(self, step: Step) -> tuple[int, ...]:
        estimate = step.cost() + self._astar_cost(step)
        return (estimate, *step.joints) if self.tie == "lex" else (estimate, step.work)

    def _astar_cost(self, step: Step) -> int:
        """Return the estimate of the cost from here to a goal."""
        work, spread = self.space.single.work, self.space.bounds.spread
        if self.estimate == "paper":
            if not step.offspring or step.option is None:
                return 0
            slot = step.option[0]
            return max(work(chain) for chain in step.offspring) // (slot.last - slot.first)
        least = max(
            (
                step.active[slot.first] + spread(work(slot.chain), slot.last - slot.first)
                for slot in step.slots
                if slot.above >= 0
            ),
            default=0,
        )
        return max(0, least - step.cost())

    def _next_nodes(self, step: Step) -> list[Step]:
        chosen = range(1 if self.improved else len(step.slots))
        result = []
        for at in chosen:
            slot = step.slots[at]
            processes = slot.last - slot.first
            options = self.space.options(slot.chain, processes, every=True)
            rest = (*step.slots[:at], *step.slots[at + 1 :])
            for i in range(len(options.cut)):
                option = self.space.option(slot.chain, processes, options, i)
                result.append(self._extend(step, slot, option, rest))
        return result

    def _extend(self, step: Step, slot: Pending, option: Option, rest: tuple[Pending, ...]) -> Step:
        """Return the node that adds a joint to a slot: Cost() is charged to all of its range."""
        joint = self.space.chains.original[option.position]
        active = list(step.active)
        for p in range(slot.first, slot.last):
            active[p] += option.cost
        work = step.work - self.space.single.work(slot.chain)
        work += option.cost + option.root_work + option.end_work
        middle = slot.first if option.shared else slot.first + option.first
        sides = [
            Pending(option.root, slot.first, slot.first + option.first, joint, False),
            Pending(option.end, middle, middle + option.second, joint, True),
        ]
        sides = [s for s, w in zip(sides, (option.root_work, option.end_work), strict=True) if w]
        base = Step(tuple(active), rest, (*step.joints, joint), work, (slot, option), step)
        return self._add(base, sides)

    def _add(self, step: Step, sides: list[Pending]) -> Step:
        """Return the node with more slots; those on one process are done by III-D at once."""
        active = list(step.active)
        open_ = []
        for side in sides:
            if side.last - side.first == 1:
                active[side.first] += self.space.single.work(side.chain)
            else:
                open_.append(side)
        return Step(
            tuple(active),
            (*step.slots, *open_),
            step.joints,
            step.work,
            step.option,
            step.before,
            tuple(side.chain for side in open_),
        )
