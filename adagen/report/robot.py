"""The robot of a report: links, joints and loops as plain data, and a pose with closed loops."""

from __future__ import annotations

import math
from collections.abc import Mapping
from math import fsum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.exact import rotation_taking_z_to, rounded
from adagen.model import Joint, Model
from adagen.model.loops import Loop
from adagen.reference.closed import closed_states, closest, constraints
from adagen.states import resting_states
from adagen.states.types import columns

Array = NDArray[np.float64]
OPEN = 1e-6
"""m or rad; loops that are open by less look closed."""


def robot(model: Model, owner: Mapping[str, int]) -> dict[str, Any]:
    """Return a robot as the page draws it.

    Args:
        model: the robot.
        owner: the process that computes the acceleration of each joint, by name.
    """
    return {
        "name": model.name,
        "floating": model.floating,
        "gravity": model.gravity.tolist(),
        "nv": model.nv,
        "mass": fsum(link.inertia.mass for link in model.links[1:]),
        "links": [
            {
                "name": link.name,
                "mass": link.inertia.mass,
                "com": link.inertia.com.tolist(),
                "fixed": [
                    {"name": frame.name, "at": frame.translation.tolist()} for frame in link.frames
                ],
            }
            for link in model.links
        ],
        "joints": [_joint(joint, owner[joint.name]) for joint in model.joints],
        "loops": [_loop(loop) for loop in model.loops],
        "rest": _rest(model),
    }


def _loop(loop: Loop) -> dict[str, Any]:
    return {
        "name": loop.name,
        "kind": loop.kind.name,
        "held": list(loop.kind.linear),
        "rotation": loop.frame1.rotation.tolist(),
        "ends": [{"link": link, "at": frame.translation.tolist()} for link, frame in loop.ends],
    }


def _joint(joint: Joint, owner: int) -> dict[str, Any]:
    mimic, across = joint.mimic, None
    if joint.kind.name == "planar":  # the directions in which it shifts
        across = rounded(rotation_taking_z_to(joint.axis))[:, :2].T.tolist()
    return {
        "name": joint.name,
        "kind": joint.kind.name,
        "parent": joint.parent,
        "rotation": joint.rotation.tolist(),
        "translation": joint.translation.tolist(),
        "axis": joint.axis.tolist(),
        "across": across,
        "owner": owner,
        "mimic": None if mimic is None else [mimic.source, mimic.multiplier, mimic.offset],
    }


def _rest(model: Model) -> list[list[float]]:
    """Return q of each joint as the page begins: all zero, or as near to it as loops close.

    Quaternions are given as rotation vectors, which sliders can move.
    """
    q = resting_states(model, 1).q
    if model.closed:
        near = closest(model, q)
        found, _ = closed_states(model, 1) if _open(model, near) else (near, None)
        q = found if len(found) else near
    described = []
    for j, joint in enumerate(model.joints):
        own = q[0, columns(model, j, "q")].tolist()
        if joint.kind.quaternion is not None:
            own = [*own[: joint.kind.quaternion], *_rotation_vector(own[joint.kind.quaternion :])]
        described.append(own)
    return described


def _open(model: Model, q: Array) -> bool:
    return bool(np.abs(constraints(model, q[0]).gaps).max(initial=0.0) > OPEN)


def _rotation_vector(xyzw: list[float]) -> list[float]:
    x, y, z, w = np.array(xyzw) / np.linalg.norm(xyzw) * math.copysign(1.0, xyzw[3])
    size = math.hypot(x, y, z)
    factor = 2.0 if size == 0.0 else 2.0 * math.atan2(size, w) / size
    return [float(factor * part) for part in (x, y, z)]
