"""The record of error estimates beside true errors as Markdown."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any

from adagen.studies.bench.report import table

FACTOR = 3.0
ROUNDING = 2.0**-53
Row = dict[str, Any]


def within(estimate: float, true: float) -> bool:
    """Return whether an estimate is within a factor 3 of an error.

    What is below the rounding of a double counts as that.
    """
    estimate, true = max(estimate, ROUNDING), max(true, ROUNDING)
    return true < FACTOR * estimate < FACTOR * FACTOR * true


def judged(row: Row) -> list[str]:
    """Return what becomes of each state's estimate: "file", "own", "beyond" or "rest".

    Args:
        row: of the record; ``own`` has no number where the estimate is within the factor already.

    Returns:
        For each state whether the estimate is within the factor of the error against the file's
        truth, of that against the exact answer of the robot as it was read, or of neither. Of a
        robot at rest no error is a part of the answer.
    """

    def verdict(estimate: float, true: float, own: float | None) -> str:
        if not math.isfinite(true):
            return "rest"
        if within(estimate, true):
            return "file"
        return "own" if own is not None and within(estimate, own) else "beyond"

    return [verdict(*numbers) for numbers in zip(row["said"], row["true"], row["own"], strict=True)]


def report(rows: Sequence[Row]) -> str:
    """Return the tables of docs/records/refinement.md."""
    return "\n".join([*_summary(rows), "", *_beyond(rows), *_refused(rows)])


def _summary(rows: Sequence[Row]) -> Iterator[str]:
    within_3 = ("within 3 of the true error", "within 3 but for rounded constants")
    head = ("form, scalar, P", "runs", "refused", "states", *within_3, "at rest", "beyond")
    yield from table(head, _variants(rows))


def _variants(rows: Sequence[Row]) -> Iterator[tuple[object, ...]]:
    for variant in dict.fromkeys(tuple(row["key"][1:]) for row in rows):
        some = [row for row in rows if tuple(row["key"][1:]) == variant]
        answered = [row for row in some if "said" in row]
        count = Counter(verdict for row in answered for verdict in judged(row))
        kinds = (count[kind] for kind in ("file", "own", "rest", "beyond"))
        runs = (len(some), len(some) - len(answered), count.total())
        yield ", ".join(map(str, variant)), *runs, *kinds


def _beyond(rows: Sequence[Row]) -> Iterator[str]:
    beyond = [
        (*_named(row), s, *(f"{row[what][s]:.1e}" for what in ("said", "true", "own")))
        for row in rows
        if "said" in row
        for s, verdict in enumerate(judged(row))
        if verdict == "beyond"
    ]
    head = ("beyond: robot", "form, scalar, P", "state", "estimate", "error")
    if beyond:
        yield from (*table((*head, "of the robot as read"), beyond), "")


def _named(row: Row) -> tuple[str, str]:
    """The robot of a row, and form, scalar and processes."""
    name, *variant = row["key"]
    return name, ", ".join(map(str, variant))


def _refused(rows: Sequence[Row]) -> Iterator[str]:
    reasons: dict[tuple[str, str], list[str]] = {}
    for row in rows:
        if "refused" in row:
            name, variant = _named(row)
            reason = row["refused"].removeprefix("error: ").split(";")[0]
            reasons.setdefault((variant, reason), []).append(name)
    if reasons:
        lines = [(*key, ", ".join(names)) for key, names in reasons.items()]
        yield from table(("refused: form, scalar, P", "why", "robots"), lines)
