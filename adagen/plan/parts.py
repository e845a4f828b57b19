"""Long chains of hinges in parts inside one process, one part in each SIMD lane.

In a chain on one process, each joint of a sweep waits for the one before. Divided into parts, it is
as many short chains as there are SIMD lanes, which are swept side by side. Each part has a mobility
at both of its ends, and the process joins the parts by Eq. (3)-(10), as processes do with theirs.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
from itertools import pairwise

from adagen.plan import steps as do
from adagen.plan.robot import PlanJoint
from adagen.plan.steps import Step

FEWEST_ROWS = 3
"""Joints of each part at least, the one that it hangs on by included: as many rows are swept."""


def strips_of(joints: range, lanes: int) -> list[range]:
    """Return a run of joints in as many parts as there are lanes, the last ones a joint shorter."""
    rows = -(-len(joints) // lanes)
    longer = len(joints) - (rows - 1) * lanes
    ends = [joints.start]
    for lane in range(lanes):
        ends.append(ends[-1] + rows - (lane >= longer))
    return [range(first, beyond) for first, beyond in pairwise(ends)]


def parts_of(joints: Sequence[PlanJoint], members: Container[int], lanes: int) -> list[range]:
    """Return the strips of a segment's chain of hinges; none where it is not divided.

    The first joint of each strip is the one that its part hangs on by. That of the first strip may
    lie before the segment, which then hangs on by it. Joints of other kinds may come before the
    chain, a floating base for one.

    Args:
        joints: the robot's joints.
        members: those of the segment.
        lanes: how many parts there are to be; 0: none.
    """
    own = [j for j in range(len(joints)) if j in members]
    if not lanes or not own or own[-1] - own[0] + 1 != len(own):
        return []
    first = own[0] - (joints[own[0]].parent > 0)
    if not all(joints[j].parent == j for j in range(first, own[-1] + 1)):
        return []
    others = [j for j in range(first, own[-1] + 1) if not _is_hinge(joints[j])]
    hinges = others[-1] + 1 if others else first
    if first < hinges <= own[0]:  # by no hinge
        return []
    run = range(hinges, own[-1] + 1)
    return strips_of(run, lanes) if FEWEST_ROWS * lanes <= len(run) else []


def _is_hinge(joint: PlanJoint) -> bool:
    return joint.kind == "revolute" and not joint.prescribed and joint.mimic is None


def swept_first(steps: Sequence[Step]) -> list[Step]:
    """Return steps with those of all inward sweeps before mobilities and joins.

    Args:
        steps: of one process, from its first sweep to its last.
    """
    first_message = next(
        (k for k, s in enumerate(steps) if isinstance(s, do.Send | do.Receive)), len(steps)
    )
    swept = _by_kinds(
        steps[:first_message],
        (do.StartLink, do.FreeBase),
        (do.Articulate,),
        (do.InvertRoot,),
        (do.Propagate,),
    )
    return [*swept, *steps[first_message:]]


def released_first(steps: Sequence[Step]) -> list[Step]:
    """Return steps with the releases of all joints before what is done inside the parts.

    The accelerations of their joints come last, as no step waits for them.
    """
    begun = next((k for k, s in enumerate(steps) if isinstance(s, do.Disassemble)), len(steps))
    released = _by_kinds(
        steps[begun:], (do.Disassemble,), (do.Load,), (do.Deliver,), (do.AccelerateRoot,)
    )
    return [*steps[:begun], *released]


def _by_kinds(steps: Sequence[Step], *turns: tuple[type, ...]) -> list[Step]:
    """Steps of some kinds in turn, then those of all others."""

    def turn(step: Step) -> int:
        return next((k for k, kinds in enumerate(turns) if isinstance(step, kinds)), len(turns))

    return sorted(steps, key=turn)


def pairs_of(count: int) -> Iterator[tuple[int, int]]:
    """Yield which of so many parts are joined, in order: pairs, then pairs of pairs, and so on.

    The first of each two stands for what both become.
    """
    distance = 1
    while distance < count:
        yield from ((k, k + distance) for k in range(0, count - distance, 2 * distance))
        distance *= 2
