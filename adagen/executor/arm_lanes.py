"""Unknowns of similar arms of a closure, one arm in each SIMD lane (adagen/plan/arms.py)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from adagen.executor.frames import Transform
from adagen.executor.front import Front
from adagen.executor.rows import Rows
from adagen.graph import Expression, cross
from adagen.plan.arms import Arms, WideUnknown
from adagen.plan.steps import CloseLoop

Array = NDArray[Any]


class CouplingColumn(NamedTuple):
    """Column of C that couples an unknown (wide for similar arms) with a link's acceleration."""

    wide_unknown: WideUnknown
    column: Array
    point: Array | None = None

    def passed(self, x: Transform) -> CouplingColumn:
        """Return the column at the near link of a joint.

        A force at a point is turned, and the point is brought there, which gaps know already: its
        moment follows from these by fewer products than by turning it, but for what of it is zero.
        """
        column = x.force(self.column)
        if self.point is None:
            return CouplingColumn(self.wide_unknown, column)
        point = x.origin + x.rotation.vector(self.point)
        if all(entry.constant is None for entry in self.column[:3]):
            column = np.concatenate([cross(point, column[3:]), column[3:]])
        return CouplingColumn(self.wide_unknown, column, point)


class ArmLanes:
    """Splits wide values of similar arms, combines them, and adds them to a closure's state.

    Args:
        rows: joints and arms that share lanes.
        arms: all arms of a process.

    Attributes:
        holds: of the first of joints that are treated as one, all of them.
        closing: of loops likewise.
    """

    def __init__(self, rows: Rows, arms: Iterable[Arms]) -> None:
        self.rows = rows
        self.holds: dict[int, WideUnknown] = {}
        self.closing: dict[CloseLoop, tuple[CloseLoop, ...]] = {}
        for each in arms:
            self.holds.update((row[0], row) for row in each.limbs.rows)
            self.closing.update((loops[0], loops) for loops in each.loops)

    def forces(self, step: CloseLoop, row: int) -> WideUnknown:
        """Numbers of a row's force in all lanes."""
        return tuple(each.first + row for each in self.closing.get(step, (step,)))

    def each(self, value: Expression, count: int) -> list[Expression]:
        """The value of each arm."""
        return [each.item() for each in self.rows.each(np.array(value, object), count)]

    def add(self, front: Front, some: WideUnknown, others: WideUnknown, value: Expression) -> None:
        """Add to entries of E, lane by lane for similar arms."""
        for i, k, each in zip(some, others, self.each(value, len(some)), strict=True):
            front.add(i, k, each)

    def add_bias(self, front: Front, wide_unknown: WideUnknown, value: Array) -> None:
        """Add to e, lane by lane for similar arms."""
        for unknown, each in zip(
            wide_unknown, self.rows.each(value, len(wide_unknown)), strict=True
        ):
            front.add_bias(unknown, each)

    def add_columns(
        self,
        front: Front,
        links: Sequence[int],
        wide_unknown: WideUnknown,
        column: Array,
        point: Array | None = None,
    ) -> None:
        """Add to C at links, one for each lane; for a force at a point, with that point."""
        each = self.rows.each(column, len(wide_unknown))
        points = [None] * len(each) if point is None else self.rows.each(point, len(wide_unknown))
        for link, unknown, own, at in zip(links, wide_unknown, each, points, strict=False):
            front.add_column(link, unknown, own, at)

    def take_columns(self, front: Front, joints: Sequence[int]) -> list[CouplingColumn]:
        """Remove C from the far links of joints, of similar arms as wide columns."""
        each = [front.columns.pop(j + 1, {}) for j in joints]
        points = [front.points.pop(j + 1, {}) for j in joints]
        found = []
        for unknowns in zip(*each, strict=True):
            columns = [own[u] for own, u in zip(each, unknowns, strict=True)]
            at = [own.get(u) for own, u in zip(points, unknowns, strict=True)]
            known = [one for one in at if one is not None]
            point = self.rows.together(known) if len(known) == len(at) else None
            found.append(CouplingColumn(unknowns, self.rows.together(columns), point))
        return found

    @staticmethod
    def freedoms(front: Front, count: int) -> list[WideUnknown]:
        """Accelerations that are unknowns, those of similar arms as wide ones."""
        arms = [
            wide_unknown
            for each in front.arms
            for wide_unknown in each.freedoms
            if len(wide_unknown) == count > 1
        ]
        wide = {unknown for wide_unknown in arms for unknown in wide_unknown}
        return [*((own,) * count for own in front.speeds if own not in wide), *arms]
