"""The data of a report's page.

All of it is taken from the compiled solver: the model, the program and its timeline. The page draws
it and computes only the poses of joints while they are moved.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from adagen.cost import Interval, Timeline
from adagen.drawing.program import operation_name
from adagen.drawing.svg import colour
from adagen.library import Compiled
from adagen.plan.simd_groups import Limbs
from adagen.program import Operation, Program
from adagen.program.summary import lanes, owners, title
from adagen.report.accuracy import Accuracy
from adagen.report.robot import robot
from adagen.studies.chart import Chart

VERSION = 2


@dataclass(frozen=True)
class Measured:
    """What a run of the built program says.

    Attributes:
        median: of an evaluation, microseconds.
        least: of an evaluation, microseconds.
        source: "clock", or "stretches" of computing.
        error: largest forward error of the answers that were checked, or None.
        digits: certain digits of the accelerations, or None.
        right: whether the check was passed.
        timeline: what each process did when; None where the program tells none.
    """

    median: float
    least: float
    source: str
    error: float | None
    digits: float | None
    right: bool
    timeline: Timeline | None


@dataclass(frozen=True)
class Scene:
    """What a scene removed and saved: its file, and lines for people."""

    file: str
    lines: tuple[str, ...]


def document(
    made: Compiled,
    commands: Mapping[str, str],
    *,
    measured: Measured | None = None,
    accuracy: Accuracy | None = None,
    scene: Scene | None = None,
    chart: Chart | None = None,
    remarks: Sequence[str] = (),
) -> dict[str, Any]:
    """Return the document of a report: JSON types alone, every number finite.

    Args:
        made: what was compiled.
        commands: the command behind each part: "page", "robot", "program", "measured",
            "accuracy", "scene", "chart"; and "run", "record": what adds the parts that are missing.
        measured: what a run says, if there was one.
        accuracy: errors beside their bounds, if there was a run.
        scene: what a scene did, if there was one.
        chart: error against time of variants of this robot, if there is a record.
        remarks: warnings, and what is not modelled.
    """
    program = made.program
    predicted = None if made.request.batch else made.timeline
    phases = {} if predicted is None else _phases(program, predicted)
    return {
        "version": VERSION,
        "robot": robot(made.model, owners(program)),
        "program": {
            "title": title(program),
            "shape": program.shape,
            "form": made.request.form,
            "scalar": made.request.scalar,
            "profile": made.request.profile,
            "untimed": _untimed(made),
            "colours": [colour(p) for p in range(len(program.processes))],
            "lanes": [{"process": p, "lanes": limbs.lanes} for p, limbs in lanes(program)],
            "timelines": [
                _timeline(program, line, phases)
                for line in (predicted, None if measured is None else measured.timeline)
                if line is not None
            ],
        },
        "figures": _figures(made, measured),
        "accuracy": None if accuracy is None else asdict(accuracy),
        "scene": None if scene is None else {"file": scene.file, "lines": list(scene.lines)},
        "chart": None if chart is None else _chart(chart),
        "remarks": list(remarks),
        "commands": dict(commands),
    }


def _untimed(made: Compiled) -> str | None:
    """Return why no timeline is predicted; None where one is."""
    if made.request.batch:
        return "No timeline is shown of a batch: processes share its states."
    if made.timeline is not None:
        return None
    return f"No timeline is predicted: the profile {made.request.profile} prices joins alone."


Phase = tuple[int, str, int]
"""A process, what it does, and how many messages it has sent and received before."""


def _numbered(line: Timeline) -> Iterator[tuple[Phase, Interval]]:
    """Yield the intervals of a timeline, each with the phase that it belongs to."""
    before: Counter[int] = Counter()
    for each in (*line.calls, *line.intervals):
        yield (each.process, each.what, before[each.process]), each
        before[each.process] += each.what in ("send", "receive")


def _phases(program: Program, line: Timeline) -> dict[Phase, list[str]]:
    """Return the limbs that each SIMD lane computes in a phase, for phases that use lanes."""
    found: dict[Phase, list[list[str]]] = {}
    for phase, each in _numbered(line):
        operation = each.operation
        if operation is None:
            continue
        limbs = _lanes(program, program.processes[each.process].operations[operation])
        rows = found.setdefault(phase, [])
        rows += [[] for _ in limbs[len(rows) :]]
        for row, limb in zip(rows, limbs, strict=False):
            if limb not in row:
                row.append(limb)
    return {phase: [", ".join(row) for row in rows] for phase, rows in found.items() if rows}


def _timeline(
    program: Program, line: Timeline, phases: Mapping[Phase, list[str]]
) -> dict[str, Any]:
    return {
        "source": line.source,
        "makespan": line.makespan,
        "busy": [line.busy(p) for p in range(len(program.processes))],
        "waiting": [line.waiting(p) for p in range(len(program.processes))],
        "intervals": [
            {
                "process": each.process,
                "what": each.what,
                "start": each.start,
                "end": each.end,
                **_words(program, each, phases.get(phase, [])),
            }
            for phase, each in _numbered(line)
        ],
        "exchanges": [
            {"from": each.sender, "to": each.receiver, "sent": each.sent, "used": each.used}
            for each in line.exchanges
        ],
    }


def _words(program: Program, each: Interval, lanes: list[str]) -> dict[str, Any]:
    """Return the name of an interval, and the contents of each SIMD lane.

    Args:
        program: the program.
        each: an interval; where it was measured it is a joint of form ada, else a whole phase.
        lanes: what the phase computes in each.
    """
    if each.operation is None:
        if each.joint is None or program.plan.form != "ada":
            return {"name": "", "lanes": lanes}
        return {"name": program.plan.joints[each.joint].name, "lanes": []}
    operation = program.processes[each.process].operations[each.operation]
    return {"name": operation_name(program, operation), "lanes": _lanes(program, operation)}


def _lanes(program: Program, operation: Operation) -> list[str]:
    """Return the limb in each lane of an operation, by its first and last joint."""
    if not isinstance(operation.block, Limbs):
        return []
    joints, rows = program.plan.joints, operation.block.rows
    ends = zip(rows[0], rows[-1], strict=True)
    return [" .. ".join(joints[j].name for j in dict.fromkeys(pair)) for pair in ends]


def _figures(made: Compiled, measured: Measured | None) -> list[dict[str, Any]]:
    """Return rows of a table: what, as predicted, as measured, its unit."""
    digits = None if made.digits is None else round(made.digits, 1)
    median, least, sure, error = (
        (None, None, None, None)
        if measured is None
        else (measured.median, measured.least, measured.digits, measured.error)
    )
    once = "a state of a batch" if made.request.batch else "an evaluation"
    rows: list[tuple[str, float | None, float | None, str]] = [
        (f"time of {once}", made.predicted, median, "µs"),
        ("least time", None, least, "µs"),
        ("right digits of an acceleration", digits, sure, ""),
        ("largest error", None, error, "relative"),
    ]
    return [
        {"what": what, "predicted": one, "measured": two, "unit": unit}
        for what, one, two, unit in rows
        if one is not None or two is not None
    ] + _verdict(measured)


def _verdict(measured: Measured | None) -> list[dict[str, Any]]:
    if measured is None:
        return []
    verdict = "right" if measured.right else "wrong"
    if measured.source != "clock":
        verdict += "; times computed from measured stretches of computing"
    return [{"what": "answers", "predicted": None, "measured": verdict, "unit": ""}]


def _chart(chart: Chart) -> dict[str, Any]:
    return {
        "model": chart.model,
        "machine": chart.machine,
        "states": chart.states,
        "points": [
            {
                "label": point.label,
                "team": point.team,
                "time": point.time_ns / 1e3,
                "error": point.error,
                "front": point.front,
                "emitted": point.team == "adagen" and not point.batch and point.clocked,
            }
            for point in chart.points
            if point.time_ns is not None and point.error is not None
        ],
    }
