"""Where welds are looked at: at a point through which the axes of joints go.

What a weld holds together it holds at every point. Rows at the centre of a ball joint, or on the
axis of a hinge, have no entries for that joint, so that what follows by them falls into parts that
are solved one after the other (adagen/graph/parts.py).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from adagen.exact import exact, rounded
from adagen.model import Model
from adagen.model.kinds import KINDS
from adagen.plan.closures import closures_of
from adagen.plan.constants import joints_of, loops_of
from adagen.plan.robot import PlanJoint, PlanLoop


def with_points(model: Model) -> tuple[PlanLoop, ...]:
    """Return a robot's loops, welds at the end whose joints have most freedoms that follow."""
    joints, loops = joints_of(model), loops_of(model)
    found = list(loops)
    for closure in closures_of(model):
        moved = set(closure.choices[0].moved)
        for k in closure.loops:
            loop = loops[k]
            if loop.kind == "weld":
                links = (loop.link1, loop.link2)
                counts = [len(moved.intersection(_turned(joints, link))) for link in links]
                if any(counts):
                    found[k] = _at_origin(loop, counts.index(max(counts)))
    return tuple(found)


def _turned(joints: Sequence[PlanJoint], link: int) -> list[int]:
    """Freedoms of the joints that turn a link about its origin, as entries of v."""
    found: list[int] = []
    while link > 0:
        joint = joints[link - 1]
        kind = KINDS[joint.kind]
        if any(row >= 3 for row in kind.free):
            break
        found += range(joint.v, joint.v + kind.nv)
        if any(joint.translation):
            break
        link = joint.parent
    return found


def _at_origin(loop: PlanLoop, side: int) -> PlanLoop:
    """A weld that is looked at in the origin of its first or its second link."""
    turns = [exact(loop.rotation1), exact(loop.rotation2)]
    places = [exact(loop.translation1), exact(loop.translation2)]
    other = 1 - side
    place = places[other] - turns[other].dot(turns[side].T.dot(places[side]))
    moved = [(0.0, 0.0, 0.0), tuple(float(x) for x in rounded(place))]
    one, two = (moved[int(k != side)] for k in (0, 1))
    return replace(loop, translation1=one, translation2=two)
