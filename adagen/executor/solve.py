"""Carries a plan out in numbers, without a compiler."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import SINGULAR, Check
from adagen.executor.lanes import Grouping
from adagen.executor.machine import RECEIVED, Machine
from adagen.executor.run import Simulated, after_all_steps
from adagen.executor.state import Refining
from adagen.executor.straight import simulate, straight_line
from adagen.graph import DOUBLE, Algebra, Evaluation, Numbers
from adagen.graph.evaluate import in_lanes
from adagen.graph.numbers import of_each
from adagen.plan.steps import FusedJoin
from adagen.plan.types import Plan

Array = NDArray[Any]
Lanes = bool | Grouping
"""Whether limbs may share a straight line where that is less work, or which limbs do."""


class SingularPoseError(FloatingPointError):
    """A mobility cannot be inverted: the plan's recovery steps are needed."""

    def __init__(self) -> None:
        super().__init__("a mobility is singular in this pose")


def interpret(
    plan: Plan,
    q: Any,
    v: Any,
    tau: Any,
    algebra: Algebra = DOUBLE,
    *,
    once: bool = False,
    lanes: Lanes = False,
) -> Array:
    """Return the joint accelerations that a plan computes.

    Args:
        plan: the plan.
        q: configuration, shape (nq,), or (nq, S) for S states at once.
        v: velocity, shape (nv,) or (nv, S).
        tau: joint torques and forces (prescribed joints: accelerations), then outer forces.
        algebra: what is computed with.
        once: whether to compute in double at once, without graphs (see ``Run``).
        lanes: whether limbs may share a straight line, as they may in emitted code, or which do.

    Returns:
        Accelerations, outputs and forces of loops, shape (nqdd,) or (nqdd, S); NaN where they are
        not wanted.

    Raises:
        PlanError: a process waits for a message that never comes, or reads what it does not have.
        FloatingPointError: a factorization failed; the message names the joint.
    """
    run = Run(plan, {"q": q, "v": v, "tau": tau}, algebra, once=once, lanes=lanes)
    try:
        run.check()
    except SingularPoseError:
        return interpret(plan.recovering(), q, v, tau, algebra, once=once, lanes=bool(lanes))
    return run.accelerations()


def _line(plan: Plan, refining: Refining, lanes: Lanes) -> tuple[Simulated, ...]:
    if refining is not None:
        return simulate(plan, refining=refining)
    return straight_line(plan, lanes=lanes) if isinstance(lanes, bool) else simulate(plan, lanes)


class Run:
    """One evaluation of a plan by all its processes.

    Args:
        plan: the plan.
        inputs: numbers by the names of the arrays that inputs are entries of: "q", "v", "tau"; and
            "parameter", if they are not as in the plan.
        algebra: what is computed with.
        refining: what of iterative refinement is computed, if any.
        once: whether to compute in double at once, without graphs. It is the faster way where a
            plan is carried out a few times; last digits are others.
        lanes: whether limbs may share a straight line, or which do; not in refinement, nor at once.

    Attributes:
        machines: one for each process, after all its steps.
    """

    def __init__(
        self,
        plan: Plan,
        inputs: dict[str, Any],
        algebra: Algebra = DOUBLE,
        refining: Refining = None,
        *,
        once: bool = False,
        lanes: Lanes = False,
    ) -> None:
        self.plan, self.algebra, self.once = plan, algebra, once
        self.inputs = {"parameter": plan.parameter_values, **inputs}
        self._circular: dict[int, list[tuple[Any, Any]]] = {}
        self._mail: dict[int, list[Any]] = {}
        lookups = [self._lookup(p) for p in range(len(plan.processes))]
        self.machines: list[Machine] = []
        if once:
            mail: dict[int, list[Any]] = {}
            self.machines += [
                Machine(plan, mail, refining, Numbers(look), steps=process.steps)
                for look, process in zip(lookups, plan.processes, strict=True)
            ]
            with np.errstate(all="ignore"):  # pivots are looked at afterwards
                after_all_steps(plan, self.machines)
        else:
            self.machines += [one.machine for one in _line(plan, refining, lanes)]
        self._evaluations = [
            Evaluation(machine.graph, lookup, algebra)
            for machine, lookup in zip(self.machines, lookups, strict=True)
        ]

    def _values(self, p: int, expressions: Iterable[Any]) -> list[Any]:
        if self.once:
            return [number.x for number in expressions]
        return self._evaluations[p].of(expressions)

    def of(self, p: int, expressions: Any) -> Array:
        """Return the values of an array of expressions of process p, in its shape, states last."""
        array = np.asarray(expressions, dtype=object)
        values = self.algebra.together(self._values(p, array.flat)) if array.size else array
        return np.asarray(values).reshape(*array.shape, *np.shape(values)[1:])

    def accelerations(self) -> Array:
        """Return qdd, shape (nqdd,) or (nqdd, S): NaN for joints of which it is not wanted."""
        rows: list[Any] = [self.algebra.given(np.nan)] * self.plan.nqdd
        for p, (process, machine) in enumerate(
            zip(self.plan.processes, self.machines, strict=True)
        ):
            for j in set(process.owns) & machine.results.keys():
                lanes = machine.lanes_of_result(j)
                for k, value in enumerate(self._values(p, machine.results[j])):
                    for each, x in zip(lanes, in_lanes(value, len(lanes)), strict=True):
                        if self.plan.wants(each):
                            rows[self.plan.joints[each].v + k] = x
            for place, output in machine.outputs.items():
                first = self.plan.entry_of_output(place)
                rows[first : first + len(output)] = self._values(p, output)
            for first, force in machine.forces.items():
                rows[first : first + len(force)] = self._values(p, force)
        return np.asarray(self.algebra.together(rows))

    def check(self, *, digits: bool = True) -> None:
        """Check all pivots, in the order of processes and their steps.

        Args:
            digits: whether a pivot that has lost its digits is refused, as emitted code does, or
                only what is not positive.

        Raises:
            FloatingPointError: a factorization failed; the message names the joint.
        """
        for p, machine in enumerate(self.machines):
            checks = machine.checks
            values = self._values(p, (x for c in checks for x in (c.pivot, c.least)))
            for k, check in enumerate(checks):
                pivot, least = values[2 * k : 2 * k + 2]
                if not digits and check.failure in ("kFactorization", "kGrowth"):
                    least = 0
                wide = isinstance(pivot, tuple)
                own = machine.rows.own(check.joint) if wide else (check.joint,)
                pairs = zip(own, in_lanes(pivot, len(own)), in_lanes(least, len(own)), strict=False)
                for joint, x, y in pairs:
                    if not np.all(x > y):
                        self._fail(check, joint)

    def _fail(self, check: Check, joint: int) -> None:
        if check.failure == SINGULAR:
            raise SingularPoseError
        names = self.plan.place(joint)
        if check.failure == "kGimbalLock":
            fused = self.plan.steps_of(FusedJoin)
            run = next(step.run for step in fused if step.joint == check.joint)
            names = "joints " + ", ".join(f'"{self.plan.joints[j].name}"' for j in run)
        raise FloatingPointError(f"{names}: {_SAID[check.failure]}")

    def _lookup(self, p: int) -> Callable[[str], Any]:
        """What returns inputs of process p by name: the state, sines, what messages bring."""

        def lookup(name: str) -> Any:
            word, *places = name.removesuffix("]").replace("]", "").split("[")
            if word == RECEIVED:
                return self._received(*map(int, places))
            if word in ("sine", "cosine"):
                return self._sine_and_cosine(p, int(places[0]))[word == "cosine"]
            if word == "tangent":
                return self._tangent(p, int(places[0]))
            given = self.algebra.given(self.inputs[word][int(places[0])])
            return float(given) if self.once and np.ndim(given) == 0 else given

        return lookup

    def _received(self, number: int, place: int) -> Any:
        if number not in self._mail:
            source = self.plan.messages[number].source
            self._mail[number] = self._values(source, self.machines[source].sent[number])
        return self._mail[number][place]

    def _sine_and_cosine(self, p: int, k: int) -> tuple[Any, Any]:
        angles = self.machines[p].angles
        if self.once:
            angle = angles[k].x  # type: ignore[attr-defined]
            return of_each(math.sin, angle), of_each(math.cos, angle)
        if p not in self._circular:
            self._circular[p] = self.algebra.sines_and_cosines(self._values(p, angles))
        return self._circular[p][k]

    def _tangent(self, p: int, k: int) -> Any:
        rate, factor = self._values(p, self.machines[p].tangents[k])
        if self.once:
            return of_each(math.tanh, rate * factor)
        return self.algebra.tanh(rate * factor)


_SAID = {
    "kFactorization": "factorization failed",
    "kGrowth": "no digits left",
    "kGimbalLock": "gimbal lock",
    "kLoopOpen": "it is open",
    "kLoopTorn": "the velocity violates it",
    "kLoopSingular": "singular pose",
    "kLoopFree": "it can move without inertia",
}
