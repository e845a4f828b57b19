"""The frame that a join is done in, in numpy: a joint's own, or a run's."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import KINDS
from adagen.plan.fused_frame import joint_coordinates, run_motion
from adagen.plan.steps import FusedJoin, Join
from adagen.plan.types import PlanJoint

if TYPE_CHECKING:
    from adagen.plan.interpret import Machine

Array = NDArray[np.float64]

GIMBAL_LOCK = 1e-7
"""Fused joints this near to gimbal lock (``joint_coordinates``) are not joined."""


@dataclass(frozen=True)
class JointFrame:
    """Coordinates in which the motions of a joint, or of a run of joints, are unit vectors.

    Attributes:
        run: the joints.
        x: from the frame of the parent link, shape (6, 6).
        y: from the frame of the child link, shape (6, 6).
        free: the rows along the motions; n of them.
        constrained: the other rows.
        c: acceleration across the joint that qdd has no say in, shape (6, columns).
        tau: torques along the motions, shape (n, columns).
        give: mobility of the joint itself, where it gives way other than along its motions, (6, 6).
    """

    run: tuple[int, ...]
    x: Array
    y: Array
    free: list[int]
    constrained: list[int]
    c: Array
    tau: Array
    give: Array

    def parts(self, joints: Sequence[PlanJoint]) -> list[slice]:
        """Return the rows of each joint of the run among those along the motions."""
        if len(self.run) == 1:
            return [slice(None)]
        ends = list(accumulate((KINDS[joints[j].kind].nv for j in self.run), initial=0))
        return [slice(first, last) for first, last in pairwise(ends)]


@dataclass(frozen=True)
class Joined:
    """What disassembly needs of a join; names as in the paper (templates/runtime/joins.hpp)."""

    step: Join
    frame: JointFrame
    lower: NDArray[Any]
    z0: NDArray[Any]
    z: dict[int, Array]
    y: dict[int, Array]
    phi: Array
    beta: Array


def joint_frame(machine: Machine, step: Join) -> JointFrame:
    """Return the frame of a join.

    Raises:
        FloatingPointError: the joints of a run are in gimbal lock.
    """
    joints, memory = machine.plan.joints, machine.memory
    if not isinstance(step, FusedJoin):
        return machine.own_frame(step.joint)
    kinds = [KINDS[joints[j].kind] for j in step.run]
    x, s = run_motion([memory["X", j] for j in step.run], kinds)
    c = np.zeros((6, machine.columns))
    for j in step.run:
        c = memory["X", j] @ c + machine.velocity_product(j)
    y, lock = joint_coordinates(s)
    if lock < GIMBAL_LOCK:
        names = ", ".join(f'"{joints[j].name}"' for j in step.run)
        raise FloatingPointError(f"joints {names}: gimbal lock")
    n = s.shape[1]
    tau = np.vstack([machine.torques(j) for j in step.run])
    free, constrained = list(range(n)), list(range(n, 6))
    return JointFrame(step.run, y @ x, y, free, constrained, y @ c, tau, np.zeros((6, 6)))
