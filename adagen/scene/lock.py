"""Locked joints: the links that they connect become one link, exact and rounded once."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from adagen.exact import exact, rounded
from adagen.model import Coupling, Frame, Link, Loop, Mimic, Model, Part, Pose, lump
from adagen.model.placement import placed


@dataclass
class _Body:
    """A link of the new model while what is locked to it is being gathered."""

    link: int
    frames: list[Frame]
    parts: list[Part] = field(default_factory=list)

    def take(self, link: Link, pose: Pose) -> None:
        """Add a link, and what is fixed to it, at a pose in this body's frame."""
        self.frames.append(pose.frame(link.name))
        for frame in link.frames:
            inside = pose.then(exact(frame.rotation), exact(frame.translation))
            self.frames.append(inside.frame(frame.name))
        self.parts.append(pose.part(link.inertia))

    def lumped(self, link: Link) -> Link:
        """Return the body's own link with all that was added."""
        added = [part for part in self.parts if part[0] != 0 or (part[2] != 0).any()]
        inertia = lump([Pose.home().part(link.inertia), *added]) if added else link.inertia
        return replace(link, inertia=inertia, frames=tuple(self.frames))


def lock(
    model: Model,
    values: Mapping[int, Sequence[Any]],
    masses: Mapping[int, Sequence[Part]] | None = None,
) -> Model:
    """Return the model with joints locked, and masses added, in the same depth-first order.

    Args:
        model: the robot.
        values: configuration (floats or arb) of each joint that is locked; a slaved joint with its
            source.
        masses: for each link what is added to it, in its frame.
    """
    masses = masses or {}
    home = Pose.home()
    bodies = [_Body(0, list(model.links[0].frames))]
    at = [(0, home)]  # the body of each link of the old model, and the link's pose in it
    joints = []
    kept = {j: k for k, j in enumerate(j for j in range(len(model.joints)) if j not in values)}
    for j, joint in enumerate(model.joints):
        body, pose = at[joint.parent]
        link = model.links[j + 1]
        if j not in values:
            put = pose.then(exact(joint.rotation), exact(joint.translation))
            joints.append(
                replace(
                    joint,
                    parent=body,
                    mimic=_renumbered(joint.mimic, kept),
                    rotation=rounded(put.rotation),
                    translation=rounded(put.translation),
                )
            )
            at.append((len(bodies), home))
            bodies.append(_Body(j + 1, list(link.frames)))
            continue
        here = placed(joint, values[j])
        pose = pose.then(here.rotation, here.translation)
        at.append((body, pose))
        bodies[body].take(link, pose)
    for k, parts in masses.items():
        body, pose = at[k]
        bodies[body].parts.extend(pose.moved(part) for part in parts)
    links = tuple(body.lumped(model.links[body.link]) for body in bodies)
    return replace(
        model,
        links=links,
        joints=tuple(joints),
        loops=tuple(_carried(loop, at) for loop in model.loops),
        couplings=tuple(
            left
            for coupling in model.couplings
            if (left := _without(coupling, values, kept)).terms or abs(left.offset) > left.tolerance
        ),
    )


def _carried(loop: Loop, at: Sequence[tuple[int, Pose]]) -> Loop:
    """A loop whose links are held by others, with its frames in these."""
    (body1, pose1), (body2, pose2) = at[loop.link1], at[loop.link2]
    return replace(
        loop,
        link1=body1,
        frame1=_inside(pose1, loop.frame1),
        link2=body2,
        frame2=_inside(pose2, loop.frame2),
    )


def _inside(pose: Pose, frame: Frame) -> Frame:
    return pose.then(exact(frame.rotation), exact(frame.translation)).frame(frame.name)


def _without(
    coupling: Coupling, values: Mapping[int, Sequence[Any]], kept: Mapping[int, int]
) -> Coupling:
    """A coupling in which locked joints are part of the offset."""
    known = sum((float(values[j][0]) * factor for j, factor in coupling.terms if j in values), 0.0)
    terms = tuple((kept[j], factor) for j, factor in coupling.terms if j not in values)
    return replace(coupling, terms=terms, offset=coupling.offset - known)


def select(model: Model, joints: Collection[int]) -> Model:
    """Return the model with only some joints and their child links.

    Args:
        model: the robot.
        joints: those that stay; with each all those between it and the ground, and with a slaved
            joint its source.
    """
    kept = {j: k for k, j in enumerate(sorted(joints))}
    number = {0: 0, **{j + 1: k + 1 for j, k in kept.items()}}
    return replace(
        model,
        links=tuple(model.links[old] for old in number),
        joints=tuple(
            replace(
                model.joints[j],
                parent=number[model.joints[j].parent],
                mimic=_renumbered(model.joints[j].mimic, kept),
            )
            for j in kept
        ),
        loops=tuple(
            replace(loop, link1=number[loop.link1], link2=number[loop.link2])
            for loop in model.loops
            if loop.link1 in number and loop.link2 in number
        ),
        couplings=tuple(
            replace(coupling, terms=tuple((kept[j], factor) for j, factor in coupling.terms))
            for coupling in model.couplings
            if all(j in kept for j, _ in coupling.terms)
        ),
    )


def _renumbered(mimic: Mimic | None, kept: Mapping[int, int]) -> Mimic | None:
    return None if mimic is None else replace(mimic, source=kept[mimic.source])
