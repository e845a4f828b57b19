"""The ways to compute the same accelerations: algorithm, schedule, scalar, processes, ..."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import get_args

from adagen.calibrate.schedules import random_schedule
from adagen.emit import emit, program_of
from adagen.emit.refine import LEAST_MIXED_STEPS
from adagen.emit.shapes import BASELINES
from adagen.errors import UsageError
from adagen.model import Model
from adagen.plan import SCALARS, Plan, make_plan
from adagen.program import Program
from adagen.schedule import Schedule, Topology, load_profile
from adagen.schedule.tree import Named
from adagen.search import best_schedule, named_schedule

NAMES = {
    "crba": "CRBA",
    "aba": "ABA, textbook",
    "aba_exact": "ABA, exact projection",
    "ada": "form ada",
    "segment": "form segment",
}
"""Algorithms, and what pictures call them."""

REFINEMENTS = {
    "double": (0, 1, 2),
    "float": (0, 1, 2),
    "mixed": (LEAST_MIXED_STEPS, LEAST_MIXED_STEPS + 1),
}
"""Steps of refinement of each scalar in a chart, unless others are asked for."""

SCHEDULES = ("auto", "balanced", "sequential", "random")
_SEED = 1  # of the random schedule


@dataclass(frozen=True)
class Variant:
    """A way to compute the accelerations.

    Attributes:
        algorithm: a key of ``NAMES``.
        schedule: one of ``SCHEDULES``; "auto" is searched.
        scalar: "double", "float" or "mixed".
        processes: P.
        refine: steps of iterative refinement.
        shape: shape of the code; "auto" is what the compiler chooses.
    """

    algorithm: str
    schedule: str = "auto"
    scalar: str = "double"
    processes: int = 1
    refine: int = 0
    shape: str = "auto"

    @property
    def baseline(self) -> bool:
        """Whether this is a textbook algorithm, not what adagen is for."""
        return self.algorithm in BASELINES

    @property
    def label(self) -> str:
        """A name that tells it from all others."""
        words = [NAMES[self.algorithm]]
        words += [self.shape] if self.shape != "auto" else []
        words += [self.schedule] if self.schedule != "auto" else []
        words += [self.scalar] if self.scalar != "double" else []
        words += [f"P={self.processes}"] if self.processes > 1 else []
        words += [f"refined {self.refine}x"] if self.refine else []
        return ", ".join(words)

    def plan(self, model: Model, source_hash: str = "") -> tuple[Schedule, Plan]:
        """Return its schedule and plan of a robot.

        Raises:
            AdagenError: the robot cannot be treated so.
        """
        form = "segment" if self.baseline else self.algorithm
        schedule = schedule_of(model, self, form)
        plan = make_plan(model, schedule, form=form, scalar=self.scalar, source_hash=source_hash)
        return schedule, plan

    def program(self, plan: Plan) -> Program:
        """Return what is emitted of its plan.

        Raises:
            UsageError: the plan cannot be emitted so.
        """
        return program_of(plan, self.algorithm if self.baseline else self.shape, self.refine)

    def files(self, plan: Plan, name: str | None = None, svg: str | None = None) -> dict[str, str]:
        """Return what is emitted of its plan, file name to text.

        Raises:
            UsageError: the plan cannot be emitted so.
        """
        shape = self.algorithm if self.baseline else self.shape
        return emit(plan, name=name, svg=svg, shape=shape, refine=self.refine)


REFERENCE = Variant("segment")
"""The serial articulated-body solver, to which times are told as ratios."""


def every_variant(
    processes: Sequence[int] = (1, 2, 4),
    scalars: Sequence[str] = SCALARS,
    refinements: Sequence[int] | None = None,
    shapes: Sequence[str] = ("auto",),
    *,
    whole: bool = False,
) -> list[Variant]:
    """Return what a chart holds, the reference first.

    Schedules are varied in double without refinement, and refinement on the searched schedule,
    unless the ``whole`` product is asked for. A schedule makes no difference in form segment on one
    process, and baselines have neither schedule nor processes nor refinement, without which there
    is no mixed solver. That takes those of the ``refinements`` asked for that are enough for it, or
    as few as it can.
    """
    unrefined = [scalar for scalar in scalars if scalar != "mixed"]
    found = [REFERENCE, *(Variant(name, scalar=s) for name in BASELINES for s in unrefined)]
    for form in ("segment", "ada"):
        for p in processes:
            schedules = SCHEDULES if p > 1 or form == "ada" else SCHEDULES[:1]
            for scalar in scalars:
                plain = Variant(form, scalar=scalar, processes=p)
                found += [replace(plain, shape=shape) for shape in shapes if scalar in unrefined]
                refined = [replace(plain, refine=n) for n in _steps(scalar, refinements) if n]
                rescheduled = [replace(plain, schedule=s) for s in schedules[1:]]
                found += refined
                if whole:
                    found += [replace(r, schedule=s.schedule) for r in refined for s in rescheduled]
                if scalar in unrefined and (whole or scalar == "double"):
                    found += rescheduled
    return list(dict.fromkeys(found))


def _steps(scalar: str, asked: Sequence[int] | None) -> Sequence[int]:
    """Return the steps of refinement of a scalar in a chart."""
    if asked is None:
        return REFINEMENTS[scalar]
    if scalar != "mixed":
        return asked
    return [n for n in asked if n >= LEAST_MIXED_STEPS] or [LEAST_MIXED_STEPS]


def schedule_of(model: Model, variant: Variant, form: str) -> Schedule:
    """Return a variant's schedule.

    Raises:
        AdagenError: there is none.
    """
    profile = load_profile("default")
    if variant.schedule == "auto":
        # Shape kernels alone lets processes gather, and has no refinement.
        gather = not variant.refine and variant.shape in ("auto", "kernels")
        return best_schedule(model, variant.processes, profile, form, variant.scalar, gather=gather)
    topology = Topology.of(model)
    costs = profile.joins_only() if form == "ada" else profile
    if variant.schedule == "random":
        return random_schedule(topology, variant.processes, costs, _SEED, mixed=True)
    if variant.schedule in get_args(Named):
        name: Named = variant.schedule  # type: ignore[assignment]
        return named_schedule(name, topology, variant.processes, profile=costs)
    raise UsageError(f"unknown schedule '{variant.schedule}': expected {', '.join(SCHEDULES)}")
