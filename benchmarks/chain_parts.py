"""What a long chain takes on one process and on two, part by part, and what sharing it could save.

    python -m benchmarks.chain_parts [--joints N ...] [--profile NAME] [--rounds R] [--priority N]
                                     [--write PAGE]

Times are those between the time stamps of --trace, less what looking at the clock takes. The
shortest chain and one of twice as many joints tell what does not depend on the length: every
process takes that.
"""

from __future__ import annotations

import json
import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

from adagen.build import Toolchain, build_executable, find_toolchain
from adagen.cli.console import speaking
from adagen.errors import AdagenError
from adagen.library import compile as compiled
from adagen.library import read
from adagen.run import launch
from adagen.studies.bench.figures import chain
from adagen.studies.bench.machine import machine
from adagen.studies.bench.scale import at_priority
from benchmarks.page import command, publish

JOINTS = (200, 1000)
TIMEOUT = 300.0

KINEMATICS, PASSAGE, INWARDS = "angles, motions, links", "message: passage", "inwards, own joins"
EXCHANGE, CUT, OUTWARDS = "messages: exchange", "join at the cut", "release, outwards, results"
KINDS = (KINEMATICS, PASSAGE, INWARDS, EXCHANGE, CUT, OUTWARDS)
"""What processes do, in order. Messages: written, waited for and read."""

Times = dict[str, float]
"""Microseconds by each of ``KINDS`` that there is."""


@dataclass(frozen=True)
class Parts:
    """What a chain takes, microseconds.

    Attributes:
        joints: of the chain.
        alone: on one process.
        shared: of each of two processes.
        once: what does not depend on the length, of each process.
    """

    joints: int
    alone: Times
    shared: tuple[Times, Times]
    once: float

    @property
    def limits(self) -> dict[str, float]:
        """What two processes would take if they did nothing else, more and more of it."""
        whole = sum(self.alone.values())
        halves = (whole - self.once) / 2 + self.once
        cut = sum(own[CUT] for own in self.shared) / 2
        exchange = sum(own[EXCHANGE] for own in self.shared) / 2
        return {
            "half of everything": whole / 2,
            "half of the rows, and all that does not depend on the length": halves,
            "and the join at the cut": halves + cut,
            "and the exchange": halves + cut + exchange,
            "as they are": max(sum(own.values()) for own in self.shared),
        }


def times_of(rows: Sequence[Mapping[str, Any]], clock: float) -> Times:
    """Return what a process takes by its stages in a trace.

    Args:
        rows: its stages in order, as the file of --trace has them.
        clock: nanoseconds that a look at the clock takes, as this has it.
    """
    found: Times = {}
    joins = 0
    for row in rows:
        joins += row["what"] == "assembly"
        kind = {
            "kinematics": KINEMATICS,
            "assembly": INWARDS if joins == 1 else CUT,
            "disassembly": OUTWARDS,
        }.get(row["what"], EXCHANGE if joins else PASSAGE)
        found[kind] = found.get(kind, 0.0) + max(0.0, row["length_ns"] - clock) / 1e3
    return found


def measure(
    chains: Sequence[int], profile: str, rounds: int, on_progress: Callable[[str], None]
) -> list[Parts]:
    """Return what chains take: medians of several rounds by turns.

    Raises:
        AdagenError: a solver could not be made, built or run.
    """
    toolchain = find_toolchain()
    shortest = min(chains)
    wanted = sorted({(2 * shortest, 1), *((n, p) for n in chains for p in (1, 2))})
    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        built = {}
        for joints, processes in wanted:
            on_progress(f"chain of {joints}: building (P={processes})")
            built[joints, processes] = _built(Path(folder), joints, processes, profile, toolchain)
        traces: dict[tuple[int, int], list[list[Times]]] = {key: [] for key in built}
        for k in range(rounds):
            for (joints, processes), program in built.items():
                on_progress(f"chain of {joints}: round {k + 1} of {rounds} (P={processes})")
                file = Path(folder, "trace.json")
                words = ["--trace", str(file), "--repeat", "100"]
                _ = launch(program, processes, words, toolchain, TIMEOUT).printed
                trace = json.loads(file.read_text(encoding="utf-8"))
                by_process = [
                    [row for row in trace["stages"] if row["process"] == p]
                    for p in range(processes)
                ]
                traces[joints, processes].append(
                    [times_of(rows, trace["clock_ns"]) for rows in by_process]
                )
    middle = {
        key: [_medians(own) for own in zip(*rounds_of, strict=True)]
        for key, rounds_of in traces.items()
    }
    short, twice = (sum(middle[n, 1][0].values()) for n in (shortest, 2 * shortest))
    once = max(0.0, 2 * short - twice)
    return [Parts(n, middle[n, 1][0], (middle[n, 2][0], middle[n, 2][1]), once) for n in chains]


def _built(folder: Path, joints: int, processes: int, profile: str, toolchain: Toolchain) -> Path:
    file = folder / f"chain{joints}.urdf"
    file.write_text(chain(joints), encoding="utf-8")
    found = compiled(read(file), processes, profile=profile)
    return build_executable(found.source, found.stem, toolchain)


def _medians(rounds: Sequence[Times]) -> Times:
    return {kind: median(one[kind] for one in rounds) for kind in rounds[0]}


def tables(found: Sequence[Parts]) -> str:
    """Return what was found as Markdown."""
    lines = [
        "| joints | us | P = 1 | P = 2, at the ground | beyond |",
        "|--:|---|--:|--:|--:|",
    ]
    for parts in found:
        for kind in KINDS:
            own = [times.get(kind) for times in (parts.alone, *parts.shared)]
            cells = ("" if time is None else f"{time:.2f}" for time in own)
            lines.append(f"| {parts.joints} | {kind} | {' | '.join(cells)} |")
        sums = (f"{sum(times.values()):.2f}" for times in (parts.alone, *parts.shared))
        lines.append(f"| {parts.joints} | all | {' | '.join(sums)} |")
    lines += ["", "| joints | two processes, if they took | us | saved |", "|--:|---|--:|--:|"]
    for parts in found:
        whole = sum(parts.alone.values())
        for name, time in parts.limits.items():
            lines.append(f"| {parts.joints} | {name} | {time:.2f} | {1 - time / whole:.0%} |")
    return "\n".join(lines) + "\n"


def main(words: Sequence[str] | None = None) -> int:
    """Measure what the command line names, print tables, and return the exit status."""
    parser = command(__doc__)
    parser.add_argument("--joints", type=int, nargs="+", default=JOINTS)
    parser.add_argument("--profile", default="default", help="what solvers are made with")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--priority", type=int, default=0, help="real-time, of what is timed")
    options = parser.parse_args(words)
    try:
        with speaking("chain_parts") as on_progress, at_priority(options.priority):
            found = measure(options.joints, options.profile, options.rounds, on_progress)
    except AdagenError as error:
        print(error, file=sys.stderr)
        return error.status
    on = machine()
    head = (
        f"{on['processor']}, {on['cores']} cores, {on['system']}; "
        f"{'; '.join(on['compilers'].values())}. Profile: {options.profile}. "
        f"{options.rounds} rounds by turns.\n\n"
    )
    publish(options, "chain_parts", head + tables(found))
    return 0


if __name__ == "__main__":
    sys.exit(main())
