"""The frame of a join: a joint's own, or the coordinates in which a run of joints is one joint.

With S the motions of a run's joints in the last link's frame, one in each column, B S = [1; 0]: the
first rows of B are a left inverse of S, the others its left null space. In the coordinates B a of
an acceleration a, the run is joined and released as a joint whose freedoms are the first rows.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import Check
from adagen.executor.frames import Transform, columnwise
from adagen.executor.kinematics import Motion
from adagen.executor.state import State
from adagen.graph import Expression, Graph, matrix_times, reflect, total
from adagen.model.kinds import HELD
from adagen.plan.digits import GIMBAL_LOCK, NEAR_GIMBAL_LOCK
from adagen.plan.fused_frame import run_length
from adagen.plan.steps import FusedJoin, Join

Array = NDArray[Any]


@dataclass(frozen=True)
class JointFrame:
    """Coordinates in which the motions of a joint, or of a run of joints, are unit vectors.

    Attributes:
        run: the joints.
        transforms: X of each, outwards.
        turn: B, from the last link's frame, shape (6, 6); None where that is the frame.
        parts: rows of each joint of the run among those along the motions.
        free: the rows along the motions; n of them.
        constrained: the other rows.
        drift: what the two sides differ by beyond the reference field and S qdd, shape
            (6, columns); None for nothing.
        tau: torques along the motions, shape (n, columns).
        give: mobility of the joint itself by its entries on the diagonal, where it gives way other
            than along its motions.
    """

    run: tuple[int, ...]
    transforms: tuple[Transform, ...]
    turn: Array | None
    parts: tuple[slice, ...]
    free: list[int]
    constrained: list[int]
    drift: Array | None
    tau: Array
    give: dict[int, Expression]

    def from_parent(self, motions: Array) -> Array:
        """Return motions of the parent link in the frame, shape (6, k)."""
        for x in self.transforms:
            motions = columnwise(x.motion, motions)
        return self.from_child(motions)

    def from_child(self, motions: Array) -> Array:
        """Return motions of the child link in the frame, shape (6, k)."""
        return motions if self.turn is None else matrix_times(self.turn, motions)

    def mobility_of_parent(self, phi: Array) -> Array:
        """Return a mobility of the parent link in the frame, shape (6, 6)."""
        for x in self.transforms:
            phi = x.mobility(phi)
        return self.mobility_of_child(phi)

    def mobility_of_child(self, phi: Array) -> Array:
        """Return a mobility of the child link in the frame, shape (6, 6)."""
        if self.turn is None:
            return phi
        half, result = matrix_times(self.turn, phi), phi.copy()
        for i in range(6):
            for k in range(i, 6):
                result[i, k] = result[k, i] = total(half[i] * self.turn[k])
        return result

    def on_child(self, f: Array) -> Array:
        """Return a wrench in the frame as one on the child link, shape (6, columns)."""
        return f if self.turn is None else matrix_times(self.turn.T, f)

    def on_parent(self, f: Array) -> Array:
        """Return a wrench in the frame as one on the parent link, shape (6, columns)."""
        f = self.on_child(f)
        for x in reversed(self.transforms):
            f = columnwise(x.force, f)
        return f


def joint_frame(state: State, motion: Motion, step: Join) -> JointFrame:
    """Return the frame of a join."""
    if isinstance(step, FusedJoin):
        return _frame_of_run(state, motion, step)
    kind, x = state.kind(step.joint), state.memory["X", step.joint]
    drift, tau, rotor = motion.drift(step.joint), state.torques(step.joint), state.rotor(step.joint)
    give: dict[int, Expression] = {}
    if rotor is not None:  # it gives way, S qdd = S J^-1 (tau - S^T f): nothing is free
        over = state.graph.reciprocal(rotor)
        give = dict.fromkeys(kind.free, over)
        drift = state.zeros(6, state.columns) if drift is None else drift
        drift[list(kind.free)] = drift[list(kind.free)] + tau * over
        kind, tau = HELD, tau[:0]
    free, constrained = list(kind.free), list(kind.constrained)
    return JointFrame(
        (step.joint,), (x,), None, (slice(None),), free, constrained, drift, tau, give
    )


def _frame_of_run(state: State, motion: Motion, step: FusedJoin) -> JointFrame:
    transforms = tuple(state.memory["X", j] for j in step.run)
    s, drift = state.zeros(6, 0), None
    for j, x in zip(step.run, transforms, strict=True):
        own, kind = motion.drift(j), state.kind(j)
        drift = None if drift is None else columnwise(x.motion, drift)
        drift = own if drift is None else drift if own is None else drift + own
        s = columnwise(x.motion, s) if s.size else s
        s = np.hstack([s, state.constants(np.eye(6)[:, list(kind.free)])])
    joints = [state.plan.joints[j] for j in step.run]
    length = run_length(joints, state.plan.links[step.joint + 1])
    turn, lock = joint_coordinates(state.graph, s, length)
    least = state.graph.constant(GIMBAL_LOCK[state.plan.scalar] ** 2)
    near = NEAR_GIMBAL_LOCK**2  # lock is a square, too
    state.checks.append(Check(lock, least, step.joint, "kGimbalLock", near))
    n = s.shape[1]
    ends = accumulate((state.kind(j).nv for j in step.run), initial=0)
    parts = tuple(slice(*ends) for ends in pairwise(ends))
    tau = np.vstack([state.torques(j) for j in step.run])
    drift = None if drift is None else matrix_times(turn, drift)
    free, constrained = list(range(n)), list(range(n, 6))
    return JointFrame(step.run, transforms, turn, parts, free, constrained, drift, tau, {})


def joint_coordinates(graph: Graph, s: Array, length: float) -> tuple[Array, Expression]:
    """Return B with B S = [1; 0], shape (6, 6), and how far the run is from gimbal lock, squared.

    By Householder's reflections of S, each column scaled to length one.

    Args:
        graph: what S belongs to.
        s: motions of the run's joints in the last link's frame, shape (6, n).
        length: the unit of lengths (``adagen.plan.fused_frame.run_length``), m.

    Returns:
        B, and 1 / |S^+|^2 (Frobenius norm): about the square of the least singular value of the
        scaled S where only that one is small. Zero in gimbal lock; B is then not finite.
    """
    n, unit = s.shape[1], graph.constant(1.0 / length)
    r, b = s.copy(), np.full((6, 6), graph.constant(0), dtype=object)
    r[3:] = r[3:] * unit
    for k in range(6):
        b[k, k] = graph.constant(1) if k < 3 else unit
    scale = [graph.reciprocal(graph.sqrt(total(r[:, k] * r[:, k]))) for k in range(n)]
    for k in range(n):
        r[:, k] = r[:, k] * scale[k]
    for k in range(n):
        reflect(k, r, b)
    inverse = _inverted(graph, r[:n])
    top = matrix_times(inverse, b[:n])
    for k in range(n):
        b[k] = top[k] * scale[k]
    return b, graph.reciprocal(total(x * x for k in range(n) for x in inverse[k, k:]))


def _inverted(graph: Graph, r: Array) -> Array:
    """The inverse of an upper triangular matrix."""
    inverse = np.full(r.shape, graph.constant(0), dtype=object)
    for k in range(len(r)):
        inverse[k, k] = graph.reciprocal(r[k, k])
        for j in reversed(range(k)):
            inner = total(r[j, m] * inverse[m, k] for m in range(j + 1, k + 1))
            inverse[j, k] = -(inner * inverse[j, j])
    return inverse
