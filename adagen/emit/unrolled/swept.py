"""A loop over rows of joints in a straight line: what it finds in memory, and its tables."""

from __future__ import annotations

from collections import defaultdict

from adagen.emit.unrolled.text import TYPES, Text
from adagen.executor import Machine, Swept


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
    kind = ", ".join([TYPES[swept.lanes], *(str(x).lower() for x in (swept.floats, swept.closed))])
    places = f"{swept.gathered}, {swept.sums}"
    return f"sweep_rows<{kind}>(w, kSwept_{p}, kSweptConstants_{p}, {places});"


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
        near = ", ".join(map(str, row.near))
        beside = str(row.aligned).lower()
        places = ", ".join(map(str, angles))
        rows.append(f"{{{row.place}, {row.hands_on}, {beside}, {{{places}}}, {{{near}}}}}")
    numbers = [
        [text.literal(x.node.value) for x in numbers]
        for row in swept.rows
        for numbers in row.constants
    ]
    count = swept.lanes * len(numbers)
    return {"lanes": swept.lanes, "rows": rows, "constants": numbers, "constant_count": count}
