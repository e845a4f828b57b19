"""From a plan to text: C++ source, the plan itself, and the Makefile that builds them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from adagen import __version__
from adagen.cost import programmed, with_recovery
from adagen.emit.around import PROGRAM_FILE, options_of, program_text, standalone
from adagen.emit.combinations import check_batch, check_certified, check_reproducible
from adagen.emit.embedded import check_target, embedded_values
from adagen.emit.head import algorithm, frames, method, program_lines
from adagen.emit.includes import needs_eigen, umbrellas
from adagen.emit.interface import FAILURES
from adagen.emit.model import model_values
from adagen.emit.names import file_stem, prefix_of, quoted
from adagen.emit.processes import describe_message, message_size, process_rows, table_sizes
from adagen.emit.refine import checked_shape, checked_steps, refinement_messages
from adagen.emit.runtime import runtime_files, version_number
from adagen.emit.settings import description, settings
from adagen.emit.shapes import KNOWN, chosen_shape, shape_to_refine, to_be_refined
from adagen.emit.templates import render, template, templates_folder
from adagen.emit.words import Words
from adagen.errors import UsageError
from adagen.executor import Grouping
from adagen.plan import Plan, plan_to_json
from adagen.program import Program, check, lower
from adagen.program.summary import TREES, meeting
from adagen.schedule import CostProfile, load_profile, step_costs

# Largest backward error that an emitted self-check lets pass: what cuts may lose at most, with a
# margin (adagen/plan/cuts.py, docs/explanation/accuracy.md).
TOLERANCE = {"double": 1e-9, "float": 1e-3}

__all__ = [
    "check_batch",
    "check_certified",
    "check_reproducible",
    "emit",
    "file_stem",
    "program_of",
    "stem_of",
    "templates_folder",
]


def stem_of(plan: Plan, name: str | None = None, batch: int = 0) -> str:
    """Return NAME_pP, what the emitted files of a plan are called without their endings."""
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
        residual: what these find residuals in: the solver's "own" numbers, "wide" ones, or its own
            where loops have them ("auto").
        batch: if not 0, solve many states at once on so many processes, each by the plan of one.
        chunk: values that one function of shape unrolled computes; 0 for its default.
        compiler: what the MPI wrapper is to call; "" for its own choice.
        profile: what the shape, the methods and the limbs that are computed side by side are chosen
            by, and what messages cost where the program plays stretches of computing through
            instead of timing itself; without it, or if it prices joins alone, the shipped one.
        limbs: those that each process takes side by side, one in each SIMD lane; None for those
            of least price.
        single_file: whether NAME_pP.cpp holds the program, too, and stands alone.
        target: "host", or "embedded" for a solver that needs no operating system.

    Returns:
        NAME_pP.cpp, NAME_pP.h, NAME_pP.plan.json, NAME_pP.pc and, if given, NAME_pP.svg; and for
        all the same adagen_program.cpp, the program around them, Makefile and CMakeLists.txt, which
        build all in their folder. Of an embedded solver source, header, plan and drawing alone.

    Raises:
        UsageError: the plan cannot be emitted in this shape, or not refined, or not for batches.
    """
    plan = plan.for_batches if batch else plan
    processes = batch or len(plan.processes)
    stem = stem_of(plan, name, batch)
    steps = checked_steps(refine)
    check_target(target, processes, steps, batch=bool(batch), single_file=single_file)
    header, text = _texts(
        plan, stem, shape, refine, residual, chunk, compiler, batch, profile, limbs, target
    )
    files = {
        f"{stem}.cpp": text,
        f"{stem}.h": header,
        f"{stem}.plan.json": plan_to_json(replace(plan, profile=_named(profile))),
    }
    if svg is not None:
        files[f"{stem}.svg"] = svg
    if not single_file:
        files |= runtime_files()
    if target == "embedded":
        return files
    files |= {
        f"{stem}.pc": render(
            "solver.pc.j2",
            stem=stem,
            process_count=processes,
            mpi=processes > 1 and not plan.threads,
            threads=plan.threads,
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


def _named(profile: CostProfile | None) -> str:
    """The name of the profile that a program is chosen by: the shipped one where none can be."""
    return "default" if profile is None or profile.steps is None else profile.name


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
    """Return the program that is emitted of a plan.

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
    if refine and checked_shape(refine, shape) == "auto":
        shape = shape_to_refine(plan, shape)
    shape = chosen_shape(plan, shape, batch=batch, profile=profile)
    plan = to_be_refined(plan, shape, refine, residual) if refine else plan
    if limbs is not None and not batch:
        return lower(plan, shape, limbs=limbs, costs=step_costs(profile))
    again = refine > 0 and not plan.corrections
    program = programmed(plan, shape, profile, batch=batch, again=again)
    return program if batch else with_recovery(program, profile)


def source(plan: Plan, stem: str, shape: str = "auto") -> str:
    """Return the C++ source of a plan; ``stem`` begins the names of its C functions.

    Raises:
        UsageError: the plan cannot be emitted in this shape.
    """
    return _texts(plan, stem, shape, None, "auto", 0, "", 0, None, None)[1]


def _texts(
    plan: Plan,
    stem: str,
    shape: str,
    refine: int | None,
    residual: str,
    chunk: int,
    compiler: str,
    batch: int,
    profile: CostProfile | None,
    limbs: Grouping | None,
    target: str = "host",
) -> tuple[str, str]:
    """Return the C header and the C++ source of a plan."""
    program = program_of(
        plan, shape, refine, residual=residual, batch=bool(batch), profile=profile, limbs=limbs
    )
    check(program)
    refine = checked_steps(refine)
    plan, shape = program.plan, program.shape
    words = Words(program, 0 if plan.corrections else refine, chunk, step_costs(profile))
    processes = batch or len(plan.processes)
    mpi = processes > 1 and not plan.threads
    embedded = target == "embedded"
    costs = load_profile("default") if profile is None else profile
    of_shape = KNOWN[shape].values(words)
    idle = _idle(plan) if not batch and not refine else set()
    alone = _alone(program) and (not batch or processes == 1)
    values: dict[str, object] = {
        "number": plan.scalar,
        "tolerance": TOLERANCE[plan.scalar],
        "columns": words.columns,
        "slaved_count": len(plan.slaved),
        "process_count": processes,
        "mpi": mpi,
        "threads": plan.threads,
        "batch": bool(batch),
        "reproducible": plan.reproducible,
        "certified": plan.certified,
        "alone": alone,
        "processes": process_rows(words) * (batch or 1),
        "idle": idle,
        "run_list": ", ".join(
            "refined" if words.refine else "kNothing" if p in idle else f"run_{0 if batch else p}"
            for p in range(processes)
        ),
        "refine": refine,
        "own_residual": plan.corrections > 0,
        "wide_residual": words.refine > 0,
        "weighed": plan.weighed,
        "messages": plan.messages,
        "channel_messages": [] if alone else _channel_messages(words),
        "hops": _hops(costs) if processes > 1 else "",
        "program_file": PROGRAM_FILE,
        "program_options": options_of(mpi, plan.scalar),
        "comm": "MPI_Comm" if mpi else "adagen::OneProcess",
        "embedded": embedded,
        "failures": FAILURES,
        **_head(program, stem, chunk, compiler),
        "method": method(program),
        "frames": frames(program),
        "algorithm": algorithm(program),
        "program_lines": program_lines(program, costs),
        **model_values(words),
        **of_shape,
        "eigen": needs_eigen(of_shape),
        **(embedded_values(words, of_shape) if embedded else {}),
    }
    more = description(values)
    plain = not any(values[name] for name in ("certified", "parameters", "batch", "embedded"))
    kind = "threads" if plan.threads else "mpi" if mpi else "alone"
    own = {
        **umbrellas(values),
        "plain_program": not (more or mpi or plan.threads),
        "plain_solver": plain and processes == 1,
        "whole": f"whole_{kind}.hpp"
        if plain and not (more or plan.reproducible or (kind == "alone" and words.refine))
        else "",
        "macros": _macros(plan, values),
        "settings": settings(values, len(plan.messages)),
        "description": more,
    }
    return render("interface.h.j2", **values), render("solver.cpp.j2", **own, **values)


def _macros(plan: Plan, values: Mapping[str, object]) -> list[str]:
    """What tells the headers what they are to do."""
    settable = {parameter.what for parameter in plan.parameters}
    wanted = {
        "ADAGEN_MPI": values["mpi"],
        "ADAGEN_THREADS": plan.threads,
        "ADAGEN_EMBEDDED": values["embedded"],
        "ADAGEN_BATCH": values["batch"],
        "ADAGEN_LOOPS": plan.closed,
        "ADAGEN_CERTIFIED": plan.certified,
        "ADAGEN_REFINES": values["refine"],
        "ADAGEN_RECOVERS": values.get("recovery"),
        "ADAGEN_SETS_GRAVITY": plan.entry_of_parameter("gravity") is not None,
        **{f"ADAGEN_SETS_{what.upper()}": what in settable for what in ("mass", "center")},
    }
    return [name for name, asked in wanted.items() if asked]


def _alone(program: Program) -> bool:
    """Whether process 0 does all: the others have nothing to do, and nothing is sent."""
    return meeting(program) == "alone" and not any(p.owns for p in program.plan.processes[1:])


def _idle(plan: Plan) -> set[int]:
    """Processes that run nothing, in nearly every plan those without steps."""
    if plan.slaved or plan.weighed or any(process.recovery for process in plan.processes):
        return set()
    return {p for p, process in enumerate(plan.processes) if not process.steps}


def _head(program: Program, stem: str, chunk: int, compiler: str) -> dict[str, object]:
    """What the head of the file says that it was made from, and how its names begin."""
    plan = program.plan
    return {
        "stem": prefix_of(stem),
        "STEM": prefix_of(stem).upper(),
        "header": f"{stem}.h",
        "version": __version__,
        "version_number": version_number(),
        "robot": quoted(plan.name),
        "source_hash": plan.source_hash or "not given",
        "form": plan.form,
        "shape": program.shape,
        "tuning": f" (functions of {chunk} values)" if chunk else "",
        "compiler": compiler,
        "scalar": plan.scalar,
        "channel": plan.channel,
        "base": "floating" if plan.floating else "fixed",
        "floating": plan.floating,
        # The paper's tree says what runs where processes are joined, and only there.
        "tree": quoted(plan.schedule)[1:-1] if meeting(program) in TREES else "",
    }


def _hops(profile: CostProfile) -> str:
    """What messages cost, ns: through a window, and as one of MPI."""
    if profile.steps is None:
        profile = load_profile("default")
    assert profile.steps is not None  # the shipped one has them
    hops = (profile.steps.window, profile.steps.message)
    rows = (
        f"{{{1e3 * hop.send:.6g}, {1e3 * hop.latency:.6g}, {1e3 * hop.number:.6g}}}" for hop in hops
    )
    return f"{{{', '.join(rows)}}}"


def _channel_messages(words: Words) -> list[dict[str, object]]:
    """The plan's messages, and behind them state and result of each process but the first."""
    rows: list[dict[str, object]] = [
        {
            "source": message.source,
            "target": message.target,
            "size": message_size(words, message),
            "comment": describe_message(words, message),
        }
        for message in words.plan.messages
    ]
    for p, process in enumerate(words.plan.processes[1:], start=1):
        state, result = table_sizes(words, process)
        state += len(words.plan.parameter_values)
        rows.append({"source": 0, "target": p, "size": state, "comment": "state"})
        rows.append({"source": p, "target": 0, "size": result, "comment": "accelerations"})
    return rows + refinement_messages(words)
