"""Memory of joints in one row of SIMD lanes, and moves between single joints and rows.

The values of a row are wide. They are stored under its first joint and that joint's far link.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from adagen.executor.lanes import Row, in_lanes
from adagen.executor.process_memory import ProcessMemory
from adagen.graph import Expression
from adagen.plan.robot import PlanJoint, PlanLink

Array = NDArray[Any]


class Rows:
    """Rows of joints in SIMD lanes, in a process's memory.

    Attributes:
        rows: the rows by their first joints.
        beyond_joints: loops and couplings in lanes likewise, counted behind all joints.
    """

    def __init__(self, process: ProcessMemory, rows: Mapping[int, Row]) -> None:
        self.process, self.rows = process, rows
        self.beyond_joints: dict[int, tuple[int, ...]] = {}
        self._lane_of = {
            j: (lead, k) for lead, row in rows.items() for k, j in enumerate(row.lanes[: row.count])
        }

    def __contains__(self, j: int) -> bool:
        """Whether joint j represents a row."""
        return j in self.rows

    def lanes(self, j: int) -> tuple[int, ...]:
        """Return the joints in the lanes of joint j's row, or j alone."""
        return self.rows[j].lanes if j in self.rows else (j,)

    def own(self, j: int) -> tuple[int, ...]:
        """Return the same without the joints that idle lanes repeat.

        Of a loop or coupling, counted behind all joints, those that share lanes with it.
        """
        if j in self.beyond_joints:
            return self.beyond_joints[j]
        return self.lanes(j)[: self.rows[j].count] if j in self.rows else (j,)

    def row_at(self, link: int) -> Row | None:
        """Return the row that the joint of a link is in; None where it is by itself."""
        place = self._lane_of.get(link - 1)
        return None if place is None else self.rows[place[0]]

    # -- constants and inputs ---------------------------------------------------------------------

    def of_joint(self, j: int, read: Callable[[PlanJoint], Any]) -> Array:
        """Return numbers of a joint as constants, of a row those of its lanes."""
        return self._constants([read(self.process.plan.joints[i]) for i in self.lanes(j)])

    def of_link(self, number: int, read: Callable[[PlanLink], Any]) -> Array:
        """Return numbers of a link as constants, of those beyond a row those of its lanes."""
        links = self.process.plan.links
        return self._constants([read(links[j + 1]) for j in self.lanes(number - 1)])

    def mass(self, number: int) -> Expression:
        """Return the mass of a link, of those beyond a row those of its lanes."""
        masses = [self.process.mass(j + 1) for j in self.lanes(number - 1)]
        return cast("Expression", self.packed(masses)[()])

    def com(self, number: int) -> Array:
        """Return the centre of mass of a link likewise, shape (3,)."""
        return self.packed([self.process.com(j + 1) for j in self.lanes(number - 1)])

    def _constants(self, values: Sequence[Any]) -> Array:
        return self.packed([self.process.constants(value) for value in values])

    def entries(self, name: str, j: int, count: int) -> Array:
        """Return the first ``count`` entries of a joint in q, v or tau."""
        joints = [self.process.plan.joints[i] for i in self.lanes(j)]
        starts = [joint.q if name == "q" else joint.v for joint in joints]
        graph = self.process.graph
        own = [[graph.input(f"{name}[{start + k}]") for k in range(count)] for start in starts]
        return self.packed([np.array(each, dtype=object) for each in own])

    # -- numbers and lanes ------------------------------------------------------------------------

    def packed(self, arrays: Sequence[Array], count: int | None = None) -> Array:
        """Return arrays of one shape as one, a lane for each; of one array, itself.

        Only the first ``count`` lanes matter, all if not given.
        """
        if len(arrays) == 1:
            return arrays[0]
        result = arrays[0].copy()
        for index in np.ndindex(result.shape):
            entries: list[Any] = [array[index] for array in arrays]
            result[index] = self.process.graph.pack(entries, count)
        return result

    def together(self, arrays: Sequence[Array]) -> Array:
        """Return values of a closure's arms as one array; idle lanes repeat the last."""
        return self.packed(in_lanes(arrays), len(arrays))

    def joined(self, values: Sequence[Expression]) -> Expression:
        """Return numbers of a closure's arms as a wide one likewise."""
        whole = self.together([np.array(value, object) for value in values])
        return cast("Expression", whole.item())

    def each(self, value: Array, count: int) -> list[Array]:
        """Return the values of a number of arms from one array; of a single one, itself."""
        return [value] if count == 1 else [self.lane(value, k) for k in range(count)]

    def sum_of(self, value: Array, count: int) -> Array:
        """Return the sum of the first lanes likewise."""
        return value if count == 1 else _each(value, lambda x: x.graph.across(x, count))

    def summed(self, x: Expression, count: int) -> Expression:
        """Return the sum of the first numbers of a value; of a single one, itself."""
        return cast("Expression", self.sum_of(np.array(x, object), count).item())

    def whole(self, j: int, x: Expression) -> Expression:
        """Return the sum of the numbers of joint j's row; of a single joint its own."""
        return self.summed(x, len(self.own(j)))

    def lane(self, value: Array, k: int) -> Array:
        """Return lane k of an array."""
        return _each(value, lambda x: x.graph.lane(x, k))

    def apart(self, j: int, value: Array) -> Iterator[tuple[int, Array]]:
        """Yield each joint of joint j's row with its lane of an array."""
        if j in self.rows:
            yield from ((each, self.lane(value, k)) for k, each in enumerate(self.own(j)))
        else:
            yield j, value

    # -- what is kept of links --------------------------------------------------------------------

    def near_links(self, j: int) -> list[int]:
        """Return the near links of joint j's row, by lanes."""
        return [self.process.plan.joints[i].parent for i in self.lanes(j)]

    def follows(self, j: int) -> bool:
        """Whether a joint's near link is stored in the same lanes: not for limbs' first joints."""
        return self.as_kept(self.near_links(j))

    def as_kept(self, links: Sequence[int]) -> bool:
        """Whether links, one for each lane, are stored as one value; a single one by itself."""
        lead = links[0] - 1
        if len(links) == 1:
            return lead not in self._lane_of
        return lead in self.rows and [i + 1 for i in self.rows[lead].lanes] == list(links)

    def name_of(self, link: int) -> int:
        """Return the link under which a link's values are stored: the first of its row."""
        lead, _ = self._lane_of.get(link - 1, (link - 1, 0))
        return lead + 1

    def kept(self, name: str, link: int) -> tuple[Any, int | None]:
        """Return the stored value of a link's row, and its lane; None if it is stored by itself."""
        _, k = self._lane_of.get(link - 1, (link - 1, None))
        return self.process.memory[name, self.name_of(link)], k

    def near_motion(self, j: int) -> Array | None:
        """Return the acceleration of the near links of joint j's row; None for the ground."""
        if not any(self.near_links(j)):
            return None
        return self.of_near("a", j, self.process.zeros(6, self.process.columns))

    def of_near(self, name: str, j: int, ground: Array) -> Array:
        """Return the stored values of the near links of joint j's row.

        Args:
            name: what is asked for.
            j: the joint.
            ground: what holds of the ground.
        """
        return self.of_links(name, self.near_links(j), ground)

    def of_links(self, name: str, links: Sequence[int], ground: Array) -> Array:
        """Return the stored values of links, one for each lane."""
        if any(links) and self.as_kept(links):
            found: Array = self.process.memory[name, links[0]]
            return found
        each = {0: ground}
        for link in set(links) - {0}:
            value, k = self.kept(name, link)
            each[link] = value if k is None else self.lane(value, k)
        return self.packed([each[link] for link in links])

    def hand_on(self, name: str, j: int, value: Array) -> None:
        """Add the contribution of joint j to the stored values of its near links."""
        self.process.passed[name, j] = value
        self.add(name, self.near_links(j), len(self.own(j)), value)

    def add(self, name: str, links: Sequence[int], count: int, value: Array) -> None:
        """Add to the stored values of links, one for each lane, the first ``count`` lanes only.

        Lanes are added one by one where several hang on one link: its row may repeat it in an idle
        lane, which must not take the contribution of another.
        """
        near = links[:count]
        if self.as_kept(links) and len(set(near)) == count:
            memory = self.process.memory
            memory[name, links[0]] = memory[name, links[0]] + value
            return
        for link in sorted(set(near) - {0}):
            lanes = [k for k, each in enumerate(near) if each == link]
            self._add(name, link, self._summed(value, lanes, len(near)))

    def _summed(self, value: Array, lanes: Sequence[int], count: int) -> Array:
        """The sum of some lanes of the first ones; a reproducible one is the same without lanes."""
        if count == 1:
            return value
        if len(lanes) == count and not self.process.plan.reproducible:
            return _each(value, lambda x: x.graph.across(x, count))
        first, *others = (self.lane(value, k) for k in lanes)
        for each in others:
            first = first + each
        return first

    def _add(self, name: str, link: int, value: Array) -> None:
        memory = self.process.memory
        if link - 1 in self._lane_of:
            lead, _ = self._lane_of[link - 1]
            nothing = self.process.zeros(*value.shape)
            lanes = [value if i == link - 1 else nothing for i in self.rows[lead].lanes]
            link, value = lead + 1, self.packed(lanes)
        memory[name, link] = memory[name, link] + value


def _each(value: Array, change: Callable[[Expression], Expression]) -> Array:
    """An array of changed entries."""
    result = value.copy()
    for index, entry in np.ndenumerate(value):
        result[index] = change(entry)
    return result
