"""The weakest degree of freedom of a robot with slaved joints, from the whole inertia matrix.

Slaved velocities are qd = G u with the independent velocities u, so that the robot's inertia is
G^T H G. Where H is positive definite so is this; where H is singular it may still be, because a
joint that moves no mass of its own can be driven by another one.
"""

from __future__ import annotations

from typing import Any

from flint import arb, arb_mat, ctx

from adagen.model import Model, canonical
from adagen.urdf.mobility import (
    AT_REST,
    BITS,
    CONFIGURATIONS,
    SINGULAR,
    TINY,
    Mobility,
    motion_transform,
    spatial_inertia,
)


def weakest_slaved(model: Model) -> Mobility:
    """Return the weakest independent degree of freedom, at the best of a few configurations.

    Time grows with (number of joints) x (depth): use ``weakest`` first, which needs no matrix.

    Args:
        model: mimic joints count as slaved.
    """
    upright = canonical(model)
    with ctx.workprec(BITS):
        best = _weakest_at(upright, 0)
        for k in range(1, CONFIGURATIONS):
            if not best.singular:
                break
            best = max(best, _weakest_at(upright, k), key=lambda mobility: mobility.ratio)
    return best


def _weakest_at(model: Model, configuration: int) -> Mobility:
    return _weakest_of(reduced(model, inertia_matrix(model, configuration)), model)


def inertia_matrix(model: Model, configuration: int) -> Any:
    """Return the joint-space inertia, nv x nv, by composite rigid bodies (Featherstone, 6.2).

    Args:
        model: with every joint axis z.
        configuration: which of the generic configurations.
    """
    n = len(model.joints)
    composite = [spatial_inertia(link.inertia) for link in model.links]
    motion = [motion_transform(joint, j, configuration) for j, joint in enumerate(model.joints)]
    result = arb_mat(model.nv, model.nv)
    for j in range(n - 1, -1, -1):
        joint = model.joints[j]
        force = _columns(composite[j + 1], joint.kind.free)
        i, at = j, joint
        while True:
            for a, row in enumerate(at.kind.free):
                for b in range(joint.kind.nv):
                    r, c = model.v_start[i] + a, model.v_start[j] + b
                    result[r, c] = result[c, r] = force[row, b]
            if at.parent == 0:
                break
            force = (motion[i].transpose() * force).mid()
            i = at.parent - 1
            at = model.joints[i]
        x = motion[j]
        composite[joint.parent] += (x.transpose() * composite[j + 1] * x).mid()
        for row in range(model.v_start[j], model.v_start[j] + joint.kind.nv):
            result[row, row] += arb(joint.passive.rotor_inertia)
    return result


def reduced(model: Model, inertia: Any) -> Any:
    """Return G^T H G, in which only independent joints have rows."""
    g = _gear(model)
    return (g.transpose() * inertia * g).mid()


def _columns(matrix: Any, which: tuple[int, ...]) -> Any:
    return arb_mat(6, len(which), [matrix[r, c] for r in range(6) for c in which])


def _independent(model: Model) -> list[tuple[int, int]]:
    """Return (joint, row in v) of each degree of freedom that is neither slaved nor prescribed."""
    return [
        (j, model.v_start[j] + k)
        for j, joint in enumerate(model.joints)
        if joint.mimic is None and not joint.prescribed
        for k in range(joint.kind.nv)
    ]


def _gear(model: Model) -> Any:
    free = _independent(model)
    column = {row: c for c, (_, row) in enumerate(free)}
    g = arb_mat(model.nv, len(free))
    for _, row in free:
        g[row, column[row]] = arb(1)
    for j, joint in enumerate(model.joints):
        if joint.mimic is not None:
            source = column[model.v_start[joint.mimic.source]]
            g[model.v_start[j], source] = arb(joint.mimic.multiplier)
    return g


def _weakest_of(matrix: Any, model: Model) -> Mobility:
    """Return the least pivot over diagonal, eliminating from the last row up."""
    n = matrix.nrows()
    m = [[matrix[i, k] for k in range(n)] for i in range(n)]
    factor: dict[int, list[Any]] = {}
    owner = [joint for joint, _ in _independent(model)]
    worst = Mobility(owner[0], 1.0, (owner[0],))
    for k in range(n - 1, -1, -1):
        usable = matrix[k, k] > 0 and abs(float(m[k][k])) > TINY
        ratio = float(m[k][k] / matrix[k, k]) if usable else 0.0
        if ratio < worst.ratio:
            worst = Mobility(owner[k], ratio, (owner[k],))
        if ratio < SINGULAR:
            return Mobility(owner[k], ratio, _moving(k, factor, owner, n))
        factor[k] = [(m[k][i] / m[k][k]).mid() for i in range(k)]
        for i in range(k):
            for c in range(k):
                m[i][c] = (m[i][c] - factor[k][i] * m[k][c]).mid()
    return worst


def _moving(k: int, factor: dict[int, list[Any]], owner: list[int], n: int) -> tuple[int, ...]:
    """Return the joints that move when row k moves by 1 and the rows below it are free."""
    value = [arb(0)] * n
    value[k] = arb(1)
    for i in range(k + 1, n):
        value[i] = -sum((factor[i][c] * value[c] for c in range(k, i)), arb(0)).mid()
    others = {owner[i] for i in range(k + 1, n) if abs(float(value[i])) > AT_REST}
    return (owner[k], *sorted(others - {owner[k]}))
