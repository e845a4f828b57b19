"""Independent answers in double precision."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.model import Model
from adagen.reference.coupling import (
    checked,
    coupled,
    coupling,
    free_rows,
    prescribed,
    prescribed_rows,
    row_names,
)
from adagen.reference.inertia import cholesky_solve, inertia_matrix
from adagen.reference.kinematics import momenta
from adagen.reference.loop_rows import loop_rows, more_than_rounding
from adagen.reference.newton_euler import energies, joint_torques
from adagen.reference.numbers import DOUBLE

Array = NDArray[np.float64]


def inverse_dynamics(model: Model, q: Any, v: Any, a: Any, tau: Any = None) -> Array:
    """Return the joint torques that give the accelerations a, by recursive Newton-Euler.

    Args:
        model: the robot.
        q: configuration, shape (nq,); quaternions (x, y, z, w) of any length.
        v: velocity, shape (nv,).
        a: time derivative of v's components, shape (nv,).
        tau: shape (ntau,), where outer forces are looked up; none act where it is left out.

    Returns:
        Torques and forces, shape (nv,), N m and N. A slaved joint's entries in q, v and a are
        copied from the joint that it follows; its own torque is 0, its share being in the other's.
        So is that of a joint with a prescribed acceleration, which nobody asks for.

    Raises:
        InputError: a number is not finite, or a quaternion is zero.
    """
    q, v = checked(model, "q", q, model.nq), checked(model, "v", v, model.nv)
    q, v, a = coupled(DOUBLE, model, q, v, checked(model, "a", a, model.nv))
    outer = None if tau is None else checked(model, "tau", tau, model.ntau)
    needed = joint_torques(DOUBLE, model, q, v, a, outer)
    result = np.zeros(model.nv)
    result[free_rows(model)] = coupling(DOUBLE, model).T.dot(needed)
    return result


def bias(model: Model, q: Any, v: Any) -> Array:
    """Return the torques, shape (nv,), that hold the accelerations at zero.

    Arguments and errors as for `inverse_dynamics`.
    """
    return inverse_dynamics(model, q, v, np.zeros(model.nv))


def joint_space_inertia(model: Model, q: Any) -> Array:
    """Return the joint-space inertia H by composite rigid bodies.

    Args:
        model: the robot.
        q: configuration, shape (nq,).

    Returns:
        Symmetric, shape (nv, nv), with a row for each slaved joint too, as if it were free.

    Raises:
        InputError: a number is not finite, or a quaternion is zero.
    """
    q = checked(model, "q", q, model.nq)
    q, _ = coupled(DOUBLE, model, q, np.zeros(model.nv))
    return np.asarray(inertia_matrix(DOUBLE, model, q))


def forward_dynamics(model: Model, q: Any, v: Any, tau: Any) -> Array:
    """Return the joint accelerations by composite rigid bodies and Cholesky.

    Args:
        model: the robot.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
        tau: torques and forces of the joints, then outer forces, shape (ntau,); a slaved joint's
            counts through its multiplier, a prescribed joint's entries are its acceleration.

    Returns:
        Time derivative of v's components, shape (nv,); a slaved joint's entry follows from its
        source's.

    Raises:
        InputError: a number is not finite, a quaternion is zero, or the joint-space inertia is
            singular.
    """
    tau = checked(model, "tau", tau, model.ntau)
    moved = joint_space_inertia(model, q)
    shares = coupling(DOUBLE, model)
    free = free_rows(model)
    known = prescribed(DOUBLE, model, tau)
    needed = shares.T.dot(tau[: model.nv]) - inverse_dynamics(model, q, v, known, tau)[free]
    names = row_names(model)
    reduced = shares.T.dot(moved).dot(shares)
    result = shares.dot(cholesky_solve(reduced, needed, [names[row] for row in free])) + known
    if not np.isfinite(result).all():
        raise InputError("the accelerations overflow; the state or the robot is out of range")
    return np.asarray(result)


def kinetic_energy(model: Model, q: Any, v: Any) -> float:
    """Return the kinetic energy (J), from the links' velocities; arguments as for `bias`."""
    q, v = checked(model, "q", q, model.nq), checked(model, "v", v, model.nv)
    return float(energies(DOUBLE, model, *coupled(DOUBLE, model, q, v))[0])


def potential_energy(model: Model, q: Any) -> float:
    """Return the potential energy in gravity (J), zero with all masses at the ground's origin."""
    q = checked(model, "q", q, model.nq)
    return float(energies(DOUBLE, model, *coupled(DOUBLE, model, q, np.zeros(model.nv)))[1])


def momentum(model: Model, q: Any, v: Any) -> tuple[Array, Array]:
    """Return linear momentum (kg m/s) and angular momentum about the centre of mass (kg m^2/s).

    Args:
        model: the robot.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).

    Returns:
        Two vectors of shape (3,) in ground coordinates. Those of a robot on a floating base whose
        base has no torque: the first changes by gravity alone, the second not at all.

    Raises:
        InputError: as `inverse_dynamics`.
    """
    q, v = checked(model, "q", q, model.nq), checked(model, "v", v, model.nv)
    linear, angular = momenta(DOUBLE, model, *coupled(DOUBLE, model, q, v))
    return np.asarray(linear), np.asarray(angular)


def residual(model: Model, q: Any, v: Any, tau: Any, qdd: Any) -> float:
    """Return how far the accelerations are from the torques, relative to the torques at work.

    The norm of (inverse dynamics of qdd) - tau, divided by the largest of the norms of tau, of the
    bias and of the inverse dynamics, so that it also has a meaning where tau is zero. Of that
    difference, forces of closed loops take what they can (least squares); and accelerations that
    open the loops count as much: J qdd + Jdot v beside |J| |qdd| or Jdot v. A small residual does
     not prove a small error: see `energy_norm_error`.

    Args:
        model: the robot.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
        tau: torques and outer forces, shape (ntau,).
        qdd: accelerations to be judged, shape (nv,).

    Returns:
        At most 2; infinity where qdd is not finite or not as prescribed; 0 where everything is
        zero.
    """
    if not np.isfinite(np.asarray(qdd, dtype=np.float64)).all():
        return np.inf
    tau = checked(model, "tau", tau, model.ntau)
    free, rows = free_rows(model), prescribed_rows(model)
    if not np.array_equal(np.asarray(qdd)[rows], tau[rows]):
        return np.inf
    given = coupling(DOUBLE, model).T.dot(tau[: model.nv])
    needed = inverse_dynamics(model, q, v, qdd, tau)[free]
    held = inverse_dynamics(model, q, v, prescribed(DOUBLE, model, tau), tau)[free]
    scale = max(float(np.linalg.norm(x)) for x in (given, needed, held))
    left, opening = needed - given, 0.0
    if model.closed:
        at, speed, rate = coupled(DOUBLE, model, *map(np.asarray, (q, v, qdd)))
        jacobian, drift = loop_rows(DOUBLE, model, at, speed)
        told = more_than_rounding(model, jacobian)
        jacobian, drift = jacobian[told], drift[told]
        size = np.array(np.linalg.norm(jacobian) * np.linalg.norm(rate))
        opening = _beside(jacobian @ rate + drift, size, drift)
        pushed = (jacobian @ coupling(DOUBLE, model)).T
        left = left - pushed @ np.linalg.lstsq(pushed, left, rcond=1e-9)[0]
    return max(_beside(left, np.array(scale)), opening)


def _beside(value: Array, *sizes: Array) -> float:
    """Return the norm of an array over the largest of others; 0 where all are zero."""
    scale = max(float(np.linalg.norm(size)) for size in sizes)
    return float(np.linalg.norm(value)) / scale if scale > 0 else 0.0


def energy_norm_error(inertia: Any, error: Any, truth: Any) -> float:
    """Return sqrt(e^T H e / t^T H t), a relative error that mixes metres and radians rightly.

    Args:
        inertia: joint-space inertia H, shape (nv, nv).
        error: difference of two accelerations, shape (nv,).
        truth: the true acceleration, shape (nv,).

    Returns:
        The error; infinity where a number is not finite or only the truth is zero.
    """
    h, e, t = (np.asarray(x, dtype=np.float64) for x in (inertia, error, truth))
    if not all(np.isfinite(x).all() for x in (h, e, t)):
        return np.inf
    wrong, right = max(float(e @ h @ e), 0.0), max(float(t @ h @ t), 0.0)
    if right == 0.0:
        return 0.0 if not e.any() else np.inf
    return float(np.sqrt(wrong / right))
