"""Closed loops in double: constraints, states that satisfy them, and accelerations.

Constraints are in the ground's axes, straight from the model's frames: link by link, without
spatial vectors. A row of J is the rate of a gap: how fast a loop's frames part along an axis that
frame 1 holds, or turn against each other about it; for a coupling, of the sum that it holds.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.exact import rotation_taking_z_to, rounded
from adagen.model import FLOATING, PRISMATIC, REVOLUTE, SPHERICAL, Joint, Loop, Model
from adagen.reference.coupling import checked, coupled, prescribed
from adagen.reference.coupling import coupling as following
from adagen.reference.double import inverse_dynamics, joint_space_inertia
from adagen.reference.loop_rows import loop_rows, more_than_rounding, size_of, usual_sizes
from adagen.reference.numbers import DOUBLE

Array = NDArray[np.float64]
STARTS = 40
"""Random configurations from which loops are tried to be closed."""
SCALES = (0.3, 1.0, 3.0)
"""How far from rest these are: radians, and sizes of the robot."""
STEPS = 120
SMALL = 0.02
"""Largest length on a link, m, of robots whose loops are closed in units of that length."""
CLOSED = 1e-11
"""How far a loop may be open, beside the size of the robot, that counts as closed."""

ROUNDING = 2 * float(np.finfo(float).eps)
"""How far they may be open, likewise, that no step makes better: three quarters of all steps were
tried for less."""


@dataclass(frozen=True)
class Constraints:
    """The constraints of a robot, in one configuration or in several (S, one in each row).

    Attributes:
        gaps: how far each constraint is from being satisfied, shape (rows,) or (S, rows), m, rad.
        rows: J, shape (rows, nv) or (S, rows, nv): rates of the gaps are J v.
        names: of the loop or coupling that each row is of.
    """

    gaps: Array
    rows: Array
    names: tuple[str, ...]


class _Poses:
    """All links in ground axes, in S configurations at once.

    Attributes:
        turns: axes of each link, shape (S, 3, 3).
        places: origin of each link, shape (S, 3).
        angular: of each joint, shape (S, 3, n): angular velocity of its child link by unit rates.
        linear: likewise the velocity of the child's origin.
    """

    def __init__(self, model: Model, q: Array) -> None:
        self.model, count = model, len(q)
        self.turns = [np.broadcast_to(np.eye(3), (count, 3, 3))]
        self.places = [np.zeros((count, 3))]
        self.angular: list[Array] = []
        self.linear: list[Array] = []
        for joint, start in zip(model.joints, model.q_start, strict=True):
            above = self.turns[joint.parent]
            turn, shift, angular, linear = _motion(joint, q[:, start : start + joint.kind.nq])
            at = joint.translation + shift @ joint.rotation.T
            own = above @ joint.rotation @ turn
            self.turns.append(own)
            self.places.append(self.places[joint.parent] + (above @ at[..., None])[..., 0])
            self.angular.append(own @ angular)
            self.linear.append(own @ linear)

    @cached_property
    def rates(self) -> tuple[Array, Array, Array]:
        """Of each entry of v, shapes (S, 3, nv): angular, linear, and the child's origin."""
        counts = [joint.kind.nv for joint in self.model.joints]
        origins = np.repeat(np.stack(self.places[1:], axis=2), counts, axis=2)
        return np.concatenate(self.angular, axis=2), np.concatenate(self.linear, axis=2), origins

    def add_rates(self, link: int, sign: float, place: Array, row: Array) -> None:
        """Add how a point of a link moves (first three) and the link turns, to (S, 6, nv)."""
        at: list[int] = []
        while link > 0:
            joint, first = self.model.joints[link - 1], self.model.v_start[link - 1]
            at += range(first, first + joint.kind.nv)
            link = joint.parent
        if not at:
            return
        angular, linear, origins = (each[:, :, at] for each in self.rates)
        x, y, z = angular.transpose(1, 0, 2)
        ax, ay, az = (place[:, :, None] - origins).transpose(1, 0, 2)
        turning = np.stack([y * az - z * ay, z * ax - x * az, x * ay - y * ax], axis=1)
        row[:, :3, at] += sign * (linear + turning)
        row[:, 3:, at] += sign * angular


def _motion(joint: Joint, q: Array) -> tuple[Array, Array, Array, Array]:
    """Turn (S, 3, 3) and shift (S, 3) in the joint frame; angular and linear rates, (3, n)."""
    count, none = len(q), np.zeros((3, 3))
    still, whole = np.zeros((count, 3)), np.eye(3)
    if joint.kind is SPHERICAL:
        return _turns_of(q), still, whole, none
    if joint.kind is FLOATING:
        return _turns_of(q[:, 3:]), q[:, :3], np.hstack([none, whole]), np.hstack([whole, none])
    axis = joint.axis / np.linalg.norm(joint.axis)
    if joint.kind is REVOLUTE:
        return _about(axis, q[:, 0]), still, axis[:, None], none[:, :1]
    if joint.kind is PRISMATIC:
        same = np.broadcast_to(whole, (count, 3, 3))
        return same, q * axis, none[:, :1], axis[:, None]
    frame = rounded(rotation_taking_z_to(joint.axis))
    across = np.hstack([none[:, :2], frame[:, 2:]])
    return (
        _about(frame[:, 2], q[:, 2]),
        q[:, :2] @ frame[:, :2].T,
        across,
        np.hstack([frame[:, :2], none[:, :1]]),
    )


def _about(axis: Array, angles: Array) -> Array:
    k = _cross(axis)
    sine, cosine = np.sin(angles)[:, None, None], np.cos(angles)[:, None, None]
    result: Array = np.eye(3) + k * sine + (k @ k) * (1 - cosine)
    return result


def _turns_of(xyzw: Array) -> Array:
    x, y, z, w = xyzw.T
    zero = np.zeros_like(x)
    k = np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]).transpose(2, 0, 1)
    over = (2 / (xyzw * xyzw).sum(axis=1))[:, None, None]
    result: Array = np.eye(3) + (k * w[:, None, None] + k @ k) * over
    return result


def _cross(a: Array) -> Array:
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def constraints(model: Model, q: Any) -> Constraints:
    """Return the constraints of a robot at configuration q, shape (nq,)."""
    found = constraints_of_all(model, checked(model, "q", q, model.nq)[None])
    return Constraints(found.gaps[0], found.rows[0], found.names)


def constraints_of_all(model: Model, q: Array) -> Constraints:
    """Return the constraints of a robot in S configurations, shape (S, nq)."""
    poses = _Poses(model, q)
    gaps: list[Array] = []
    rows: list[Array] = []
    names: list[str] = []
    for loop in model.loops:
        own_gaps, own_rows = _of_loop(loop, poses, len(q))
        gaps += own_gaps
        rows += own_rows
        names += [loop.name] * len(own_rows)
    for coupling in model.couplings:
        row, gap = np.zeros((len(q), model.nv)), np.full(len(q), -coupling.offset)
        for j, factor in coupling.terms:
            row[:, model.v_start[j]] += factor
            gap = gap + factor * q[:, model.q_start[j]]
        gaps.append(gap)
        rows.append(row)
        names.append(coupling.name)
    values = np.array(rows).transpose(1, 0, 2)
    values = np.where(more_than_rounding(model, values)[:, :, None], values, 0.0)
    return Constraints(np.array(gaps).T, values, tuple(names))


def pose_of(model: Model, q: Any, link: int) -> tuple[Array, Array]:
    """Return axes (3, 3) and origin (3,) of a link in ground axes at configuration q."""
    poses = _Poses(model, checked(model, "q", q, model.nq)[None])
    return poses.turns[link][0], poses.places[link][0]


def _of_loop(loop: Loop, poses: _Poses, count: int) -> tuple[list[Array], list[Array]]:
    """Gaps (S,) and rows (S, nv) of a loop; frame 1 carries the place where frame 2 is."""
    (link1, frame1), (link2, frame2) = loop.ends
    axes1, axes2 = poses.turns[link1] @ frame1.rotation, poses.turns[link2] @ frame2.rotation
    place1, place2 = (
        poses.places[link] + poses.turns[link] @ frame.translation for link, frame in loop.ends
    )
    apart, seen = place2 - place1, place1
    for k in loop.kind.sliding:  # where it is if the loop is closed
        seen = seen + axes1[:, :, k] * _dots(axes1[:, :, k], apart)[:, None]
    rates = np.zeros((count, 6, poses.model.nv))
    poses.add_rates(link2, 1.0, place2, rates)
    poses.add_rates(link1, -1.0, seen, rates)

    def along(direction: Array, first: int) -> Array:
        row: Array = np.einsum("si,sij->sj", direction, rates[:, first : first + 3])
        return row

    gaps = [_dots(axes1[:, :, k], apart) for k in loop.kind.linear]
    rows = [along(axes1[:, :, k], 0) for k in loop.kind.linear]
    if loop.kind.axes == 2:
        gaps.append(_dots(axes1[:, :, 2], axes2[:, :, 2]))
        rows.append(along(np.cross(axes2[:, :, 2], axes1[:, :, 2]), 3))
        return gaps, rows
    whole = len(loop.kind.angular) == 3
    agreeing = range(3) if whole else (2,)
    twist = sum(np.cross(axes1[:, :, k], axes2[:, :, k]) for k in agreeing)
    gaps += [_dots(axes1[:, :, k], twist) / (2 if whole else 1) for k in loop.kind.angular]
    rows += [along(axes1[:, :, k], 3) for k in loop.kind.angular]
    return gaps, rows


def _dots(a: Any, b: Any) -> Array:
    result: Array = (a * b).sum(axis=1)
    return result


def moved(model: Model, q: Array, step: Array) -> Array:
    """Return the configuration that is reached from q by a step in v's components.

    Shapes (nq,) and (nv,), or (S, nq) and (S, nv).
    """
    result = np.atleast_2d(q).copy()
    steps = np.atleast_2d(step)
    for j, joint in enumerate(model.joints):
        at, own = model.q_start[j], steps[:, model.v_start[j] :][:, : joint.kind.nv]
        if joint.kind.quaternion is None:
            if joint.kind.nv == 3:  # planar: its velocity is given in the turned frame
                own = _in_plane(own, result[:, at + 2])
            result[:, at : at + joint.kind.nq] += own
            continue
        first = at + joint.kind.quaternion
        four = result[:, first : first + 4]
        four = four / np.linalg.norm(four, axis=1, keepdims=True)
        if joint.kind.quaternion:
            result[:, at : at + 3] += (_turns_of(four) @ own[:, :3, None])[..., 0]
        result[:, first : first + 4] = _turned(four, own[:, -3:])
    return result if q.ndim == 2 else result[0]


def _in_plane(step: Array, angles: Array) -> Array:
    c, s = np.cos(angles), np.sin(angles)
    x, y, turn = step.T
    result: Array = np.array([c * x - s * y, s * x + c * y, turn]).T
    return result


def _turned(xyzw: Array, angle: Array) -> Array:
    """Quaternions after turns by rotation vectors in their own axes, shapes (S, 4), (S, 3)."""
    half = np.linalg.norm(angle, axis=1, keepdims=True) / 2
    axis = angle * np.sinc(half / np.pi) / 2
    w = np.cos(half)
    vector = xyzw[:, 3:] * axis + w * xyzw[:, :3] + np.cross(xyzw[:, :3], axis)
    last = xyzw[:, 3:] * w - (xyzw[:, :3] * axis).sum(axis=1, keepdims=True)
    whole = np.hstack([vector, last])
    result: Array = whole / np.linalg.norm(whole, axis=1, keepdims=True)
    return result


def closest(model: Model, q: Array) -> Array:
    """Return configurations near q (S, nq) in which constraints are satisfied as well as can be.

    By Levenberg and Marquardt's method.
    """
    over, unit = _units(model)

    def seen(places: Array) -> tuple[Array, Array]:
        found = constraints_of_all(model, places)
        return found.gaps * over, found.rows * over[:, None] * unit

    q, fine = q.copy(), ROUNDING * max(size_of(model), 1.0)
    gaps, rows = seen(q)
    cost, damping = (gaps**2).sum(axis=1), np.full(len(q), 1e-3)
    for _ in range(STEPS):
        busy = np.flatnonzero((np.abs(gaps).max(axis=1) > fine) & (damping < 1e12))
        if not len(busy):
            break
        tried = moved(model, q[busy], -_least(rows[busy], gaps[busy], damping[busy]) * unit)
        new_gaps, new_rows = seen(tried)
        costs = (new_gaps**2).sum(axis=1)
        better = costs < cost[busy]
        taken = busy[better]
        q[taken], cost[taken] = tried[better], costs[better]
        gaps[taken], rows[taken] = new_gaps[better], new_rows[better]
        damping[busy] = np.where(better, damping[busy] * 0.1, np.maximum(damping[busy], 1e-9) * 10)
    return q


def _units(model: Model) -> tuple[Array, Array]:
    """Return what gaps are multiplied by (rows,), and of which unit steps are (nv,).

    Both are 1 but for robots of millimetres, of which gaps in metres would weigh next to nothing
    beside radians: their lengths are in units of the robot.
    """
    size = size_of(model)
    if size >= SMALL:
        return np.ones(len(usual_sizes(model))), np.ones(model.nv)
    rows = [row for joint in model.joints for row in joint.kind.free]
    return 1 / usual_sizes(model), np.where(np.array(rows) >= 3, size, 1.0)


def _least(rows: Array, gaps: Array, damping: Array) -> Array:
    """Damped least steps that close gaps, shape (S, nv)."""
    left, sizes, right = np.linalg.svd(rows, full_matrices=False)
    first = sizes[:, :1]
    kept = sizes > 1e-9 * first
    least = np.where(damping < 1e-9, 0.0, damping)[:, None] * first**2
    over = np.where(kept, sizes / np.where(kept, sizes**2 + least, 1.0), 0.0)
    share = np.einsum("srk,sr->sk", left, gaps) * over
    result: Array = np.einsum("skn,sk->sn", right, share)
    return result


def closed_states(
    model: Model, count: int, seed: int = 0, starts: int = STARTS
) -> tuple[Array, Array]:
    """Return states that satisfy all constraints, from random starts: q (S, nq) and v (S, nv).

    Args:
        model: the robot.
        count: how many are wanted.
        seed: at least 0.
        starts: random configurations to begin from, at most.

    Returns:
        At most ``count`` states, those found; none where the loops could not be closed.
    """
    rng = np.random.default_rng(seed)
    limit = CLOSED * max(size_of(model), 1.0)
    q = np.empty((0, model.nq))
    for first in range(0, starts, count):
        if first >= STARTS and not len(q):
            break
        scales = [SCALES[(first + k) % len(SCALES)] for k in range(min(count, starts - first))]
        places = closest(model, _starts(model, rng, scales))
        gaps = np.abs(constraints_of_all(model, places).gaps).max(axis=1, initial=0.0)
        q = np.vstack([q, places[gaps <= limit]])[:count]
        if len(q) == count:
            break
    v = rng.uniform(-1.0, 1.0, (len(q), model.nv))
    if len(q):
        rows = constraints_of_all(model, q).rows
        v = v - _least(rows, np.einsum("srn,sn->sr", rows, v), np.zeros(len(q)))
    return q, v


def nearly_closed(model: Model) -> dict[str, float]:
    """Return by how much each loop and coupling is open where all are closed as well as was found.

    In m and rad, the larger one; from as many random starts as there are scales, by least squares.
    """
    rng = np.random.default_rng(0)
    starts = _starts(model, rng, SCALES)
    found = constraints_of_all(model, closest(model, starts))
    best = int(np.argmin((found.gaps**2).sum(axis=1)))
    by: dict[str, float] = {}
    for name, gap in zip(found.names, np.abs(found.gaps[best]).tolist(), strict=True):
        by[name] = max(by.get(name, 0.0), gap)
    return by


def _starts(model: Model, rng: np.random.Generator, scales: Sequence[float]) -> Array:
    """Random configurations around rest, one for each scale, shape (S, nq)."""
    q, size = np.zeros((len(scales), model.nq)), size_of(model)
    step = np.array([rng.uniform(-scale, scale, model.nv) for scale in scales])
    for j, joint in enumerate(model.joints):
        if joint.kind.quaternion is not None:
            q[:, model.q_start[j] + joint.kind.nq - 1] = 1.0
        for k, row in enumerate(joint.kind.free):
            if row >= 3:
                step[:, model.v_start[j] + k] *= size
    return moved(model, q, step)


def closed_forward_dynamics(model: Model, q: Any, v: Any, tau: Any, rank: float = 1e-9) -> Array:
    """Return the joint accelerations of a robot with loops, by the null space of J.

    With N an orthonormal basis of it, (N^T H N) y = N^T (tau - bias - H a), qdd = a + N y, where
    a satisfies J a = -Jdot v and what is prescribed, with the least accelerations beside that.
    Slaved joints follow their sources.

    Args:
        model: the robot.
        q: configuration that satisfies the constraints, shape (nq,).
        v: velocity that does, shape (nv,).
        tau: torques, shape (ntau,).
        rank: singular values of J below this, relative to the largest, are zero.
    """
    q, v = checked(model, "q", q, model.nq), checked(model, "v", v, model.nv)
    tau = checked(model, "tau", tau, model.ntau)
    q, v = coupled(DOUBLE, model, q, v)
    (rows, fast), follow = loop_rows(DOUBLE, model, q, v), following(DOUBLE, model)
    told = more_than_rounding(model, rows)
    rows, fast = rows[told], fast[told]
    given = prescribed(DOUBLE, model, tau)
    left, sizes, right = np.linalg.svd(rows @ follow)
    kept = int((sizes > rank * sizes[:1].sum()).sum())
    open_by = left[:, :kept].T @ (fast + rows @ given)
    least = given - follow @ (right[:kept].T @ (open_by / sizes[:kept]))
    inertia, free = joint_space_inertia(model, q), follow @ right[kept:].T
    needed = tau[: model.nv] - inverse_dynamics(model, q, v, least, tau)
    reduced = free.T @ inertia @ free
    result: Array = least + free @ np.linalg.solve(reduced, free.T @ needed)
    return result
