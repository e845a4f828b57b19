"""From compiled bodies to a Model: bodies without joints lumped, every number rounded once.

A body of MuJoCo may have several joints, each anywhere in it. Here each joint has a link of its
own, whose frame has its origin at the joint: the last link of a body holds its mass, those before
it have none.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from flint import arb

from adagen.exact import Exact, exact, identity, rotated_inertia, rounded
from adagen.mjcf.compiled import BALL, FREE, HINGE, SLIDE, Compiled
from adagen.model import (
    BASE,
    FLOATING,
    PRISMATIC,
    REVOLUTE,
    SPHERICAL,
    Joint,
    JointKind,
    Link,
    Mimic,
    Model,
    Part,
    Passive,
    Pose,
    lump,
)
from adagen.model.placement import rotation_about, rotation_of_quaternion

Followed = Mapping[int, tuple[int, float, float]]
"""For each slaved joint the joint that it follows, multiplier and offset."""

_KINDS: dict[int, JointKind] = {
    FREE: FLOATING,
    BALL: SPHERICAL,
    SLIDE: PRISMATIC,
    HINGE: REVOLUTE,
}


@dataclass
class _Link:
    """A link while its fixed bodies are collected; ``joint`` is None for the base of --floating.

    Attributes:
        name: of the link.
        joint: MuJoCo's number of the joint that moves it.
        parent: index of its parent link.
        pose: of the joint's frame in the parent's frame.
        merged: names of bodies, and where their frames are in the link's.
        parts: mass, centre of mass and tensor about it in the link's frame, of each body.
    """

    name: str
    joint: int | None = None
    parent: int = 0
    pose: Pose = field(default_factory=Pose.home)
    merged: list[tuple[str, Pose]] = field(default_factory=list)
    parts: list[Part] = field(default_factory=list)


def model_of(
    robot: Compiled, floated: int | None, followed: Followed, passives: Mapping[int, Passive]
) -> Model:
    """Return the model of a compiled MJCF, under its own gravity.

    Args:
        robot: the compiled file.
        floated: a body on the world without joints that gets a floating base, or None.
        followed: slaved joints, by MuJoCo's numbers.
        passives: what joints do by themselves, by MuJoCo's numbers.
    """
    links = _links(robot, floated)
    index = {link.joint: k for k, link in enumerate(links[1:]) if link.joint is not None}
    joints = []
    for link in links[1:]:
        j, mimic = link.joint, None
        if j is not None and j in followed:
            source, multiplier, offset = followed[j]
            mimic = Mimic(index[source], multiplier, offset)
        joints.append(
            Joint(
                BASE if j is None else robot.joints[j],
                FLOATING if j is None else _KINDS[int(robot.model.jnt_type[j])],
                link.parent,
                rounded(link.pose.rotation),
                rounded(link.pose.translation),
                np.array([0.0, 0.0, 1.0]) if j is None else rounded(_axis(robot, j)),
                mimic,
                Passive() if j is None else passives.get(j, Passive()),
            )
        )
    return Model(
        robot.name,
        tuple(
            Link(link.name, lump(link.parts), tuple(pose.frame(name) for name, pose in link.merged))
            for link in links
        ),
        tuple(joints),
        gravity=np.array(robot.model.opt.gravity, dtype=np.float64) + 0.0,
        floating=bool(joints) and joints[0].name == BASE and joints[0].kind is FLOATING,
    )


def _links(robot: Compiled, floated: int | None) -> list[_Link]:
    """Return the links in depth-first order, the ground first."""
    children = robot.children()
    links = [_Link(robot.bodies[0])]
    at = {0: (0, Pose.home())}
    waiting = list(reversed(children[0]))
    while waiting:
        body = waiting.pop()
        waiting += reversed(children[body])
        index, frame = at[int(robot.model.body_parentid[body])]
        frame = frame.then(_turn(robot.model.body_quat[body]), exact(robot.model.body_pos[body]))
        if body == floated:
            links.append(_Link(robot.bodies[body]))
            index, frame = len(links) - 1, Pose.home()
        for j in robot.joints_of(body):
            index, frame = _jointed(robot, links, j, index, frame)
        if links[index].name != robot.bodies[body]:
            links[index].merged.append((robot.bodies[body], frame))
        at[body] = index, frame
        _add(robot, links[index], body, frame)
    return links


def _jointed(
    robot: Compiled, links: list[_Link], joint: int, index: int, frame: Pose
) -> tuple[int, Pose]:
    """Add a joint and its link; return the link's index, and the body's frame in the link's.

    Args:
        robot: the compiled file.
        links: are added to.
        joint: the joint.
        index: of the link that it is on.
        frame: the body's, in that link's, before the joint moves it.
    """
    body = int(robot.model.jnt_bodyid[joint])
    last = joint == robot.joints_of(body)[-1]
    if robot.model.jnt_type[joint] == FREE:  # its q is a pose in the world
        links.append(_Link(robot.bodies[body], joint))
        return len(links) - 1, Pose.home()
    anchor = robot.model.jnt_pos[joint]
    name = robot.bodies[body]
    if not last or anchor.any():
        name += f"@{robot.joints[joint]}"
    pose = frame.then(identity(), exact(anchor)).then(*_back(robot, joint))
    links.append(_Link(name, joint, index, pose))
    return len(links) - 1, Pose(identity(), -exact(anchor))


def _back(robot: Compiled, joint: int) -> tuple[Exact, Exact]:
    """Return the motion from q = ref, where the file shows a joint, to q = 0."""
    kind, still = robot.model.jnt_type[joint], exact([0.0, 0.0, 0.0])
    ref = arb(float(robot.model.qpos0[robot.model.jnt_qposadr[joint]]))
    if ref == 0 or kind == BALL:
        return identity(), still
    if kind == SLIDE:
        return identity(), _axis(robot, joint) * -ref
    return rotation_about(_axis(robot, joint), -ref), still


def _axis(robot: Compiled, joint: int) -> Exact:
    if robot.model.jnt_type[joint] not in (SLIDE, HINGE):
        return exact([0.0, 0.0, 1.0])
    axis = exact(robot.model.jnt_axis[joint])
    unit: Exact = axis / axis.dot(axis).sqrt()
    return unit


def _add(robot: Compiled, link: _Link, body: int, frame: Pose) -> None:
    """Add the mass of a body whose frame is at ``frame`` in the link's."""
    mass = float(robot.model.body_mass[body])
    moments = robot.model.body_inertia[body]
    if mass == 0.0 and not moments.any():
        return
    turn = _turn(robot.model.body_iquat[body])
    tensor = _as_given(robot, body, rotated_inertia(turn, exact(np.diag(moments))))
    link.parts.append(frame.moved((arb(mass), exact(robot.model.body_ipos[body]), tensor)))


NOISE = 1e-11
"""Off-diagonal moments (kg m^2) below this were left out by MuJoCo 3 as it looked for axes."""


def _as_given(robot: Compiled, body: int, tensor: Exact) -> Exact:
    """Return the tensor that the file gives, where MuJoCo changed it by rounding alone."""
    given = robot.tensors.get(body)
    if given is None:
        return tensor
    xx, yy, zz, xy, xz, yz = given
    own = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    changed = float(np.abs(rounded(tensor) - own).max())
    return exact(own) if changed <= NOISE + 1e-6 * float(np.abs(own).max()) else tensor


def _turn(wxyz: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> Exact:
    w, x, y, z = (arb(float(number)) for number in wxyz)
    return rotation_of_quaternion([x, y, z, w])
