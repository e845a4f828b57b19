"""Values of alike arms of a closure, treated as one, lane by lane (adagen/plan/arms.py)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from adagen.executor.front import Front
from adagen.executor.rows import Rows
from adagen.graph import Expression
from adagen.plan.arms import Arms, Mates
from adagen.plan.steps import CloseLoop

Array = NDArray[Any]


class MatesInLanes:
    """Takes values of arms apart, puts them together, and adds them to a front.

    Args:
        rows: joints and arms that share lanes.
        arms: all arms of a process.

    Attributes:
        holds: of the first of joints that are treated as one, all of them.
        closing: of loops likewise.
    """

    def __init__(self, rows: Rows, arms: Iterable[Arms]) -> None:
        self.rows = rows
        self.holds: dict[int, Mates] = {}
        self.closing: dict[CloseLoop, tuple[CloseLoop, ...]] = {}
        for each in arms:
            self.holds.update((row[0], row) for row in each.limbs.rows)
            self.closing.update((loops[0], loops) for loops in each.loops)

    def forces(self, step: CloseLoop, row: int) -> Mates:
        """The numbers of a row's force, and of those that are treated as one with it."""
        return tuple(each.first + row for each in self.closing.get(step, (step,)))

    def each(self, value: Expression, count: int) -> list[Expression]:
        """A value for each of so many arms."""
        return [each.item() for each in self.rows.each(np.array(value, object), count)]

    def together(self, values: Sequence[Expression]) -> Expression:
        """The values of arms as one."""
        whole = self.rows.together([np.array(value, object) for value in values])
        return cast("Expression", whole.item())

    def add(self, front: Front, some: Mates, others: Mates, value: Expression) -> None:
        """Add to entries of E, of alike arms lane by lane."""
        for i, k, each in zip(some, others, self.each(value, len(some)), strict=True):
            front.add(i, k, each)

    def add_bias(self, front: Front, mates: Mates, value: Array) -> None:
        """Add to e likewise."""
        for unknown, each in zip(mates, self.rows.each(value, len(mates)), strict=True):
            front.add_bias(unknown, each)

    def add_columns(self, front: Front, links: Sequence[int], mates: Mates, column: Array) -> None:
        """Add to C at links, one for each lane, likewise."""
        each = self.rows.each(column, len(mates))
        for link, unknown, own in zip(links, mates, each, strict=False):
            front.add_column(link, unknown, own)

    @staticmethod
    def freedoms(front: Front, count: int) -> list[Mates]:
        """What is held back, as so many arms are treated as one."""
        arms = [mates for each in front.arms for mates in each.freedoms if len(mates) == count > 1]
        wide = {unknown for mates in arms for unknown in mates}
        return [*((own,) * count for own in front.speeds if own not in wide), *arms]
