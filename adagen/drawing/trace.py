"""Timelines of a machine, predicted and measured, on one scale of time."""

from __future__ import annotations

from collections.abc import Sequence

from adagen.cost import Interval, Timeline
from adagen.drawing.gantt import Caption, chart, legend
from adagen.drawing.svg import MARGIN, Canvas, shorten

_WIDTH = 1100.0


def machine_svg(timelines: Sequence[Timeline], names: Sequence[str], title: str) -> str:
    """Return a drawing of timelines under each other, on one scale.

    Args:
        timelines: such as the predicted and the measured one, with as many processes each.
        names: the robot's joints.
        title: such as the robot's name.

    Returns:
        An SVG document that needs no other resource; the same bytes for the same arguments.
    """

    def caption(i: Interval) -> Caption:
        about = "" if i.joint is None else f" at {names[i.joint]}"
        about += "" if i.message is None else f" (message {i.message})"
        short = () if i.joint is None else (names[i.joint], str(i.joint))
        return Caption(f"{i.what}{about}", short)

    canvas = Canvas()
    canvas.text(MARGIN, 34, shorten(title, _WIDTH - 2 * MARGIN, 18), 18, bold=True)
    legend(canvas, 56)
    longest, top = max(line.makespan for line in timelines), 84.0
    for line in timelines:
        what = f"{line.source.capitalize()}: {line.makespan:.2f} µs"
        canvas.text(MARGIN, top, what, 13, bold=True)
        top = chart(canvas, line, caption, top + 12, _WIDTH, longest)
    return canvas.document(_WIDTH, top + MARGIN, title)
