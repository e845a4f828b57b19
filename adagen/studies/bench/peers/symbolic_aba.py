"""The articulated-body algorithm in casadi's symbols, for the code that casadi generates of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from adagen.model import Joint, Model


@dataclass
class _Body:
    """A link in its own frame: velocity, articulated inertia in 3x3 blocks, bias force.

    The inertia is [[A, B], [B^T, C]] on [angular; linear] vectors.
    """

    turn: Any
    place: Any
    w: Any
    v: Any
    A: Any
    B: Any
    C: Any
    bias: Any
    drift: Any
    U: Any = None
    factor: Any = None
    u: Any = None


def forward_dynamics(model: Model, *, exact: bool = True) -> ca.Function:
    """Return casadi's function (q, v, tau) -> qdd of a robot.

    Featherstone's recursion in link frames; zeros are structural, so that casadi drops what is
    multiplied by them, and common sub-expressions are shared.

    Args:
        model: the robot in canonical frames, every joint axis z.
        exact: whether what the projection through a joint makes zero is left out as zero (fewer
            operations, more digits), or computed as textbooks have it.
    """
    q, v, tau = (ca.SX.sym(s, n) for s, n in (("q", model.nq), ("v", model.nv), ("tau", model.nv)))
    bodies: list[_Body | None] = [None]
    for j, joint in enumerate(model.joints):
        own_q = q[model.q_start[j] : model.q_start[j] + joint.kind.nq]
        bodies.append(_outward(model, j, own_q, _rate(model, j, v), bodies[joint.parent]))
    for j in reversed(range(len(model.joints))):
        _inward(model.joints[j], bodies, j, _own(model, j, tau), exact)
    qdd = _accelerations(model, bodies)
    return ca.Function("forward_dynamics", [q, v, tau], [ca.cse(ca.densify(qdd))])


def _own(model: Model, j: int, x: Any) -> Any:
    return x[model.v_start[j] : model.v_start[j] + model.joints[j].kind.nv]


def _rate(model: Model, j: int, v: Any) -> Any:
    """Return a joint's velocity as a spatial one, shape (6, 1)."""
    rate = ca.SX(6, 1)
    for row, value in zip(model.joints[j].kind.free, ca.vertsplit(_own(model, j, v)), strict=True):
        rate[row] = value
    return rate


def _constant(values: Any) -> Any:
    return ca.sparsify(ca.SX(ca.DM(np.asarray(values, dtype=np.float64))))


def _placed(joint: Joint, q: Any) -> tuple[Any, Any]:
    """Return rotation and origin of a child link's frame in its parent's."""
    turn, place = _constant(joint.rotation), _constant(joint.translation)
    kind = joint.kind
    if kind.name == "prismatic":
        return turn, ca.sparsify(place + turn @ ca.vertcat(ca.SX(2, 1), q))
    if kind.name == "floating":
        place = place + turn @ q[:3]
    if kind.name == "planar":
        place = place + turn @ ca.vertcat(q[:2], ca.SX(1, 1))
    if kind.quaternion is not None:
        own = _of_quaternion(q[kind.quaternion :])
    else:
        own = _about_z(q[kind.nq - 1])
    return ca.sparsify(turn @ own), ca.sparsify(place)


def _about_z(angle: Any) -> Any:
    turn = ca.SX(3, 3)
    turn[0, 0] = turn[1, 1] = ca.cos(angle)
    turn[1, 0], turn[0, 1], turn[2, 2] = ca.sin(angle), -ca.sin(angle), 1
    return turn


def _of_quaternion(p: Any) -> Any:
    x, y, z, w = ca.vertsplit(p)
    rows = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    )
    return ca.vertcat(*(ca.horzcat(*row) for row in rows))


def _outward(model: Model, j: int, q: Any, rate: Any, above: _Body | None) -> _Body:
    """Return a link's velocity, bias force and velocity-product acceleration."""
    joint, inertia = model.joints[j], model.links[j + 1].inertia
    turn, place = _placed(joint, q)
    w, v = rate[:3], rate[3:]
    if above is not None:
        w = turn.T @ above.w + w
        v = turn.T @ (above.v + ca.cross(above.w, place)) + v
    drift = ca.sparsify(
        ca.vertcat(ca.cross(w, rate[:3]), ca.cross(v, rate[:3]) + ca.cross(w, rate[3:]))
    )
    arm = ca.skew(_constant(inertia.mass * inertia.com))
    spread = np.eye(3) * float(inertia.com @ inertia.com) - np.outer(inertia.com, inertia.com)
    A = _constant(inertia.tensor + inertia.mass * spread)
    C = _constant(inertia.mass * np.eye(3))
    body = _Body(turn, place, w, v, A, ca.sparsify(arm), C, None, drift)
    moment, momentum = body.A @ w + body.B @ v, body.B.T @ w + body.C @ v
    body.bias = ca.sparsify(
        ca.vertcat(ca.cross(w, moment) + ca.cross(v, momentum), ca.cross(w, momentum))
    )
    return body


def _inward(joint: Joint, bodies: list[_Body | None], j: int, tau: Any, exact: bool) -> None:
    """Project a link's inertia and bias through its joint and hand them to the parent."""
    body, above = bodies[j + 1], bodies[joint.parent]
    assert body is not None
    whole = ca.vertcat(ca.horzcat(body.A, body.B), ca.horzcat(body.B.T, body.C))
    free = list(joint.kind.free)
    body.U = whole[:, free]
    body.factor = _factor(body.U[free, :])
    body.u = tau - body.bias[free]
    if above is None:
        return
    if len(free) == 6 and exact:  # nothing but the joint's own force passes
        inertia, force = ca.SX(6, 6), _scattered(free, tau)
    else:
        inertia = whole - body.U @ _solved(body.factor, body.U.T)
        if exact:
            inertia[free, :], inertia[:, free] = ca.SX(len(free), 6), ca.SX(6, len(free))
        inertia = ca.sparsify(_symmetric(inertia))
        force = body.bias + inertia @ body.drift + body.U @ _solved(body.factor, body.u)
    _hand_on(body, above, inertia, force)


def _scattered(rows: list[int], values: Any) -> Any:
    full = ca.SX(6, 1)
    for k, row in enumerate(rows):
        full[row] = values[k]
    return full


def _symmetric(x: Any) -> Any:
    """Return a matrix from its upper triangle; the lower one is then nobody's work."""
    return ca.triu2symm(ca.triu(x))


def _hand_on(body: _Body, above: _Body, inertia: Any, force: Any) -> None:
    """Add an inertia and a force, moved to the parent's frame, to what the parent has."""
    turn, place = body.turn, body.place
    A = _symmetric(turn @ inertia[:3, :3] @ turn.T)
    B = turn @ inertia[:3, 3:] @ turn.T
    C = _symmetric(turn @ inertia[3:, 3:] @ turn.T)
    cross = ca.sparsify(ca.skew(place))
    moved = ca.sparsify(B + cross @ C)
    above.A = ca.sparsify(above.A + _symmetric(A - B @ cross + cross @ moved.T))
    above.B = ca.sparsify(above.B + moved)
    above.C = ca.sparsify(above.C + C)
    push = turn @ force[3:]
    moment = turn @ force[:3] + cross @ push
    above.bias = ca.sparsify(above.bias + ca.vertcat(moment, push))


def _accelerations(model: Model, bodies: list[_Body | None]) -> Any:
    """Return qdd by the last, outward sweep."""
    at: list[tuple[Any, Any]] = [(ca.SX(3, 1), _constant(-model.gravity))]
    found = []
    for j, joint in enumerate(model.joints):
        body = bodies[j + 1]
        assert body is not None
        alpha, linear = at[joint.parent]
        carried = ca.vertcat(
            body.turn.T @ alpha, body.turn.T @ (linear + ca.cross(alpha, body.place))
        )
        carried = ca.sparsify(carried + body.drift)
        own = _solved(body.factor, body.u - body.U.T @ carried)
        found.append(own)
        total = carried + _scattered(list(joint.kind.free), own)
        at.append((total[:3], total[3:]))
    return ca.vertcat(*found)


def _factor(D: Any) -> list[list[Any]]:
    """Return L of L diag(d) L^T = D with 1/d on its diagonal."""
    n = D.shape[0]
    L: list[list[Any]] = [[None] * n for _ in range(n)]
    for k in range(n):
        L[k][k] = 1 / (D[k, k] - sum(L[k][m] ** 2 / L[m][m] for m in range(k)))
        for i in range(k + 1, n):
            L[i][k] = (D[i, k] - sum(L[i][m] * L[k][m] / L[m][m] for m in range(k))) * L[k][k]
    return L


def _solved(L: list[list[Any]], right: Any) -> Any:
    """Return D^-1 right from D's factor."""
    rows = ca.vertsplit(right)
    n = len(rows)
    for i in range(n):
        rows[i] = rows[i] - sum((L[i][m] * rows[m] for m in range(i)), ca.SX(1, right.shape[1]))
    for i in reversed(range(n)):
        back = (L[m][i] * rows[m] for m in range(i + 1, n))
        rows[i] = rows[i] * L[i][i] - sum(back, ca.SX(1, right.shape[1]))
    return ca.vertcat(*rows)
