"""Where the numbers of joints lie in the vectors of a solver."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from typing import Any, Literal, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from adagen.errors import JointError, UsageError, printable
from adagen.library.request import Request
from adagen.model import Model
from adagen.plan import Plan

Part = Literal["q", "v", "tau"]


class Described(Protocol):
    """What tells where numbers lie: a robot, its plan, and what was asked for."""

    @property
    def model(self) -> Model:
        """The robot."""

    @property
    def plan(self) -> Plan:
        """What each process computes."""

    @property
    def request(self) -> Request:
        """The options."""


class Vectors:
    """Names, sizes and places of what lies in q, v, tau and accelerations.

    Attributes:
        compiled: what they are vectors of.
    """

    compiled: Described

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints, in the order in which they lie in q and v."""
        return tuple(joint.name for joint in self.compiled.model.joints)

    @property
    def nq(self) -> int:
        """Numbers in q."""
        return self.compiled.model.nq

    @property
    def nv(self) -> int:
        """Numbers in v, and in accelerations."""
        return self.compiled.model.nv

    @property
    def nqdd(self) -> int:
        """Numbers in an answer: accelerations, outputs of a scene, then forces of loops."""
        return self.compiled.plan.nqdd

    @property
    def ntau(self) -> int:
        """Numbers in tau: behind those of the joints, six of each outer force of a scene."""
        return self.compiled.model.ntau

    def force(self, name: str) -> int | slice:
        """Return the index of a loop's or coupling's force in the answer.

        The robot was compiled with ``loop_forces=True``. A loop's is [force; moment] on its link 2
        at frame 2, in the axes of frame 2, N and N m; a coupling's the effort along a coordinate of
        factor 1. Where constraints follow from each other, the one of least squares.

        Args:
            name: of the loop or coupling.

        Raises:
            UsageError: there is no such force.
        """
        plan = self.compiled.plan
        if plan.loop_forces:
            for k, loop in enumerate(plan.loops):
                if loop.name == name:
                    return slice(plan.entry_of_loop(k), plan.entry_of_loop(k) + 6)
            for k, coupling in enumerate(plan.couplings):
                if coupling.name == name:
                    return plan.entry_of_coupling(k)
        raise UsageError(
            f'there is no force of "{printable(name)}": compile with loop_forces=True, and name a '
            "loop or coupling"
        )

    @property
    def dtype(self) -> np.dtype[Any]:
        """The number type; arrays of others are converted."""
        return np.dtype(np.float32 if self.compiled.request.scalar == "float" else np.float64)

    def index(self, joint: str, of: Part = "q") -> int | slice:
        """Return the index or slice of a joint in q or another vector.

        Args:
            joint: its name.
            of: "q", "v" or "tau"; "v" also holds for accelerations.

        Raises:
            JointError: there is no such joint.
        """
        start, count = self._place(joint, of)
        return start if count == 1 else slice(start, start + count)

    def pack(self, values: Mapping[str, ArrayLike], of: Part = "q") -> NDArray[Any]:
        """Return a vector with the values of some joints; the others are at rest.

        Args:
            values: name of a joint to its number, or numbers.
            of: "q", "v" or "tau".

        Returns:
            Shape (nq,), (nv,) or (ntau,); zeros, and unit quaternions, for the other joints.

        Raises:
            JointError: there is no such joint.
            ValueError: a joint, which is named, has another number of values.
        """
        model = self.compiled.model
        size = {"q": self.nq, "v": self.nv, "tau": self.ntau}[_part(of)]
        packed = np.zeros(size, self.dtype)
        if of == "q":
            for joint, start in zip(model.joints, model.q_start, strict=True):
                if joint.kind.nq >= 4:  # a quaternion comes last
                    packed[start + joint.kind.nq - 1] = 1
        for name, value in values.items():
            start, count = self._place(name, of)
            given = np.atleast_1d(np.asarray(value, self.dtype))
            if given.shape != (count,):
                raise ValueError(
                    f'joint "{printable(name)}" has {count} number{"s" * (count > 1)} in {of}, '
                    f"not shape {np.shape(value)}"
                )
            packed[start : start + count] = given
        return packed

    def _place(self, name: str, of: Part) -> tuple[int, int]:
        """The first index and the size of a joint in a vector."""
        model = self.compiled.model
        names = self.joints
        if name not in names:
            near = difflib.get_close_matches(name, names, n=1)
            hint = f' (did you mean "{printable(near[0])}"?)' if near else ""
            raise JointError(f'there is no joint "{printable(name)}"{hint}')
        j = names.index(name)
        if _part(of) == "q":
            return model.q_start[j], model.joints[j].kind.nq
        return model.v_start[j], model.joints[j].kind.nv


def _part(of: str) -> str:
    if of not in ("q", "v", "tau"):
        raise UsageError(f"of is q, v or tau, not {of!r}")
    return of
