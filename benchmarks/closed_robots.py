"""Mechanisms with closed loops that benchmarks time."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from adagen.library import read
from adagen.model import Frame, LoopEnd, Model, NamedLoop, closed
from adagen.reference.closed import pose_of
from benchmarks.page import MODELS
from benchmarks.paper import robots
from benchmarks.real_robots import file_of

G1_FEET = ("left_ankle_roll_link", "right_ankle_roll_link")
LEGS = 6
Array = NDArray[np.float64]


def pose_with(model: Model, angles: Mapping[str, float], bent: float = 0.0) -> Array:
    """Return a configuration with the base at the origin, shape (nq,).

    Args:
        model: the robot.
        angles: of joints whose names hold a key, rad.
        bent: of all others.
    """
    pose = np.full(model.nq, bent)
    for start, joint in zip(model.q_start, model.joints, strict=True):
        if joint.kind.quaternion is not None:
            pose[start : start + joint.kind.nq] = 0.0
            pose[start + joint.kind.nq - 1] = 1.0
        for word, angle in angles.items():
            if word in joint.name:
                pose[start] = angle
    return pose


def _held(model: Model, *feet: str, kind: str, pose: Array) -> Model:
    """Return a robot whose links or frames the ground holds where they are in a pose."""
    links: dict[str, tuple[int, Frame | None]]
    links = {link.name: (k, None) for k, link in enumerate(model.links)}
    links.update({f.name: (k, f) for k, link in enumerate(model.links) for f in link.frames})
    loops = []
    for foot in feet:
        number, frame = links[foot]
        turn, place = pose_of(model, pose, number)
        if frame is not None:
            place = place + turn @ frame.translation
        x, y, z = (float(value) for value in place)
        ends = LoopEnd(foot), LoopEnd("__world__", (x, y, z))
        loops.append(NamedLoop(foot, kind, *ends))
    return closed(model, loops, (), links.__getitem__, dict[str, int]().__getitem__)


def _standing(name: str, *feet: str, kind: str) -> Model:
    model = read(file_of(name), floating=True).model
    return _held(model, *feet, kind=kind, pose=pose_with(model, {}))


def on_springs() -> tuple[Model, Array]:
    """Return g1 on both feet with its knees bent, on springs that keep it up, and this pose."""
    model = read(file_of("g1"), floating=True).model
    pose = pose_with(model, {"hip_pitch": -0.3, "knee": 0.6, "ankle_pitch": -0.3})
    joints = list(model.joints)
    for j, (start, joint) in enumerate(zip(model.q_start, joints, strict=True)):
        if joint.kind.nv == 1:
            leg = any(word in joint.name for word in ("hip", "knee", "ankle"))
            spring = replace(
                joint.passive, stiffness=600.0 if leg else 50.0, rest=float(pose[start])
            )
            joints[j] = replace(joint, passive=spring)
    return _held(replace(model, joints=tuple(joints)), *G1_FEET, kind="weld", pose=pose), pose


def _of_example(name: str) -> Model:
    return read(MODELS / f"{name}.urdf", scene=MODELS / f"{name}.toml").model


def _pinned_chain(joints: int) -> Model:
    """Return a chain that is bent, with its last link pinned to the ground."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "chain.urdf")
        path.write_text(robots.chain(joints), encoding="utf-8")
        model = read(path).model
    return _held(model, model.links[-1].name, kind="point", pose=pose_with(model, {}, 0.1))


def _body(name: str, mass: float, z: float, across: float, along: float) -> str:
    return (
        f'<link name="{name}"><inertial><origin xyz="0 0 {z}"/><mass value="{mass}"/>'
        f'<inertia ixx="{across}" iyy="{across}" izz="{along}" ixy="0" ixz="0" iyz="0"/>'
        "</inertial></link>"
    )


def _joint(name: str, kind: str, parent: str, child: str, axis: str, place: str) -> str:
    limit = '<limit lower="-1" upper="1" effort="100" velocity="10"/>'
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{place}"/><axis xyz="{axis}"/>{limit}</joint>'
    )


def _stewart() -> Model:
    """Return a platform 1 m above six legs: crossed hinges, a slide, and a ball at the platform."""
    parts = ['<link name="base"/>', _body("platform", 6.0, 0.0, 0.3, 0.6)]
    parts.append(
        '<joint name="platform" type="floating"><parent link="base"/><child link="platform"/>'
        '<origin xyz="0 0 1"/></joint>'
    )
    loops = []
    for leg in range(LEGS):
        low, high = np.pi / 3 * leg, np.pi / 3 * leg + (0.6 if leg % 2 else -0.6)
        foot = f"{np.cos(low):.6f} {np.sin(low):.6f} 0"
        pin = f"[{0.5 * np.cos(high):.6f}, {0.5 * np.sin(high):.6f}, 0.0]"
        parts += [
            _body(f"cross{leg}", 0.1, 0.0, 1e-4, 1e-4),
            _body(f"cylinder{leg}", 1.0, 0.2, 0.02, 1e-3),
            _body(f"rod{leg}", 0.6, -0.2, 0.01, 5e-4),
            _joint(f"first{leg}", "revolute", "base", f"cross{leg}", "1 0 0", foot),
            _joint(f"second{leg}", "revolute", f"cross{leg}", f"cylinder{leg}", "0 1 0", "0 0 0"),
            _joint(f"slide{leg}", "prismatic", f"cylinder{leg}", f"rod{leg}", "0 0 1", "0 0 1"),
        ]
        loops.append(
            f'[[loops]]\nname = "ball{leg}"\nkind = "point"\nlink1 = "rod{leg}"\n'
            f'link2 = "platform"\norigin2 = {{ xyz = {pin} }}\n'
        )
    with tempfile.TemporaryDirectory() as folder:
        path, scene = Path(folder, "stewart.urdf"), Path(folder, "stewart.toml")
        path.write_text(f'<robot name="stewart">{"".join(parts)}</robot>', encoding="utf-8")
        scene.write_text("\n".join(loops), encoding="utf-8")
        return read(path, scene=scene).model


def of_file(path: Path) -> Model:
    """Return a mechanism of a file, closed by a scene or frame pairs of its name beside it."""
    scenes = [path.with_suffix(".toml"), path.with_suffix(".scene.toml")]
    scene = next((s for s in scenes if s.exists()), None)
    pairs = path.with_suffix(".yaml") if scene is None else None
    return read(path, scene=scene, loops=pairs if pairs and pairs.exists() else None).model


MECHANISMS: dict[str, Callable[[], Model]] = {
    "four-bar": lambda: _of_example("fourbar"),
    "leg with a parallel ankle": lambda: _of_example("ankle"),
    "Stewart platform": _stewart,
    "g1 on both feet": lambda: _standing("g1", *G1_FEET, kind="weld"),
    "a1 on four point feet": lambda: _standing(
        "a1", "FL_foot", "FR_foot", "RL_foot", "RR_foot", kind="point"
    ),
    "talos on both feet": lambda: _standing(
        "talos_reduced", "leg_left_6_link", "leg_right_6_link", kind="weld"
    ),
    "chain of 50 pinned at both ends": lambda: _pinned_chain(50),
}
