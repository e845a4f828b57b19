"""Bounds of errors that emitted solvers tell, beside the errors that their answers have."""

from __future__ import annotations

import ctypes
import json
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from flint import ctx
from numpy.typing import NDArray

from adagen.build import Toolchain, build_executable
from adagen.emit import emit, stem_of
from adagen.errors import AdagenError, UsageError
from adagen.executor.refine import WideLinks
from adagen.executor.solve import interpret
from adagen.graph import BALLS
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.certificate import certified, has_inner_root, looped
from adagen.program.strips import LANES
from adagen.run import launch
from adagen.schedule import load_profile
from adagen.schedule.tree import Gathered
from adagen.search.base_gathering import alone_schedule, certified_layouts
from adagen.states import States, write_states
from adagen.studies.stability.audit import truths
from adagen.studies.stability.loaded import loaded
from benchmarks.stability.mechanisms import BITS

Array = NDArray[np.float64]
FACTOR = 3.0
"""By how much an error may exceed its bound."""


@dataclass(frozen=True)
class Certified:
    """How a robot is solved.

    Attributes:
        shape: "kernels" or "unrolled".
        batch: whether states are solved many at once.
        scalar: "double" or "float".
        processes: threads that share the robot, whether that pays or not; of a batch, processes
            of MPI that process 0 hands states out to.
        elsewhere: whether two threads gather elsewhere than at the base or the ground.
        parts: whether one process has a chain in parts, one in each SIMD lane.
        looped: rows of joints whose residuals a loop sweeps in a straight line, where that can be.
    """

    shape: str
    batch: bool = False
    scalar: str = "double"
    processes: int = 1
    elsewhere: bool = False
    parts: bool = False
    looped: int = 0

    def __str__(self) -> str:
        words = [self.shape] + ["batch"] * self.batch
        words += [f"P = {self.processes}"] * (self.processes > 1) + ["elsewhere"] * self.elsewhere
        words += ["in parts"] * self.parts
        words += ["in a loop"] * (self.looped > 0)
        return ", ".join(words + [self.scalar] * (self.scalar != "double"))


@dataclass(frozen=True, eq=False)
class Bounded:
    """Answered states.

    Attributes:
        errors: true relative errors in the energy norm, shape (S,).
        bounds: those of the solver, shape (S,).
        refused: how many states were not answered, or have no answer.
    """

    errors: Array
    bounds: Array
    refused: int

    @property
    def ratios(self) -> Array:
        """Errors relative to their bounds, shape (S,)."""
        return np.where(self.errors > 0, self.errors / self.bounds, 0.0)


def certified_plan(
    model: Model, scalar: str = "double", processes: int = 1, *, parts: bool = False
) -> Plan:
    """Return the certified plan of one process, or of threads that share the robot.

    Args:
        model: the robot.
        scalar: "double" or "float".
        processes: how many.
        parts: whether one process has a chain in parts, if it is long enough.

    Raises:
        AdagenError: the robot has none.
    """
    alone = alone_schedule(model, processes, load_profile("default"))
    alone = replace(alone, parts=LANES[scalar]) if parts else alone
    plan = certified(make_plan(model, alone, scalar=scalar))
    if processes == 1:
        return plan
    layouts, _ = certified_layouts(model, plan.joints, alone, scalar)
    for gathered in layouts:
        shared = replace(alone, meeting="gather", gathered=gathered)
        with suppress(AdagenError):
            plan = certified(make_plan(model, shared, scalar=scalar, channel="threads"))
    if not any(process.steps for process in plan.processes[1:]):
        raise UsageError("no limbs can be shared")
    return plan


def plan_elsewhere(model: Model, scalar: str = "double") -> Plan:
    """Return the certified plan of two threads that gather three quarters through a robot.

    Or as near to that as they can: beyond eight freedoms the ground becomes a body there.

    Raises:
        AdagenError: the robot has none.
    """
    alone = alone_schedule(model, 2, load_profile("default"))
    joints = make_plan(model, alone).joints
    for root in sorted(range(1, len(joints) + 1), key=lambda link: abs(4 * link - 3 * len(joints))):
        beyond = set[int]()
        for j, joint in enumerate(joints):
            if joint.parent == root or joint.parent - 1 in beyond:
                beyond.add(j)
        owners = tuple(int(j in beyond) for j in range(len(joints)))
        shared = replace(alone, meeting="gather", gathered=Gathered((root,), owners))
        with suppress(AdagenError):
            plan = certified(make_plan(model, shared, scalar=scalar, channel="threads"))
            if has_inner_root(plan) and plan.processes[1].steps:
                return plan
    raise UsageError("there is no link beyond the base or the ground to gather at")


def bounded(
    model: Model,
    states: States,
    ways: Sequence[Certified],
    toolchain: Toolchain,
    truth: Sequence[Array | None] | None = None,
) -> dict[Certified, Bounded]:
    """Solve states of a robot in some ways and compare bounds with true errors.

    Errors are relative to certified accelerations of 25 digits, for states as the solver reads
    them; of closed loops to `own_truths`. Ways that a robot cannot be emitted in are left out.

    Args:
        model: the robot.
        states: its states.
        ways: how they are solved.
        toolchain: builds the solvers.
        truth: the true accelerations in double, where they are known already.

    Raises:
        EnvironmentFault: a solver cannot be built.
    """
    found: dict[Certified, Bounded] = {}
    known: dict[str, tuple[States, Sequence[Array | None]]] = {}
    if truth is not None:
        known["double"] = states, truth
    for way in ways:
        try:
            plan = _plan_of(model, way)
            text = emit(plan, name=_NAME, shape=way.shape, batch=way.processes * way.batch)
        except AdagenError:
            continue
        if way.scalar not in known:
            given = states.read_in(way.scalar)
            every = own_truths(plan, given) if plan.closed else truths(model, given)
            known[way.scalar] = given, every
        given, true_ones = known[way.scalar]
        stem = stem_of(plan, _NAME, way.processes * way.batch)
        if way.batch and way.processes > 1:
            program = build_executable(text[f"{stem}.cpp"], stem, toolchain)
            answers, bounds = _handed_out(program, way.processes, model, given, toolchain)
        else:
            answers, bounds = _answers(text[f"{stem}.cpp"], stem, plan, way, given, toolchain)
        rows = [
            (_error(plan, given.q[k], given.v[k], answers[k], true), bounds[k])
            for k, true in enumerate(true_ones)
            if true is not None and np.isfinite(answers[k]).all()
        ]
        errors, bounds = np.array(rows, dtype=float).reshape(-1, 2).T
        found[way] = Bounded(errors, bounds, len(true_ones) - len(rows))
    return found


def _plan_of(model: Model, way: Certified) -> Plan:
    if way.elsewhere:
        return plan_elsewhere(model, way.scalar)
    processes = 1 if way.batch else way.processes
    plan = certified_plan(model, way.scalar, processes, parts=way.parts)
    if not way.looped:
        return plan
    other = looped(plan, way.looped)
    if other is None:
        raise UsageError("no loop can sweep its residuals")
    return other


def own_truths(plan: Plan, states: States) -> list[Array | None]:
    """Return what a plan answers in hundreds of bits, None where it does not.

    A state in doubles closes its loops up to rounding. Rows that follow from others then follow up
    to rounding only, and which of them are left out is the plan's to choose.
    """
    found: list[Array | None] = []
    for state in states.each:
        true = None
        for each in plan.alternatives:
            with suppress(FloatingPointError):
                interpret(each, *state, once=True)  # the first that stands the pose
                with ctx.workprec(BITS):
                    true = np.array([float(x) for x in interpret(each, *state, BALLS)])
                break
        found.append(true)
    return found


_NAME = "certified"
_SECONDS = 300.0
"""That processes have for their states."""


def _error(plan: Plan, q: Array, v: Array, answer: Array, true: Array) -> float:
    """The relative error of an answer in the energy norm."""
    chain = WideLinks(plan, q, v, np.longdouble)
    off, whole = chain.energy(answer.astype(np.longdouble) - true), chain.energy(true)
    return float(np.sqrt(off / whole)) if whole > 0 else 0.0


def _handed_out(
    program: Path, processes: int, model: Model, states: States, toolchain: Toolchain
) -> tuple[Array, Array]:
    """The same of a batch solver's program, which process 0 of some hands the states out in.

    Its file of results has three digits of bounds, and none of an infinite one.
    """
    with TemporaryDirectory() as folder:
        given, told = Path(folder, "states.json"), Path(folder, "result.json")
        write_states(states, model, given)
        words = ["--states", str(given), "--result", str(told)]
        launch(program, processes, words, toolchain, _SECONDS)
        result = json.loads(told.read_text())
    parts = [result["joints"][joint.name]["qdd"] for joint in model.joints]
    rows = [np.array(part, dtype=float).reshape(states.count, -1) for part in parts]
    bounds = np.array(result["error_bounds"], dtype=float)
    return np.hstack(rows), np.where(np.isnan(bounds), np.inf, bounds)


def _answers(
    source: str, stem: str, plan: Plan, way: Certified, states: States, toolchain: Toolchain
) -> tuple[Array, Array]:
    """Accelerations, shape (S, nv), and their bounds, shape (S,); NaN where there is none."""
    rows = states.stored(way.scalar)
    qdd, bounds = np.full_like(rows[1], np.nan), np.full(states.count, np.nan)
    with loaded(source, stem, plan, toolchain) as call:
        if way.batch:
            call("solve_batch_certified", ctypes.c_int, states.count, *rows, qdd, bounds)
            return qdd.astype(float), bounds
        for k, state in enumerate(zip(*rows, qdd, strict=True)):
            if call("solve", ctypes.c_int, *state) == 0:
                bounds[k] = call("error_bound", ctypes.c_double)
        return qdd.astype(float), bounds
