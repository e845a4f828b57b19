"""A model's constants as a plan needs them: canonical frames, inverse inertias."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import asdict
from functools import lru_cache

import numpy as np

from adagen.errors import InputError
from adagen.exact import Exact, exact, identity, rounded, skew
from adagen.graph import cross
from adagen.model import Inertia, Model, Passive, canonical
from adagen.plan.robot import PlanCoupling, PlanJoint, PlanLink, PlanLoop, PlanOutput, PlanWrench

WAY_OUT = (
    "joining it as a link of its own inverts its inertia: use a schedule that adagen finds, or form"
    " segment without a cut beside it, give it mass and rotational inertia about three axes, or"
    " make one of its joints fixed"
)


def links_of(model: Model, inverted: Collection[int]) -> tuple[PlanLink, ...]:
    """Return the constants of a model's links, with the inverse inertias of some.

    Raises:
        InputError: the inertia of such a link cannot be inverted.
    """
    links = [_ground(model.links[0].name)]
    for k, link in enumerate(canonical(model).links[1:], start=1):
        mass, com, tensor = link.inertia.mass, link.inertia.com, link.inertia.tensor
        inverse: tuple[tuple[float, ...], ...] = ()
        phi: tuple[tuple[float, ...], ...] = ()
        if k in inverted:
            inverse, phi = map(_rows, inverse_inertia(link.inertia, link.name))
        links.append(PlanLink(link.name, mass, _tuple(com), _rows(tensor), inverse, phi))
    return tuple(links)


@lru_cache(maxsize=4)  # asked for by every plan that a search tries
def joints_of(model: Model) -> tuple[PlanJoint, ...]:
    """Return the constants of a model's joints in canonical frames."""
    robot = canonical(model)
    return tuple(
        PlanJoint(
            joint.name,
            joint.kind.name,
            joint.parent,
            robot.q_start[j],
            robot.v_start[j],
            _rows(joint.rotation),
            _tuple(joint.translation),
            None
            if joint.mimic is None
            else (joint.mimic.source, joint.mimic.multiplier, joint.mimic.offset),
            **asdict(Passive() if joint.prescribed else joint.passive),
            prescribed=joint.prescribed,
        )
        for j, joint in enumerate(robot.joints)
    )


def wrenches_of(model: Model) -> tuple[PlanWrench, ...]:
    """Return a model's outer forces in canonical frames."""
    return tuple(
        PlanWrench(
            wrench.frame.name,
            wrench.link,
            _rows(wrench.frame.rotation),
            _tuple(wrench.frame.translation),
        )
        for wrench in (canonical(model).wrenches if model.wrenches else ())
    )


def outputs_of(model: Model) -> tuple[PlanOutput, ...]:
    """Return the outputs of a model beside accelerations, in canonical frames."""
    return tuple(
        PlanOutput(
            output.what,
            output.name,
            output.link,
            _rows(output.frame.rotation),
            _tuple(output.frame.translation),
        )
        for output in (canonical(model).outputs if model.outputs else ())
    )


def loops_of(model: Model) -> tuple[PlanLoop, ...]:
    """Return a model's loop joints in canonical frames."""
    return tuple(
        PlanLoop(
            loop.name,
            loop.kind.name,
            loop.link1,
            _rows(loop.frame1.rotation),
            _tuple(loop.frame1.translation),
            loop.link2,
            _rows(loop.frame2.rotation),
            _tuple(loop.frame2.translation),
            loop.tolerance,
            loop.turn2,
        )
        for loop in (canonical(model).loops if model.loops else ())
    )


def couplings_of(model: Model) -> tuple[PlanCoupling, ...]:
    """Return a model's couplings."""
    return tuple(PlanCoupling(c.name, c.terms, c.offset, c.tolerance) for c in model.couplings)


def inverse_inertia(inertia: Inertia, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Return J = Ic^-1 (3x3) and Phi = I^-1 (6x6) of a link at its origin.

    I^-1 = [[J, -J cx], [cx J, 1/m - cx J cx]] with c the centre of mass: no cancellation with the
    mass, and finite for a light link. Units 1/(kg m^2) and, below right, 1/kg.

    Raises:
        InputError: the inertia is singular; the message names the link and the way out.
    """
    if inertia.mass <= 0.0:
        raise InputError(f'link "{name}" has no mass; {WAY_OUT}')
    tensor = exact(inertia.tensor)
    if not _positive_definite(tensor):
        raise InputError(f'link "{name}" has a singular rotational inertia; {WAY_OUT}')
    inverse = _inverse3(tensor)
    c = skew(exact(inertia.com))
    phi = np.empty((6, 6), dtype=object)
    phi[:3, :3] = inverse
    phi[:3, 3:] = -inverse.dot(c)
    phi[3:, :3] = c.dot(inverse)
    phi[3:, 3:] = identity() / exact(inertia.mass).item() - c.dot(inverse).dot(c)
    return rounded(inverse), rounded((phi + phi.T) / 2)


def _positive_definite(tensor: Exact) -> bool:
    """Whether a symmetric 3x3 tensor is positive definite by more than the rounding of its entries.

    The pivots of Cholesky's factorization, relative to the diagonal, say how many digits are left.
    """
    a = tensor.copy()
    for k in range(3):
        diagonal = float(tensor[k, k])
        if not (diagonal > 0.0 and float(a[k, k]) > 1e-14 * diagonal):
            return False
        for i in range(k + 1, 3):
            for j in range(k + 1, 3):
                a[i, j] = a[i, j] - a[i, k] * a[k, j] / a[k, k]
    return True


def _inverse3(a: Exact) -> Exact:
    cofactors = np.array([cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1])], dtype=object)
    inverse: Exact = cofactors.T / a[0].dot(cofactors[0])
    return inverse


def _ground(name: str) -> PlanLink:
    zero = (0.0, 0.0, 0.0)
    return PlanLink(name, 0.0, zero, (zero, zero, zero), (), ())


def _tuple(values: Sequence[float] | np.ndarray) -> tuple[float, ...]:
    return tuple(float(x) + 0.0 for x in values)


def _rows(matrix: np.ndarray) -> tuple[tuple[float, ...], ...]:
    return tuple(_tuple(row) for row in matrix)
