"""Methods as textbooks have them, to be failed: composite bodies, articulated bodies, world frame.

All are written for any kind of number: doubles, floats, or balls of any precision, in which the
articulated-body algorithm is also the truth for chains that are too long for a dense solve.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb, ctx
from numpy.typing import NDArray

from adagen.exact import exact, rounded
from adagen.model import Model
from adagen.reference.inertia import inertia_matrix
from adagen.reference.kinematics import bodies, placements
from adagen.reference.newton_euler import joint_torques
from adagen.reference.numbers import BALLS, DOUBLE, Numbers, cross, cross_matrix

Array = NDArray[Any]
MOST_BITS = 1 << 15


def composite(model: Model, q: Array, v: Array, tau: Array, scalar: Any = np.float64) -> Array:
    """Return accelerations by composite rigid bodies and Cholesky's factorization, shape (nv,).

    Raises:
        FloatingPointError: the joint-space inertia is not positive definite any more.
    """
    inertia = inertia_matrix(DOUBLE, model, q).astype(scalar)
    held = joint_torques(DOUBLE, model, q, v, np.zeros(model.nv)).astype(scalar)
    try:
        lower = np.linalg.cholesky(inertia)
    except np.linalg.LinAlgError:
        raise FloatingPointError("H is not positive definite") from None
    right = np.linalg.solve(lower, tau.astype(scalar) - held)
    result: Array = np.linalg.solve(lower.T, right)
    return result.astype(np.float64)


def articulated(
    model: Model, q: Array, v: Array, tau: Array, scalar: Any = np.float64, world: bool = False
) -> Array:
    """Return accelerations by the articulated-body algorithm without exact projection.

    Args:
        model: the robot.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
        tau: torques, shape (nv,).
        scalar: numpy's type to reckon in.
        world: tell everything in one world frame instead of the links' own.

    Raises:
        FloatingPointError: D of a joint cannot be inverted; the message names the joint.
    """
    tree = _tree(DOUBLE, model, q, v, lambda x: x.astype(scalar))
    if world:
        tree = _in_world(model, tree, v.astype(scalar))
    with np.errstate(all="ignore"):
        found = _sweep(model, tree, tau.astype(scalar))
    result = found.astype(np.float64)
    if not np.isfinite(result).all():
        raise FloatingPointError("accelerations are not finite")
    return result


def true_acceleration(model: Model, q: Array, v: Array, tau: Array) -> Array:
    """Return the accelerations to all digits of a double, by the same recursion in balls.

    Args:
        model: the robot, without slaved joints.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
        tau: torques, shape (nv,).

    Returns:
        Accelerations, shape (nv,).

    Raises:
        FloatingPointError: no precision up to 32768 bits is enough: singular.
    """
    before, bits = ctx.prec, 512
    try:
        while bits <= MOST_BITS:
            ctx.prec = bits
            tree = _tree(BALLS, model, exact(q), exact(v), lambda x: x)
            found = _sweep(model, tree, exact(tau))
            if all(x.is_finite() for x in found):
                radius = max((x.rad() for x in found), default=arb(0))
                largest = max((x.abs_lower() for x in found), default=arb(0))
                if radius * arb(10) ** 25 <= largest:
                    return rounded(found)
            bits *= 4
    finally:
        ctx.prec = before
    raise FloatingPointError("the joint-space inertia is singular")


@dataclass(frozen=True)
class _Tree:
    """Transforms from parents, motion subspaces, inertias, velocities, c, and the ground's a."""

    x: list[Array]
    s: list[Array]
    inertia: list[Array]
    v: list[Array]
    c: list[Array]
    ground: Array


def _tree(
    numbers: Numbers, model: Model, q: Array, v: Array, cast: Callable[[Array], Array]
) -> _Tree:
    x, s, product, inertia = [], [], [], []
    speed: list[Array] = []
    zero = cast(numbers.zeros(6))
    placed = placements(numbers, model, q)
    for j, (place, body) in enumerate(zip(placed, bodies(numbers, model), strict=True)):
        turn = cast(place.rotation).T
        x.append(_blocks(turn, -turn.dot(cross_matrix(cast(place.position))), zero))
        s.append(np.vstack([cast(place.angular), cast(place.linear)]))
        start = model.v_start[j]
        motion = s[j].dot(cast(v[start : start + model.joints[j].kind.nv]))
        parent = model.joints[j].parent
        speed.append(motion if parent == 0 else x[j].dot(speed[parent - 1]) + motion)
        product.append(_cross_motion(speed[j], motion))
        k, mass = cross_matrix(cast(body.com)), cast(numbers.array([body.mass])).reshape(-1)[0]
        moved = k * mass
        eye = cast(numbers.array(np.eye(3))) * mass
        inertia.append(np.block([[cast(body.tensor) - k.dot(moved), moved], [-moved, eye]]))
    ground = zero.copy()
    ground[3:] = -cast(numbers.array(model.gravity))
    return _Tree(x, s, inertia, speed, product, ground)


def _blocks(turn: Array, below: Array, zero: Array) -> Array:
    none = np.outer(zero[:3], zero[:3])
    return np.block([[turn, none], [below, turn]])


def _in_world(model: Model, tree: _Tree, v: Array) -> _Tree:
    """Tell a tree in world axes at the world's origin: transforms become identities."""
    one = np.eye(6, dtype=tree.ground.dtype)
    from_world: list[Array] = []
    speed: list[Array] = []
    s, inertia, product = [], [], []
    for j, joint in enumerate(model.joints):
        above = from_world[joint.parent - 1] if joint.parent else one
        from_world.append(tree.x[j].dot(above))
        s.append(_back(from_world[j]).dot(tree.s[j]))
        inertia.append(from_world[j].T.dot(tree.inertia[j]).dot(from_world[j]))
        motion = s[j].dot(v[model.v_start[j] : model.v_start[j] + joint.kind.nv])
        speed.append(motion + (speed[joint.parent - 1] if joint.parent else 0 * motion))
        product.append(_cross_motion(speed[j], motion))
    return _Tree([one] * len(s), s, inertia, speed, product, tree.ground)


def _back(x: Array) -> Array:
    """Return the inverse of a motion transform."""
    turn, below = x[:3, :3].T, x[3:, :3]
    return np.block([[turn, 0 * turn], [-turn.dot(below).dot(turn), turn]])


def _sweep(model: Model, tree: _Tree, tau: Array) -> Array:
    """The recursion as in Featherstone's RBDA, table 7.1."""
    n = len(model.joints)
    body = [i.copy() for i in tree.inertia]
    force = [_cross_force(v, i.dot(v)) for v, i in zip(tree.v, tree.inertia, strict=True)]
    kept: list[tuple[Array, Array, Array]] = [(tau, tau, tau)] * n
    for j in reversed(range(n)):
        s, parent = tree.s[j], model.joints[j].parent
        own = slice(model.v_start[j], model.v_start[j] + s.shape[1])
        u_matrix = body[j].dot(s)
        inverse = _inverse(s.T.dot(u_matrix), model.joints[j].name)
        u = tau[own] - s.T.dot(force[j])
        kept[j] = (u_matrix, inverse, u)
        if parent:
            passed = body[j] - u_matrix.dot(inverse).dot(u_matrix.T)
            bias = force[j] + passed.dot(tree.c[j]) + u_matrix.dot(inverse.dot(u))
            body[parent - 1] = body[parent - 1] + tree.x[j].T.dot(passed).dot(tree.x[j])
            force[parent - 1] = force[parent - 1] + tree.x[j].T.dot(bias)
    result, a = tau.copy(), list[Array]()
    for j in range(n):
        parent, (u_matrix, inverse, u) = model.joints[j].parent, kept[j]
        own = slice(model.v_start[j], model.v_start[j] + tree.s[j].shape[1])
        near = tree.x[j].dot(a[parent - 1] if parent else tree.ground) + tree.c[j]
        result[own] = inverse.dot(u - u_matrix.T.dot(near))
        a.append(near + tree.s[j].dot(result[own]))
    return result


def _inverse(matrix: Array, joint: str) -> Array:
    """Return the inverse of D, by Gauss and Jordan without pivoting: D is positive definite."""
    n = len(matrix)
    work, result = matrix.copy(), matrix - matrix
    for k in range(n):
        result[k, k] = result[k, k] + 1
    for k in range(n):
        if work.dtype != object and not work[k, k] != 0:
            raise FloatingPointError(f'joint "{joint}": D is zero')
        scale = 1 / work[k, k]
        work[k], result[k] = work[k] * scale, result[k] * scale
        for i in range(n):
            if i != k:
                factor = work[i, k]
                work[i], result[i] = work[i] - work[k] * factor, result[i] - result[k] * factor
    return result


def _cross_motion(v: Array, m: Array) -> Array:
    return np.concatenate([cross(v[:3], m[:3]), cross(v[:3], m[3:]) + cross(v[3:], m[:3])])


def _cross_force(v: Array, f: Array) -> Array:
    return np.concatenate([cross(v[:3], f[:3]) + cross(v[3:], f[3:]), cross(v[:3], f[3:])])
