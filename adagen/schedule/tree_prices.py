"""Costs of the nodes of a schedule tree by segments, where a profile has costs of steps.

The costs are laid so that the rules of the tree (:func:`adagen.schedule.tree.makespan_of`) play the
plan through: a joint inside a segment costs what it takes there, the topmost one also what its
process does for the segment as a whole, and before it: kinematics, also towards the joints that the
process joins later. A joint between processes also costs receiving and sending.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.profile import TICKS, CostProfile
from adagen.schedule.segment_costs import Price, SegmentCosts
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Node


class NodePrice(NamedTuple):
    """Cost of a node in either sweep, and time of its messages under way; ticks."""

    assembly: int
    disassembly: int
    transit: tuple[int, int] | None

    def node(
        self,
        joint: int,
        processes: tuple[int, int],
        root_side: Node | None,
        end_side: Node | None,
        boundary: int,
    ) -> Node:
        """Return the node of a joint at this price; see :class:`Node`."""
        away = None if self.transit is None else tuple(ticks / TICKS for ticks in self.transit)
        return Node(
            joint,
            processes,
            root_side,
            end_side,
            (self.assembly + self.disassembly) / TICKS,
            boundary,
            self.disassembly / TICKS,
            None if away is None else (away[0], away[1]),
        )


def segment_prices(
    topology: Topology,
    profile: CostProfile,
    root: int,
    children: Sequence[tuple[int, int]],
    ranges: Sequence[tuple[int, int]],
) -> list[NodePrice]:
    """Return the cost of each joint's node.

    Args:
        topology: the robot.
        profile: one with step costs.
        root: the joint at the root of the tree.
        children: for each joint its descendants on root and end side, -1 for a bare link.
        ranges: for each joint its range of processes.
    """
    return _Pricing(SegmentCosts(topology, profile), children, ranges).prices(root)


class _Part(NamedTuple):
    """A part of the tree, and the joints that its process joins further up; positions."""

    joint: int
    chain: Chain
    joined: tuple[int, ...]
    transit: tuple[int, int] | None


class _Pricing:
    def __init__(
        self,
        costs: SegmentCosts,
        children: Sequence[tuple[int, int]],
        ranges: Sequence[tuple[int, int]],
    ) -> None:
        self.costs = costs
        self.children = children
        self.ranges = ranges
        self.place = {j: p for p, j in enumerate(costs.chains.original)}
        self.found = [NodePrice(0, 0, (0, 0))] * len(children)

    def prices(self, root: int) -> list[NodePrice]:
        alone = _alone(root, self.children, self.ranges)
        stack = [_Part(root, WHOLE, (), (0, 0))]
        while stack:
            part = stack.pop()
            if alone[part.joint]:
                self._segment(part)
            else:
                stack += self._join(part)
        return self.found

    def _join(self, part: _Part) -> list[_Part]:
        """Price a joint between processes; return the parts below it."""
        costs, (joint, chain, joined, _) = self.costs, part
        process, position = self.ranges[joint][0], self.place[joint]
        speed = costs.costs.speed(process)
        cut = costs.cut(chain, position)
        up, down = scaled(cut.assembly, speed), scaled(cut.disassembly, speed)
        below = []
        local = (*joined, position)  # the first side that stays here bears the kinematics
        sides = costs.chains.split(chain, position)
        for child, side in zip(self.children[joint], sides, strict=True):
            if child < 0:
                up += scaled(costs.bare(), speed) if side.top else 0  # the ground has no bias
            elif self.ranges[child][0] == process:
                below.append(_Part(child, side, local, (0, 0)))
                local = ()
            else:
                transit = costs.transit(side)
                if transit is None:
                    below.append(_Part(child, side, (), None))
                    continue
                up += transit.handling.assembly
                down += transit.handling.disassembly
                below.append(_Part(child, side, (), transit.away))
        self.found[joint] = NodePrice(up, down, part.transit)
        return below

    def _segment(self, part: _Part) -> None:
        costs, chains = self.costs, self.costs.chains
        speed = costs.costs.speed(self.ranges[part.joint][0])
        price = costs.price(part.chain)
        on_path = set(price.path)
        total = [0, 0]
        for p in chains.positions(part.chain):
            out = costs.outward[p] if p in on_path else Price(0, 0)
            up = scaled(costs.own[p] + costs.alone[p].assembly + out.assembly, speed)
            down = scaled(costs.alone[p].disassembly + out.disassembly, speed)
            self.found[chains.original[p]] = NodePrice(up, down, (0, 0))
            total = [total[0] + up, total[1] + down]
        first, second = segment_time(
            costs, part.chain, costs.beyond(part.chain, part.joined), speed
        )
        own = self.found[part.joint]
        up, down = own.assembly + first - total[0], own.disassembly + second - total[1]
        self.found[part.joint] = NodePrice(up, down, part.transit)


def segment_time(costs: SegmentCosts, chain: Chain, beyond: int, speed: float) -> tuple[int, int]:
    """Return the time of a process for a segment in the first and in the second sweep, ticks.

    Args:
        costs: prices.
        chain: the segment.
        beyond: kinematics towards joints outside that the process joins.
        speed: of its core.
    """
    price = costs.price(chain)
    first = costs.start + price.kinematics + beyond + price.sweeps.assembly
    return scaled(first, speed), scaled(price.sweeps.disassembly, speed)


def scaled(ticks: int, speed: float) -> int:
    """Return a time on a core of some speed."""
    return ticks if speed == 1.0 else round(ticks / speed)


def _alone(
    root: int, children: Sequence[tuple[int, int]], ranges: Sequence[tuple[int, int]]
) -> list[bool]:
    """Return for each joint whether all below it is computed by its own process."""
    order, stack = [], [root]
    while stack:
        joint = stack.pop()
        order.append(joint)
        stack += [child for child in children[joint] if child >= 0]
    alone = [True] * len(children)
    for joint in reversed(order):
        alone[joint] = all(
            alone[child] and ranges[child][0] == ranges[joint][0]
            for child in children[joint]
            if child >= 0
        )
    return alone
