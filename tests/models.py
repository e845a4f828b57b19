"""Robots for tests, built directly as models: chains, trees, stars, a human figure.

``from tests.models import serial_chain, random_tree, ...``. All are of the same form as what the
URDF reader gives: depth-first joints with siblings by name, one inertia per link.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from adagen.model import (
    BASE,
    FLOATING,
    KINDS,
    PRISMATIC,
    REVOLUTE,
    SPHERICAL,
    Frame,
    Inertia,
    Joint,
    JointKind,
    Link,
    Mimic,
    Model,
)

Array = NDArray[np.float64]
AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
ALL_KINDS = tuple(KINDS.values())


def vector(*values: float) -> Array:
    """Return the values as a float array."""
    return np.array(values, dtype=np.float64)


@dataclass(frozen=True, eq=False)
class Part:
    """A joint and the link under it, ``parent`` being a joint's name or None for the ground."""

    name: str
    parent: str | None
    kind: JointKind
    inertia: Inertia
    translation: Array = field(default_factory=lambda: np.zeros(3))
    rotation: Array = field(default_factory=lambda: np.eye(3))
    axis: Array = field(default_factory=lambda: vector(0.0, 0.0, 1.0))
    mimic: tuple[str, float, float] | None = None  # source joint, multiplier, offset


def assemble(name: str, parts: Sequence[Part], floating: bool = False) -> Model:
    """Return the model of the parts, given in any order."""
    below: dict[str | None, list[Part]] = {}
    for part in parts:
        below.setdefault(part.parent, []).append(part)
    ordered: list[tuple[Part, int]] = []
    waiting = [(part, 0) for part in sorted(below.get(None, []), key=_descending)]
    while waiting:
        part, parent = waiting.pop()
        ordered.append((part, parent))
        waiting += [(p, len(ordered)) for p in sorted(below.get(part.name, []), key=_descending)]
    if len(ordered) != len(parts):
        raise ValueError("some parts hang on a parent that does not exist")
    index = {part.name: j for j, (part, _) in enumerate(ordered)}
    joints = [
        Joint(
            part.name,
            part.kind,
            parent,
            part.rotation,
            part.translation,
            part.axis if part.kind.has_axis else vector(0.0, 0.0, 1.0),
            None if part.mimic is None else Mimic(index[part.mimic[0]], *part.mimic[1:]),
        )
        for part, parent in ordered
    ]
    links = [Link("ground", Inertia.zero())]
    links += [Link(f"{part.name}_link", part.inertia) for part, _ in ordered]
    return Model(name, tuple(links), tuple(joints), floating=floating)


def _descending(part: Part) -> tuple[int, ...]:
    return (*(-ord(c) for c in part.name), 1)  # a stack pops the last: least name last


def rod(mass: float, tip: Array, radius: float = 0.02) -> Inertia:
    """Return a solid cylinder of the given mass from the origin to ``tip``."""
    length = float(np.linalg.norm(tip))
    along = tip / length
    across = mass * (3 * radius**2 + length**2) / 12
    outer = np.outer(along, along)
    tensor = across * (np.eye(3) - outer) + 0.5 * mass * radius**2 * outer
    return Inertia(mass, tip / 2, (tensor + tensor.T) / 2)


def random_rotation(rng: np.random.Generator) -> Array:
    """Return a rotation, uniformly distributed, shape (3, 3)."""
    x, y, z, w = _unit(rng.normal(size=4))
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def _unit(values: Array) -> Array:
    unit: Array = values / np.linalg.norm(values)
    return unit


def random_inertia(rng: np.random.Generator) -> Inertia:
    """Return the inertia of a possible body: 0.2 to 2 kg, 3 to 20 cm across."""
    mass = float(rng.uniform(0.2, 2.0))
    turn = random_rotation(rng)
    spread = turn @ np.diag(rng.uniform(0.03, 0.2, size=3) ** 2) @ turn.T
    tensor = mass * (np.trace(spread) * np.eye(3) - spread)
    return Inertia(mass, rng.uniform(-0.2, 0.2, size=3), (tensor + tensor.T) / 2)


def serial_chain(
    n: int,
    *,
    axes: str = "xyz",
    kind: JointKind = REVOLUTE,
    mass: float = 0.5,
    length: float = 0.2,
    radius: float = 0.02,
    floating: bool = False,
) -> Model:
    """Return n equal rods end to end along x, the axes taken in turn from ``axes``.

    With ``floating``, one more rod on a floating base joint precedes them.
    """
    step = vector(length, 0.0, 0.0)
    body = rod(mass, step, radius)
    parts = [Part(BASE, None, FLOATING, body)] if floating else []
    for i in range(n):
        above = parts[-1].name if parts else None
        axis = vector(*AXES[axes[i % len(axes)]])
        offset = step if above is not None else np.zeros(3)
        parts.append(Part(f"j{i:03d}", above, kind, body, offset, axis=axis))
    return assemble(f"chain{n}", parts, floating)


def random_tree(
    rng: np.random.Generator,
    n: int,
    kinds: Sequence[JointKind] = ALL_KINDS,
    *,
    branching: float = 0.4,
    floating: bool = False,
    mimics: int = 0,
    coordinate_axes: bool = False,
) -> Model:
    """Return a random tree of n joints of the given kinds, oblique axes and inertias of bodies.

    Args:
        rng: where randomness comes from.
        n: joints, not counting the floating base.
        kinds: what joints are drawn from.
        branching: chance that a joint hangs on any earlier link instead of the last one; 0 gives
            a serial chain.
        floating: put a floating base under it.
        mimics: joints slaved to another revolute or prismatic one, at most.
        coordinate_axes: whether axes are x, y or z (either sign) instead of oblique.
    """
    parts = [Part(BASE, None, FLOATING, random_inertia(rng))] if floating else []
    for i in range(n):
        anywhere = rng.random() < branching
        above = parts[int(rng.integers(len(parts))) if anywhere else -1].name if parts else None
        axis = _unit(rng.normal(size=3))
        if coordinate_axes:
            axis = np.eye(3)[int(rng.integers(3))] * rng.choice([-1.0, 1.0])
        kind = kinds[int(rng.integers(len(kinds)))]
        place = rng.uniform(-0.3, 0.3, size=3)
        name, body = f"j{i}", random_inertia(rng)
        parts.append(Part(name, above, kind, body, place, random_rotation(rng), axis))
    return assemble(f"tree{n}", _with_mimics(rng, parts, mimics), floating)


def some_rubbing(model: Model, seed: int) -> Model:
    """Return a robot with friction in about half of its hinges and sliders."""
    rubs = np.random.default_rng(seed).random(len(model.joints)) < 0.5
    joints = [
        replace(joint, passive=replace(joint.passive, friction=0.1))
        if rub and joint.kind.takes("friction")
        else joint
        for joint, rub in zip(model.joints, rubs, strict=True)
    ]
    return replace(model, joints=tuple(joints))


def _with_mimics(rng: np.random.Generator, parts: list[Part], count: int) -> list[Part]:
    scalar = [k for k, part in enumerate(parts) if part.kind in (REVOLUTE, PRISMATIC)]
    followers = sorted(scalar[1:], key=lambda _: rng.random())[:count]
    sources = [k for k in scalar if k not in followers]
    for k in followers:
        source = parts[sources[int(rng.integers(len(sources)))]].name
        part, relation = parts[k], (float(rng.uniform(-2, 2)), float(rng.uniform(-1, 1)))
        parts[k] = Part(
            part.name,
            part.parent,
            part.kind,
            part.inertia,
            part.translation,
            part.rotation,
            part.axis,
            (source, *relation),
        )
    return parts


def star(
    arms: int, joints_per_arm: int = 2, *, kind: JointKind = REVOLUTE, floating: bool = False
) -> Model:
    """Return a hub with arms; without ``floating`` the hub turns on a fixed z axis."""
    hub = Inertia(3.0, np.zeros(3), np.diag([0.02, 0.02, 0.03]))
    root = Part(BASE, None, FLOATING, hub) if floating else Part("hub", None, REVOLUTE, hub)
    parts = [root]
    for a in range(arms):
        angle = 2 * np.pi * a / arms
        out = vector(float(np.cos(angle)), float(np.sin(angle)), 0.0)
        across = vector(-out[1], out[0], 0.0)
        above, place = root.name, 0.15 * out
        for i in range(joints_per_arm):
            axis = across if i % 2 else AXES["z"]
            name, body = f"a{a:02d}_{i}", rod(0.4, 0.2 * out)
            parts.append(Part(name, above, kind, body, place, axis=vector(*axis)))
            above, place = name, 0.2 * out
    return assemble(f"star{arms}", parts, floating)


def binary(levels: int, *, floating: bool = False) -> Model:
    """Return a complete binary tree of revolute joints, 2^(levels + 1) - 2 of them."""
    parts = [Part(BASE, None, FLOATING, rod(1.0, vector(0.0, 0.0, 0.2)))] if floating else []
    above: list[tuple[str | None, str]] = [(BASE if floating else None, "b")]
    for level in range(levels):
        below: list[tuple[str | None, str]] = []
        for parent, path in above:
            for side, sign in (("l", 1.0), ("r", -1.0)):
                body = rod(0.5, vector(0.0, sign * 0.1, 0.2))
                place = vector(0.0, 0.05 * sign, 0.2)
                axis = vector(*AXES["xyz"[level % 3]])
                parts.append(Part(path + side, parent, REVOLUTE, body, place, axis=axis))
                below.append((path + side, path + side))
        above = below
    return assemble(f"binary{levels}", parts, floating)


HUMAN = (  # name, parent, kind, axis, place in the parent, tip of the link, mass
    ("waist", BASE, SPHERICAL, "z", (0.0, 0.0, 0.12), (0.0, 0.0, 0.4), 24.0),
    ("neck", "waist", SPHERICAL, "z", (0.0, 0.0, 0.45), (0.0, 0.0, 0.25), 5.0),
    *(
        joint
        for s, y in (("left", 1.0), ("right", -1.0))
        for joint in (
            (f"{s}_shoulder", "waist", SPHERICAL, "z", (0, 0.2 * y, 0.4), (0, 0, -0.28), 2.1),
            (f"{s}_elbow", f"{s}_shoulder", REVOLUTE, "y", (0, 0, -0.28), (0, 0, -0.25), 1.3),
            (f"{s}_wrist", f"{s}_elbow", SPHERICAL, "z", (0, 0, -0.25), (0, 0, -0.18), 0.5),
            (f"{s}_hip", BASE, SPHERICAL, "z", (0, 0.09 * y, -0.05), (0, 0, -0.42), 8.5),
            (f"{s}_knee", f"{s}_hip", REVOLUTE, "y", (0, 0, -0.42), (0, 0, -0.42), 3.5),
            (f"{s}_ankle", f"{s}_knee", SPHERICAL, "z", (0, 0, -0.42), (0.22, 0, -0.07), 1.1),
        )
    ),
)


def human_figure() -> Model:
    """Return a human figure of 40 degrees of freedom: 1 free, 10 spherical, 4 revolute joints."""
    parts = [Part(BASE, None, FLOATING, rod(11.0, vector(0.0, 0.0, 0.2), 0.13))]
    for name, parent, kind, axis, place, tip, mass in HUMAN:
        body = rod(mass, vector(*tip), 0.05)
        parts.append(Part(name, parent, kind, body, vector(*place), axis=vector(*AXES[axis])))
    return assemble("human_figure", parts, floating=True)


POINT = Inertia(0.1, np.zeros(3), np.zeros((3, 3)))
"""A point mass on the joint's axes: no inertia about them."""


def three_axis_chain(balls: int, between: Inertia | None = None) -> Model:
    """Return rods on ball joints, each three revolute joints through two links of no inertia."""
    none = Inertia.zero() if between is None else between
    step, parts = vector(0.3, 0.0, 0.0), list[Part]()
    for i in range(balls):
        for k, axis in enumerate("xyz"):
            body = rod(1.0, step) if k == 2 else none
            above = parts[-1].name if parts else None
            place = step if k == 0 and parts else np.zeros(3)
            name = f"b{i:02d}{axis}"
            parts.append(Part(name, above, REVOLUTE, body, place, axis=vector(*AXES[axis])))
    return assemble(f"three_axis{balls}", parts)


BONES = (  # name, parent, length of the bone (m), mass (kg)
    *(("lower_back", "root", 0.1, 9.0), ("upper_back", "lower_back", 0.12, 8.0)),
    *(("thorax", "upper_back", 0.12, 8.0), ("lower_neck", "thorax", 0.08, 1.0)),
    *(("upper_neck", "lower_neck", 0.05, 0.5), ("head", "upper_neck", 0.2, 4.5)),
    *(
        bone
        for side in ("left", "right")
        for bone in (
            (f"{side}_clavicle", "thorax", 0.17, 0.6),
            (f"{side}_humerus", f"{side}_clavicle", 0.28, 2.0),
            (f"{side}_radius", f"{side}_humerus", 0.2, 1.1),
            (f"{side}_thumb", f"{side}_radius", 0.04, 1e-3),
            (f"{side}_femur", "root", 0.42, 8.0),
            (f"{side}_tibia", f"{side}_femur", 0.4, 3.5),
            (f"{side}_toes", f"{side}_tibia", 0.06, 1e-3),
        )
    ),
)


def motion_capture_figure() -> Model:
    """Return a human figure of 66 degrees of freedom as motion capture has it, on a floating base.

    Each of 20 bones turns about three axes, one after the other, through links of 1e-9 kg.
    """
    parts = [Part(BASE, None, FLOATING, rod(11.0, vector(0.0, 0.0, 0.2), 0.13))]
    ends = {"root": (BASE, vector(0.0, 0.0, 0.1))}
    turn = np.random.default_rng(7)
    for name, parent, length, mass in BONES:
        above, place = ends[parent]
        tip = length * _unit(turn.normal(size=3))
        for axis in "zyx":
            body = rod(mass, tip, 0.1 * length) if axis == "x" else rod(1e-9, 0.01 * tip, 1e-4)
            part = Part(f"{name}_{axis}", above, REVOLUTE, body, place, axis=vector(*AXES[axis]))
            parts.append(part)
            above, place = part.name, np.zeros(3)
        ends[name] = (above, tip)
    return assemble("motion_capture_figure", parts, floating=True)


def shrunk(model: Model, mass: float, length: float) -> Model:
    """Return a robot with its masses and lengths times these factors, loops included."""

    def placed(frame: Frame) -> Frame:
        return replace(frame, translation=frame.translation * length)

    links = []
    for link in model.links:
        own = link.inertia
        tensor = own.tensor * mass * length**2
        own = replace(own, mass=own.mass * mass, com=own.com * length, tensor=tensor)
        links.append(replace(link, inertia=own))
    joints = [replace(joint, translation=joint.translation * length) for joint in model.joints]
    loops = [
        replace(loop, frame1=placed(loop.frame1), frame2=placed(loop.frame2))
        for loop in model.loops
    ]
    return replace(model, links=tuple(links), joints=tuple(joints), loops=tuple(loops))


def random_configuration(model: Model, rng: np.random.Generator) -> Array:
    """Return entries of q between -1 and 1, its quaternions of length one."""
    q = rng.uniform(-1, 1, model.nq)
    for joint, start in zip(model.joints, model.q_start, strict=True):
        if joint.kind.quaternion is not None:
            part = slice(start + joint.kind.quaternion, start + joint.kind.nq)
            q[part] /= np.linalg.norm(q[part])
    return q
