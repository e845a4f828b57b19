"""Small robots that are hard to solve: what loses digits, at random and to the extreme.

Each family varies one thing over many orders of magnitude that methods are known to fail on: what a
link's inertia about its axis is beside all else, how near axes are to each other, how light a link
is that others hang on.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from adagen.model import (
    FLOATING,
    PLANAR,
    PRISMATIC,
    REVOLUTE,
    SPHERICAL,
    Inertia,
    Joint,
    JointKind,
    Link,
    Model,
)
from adagen.studies.stability.robots import rod

Array = NDArray[np.float64]
UNIT = np.eye(3)


@dataclass(frozen=True)
class Part:
    """A link and the joint that it hangs by.

    Attributes:
        parent: number of the link that it hangs on, 0 for the ground.
        axis: of the joint, shape (3,).
        place: of the joint in the parent's frame, shape (3,), m.
        inertia: of the link.
        kind: of the joint.
        turn: of the joint's frame in the parent's, shape (3, 3).
    """

    parent: int
    axis: Array
    place: Array
    inertia: Inertia
    kind: JointKind = REVOLUTE
    turn: Array | None = None


def assembled(name: str, parts: list[Part]) -> Model:
    """Return the robot of parts in depth-first order."""
    links, joints = [Link("ground", Inertia.zero())], []
    for i, part in enumerate(parts):
        turn = UNIT if part.turn is None else part.turn
        joints.append(Joint(f"j{i}", part.kind, part.parent, turn, part.place, part.axis, None))
        links.append(Link(f"link{i}", part.inertia))
    return Model(name, tuple(links), tuple(joints), floating=parts[0].kind is FLOATING)


def between(rng: Generator, least: float, most: float) -> float:
    """Return a number between two powers of ten, its exponent uniformly distributed."""
    return float(10.0 ** rng.uniform(least, most))


def _length(rng: Generator, i: int) -> Array:
    return np.array([0.0, 0.0, rng.uniform(0.2, 1.0) if i else 0.0])


def _axis(rng: Generator) -> Array:
    axis: Array = UNIT[rng.integers(3)]
    return axis


def _chain(name: str, rng: Generator, inertias: list[Inertia], **options: object) -> Model:
    parts = [
        Part(i, _axis(rng), _length(rng, i), own, **options)  # type: ignore[arg-type]
        for i, own in enumerate(inertias)
    ]
    return assembled(name, parts)


def _rods(rng: Generator, least: int = 3, most: int = 8) -> list[Inertia]:
    return [rod(length=rng.uniform(0.2, 1.0)) for _ in range(rng.integers(least, most + 1))]


def _point(rng: Generator, mass: float, off: float) -> Inertia:
    return Inertia(mass, off * rng.normal(size=3), np.zeros((3, 3)))


def slender_tools(rng: Generator) -> Model:
    """Rods, the last of which is thin: its D is a small part of the inertia at the joint."""
    links = _rods(rng)
    links[-1] = rod(radius=between(rng, -7, -1))
    return _chain("slender tool", rng, links)


def wrists(rng: Generator) -> Model:
    """Rods on three axes through links of little or no inertia: gimbal lock."""
    parts: list[Part] = []
    for ball in range(rng.integers(1, 4)):
        first = int(rng.integers(3))
        axes = [first, (first + 1) % 3, first if rng.random() < 0.3 else (first + 2) % 3]
        for k, axis in enumerate(axes):
            size = between(rng, -4, -1)
            mass = between(rng, -8, 0)
            light = (
                Inertia.zero(),
                _point(rng, mass, 0.0),
                Inertia(mass, np.zeros(3), mass * size**2 * UNIT),
            )[rng.integers(3)]
            place = _length(rng, ball) if k == 0 else np.zeros(3)
            parts.append(Part(len(parts), UNIT[axis], place, rod() if k == 2 else light))
    return assembled("wrists", parts)


def coaxial(rng: Generator) -> Model:
    """Axes that nearly coincide: a little off, or a little tilted."""
    parts: list[Part] = []
    for i, own in enumerate(_rods(rng, 3, 6)):
        off = between(rng, -9, -1) * rng.normal(size=3) if i else np.zeros(3)
        tilt = UNIT[2] + between(rng, -9, -1) * rng.normal(size=3)
        parts.append(Part(i, tilt / np.linalg.norm(tilt), off, own))
    return assembled("coaxial axes", parts)


def light_links(rng: Generator) -> Model:
    """Rods of masses many orders of magnitude apart."""
    return _chain("light links", rng, [rod(between(rng, -8, 2)) for _ in _rods(rng)])


def point_masses(rng: Generator) -> Model:
    """Point masses off and on their joints' axes, and a rod at the end."""
    links = [_point(rng, between(rng, -3, 1), rng.choice([0.0, 0.1, 1.0])) for _ in _rods(rng)]
    return _chain("point masses", rng, [*links, rod()])


def tiny_roots(rng: Generator) -> Model:
    """A floating base that is light beside what it carries."""
    mass = between(rng, -8, 0)
    base = Part(0, UNIT[2], np.zeros(3), rod(mass, 0.1, 0.1), FLOATING)
    parts = [base]
    for _ in range(rng.integers(1, 4)):
        parent = 1
        for k in range(rng.integers(1, 4)):
            parts.append(Part(parent, _axis(rng), _length(rng, k + 1), rod()))
            parent = len(parts)
    return assembled("tiny root", parts)


def graded(rng: Generator) -> Model:
    """Masses that grow or shrink geometrically."""
    count = int(rng.integers(5, 12))
    ratio = between(rng, 0, 10) ** rng.choice([-1.0, 1.0])
    return _chain("graded", rng, [rod(float(ratio ** (i / count))) for i in range(count)])


def trees(rng: Generator) -> Model:
    """A branching robot some links of which are light, thin or points."""
    parts: list[Part] = []
    path = [0]
    for _ in range(rng.integers(6, 14)):
        while len(path) > 1 and rng.random() < 0.3:
            path.pop()
        choice = rng.integers(4)
        own = (
            rod(),
            rod(between(rng, -6, 0)),
            rod(radius=between(rng, -6, -1)),
            _point(rng, 0.3, 0.1),
        )[choice]
        parts.append(Part(path[-1], _axis(rng), _length(rng, path[-1]), own))
        path.append(len(parts))
    return assembled("tree", parts)


def arms(rng: Generator) -> Model:
    """Long arms with a few branches: light, slender and ordinary links, sliders among hinges."""
    parts: list[Part] = []
    path = [0]  # from the ground to where the next link hangs
    for k in range(rng.integers(11, 17)):
        own = (
            *(rod(between(rng, -4, 1)), rod(radius=between(rng, -6, -1))),
            *(_point(rng, 0.3, 0.1), rod(), rod()),
        )[rng.integers(5)]
        kind = PRISMATIC if rng.random() < 0.15 else REVOLUTE
        if len(path) > 2 and rng.random() < 0.1:
            path.pop()
        parts.append(Part(path[-1], _axis(rng), _length(rng, k), own, kind))
        path.append(k + 1)
    return assembled("arm", parts)


def long_chains(rng: Generator) -> Model:
    """Long chains of hinges: graded, or of light, slender and ordinary links by turns."""
    count, ratio = int(rng.integers(24, 60)), between(rng, -4, 4)
    kind = rng.integers(3)
    parts: list[Part] = []
    for k in range(count):
        grade = float(ratio ** (k / count))
        own = (
            rod(grade),
            (rod(), rod(between(rng, -3, 0)), rod(radius=between(rng, -5, -1)))[rng.integers(3)],
            rod(),
        )[kind]
        tilt = _axis(rng) + between(rng, -9, 0) * rng.normal(size=3)
        parts.append(Part(k, tilt / np.linalg.norm(tilt), _length(rng, k), own))
    return assembled("long chain", parts)


def slides(rng: Generator) -> Model:
    """Hinges and slides by turns, along nearly the same axes."""
    parts: list[Part] = []
    for i, own in enumerate(_rods(rng, 4, 8)):
        kind = PRISMATIC if rng.random() < 0.4 else REVOLUTE
        tilt = _axis(rng) + between(rng, -9, 0) * rng.normal(size=3)
        light = rod(between(rng, -6, 0)) if rng.random() < 0.4 else own
        parts.append(Part(i, tilt / np.linalg.norm(tilt), _length(rng, i), light, kind))
    parts[-1] = Part(parts[-1].parent, UNIT[0], parts[-1].place, rod())
    return assembled("slides", parts)


def balls(rng: Generator) -> Model:
    """Ball joints with slender links of unequal masses."""
    count = int(rng.integers(2, 7))
    links = [rod(between(rng, -4, 2), radius=between(rng, -5, -1)) for _ in range(count)]
    return _chain("balls", rng, links, kind=SPHERICAL)


def far_centres(rng: Generator) -> Model:
    """Links whose mass is far from their joints."""
    far = between(rng, 0, 4)
    links = [Inertia(1.0, far * rng.normal(size=3), 0.01 * UNIT) for _ in _rods(rng)]
    return _chain("far centres", rng, links)


def free_bodies(rng: Generator) -> Model:
    """Planar and floating joints beyond hinges, with light links."""
    kinds = (REVOLUTE, PLANAR, FLOATING, REVOLUTE)
    parts = [
        Part(i, _axis(rng), _length(rng, i), rod(between(rng, -5, 1)), kind)
        for i, kind in enumerate(kinds)
    ]
    return assembled("free bodies", parts)


Family = Callable[[Generator], Model]
FAMILIES: tuple[Family, ...] = (
    slender_tools,
    wrists,
    coaxial,
    light_links,
    point_masses,
    tiny_roots,
    graded,
    trees,
    slides,
    balls,
    far_centres,
    free_bodies,
)


def robots(count: int, seed: int = 0, families: Sequence[Family] = FAMILIES) -> list[Model]:
    """Return a number of robots of the families in turn; the same seed gives the same robots."""
    found = []
    for k in range(count):
        rng = np.random.default_rng((seed, k))
        found.append(families[k % len(families)](rng))
    return found
