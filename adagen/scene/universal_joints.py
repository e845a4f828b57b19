"""Universal joints: a joint becomes two hinges with a massless link between them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from adagen.model import REVOLUTE, Inertia, Joint, Link, Model, Passive

AXES = "XYZ"


def with_universal_joints(model: Model, crosses: Mapping[int, str]) -> Model:
    """Return a robot in which some joints are universal.

    A joint NAME becomes two, NAME_X about the first axis of its frame, NAME_Y about the second; the
    cross between them is a link NAME_cross, whose frame is its child link's at rest.

    Args:
        model: the robot; its wrenches and outputs are not yet known.
        crosses: for each joint two different letters of ``AXES``: the hinges' axes in its frame.
    """
    before = [sum(j < k for j in crosses) for k in range(len(model.links))]  # by link
    links, joints = [model.links[0]], list[Joint]()
    for j, joint in enumerate(model.joints):
        parent = joint.parent + before[joint.parent]
        mimic = joint.mimic
        if mimic is not None:
            mimic = replace(mimic, source=mimic.source + before[mimic.source + 1])
        last = replace(joint, parent=parent, mimic=mimic)
        if j in crosses:
            first, last = _hinges(last, crosses[j], len(links))
            joints.append(first)
            links.append(Link(f"{joint.name}_cross", Inertia.zero()))
        joints.append(last)
        links.append(model.links[j + 1])
    return replace(
        model,
        links=tuple(links),
        joints=tuple(joints),
        loops=tuple(
            replace(
                loop,
                link1=loop.link1 + before[loop.link1],
                link2=loop.link2 + before[loop.link2],
            )
            for loop in model.loops
        ),
        couplings=tuple(
            replace(one, terms=tuple((j + before[j + 1], factor) for j, factor in one.terms))
            for one in model.couplings
        ),
    )


def _hinges(joint: Joint, letters: str, cross: int) -> tuple[Joint, Joint]:
    """Return the two hinges of a joint; the link between them has a number."""
    first, second = (np.eye(3)[AXES.index(letter)] for letter in letters)
    hinge = replace(joint, kind=REVOLUTE, passive=Passive())
    return (
        replace(hinge, name=f"{joint.name}_{letters[0]}", axis=first),
        replace(
            hinge,
            name=f"{joint.name}_{letters[1]}",
            parent=cross,
            rotation=np.eye(3),
            translation=np.zeros(3),
            axis=second,
        ),
    )
