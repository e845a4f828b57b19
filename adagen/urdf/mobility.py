"""Whether the joint-space inertia H is positive definite, and which joints move no mass.

Forward dynamics is well posed exactly where H is positive definite: no motion leaves every massive
link at rest. H = L D L^T where the blocks of D are those of the articulated-body recursion
(Featherstone, Rigid Body Dynamics Algorithms, 2008, section 7.3): one pass from the leaves tells,
without forming H. A pivot of D is compared with the diagonal of H for the same degree of freedom,
the composite inertia: their ratio is the part of it that is left when all outer joints give way.

The recursion runs in 256-bit numbers at generic configurations, so that a ratio that is zero shows
as 1e-70 and one that is merely small as what it is. The rows and columns of a joint's own motion
are set to zero exactly (N^T [...] N), without which chains of spherical joints lose all digits.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from flint import arb, arb_mat, ctx

from adagen.model import Inertia, Joint, Model, canonical

BITS = 256
SINGULAR = 1e-14
"""In double precision a ratio below this cannot be distinguished from zero."""

AT_REST = 1e-9
"""Beside a joint that moves by 1 (rad/s^2 or m/s^2), one that moves less than this is at rest."""

TINY = 1e-100
"""kg m^2 or kg: an articulated inertia below this has no inverse to compute with."""

CONFIGURATIONS = 3


@dataclass(frozen=True)
class Mobility:
    """The weakest degree of freedom of a robot.

    Attributes:
        joint: index of the joint that has it.
        ratio: its articulated inertia over its composite inertia, in (-inf, 1].
        moving: indices of the joints that take part in the motion that meets so little inertia,
            in depth-first order; ``joint`` is the first.
    """

    joint: int
    ratio: float
    moving: tuple[int, ...]

    @property
    def singular(self) -> bool:
        """Whether double precision cannot tell this inertia from zero (or it is negative)."""
        return self.ratio < SINGULAR


def weakest(model: Model) -> Mobility:
    """Return the weakest degree of freedom, at the best of a few generic configurations.

    Args:
        model: at least one joint; mimic joints count as independent.
    """
    upright = canonical(model)
    with ctx.workprec(BITS):
        best = _Recursion(upright, 0).weakest()
        for k in range(1, CONFIGURATIONS):
            if not best.singular:
                break
            other = _Recursion(upright, k).weakest()
            best = other if other.ratio > best.ratio else best
    return best


class _Recursion:
    """One articulated-body pass, from the leaves to the root.

    Stops at the first joint whose block of D is singular: what is below it is complete, so that
    the motion without inertia can be named.
    """

    def __init__(self, model: Model, configuration: int) -> None:
        self.model = model
        n = len(model.joints)
        articulated = [spatial_inertia(link.inertia) for link in model.links]
        composite = [spatial_inertia(link.inertia) for link in model.links]
        self.motion = [arb_mat(6, 6)] * n
        self.gain = [arb_mat(0, 6)] * n  # D^-1 U^T
        self.worst = Mobility(0, 1.0, (0,))
        for j in range(n - 1, -1, -1):
            joint = model.joints[j]
            if not joint.prescribed:
                ratio, direction = self._pivots(joint, articulated[j + 1], composite[j + 1])
                if ratio < self.worst.ratio:
                    moving = self._moving(j, direction) if ratio < SINGULAR else (j,)
                    self.worst = Mobility(j, ratio, moving)
                    if ratio < SINGULAR:
                        return
            self.motion[j] = x = motion_transform(joint, j, configuration)
            below = (
                articulated[j + 1] if joint.prescribed else self._projected(j, articulated[j + 1])
            )
            articulated[joint.parent] += (x.transpose() * below * x).mid()
            composite[joint.parent] += (x.transpose() * composite[j + 1] * x).mid()

    def weakest(self) -> Mobility:
        """Return the weakest degree of freedom that was met."""
        return self.worst

    def _pivots(self, joint: Joint, articulated: Any, composite: Any) -> tuple[float, list[Any]]:
        """Return the least ratio in a joint's block of D and the direction that it belongs to.

        D = L diag(pivots) L^T; the direction d solves L^T d = unit vector, so that d^T D d is the
        pivot.
        """
        free, rotor = joint.kind.free, arb(joint.passive.rotor_inertia)
        n = len(free)
        d = [[articulated[r, c] + (rotor if r == c else 0) for c in free] for r in free]
        lower = [[arb(int(i == k)) for k in range(n)] for i in range(n)]
        worst, at = 2.0, 0
        for k in range(n):
            scale = composite[free[k], free[k]] + rotor
            usable = scale > 0 and abs(float(d[k][k])) > TINY
            ratio = float(d[k][k] / scale) if usable else 0.0
            if ratio < worst:
                worst, at = ratio, k
            if ratio < SINGULAR:
                break
            for i in range(k + 1, n):
                lower[i][k] = (d[i][k] / d[k][k]).mid()
                for c in range(k + 1, n):
                    d[i][c] = (d[i][c] - lower[i][k] * d[k][c]).mid()
        direction = [arb(int(i == at)) for i in range(n)]
        for i in range(at - 1, -1, -1):
            direction[i] = -sum((lower[m][i] * direction[m] for m in range(i + 1, at + 1)), arb(0))
        return worst, direction

    def _projected(self, j: int, articulated: Any) -> Any:
        """Return what the parent feels of a link's articulated inertia; remember D^-1 U^T."""
        kind, rotor = self.model.joints[j].kind, self.model.joints[j].passive.rotor_inertia
        free, n = kind.free, kind.nv
        u = arb_mat(6, n, [articulated[r, c] for r in range(6) for c in free])
        d = arb_mat(n, n, [articulated[r, c] for r in free for c in free])
        for k in range(n):
            d[k, k] += arb(rotor)
        self.gain[j] = d.solve(u.transpose()).mid()
        below = (articulated - u * self.gain[j]).mid()
        for row in () if rotor else free:
            for k in range(6):
                below[row, k] = below[k, row] = arb(0)
        return (below + below.transpose()) / 2

    def _moving(self, j: int, direction: list[Any]) -> tuple[int, ...]:
        """Return the joints that take part when joint j moves and all outer joints give way."""
        acceleration: dict[int, Any] = {j + 1: arb_mat(6, 1)}
        for row, value in zip(self.model.joints[j].kind.free, direction, strict=True):
            acceleration[j + 1][row, 0] = value
        moving = [j]
        for c in range(j + 1, len(self.model.joints)):
            joint = self.model.joints[c]
            if joint.parent not in acceleration:
                continue
            a = (self.motion[c] * acceleration[joint.parent]).mid()
            if joint.prescribed:
                acceleration[c + 1] = a
                continue
            qdd = -(self.gain[c] * a).mid()
            if any(abs(float(qdd[i, 0])) > AT_REST for i in range(joint.kind.nv)):
                moving.append(c)
            for i, row in enumerate(joint.kind.free):
                a[row, 0] += qdd[i, 0]
            acceleration[c + 1] = a
        return tuple(moving)


def spatial_inertia(inertia: Inertia) -> Any:
    """Return the 6x6 inertia [angular; linear] about the link's origin."""
    m = arb(inertia.mass)
    c = _cross([arb(x) for x in inertia.com.tolist()])
    mc = c * m
    top = arb_mat(3, 3, [arb(x) for x in inertia.tensor.reshape(-1).tolist()]) - mc * c
    return _blocks(top, mc, mc.transpose(), arb_mat(3, 3, [m, 0, 0, 0, m, 0, 0, 0, m])).mid()


def _cross(v: list[Any]) -> Any:
    return arb_mat(3, 3, [0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0])


def _blocks(a: Any, b: Any, c: Any, d: Any) -> Any:
    result = arb_mat(6, 6)
    for i in range(3):
        for k in range(3):
            result[i, k], result[i, k + 3] = a[i, k], b[i, k]
            result[i + 3, k], result[i + 3, k + 3] = c[i, k], d[i, k]
    return result


def _generic(j: int, configuration: int, component: int) -> float:
    """Return a number in (0.1, 0.9), the same on every machine, with no pattern in j."""
    golden = 0.6180339887498949 * (7 * j + 3 * component + 1) + 0.3819 * configuration
    return 0.1 + 0.8 * (golden % 1.0)


def motion_transform(joint: Joint, j: int, configuration: int) -> Any:
    """Return the 6x6 motion transform from the parent link's frame to the child's, axis z."""
    value = [_generic(j, configuration, k) for k in range(6)]
    turn = arb_mat(3, 3, [1, 0, 0, 0, 1, 0, 0, 0, 1])
    for k, row in enumerate(joint.kind.free):
        if row < 3:
            turn = turn * _turn(row, 2.5 * value[k])
    shift = arb_mat(3, 1)
    for k, row in enumerate(joint.kind.free):
        if row >= 3:
            shift[row - 3, 0] = arb(value[k])
    rotation = arb_mat(3, 3, [arb(x) for x in joint.rotation.reshape(-1).tolist()])
    origin = arb_mat(3, 1, [arb(x) for x in joint.translation.tolist()]) + rotation * shift
    e = (rotation * turn).transpose()
    lower = -(e * _cross([origin[0, 0], origin[1, 0], origin[2, 0]]))
    return _blocks(e, arb_mat(3, 3), lower, e).mid()


def _turn(axis: int, angle: float) -> Any:
    """Return the rotation about a coordinate axis."""
    sine, cosine = arb(angle).sin_cos()
    result = arb_mat(3, 3)
    a, b = (axis + 1) % 3, (axis + 2) % 3
    result[axis, axis] = arb(1)
    result[a, a] = result[b, b] = cosine
    result[a, b], result[b, a] = -sine, sine
    return result
