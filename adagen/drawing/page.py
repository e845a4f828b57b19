"""A complete picture: title, timeline, and two outlines beside each other."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from adagen.cost import Timeline
from adagen.drawing.gantt import Captions, chart, legend
from adagen.drawing.outline import Row, robot_rows
from adagen.drawing.svg import MARGIN, MUTED, SIZE, Canvas, colour, shorten, text_width
from adagen.schedule import Topology

ROW = 18.0
INDENT = 20.0
NAME = 240.0
"""Most width for a joint's name, pixels."""
LEAST_WIDTH, MOST_WIDTH = 960.0, 1920.0
_PER_BAR = 26.0  # pixels of the chart's width for each bar of the busiest process


@dataclass(frozen=True)
class Outline:
    """A tree with its heading.

    Attributes:
        heading: above it.
        about: what its rows say.
        rows: each with its name and note.
        process: of each joint: the number in its circle, and its colour.
    """

    heading: str
    about: str
    rows: list[tuple[Row, str, str]]
    process: Mapping[int, int]

    @property
    def notes(self) -> float:
        """Where the notes of rows begin, from the left edge, pixels."""
        ends = (row.indent * INDENT + text_width(name, SIZE) for row, name, _ in self.rows)
        return max(ends) + 30

    @property
    def width(self) -> float:
        """Of all of it, pixels."""
        return self.notes + max(text_width(note, 9) for _, _, note in self.rows)

    def draw(self, canvas: Canvas, x: float, y: float) -> None:
        """Draw its rows from a place on, downwards."""

        def centre(row: int) -> tuple[float, float]:
            return x + 7 + self.rows[row][0].indent * INDENT, y + row * ROW

        notes = x + self.notes
        for i, (row, _, _) in enumerate(self.rows):
            if row.above >= 0:
                (px, py), (cx, cy) = centre(row.above), centre(i)
                canvas.path([(px, py), (px, cy), (cx, cy)] if px != cx else [(px, py), (cx, cy)])
        for i, (row, name, note) in enumerate(self.rows):
            cx, cy = centre(i)
            process = self.process[row.joint]
            fill, ink = colour(process)
            canvas.circle(cx, cy, 7, fill)
            canvas.text(cx, cy + 3, str(process), 8.5, fill=ink, anchor="middle")
            canvas.text(cx + 12, cy + 4, name, SIZE)
            canvas.text(notes, cy + 4, note, 9, fill=MUTED)


def robot_outline(topology: Topology, owner: Mapping[int, int], colours: str) -> Outline:
    """Return the robot joint under joint: name, and joint number and freedoms.

    Args:
        topology: the robot.
        owner: the process of each joint.
        colours: what the colours are, in words.
    """
    rows = []
    for row in robot_rows(topology):
        dofs = topology.dofs[row.joint]
        note = f"{row.joint}:  {dofs} DOF" if dofs > 1 else f"{row.joint}"
        rows.append((row, shorten(topology.names[row.joint], NAME, SIZE), note))
    return Outline("Robot", f"joint under joint, in {colours}; joint number", rows, owner)


def page(
    name: str,
    caption: str,
    line: Timeline | None,
    captions: Captions,
    bars: int,
    left: Outline,
    right: Outline,
) -> str:
    """Return a picture.

    Args:
        name: the robot's name.
        caption: what is shown, in a line of words.
        line: how it is predicted to go; None for no chart.
        captions: what the chart's bars say.
        bars: of the busiest process: the chart is wide enough to distinguish most of them.
        left: one outline.
        right: the other one.

    Returns:
        An SVG document that needs no other resource; the same bytes for the same arguments.
    """
    canvas = Canvas()
    middle = MARGIN + left.width + 2 * MARGIN
    wanted = min(max(LEAST_WIDTH, 240 + bars * _PER_BAR), MOST_WIDTH)
    width = max(middle + right.width + MARGIN, wanted)
    middle = max(middle, width / 2)
    canvas.text(MARGIN, 34, shorten(name, width - 2 * MARGIN, 18), 18, bold=True)
    canvas.text(MARGIN, 54, shorten(caption, width - 2 * MARGIN, SIZE), SIZE)
    bottom = 90.0
    if line is not None:
        canvas.text(MARGIN, 84, "Predicted time", 13, bold=True)
        legend(canvas, 102)
        bottom = chart(canvas, line, captions, 112, width)
    outlines = ((MARGIN, left), (middle, right))
    for x, outline in outlines:
        canvas.text(x, bottom, outline.heading, 13, bold=True)
    for x, outline in outlines:
        canvas.text(x, bottom + 15, outline.about, 10, fill=MUTED)
    for x, outline in outlines:
        outline.draw(canvas, x, bottom + 34)
    rows = max(len(left.rows), len(right.rows))
    return canvas.document(width, bottom + 34 + ROW * rows + MARGIN, name)
