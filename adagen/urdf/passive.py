"""Damping and friction of joints in a URDF, read only if a scene asks for them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import replace

from adagen.model import Model
from adagen.urdf.bodies import KIND_OF
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

SEVERAL = "no single meaning for a joint of several degrees of freedom"
"""Why a joint's passive effects are not modelled whatever a scene says."""

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
    unfit: dict[str, dict[str, int | None]] = {}
    for joint in root.iterchildren("joint"):
        name = joint.get("name", "")
        for element in joint.iterchildren("dynamics") if joint.get("type") != "fixed" else ():
            kind = KIND_OF[joint.get("type", "")]
            for key in map(str, element.attrib):
                fits = key not in EFFECTS or kind.takes(key)
                if not is_zero(element.get(key, "")) and not (fits and decided(key, name)):
                    where = found if fits else unfit
                    where.setdefault(key, {}).setdefault(name, line_of(element))
    tell_dropped(found, notes)
    tell_dropped(unfit, notes, why=SEVERAL)


def tell_dropped(
    found: Mapping[str, Mapping[str, int | None]], notes: Notes, why: str | None = None
) -> None:
    """Warn about passive forces of joints that the model does not contain.

    Args:
        found: for each effect, a member of ``EFFECTS`` or another, the joints that have it, with
            their lines.
        notes: takes the warnings, one for all effects of the same joints.
        why: why no scene can model them; by default, what a scene says that does.
    """
    alike: dict[tuple[tuple[str, ...], bool], list[str]] = {}
    for key, joints in found.items():
        alike.setdefault((tuple(joints), key in _WAYS), []).append(key)
    for (names, known), keys in alike.items():
        those = f"joint {quoted(names)}" if len(names) == 1 else f"{len(names)} joints"
        how = f" ({quoted(names, SHOWN)})" if len(names) > 1 else ""
        are, them = ("is", "it") if len(keys) == 1 else ("are", "them")
        if why is not None:
            how += f": {why}"
        elif known:
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
    """Return the model with those effects that joints of their kinds take."""
    joints = []
    for joint in model.joints:
        own = effects.get(joint.name, {})
        own = {effect: value for effect, value in own.items() if joint.kind.takes(effect)}
        joints.append(replace(joint, passive=replace(joint.passive, **own)))
    return replace(model, joints=tuple(joints))
