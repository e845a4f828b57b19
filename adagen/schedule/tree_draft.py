"""A schedule tree under construction: joints, their descendants and their ranges."""

from __future__ import annotations

from collections.abc import Sequence

from adagen.schedule.profile import CostProfile
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Node
from adagen.schedule.tree_prices import NodePrice, segment_prices
from adagen.union_find import UnionFind


class Draft:
    """Descendants and process ranges of each joint, to be filled from the root down.

    Attributes:
        root: the joint at the root.
        root_child: for each joint the descendant on its root side, -1 for a bare link; length N.
        end_child: the same on its end side; length N.
        ranges: for each joint its range of processes (first, last + 1); length N.
    """

    def __init__(self, joints: int) -> None:
        self.root = -1
        self.root_child = [-1] * joints
        self.end_child = [-1] * joints
        self.ranges = [(0, 1)] * joints

    def children(self, joint: int) -> tuple[int, int]:
        """Return the descendants of a joint on its root and end side, -1 for a bare link."""
        return self.root_child[joint], self.end_child[joint]

    def hang(self, above: int, joint: int, is_end: bool) -> None:
        """Add a joint below another one, on its end side or root side; -1 makes it the root."""
        if above < 0:
            self.root = joint
        else:
            (self.end_child if is_end else self.root_child)[above] = joint

    def contract(self, topology: Topology, order: Sequence[int]) -> int:
        """Build the tree of a partial chain for an order of assembly.

        Args:
            topology: the robot.
            order: the chain's joints, the first one assembled first.

        Returns:
            The joint assembled last, the root of the chain's part of the tree.
        """
        leaders = UnionFind[int]()  # of links that are assembled
        top: dict[int, int] = {}  # leader -> joint that made the component
        for joint in order:
            above, below = leaders.of(topology.parents[joint]), leaders.of(joint + 1)
            self.root_child[joint] = top.get(above, -1)
            self.end_child[joint] = top.get(below, -1)
            leaders.join(below, above)
            top[above] = joint
        return order[-1]

    def assign(self, joint: int, processes: tuple[int, int]) -> None:
        """Assign ranges to a joint and all below it by halving, as in Section III-C."""
        stack = [(joint, processes)]
        while stack:
            joint, (a, b) = stack.pop()
            self.ranges[joint] = (a, b)
            sides = [child for child in self.children(joint) if child >= 0]
            if len(sides) == 2 and b - a > 1:
                m = a + (b - a) // 2  # the text's b + (b - a)/2 is a misprint
                stack += [(sides[0], (a, m)), (sides[1], (m, b))]
            else:
                stack += [(side, (a, b)) for side in sides]

    def finish(self, topology: Topology, profile: CostProfile) -> Node:
        """Return the tree with the cost and the boundary of each node.

        Where the profile has costs of steps, nodes are priced by segments.
        """
        prices = None
        if profile.steps is not None:
            children = list(zip(self.root_child, self.end_child, strict=True))
            prices = segment_prices(topology, profile, self.root, children, self.ranges)
        order, stack = [], [self.root]
        while stack:
            joint = stack.pop()
            order.append(joint)
            stack += [child for child in self.children(joint) if child >= 0]
        made: dict[int, tuple[Node, int, int]] = {}  # joint -> node, sum of degrees, joints
        for joint in reversed(order):
            sides, degrees, joints = [], 0, 1
            for child, link in zip(
                self.children(joint), (topology.parents[joint], joint + 1), strict=True
            ):
                node, d, n = made[child] if child >= 0 else (None, topology.degrees[link], 0)
                sides.append(node)
                degrees += d
                joints += n
            # Each joint inside the chain is counted by both of its links, one outside by one.
            k = degrees - 2 * joints
            cost = profile.join(k, topology.dofs[joint])
            price = NodePrice(cost, 0, (0, 0)) if prices is None else prices[joint]
            result = price.node(joint, self.ranges[joint], sides[0], sides[1], k)
            made[joint] = (result, degrees, joints)
        return made[self.root][0]
