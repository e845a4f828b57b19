"""Joint-space inertia by composite rigid bodies (Walker and Orin 1982), and the dense solve."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.model import Model
from adagen.reference.kinematics import Body, Placement, bodies, placements
from adagen.reference.numbers import Numbers, Numeric, cross_matrix

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Composite:
    """A link and all below it as one rigid body, about the link's origin.

    Attributes:
        mass: kg.
        moment: first moment of mass, shape (3,), kg m.
        tensor: rotational inertia about the origin, shape (3, 3), kg m^2.
    """

    mass: Any
    moment: Numeric
    tensor: Numeric

    @staticmethod
    def of(body: Body) -> Composite:
        """Return a single link."""
        k = cross_matrix(body.com)
        return Composite(body.mass, body.com * body.mass, body.tensor - k.dot(k) * body.mass)

    def seen_from_parent(self, place: Placement) -> Composite:
        """Return the same body expressed in the parent link's frame and about its origin."""
        turned = place.rotation.dot(self.moment)
        about = place.rotation.dot(self.tensor).dot(place.rotation.T)
        k, h = cross_matrix(place.position), cross_matrix(turned)
        about = about - k.dot(h) - h.dot(k) - k.dot(k) * self.mass
        return Composite(self.mass, turned + place.position * self.mass, about)

    def __add__(self, other: Composite) -> Composite:
        """Return both bodies as one."""
        return Composite(
            self.mass + other.mass, self.moment + other.moment, self.tensor + other.tensor
        )


def inertia_matrix(numbers: Numbers, model: Model, q: Numeric) -> Numeric:
    """Return the joint-space inertia, shape (nv, nv), slaved joints counting as independent.

    Args:
        numbers: the kind of number that q holds.
        model: the robot.
        q: configuration, shape (nq,).
    """
    placed = placements(numbers, model, q)
    whole = [Composite.of(body) for body in bodies(numbers, model)]
    # Per link, of each degree of freedom at or below it: its index, and force and moment on the
    # link (3, k) that hold what is below in a unit acceleration of that degree of freedom alone.
    below: list[list[tuple[list[int], Numeric, Numeric]]] = [[] for _ in placed]
    result = numbers.zeros(model.nv, model.nv)
    for j in reversed(range(len(placed))):
        place, joint, body = placed[j], model.joints[j], whole[j]
        own = list(range(model.v_start[j], model.v_start[j] + joint.kind.nv))
        k = cross_matrix(body.moment)
        force = place.linear * body.mass - k.dot(place.angular)
        moment = body.tensor.dot(place.angular) + k.dot(place.linear)
        groups = [(own, force, moment), *below[j]]
        columns = [column for group in groups for column in group[0]]
        force = np.hstack([group[1] for group in groups])
        moment = np.hstack([group[2] for group in groups])
        block = place.angular.T.dot(moment) + place.linear.T.dot(force)
        block[:, : len(own)] = (block[:, : len(own)] + block[:, : len(own)].T) / 2
        rotor = numbers.array(np.eye(len(own)) * joint.passive.rotor_inertia)
        block[:, : len(own)] = block[:, : len(own)] + rotor
        result[np.ix_(own, columns)] = block
        result[np.ix_(columns, own)] = block.T
        if joint.parent:
            force = place.rotation.dot(force)
            moment = place.rotation.dot(moment) + cross_matrix(place.position).dot(force)
            below[joint.parent - 1].append((columns, force, moment))
            whole[joint.parent - 1] += body.seen_from_parent(place)
    return result


def cholesky_solve(matrix: Array, right: Array, names: list[str]) -> Array:
    """Solve matrix x = right by Cholesky after scaling the diagonal to one.

    Args:
        matrix: symmetric, shape (n, n).
        right: shape (n,).
        names: joint of each row, for the message.

    Raises:
        InputError: the matrix is not positive definite in double precision; names the joint at
            which the motion without inertia shows.
    """
    n = len(right)
    diagonal = np.diagonal(matrix)
    for row in range(n):
        if not 0 < diagonal[row] < np.inf:
            raise InputError(singular(names[row]))
    scale = 1 / np.sqrt(diagonal)
    factor = matrix * np.outer(scale, scale)
    for k in range(n):
        # Rounding leaves a pivot of up to n eps where the exact one is zero.
        if not factor[k, k] > n * np.finfo(np.float64).eps:
            raise InputError(singular(names[k]))
        factor[k:, k] /= np.sqrt(factor[k, k])
        factor[k + 1 :, k + 1 :] -= np.outer(factor[k + 1 :, k], factor[k + 1 :, k])
    x = right * scale
    for k in range(n):
        x[k] = (x[k] - factor[k, :k].dot(x[:k])) / factor[k, k]
    for k in reversed(range(n)):
        x[k] = (x[k] - factor[k + 1 :, k].dot(x[k + 1 :])) / factor[k, k]
    return np.asarray(x * scale)


def singular(joint: str) -> str:
    """Return the message about a joint-space inertia that cannot be inverted."""
    return (
        f"joint '{joint}': the joint-space inertia is singular: a motion of this joint (with "
        "those before it) moves no mass; give the links that it moves an inertia"
    )
