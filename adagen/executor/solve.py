"""Carries a plan out in numbers: what its processes compute together, without a compiler."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import SINGULAR, Check
from adagen.executor.machine import RECEIVED
from adagen.executor.run import Simulated, simulate
from adagen.graph import DOUBLE, Algebra, Evaluation
from adagen.model.kinds import KINDS
from adagen.plan.steps import FusedJoin
from adagen.plan.types import Plan

Array = NDArray[Any]


class SingularPoseError(FloatingPointError):
    """A mobility cannot be taken for an inertia: the plan's recovery is to be carried out."""


def interpret(plan: Plan, q: Any, v: Any, tau: Any, algebra: Algebra = DOUBLE) -> Array:
    """Return the joint accelerations that a plan computes.

    Args:
        plan: the plan.
        q: configuration, shape (nq,), or (nq, S) for S states at once.
        v: velocity, shape (nv,) or (nv, S).
        tau: joint torques and forces (prescribed joints: accelerations), then outer forces.
        algebra: what is computed with.

    Returns:
        Accelerations, shape (nv,) or (nv, S).

    Raises:
        PlanError: a process waits for a message that never comes, or reads what it does not have.
        FloatingPointError: a factorization failed; the message names the joint.
    """
    run = Run(plan, {"q": q, "v": v, "tau": tau}, algebra)
    try:
        run.check()
    except SingularPoseError:
        return interpret(plan.recovering(), q, v, tau, algebra)
    return run.accelerations()


class Run:
    """One evaluation of a plan by all its processes.

    Args:
        plan: the plan.
        inputs: numbers by the names of the arrays that inputs are entries of: "q", "v", "tau".
        algebra: what is computed with.
        simulated: the plan's processes, by default as they come from it.
    """

    def __init__(
        self,
        plan: Plan,
        inputs: dict[str, Any],
        algebra: Algebra = DOUBLE,
        simulated: tuple[Simulated, ...] | None = None,
    ) -> None:
        self.plan, self.inputs, self.algebra = plan, inputs, algebra
        self.simulated = simulate(plan) if simulated is None else simulated
        self.circular: dict[int, list[tuple[Any, Any]]] = {}
        self.mail: dict[int, list[Any]] = {}
        self.evaluations = [
            Evaluation(one.machine.graph, self._lookup(p), algebra)
            for p, one in enumerate(self.simulated)
        ]

    def of(self, p: int, expressions: Any) -> Array:
        """Return the values of an array of expressions of process p, in its shape, states last."""
        array = np.asarray(expressions, dtype=object)
        values = self.algebra.together(self.evaluations[p].of(array.flat)) if array.size else array
        return np.asarray(values).reshape(*array.shape, *np.shape(values)[1:])

    def accelerations(self) -> Array:
        """Return the accelerations of all joints, shape (nv,) or (nv, S)."""
        rows: list[Any] = [np.nan] * sum(KINDS[joint.kind].nv for joint in self.plan.joints)
        for process, one, evaluation in zip(
            self.plan.processes, self.simulated, self.evaluations, strict=True
        ):
            for j in process.owns:
                v = self.plan.joints[j].v
                values = one.machine.results[j]
                rows[v : v + len(values)] = evaluation.of(values)
        return np.asarray(self.algebra.together(rows))

    def check(self) -> None:
        """Look at all pivots.

        Raises:
            FloatingPointError: a factorization failed; the message names the joint.
        """
        for one, evaluation in zip(self.simulated, self.evaluations, strict=True):
            checks = one.machine.checks
            values = evaluation.of(x for check in checks for x in (check.pivot, check.least))
            for k, check in enumerate(checks):
                pivot, least = values[2 * k : 2 * k + 2]
                if not np.all(pivot > least):
                    self._fail(check)

    def _fail(self, check: Check) -> None:
        if check.failure == SINGULAR:
            raise SingularPoseError
        names = f'joint "{self.plan.joints[check.joint].name}"'
        if check.failure == "kGimbalLock":
            steps = (step for process in self.plan.processes for step in process.steps)
            run = next(s.run for s in steps if isinstance(s, FusedJoin) and s.joint == check.joint)
            names = "joints " + ", ".join(f'"{self.plan.joints[j].name}"' for j in run)
        raise FloatingPointError(f"{names}: {_SAID[check.failure]}")

    def _lookup(self, p: int) -> Any:
        """Returns inputs of process p by name: the state, sines, what messages bring."""
        machine = self.simulated[p].machine

        def lookup(name: str) -> Any:
            word, *places = name.removesuffix("]").replace("]", "").split("[")
            if word == RECEIVED:
                number, place = map(int, places)
                if number not in self.mail:
                    source = self.plan.messages[number].source
                    sent = self.simulated[source].machine.sent[number]
                    self.mail[number] = self.evaluations[source].of(sent)
                return self.mail[number][place]
            k = int(places[0])
            if word in ("sine", "cosine"):
                if p not in self.circular:
                    angles = self.evaluations[p].of(machine.angles)
                    self.circular[p] = self.algebra.sines_and_cosines(angles)
                return self.circular[p][k][word == "cosine"]
            return self.algebra.given(self.inputs[word][k])

        return lookup


_SAID = {
    "kFactorization": "factorization failed",
    "kGrowth": "no digits left",
    "kGimbalLock": "gimbal lock",
}
