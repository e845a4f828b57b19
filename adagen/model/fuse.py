"""Runs of joints through massless links, which are joined as one joint.

A massless link has no inverse inertia, so Eq. (3)-(10) of the paper cannot join anything to it. The
joints on its two sides are then treated as one, with S = [X_(last<-j) S_j], in the frame of the
last link. A point mass on the axis of a joint moves equally with both links of that joint: it may
be assigned to either, which leaves the other without mass, exactly.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from adagen.exact import Exact, exact
from adagen.model.frames import canonical
from adagen.model.links import Inertia
from adagen.model.model import Joint, Model
from adagen.model.rigid import Part, lump

Run = tuple[int, ...]
"""Joints in a row, outwards; the links between them have no mass."""

MOST_FREEDOMS = 6

NOISE = 2.0**-60
"""A point this near to an axis, relative to the lengths around it, lies on it."""


def runs_of(model: Model) -> tuple[Run, ...]:
    """Return the runs of a model, the longest ones, in the order of their joints.

    A run ends at a link with several joints beyond it, or with a force or a loop upon it. None has
    more than six degrees of freedom, or a joint with rotor inertia or of prescribed acceleration.
    """
    upright = canonical(model)
    starts = {j for j in range(len(model.joints)) if not _is_inner(upright, model.joints[j].parent)}
    runs = []
    for first in sorted(starts):
        run = [first]
        while _is_inner(upright, run[-1] + 1):
            run.append(model.children[run[-1] + 1][0])
        if len(run) > 1 and _fusible(upright, run):
            runs.append(tuple(run))
    return tuple(runs)


def settled(model: Model, runs: Iterable[Run]) -> Model:
    """Return the same robot with the point masses inside of runs assigned to their ends.

    Forces, accelerations and the joint-space inertia are the same.

    Args:
        model: the robot; what is returned is in canonical frames (every joint axis z).
        runs: some of its runs.
    """
    upright = canonical(model)
    parts: dict[int, list[Part]] = {}
    links = list(upright.links)
    for run in runs:
        for joint in run[:-1]:
            inertia = upright.links[joint + 1].inertia
            if inertia.mass > 0.0:
                end = _end_of(upright, run, joint + 1)
                assert end is not None  # that is what makes it a run
                parts.setdefault(end[0], []).append(
                    (exact(inertia.mass).item(), end[1], exact(inertia.tensor))
                )
            links[joint + 1] = replace(links[joint + 1], inertia=Inertia.zero())
    for number, added in parts.items():
        if number > 0:  # what rests on the ground has no say
            own = links[number].inertia
            whole = (exact(own.mass).item(), exact(own.com), exact(own.tensor))
            links[number] = replace(links[number], inertia=lump([whole, *added]))
    return replace(upright, links=tuple(links))


def _is_inner(model: Model, number: int) -> bool:
    """Whether a link has one joint beyond it and nothing to set in motion but a point, at most."""
    if number == 0 or len(model.children[number]) != 1:
        return False
    pushed = any(wrench.link == number for wrench in model.wrenches)
    pushed = pushed or any(number == link for loop in model.loops for link, _ in loop.ends)
    return not model.links[number].inertia.tensor.any() and not pushed


def _fusible(model: Model, run: Sequence[int]) -> bool:
    joints = [model.joints[j] for j in run]
    return (
        sum(joint.kind.nv for joint in joints) <= MOST_FREEDOMS
        and not any(joint.passive.rotor_inertia or joint.prescribed for joint in joints)
        and all(
            model.links[j + 1].inertia.mass == 0.0 or _end_of(model, run, j + 1) is not None
            for j in run[:-1]
        )
    )


def _end_of(model: Model, run: Sequence[int], number: int) -> tuple[int, Exact] | None:
    """Return the end of a run in which a link's centre of mass is at rest, and its place there."""
    lengths = [model.links[run[-1] + 1].inertia.com, *(model.joints[j].translation for j in run)]
    least = NOISE * max(float(abs(x).max()) for x in lengths)
    place = exact(model.links[number].inertia.com)
    inwards = [model.joints[j] for j in reversed(run) if j < number]
    for joint in inwards:
        if not _rests(joint, place, least):
            break
        place = exact(joint.translation) + exact(joint.rotation).dot(place)
    else:
        return inwards[-1].parent, place
    place = exact(model.links[number].inertia.com)
    for joint in (model.joints[j] for j in run if j >= number):
        place = exact(joint.rotation).T.dot(place - exact(joint.translation))
        if not _rests(joint, place, least):
            return None
    return run[-1] + 1, place


def _rests(joint: Joint, place: Exact, least: float) -> bool:
    """Whether the joint does not move a point, given in joint coordinates."""
    moved = {"revolute": 2, "spherical": 3}.get(joint.kind.name)
    return moved is not None and all(abs(float(x)) <= least for x in place[:moved])
