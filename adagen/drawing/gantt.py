"""A timeline as rows of a chart: one for each process, its work in time, its messages."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from adagen.cost import Interval, Timeline
from adagen.drawing.svg import INK, MARGIN, MUTED, SIZE, Canvas, colour, text_width, time_axis
from adagen.errors import printable

HEIGHT = 26.0
"""Of a process's row, pixels."""
MOST_ROWS = 64
_WAIT = "#e4e4e4"
_LEGEND = (
    ("call", 50.0),
    ("kinematics", 90.0),
    ("assembly", 80.0),
    ("disassembly", 100.0),
    ("message", 80.0),
    ("waiting", 70.0),
)


@dataclass(frozen=True)
class Caption:
    """What a bar says.

    Attributes:
        note: under a pointer, before its times.
        short: inside, the first that fits as a whole.
        lanes: SIMD lanes; limbs in several are drawn as stripes.
    """

    note: str
    short: tuple[str, ...] = ()
    lanes: int = 1


Captions = Callable[[Interval], Caption]


def legend(canvas: Canvas, y: float) -> None:
    """Draw what bars mean, from the left margin rightwards."""
    x = MARGIN
    for what, width in _LEGEND:
        _bar(canvas, "send" if what == "message" else what, 0, x, y - 9, 16, 11)
        canvas.text(x + 21, y, what, 10, fill=MUTED)
        x += 21 + width
    _bar(canvas, "assembly", 0, x, y - 9, 16, 11, lanes=4)
    canvas.text(x + 21, y, "limbs in SIMD lanes", 10, fill=MUTED)


def _bar(
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
        canvas.rect(x, y, width, height, _WAIT, note=note)
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


def chart(
    canvas: Canvas, line: Timeline, captions: Captions, top: float, width: float, end: float = 0.0
) -> float:
    """Draw a timeline over the whole width; return where the next part begins.

    Args:
        canvas: to draw on.
        line: the timeline.
        captions: what its bars say.
        top: where the first row begins, pixels.
        width: of the whole picture.
        end: of the axis of time, microseconds, if that is later than the timeline's.
    """
    end = max(end, line.makespan, 1e-9)
    rows = sorted({i.process for i in line.intervals})[:MOST_ROWS]
    start = MARGIN + 100
    scale = (width - MARGIN - start - 70) / end
    place = {p: top + k * HEIGHT for k, p in enumerate(rows)}
    for p in rows:
        canvas.rect(MARGIN, place[p] + 6, 12, 12, colour(p)[0])
        canvas.text(MARGIN + 18, place[p] + 16, f"process {p}", SIZE)
        share = f"{100 * line.busy(p) / line.makespan:.0f} % busy"
        canvas.text(start + end * scale + 8, place[p] + 16, share, 10, fill=MUTED)
    for interval in (*line.calls, *line.intervals):
        if interval.process in place:
            _interval(canvas, interval, captions, start, place[interval.process], scale)
    for e in line.exchanges:
        if e.sender in place and e.receiver in place:
            down = place[e.receiver] > place[e.sender]
            y, y2 = place[e.sender] + HEIGHT / 2, place[e.receiver] + (2 if down else HEIGHT - 2)
            canvas.path([(start + e.sent * scale, y), (start + e.used * scale, y2)], INK)
            canvas.circle(start + e.used * scale, y2, 2, INK)
    bottom = top + HEIGHT * len(rows) + 4
    time_axis(canvas, end, start, scale, bottom)
    return bottom + 56


def _interval(
    canvas: Canvas, i: Interval, captions: Captions, start: float, top: float, scale: float
) -> None:
    caption = captions(i)
    note = f"{caption.note}: {i.start:.3f} to {i.end:.3f} µs"
    x, width = start + i.start * scale, (i.end - i.start) * scale
    _bar(canvas, i.what, i.process, x, top + 2, width, HEIGHT - 4, note, caption.lanes)
    if i.what not in ("assembly", "disassembly") or caption.lanes > 1:
        return
    fitting = (text for text in caption.short if text_width(printable(text), 9) <= width - 4)
    if short := next(fitting, ""):
        canvas.text(x + width / 2, top + 13, short, 9, fill=colour(i.process)[1], anchor="middle")
