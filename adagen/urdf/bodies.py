"""From a described tree to a Model: fixed joints lumped, every number rounded once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from flint import arb

from adagen.exact import exact, rotated_inertia, rotation_from_rpy, rounded
from adagen.model import (
    BASE,
    FLOATING,
    PLANAR,
    PRISMATIC,
    REVOLUTE,
    SPHERICAL,
    WORLD,
    Joint,
    JointKind,
    Link,
    Mimic,
    Model,
    Part,
    Pose,
    lump,
)
from adagen.urdf.description import WITH_AXIS, Description, Inertial, JointElement, Origin, Triple
from adagen.urdf.tree import Tree

KIND_OF: dict[str, JointKind] = {
    "revolute": REVOLUTE,
    "continuous": REVOLUTE,
    "prismatic": PRISMATIC,
    "planar": PLANAR,
    "spherical": SPHERICAL,
    "ball": SPHERICAL,
    "floating": FLOATING,
}


@dataclass
class Body:
    """A link that moves on its own, while the links fixed to it are being gathered.

    Attributes:
        name: of the link whose frame the body's is.
        joint: that moves it; None for the ground or under a floating base.
        parent: index of its parent body.
        pose: of the joint frame in the parent's frame.
        merged: names of the links fixed to it, and where their frames are in the body's.
        parts: mass, centre of mass and tensor about it in the body's frame, of each massive link.
    """

    name: str
    joint: JointElement | None
    parent: int
    pose: Pose
    merged: list[tuple[str, Pose]] = field(default_factory=list)
    parts: list[Part] = field(default_factory=list)

    def add(self, inertial: Inertial | None, pose: Pose) -> None:
        """Add the mass of a link whose frame is at ``pose``."""
        if inertial is None or not (inertial.mass or any(inertial.moments)):
            return
        frame = _at(pose, inertial.origin)
        xx, xy, xz, yy, yz, zz = inertial.moments
        tensor = exact([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        self.parts.append(
            (arb(inertial.mass), frame.translation, rotated_inertia(frame.rotation, tensor))
        )


def _at(pose: Pose, origin: Origin) -> Pose:
    """Return the pose of a frame that is at ``origin`` in the frame at ``pose``."""
    return pose.then(rotation_from_rpy(origin.rpy), exact(origin.xyz))


def gather(description: Description, tree: Tree, floating: bool) -> list[Body]:
    """Return the bodies in depth-first order, the ground first (the world if floating)."""
    inertials = {link.name: link.inertial for link in description.links}
    home = Pose.home()
    bodies = [Body(WORLD, None, 0, home)] if floating else []
    bodies.append(Body(tree.root, None, 0, home))
    at = {tree.root: (len(bodies) - 1, home)}
    bodies[-1].add(inertials[tree.root], home)
    for joint in tree.depth_first():
        index, pose = at[joint.parent]
        frame = _at(pose, joint.origin)
        if joint.type == "fixed":
            at[joint.child] = (index, frame)
            bodies[index].merged.append((joint.child, frame))
            bodies[index].add(inertials[joint.child], frame)
        else:
            at[joint.child] = (len(bodies), home)
            bodies.append(Body(joint.child, joint, index, frame))
            bodies[-1].add(inertials[joint.child], home)
    return bodies


def unit(axis: Triple) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Return the axis divided by its length, exactly and rounded once; shape (3,)."""
    a = exact(axis)
    return rounded(a / a.dot(a).sqrt())


def build(
    name: str,
    bodies: Sequence[Body],
    mimics: dict[str, tuple[str, float, float]],
    floating: bool,
) -> Model:
    """Return the model of gathered bodies.

    Args:
        name: the robot's.
        bodies: from ``gather``.
        mimics: for each slaved joint the joint that it follows, multiplier and offset.
        floating: whether bodies[1] hangs on a floating base.
    """
    index = {body.joint.name: j for j, body in enumerate(bodies[1:]) if body.joint is not None}
    joints = []
    for body in bodies[1:]:
        element = body.joint
        mimic = None
        if element is not None and element.name in mimics:
            source, multiplier, offset = mimics[element.name]
            mimic = Mimic(index[source], multiplier, offset)
        joints.append(
            Joint(
                BASE if element is None else element.name,
                FLOATING if element is None else KIND_OF[element.type],
                body.parent,
                rounded(body.pose.rotation),
                rounded(body.pose.translation),
                unit(element.axis)
                if element is not None and element.type in WITH_AXIS
                else np.array([0.0, 0.0, 1.0]),
                mimic,
            )
        )
    links = tuple(
        Link(body.name, lump(body.parts), tuple(pose.frame(name) for name, pose in body.merged))
        for body in bodies
    )
    return Model(name, links, tuple(joints), floating=floating)
