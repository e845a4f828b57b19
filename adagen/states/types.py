"""States of a model, and the columns of each joint in them."""

from __future__ import annotations

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
