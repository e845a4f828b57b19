"""Link frames rotated so that every joint axis is z."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np

from adagen.exact import Exact, exact, identity, rotated_inertia, rotation_taking_z_to, rounded
from adagen.model.links import Frame, Inertia
from adagen.model.model import Model


@lru_cache(maxsize=4)  # asked for by every plan that a search tries
def canonical(model: Model) -> Model:
    """Return the same robot with each joint frame and child link frame turned to have axis z.

    Joint coordinates, velocities and torques keep their meaning: those of a revolute or prismatic
    joint are scalars, those of a planar joint are given in the turned frame by definition, and the
    frames of other kinds are left alone. The gain: S and N of every joint are selections of rows.
    """
    turn = [identity()] + [
        rotation_taking_z_to(joint.axis) if joint.kind.has_axis else identity()
        for joint in model.joints
    ]
    links = [model.links[0]]
    joints = []
    for j, joint in enumerate(model.joints):
        at_parent, own = turn[joint.parent].T, turn[j + 1]
        inertia = model.links[j + 1].inertia
        com = own.T.dot(exact(inertia.com))
        tensor = rotated_inertia(own.T, exact(inertia.tensor))
        joints.append(
            replace(
                joint,
                rotation=rounded(at_parent.dot(exact(joint.rotation)).dot(own)),
                translation=rounded(at_parent.dot(exact(joint.translation))),
                axis=np.array([0.0, 0.0, 1.0]),
            )
        )
        links.append(
            replace(
                model.links[j + 1],
                inertia=Inertia(inertia.mass, rounded(com), rounded(tensor)),
                frames=tuple(_turned(frame, own) for frame in model.links[j + 1].frames),
            )
        )
    wrenches = tuple(
        replace(wrench, frame=_turned(wrench.frame, turn[wrench.link])) for wrench in model.wrenches
    )
    outputs = tuple(
        replace(output, frame=_turned(output.frame, turn[output.link])) for output in model.outputs
    )
    loops = tuple(
        replace(
            loop,
            frame1=_turned(loop.frame1, turn[loop.link1]),
            frame2=_turned(loop.frame2, turn[loop.link2]),
        )
        for loop in model.loops
    )
    return replace(
        model,
        links=tuple(links),
        joints=tuple(joints),
        wrenches=wrenches,
        outputs=outputs,
        loops=loops,
    )


def _turned(frame: Frame, turn: Exact) -> Frame:
    """Return a frame expressed in link axes that are turned."""
    rotation, translation = exact(frame.rotation), exact(frame.translation)
    return Frame(frame.name, rounded(turn.T.dot(rotation)), rounded(turn.T.dot(translation)))
