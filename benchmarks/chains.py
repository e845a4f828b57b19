"""Long chains: what they take to generate, to compile and to run, on one process and on several.

    python -m benchmarks.chains [--joints N ...] [--processes P ...] [--rounds R] [--write PAGE]

Chains of hinges about x, y and z by turns. All solvers of a length take turns; times are the least
over all turns. Processes beyond the machine's cores are timed by stretches: what each one computes
between messages is measured by itself and played through with what messages cost.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import adagen
from adagen.build import build_executable, find_toolchain
from adagen.errors import AdagenError, EnvironmentFault
from adagen.run import launch
from benchmarks.page import write_between_marks
from benchmarks.paper import robots

WORK = Path(__file__).resolve().parents[1] / "build" / "chains"
JOINTS = (200, 500, 1000, 2000, 5000, 10000)
PROCESSES = (1, 2, 4, 8, 16)
MOST_SHARED = 2000
"""Joints up to which chains are shared by processes here."""
TIMEOUT = 300.0


@dataclass
class Solver:
    """A chain's solver on some processes.

    Attributes:
        joints: of the chain.
        processes: P.
        generated: seconds of the processor to read, search and emit.
        compiled: seconds until it was built; 0 where it was found in the cache.
        size: of the source, kB.
        predicted: microseconds, on the shipped profile.
        program: the executable.
        meeting: how processes meet.
        times: nanoseconds of an evaluation, the least of each turn.
    """

    joints: int
    processes: int
    generated: float
    compiled: float
    size: float
    predicted: float
    program: Path
    meeting: str
    times: list[float] = field(default_factory=list)

    @property
    def least(self) -> float:
        """Nanoseconds of an evaluation."""
        return min(self.times)


def made(joints: int, processes: int) -> Solver:
    """Generate and build the solver of a chain."""
    path = WORK / f"chain{joints}.urdf"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(robots.chain(joints), encoding="utf-8")
    begin = time.process_time()
    found = adagen.compile(adagen.read(path), processes)
    generated = time.process_time() - begin
    begin = time.perf_counter()
    program = build_executable(found.source, found.stem, find_toolchain())
    compiled = time.perf_counter() - begin
    meeting = found.schedule.meeting if processes > 1 else "alone"
    size = len(found.source) / 1000
    predicted = found.predicted or 0.0
    return Solver(joints, processes, generated, compiled, size, predicted, program, meeting)


def take_turn(solver: Solver, repeat: int) -> None:
    """Time a solver once: by the clock, or by stretches where there are not cores enough."""
    words = ["--time", "--json", "--repeat", str(repeat)]
    if solver.processes > 1:
        words.append("--stretches")
    done = launch(solver.program, solver.processes, words, find_toolchain(), TIMEOUT)
    if done.status != 0:
        raise EnvironmentFault(done.stderr.strip().removeprefix("error: "))
    solver.times.append(float(json.loads(done.stdout)["time"]["in_place"]["min_ns"]))


def table(solvers: Sequence[Solver]) -> str:
    """Return the tables of one process and of several (Markdown)."""
    alone = {s.joints: s for s in solvers if s.processes == 1}
    first = alone[min(alone)]
    lines = [
        "| joints | generate, s | compile, s | source, kB | us | ns a joint | x the shortest |",
        "|--:|--:|--:|--:|--:|--:|--:|",
    ]
    for joints, s in sorted(alone.items()):
        each, least = s.least / joints, first.least / first.joints
        lines.append(
            f"| {joints} | {s.generated:.1f} | {s.compiled:.1f} | {s.size:.0f} "
            f"| {s.least / 1000:.1f} | {each:.1f} | {each / least:.2f} |"
        )
    lines += [
        "",
        "| joints | P | meeting | generate, s | us, from stretches | saved | predicted |",
        "|--:|--:|---|--:|--:|--:|--:|",
    ]
    for s in solvers:
        if s.processes > 1:
            one = alone[s.joints]
            lines.append(
                f"| {s.joints} | {s.processes} | {s.meeting} | {s.generated:.1f} "
                f"| {s.least / 1000:.2f} | {1 - s.least / one.least:.0%} "
                f"| {1 - s.predicted / one.predicted:.0%} |"
            )
    return "\n".join(lines)


def main(words: Sequence[str] | None = None) -> int:
    """Measure what the command line names, print tables, and return the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--joints", type=int, nargs="+", default=JOINTS)
    parser.add_argument("--processes", type=int, nargs="+", default=PROCESSES)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--repeat", type=int, default=10, help="evaluations of a state in a turn")
    parser.add_argument("--write", type=Path, metavar="PAGE", help="put the tables there")
    options = parser.parse_args(words)
    solvers: list[Solver] = []
    try:
        for joints in options.joints:
            own = []
            for processes in sorted({1, *options.processes}):
                if processes == 1 or joints <= MOST_SHARED:
                    print(f"chain of {joints}, P={processes}", file=sys.stderr)
                    own.append(made(joints, processes))
            for _ in range(options.rounds):
                for solver in own:
                    take_turn(solver, options.repeat)
            solvers += own
    except AdagenError as error:
        print(error, file=sys.stderr)
        return error.status
    text = f"{len(os.sched_getaffinity(0))} cores.\n\n{table(solvers)}\n"
    print(text)
    if options.write is not None:
        write_between_marks(options.write, "chains", text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
