"""A loop over rows of joints in a straight line: what it finds in memory, and its tables."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

from adagen.emit.unrolled.text import TYPES, Text
from adagen.executor import Machine, Swept
from adagen.executor.swept_records import Pass


def kept_lines(machine: Machine, text: Text) -> dict[int, list[str]]:
    """Return by index the lines that leave values in memory, but for those stored there anyway."""
    lines: dict[int, list[str]] = defaultdict(list)
    swept = machine.swept
    if swept is None:
        return lines
    stored = swept.first_places()
    for place, x, lanes in swept.left:
        if stored.get(x.index) == place and not _given(x.node.op):
            continue
        name = text.name(x.index)
        if lanes == 1:
            lines[x.index].append(f"w.x[{place}] = {name};")
        else:
            wide = name if x.node.width == lanes else f"{TYPES[lanes]}{{}} + {name}"
            lines[x.index].append(f"put({wide}, w.x.data() + {place});")
    return lines


def _given(op: str) -> bool:
    return op in ("input", "constant")


def sweep_line(swept: Swept, p: int) -> str:
    """Return the line that sweeps residuals of process p."""
    flags = (swept.floats, swept.closed, swept.slides, swept.rotors)
    kinds = f"SweptKinds<{', '.join(str(flag).lower() for flag in flags)}>"
    places = f"kSwept_{p}, kSweptPasses_{p}, kSweptConstants_{p}, {swept.gathered}, {swept.sums}"
    return f"sweep_rows<{TYPES[swept.lanes]}, {kinds}>(w, {places});"


def swept_values(swept: Swept | None, text: Text, zero: int) -> dict[str, object]:
    """Return the template's values for the tables.

    Args:
        swept: what a line leaves; None for none.
        text: of its values.
        zero: a place among angles whose sine and cosine are zero.
    """
    if swept is None:
        return {}
    rows = []
    for row in swept.rows:
        angles = [zero if k is None else k for k in row.angles]
        places = ", ".join(map(str, angles))
        flags = ", ".join(str(flag).lower() for flag in (row.next, row.added, row.slides))
        count = 0 if row.next else len(row.passes)
        rows.append(f"{{{row.place}, {count}, {flags}, {{{places}}}}}")
    numbers = [
        [text.literal(x.node.value) for x in numbers]
        for row in swept.rows
        for numbers in row.constants
    ]
    handed = [[] if row.next else row.passes for row in swept.rows]
    passes = [_pass(each, own[k + 1 :]) for own in handed for k, each in enumerate(own)]
    count = swept.lanes * len(numbers)
    return {
        "lanes": swept.lanes,
        "rows": rows,
        "passes": passes,
        "constants": numbers,
        "constant_count": count,
    }


def _pass(each: Pass, others: Sequence[Pass]) -> str:
    more = bool(others) and others[0].near == each.near
    sources = ", ".join(str(k or 0) for k in each.sources)
    counts = ", ".join(str(int(k is not None)) for k in each.sources)
    return f"{{{each.near}, {str(more).lower()}, {{{sources}}}, {{{counts}}}}}"
