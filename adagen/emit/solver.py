"""The source and the header of a solver: the values of their templates."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from adagen.emit.embedded import embedded_values
from adagen.emit.head import algorithm, frames, method, program_lines
from adagen.emit.messages import describe_message, message_size
from adagen.emit.model import model_values
from adagen.emit.names import prefix_of, quoted
from adagen.emit.processes import process_rows, table_sizes
from adagen.emit.refine import refinement_messages
from adagen.emit.runtime import version_number
from adagen.emit.settings import description, needs_eigen, settings, umbrellas
from adagen.emit.shapes import KNOWN
from adagen.emit.solver_program import PROGRAM_FILE, options_of
from adagen.emit.symbols import Symbols
from adagen.emit.templates import render
from adagen.plan import Plan
from adagen.plan.digits import meets_subnormals
from adagen.program import Program
from adagen.program.summary import TREES, meeting
from adagen.schedule import CostProfile, load_profile, step_costs
from adagen.schedule.costs import StepCosts
from adagen.version import __version__


@dataclass(frozen=True)
class FailureRow:
    """A reason why an evaluation fails.

    Attributes:
        name: what the header calls it, behind the solver's own prefix.
        value: as ``templates/include/adagen/status.hpp`` has it.
        what: in a few words, for the header.
    """

    name: str
    value: int
    what: str

    @property
    def word(self) -> str:
        """Its name in the source."""
        return "k" + "".join(part.capitalize() for part in self.name.split("_"))


FAILURES = (
    FailureRow("FINE", 0, "none"),
    FailureRow("NOT_FINITE", 1, "q, v or tau of a joint is not a finite number"),
    FailureRow("ZERO_QUATERNION", 2, "a joint's quaternion cannot be normalised"),
    FailureRow("FACTORIZATION", 3, "inertias beside a joint differ too much for the scalar"),
    FailureRow("OVERFLOW", 4, "a joint's acceleration is not a finite number"),
    FailureRow("NO_ANSWER", 5, "a process did not answer within the time limit"),
    FailureRow("ENDED", 6, "process 0 has ended the evaluations"),
    FailureRow("NOT_REFINED", 7, "refinement does not converge"),
    FailureRow("GIMBAL_LOCK", 8, "gimbal lock of joints that are joined as one"),
    FailureRow("GROWTH", 9, "a link beside a joint is too light for its neighbours"),
    FailureRow(
        "NOT_SET",
        16,
        "a value is not finite, a mass not positive, or the constant cannot be set",
    ),
    FailureRow("TOO_FEW_STEPS", 11, "refinement converges too slowly"),
    FailureRow("LOOP_OPEN", 12, "a loop or coupling is not closed in this configuration"),
    FailureRow("LOOP_TORN", 13, "the velocity violates a loop or coupling"),
    FailureRow("LOOP_SINGULAR", 14, "the rank of the loop constraints changes in this pose"),
    FailureRow("LOOP_FREE", 15, "the loops allow a motion of a joint that has no inertia"),
)
"""What a status may say, as the header names it."""


# Largest backward error that an emitted self-check lets pass: what cuts may lose at most, with a
# margin (adagen/plan/cuts.py, docs/explanation/accuracy.md).
TOLERANCE = {"double": 1e-9, "float": 1e-3}


@dataclass(frozen=True)
class Solver:
    """The contents of a solver's source and header.

    Attributes:
        program: what it runs.
        stem: what its files are called.
        refine: steps of iterative refinement.
        batch: if not 0, on how many processes many states are solved at once.
        chunk: values that one function of shape unrolled computes; 0 for its default.
        compiler: what the MPI wrapper is to call; "" for its own choice.
        profile: prices the program, and messages; the shipped one if not given.
        embedded: whether it needs no operating system.
    """

    program: Program
    stem: str
    refine: int = 0
    batch: int = 0
    chunk: int = 0
    compiler: str = ""
    profile: CostProfile | None = None
    embedded: bool = False

    @property
    def plan(self) -> Plan:
        """The plan that is carried out."""
        return self.program.plan

    @property
    def processes(self) -> int:
        """How many processes it runs on."""
        return self.batch or len(self.plan.processes)

    @property
    def mpi(self) -> bool:
        """Whether its processes are MPI processes."""
        return self.processes > 1 and not self.plan.threads

    @cached_property
    def symbols(self) -> Symbols:
        """The C++ names of joints, links and buffers."""
        in_wide_numbers = 0 if self.plan.corrections else self.refine
        costs = step_costs(self.profile)
        return Symbols(self.program, in_wide_numbers, self.chunk, costs, self.embedded)

    @cached_property
    def costs(self) -> CostProfile:
        """The profile of its predicted time."""
        return load_profile("default") if self.profile is None else self.profile

    def texts(self) -> tuple[str, str]:
        """Return the C header and the C++ source.

        Raises:
            UsageError: an embedded solver would need Eigen.
        """
        of_shape = KNOWN[self.program.shape].values(self.symbols)
        values = {
            **self._of_processes(),
            **self._of_numbers(),
            **self._head(),
            **model_values(self.symbols),
            **of_shape,
            "eigen": needs_eigen(of_shape),
            **(embedded_values(self.symbols, of_shape) if self.embedded else {}),
        }
        header = render("interface.h.j2", **values)
        return header, render("solver.cpp.j2", **self._of_source(values), **values)

    def _of_numbers(self) -> dict[str, object]:
        """Values about number type, refinement and tolerance."""
        plan = self.plan
        return {
            "number": plan.scalar,
            "tolerance": TOLERANCE[plan.scalar],
            "columns": self.symbols.columns,
            "slaved_count": len(plan.slaved),
            "batch": bool(self.batch),
            "cache": int(self.symbols.costs["process.cache"]),
            "state_by_state": bool(self.batch) and not self.program.batch,
            "reproducible": plan.reproducible,
            "certified": plan.certified,
            "refine": self.refine,
            "own_residual": plan.corrections > 0,
            "wide_residual": self.symbols.refine > 0,
            "weighed": plan.weighed,
            "embedded": self.embedded,
            "failures": FAILURES,
        }

    def _of_processes(self) -> dict[str, object]:
        """Values about processes and messages."""
        plan, count = self.plan, self.processes
        idle = set() if self.batch or self.refine else _idle(plan)
        alone = _alone(self.program) and (not self.batch or count == 1)
        return {
            "process_count": count,
            "mpi": self.mpi,
            "threads": plan.threads,
            "alone": alone,
            "processes": process_rows(self.symbols) * (self.batch or 1),
            "idle": idle,
            "run_list": ", ".join(
                "refined"
                if self.symbols.refine
                else "kNothing"
                if p in idle
                else f"run_{0 if self.batch else p}"
                for p in range(count)
            ),
            "messages": plan.messages,
            "channel_messages": [] if alone else _channel_messages(self.symbols),
            "meets_subnormals": meets_subnormals(plan),
            "hops": _hops(step_costs(self.costs)) if count > 1 else "",
            "program_file": PROGRAM_FILE,
            "program_options": options_of(self.mpi, plan.scalar),
            "comm": "MPI_Comm" if self.mpi else "adagen::OneProcess",
        }

    def _of_source(self, values: Mapping[str, object]) -> dict[str, object]:
        """Values of the source alone: its headers and macros."""
        plan, more = self.plan, description(values)
        plain = not any(values[name] for name in ("certified", "parameters", "batch", "embedded"))
        kind = "threads" if plan.threads else "mpi" if self.mpi else "alone"
        plainly = plain and not (
            more or plan.reproducible or (kind == "alone" and self.symbols.refine)
        )
        return {
            **umbrellas(values),
            "plain_program": not (more or self.mpi or plan.threads),
            "plain_solver": plain and self.processes == 1,
            "whole": f"whole_{kind}.hpp" if plainly else "",
            "macros": _macros(plan, values),
            "settings": settings(values, len(plan.messages)),
            "description": more,
        }

    def _head(self) -> dict[str, object]:
        """Values of the file's head, and the prefix of its names."""
        plan, program = self.plan, self.program
        return {
            "stem": prefix_of(self.stem),
            "STEM": prefix_of(self.stem).upper(),
            "header": f"{self.stem}.h",
            "version": __version__,
            "version_number": version_number(),
            "robot": quoted(plan.name),
            "source_hash": plan.source_hash or "not given",
            "form": plan.form,
            "shape": program.shape,
            "tuning": f" (functions of {self.chunk} values)" if self.chunk else "",
            "compiler": self.compiler,
            "scalar": plan.scalar,
            "channel": plan.channel,
            "base": "floating" if plan.floating else "fixed",
            "floating": plan.floating,
            # The paper's tree says what runs where processes are joined, and only there.
            "tree": quoted(plan.schedule)[1:-1] if meeting(program) in TREES else "",
            "method": method(program),
            "frames": frames(program),
            "algorithm": algorithm(program, batch=bool(self.batch)),
            "program_lines": program_lines(program, self.costs),
        }


def _macros(plan: Plan, values: Mapping[str, object]) -> list[str]:
    """Macros that configure the headers."""
    settable = {parameter.what for parameter in plan.parameters}
    wanted = {
        "ADAGEN_MPI": values["mpi"],
        "ADAGEN_THREADS": plan.threads,
        "ADAGEN_EMBEDDED": values["embedded"],
        "ADAGEN_BATCH": values["batch"],
        "ADAGEN_STATE_BY_STATE": values["state_by_state"],
        "ADAGEN_LOOPS": plan.closed,
        "ADAGEN_CERTIFIED": plan.certified,
        "ADAGEN_REFINES": values["refine"],
        "ADAGEN_RECOVERS": values.get("recovery"),
        "ADAGEN_SETS_GRAVITY": plan.entry_of_parameter("gravity") is not None,
        **{f"ADAGEN_SETS_{what.upper()}": what in settable for what in ("mass", "center")},
    }
    return [name for name, asked in wanted.items() if asked]


def _alone(program: Program) -> bool:
    """Whether process 0 does everything: the others have nothing to do, and nothing is sent."""
    return meeting(program) == "alone" and not any(p.owns for p in program.plan.processes[1:])


def _idle(plan: Plan) -> set[int]:
    """Processes that run nothing, in nearly every plan those without steps."""
    if plan.slaved or plan.weighed or any(process.recovery for process in plan.processes):
        return set()
    return {p for p, process in enumerate(plan.processes) if not process.steps}


def _hops(costs: StepCosts) -> str:
    """Costs of messages, ns: through a window, and by MPI."""
    hops = (costs.window, costs.message)
    rows = (
        f"{{{1e3 * hop.send:.6g}, {1e3 * hop.latency:.6g}, {1e3 * hop.number:.6g}}}" for hop in hops
    )
    return f"{{{', '.join(rows)}}}"


def _channel_messages(symbols: Symbols) -> list[dict[str, object]]:
    """The plan's messages, and behind them state and result of each process but the first."""
    rows: list[dict[str, object]] = [
        {
            "source": message.source,
            "target": message.target,
            "size": message_size(symbols, message),
            "comment": describe_message(symbols, message),
        }
        for message in symbols.plan.messages
    ]
    for p, process in enumerate(symbols.plan.processes[1:], start=1):
        state, result = table_sizes(symbols, process)
        state += len(symbols.plan.parameter_values)
        rows.append({"source": 0, "target": p, "size": state, "comment": "state"})
        rows.append({"source": p, "target": 0, "size": result, "comment": "accelerations"})
    return rows + refinement_messages(symbols)
