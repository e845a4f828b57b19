"""The robots of the stability suite, built directly: chains of rods with one thing wrong."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from adagen.model import REVOLUTE, SPHERICAL, Inertia, Joint, JointKind, Link, Model
from adagen.states import States

Array = NDArray[np.float64]
AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
RADIUS = 0.05


def rod(mass: float = 1.0, length: float = 1.0, radius: float = RADIUS) -> Inertia:
    """Return a solid cylinder from the origin along z; kg, m."""
    across = mass * (3 * radius**2 + length**2) / 12
    tensor = np.diag([across, across, 0.5 * mass * radius**2])
    return Inertia(mass, np.array([0.0, 0.0, length / 2]), tensor)


def chain(
    name: str,
    inertias: Sequence[Inertia],
    *,
    axes: str = "xy",
    kind: JointKind = REVOLUTE,
    lengths: Sequence[float] | None = None,
    base: Sequence[float] = (0.0, 0.0, 0.0),
    turn: Array | None = None,
    gravity: Sequence[float] = (0.0, 0.0, -9.81),
) -> Model:
    """Return links end to end along z on a fixed base.

    Args:
        name: of the robot.
        inertias: of the links, the first one at the base.
        axes: the joints' axes in turn, letters x, y and z.
        kind: of all joints.
        lengths: distance from each link's joint to the next one, m; 1 by default.
        base: where the first joint is, m.
        turn: rotation of each joint's frame in the link before it, shape (3, 3); none by default.
        gravity: m/s^2.
    """
    links, joints = [Link("ground", Inertia.zero())], []
    place = np.array(base, dtype=np.float64)
    for i, inertia in enumerate(inertias):
        axis = np.array(AXES[axes[i % len(axes)]])
        frame = np.eye(3) if turn is None or i == 0 else turn
        joints.append(Joint(f"j{i + 1}", kind, i, frame, place, axis, None))
        links.append(Link(f"link{i + 1}", inertia))
        place = np.array([0.0, 0.0, 1.0 if lengths is None else lengths[i]])
    return Model(name, tuple(links), tuple(joints), gravity=np.array(gravity))


def rods(n: int, *, kind: JointKind = REVOLUTE, radius: float = RADIUS) -> Model:
    """Return n rods of 1 kg and 1 m, axes x and y in turn."""
    return chain(f"rods {n}", [rod(radius=radius)] * n, kind=kind)


def spherical_rods(n: int) -> Model:
    """Return n such rods on ball joints."""
    return rods(n, kind=SPHERICAL)


def with_mass(n: int, link: int, mass: float) -> Model:
    """Return n rods, one of them (counted from 1) of another mass, kg."""
    inertias = [rod(mass if i + 1 == link else 1.0) for i in range(n)]
    return chain(f"rods {n}, link {link} of {mass:g} kg", inertias)


def graded(n: int, ratio: float) -> Model:
    """Return n rods whose masses grow geometrically, ``ratio`` from the base to the tip."""
    masses = ratio ** (np.arange(n) / max(n - 1, 1))
    return chain(f"rods {n}, graded {ratio:g}", [rod(float(m)) for m in masses])


def far_away(n: int, distance: float) -> Model:
    """Return n rods whose base is ``distance`` m from the world's origin."""
    return chain(f"rods {n} at {distance:g} m", [rod()] * n, base=(distance, 0.0, 0.0))


def three_axis(balls: int, massless: Inertia | None = None) -> Model:
    """Return rods on ball joints, each three revolute joints through two massless links."""
    none = Inertia.zero() if massless is None else massless
    inertias = [body for _ in range(balls) for body in (none, none, rod())]
    lengths = [step for _ in range(balls) for step in (0.0, 0.0, 1.0)]
    return chain(f"three axes x {balls}", inertias, axes="xyz", lengths=lengths)


def massless_leaf(n: int) -> Model:
    """Return n rods, the last one without any mass."""
    return chain(f"rods {n}, massless tip", [rod()] * (n - 1) + [Inertia.zero()])


def planar(n: int, tip: float) -> Model:
    """Return n rods that turn about y in one plane without gravity, the last one of ``tip`` kg."""
    inertias = [rod(tip if i + 1 == n else 1.0) for i in range(n)]
    return chain(f"planar {n}", inertias, axes="y", gravity=(0.0, 0.0, 0.0))


def coil(n: int) -> Model:
    """Return n links cut from one rod of 1 kg and 1 m, their axes turning along it like a coil.

    After Featherstone's coil(n) ("An empirical study of the joint-space inertia matrix", 2004);
    here each joint is turned by 40 degrees about the rod.
    """
    c, s = np.cos(np.deg2rad(40.0)), np.sin(np.deg2rad(40.0))
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    links = [rod(1.0 / n, 1.0 / n, 0.01 / n)] * n
    return chain(f"coil {n}", links, axes="x", lengths=[1.0 / n] * n, turn=turn)


def dill(level: int) -> Model:
    """Return 2^level links of sizes over ``level`` scales, small beside large throughout.

    After Featherstone's dill(level) (ibid.): level k + 1 is level k twice, its second half ten
    times smaller; masses go with the cube of the size.
    """
    sizes = [1.0]
    for _ in range(level):
        sizes = [*sizes, *(0.1 * size for size in sizes)]
    links = [rod(size**3, size, RADIUS * size) for size in sizes]
    return chain(f"dill {level}", links, lengths=sizes)


def state(model: Model) -> tuple[Array, Array, Array]:
    """Return the suite's state: q_i = pi sin 1.7i, v_i = cos 2.3i, tau_i = sin 3.1i, i from 1.

    Shapes (nq,), (nv,) and (nv,); SI units.
    The quaternion of joint i is (sin 1.1i, cos 1.3i, sin 1.7i, cos 1.9i), normalised.
    """
    i = np.arange(1, model.nv + 1)
    q = np.zeros(model.nq)
    for j, joint in enumerate(model.joints):
        if joint.kind.quaternion is None:
            q[model.q_start[j]] = np.pi * np.sin(1.7 * (j + 1))
            continue
        four = [np.sin(1.1 * (j + 1)), np.cos(1.3 * (j + 1))]
        four += [np.sin(1.7 * (j + 1)), np.cos(1.9 * (j + 1))]
        q[model.q_start[j] : model.q_start[j] + 4] = np.array(four) / np.linalg.norm(four)
    return q, np.cos(2.3 * i), np.sin(3.1 * i)


def states_with(model: Model, more: States) -> States:
    """Return the suite's state of a robot, and more."""
    pairs = zip(state(model), more.parts, strict=True)
    return States(*map(np.vstack, pairs))


FAMILIES: dict[str, tuple[str, Callable[[float], Model], tuple[float, ...]]] = {
    "length": ("links", lambda n: rods(int(n)), (3, 10, 30, 100, 300)),
    "planar": ("links in a plane", lambda n: planar(int(n), 1.0), (3, 10, 30, 100, 300)),
    "coil": ("links", lambda n: coil(int(n)), (3, 10, 30, 100)),
    "dill": ("level", lambda n: dill(int(n)), (1, 2, 3, 4, 5)),
    "tip": ("mass of the tip (kg)", lambda m: with_mass(30, 30, m), (1, 1e2, 1e4, 1e6, 1e8)),
    "graded": ("mass ratio tip to base", lambda r: graded(30, r), (1e-8, 1e-4, 1, 1e4, 1e8)),
    "light": (
        "mass of link 15 (kg)",
        lambda m: with_mass(30, 15, m),
        (1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10),
    ),
    "slender": ("radius (m)", lambda r: rods(30, radius=r), (0.05, 5e-3, 5e-4, 5e-5)),
    "distance": ("base from the origin (m)", lambda d: far_away(30, d), (1, 1e2, 1e4, 1e6)),
    "spherical": ("ball joints", lambda n: spherical_rods(int(n)), (10, 20, 40, 60, 100)),
}
"""What the maps vary: axis title, robot, values."""
