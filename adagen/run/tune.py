"""Shape, function length and compiler of the fastest code here, found by building and timing."""

from __future__ import annotations

import json
import shutil
import time
from collections.abc import Callable, Iterable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path

from adagen.build.cache import Progress, build_executable
from adagen.build.toolchain import Toolchain, with_compiler
from adagen.errors import EnvironmentFault
from adagen.run.launch import launch

CHUNKS = (250, 1000, 4000)
"""Lengths of functions that are tried where the code is a straight line."""

_ROUNDS = 5
_REPEAT = "20"  # evaluations of each of 64 random states in a round
_TIMEOUT = 120.0


@dataclass(frozen=True)
class Candidate:
    """One way to emit and compile a plan.

    Attributes:
        shape: shape of the code.
        chunk: values that one function computes; 0 where the shape does not ask.
        compiler: what the MPI wrapper is to call; "" for its own choice.
    """

    shape: str
    chunk: int = 0
    compiler: str = ""

    def __str__(self) -> str:
        """All of it in a few words."""
        length = f", functions of {self.chunk} values" if self.chunk else ""
        return f"{self.shape}{length}, {self.compiler or 'default compiler'}"


@dataclass(frozen=True)
class Trial:
    """What became of a candidate.

    Attributes:
        candidate: the candidate.
        nanoseconds: of an evaluation: the least median of several rounds; None where it failed.
        seconds: that its compilation took.
        failure: why it failed, else "".
        source: of the nanoseconds: "clock", or "stretches" of computing, played through, where
            there are more processes than cores.
    """

    candidate: Candidate
    nanoseconds: float | None
    seconds: float
    failure: str = ""
    source: str = "clock"


def candidates(shapes: Iterable[str], compilers: Sequence[str]) -> list[Candidate]:
    """Return what is worth trying of the shapes, under each compiler."""
    ways = [
        (shape, chunk) for shape in shapes for chunk in (CHUNKS if shape == "unrolled" else (0,))
    ]
    return [Candidate(shape, chunk, compiler) for shape, chunk in ways for compiler in compilers]


def compilers() -> tuple[str, ...]:
    """Return the compilers to try: the wrapper's own, and clang++ where it is installed."""
    return ("", "clang++") if shutil.which("clang++") else ("",)


def tune(
    tried: Sequence[Candidate],
    text_of: Callable[[Candidate], str],
    name: str,
    processes: int,
    toolchain: Toolchain,
    progress: Progress | None = None,
) -> list[Trial]:
    """Build every candidate, time them in turn, and return them with the fastest first.

    Candidates of the same text and compiler are tried once, under the first of their names.

    Args:
        tried: the candidates.
        text_of: emits one.
        name: file name of the executables.
        processes: how many processes run it.
        toolchain: what to build and run with.
        progress: makes the context in which one is built or timed, from a line that says so.

    Raises:
        EnvironmentFault: not one could be built and run.
    """
    show = progress or (lambda *_: nullcontext())
    seen: set[tuple[str, str]] = set()
    trials: list[Trial] = []
    built = []
    for k, candidate in enumerate(tried, start=1):
        text = text_of(candidate)
        if (text, candidate.compiler) in seen:
            continue
        seen.add((text, candidate.compiler))
        tools = with_compiler(toolchain, candidate.compiler)
        start = time.perf_counter()
        try:
            with show(f"building candidate {k} of {len(tried)}: {candidate}", len(text)):
                executable = build_executable(text, name, tools)
            built.append((candidate, executable, time.perf_counter() - start))
        except EnvironmentFault as fault:
            trials.append(Trial(candidate, None, time.perf_counter() - start, str(fault)))
    least: dict[Candidate, float] = {}
    source = "clock"
    for turn in range(1, _ROUNDS + 1):
        with show(f"timing {len(built)} candidates, round {turn} of {_ROUNDS}", len(built)):
            for candidate, executable, _ in built:
                found, source = _median(executable, processes, toolchain)
                least[candidate] = min(found, least.get(candidate, found))
    trials += [Trial(c, least[c], seconds, source=source) for c, _, seconds in built]
    trials.sort(key=lambda trial: (trial.nanoseconds is None, trial.nanoseconds or 0.0))
    if not trials or trials[0].nanoseconds is None:
        raise EnvironmentFault(trials[0].failure if trials else "there is nothing to try")
    return trials


def _median(executable: Path, processes: int, toolchain: Toolchain) -> tuple[float, str]:
    """Time an executable once; ns, and by what."""
    words = ["--time", "--json", "--repeat", _REPEAT]
    done = launch(executable, processes, words, toolchain, _TIMEOUT)
    if done.status != 0:
        raise EnvironmentFault(f"{executable.name} cannot be timed: {done.stderr}")
    times = json.loads(done.stdout)["time"]
    return float(times["in_place"]["median_ns"]), str(times["source"])


def table(trials: Sequence[Trial]) -> str:
    """Return what was tried as a table, the fastest first."""
    rows = [("ns", "compiled in", "shape, functions, compiler")]
    for trial in trials:
        time_text = "failed" if trial.nanoseconds is None else f"{trial.nanoseconds:.0f}"
        note = f": {trial.failure}" if trial.failure else ""
        rows.append((time_text, f"{trial.seconds:.1f} s", f"{trial.candidate}{note}"))
    widths = [max(len(row[k]) for row in rows) for k in range(2)]
    return "\n".join(f"{a:>{widths[0]}}  {b:>{widths[1]}}  {c}" for a, b, c in rows)
