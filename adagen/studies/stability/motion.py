"""Cases in time: a stiff damped joint, and a body that tumbles about its middle axis."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from adagen.reference import bias, joint_space_inertia
from adagen.studies.stability import robots

Array = NDArray[np.float64]
Row = tuple[str, bool, float, str, bool]
"""Method, whether it is a weak one, its figure, what that must be, whether it is."""

DAMPING = 1.0  # N m s/rad at the last joint
STEPS = 400
TENSOR = np.array([1.0, 2.0, 3.0])  # kg m^2
SECONDS = 20.0
SWING = 0.02  # s


def damped_tip() -> tuple[Row, ...]:
    """Return how much energy grows in steps at 0.9 and 1.1 of 2/lambda, explicit and implicit.

    lambda is the largest eigenvalue of H^-1 D: steps of semi-implicit Euler beyond 2/lambda swing
    ever further; with the damping treated implicitly there is no such limit.
    """
    model = robots.planar(3, 1e-4)
    q, _, _ = robots.state(model)
    d = np.diag([0.0, 0.0, DAMPING])
    fastest = np.linalg.eigvals(np.linalg.solve(joint_space_inertia(model, q), d)).real.max()
    limit = 2.0 / float(fastest)
    at = {part: energy_growth(part * limit, STEPS, False) for part in (0.9, 1.1)}
    implicit = energy_growth(5e-2, 40, True)
    return (
        ("largest stable step 2/lambda (s)", False, limit, "6e-5 to 7e-5", 6e-5 < limit < 7e-5),
        ("explicit damping, 1.1 of it: energy", True, at[1.1], "> 1e6", not at[1.1] < 1e6),
        ("explicit damping, 0.9 of it: energy", False, at[0.9], "< 1.01", at[0.9] < 1.01),
        ("implicit damping, 50 ms: energy", False, implicit, "< 1.01", implicit < 1.01),
    )


def energy_growth(step: float, count: int, implicit: bool) -> float:
    """Return the kinetic energy after steps of semi-implicit Euler, relative to that before.

    Args:
        step: h, s.
        count: of steps; fewer where the energy overflows.
        implicit: whether damping acts as at the end of the step: (H + h D) dv = h (-D v - b).
    """
    model = robots.planar(3, 1e-4)
    d = np.diag([0.0, 0.0, DAMPING])
    q = robots.state(model)[0]
    v: Array = np.array([0.1, -0.1, 0.1])
    start = v @ joint_space_inertia(model, q) @ v
    energy = start
    for _ in range(count):
        inertia = joint_space_inertia(model, q)
        energy = v @ inertia @ v
        if not energy < 1e12 * start:
            return float("inf")
        matrix = inertia + step * d if implicit else inertia
        v = v + step * np.linalg.solve(matrix, -d @ v - bias(model, q, v))
        q = q + step * v
    return float(energy / start)


def swing(step: float, method: str) -> Array:
    """Return the velocities of the damped chain after ``SWING``, shape (3,), rad/s.

    Args:
        step: h, s.
        method: "explicit" or "implicit" damping in semi-implicit Euler, or "rk4".
    """
    model = robots.planar(3, 1e-4)
    d = np.diag([0.0, 0.0, DAMPING])
    q = robots.state(model)[0]
    v: Array = np.array([0.1, -0.1, 0.1])

    def rate(at: Array, speed: Array, extra: Array) -> Array:
        needed = -d @ speed - bias(model, at, speed)
        return np.asarray(np.linalg.solve(joint_space_inertia(model, at) + extra, needed))

    for _ in range(max(1, round(SWING / step))):
        if not np.abs(v).max() < 1e9:
            return np.full(3, np.inf)
        if method == "rk4":
            a = rate(q, v, 0 * d)
            b = rate(q + step / 2 * v, v + step / 2 * a, 0 * d)
            c = rate(q + step / 2 * (v + step / 2 * a), v + step / 2 * b, 0 * d)
            e = rate(q + step * (v + step / 2 * b), v + step * c, 0 * d)
            q = q + step * v + step**2 / 6 * (a + b + c)
            v = v + step / 6 * (a + 2 * b + 2 * c + e)
        else:
            v = v + step * rate(q, v, step * d if method == "implicit" else 0 * d)
            q = q + step * v
    return v


def tumbling_body() -> tuple[Row, ...]:
    """Return the drift of momentum in 20 s of 10 ms steps, and the orders of two integrators."""
    start = np.array([0.0, 0.0, 0.0, 1.0]), np.array([0.01, 3.0, 0.01])
    drift = momentum_drift(*integrate(*start, 0.01, runge_kutta), start[1])
    truth = integrate(*start, 0.005, runge_kutta)[0]

    def order(advance: Callable[[Array, Array, float], tuple[Array, Array]]) -> float:
        errors = [_apart(integrate(*start, h, advance)[0], truth) for h in (0.04, 0.02)]
        return float(np.log2(errors[0] / errors[1]))

    good, poor = order(runge_kutta), order(mean_velocity)
    return (
        ("RK4, momentum drift", False, drift, "< 1e-7", drift < 1e-7),
        ("RK4, quaternion renormalised: order", False, good, ">= 3.7", good >= 3.7),
        ("RK4, exp(h mean omega): order", True, poor, "< 2.5", poor < 2.5),
    )


def integrate(
    quaternion: Array,
    w: Array,
    step: float,
    advance: Callable[[Array, Array, float], tuple[Array, Array]],
) -> tuple[Array, Array]:
    """Return quaternion (x, y, z, w) and angular velocity (body frame, rad/s) after 20 s.

    Args:
        quaternion: at the start, shape (4,).
        w: angular velocity at the start in the body frame, shape (3,), rad/s.
        step: s.
        advance: the method: from both and a step to both.
    """
    for _ in range(round(SECONDS / step)):
        quaternion, w = advance(quaternion, w, step)
    return quaternion, w


def runge_kutta(quaternion: Array, w: Array, h: float) -> tuple[Array, Array]:
    """Advance by classical Runge-Kutta, the quaternion normalised after the step."""
    slopes = [_slope(quaternion, w)]
    for part in (0.5, 0.5, 1.0):
        dq, dw = slopes[-1]
        slopes.append(_slope(quaternion + part * h * dq, w + part * h * dw))
    (a, b), (c, d), (e, f), (g, k) = slopes
    moved = quaternion + h / 6 * (a + 2 * c + 2 * e + g)
    return moved / np.linalg.norm(moved), w + h / 6 * (b + 2 * d + 2 * f + k)


def mean_velocity(quaternion: Array, w: Array, h: float) -> tuple[Array, Array]:
    """Advance the velocity by Runge-Kutta, and turn by the mean of both ends': order 2 only."""
    _, after = runge_kutta(quaternion, w, h)
    turn = h * (w + after) / 2
    angle = float(np.linalg.norm(turn))
    small = np.append(np.sinc(angle / (2 * np.pi)) / 2 * turn, np.cos(angle / 2))
    return _product(quaternion, small), after


def momentum_drift(quaternion: Array, w: Array, first: Array) -> float:
    """Return how far angular momentum (in space) is from what it was, relative to its size."""
    start = TENSOR * first
    end = _turned(quaternion, TENSOR * w)
    return float(np.linalg.norm(end - start) / np.linalg.norm(start))


def _slope(quaternion: Array, w: Array) -> tuple[Array, Array]:
    rate = 0.5 * _product(quaternion, np.append(w, 0.0))
    return rate, -_cross(w, TENSOR * w) / TENSOR


def _product(p: Array, q: Array) -> Array:
    vector = p[3] * q[:3] + q[3] * p[:3] + _cross(p[:3], q[:3])
    return np.append(vector, p[3] * q[3] - p[:3] @ q[:3])


def _turned(quaternion: Array, vector: Array) -> Array:
    twice = 2.0 * _cross(quaternion[:3], vector)
    result: Array = vector + quaternion[3] * twice + _cross(quaternion[:3], twice)
    return result


def _apart(p: Array, q: Array) -> float:
    return float(min(np.linalg.norm(p - q), np.linalg.norm(p + q)))


def _cross(a: Array, b: Array) -> Array:
    """Return a x b: numpy's own is ten times slower for one pair."""
    (u, v, w), (x, y, z) = a, b
    return np.array([v * z - w * y, w * x - u * z, u * y - v * x])
