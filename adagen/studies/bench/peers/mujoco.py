"""MuJoCo's smooth forward dynamics of the same robot, built body by body."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path

import mujoco
import numpy as np
from numpy.typing import NDArray

from adagen.errors import EnvironmentFault
from adagen.model import Joint, Model
from adagen.states import States
from adagen.studies.bench.contest import Contestant
from adagen.studies.bench.machine import package
from adagen.studies.bench.program import NATIVE, Coordinates, Peer, build, compilers, source

Array = NDArray[np.float64]


def contestants(model: Model, states: States, folder: Path) -> Sequence[Contestant]:
    """Return MuJoCo's contestant for a robot.

    Raises:
        EnvironmentFault: MuJoCo refuses the robot, or the program cannot be built.
    """
    compiler = compilers()[0]
    file, given = folder / "mujoco.mjb", folder / "mujoco.states"
    try:
        mujoco.mj_saveModel(_spec(model).compile(), str(file))
    except (ValueError, mujoco.FatalError) as error:
        reason = " ".join(str(error).split())
        raise EnvironmentFault(f"MuJoCo refuses this robot: {reason}") from None
    coordinates(model, states).write(given)
    loop = f"its library as shipped; the loop {compiler} {' '.join(NATIVE)}"
    program = Peer(_build(compiler), (str(file),))
    own = partial(coordinates, model), partial(_from_mujoco, model)
    return [program.contestant("mujoco smooth", loop, given, *own)]


def _build(compiler: str) -> Path:
    folder = Path(mujoco.__file__).parent
    libraries = sorted(folder.glob("libmujoco.so*")) + sorted(folder.glob("libmujoco*.dylib"))
    if not libraries:
        raise EnvironmentFault("mujoco is installed without its library")
    words = (str(libraries[0]), f"-Wl,-rpath,{folder}")
    text = f"// mujoco {package('mujoco')}\n{source('mujoco.cpp')}"
    return build(text, "bench_mujoco", compiler, NATIVE, (folder / "include",), words)


def _spec(model: Model) -> mujoco.MjSpec:
    """Return the robot as MuJoCo's specification: bodies, inertias and joints, nothing else."""
    spec = mujoco.MjSpec()
    spec.option.gravity = model.gravity
    spec.compiler.degree = False
    spec.compiler.balanceinertia = False
    bodies = [spec.worldbody]
    for joint, link in zip(model.joints, model.links[1:], strict=True):
        body = bodies[joint.parent].add_body(name=f"b{len(bodies)}", pos=joint.translation)
        quaternion = np.zeros(4)
        mujoco.mju_mat2Quat(quaternion, joint.rotation.ravel())
        body.quat = quaternion
        body.explicitinertial = True
        body.mass, body.ipos = link.inertia.mass, link.inertia.com
        t = link.inertia.tensor
        body.fullinertia = [t[0, 0], t[1, 1], t[2, 2], t[0, 1], t[0, 2], t[1, 2]]
        for kind, axis in _parts(joint):
            body.add_joint(name=f"j{len(bodies)}_{kind.name}_{axis}", type=kind, axis=axis)
        bodies.append(body)
    return spec


def _parts(joint: Joint) -> list[tuple[mujoco.mjtJoint, tuple[int, int, int]]]:
    """Return MuJoCo's joints that make one of ours, outermost first, with their axes."""
    kinds = mujoco.mjtJoint
    x, y, z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
    slides = [(kinds.mjJNT_SLIDE, axis) for axis in (x, y, z)]
    return {
        "revolute": [(kinds.mjJNT_HINGE, z)],
        "prismatic": [(kinds.mjJNT_SLIDE, z)],
        "spherical": [(kinds.mjJNT_BALL, z)],
        "planar": [*slides[:2], (kinds.mjJNT_HINGE, z)],
        # Its free joint has a place under the world alone; this is the same to the digit.
        "floating": [(kinds.mjJNT_FREE, z)]
        if _is_free(joint)
        else [*slides, (kinds.mjJNT_BALL, z)],
    }[joint.kind.name]


def _is_free(joint: Joint) -> bool:
    """Whether a floating joint stands in the world's own frame, as MuJoCo's free joint does."""
    at_home = np.array_equal(joint.rotation, np.eye(3)) and not joint.translation.any()
    return joint.parent == 0 and at_home


def _turns(model: Model, states: States) -> list[tuple[int, int, Array]]:
    """Return where linear velocities are given in another frame, and the rotations between.

    Each: index of joint, width of the linear part, rotations of the child frame in the joint's
    frame, shape (S, width, width). MuJoCo has them along the joint's axes, adagen the child's.
    """
    found = []
    for j, joint in enumerate(model.joints):
        q = states.q[:, model.q_start[j] : model.q_start[j] + joint.kind.nq]
        if joint.kind.name == "floating":
            found.append((j, 3, np.array([_rotation(p) for p in q[:, 3:]])))
        elif joint.kind.name == "planar":
            c, s = np.cos(q[:, 2]), np.sin(q[:, 2])
            found.append((j, 2, np.moveaxis(np.array([[c, -s], [s, c]]), 2, 0)))
    return found


def _rotation(quaternion: Array) -> Array:
    x, y, z, w = quaternion / np.linalg.norm(quaternion)
    found = np.zeros(9)
    mujoco.mju_quat2Mat(found, np.array([w, x, y, z]))
    return found.reshape(3, 3)


def coordinates(model: Model, states: States) -> Coordinates:
    """Return states as MuJoCo has them: quaternions wxyz, linear velocities along joint axes."""
    q, v, tau = states.q.copy(), states.v.copy(), states.tau.copy()
    for j, joint in enumerate(model.joints):
        if joint.kind.quaternion is not None:
            at = model.q_start[j] + joint.kind.quaternion
            q[:, at : at + 4] = states.q[:, [at + 3, at, at + 1, at + 2]]
    for j, width, turns in _turns(model, states):
        own = slice(model.v_start[j], model.v_start[j] + width)
        for given, turned in ((states.v, v), (states.tau, tau)):
            turned[:, own] = np.einsum("sij,sj->si", turns, given[:, own])
    return Coordinates(q, v, tau)


def _from_mujoco(model: Model, states: States, qdd: Array) -> Array:
    """Return MuJoCo's accelerations as adagen tells them: d/dt (R v) = R (dv/dt + w x v)."""
    found = qdd.copy()
    for j, width, turns in _turns(model, states):
        start = model.v_start[j]
        own = slice(start, start + width)
        found[:, own] = np.einsum("sji,sj->si", turns, qdd[:, own])
        v = states.v[:, own]
        if width == 3:
            found[:, own] -= np.cross(states.v[:, start + 3 : start + 6], v)
        else:
            w = states.v[:, start + 2 : start + 3]
            found[:, own] -= w * np.column_stack((-v[:, 1], v[:, 0]))
    return found
