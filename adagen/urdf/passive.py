"""Damping and friction of joints in a URDF, read only if a scene asks for them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import replace

from adagen.model import Model, Passive
from adagen.urdf.elements import Element, check_attributes, scalar
from adagen.urdf.notes import Notes, line_of, quoted
from adagen.urdf.numbers import number

EFFECTS = ("damping", "friction")
"""Attributes of <dynamics>: N m s/rad and N m, or N s/m and N."""

_WAYS = {
    "damping": 'damping = "urdf"',
    "friction": 'friction = "urdf"',
    "stiffness": "stiffness in [joints.NAME]",
}
"""What a scene says to model an effect."""

SHOWN = 3  # joints that a warning names

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


def warn_dropped(root: Element, decided: Callable[[str, str], bool], notes: Notes) -> None:
    """Warn about <dynamics> of moving joints that the model does not contain.

    Attributes of the same joints take one line.

    Args:
        root: the element <robot>.
        decided: of an effect and a joint's name, whether what the model holds is what was asked
            for, so that there is nothing to warn of.
        notes: takes the warnings.
    """
    found: dict[str, dict[str, int | None]] = {}
    for joint in root.iterchildren("joint"):
        name = joint.get("name", "")
        for element in joint.iterchildren("dynamics") if joint.get("type") != "fixed" else ():
            for key in map(str, element.attrib):
                if not is_zero(element.get(key, "")) and not decided(key, name):
                    found.setdefault(key, {}).setdefault(name, line_of(element))
    tell_dropped(found, notes)


def tell_dropped(found: Mapping[str, Mapping[str, int | None]], notes: Notes) -> None:
    """Warn about passive forces of joints that the model does not contain.

    Args:
        found: for each effect, a member of ``EFFECTS`` or another, the joints that have it, with
            their lines.
        notes: takes the warnings, one for all effects of the same joints.
    """
    alike: dict[tuple[tuple[str, ...], bool], list[str]] = {}
    for key, joints in found.items():
        alike.setdefault((tuple(joints), key in _WAYS), []).append(key)
    for (names, known), keys in alike.items():
        those = f"joint {quoted(names)}" if len(names) == 1 else f"{len(names)} joints"
        how = f" ({quoted(names, SHOWN)})" if len(names) > 1 else ""
        are, them = ("is", "it") if len(keys) == 1 else ("are", "them")
        if known:
            entries = " and ".join(_WAYS[key] for key in keys)
            how += f": a scene with {entries} models {them}"
        line = found[keys[0]][names[0]]
        what = " and ".join([", ".join(keys[:-1]), keys[-1]] if len(keys) > 1 else keys)
        notes.warn(f"{what} of {those} {are} not modelled{how}", line)


def is_zero(text: str) -> bool:
    """Whether an attribute's text is a number, and zero."""
    try:
        return number(text.strip()) == 0.0
    except ValueError:
        return False


def with_effects(model: Model, effects: Effects) -> Model:
    """Return the model with the effects of its joints of one degree of freedom."""
    joints = tuple(
        replace(joint, passive=replace(Passive(), **effects[joint.name]))
        if joint.kind.nv == 1 and joint.name in effects
        else joint
        for joint in model.joints
    )
    return replace(model, joints=joints)
