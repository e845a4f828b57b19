"""A robot as plain data, and states of it to fill in."""

from __future__ import annotations

from math import fsum
from typing import Any

import numpy as np

from adagen.errors import InputError
from adagen.model import Model
from adagen.plan.loop_checks import why_open
from adagen.reference.closed import closed_states
from adagen.states import States, resting_states


def robot_data(model: Model) -> dict[str, Any]:
    """Return a model as plain data: joints in order, indices in q and v, masses (kg, m)."""
    return {
        "name": model.name,
        "floating": model.floating,
        "gravity": model.gravity.tolist(),
        "nq": model.nq,
        "nv": model.nv,
        "mass": fsum(link.inertia.mass for link in model.links[1:]),
        "joints": [_joint_data(model, j) for j in range(len(model.joints))],
        "forces": [wrench.frame.name for wrench in model.wrenches],
        "loops": [
            {
                "name": loop.name,
                "kind": loop.kind.name,
                "links": [model.links[link].name for link, _ in loop.ends],
                "frames": [frame.name for _, frame in loop.ends],
                "tolerance": loop.tolerance,
            }
            for loop in model.loops
        ],
        "couplings": [
            {
                "name": coupling.name,
                "terms": {model.joints[j].name: factor for j, factor in coupling.terms},
                "offset": coupling.offset,
                "tolerance": coupling.tolerance,
            }
            for coupling in model.couplings
        ],
    }


def _joint_data(model: Model, j: int) -> dict[str, Any]:
    joint, child = model.joints[j], model.links[j + 1]
    follows = None
    if joint.mimic is not None:
        source = model.joints[joint.mimic.source].name
        follows = {
            "joint": source,
            "multiplier": joint.mimic.multiplier,
            "offset": joint.mimic.offset,
        }
    return {
        "name": joint.name,
        "kind": joint.kind.name,
        "parent": model.links[joint.parent].name,
        "child": child.name,
        "q": [model.q_start[j], joint.kind.nq],
        "v": [model.v_start[j], joint.kind.nv],
        "axis": joint.axis.tolist() if joint.kind.has_axis else None,
        "mimic": follows,
        "prescribed": joint.prescribed,
        "mass": child.inertia.mass,
        "com": child.inertia.com.tolist(),
        "fixed_to_it": list(child.merged),
    }


def states_to_fill_in(model: Model, count: int) -> States:
    """Return states at rest, without torques; closed where the robot has loops.

    Raises:
        InputError: the loops cannot be closed.
    """
    if not model.closed:
        return resting_states(model, count)
    q, _ = closed_states(model, count)
    if not len(q):
        raise InputError(why_open(model))
    return States(
        np.resize(q, (count, model.nq)), np.zeros((count, model.nv)), np.zeros((count, model.ntau))
    )
