"""MuJoCo's own accelerations at a state of ours, and MJCF text that says what a Model does."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model import Model

Array = NDArray[np.float64]


def rotation(xyzw: Array) -> Array:
    """The rotation that a unit quaternion stands for."""
    x, y, z, w = xyzw
    k = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + 2 * (w * k + k @ k), dtype=np.float64)


def accelerations(
    theirs: Any, model: Model, names: tuple[str, ...], q: Array, v: Array, tau: Array
) -> Array:
    """MuJoCo's accelerations without passive forces, at a state of ours and in our order.

    Args:
        theirs: an ``MjModel``.
        model: what was read of it.
        names: our name of each of its joints.
        q, v, tau: the state.
    """
    import mujoco

    data = mujoco.MjData(theirs)
    turns: dict[int, Array] = {}
    applied, places = np.zeros(theirs.nv), np.empty(theirs.nv, dtype=int)
    for j, joint in enumerate(model.joints):
        k = names.index(joint.name)
        a, b = int(theirs.jnt_qposadr[k]), int(theirs.jnt_dofadr[k])
        mine = q[model.q_start[j] :][: joint.kind.nq]
        at = model.v_start[j]
        places[at : at + joint.kind.nv] = range(b, b + joint.kind.nv)
        velocity, torque = v[at : at + joint.kind.nv].copy(), tau[at : at + joint.kind.nv].copy()
        if joint.kind.nq >= 4:  # a quaternion at the end, w last
            data.qpos[a : a + joint.kind.nq] = [*mine[:-4], mine[-1], *mine[-4:-1]]
        else:
            data.qpos[a : a + joint.kind.nq] = mine
        if joint.kind.nv == 6:  # theirs is linear in the world's axes
            turns[at] = rotation(mine[-4:])
            velocity[:3], torque[:3] = turns[at] @ velocity[:3], turns[at] @ torque[:3]
        data.qvel[b : b + joint.kind.nv], applied[b : b + joint.kind.nv] = velocity, torque
    mujoco.mj_forward(theirs, data)
    inertia = np.zeros((theirs.nv, theirs.nv))
    for row, unit in zip(inertia, np.eye(theirs.nv), strict=True):
        mujoco.mj_mulM(theirs, data, row, unit)
    result = np.linalg.solve(inertia, applied - data.qfrc_bias)[places]
    for at, turn in turns.items():
        linear, angular = v[at : at + 3], v[at + 3 : at + 6]
        result[at : at + 3] = turn.T @ result[at : at + 3] - np.cross(angular, linear)
    return np.asarray(result, dtype=np.float64)


def numbers(values: Any) -> str:
    return " ".join(repr(float(value)) for value in np.ravel(values))


def mjcf_of(model: Model) -> str:
    """An MJCF of a robot with revolute, prismatic and spherical joints and a base, if it floats."""
    kinds = {"revolute": "hinge", "prismatic": "slide", "spherical": "ball", "floating": "free"}

    def body(j: int) -> str:
        joint, link = model.joints[j], model.links[j + 1]
        axis = f' axis="{numbers(joint.axis)}"' if joint.kind.has_axis else ""
        moved = f'<joint name="{joint.name}" type="{kinds[joint.kind.name]}"{axis}/>'
        t = link.inertia.tensor
        moments = numbers([t[0, 0], t[1, 1], t[2, 2], t[0, 1], t[0, 2], t[1, 2]])
        mass = (
            f'<inertial pos="{numbers(link.inertia.com)}" mass="{link.inertia.mass!r}" '
            f'fullinertia="{moments}"/>'
        )
        axes = numbers(joint.rotation[:, :2].T)
        inner = "".join(body(child) for child in model.children[j + 1])
        return (
            f'<body name="{link.name}" pos="{numbers(joint.translation)}" xyaxes="{axes}">'
            f"{mass}{moved}{inner}</body>\n"
        )

    return (
        f'<mujoco model="{model.name}"><compiler angle="radian" boundinertia="0"/>\n'
        f'<option gravity="{numbers(model.gravity)}"/><worldbody>\n'
        f"{''.join(body(j) for j in model.children[0])}</worldbody></mujoco>\n"
    )
