"""From a plan to text: C++ source, the plan itself, and the Makefile that builds them."""

from __future__ import annotations

from dataclasses import replace

from adagen.cost import programmed, with_recovery
from adagen.emit.combinations import (
    check_batch,
    check_certified,
    check_form,
    check_reproducible,
)
from adagen.emit.embedded import check_target
from adagen.emit.names import file_stem
from adagen.emit.refine import checked_shape, checked_steps
from adagen.emit.runtime import runtime_files
from adagen.emit.shapes import chosen_shape, shape_to_refine, to_be_refined
from adagen.emit.solver import TOLERANCE, Solver
from adagen.emit.solver_program import PROGRAM_FILE, program_text, standalone
from adagen.emit.templates import render, template, templates_folder
from adagen.errors import UsageError
from adagen.executor import Grouping
from adagen.plan import Plan, plan_to_json
from adagen.plan.steps import Join
from adagen.program import Program, check, lower
from adagen.schedule import CostProfile, step_costs, with_steps
from adagen.version import __version__

__all__ = [
    "TOLERANCE",
    "check_batch",
    "check_certified",
    "check_form",
    "check_reproducible",
    "emit",
    "file_stem",
    "program_of",
    "stem_of",
    "templates_folder",
]


def stem_of(plan: Plan, name: str | None = None, batch: int = 0) -> str:
    """Return NAME_pP, the name of a plan's emitted files without their endings."""
    processes = batch or len(plan.processes)
    return f"{file_stem(plan.name if name is None else name)}_p{processes}"


def emit(
    plan: Plan,
    *,
    name: str | None = None,
    svg: str | None = None,
    shape: str = "auto",
    refine: int | None = None,
    residual: str = "auto",
    batch: int = 0,
    chunk: int = 0,
    compiler: str = "",
    profile: CostProfile | None = None,
    limbs: Grouping | None = None,
    single_file: bool = False,
    target: str = "host",
) -> dict[str, str]:
    """Return the emitted files, file name to text.

    Args:
        plan: the plan.
        name: what to call the files (made safe here); the robot's name if not given.
        svg: a drawing of the schedule to put beside them.
        shape: shape of the code, one of ``adagen.emit.shapes.SHAPES``, or "auto".
        refine: steps of iterative refinement that each evaluation takes, 0 to 9; None: as many as
            the scalar needs.
        residual: precision of the residuals: "own" (the solver's), "wide", or "auto" (own where
            loops have it).
        batch: if not 0, solve many states at once on so many processes, each by the plan of one.
        chunk: values that one function of shape unrolled computes; 0 for its default.
        compiler: the compiler behind the MPI wrapper; "" for the wrapper's choice.
        profile: prices shapes, methods, limbs in lanes, and messages in times from stretches;
            without it, or if it has no costs of steps, the shipped one.
        limbs: limbs in SIMD lanes, for each process; None for those of least price.
        single_file: whether NAME_pP.cpp contains the runtime and the program, too.
        target: "host", or "embedded" for a solver that needs no operating system.

    Returns:
        NAME_pP.cpp, NAME_pP.h, NAME_pP.plan.json, NAME_pP.pc and, if given, NAME_pP.svg; the
        runtime; and adagen_program.cpp, Makefile and CMakeLists.txt, which build all solvers of
        their folder. For an embedded solver only source, header, plan, drawing and runtime.

    Raises:
        UsageError: the plan cannot be emitted in this shape, or not refined, or not for batches.
    """
    plan = plan.for_batches if batch else plan
    steps, many = checked_steps(refine), bool(batch)
    check_target(target, batch or len(plan.processes), steps, batch=many, single_file=single_file)
    program = program_of(
        plan, shape, refine, residual=residual, batch=many, profile=profile, limbs=limbs
    )
    check(program)
    stem, embedded = stem_of(plan, name, batch), target == "embedded"
    solver = Solver(program, stem, steps, batch, chunk, compiler, profile, embedded)
    data = {f"{stem}.plan.json": plan_to_json(replace(plan, profile=with_steps(profile).name))}
    drawing = {} if svg is None else {f"{stem}.svg": svg}
    return _files(solver, data | drawing, single_file=single_file)


def _files(solver: Solver, data: dict[str, str], *, single_file: bool) -> dict[str, str]:
    """Source and header of a solver, its data, the runtime, and what builds a program."""
    stem = solver.stem
    header, text = solver.texts()
    files = {f"{stem}.cpp": text, f"{stem}.h": header, **data}
    if not single_file:
        files |= runtime_files()
    if solver.embedded:
        return files
    files |= {
        f"{stem}.pc": render(
            "solver.pc.j2",
            stem=stem,
            process_count=solver.processes,
            mpi=solver.mpi,
            threads=solver.plan.threads,
            version=__version__,
        ),
        "Makefile": template("Makefile"),
        "CMakeLists.txt": template("CMakeLists.txt"),
    }
    if single_file:
        files[f"{stem}.cpp"] = standalone(text, header=header)
    else:
        files[PROGRAM_FILE] = program_text()
    return files


def program_of(
    plan: Plan,
    shape: str = "auto",
    refine: int | None = None,
    *,
    residual: str = "auto",
    batch: bool = False,
    profile: CostProfile | None = None,
    limbs: Grouping | None = None,
) -> Program:
    """Return the program that is emitted for a plan.

    Args:
        plan: what each process computes.
        shape: of the code, one of ``adagen.emit.shapes.KNOWN``, or "auto".
        refine: steps of iterative refinement; None: as many as the scalar needs.
        residual: what these find residuals in; see emit.
        batch: whether many states are solved at once.
        profile: what is chosen by; the shipped one if not given.
        limbs: those that each process takes side by side; None for those of least price.

    Raises:
        UsageError: the plan cannot be emitted in this shape, or not refined, or not for batches.
    """
    refine = checked_steps(refine)
    if batch:
        if len(plan.processes) > 1:
            raise UsageError("a batch is solved by the plan of one process")
        check_batch(shape, refine, plan.channel)
        one_by_one = _in_parts(plan, shape, profile)
        if one_by_one is not None:
            return one_by_one
    if refine and checked_shape(refine, shape) == "auto":
        shape = shape_to_refine(plan, shape)
    shape = chosen_shape(plan, shape, batch=batch, profile=profile)
    plan = to_be_refined(plan, shape, refine, residual) if refine else plan
    if limbs is not None and not batch:
        return lower(plan, shape, limbs=limbs, costs=step_costs(profile))
    again = refine > 0 and not plan.corrections
    program = programmed(plan, shape, profile, batch=batch, again=again)
    return program if batch else with_recovery(program, profile)


def _in_parts(plan: Plan, shape: str, profile: CostProfile | None) -> Program | None:
    """Return the program of one state whose chain is in parts, one in each lane; None if it is not.

    A batch is solved by it state by state: its lanes are for parts.
    """
    if shape not in ("auto", "kernels") or not any(plan.steps_of(Join)):
        return None
    program = programmed(plan, "kernels", profile)
    (process,) = program.processes
    parted = any((op.does, op.method) == ("join", "parts") for op in process.operations)
    return program if parted else None
