"""Estimates of how long a stage takes, from earlier runs of the same stage."""

from __future__ import annotations

import json
import math
import os
import tempfile
from contextlib import suppress
from pathlib import Path

KEPT = 20
"""Times that are kept of each kind of work."""

WORTH = 1.0
"""Seconds; shorter work teaches nothing."""

Times = list[tuple[float, float]]

_FIRST: dict[str, Times] = {
    "scheduling": [(15, 1.1), (29, 1.8), (200, 2.5), (1000, 7.0), (2000, 17.0)],
    "assessing": [(9, 0.12), (29, 0.28)],
    "emitting": [(9, 0.16), (29, 0.08)],
    "compiling": [(60_000, 0.8), (72_000, 1.6), (172_000, 5.7)],
}
"""What is expected on a machine on which nothing was done yet: seconds of an AMD EPYC, as `learn`
keeps them. Sizes: characters of files and sources, joints."""


def expected(kind: str, size: float) -> float | None:
    """Return about how many seconds work takes, None where nothing is known of its kind.

    The work nearest in size is scaled in proportion. It was done on this machine or, where none
    was, on the one of `_FIRST`.

    Args:
        kind: what is done, in a word.
        size: how much of it, in any unit that suits the kind.
    """
    found = _read().get(kind) or _FIRST.get(kind, [])
    if not found or size <= 0:
        return None
    known, seconds = min(reversed(found), key=lambda one: abs(math.log(one[0] / size)))
    return seconds * size / known


def learn(kind: str, size: float, seconds: float) -> None:
    """Keep how long work took; a cache that cannot be written is passed over."""
    if size <= 0 or seconds < WORTH:
        return
    known = _read()
    known[kind] = [*known.get(kind, []), (size, round(seconds, 3))][-KEPT:]
    with suppress(OSError):
        file = _file()
        file.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(prefix="pace-", dir=file.parent)
        with os.fdopen(handle, "w", encoding="utf-8") as stream:
            json.dump(known, stream)
        Path(name).replace(file)


def left(seconds: float) -> str:
    """Return words for what is left of work."""
    return f"{seconds / 60:.0f} min" if seconds > 90 else f"{seconds:.0f} s"


def _file() -> Path:
    from adagen.build.cache import cache_folder

    return cache_folder() / "pace.json"


def _read() -> dict[str, Times]:
    """Return all times that are kept; none where the file is missing or damaged."""
    with suppress(OSError, ValueError, TypeError, AttributeError):
        stored = json.loads(_file().read_text(encoding="utf-8"))
        return {
            str(kind): [(float(size), float(took)) for size, took in rows if size > 0 < took]
            for kind, rows in stored.items()
        }
    return {}
