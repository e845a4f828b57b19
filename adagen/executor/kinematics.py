"""Kinematics over expressions: frames, velocities, and the reference field with its wrenches."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from adagen.executor.frames import Dense, Rotation, Transform, Turn, about_z, placed, plus_cross
from adagen.executor.state import State
from adagen.graph import Expression, dot, matrix_times, total
from adagen.model.kinds import KINDS, JointKind
from adagen.plan.split_rods import RodHalf

Array = NDArray[Any]


class CarriedHalf(Protocol):
    """A rod half whose inertia counts to the link that carries it (split_rods.py).

    Attributes:
        half: the link.
    """

    half: RodHalf

    def inertia_at_carrier(self, own: Array) -> Array:
        """Return its inertia at the other half's link, shape (6, 6)."""

    def push_on(self, number: int) -> Array:
        """Return the effect of its ball's torques on the other half, or on the ball's near link."""


@dataclass(frozen=True)
class Field:
    """A link's velocity and reference acceleration, in its own frame.

    Attributes:
        omega: angular velocity, shape (3,).
        alpha: angular acceleration, shape (3,).
        a: acceleration of the origin relative to free fall, shape (3,).
        gradient: H = alpha x + omega x omega x, shape (3, 3): a point at r accelerates by a + H r.
        up: the ground's acceleration relative to free fall, shape (3,); None where nobody asks.
    """

    omega: Array
    alpha: Array
    a: Array
    gradient: Array
    up: Array | None = None


class Motion:
    """Executes kinematics on a process's memory; links' wrenches in the reference field."""

    def __init__(self, state: State) -> None:
        self.state = state
        self.rod_halves: tuple[CarriedHalf, ...] = ()
        self._inertias: dict[int, Array] = {}  # of links alone: each is asked for twice

    def _kind(self, j: int) -> JointKind:
        """A joint's kind, and whether its motion is prescribed."""
        return KINDS[self.state.plan.joints[j].kind]

    def kinematics(self, j: int) -> None:
        """Placement of a joint's child link, its velocity and its reference acceleration."""
        joint, kind = self.state.plan.joints[j], self._kind(j)
        x, motion = self.placed(j)
        self.state.memory["X", j] = x
        self._advance(j, x, motion[:3], motion[3:])
        if joint.prescribed:
            drift = self.state.memory.get(("drift", j), self.state.zeros(6)).copy()
            drift[list(kind.free)] = drift[list(kind.free)] + self.state.given(j)
            self.state.memory["drift", j] = drift

    def placed(self, j: int) -> tuple[Transform, Array]:
        """Return the pose of a joint's child link in its parent's frame, and its joint velocity."""
        q, v = self.state.configuration(j)
        base = self.state.rows.of_joint(j, lambda joint: joint.rotation)
        turn, shift = self._placement(j, q)
        origin = self.state.rows.of_joint(j, lambda joint: joint.translation)
        if shift is not None:
            origin = np.array(
                [total([origin[k], *(base[k] * shift)]) for k in range(3)], dtype=object
            )
        x = Transform(placed(base, turn, across=j in self.state.rows), origin)
        motion = self.state.zeros(6)
        motion[list(self._kind(j).free)] = v
        return x, motion

    def placement_of(self, j: int) -> Array:
        """Return the pose of a joint's child link in its parent's frame, shape (12,).

        Its orientation by rows, and its origin.
        """
        x: Transform = self.state.memory["X", j]
        units = (self.state.constants([float(i == k) for i in range(3)]) for k in range(3))
        rotation = np.array([x.rotation.vector(unit) for unit in units]).T
        return np.concatenate([rotation.ravel(), x.origin])

    def take_placement(self, j: int, pose: Array) -> None:
        """Take the pose of a joint's child link from another process that knows it."""
        rotation = Rotation((Dense(pose[:9].reshape(3, 3)),))
        self.state.memory["X", j] = Transform(rotation, pose[9:])

    def _placement(self, j: int, q: list[Expression]) -> tuple[Turn | Dense | None, Array | None]:
        """Rotation and shift of the child frame in the canonical joint frame; None for none."""
        kind, zero = self._kind(j), self.state.graph.constant(0)
        if kind.quaternion is not None:
            shift = np.array(q[:3], dtype=object) if kind.quaternion else None
            return Dense(self._orientation(j, q[kind.quaternion :])), shift
        if kind.name == "prismatic":
            return None, np.array([zero, zero, q[0]], dtype=object)
        shift = np.array([q[0], q[1], zero], dtype=object) if kind.name == "planar" else None
        return about_z(*self.state.circular(q[-1]), exact=self.state.turns_exactly(j)), shift

    def _orientation(self, j: int, quaternion: list[Expression]) -> Array:
        """Rotation matrix of a quaternion (x, y, z, w) of any length."""
        squared = total(part * part for part in quaternion)
        self.state.lengths.append((squared, j))
        scale = 2 * self.state.graph.reciprocal(squared)
        x, y, z, w = quaternion
        sx, sy, sz = scale * x, scale * y, scale * z
        return np.array(
            [
                [1 - (sy * y + sz * z), sx * y - sz * w, sx * z + sy * w],
                [sx * y + sz * w, 1 - (sx * x + sz * z), sy * z - sx * w],
                [sx * z - sy * w, sy * z + sx * w, 1 - (sx * x + sy * y)],
            ],
            dtype=object,
        )

    def _advance(self, j: int, x: Transform, turning: Array, sliding: Array) -> None:
        """Velocity and reference acceleration of a joint's child link."""
        parent = self.state.plan.joints[j].parent
        back = x.rotation.transposed()
        if parent == 0 and self._kind(j).name == "floating":
            # It falls freely: gravity then enters its own acceleration only, at the very end.
            omega, alpha, a = turning, self.state.zeros(3), self.state.zeros(3)
            ground = back.vector(self.state.upwards())
            self.state.memory["drift", j] = np.concatenate(
                [self.state.zeros(3), plus_cross(ground, omega, sliding)]
            )
        else:
            above = self._above(j)
            turned = back.vector(above.omega)
            omega = turned + turning
            alpha = plus_cross(back.vector(above.alpha), turned, turning)
            carried = [total([above.a[k], *(above.gradient[k] * x.origin)]) for k in range(3)]
            a = back.vector(np.array(carried, dtype=object))
            a = plus_cross(plus_cross(a, turned + turned, sliding), turning, sliding)
        up = None
        if self.state.asks_up:
            high = self._above(j).up  # of a row, some lanes may be on the ground, others not
            assert high is not None  # it is kept of all links, or of none
            up = back.vector(high)
        self.state.memory["field", j + 1] = Field(omega, alpha, a, gradient_of(omega, alpha), up)

    def _above(self, j: int) -> Field:
        """The field of a joint's parent link; for a row, of the parent links in all lanes."""
        return self.field_of_all(self.state.rows.near_links(j))

    def field_of_all(self, links: Sequence[int]) -> Field:
        """Return the field of links, one for each lane."""
        if links[0] > 0 and self.state.rows.as_kept(links):
            kept: Field = self.state.memory["field", links[0]]
            return kept
        fields = {link: self.field_of(link) for link in dict.fromkeys(links)}
        if len(fields) == 1:
            return fields[links[0]]
        omega, alpha, a = (
            self.state.rows.packed([getattr(fields[link], name) for link in links])
            for name in ("omega", "alpha", "a")
        )
        ups = [fields[link].up for link in links]
        up = None if ups[0] is None else self.state.rows.packed(ups)  # type: ignore[arg-type]
        return Field(omega, alpha, a, gradient_of(omega, alpha), up)

    def field_of(self, link: int) -> Field:
        """Return the field of a link, the ground or one of a row among them."""
        if link == 0:
            return self.ground()
        kept, k = self.state.rows.kept("field", link)
        field: Field = kept
        if k is None:
            return field
        parts = [field.omega, field.alpha, field.a, field.gradient]
        parts += [] if field.up is None else [field.up]
        return Field(*(self.state.rows.lane(part, k) for part in parts))

    def ground(self) -> Field:
        """Return the field of the ground, which is held against free fall."""
        nothing = self.state.zeros(3)
        up = self.state.upwards()
        return Field(
            nothing, nothing, up, self.state.zeros(3, 3), up if self.state.asks_up else None
        )

    def drift(self, j: int) -> Array | None:
        """Relative acceleration of a joint's sides beyond reference field and S qdd; None for zero.

        Where qdd is prescribed, S qdd is that.
        """
        drift = self.state.memory.get(("drift", j))
        return None if drift is None else self.state.column(drift)

    def link_inertia(self, number: int) -> Array:
        """Spatial inertia at the link's origin, shape (6, 6): constant, but for what can be set.

        That of links that hang counts to those that carry them.
        """
        if any(number == each.half.link for each in self.rod_halves):
            return self.state.zeros(6, 6)
        inertia = self._own_inertia(number)
        for each in self.rod_halves:
            if number == each.half.carrier:
                inertia = inertia + each.inertia_at_carrier(self._own_inertia(each.half.link))
        return inertia

    def _own_inertia(self, number: int) -> Array:
        """Spatial inertia of a link alone."""
        known = self._inertias.get(number)
        if known is not None:
            return known.copy()
        c, mass = self.state.rows.com(number), self.state.rows.mass(number)
        zero = self.state.graph.constant(0)
        m = c * mass
        mx = np.array([[zero, -m[2], m[1]], [m[2], zero, -m[0]], [-m[1], m[0], zero]])
        inertia = self.state.zeros(6, 6)
        inertia[:3, 3:], inertia[3:, :3] = mx, mx.T
        about_com = self.state.rows.of_link(number, lambda link: link.tensor)
        for i in range(3):
            inertia[3 + i, 3 + i] = mass
            for k in range(3):
                outer = dot(m, c) - m[i] * c[i] if i == k else -(m[i] * c[k])
                inertia[i, k] = about_com[i, k] + outer
        self._inertias[number] = inertia
        return inertia.copy()

    def link_force(self, number: int) -> Array:
        """Wrench that the reference field needs of the link alone: [moment; force], shape (6,).

        The moment I alpha + omega x I omega + m c x a, the products in H being used again; less
        what outer forces do for it. In refinement the opposite of what is left over.
        """
        if self.state.refining == "correction":
            left = [self.state.graph.input(f"rho[{6 * number + k}]") for k in range(6)]
            return -np.array(left, dtype=object)
        if self.state.left is not None:
            return self.state.left.of_link(number)
        return self.field_force(number)

    def field_force(self, number: int) -> Array:
        """Wrench that the reference field needs, less outer forces; shape (6,)."""
        field: Field = self.state.memory["field", number]
        inertia = self.link_inertia(number)
        mass = inertia[3, 3]
        moment_of_mass = np.array([inertia[2, 4], inertia[0, 5], inertia[1, 3]], dtype=object)
        h, moment = field.gradient, []
        for i in range(3):
            k, m = (i + 1) % 3, (i + 2) % 3
            terms = [
                field.alpha[i] * inertia[i, i],
                (field.omega[k] * field.omega[m]) * (inertia[m, m] - inertia[k, k]),
                -(h[m, i] * inertia[i, k]),
                h[k, i] * inertia[i, m],
                (h[k, k] - h[m, m]) * inertia[k, m],
            ]
            moment.append(total(terms))
        moment_of_force = plus_cross(np.array(moment, dtype=object), moment_of_mass, field.a)
        force = [total([field.a[k] * mass, *(h[k] * moment_of_mass)]) for k in range(3)]
        whole = np.concatenate([moment_of_force, np.array(force, dtype=object)])
        for push in self.pushes(number):
            whole = whole - push
        for each in self.rod_halves:
            if number in (each.half.link, each.half.carrier):
                whole = whole - each.push_on(number)
        return whole

    def pushes(self, number: int) -> Iterator[Array]:
        """Outer wrenches on a link, or on the links of a row, one in each lane."""
        each = [self._pushes(j + 1) for j in self.state.rows.lanes(number - 1)]
        for lanes in zip_longest(*each, fillvalue=self.state.zeros(6)):
            yield self.state.rows.packed(lanes)

    def _pushes(self, number: int) -> Iterator[Array]:
        """Outer wrenches [moment; force] on a link at its origin, shape (6,)."""
        plan, state = self.state.plan, self.state
        for k, wrench in enumerate(plan.wrenches):
            if wrench.link == number:
                first = plan.entry_of_wrench(k)
                given = [state.graph.input(f"tau[{first + i}]") for i in range(6)]
                turn = state.constants(wrench.rotation)
                force = matrix_times(turn, np.array(given[:3], dtype=object))
                moment = matrix_times(turn, np.array(given[3:], dtype=object))
                place = state.constants(wrench.translation)
                yield np.concatenate([plus_cross(moment, place, force), force])


def gradient_of(omega: Array, alpha: Array) -> Array:
    """Return H = alpha x + omega x omega x, shape (3, 3)."""
    h = np.empty((3, 3), dtype=object)
    squares = omega * omega
    for i in range(3):
        k, m = (i + 1) % 3, (i + 2) % 3
        h[i, i] = -(squares[k] + squares[m])
        product = omega[i] * omega[k]
        h[i, k], h[k, i] = product - alpha[m], product + alpha[m]
    return h
