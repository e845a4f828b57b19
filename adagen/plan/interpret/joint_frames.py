"""The frame that a join is done in, in numpy: a joint's own, or a run's."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import HELD, KINDS
from adagen.plan.fused_frame import joint_coordinates, run_motion
from adagen.plan.steps import FusedJoin, Join
from adagen.plan.types import PlanJoint

if TYPE_CHECKING:
    from adagen.plan.interpret.machine import Machine

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


def joint_frame(machine: Machine, step: Join) -> JointFrame:
    """Return the frame of a join.

    Raises:
        FloatingPointError: the joints of a run are in gimbal lock.
    """
    joints, memory = machine.plan.joints, machine.memory
    if not isinstance(step, FusedJoin):
        return _own_frame(machine, step.joint)
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


def _own_frame(machine: Machine, j: int) -> JointFrame:
    """The frame that a joint by itself is joined in."""
    kind, rotor = machine.kind(j), machine.plan.joints[j].rotor_inertia
    c, tau = machine.velocity_product(j), machine.torques(j)
    give = np.zeros((6, 6))
    if rotor:  # the rotor gives way, S qdd = S J^-1 (tau - S^T f): nothing is free
        give[kind.free, kind.free] = 1.0 / rotor
        c[list(kind.free)] += tau / rotor
        kind, tau = HELD, tau[:0]
    free, constrained, x = list(kind.free), list(kind.constrained), machine.memory["X", j]
    return JointFrame((j,), x, np.eye(6), free, constrained, c, tau, give)
