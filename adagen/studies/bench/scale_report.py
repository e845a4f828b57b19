"""A record of scaling as tables: for people at a terminal and as Markdown."""

from __future__ import annotations

from collections.abc import Iterator

from adagen.studies.bench.report import table
from adagen.studies.bench.scale_record import PREDICTED, STRETCHES, Scale, ScaleRow

TIMES = ("joints", "P", "us", "saved", "ideal", "predicted", "off", "at speed", "residual")
"""Heads of ``times``: what is saved and the ideal are shares of the time on one process."""
BATCHES = ("hosts", "P", "own states/s", "distributed/s", "limited by")
_MARKS = (
    "≈: from stretches of computing. Off: measured beside predicted; at speed: beside what is "
    "predicted for cores as fast as the one on which the chain was timed on one process."
)
NOTE = f"us: the fastest evaluation of all turns; {_MARKS}"
_ALONE = ("joints", "generate, s", "compile, s", "source, kB", "us", "ns a joint", "× the shortest")
_SHARED = ("joints", "P", "meeting", "generate, s", "compile, s", *TIMES[2:8])


def times(scale: Scale) -> list[list[str]]:
    """Return a row for each time, a cell for each of TIMES."""
    return [_time(scale, row) for row in scale.rows]


def _time(scale: Scale, row: ScaleRow) -> list[str]:
    one = scale.row(row.joints, 1)
    ours = row.team == "adagen"
    saved = "" if one is None or one is row else f"{1 - row.least / one.least:.0%}"
    mark = "≈" if row.source == STRETCHES else ""
    return [
        str(row.joints),
        str(row.processes) if ours else row.team,
        f"{mark}{row.least / 1e3:.3g}",
        saved if ours else f"{row.least / one.least:.1f} x" if one is not None else "",
        f"{1 - 1 / row.processes:.0%}" if row.processes > 1 else "",
        "" if row.predicted is None else f"{row.predicted / 1e3:.3g}",
        _beside(row.least, row.predicted),
        _beside(row.least, row.scaled) if row.processes > 1 else "",
        f"{row.residual:.0e}",
    ]


def _beside(time: float, predicted: float | None) -> str:
    return "" if not predicted else f"{time / predicted - 1:+.0%}"


def batches(scale: Scale) -> list[list[str]]:
    """Return a row for each number of processes and hosts, a cell for each of BATCHES."""
    return [
        [
            f"{'≈' if row.source == PREDICTED else ''}{row.hosts}",
            str(row.processes),
            f"{row.in_place:.3g}",
            f"{row.distributed:.3g}",
            row.limit,
        ]
        for row in scale.batches
    ]


def markdown(scale: Scale) -> str:
    """Return the tables as Markdown."""
    return "\n".join([*_head(scale), *_alone(scale), *_shared(scale), *_batches(scale)])


def _head(scale: Scale) -> Iterator[str]:
    machine, rules = scale.machine, scale.rules
    compilers = "; ".join(machine["compilers"].values())
    yield (
        f"{machine['processor']}, {machine['cores']} cores, {machine['system']}; {compilers}. "
        f"Load before: {machine['load_before']}. Profile: {scale.profile}."
    )
    yield (
        f"{rules.rounds} rounds by turns, {rules.repeat} evaluations of each of 64 random states "
        "in a turn; the fastest evaluation. Seconds are of the processor; a program that was in "
        f"the cache took none to compile. {_MARKS}"
    )
    yield ""


def _alone(scale: Scale) -> Iterator[str]:
    rows = [row for n in scale.joints if (row := scale.row(n, 1)) is not None]
    if not rows:
        return
    first = rows[0].least / rows[0].joints
    peers = any(scale.peer(row.joints) for row in rows)
    cells = []
    for row in rows:
        each, peer = row.least / row.joints, scale.peer(row.joints)
        cells.append(
            [
                str(row.joints),
                f"{row.generated:.1f}",
                f"{row.compiled:.1f}",
                f"{row.size:.0f}",
                f"{row.least / 1e3:.2f}",
                f"{each:.1f}",
                f"{each / first:.2f}",
                *(["" if peer is None else f"{peer.least / 1e3:.1f}"] if peers else []),
            ]
        )
    yield from table((*_ALONE, *(["pinocchio, us"] if peers else [])), cells)
    yield ""


def _shared(scale: Scale) -> Iterator[str]:
    rows = [row for row in scale.rows if row.team == "adagen" and row.processes > 1]
    if rows:
        cells = []
        for row in rows:
            joints, processes, *rest = _time(scale, row)
            made = [row.meeting, f"{row.generated:.1f}", f"{row.compiled:.1f}"]
            cells.append([joints, processes, *made, *rest[:6]])
        yield from table(_SHARED, cells)
        yield ""


def _batches(scale: Scale) -> Iterator[str]:
    if scale.batches:
        yield f"Batches of {scale.robot}; ≈: predicted."
        yield ""
        yield from table(BATCHES, batches(scale))
        yield ""
