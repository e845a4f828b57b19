"""A budget in words, and the variant that keeps it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from adagen.errors import InputError, UsageError
from adagen.studies.chart.record import Point

_UNITS = {"ns": 1.0, "us": 1e3, "µs": 1e3, "μs": 1e3, "ms": 1e6, "s": 1e9}
_TERM = re.compile(r"\s*(\w+)\s*(<=?)\s*([0-9.]+(?:[eE][+-]?[0-9]+)?)\s*([^\W\d]*)\s*")


@dataclass(frozen=True)
class Budget:
    """What a variant must keep.

    Attributes:
        error: its forward error is below this; None where any will do.
        time_ns: its time is below this, ns; None where any will do.
    """

    error: float | None = None
    time_ns: float | None = None

    def keeps(self, point: Point) -> bool:
        """Whether a point is within the budget."""
        if point.error is None or point.time_ns is None:
            return False
        fast = self.time_ns is None or point.time_ns < self.time_ns
        return fast and (self.error is None or point.error < self.error)

    def best(self, points: Sequence[Point]) -> Point:
        """Return what to use: the fastest that is right enough, or the most accurate in time.

        Only what adagen emits for one state at a time is looked at. Where both are limited, the
        fastest.

        Raises:
            InputError: nothing keeps the budget; the message says what comes nearest.
        """
        single = [p for p in points if p.team == "adagen" and not p.batch]
        own = [p for p in single if p.error is not None and p.clocked]
        if not own:
            raise InputError("nothing was both solved and timed, so that no budget can be kept")

        def cost(point: Point) -> tuple[float, float]:
            assert point.time_ns is not None
            assert point.error is not None
            pair = point.time_ns, point.error
            return pair if self.error is not None else pair[::-1]

        kept = [p for p in own if self.keeps(p)]
        if kept:
            return min(kept, key=cost)
        fastest = min(own, key=lambda p: p.time_ns or 0.0)
        rightest = min(own, key=lambda p: p.error or 0.0)
        raise InputError(
            f"nothing keeps the budget; the fastest is {_figures(fastest)}, "
            f"the most accurate {_figures(rightest)}"
        )


def _figures(point: Point) -> str:
    assert point.time_ns is not None
    return f'"{point.label}" ({point.time_ns / 1e3:.3g} us, error {point.error:.1e})'


def parse_budget(text: str) -> Budget:
    """Read a budget such as ``error<1e-10``, ``time<2us`` or ``error<1e-10, time<2us``.

    Raises:
        UsageError: it is none; the message says why.
    """
    limits: dict[str, float] = {}
    for term in re.split(r",|\band\b", text):
        found = _TERM.fullmatch(term)
        if found is None:
            raise UsageError(
                f"budget '{term.strip() or text}': expected error<NUMBER or time<NUMBER UNIT, "
                "such as error<1e-10 or time<2us"
            )
        what, _, number, unit = found.groups()
        if what not in ("error", "time"):
            raise UsageError(f"budget '{term.strip()}': only error and time can be limited")
        if what in limits:
            raise UsageError(f"budget '{text}': {what} is limited twice")
        limits[what] = _limit(what, number, unit, term.strip())
    return Budget(limits.get("error"), limits.get("time"))


def _limit(what: str, number: str, unit: str, term: str) -> float:
    try:
        value = float(number)
    except ValueError:
        raise UsageError(f"budget '{term}': '{number}' is not a number") from None
    if not 0 < value < float("inf"):
        raise UsageError(f"budget '{term}': the limit must be above 0")
    if what == "error":
        if unit:
            raise UsageError(f"budget '{term}': an error has no unit; it is relative")
        return value
    if unit not in _UNITS:
        raise UsageError(f"budget '{term}': a time needs a unit: ns, us, ms or s")
    return value * _UNITS[unit]
