"""Adagen's own solvers of a robot in a contest: what is asked for, emitted and built."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from dataclasses import dataclass

from adagen.build import find_toolchain
from adagen.errors import AdagenError, UsageError
from adagen.library import Request, Robot
from adagen.library.compiled import compiled
from adagen.run import cores
from adagen.studies.bench.contest import Contestant, Progress
from adagen.studies.bench.emitted import Emitted, all_built

VARIANTS = (
    "--procs 1",
    "--procs 2",
    "--procs 4",
    "--procs 1 --scalar float",
    "--procs 1 --shape unrolled",
    "--procs 1 --shape kernels",
    "--procs 1 --batch",
    "--procs 2 --batch",
    "--procs 1 --batch --scalar float",
)
"""What adagen is asked for, in its own command line's words; what it cannot do is skipped."""
MOST_TURNS = 16
"""Processes that are timed in turns, by their stretches, where there are fewer cores."""
MOST_TEXT = 4_000_000
"""Characters of a source that is still built: with more, a contest would be one of compilers."""
_NAMED = {"--procs", "--shape", "--scalar"}
"""Options that a contestant's name tells in its own way."""


@dataclass(frozen=True)
class Variant:
    """What adagen is asked for.

    Attributes:
        words: as its command line says it; without the robot.
        request: the same, read.
    """

    words: str
    request: Request


def built(
    robot: Robot, variants: Sequence[Variant], absent: dict[str, str], on_progress: Progress
) -> list[Contestant]:
    """Return adagen's contestants, built; why others are missing goes into ``absent``."""
    sources: dict[str, Emitted] = {}
    for variant in variants:
        try:
            emitted = _emitted(robot, variant)
        except AdagenError as error:
            absent[f"adagen {variant.words}"] = error.reason
            continue
        sources.setdefault(emitted.name, emitted)  # `auto` has often chosen one of the others
    found, gone = all_built(sources, find_toolchain(), on_progress, stretches=True)
    absent |= gone
    return list(found.values())


def _emitted(robot: Robot, variant: Variant) -> Emitted:
    """Return a variant's source and what is predicted of it.

    Raises:
        AdagenError: this adagen cannot do it, or not for this robot.
    """
    request = variant.request
    most = cores() if request.batch else max(cores(), MOST_TURNS)
    if request.procs > most:
        raise UsageError(f"{request.procs} processes: at most {most} are timed on {cores()} cores")
    made = compiled(robot, request)
    shape = made.program.shape
    if len(made.source) > MOST_TEXT:
        raise UsageError(
            f"shape {shape}: {len(made.source) / 1e6:.1f} million characters of source take "
            "minutes to compile"
        )
    words = shlex.split(variant.words)
    more = [w for k, w in enumerate(words) if not {w, *words[k - 1 : k]} & _NAMED]
    names = [shape, *([request.scalar] if request.scalar != "double" else []), *more]
    return Emitted(
        name=f"adagen P={request.procs}, {', '.join(names)}",
        model=robot.model,
        file=f"{made.stem}.cpp",
        text=made.source,
        build=f"form {request.form}, shape {shape}",
        processes=request.procs,
        scalar=f"{request.scalar} lanes" if request.batch else request.scalar,
        predicted=None if made.predicted is None else 1e3 * made.predicted,
    )
