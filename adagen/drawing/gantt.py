"""A timeline as rows of a chart: one for each process, its operations in time, its messages."""

from __future__ import annotations

from collections.abc import Mapping

from adagen.cost import Interval, Timeline
from adagen.drawing.svg import INK, MUTED, Canvas, colour, shorten, text_width, time_axis

HEIGHT = 26.0
"""Of a process's row, pixels."""
SIZE = 11.0
MOST_ROWS = 64
WAIT = "#e4e4e4"
_LEGEND = (
    ("call", 50.0),
    ("kinematics", 90.0),
    ("assembly", 80.0),
    ("disassembly", 100.0),
    ("message", 80.0),
    ("waiting", 70.0),
)

Names = Mapping[tuple[int, int], tuple[str, int]]
"""What an operation is called, and its SIMD lanes, by its process and place there."""


def legend(canvas: Canvas, x: float, y: float) -> None:
    """Draw what bars mean, from a place rightwards."""
    for what, width in _LEGEND:
        bar(canvas, "send" if what == "message" else what, 0, x, y - 9, 16, 11)
        canvas.text(x + 21, y, what, 10, fill=MUTED)
        x += 21 + width
    bar(canvas, "assembly", 0, x, y - 9, 16, 11, lanes=4)
    canvas.text(x + 21, y, "limbs in SIMD lanes", 10, fill=MUTED)


def bar(
    canvas: Canvas,
    what: str,
    process: int,
    x: float,
    y: float,
    width: float,
    height: float,
    note: str = "",
    lanes: int = 1,
) -> None:
    """Draw what a process does for a while; limbs in SIMD lanes as stripes."""
    if what in ("wait", "waiting"):
        canvas.rect(x, y, width, height, WAIT, note=note)
        return
    if what == "call":
        canvas.rect(x, y, width, height, "#ffffff", stroke=colour(process)[0], note=note)
        return
    if what in ("send", "receive"):
        canvas.rect(x, y, width, height, INK, note=note)
        return
    canvas.rect(x, y, width, height, colour(process)[0], stroke="#ffffff", note=note)
    if what == "kinematics":
        canvas.rect(x + 0.5, y + 1, max(width - 1, 0), height * 0.45, "#ffffff")
    elif what in ("disassembly", "slaved"):
        canvas.rect(x + 0.5, y + height - 6, max(width - 1, 0), 3, "#ffffff")
    for lane in range(1, lanes):
        level = y + height * lane / lanes
        canvas.path([(x, level), (x + width, level)], "#ffffff")


def process_rows(
    canvas: Canvas, line: Timeline, names: Names, left: float, top: float, width: float
) -> float:
    """Draw a timeline over the whole width; return where the next part begins.

    Args:
        canvas: to draw on.
        line: the timeline; its end is the right end of the chart.
        names: what operations are called.
        left: margin on both sides, pixels.
        top: where the first row begins.
        width: of the whole picture.
    """
    rows = sorted({i.process for i in line.intervals})[:MOST_ROWS]
    start = left + 100
    scale = (width - left - start - 70) / max(line.makespan, 1e-9)
    place = {p: top + k * HEIGHT for k, p in enumerate(rows)}
    for p in rows:
        canvas.rect(left, place[p] + 6, 12, 12, colour(p)[0])
        canvas.text(left + 18, place[p] + 16, f"process {p}", SIZE)
        share = f"{100 * line.busy(p) / line.makespan:.0f} % busy"
        canvas.text(start + line.makespan * scale + 8, place[p] + 16, share, 10, fill=MUTED)
    for interval in (*line.calls, *line.intervals):
        if interval.process in place:
            _interval(canvas, interval, names, start, place[interval.process], scale)
    for e in line.exchanges:
        if e.sender in place and e.receiver in place:
            down = place[e.receiver] > place[e.sender]
            y, y2 = place[e.sender] + HEIGHT / 2, place[e.receiver] + (2 if down else HEIGHT - 2)
            canvas.path([(start + e.sent * scale, y), (start + e.used * scale, y2)], INK)
            canvas.circle(start + e.used * scale, y2, 2, INK)
    bottom = top + HEIGHT * len(rows) + 4
    time_axis(canvas, line.makespan, start, scale, bottom)
    return bottom + 56


def _interval(
    canvas: Canvas, i: Interval, names: Names, start: float, top: float, scale: float
) -> None:
    place = -1 if i.operation is None else i.operation
    name, lanes = names.get((i.process, place), (i.what, 1))
    note = f"{name}: {i.start:.3f} to {i.end:.3f} µs"
    x, width = start + i.start * scale, (i.end - i.start) * scale
    bar(canvas, i.what, i.process, x, top + 2, width, HEIGHT - 4, note, lanes)
    if i.what not in ("assembly", "disassembly") or lanes > 1:
        return
    short = shorten(name.partition(" ")[2] or name, width - 4, 9)
    if short and not short.endswith("…") and text_width(short, 9) <= width - 4:
        ink = colour(i.process)[1]
        canvas.text(x + width / 2, top + 13, short, 9, fill=ink, anchor="middle")
