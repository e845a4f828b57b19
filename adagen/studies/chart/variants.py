"""The ways to compute the same accelerations: algorithm, schedule, scalar, processes, ..."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import get_args

from adagen.calibrate.schedules import random_schedule
from adagen.emit import emit, program_of
from adagen.emit.shapes import BASELINES
from adagen.errors import UsageError
from adagen.executor import Grouping
from adagen.model import Model
from adagen.plan import SCALARS, Plan, make_plan
from adagen.plan.certificate import certified
from adagen.program import Program
from adagen.schedule import Schedule, Topology, load_profile
from adagen.schedule.tree import Named
from adagen.search import named_schedule
from adagen.search.objective import schedule_for, suited_shape

ALGORITHMS = ("crba", "aba", "aba_exact", "ada", "segment")
METHODS = {
    "straight": "straight line",
    "loops": "loops",
    "batches": "batch of states",
    "reproducible": "reproducible line",
    "joints": "joint by joint (the paper's form)",
    "articulated": "textbook articulated bodies",
    "composite": "textbook composite bodies",
}
"""Methods of charts, and what pictures call them: each is a line."""

REFINEMENTS = (0, 1)
"""Steps of refinement in a chart, unless others are asked for."""

SHAPES = ("auto", "kernels", "unrolled")
_OF_SHAPE = {"kernels": "loops", "unrolled": "straight"}
_OF_BASELINE = {"aba": "articulated", "aba_exact": "articulated", "crba": "composite"}
_TIMES = {1: "once", 2: "twice"}
SCHEDULES = ("auto", "balanced", "sequential", "random")
_SEED = 1  # of the random schedule


@dataclass(frozen=True)
class Variant:
    """A way to compute the accelerations.

    Attributes:
        algorithm: one of ``ALGORITHMS``.
        schedule: one of ``SCHEDULES``; "auto" is searched.
        scalar: "double" or "float".
        processes: P.
        refine: steps of iterative refinement.
        shape: shape of the code; "auto" is what the compiler chooses.
        batch: whether many states are solved at once, one in each SIMD lane.
        reproducible: whether the last digits are the same on every machine.
        lanes: whether limbs that are alike may share code, one in each SIMD lane.
        objective: what the schedule and the shape are searched for.
        certify: whether a bound of its error comes with each answer.
    """

    algorithm: str
    schedule: str = "auto"
    scalar: str = "double"
    processes: int = 1
    refine: int = 0
    shape: str = "auto"
    batch: bool = False
    reproducible: bool = False
    lanes: bool = True
    objective: str = "both"
    certify: bool = False

    @property
    def baseline(self) -> bool:
        """Whether this is a textbook algorithm, not what adagen is for."""
        return self.algorithm in BASELINES

    @property
    def label(self) -> str:
        """A name that tells it from all others."""
        words = [self._named]
        words += ["limbs one by one"] * (not self.lanes)
        words += [f"schedule {self.schedule}"] if self.schedule != "auto" else []
        words += [self.scalar] if self.scalar != "double" else []
        words += [f"{self.processes} processes"] if self.processes > 1 else []
        times = _TIMES.get(self.refine, f"{self.refine} times")
        words += [f"refined {times}"] if self.refine else []
        words += ["certified"] * self.certify
        words += [f"for {self.objective}"] if self.objective != "both" else []
        return ", ".join(words)

    @property
    def _named(self) -> str:
        """What it is called without number type and processes."""
        if self.baseline:
            exact = ", exact projection" if self.algorithm == "aba_exact" else ""
            return METHODS[_OF_BASELINE[self.algorithm]] + exact
        if self.reproducible:
            return METHODS["reproducible"]
        found = "default" if self.shape == "auto" else METHODS[_OF_SHAPE[self.shape]]
        if self.algorithm == "ada":
            found = METHODS["joints"] + f", {self.shape}" * (self.shape != "auto")
        return f"{METHODS['batches']}, {found}" if self.batch else found

    def method(self, plan: Plan) -> str:
        """Return the method that its points are drawn by, a key of ``METHODS``.

        Raises:
            UsageError: the plan cannot be emitted so.
        """
        if self.baseline:
            return _OF_BASELINE[self.algorithm]
        if self.batch:
            return "batches"
        if self.reproducible:
            return "reproducible"
        return "joints" if self.algorithm == "ada" else _OF_SHAPE[self.program(plan).shape]

    def plan(self, model: Model, source_hash: str = "") -> tuple[Schedule, Plan]:
        """Return its schedule and plan of a robot.

        Raises:
            AdagenError: the robot cannot be treated so.
        """
        form = "segment" if self.baseline else self.algorithm
        schedule = schedule_of(model, self, form)
        plan = make_plan(
            model,
            schedule,
            form=form,
            scalar=self.scalar,
            source_hash=source_hash,
            reproducible=self.reproducible,
        )
        return schedule, certified(plan) if self.certify else plan

    def _shape(self, plan: Plan) -> str:
        if self.baseline:
            return self.algorithm
        return self.shape if self.batch else suited_shape(self.objective, plan, self.shape)

    def _limbs(self, plan: Plan) -> Grouping | None:
        return None if self.lanes else tuple(() for _ in plan.processes)

    def program(self, plan: Plan) -> Program:
        """Return what is emitted of its plan.

        Raises:
            UsageError: the plan cannot be emitted so.
        """
        return program_of(
            plan, self._shape(plan), self.refine, batch=self.batch, limbs=self._limbs(plan)
        )

    def files(self, plan: Plan, name: str | None = None, svg: str | None = None) -> dict[str, str]:
        """Return what is emitted of its plan, file name to text.

        Raises:
            UsageError: the plan cannot be emitted so.
        """
        return emit(
            plan,
            name=name,
            svg=svg,
            shape=self._shape(plan),
            refine=self.refine,
            batch=int(self.batch),
            limbs=self._limbs(plan),
        )


REFERENCE = Variant("segment")
"""The serial articulated-body solver, to which times are given as ratios."""


def every_variant(
    processes: Sequence[int] = (1, 2, 4),
    scalars: Sequence[str] = SCALARS,
    refinements: Sequence[int] = REFINEMENTS,
    shapes: Sequence[str] = SHAPES,
    schedules: Sequence[str] = SCHEDULES[:1],
    objective: str = "both",
    *,
    whole: bool = False,
) -> list[Variant]:
    """Return the variants of a chart, the reference first.

    Shapes are varied on the searched schedule without refinement; refinement on one process, unless
    the ``whole`` product is asked for; further schedules in double without refinement, likewise. A
    schedule makes no difference in form segment on one process, and baselines have neither schedule
    nor processes nor refinement.
    """
    found = [REFERENCE, *(Variant(name, scalar=s) for name in BASELINES for s in scalars)]
    for form in ("segment", "ada"):
        for p in processes:
            for scalar in scalars:
                plain = Variant(form, scalar=scalar, processes=p)
                own = shapes if form == "segment" else ("auto",)
                found += [replace(plain, shape=shape) for shape in own]
                steps = refinements if whole or p == min(processes) else ()
                refined = [replace(plain, refine=n) for n in steps if n]
                more = [s for s in schedules if s != "auto" and (p > 1 or form == "ada")]
                rescheduled = [replace(plain, schedule=s) for s in more]
                found += refined
                if whole:
                    found += [replace(r, schedule=s.schedule) for r in refined for s in rescheduled]
                if whole or scalar == "double":
                    found += rescheduled
    if 1 in processes:
        found += _of_one_process(scalars, shapes)
    aimed = [v if v.baseline else replace(v, objective=objective) for v in found]
    return list(dict.fromkeys([REFERENCE, *aimed]))


def _of_one_process(scalars: Sequence[str], shapes: Sequence[str]) -> list[Variant]:
    """Batches, reproducible and certified solvers, and limbs one by one."""
    named = [shape for shape in shapes if shape in ("kernels", "unrolled")]
    found = []
    for scalar in scalars:
        plain = Variant("segment", scalar=scalar)
        found += [replace(plain, shape=shape, batch=True) for shape in named]
        found += [replace(plain, reproducible=True)]
        found += [replace(plain, shape=shape, certify=True) for shape in named]
        found += [replace(plain, shape=s, lanes=False) for s in named if scalar == "double"]
    return found


def schedule_of(model: Model, variant: Variant, form: str) -> Schedule:
    """Return a variant's schedule.

    Raises:
        AdagenError: there is none.
    """
    profile = load_profile("default")
    if variant.schedule == "auto":
        # Shape kernels alone lets processes gather, and has no refinement.
        gather = not variant.refine and variant.shape in ("auto", "kernels")
        return schedule_for(
            variant.objective,
            model,
            variant.processes,
            profile,
            form,
            variant.scalar,
            gather=gather,
        )
    topology = Topology.of(model)
    costs = profile.joins_only() if form == "ada" else profile
    if variant.schedule == "random":
        return random_schedule(topology, variant.processes, costs, _SEED, mixed=True)
    if variant.schedule in get_args(Named):
        name: Named = variant.schedule  # type: ignore[assignment]
        return named_schedule(name, topology, variant.processes, profile=costs)
    raise UsageError(f"unknown schedule '{variant.schedule}': expected {', '.join(SCHEDULES)}")
