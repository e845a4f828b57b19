"""What emitted solvers answer in hard states, beside the truth: right, refused, wrong."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

import numpy as np

from adagen.build import Toolchain
from adagen.model import Model
from adagen.plan import Plan
from adagen.search.objective import FEW, predicted_digits
from adagen.states import States
from adagen.studies.stability.audit import WRONG, Array, Way, planned, solved, source_of, truths


@dataclass(frozen=True)
class Wrong:
    """An answer that is wrong without a failure or a warning.

    Attributes:
        robot: its name.
        way: how it was solved.
        state: number of the state.
        error: of the answer, relative to the largest acceleration.
    """

    robot: str
    way: Way
    state: int
    error: float


@dataclass(frozen=True)
class Audit:
    """The outcomes of all evaluations of one variant.

    Attributes:
        counts: answered, refused, and of the answered ones wrong.
        wrong: the wrong ones.
        warned: whether few digits are predicted, so that emission warns.
    """

    counts: Counter[str]
    wrong: tuple[Wrong, ...]
    warned: bool


def warned(model: Model, plan: Plan, way: Way) -> bool:
    """Whether so few digits are predicted of a plan that its emission warns."""
    try:
        found = predicted_digits("both", model, plan, way.shape)
    except FloatingPointError:
        return True
    return found.anywhere > FEW[way.scalar]


def audited(
    model: Model, states: States, ways: list[Way], toolchain: Toolchain
) -> dict[Way, Audit]:
    """Solve states of a robot in some ways and compare with the truth.

    Where the inertia matrix is singular, every answer is wrong. States of floats are rounded to
    floats for the truth, too.

    Raises:
        EnvironmentFault: a solver cannot be built.
    """
    found: dict[Way, Audit] = {}
    known: dict[str, list[Array | None]] = {}
    for way in ways:
        plan = planned(model, way)
        if plan is None:
            continue
        if way.scalar not in known:
            known[way.scalar] = truths(model, states.read_in(way.scalar))
        counts: Counter[str] = Counter()
        wrong: list[Wrong] = []
        found_ones = solved(source_of(plan, way), plan, states, toolchain)
        for k, (answer, truth) in enumerate(zip(found_ones, known[way.scalar], strict=True)):
            if answer is None:
                counts["refused"] += 1
                continue
            counts["answered"] += 1
            error = np.inf
            if truth is not None:
                error = float(np.abs(answer - truth).max() / max(np.abs(truth).max(), 1e-300))
            if not error <= WRONG[way.scalar]:
                counts["wrong"] += 1
                wrong.append(Wrong(model.name, way, k, error))
        found[way] = Audit(counts, tuple(wrong), warned(model, plan, way))
    return found
