"""Remarks about parts of a URDF that are not modelled, or odd but harmless."""

from __future__ import annotations

from collections import Counter

import numpy as np

from adagen.model import Model
from adagen.urdf.description import Description, Inertial
from adagen.urdf.elements import Element
from adagen.urdf.notes import Notes, line_of
from adagen.urdf.numbers import number

ROUNDING = 1e-9
"""Relative; printed moments of inertia rarely carry more digits."""

SHOWN = 20
"""Kinds of ignored elements before the rest is summed up."""

_LINK_EXTRAS = ("visual", "collision")
_JOINT_EXTRAS = {
    "limit": "limits (position, velocity, effort)",
    "safety_controller": "safety controllers",
    "calibration": "calibrations",
}
_MODELLED = {
    "link": {"inertial"},
    "joint": {"parent", "child", "origin", "axis", "mimic", "dynamics"},
    "loop": {"predecessor", "successor", "axis"},
    "loop_joint": {"link1", "link2", "axis"},
    "coupling": {"predecessor", "successor", "ratio"},
}
"""What is modelled, or warned of where it is not."""


def remark_ignored(root: Element, notes: Notes) -> None:
    """Record which elements of the file have no influence on the model, with their number."""
    counts: Counter[str] = Counter()
    for part in root:
        tag = _as_written(part)
        if tag not in _MODELLED:
            counts[f"<{tag}> elements"] += 1
            continue
        for child in part:
            name = _as_written(child)
            if name in _MODELLED[tag]:
                continue
            if tag == "joint" and name in _JOINT_EXTRAS:
                counts[f"joint {_JOINT_EXTRAS[name]}"] += 1
            elif tag == "link" and name in _LINK_EXTRAS:
                counts[f"{name}s"] += 1
            else:
                counts[f"<{name}> elements of a {tag}"] += 1
    for text in sorted(counts)[:SHOWN]:
        notes.ignore(f"{text}: {counts[text]}, not modelled")
    others = sorted(counts)[SHOWN:]
    if others:
        count = sum(counts[text] for text in others)
        notes.ignore(f"elements with {len(others)} other names: {count}, not modelled")


def _as_written(element: Element) -> str:
    """Return an element's name with its prefix, not with its namespace."""
    local = str(element.tag).rpartition("}")[2]
    return local if element.prefix is None else f"{element.prefix}:{local}"


_FOREIGN = {
    "inertia_scaling": ("inertia scaling", "Bullet", "1"),
    "rotor_inertia": ("rotor inertia", "Drake", "0"),
    "rotorInertia": ("rotor inertia", "Pinocchio", "0"),
    "springStiffness": ("springs", "Gazebo", "0"),
    "turnGravityOff": ("gravity switched off", "Gazebo", "0"),
}
"""Elements of one reader alone that change the dynamics: what, whose, and the value that does not.

In a scene, [joints.NAME] has rotor_inertia and stiffness.
"""


def warn_foreign(root: Element, notes: Notes) -> None:
    """Warn of what single readers would model beside the elements of a URDF, one line for each."""
    found: dict[str, list[int | None]] = {}
    for element in root.iter():
        tag = str(element.tag).rpartition("}")[2].rpartition(":")[2]
        if tag in _FOREIGN and _changes(element, _FOREIGN[tag][2]):
            found.setdefault(tag, []).append(line_of(element))
    for tag, lines in found.items():
        what, whose, _ = _FOREIGN[tag]
        places = f"{len(lines)} place{'s' * (len(lines) > 1)}"
        notes.warn(f"{what} ({whose}'s <{tag}>) in {places} is not modelled", lines[0])


def _changes(element: Element, nothing: str) -> bool:
    """Whether an element's value, an attribute or text, is another one than ``nothing``."""
    text = (element.get("value") or element.text or "").strip().lower()
    text = {"true": "1", "false": "0"}.get(text, text)
    try:
        return number(text) != number(nothing)
    except ValueError:
        return bool(text)


LIMB = 3
"""Joints that a limb has at least, beside few others."""

LEG, LEGS = 2, 4
"""Joints that a leg of small quadrupeds has, and how many limbs are legs in spite of that."""


def warn_held(model: Model, notes: Notes) -> None:
    """Warn of a root link with mass and limbs, as walking robots have, that is held fixed."""
    sizes = [_joints_from(model, joint) for joint in model.children[0]]
    legs = sum(size >= LEG for size in sizes)
    limbs = legs if legs >= LEGS else sum(size >= LIMB for size in sizes)
    mass = model.links[0].inertia.mass
    if limbs > 1 and mass > 0.0:
        notes.warn(
            f'the root link "{model.links[0].name}" ({mass:.3g} kg, {limbs} limbs) is held fixed: '
            "--floating sets it free"
        )


def _joints_from(model: Model, first: int) -> int:
    count, waiting = 0, [first]
    while waiting and count < LIMB:
        count += 1
        waiting += model.children[waiting.pop() + 1]
    return count


def warn_limits(root: Element, notes: Notes) -> None:
    """Warn of joint limits that cannot be meant: forward dynamics does not use them."""
    found: list[tuple[str, str, int | None]] = []
    for joint in root.iterchildren("joint"):
        name = joint.get("name", "")
        for limit in joint.iterchildren("limit"):
            try:
                lower = number(limit.get("lower", "0").strip())
                upper = number(limit.get("upper", "0").strip())
            except ValueError as fault:
                found.append((name, f'joint "{name}": <limit> {fault} (not used)', line_of(limit)))
                continue
            if lower > upper:
                text = f'joint "{name}": lower limit {lower:g} is above the upper one {upper:g}'
                found.append((name, f"{text} (not used)", line_of(limit)))
    notes.warn_together(found, "joints have such limits")


def warn_inertias(description: Description, notes: Notes) -> None:
    """Warn of links that no real mass distribution has; whole bodies are judged later."""
    found: list[tuple[str, str, int | None]] = []
    for link in description.links:
        problem = None if link.inertial is None else _problem(link.inertial)
        if problem is not None and link.inertial is not None:
            found.append((link.name, f'link "{link.name}": {problem}', link.inertial.line))
    notes.warn_each(found, "links have an inertia that no real body has")


def _problem(inertial: Inertial) -> str | None:
    xx, xy, xz, yy, yz, zz = inertial.moments
    low, middle, high = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).tolist()
    size = max(abs(low), abs(high))
    if low < -ROUNDING * size:
        return f"inertia has a negative principal moment ({low:.3g}): used as written"
    if low + middle < high - ROUNDING * size:
        return (
            f"principal moments {low:.3g}, {middle:.3g}, {high:.3g} break the triangle inequality: "
            "used as written"
        )
    if inertial.mass == 0.0 and size > 0.0:
        return "has a moment of inertia but no mass: used as written"
    return None
