"""A schedule tree priced by segments: what each node costs where a profile has step costs.

The costs are laid so that the rules of the tree (descendants side by side take the longer time,
one after the other their sum) give the predicted time of the whole: a joint inside a segment costs
what it takes there, the topmost one also what the segment takes as a whole, and that of a segment
computed elsewhere also the time its messages are under way.
"""

from __future__ import annotations

from collections.abc import Sequence

from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.profile import CostProfile
from adagen.schedule.segments import SegmentCosts
from adagen.schedule.topology import Topology


def segment_prices(
    topology: Topology,
    profile: CostProfile,
    root: int,
    children: Sequence[tuple[int, int]],
    ranges: Sequence[tuple[int, int]],
) -> list[int]:
    """Return what each joint's node costs, ticks.

    Args:
        topology: the robot.
        profile: one with step costs.
        root: the joint at the root of the tree.
        children: for each joint its descendants on root and end side, -1 for a bare link.
        ranges: for each joint its range of processes.
    """
    costs = SegmentCosts(topology, profile)
    place = {j: p for p, j in enumerate(costs.chains.original)}
    alone = _alone(root, children, ranges)
    prices = [0] * len(children)
    stack: list[tuple[int, Chain, int]] = [(root, WHOLE, 0)]
    while stack:
        joint, chain, extra = stack.pop()
        if alone[joint]:
            _price_segment(costs, chain, joint, prices)
            prices[joint] += extra
            continue
        position = place[joint]
        sides = costs.chains.split(chain, position)
        prices[joint] = extra + costs.cut(chain, position)
        for child, side in zip(children[joint], sides, strict=True):
            if child < 0:
                prices[joint] += costs.bare() if side.top else 0  # the ground has no bias
            else:
                remote = ranges[child][0] != ranges[joint][0]
                stack.append((child, side, costs.transit(side) if remote else 0))
    return prices


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


def _price_segment(costs: SegmentCosts, chain: Chain, top: int, prices: list[int]) -> None:
    chains, price = costs.chains, costs.price(chain)
    for p in chains.positions(chain):
        prices[chains.original[p]] = costs.alone[p]
    for p in price.path:
        prices[chains.original[p]] += costs.outward[p]
    inside = sum(prices[chains.original[p]] for p in chains.positions(chain))
    prices[top] += price.total - inside
