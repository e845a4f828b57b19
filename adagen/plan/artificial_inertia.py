"""Artificial inertia for motions of the tree that only closed loops resist (form `ada`).

Form `ada` solves the tree before its loops, so every motion of the tree needs inertia. Where a
motion has none (the pin of a massless coupler, a massless root link on one pin), one of its joints
gets an artificial inertia K, as a rotor would have. One more right-hand side subtracts its torque,
K times the acceleration, again (adagen/executor/loop_constraints.py), so the answer is that of the
robot itself.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import lru_cache

import numpy as np

from adagen.errors import UsageError, printable
from adagen.model import Joint, Model
from adagen.plan.closures import closures_of, sampled
from adagen.plan.robot import PlanJoint
from adagen.reference.double import joint_space_inertia
from adagen.urdf.mobility import weakest


@lru_cache(maxsize=4)  # asked for by every plan that a search tries
def with_artificial_inertia(model: Model) -> Model:
    """Return a robot as form `ada` sees its tree, with artificial rotor inertias.

    Raises:
        InputError: no form can solve its loops.
        UsageError: nothing can be lent to a motion that only loops resist; its joint is named.
    """
    if not model.closed:
        return model
    closures_of(model)  # what no form can solve is refused first
    seen, lent = model, set[int]()
    while (weak := weakest(seen)).singular:
        able = [j for j in weak.moving if j not in lent and _can_be_lent(model.joints[j])]
        if not able:
            _refuse(model, weak.joint)
        lent.add(able[0])
        seen = _lending(model, lent)
    return seen


def with_artificial_rotors(joints: Iterable[PlanJoint], model: Model) -> tuple[PlanJoint, ...]:
    """Return a robot's joints with their artificial inertias."""
    pairs = zip(model.joints, with_artificial_inertia(model).joints, strict=True)
    lent = (seen.passive.rotor_inertia - own.passive.rotor_inertia for own, seen in pairs)
    return tuple(replace(joint, lent=k) for joint, k in zip(joints, lent, strict=True))


def _can_be_lent(joint: Joint) -> bool:
    """Whether a joint has one unit, and no rotor with which the sum would be inexact."""
    units = {row < 3 for row in joint.kind.free}
    return len(units) == 1 and not joint.prescribed and not joint.passive.rotor_inertia


def _lending(model: Model, lent: Iterable[int]) -> Model:
    """The robot with artificial inertias of some joints, of the size of others with their unit."""
    inertias = np.diag(joint_space_inertia(model, sampled(model)[0][0]))
    linear = np.array([row >= 3 for joint in model.joints for row in joint.kind.free])
    joints = list(model.joints)
    for j in lent:
        alike = inertias[(linear == (joints[j].kind.free[0] >= 3)) & (inertias > 0.0)]
        size = 2.0 ** round(float(np.log2(np.median(alike)))) if len(alike) else 1.0
        passive = replace(joints[j].passive, rotor_inertia=size)
        joints[j] = replace(joints[j], passive=passive)
    return replace(model, joints=tuple(joints))


def _refuse(model: Model, j: int) -> None:
    link = printable(model.links[j + 1].name)
    raise UsageError(
        f"form ada solves the tree before its loops, and joint {printable(model.joints[j].name)} "
        f"(link {link}) moves no inertia there: only loops resist; use --form segment"
    )
