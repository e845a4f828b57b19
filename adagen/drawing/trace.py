"""Gantt charts of what a machine does, predicted and measured, on one scale of time."""

from __future__ import annotations

from collections.abc import Sequence

from adagen.cost.play import Interval, Timeline
from adagen.drawing.gantt import bar, legend
from adagen.drawing.svg import INK, MUTED, Canvas, colour, shorten, text_width, time_axis

MARGIN = 24.0
LANE = 22.0
SIZE = 11.0
WIDTH = 1100.0
MOST_LANES = 64


def machine_svg(timelines: Sequence[Timeline], names: Sequence[str], title: str) -> str:
    """Return a drawing of timelines under each other, on one scale.

    Args:
        timelines: such as the predicted and the measured one, with as many processes each.
        names: the robot's joints.
        title: such as the robot's name.

    Returns:
        An SVG document that needs no other resource; the same bytes for the same arguments.
    """
    canvas = Canvas()
    canvas.text(MARGIN, 34, shorten(title, WIDTH - 2 * MARGIN, 18), 18, bold=True)
    legend(canvas, MARGIN, 56)
    longest = max(max(line.makespan for line in timelines), 1e-9)
    left = MARGIN + 100
    scale = (WIDTH - left - MARGIN - 90) / longest
    top = 84.0
    for line in timelines:
        top = _chart(canvas, line, names, left, top, scale, longest)
    return canvas.document(WIDTH, top + MARGIN, title)


def _chart(
    canvas: Canvas,
    line: Timeline,
    names: Sequence[str],
    left: float,
    top: float,
    scale: float,
    longest: float,
) -> float:
    """Draw one timeline; return where the next part begins."""
    what = f"{line.source.capitalize()}: {line.makespan:.2f} µs"
    canvas.text(MARGIN, top, what, 13, bold=True)
    lanes = sorted({i.process for i in line.intervals})[:MOST_LANES]
    place = {p: top + 12 + k * LANE for k, p in enumerate(lanes)}
    for p in lanes:
        label = shorten(f"process {p}", left - MARGIN - 8, SIZE)
        canvas.text(MARGIN, place[p] + 15, label, SIZE)
        share = f"{100 * line.busy(p) / line.makespan:.0f} % busy"
        canvas.text(left + longest * scale + 8, place[p] + 15, share, 10, fill=MUTED)
    for i in (*line.calls, *line.intervals):
        if i.process in place:
            x, y = left + i.start * scale, place[i.process] + 2
            width = (i.end - i.start) * scale
            bar(canvas, i.what, i.process, x, y, width, LANE - 4, _note(i, names))
            if i.joint is not None and i.what in ("assembly", "disassembly"):
                name = shorten(names[i.joint], width - 4, 9)
                if name and text_width(name, 9) <= width - 4 and not name.startswith("…"):
                    ink = colour(i.process)[1]
                    canvas.text(x + width / 2, y + 9.5, name, 9, fill=ink, anchor="middle")
    for e in line.exchanges:
        if e.sender in place and e.receiver in place:
            down = place[e.receiver] > place[e.sender]
            y, y2 = place[e.sender] + LANE / 2, place[e.receiver] + (2 if down else LANE - 2)
            canvas.path([(left + e.sent * scale, y), (left + e.used * scale, y2)], INK)
            canvas.circle(left + e.used * scale, y2, 2, INK)
    bottom = top + 12 + LANE * len(lanes) + 4
    time_axis(canvas, longest, left, scale, bottom)
    return bottom + 44


def _note(i: Interval, names: Sequence[str]) -> str:
    about = "" if i.joint is None else f" at {names[i.joint]}"
    about += "" if i.message is None else f" (message {i.message})"
    return f"{i.what}{about}: {i.start:.3f} to {i.end:.3f} µs"
