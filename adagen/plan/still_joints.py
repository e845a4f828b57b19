"""Joints that closed loops let move in no configuration."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from adagen.errors import InputError
from adagen.model import FLOATING, Model
from adagen.plan.closures import sampled
from adagen.plan.loop_checks import rank
from adagen.urdf.notes import quoted

_SLOW = 1e-9
"""Beside motions of one, in rad/s and m/s, a joint that moves less than this does not move."""


@lru_cache(maxsize=4)  # a robot is refused by it, or warned of, each in its place
def still_joints(model: Model) -> tuple[int, ...]:
    """Return the joints that closed loops let move in no configuration, ascending.

    Raises:
        InputError: loops cannot be closed.
    """
    if not model.closed:
        return ()
    columns = [
        range(a, a + joint.kind.nv) for a, joint in zip(model.v_start, model.joints, strict=True)
    ]
    left = tuple(range(len(model.joints)))
    for rows in sampled(model)[1]:
        if not left:
            break
        free = np.linalg.svd(rows)[2][rank(rows) :]
        speeds = np.abs(free).max(axis=0, initial=0.0)
        left = tuple(j for j in left if not speeds[columns[j]].max() > _SLOW)
    return left


def check_motion(model: Model) -> None:
    """Refuse a robot in which closed loops leave no joint any motion.

    Its accelerations are zero, and a solver would give rounding alone.

    Raises:
        InputError: they leave none; or they cannot be closed.
    """
    if not model.closed or len(still_joints(model)) < len(model.joints):
        return
    names = quoted([*(loop.name for loop in model.loops), *(c.name for c in model.couplings)])
    raise InputError(
        f"nothing to solve: closed loops ({names}) leave no joint any motion, all accelerations "
        f"are zero; correct the loops, {_base_too(model)}or ask for their forces (--loop-forces)"
    )


def still_in_words(model: Model) -> str:
    """Return what is to be said of joints that closed loops let move in no configuration.

    Empty where all can move, or none: what is asked for are the loops' forces, then.
    """
    still = still_joints(model)
    if not still or len(still) == len(model.joints):
        return ""
    names = quoted([model.joints[j].name for j in still])
    return (
        f"closed loops leave {f'joints {names}' if len(still) > 1 else f'joint {names}'} no motion:"
        f" accelerations there are zero but for rounding; correct the loops, {_base_too(model)}"
        "or lock what is not to move"
    )


def _base_too(model: Model) -> str:
    """What may be missing where a robot stands on its feet."""
    floats = any(joint.kind is FLOATING for joint in model.joints)
    return "" if floats else "put the robot on a floating base (--floating), "
