"""Damping and friction of joints, read only where they are asked for."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

from adagen.model import Model, Passive
from adagen.urdf.elements import Element, check_attributes, scalar
from adagen.urdf.notes import Notes, line_of

EFFECTS = ("damping", "friction")
"""Attributes of <dynamics>: N m s/rad and N m, or N s/m and N."""

Effects = Mapping[str, Mapping[str, float]]


def read_effects(root: Element, wanted: Collection[str], notes: Notes) -> Effects:
    """Return the wanted attributes of each joint's <dynamics>, by joint name, where not zero.

    Args:
        root: the element <robot>.
        wanted: some of ``EFFECTS``.
        notes: makes the refusals.

    Raises:
        InputError: a value is no number, or is negative.
    """
    if not wanted:
        return {}
    result: dict[str, dict[str, float]] = {}
    for joint in root.iterchildren("joint"):
        name = joint.get("name", "")
        for element in joint.iterchildren("dynamics"):
            where = f'joint "{name}"'
            check_attributes(element, EFFECTS, where, notes)
            for key in sorted(wanted):
                value = scalar(element, key, where, notes) or 0.0
                if value < 0.0:
                    raise notes.error(f"{where}: {key} {value!r} is negative", line_of(element))
                if value:
                    result.setdefault(name, {})[key] = value
    return result


def with_effects(model: Model, effects: Effects) -> Model:
    """Return the model with the effects of its joints of one degree of freedom."""
    joints = tuple(
        replace(joint, passive=replace(Passive(), **effects[joint.name]))
        if joint.kind.nv == 1 and joint.name in effects
        else joint
        for joint in model.joints
    )
    return replace(model, joints=joints)
