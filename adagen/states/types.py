"""States of a model, and the columns of each joint in them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from adagen.model import Joint, Model

Array = NDArray[np.float64]

FIELDS = ("q", "v", "tau")
PRESCRIBED = ("q", "v", "qdd")


@dataclass(frozen=True, eq=False)
class States:
    """Some states of a model, in the model's order of joints.

    Attributes:
        q: configurations, shape (S, nq); quaternions (x, y, z, w) nearly of unit length.
        v: velocities, shape (S, nv).
        tau: torques and forces (of prescribed joints: accelerations), then outer forces, shape
            (S, ntau).
    """

    q: Array
    v: Array
    tau: Array

    @property
    def count(self) -> int:
        """How many states there are, S."""
        return len(self.q)

    @property
    def parts(self) -> tuple[Array, Array, Array]:
        """Its three arrays: q, v and tau of all states."""
        return self.q, self.v, self.tau

    @property
    def each(self) -> Iterator[tuple[Array, Array, Array]]:
        """The states one after the other, q, v and tau of each."""
        return zip(*self.parts, strict=True)

    def some(self, rows: slice | Sequence[int] | Array) -> States:
        """Return those of some rows."""
        return States(*(part[rows] for part in self.parts))

    def stored(self, scalar: str) -> list[Array]:
        """Return q, v and tau as a solver in "double" or "float" takes them in memory."""
        number = np.float64 if scalar == "double" else np.float32
        return [np.ascontiguousarray(part, number) for part in self.parts]

    def read_in(self, scalar: str) -> States:
        """Return what a solver in "double" or "float" reads of them."""
        if scalar == "double":
            return self
        return States(*(part.astype(np.float32).astype(np.float64) for part in self.parts))


def fields_of(joint: Joint) -> tuple[str, str, str]:
    """Return the members that a joint's state has in a file."""
    return PRESCRIBED if joint.prescribed else FIELDS


def wrench_columns(model: Model, k: int) -> slice:
    """Return the columns of tau that hold the model's outer force ``k``."""
    return slice(model.nv + 6 * k, model.nv + 6 * k + 6)


def columns(model: Model, j: int, field: str) -> slice:
    """Return the columns of joint ``j`` in q, or those in v, tau and qdd."""
    kind = model.joints[j].kind
    if field == "q":
        return slice(model.q_start[j], model.q_start[j] + kind.nq)
    return slice(model.v_start[j], model.v_start[j] + kind.nv)
