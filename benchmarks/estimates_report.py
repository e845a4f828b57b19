"""The record of error estimates beside true errors as Markdown."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any

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
    yield (
        "| form, scalar, P | runs | refused | states | within 3 of the true error | "
        "within 3 but for rounded constants | at rest | beyond |"
    )
    yield "|---|---|---|---|---|---|---|---|"
    for variant in dict.fromkeys(tuple(row["key"][1:]) for row in rows):
        some = [row for row in rows if tuple(row["key"][1:]) == variant]
        answered = [row for row in some if "said" in row]
        count = Counter(verdict for row in answered for verdict in judged(row))
        form, scalar, processes = variant
        yield (
            f"| {form}, {scalar}, {processes} | {len(some)} | {len(some) - len(answered)} | "
            f"{count.total()} | {count['file']} | {count['own']} | {count['rest']} | "
            f"{count['beyond']} |"
        )


def _beyond(rows: Sequence[Row]) -> Iterator[str]:
    beyond = [
        (row, s)
        for row in rows
        if "said" in row
        for s, verdict in enumerate(judged(row))
        if verdict == "beyond"
    ]
    if not beyond:
        return
    yield "| beyond: robot | form, scalar, P | state | estimate | error | of the robot as read |"
    yield "|---|---|---|---|---|---|"
    for row, s in beyond:
        name, form, scalar, processes = row["key"]
        yield (
            f"| {name} | {form}, {scalar}, {processes} | {s} | {row['said'][s]:.1e} | "
            f"{row['true'][s]:.1e} | {row['own'][s]:.1e} |"
        )
    yield ""


def _refused(rows: Sequence[Row]) -> Iterator[str]:
    reasons: dict[tuple[str, str], list[str]] = {}
    for row in rows:
        if "refused" in row:
            name, form, scalar, processes = row["key"]
            reason = row["refused"].removeprefix("error: ").split(";")[0]
            variant = f"{form}, {scalar}, {processes}"
            reasons.setdefault((variant, reason), []).append(name)
    if not reasons:
        return
    yield "| refused: form, scalar, P | why | robots |"
    yield "|---|---|---|"
    for (variant, reason), names in reasons.items():
        yield f"| {variant} | {reason} | {', '.join(names)} |"
