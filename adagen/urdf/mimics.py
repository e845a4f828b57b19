"""Mimic joints, resolved to sources that follow no other joint."""

from __future__ import annotations

from flint import arb

from adagen.urdf.description import SCALAR_TYPES, Description, JointElement
from adagen.urdf.notes import Notes, quoted
from adagen.urdf.numbers import LARGEST

Followed = dict[str, tuple[str, float, float]]
"""Joint name to the independent joint that it follows, multiplier and offset."""


def resolve(description: Description, slaved: bool, notes: Notes) -> Followed:
    """Return what each mimic joint follows, empty where they are to stay independent.

    Args:
        description: the robot.
        slaved: whether the user wants mimic joints slaved.
        notes: takes one warning for each mimic joint that stays independent.

    Raises:
        InputError: a mimic joint follows itself or in a circle; or, if slaved, it follows nothing,
            or it or what it follows has other than one degree of freedom.
    """
    joints = {joint.name: joint for joint in description.joints}
    mimics = [joint for joint in description.joints if joint.mimic is not None]
    _check_sources(mimics, joints, slaved, notes)
    mimics = [joint for joint in mimics if joint.mimic and joint.mimic.joint in joints]
    _refuse_circles(mimics, joints, notes)
    if not slaved:
        _warn_independent(mimics, notes)
        return {}
    for joint in mimics:
        _check_freedom(joint, joints, notes)
    return {joint.name: _compose(joint, joints, notes) for joint in mimics}


def _source(joint: JointElement, joints: dict[str, JointElement]) -> JointElement | None:
    return None if joint.mimic is None else joints.get(joint.mimic.joint)


def _check_sources(
    mimics: list[JointElement], joints: dict[str, JointElement], slaved: bool, notes: Notes
) -> None:
    dangling: list[tuple[str, str, int | None]] = []
    for joint in mimics:
        assert joint.mimic is not None
        source, line = joint.mimic.joint, joint.mimic.line
        if source == joint.name:
            raise notes.error(
                f'joint "{joint.name}" mimics itself: remove its <mimic> or name another joint',
                line,
            )
        if source not in joints:
            nothing = f'joint "{joint.name}" mimics joint "{source}", which does not exist'
            if slaved:
                raise notes.error(f"{nothing}: correct the name or remove its <mimic>", line)
            dangling.append((joint.name, nothing, line))
    notes.slips(dangling, "independent here", "that mimic nothing")


def _refuse_circles(
    mimics: list[JointElement], joints: dict[str, JointElement], notes: Notes
) -> None:
    ends: set[str] = set()
    for start in mimics:
        path: dict[str, None] = {}
        joint: JointElement | None = start
        while joint is not None and joint.name not in ends:
            if joint.name in path:
                names = list(path)
                circle = names[names.index(joint.name) :]
                raise notes.error(
                    f"joints {quoted(circle)} mimic each other in a circle: remove one <mimic>",
                    joint.line,
                )
            path[joint.name] = None
            joint = _source(joint, joints)
        ends.update(path)


def _check_freedom(joint: JointElement, joints: dict[str, JointElement], notes: Notes) -> None:
    source = _source(joint, joints)
    for one in (joint, source):
        if one is not None and one.type not in SCALAR_TYPES:
            raise notes.error(
                f'joint "{joint.name}" mimics "{source.name if source else ""}": joint '
                f'"{one.name}" is {one.type}, and only {", ".join(sorted(SCALAR_TYPES))} joints '
                "can mimic or be mimicked: remove the <mimic> or read without --mimic",
                joint.mimic.line if joint.mimic else joint.line,
            )


def _compose(
    joint: JointElement, joints: dict[str, JointElement], notes: Notes
) -> tuple[str, float, float]:
    """Return q = multiplier * q[source] + offset with a source that mimics nothing."""
    multiplier, offset = arb(1), arb(0)
    at = joint
    while at.mimic is not None:
        offset += multiplier * arb(at.mimic.offset)
        multiplier = (multiplier * arb(at.mimic.multiplier)).mid()
        at = joints[at.mimic.joint]
    result = (at.name, float(multiplier) + 0.0, float(offset.mid()) + 0.0)
    if max(abs(result[1]), abs(result[2])) > LARGEST:
        raise notes.error(
            f'joint "{joint.name}": its <mimic>, followed along the chain of mimics to '
            f'"{at.name}", is too large to compute with',
            joint.mimic.line if joint.mimic else joint.line,
        )
    return result


def _warn_independent(mimics: list[JointElement], notes: Notes) -> None:
    """Warn in one line of joints whose <mimic> is not modelled."""
    free = [joint for joint in mimics if joint.type != "fixed"]
    for joint in free[:1]:
        assert joint.mimic is not None
        text = f'joint "{joint.name}" mimics "{joint.mimic.joint}" but is independent here'
        if len(free) > 1:
            names = quoted([joint.name for joint in free], shown=3)
            text = f"{len(free)} joints mimic others but are independent here ({names})"
        notes.warn(
            f"{text}: --mimic makes {'it' if len(free) == 1 else 'them'} follow", joint.mimic.line
        )
