"""The record of predicted and measured times as Markdown."""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from statistics import median

import numpy as np

from adagen.cost import state_time
from adagen.emit import program_of
from adagen.emit.shapes import predict
from adagen.plan import Plan, plan_from_json
from adagen.schedule import CostProfile, load_profile
from adagen.studies.bench.report import table


@dataclasses.dataclass(frozen=True)
class Row:
    """A program's measured and predicted time, microseconds; ``played`` if from stretches.

    Of batches, times are of a state.
    """

    model: str
    label: str
    shape: str
    measured: float
    predicted: float
    fastest: float
    played: bool

    @property
    def error(self) -> float:
        """Relative error of the prediction."""
        return self.predicted / self.measured - 1


def spearman(a: Sequence[float], b: Sequence[float]) -> float:
    """Return the rank correlation of two lists; what is equal shares its ranks.

    It is nan where all of a list is equal.
    """
    if min(len(set(a)), len(set(b))) < 2:
        return math.nan
    ranks = []
    for x in (a, b):
        _, place, counts = np.unique(np.asarray(x), return_inverse=True, return_counts=True)
        ranks.append((np.cumsum(counts) - (counts - 1) / 2)[place])
    return float(np.corrcoef(ranks[0], ranks[1])[0, 1])


def report(path: Path, profile: str, machine: str) -> str:
    """Return the tables of docs/records/prediction.md.

    Args:
        path: the record.
        profile: name or file of the cost profile.
        machine: what was measured on.
    """
    costs = load_profile(profile)
    rows = [
        Row(
            row["model"],
            row["label"],
            row["shape"],
            row["measured"]["time"],
            _predicted(plan_from_json(row["plan"]), costs, row["shape"], row["batch"]),
            row["measured"]["best"],
            row["measured"]["source"] == "stretches",
        )
        for row in json.loads(path.read_text())
    ]
    names = list(dict.fromkeys(row.model for row in rows))
    lines = [*_summary(rows, names, costs.name, machine), *_by_model(rows, names), *_all(rows)]
    return "\n".join(lines)


def _predicted(plan: Plan, profile: CostProfile, shape: str, batch: bool) -> float:
    if batch:
        return state_time(program_of(plan, shape, batch=True, profile=profile), profile)
    return predict(plan, profile, shape).makespan


def _batch(row: Row) -> bool:
    return row.label.startswith("batch")


GROUPS: dict[str, Callable[[Row], bool]] = {
    "P = 1 and 2": lambda row: "P=4" not in row.label and not _batch(row),
    "form segment, P = 1": lambda row: row.label.startswith("segment, P=1"),
    "form segment, P = 2": lambda row: row.label.startswith("segment, P=2"),
    "form segment, P = 4": lambda row: row.label.startswith("segment, P=4"),
    "form ada": lambda row: row.label.startswith("ada"),
    "batches, of a state": _batch,
    "shape `kernels`": lambda row: row.shape == "kernels" and not _batch(row),
    "shape `joints`": lambda row: row.shape == "joints" and not _batch(row),
    "shape `unrolled`": lambda row: row.shape == "unrolled" and not _batch(row),
}


def _summary(rows: list[Row], names: list[str], profile: str, machine: str) -> Iterator[str]:
    yield f"Machine: {machine}. Profile: `{profile}`. {len(names)} robots, {len(rows)} programs.\n"
    lines = []
    for title, wanted in GROUPS.items():
        some = [row for row in rows if wanted(row)]
        if not some:
            continue
        title += ", from stretches" if all(row.played for row in some) else ""
        lines.append(_line(title, [(row.predicted, row.measured) for row in some]))
    fastest = [(row.predicted, row.fastest) for row in rows if not _batch(row)]
    lines.append(_line("all P, against the fastest evaluation", fastest))
    head = ("programs", "count", "median error", "90 % below", "largest", "rank correlation")
    yield from table(head, lines)
    yield ""
    yield (
        "The fastest evaluation is what the machine does undisturbed: with two processes on two "
        "cores, whatever else\nruns delays one of them in many evaluations, and the median too.\n"
    )
    if any(row.played for row in rows):
        yield (
            "≈: more processes than cores. A wall time means nothing then; what each process "
            "computes between messages is\nmeasured by itself, and played through with what the "
            "profile says of messages ([benchmarks](benchmarks.md)).\n"
        )


def _line(title: str, pairs: Sequence[tuple[float, float]]) -> tuple[object, ...]:
    """A row of the summary, of predicted and measured times."""
    sizes = sorted(abs(predicted / measured - 1) for predicted, measured in pairs)
    rank = spearman(*zip(*pairs, strict=True))
    shown = (median(sizes), sizes[int(0.9 * (len(sizes) - 1))], sizes[-1])
    return title, len(pairs), *(f"{size:.1%}" for size in shown), f"{rank:.3f}"


def _by_model(rows: list[Row], names: list[str]) -> Iterator[str]:
    yield "## The order of schedules\n"
    yield (
        "For each robot: the rank correlation over its programs on one and two processes, and how "
        "much slower the schedule\nthat is predicted to be the fastest really is than the fastest "
        "one.\n"
    )
    ranks, lines = [], []
    for name in names:
        some = [row for row in rows if row.model == name and GROUPS["P = 1 and 2"](row)]
        ranks.append(spearman([r.predicted for r in some], [r.measured for r in some]))
        chosen = min(some, key=lambda r: r.predicted).measured
        lost = chosen / min(r.measured for r in some) - 1
        typical = median(abs(r.error) for r in some)
        lines.append((name, len(some), f"{typical:.1%}", f"{ranks[-1]:.2f}", f"{lost:.1%}"))
    head = ("robot", "programs", "median error", "rank correlation")
    yield from table((*head, "lost by trusting the prediction"), lines)
    yield f"\nMedian of the rank correlations: {median(ranks):.2f}.\n"


def _all(rows: list[Row]) -> Iterator[str]:
    yield "## All programs\n"
    head = ("robot", "schedule", "shape", "measured (µs)", "fastest (µs)", "predicted (µs)")
    lines = (
        (
            *(r.model, r.label, r.shape, f"{'≈' if r.played else ''}{_shown(r.measured)}"),
            *(_shown(r.fastest), _shown(r.predicted), f"{r.error:+.1%}"),
        )
        for r in rows
    )
    yield from table((*head, "error"), lines)


def _shown(time: float) -> str:
    return f"{time:.2f}" if time >= 0.5 else f"{time:.3g}"
