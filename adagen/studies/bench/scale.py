"""Chains of more and more joints on more and more processes, and batches on more and more hosts.

All solvers of a chain are timed by turns. Where there are more processes than cores, times are from
stretches of computing, played through with what messages cost; on two processes both are given.
"""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from time import process_time

from adagen.build import Toolchain, build_executable, find_toolchain
from adagen.cost import timeline
from adagen.errors import EnvironmentFault
from adagen.library import Robot, read
from adagen.library import compile as compiled
from adagen.model import Model
from adagen.program import Program
from adagen.reference import residual
from adagen.run import cores, launch
from adagen.schedule import CostProfile, Fabric, load_profile
from adagen.schedule.costs import StepCosts
from adagen.search.several_hosts import batches_on
from adagen.states import random_states
from adagen.studies.bench.contest import Contestant, Progress, Rules, Times, hold
from adagen.studies.bench.emitted import TIMEOUT, Emitted
from adagen.studies.bench.figures import chain
from adagen.studies.bench.machine import machine
from adagen.studies.bench.peers import entered
from adagen.studies.bench.scale_record import (
    CLOCK,
    PREDICTED,
    STRETCHES,
    BatchRow,
    Scale,
    ScaleRow,
)

PEER = "pinocchio"
MOST_OF_PEER = 500
"""Joints up to which pinocchio takes part: its data hold four tensors of so many numbers cubed."""
_TIMED = {"in_place": CLOCK, "stretches": STRETCHES}


@dataclass(frozen=True)
class Wanted:
    """What is to be measured.

    Attributes:
        chains: joints of a chain, and the numbers of processes that it is timed on.
        rules: rounds and evaluations.
        profile: name or file of the cost profile.
        peer: whether pinocchio takes part.
        priority: real-time priority of what is timed; 0: the usual one.
    """

    chains: Sequence[tuple[int, Sequence[int]]]
    rules: Rules
    profile: str = "default"
    peer: bool = True
    priority: int = 0


@dataclass(frozen=True)
class Made:
    """A chain's solver, built, and what that took; as ``ScaleRow`` has it.

    Others' solvers have no program, and nothing is known of how they were made.
    """

    contestant: Contestant
    program: Program | None = None
    meeting: str = "alone"
    generated: float = 0.0
    compiled: float = 0.0
    size: float = 0.0


def measure_chains(
    wanted: Wanted,
    on_progress: Progress,
    done: Callable[[Scale], None] = lambda _: None,
    before: Scale | None = None,
    built: Scale | None = None,
) -> Scale:
    """Return how long evaluations of chains take.

    Args:
        wanted: what is measured.
        on_progress: called with what is done.
        done: called with the record so far after each chain.
        before: an earlier record: chains that it has are kept.
        built: an earlier record of programs that may be in the cache since: what they took to
            compile is kept.

    Raises:
        AdagenError: nothing of a chain could be timed.
    """
    scale = Scale(machine(), wanted.rules, load_profile(wanted.profile).name)
    if before is not None:
        scale = replace(before, rules=wanted.rules)
    for joints, processes in wanted.chains:
        if joints in scale.joints:
            continue
        rows, absent = _chain(joints, sorted({1, *processes}), wanted, on_progress)
        rows = tuple(row.made_as(built) for row in rows)
        rows = tuple(sorted((*scale.rows, *rows), key=lambda row: row.joints))
        scale = replace(scale, rows=rows, absent={**scale.absent, **absent})
        done(scale)
    return scale


def _chain(
    joints: int, processes: Sequence[int], wanted: Wanted, on_progress: Progress
) -> tuple[tuple[ScaleRow, ...], dict[str, str]]:
    """Return the rows of a chain, and who is missing."""
    absent: dict[str, str] = {}
    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        file = Path(folder, f"chain{joints}.urdf")
        file.write_text(chain(joints), encoding="utf-8")
        toolchain, robot = find_toolchain(), read(file)
        model, solvers = robot.model, []
        for k, count in enumerate(processes, start=1):
            on_progress(f"chain of {joints}: building {k} of {len(processes)} (P={count})")
            solvers.append(made(robot, count, wanted.profile, toolchain))
        others = _others(model, Path(folder), absent, on_progress) if wanted.peer else []
        held = [solver.contestant for solver in solvers] + others
        with at_priority(wanted.priority):
            times, gone = hold(
                held, wanted.rules, lambda text: on_progress(f"chain of {joints}: {text}")
            )
        absent |= gone
        profile = load_profile(wanted.profile)
        speed = _at_speed(solvers[0].contestant, times, profile, max(processes))
        rows: list[ScaleRow] = []
        for solver in solvers:
            rows += _rows(model, solver, times, speed)
        best = min(
            (other for other in others if other.name in times),
            key=lambda other: times[other.name]["in_place"].least,
            default=None,
        )
        if best is not None:
            rows += _rows(model, Made(best), times)
    return tuple(rows), {f"chain of {joints}, {name}": why for name, why in absent.items()}


def made(robot: Robot, processes: int, profile: str, toolchain: Toolchain) -> Made:
    """Generate and build the solver of a robot.

    Raises:
        AdagenError: it cannot be solved, or the compiler failed.
    """
    begin = process_time()
    found = compiled(robot, processes, profile=profile)
    generated = process_time() - begin
    emitted = Emitted(
        name=f"adagen P={processes}",
        model=found.model,
        file=f"{found.stem}.cpp",
        text=found.source,
        build=f"shape {found.program.shape}",
        processes=processes,
        scalar="double",
        predicted=None if found.predicted is None else 1e3 * found.predicted,
    )
    begin = _compiling()
    contestant = emitted.contestant(toolchain, stretches=True)
    meeting = found.schedule.meeting if processes > 1 else "alone"
    size = len(found.source) / 1000
    return Made(contestant, found.program, meeting, generated, _compiling() - begin, size)


def _compiling() -> float:
    """Return the seconds of the processor that programs started here have used."""
    spent = os.times()
    return spent.children_user + spent.children_system


def _at_speed(
    one: Contestant, times: Mapping[str, Mapping[str, Times]], profile: CostProfile, most: int
) -> CostProfile | None:
    """Return a profile with cores as fast as the one that a solver on one process was timed on."""
    if one.name not in times or one.predicted is None or profile.steps is None:
        return None
    speed = one.predicted / times[one.name]["in_place"].least
    return replace(profile, steps=replace(profile.steps, cores=(speed,) * most))


def _others(
    model: Model, folder: Path, absent: dict[str, str], on_progress: Progress
) -> list[Contestant]:
    if model.nv > MOST_OF_PEER:
        absent[PEER] = f"its data would hold four tensors of {model.nv}^3 numbers"
        return []
    states = random_states(model, 64, 1)
    return entered([PEER], model, states, folder, absent, on_progress)


def _rows(
    model: Model,
    solver: Made,
    times: Mapping[str, Mapping[str, Times]],
    speed: CostProfile | None = None,
) -> Iterator[ScaleRow]:
    """Yield a row for each way in which a solver was timed in place."""
    one = solver.contestant
    kept = {source: times.get(one.name, {}).get(what) for what, source in _TIMED.items()}
    if not any(kept.values()):
        return
    states = random_states(model, 1, 1)
    found = one.solve(states)[0]
    off = residual(model, states.q[0], states.v[0], states.tau[0], found)
    scaled = None
    if solver.program is not None and speed is not None:
        scaled = 1e3 * timeline(solver.program, speed).makespan
    for source, time in kept.items():
        if time is not None:
            yield ScaleRow(
                team=one.team,
                name=one.name,
                joints=len(model.joints),
                processes=one.processes,
                source=source,
                median=time.median,
                least=time.least,
                residual=off,
                predicted=one.predicted,
                scaled=scaled,
                meeting=solver.meeting,
                generated=round(solver.generated, 2),
                compiled=round(solver.compiled, 2),
                size=solver.size,
            )


@contextmanager
def at_priority(number: int) -> Iterator[None]:
    """Let what is started meanwhile run at a real-time priority; 0: as everything.

    Raises:
        EnvironmentFault: the system does not allow it.
    """
    if number == 0:
        yield
        return
    before = os.sched_getscheduler(0), os.sched_getparam(0)
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(number))
    except OSError as error:
        raise EnvironmentFault(f"no real-time priority: {error.strerror}") from None
    try:
        yield
    finally:
        os.sched_setscheduler(0, *before)


def measure_batches(file: Path, wanted: Wanted) -> tuple[BatchRow, ...]:
    """Return the states per second of batches on 1, 2, 4, ... processes of this machine.

    Args:
        file: the robot.
        wanted: rules, profile and priority.

    Raises:
        AdagenError: batches of the robot cannot be solved, or the compiler failed.
    """
    processes, toolchain = cores(), find_toolchain()
    found = compiled(read(file), processes, batch=True, profile=wanted.profile)
    program = build_executable(found.source, found.stem, toolchain)
    words = ["--time", "--json", "--repeat", str(wanted.rules.repeat)]
    best: dict[int, BatchRow] = {}
    for _ in range(wanted.rules.rounds):
        with at_priority(wanted.priority):
            done = launch(program, processes, words, toolchain, TIMEOUT)
        for step in json.loads(done.printed)["time"]["states_per_second"]:
            row = BatchRow(1, step["processes"], CLOCK, step["in_place"], step["through_root"])
            seen = best.get(row.processes, row)
            best[row.processes] = replace(
                row,
                in_place=max(row.in_place, seen.in_place),
                distributed=max(row.distributed, seen.distributed),
            )
    return tuple(best[count] for count in sorted(best))


def predicted_batches(
    model: Model, fabric: Fabric, costs: StepCosts, state: float
) -> tuple[BatchRow, ...]:
    """Return the states per second that are predicted of batches on 1, 2, 4, ... hosts.

    Args:
        model: the robot.
        fabric: the hosts, and what messages between them cost.
        costs: what messages within a host cost.
        state: microseconds of a state on one process.
    """
    return tuple(
        BatchRow(
            one.hosts,
            one.processes,
            PREDICTED,
            1e6 * one.in_place,
            1e6 * one.rate,
            one.handout.limit,
        )
        for one in batches_on(model, fabric.hosts, state, costs, fabric.network)
    )
