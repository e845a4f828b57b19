"""A schedule as a picture: both sweeps in time, the schedule tree, and the robot in its colours."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping

from adagen.drawing.outline import Row, robot_rows, schedule_rows
from adagen.drawing.svg import INK, MUTED, Canvas, colour, shorten, text_width, time_axis
from adagen.errors import printable
from adagen.schedule.timeline import Timeline, predict
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Node, Schedule, preorder

MARGIN = 24.0
LANE = 22.0
ROW = 18.0
INDENT = 20.0
SIZE = 11.0
NAME = 240.0
"""Most width for a joint's name, pixels."""
LEAST_WIDTH = 960.0
MOST_WIDTH = 1920.0
MOST_LANES = 64
WAIT = "#e4e4e4"


def schedule_svg(schedule: Schedule, topology: Topology, title: str) -> str:
    """Return a drawing of a schedule: a Gantt chart, the schedule tree, and the robot's tree.

    Args:
        schedule: the schedule.
        topology: the robot.
        title: such as the robot's name.

    Returns:
        An SVG document that needs no other resource; the same bytes for the same arguments.
    """
    canvas = Canvas()
    nodes = {node.joint: node for node in preorder(schedule.root)}
    left = captioned(schedule_rows(schedule, topology), tree_label(nodes, topology))
    right = captioned(robot_rows(topology), robot_label(topology))
    middle = MARGIN + outline_width(left) + 2 * MARGIN
    width = max(middle + outline_width(right) + MARGIN, _chart_width(nodes))
    middle = max(middle, width / 2)
    bottom = _head(canvas, schedule, title, width)
    bottom = _gantt(canvas, schedule, topology, bottom, width)
    canvas.text(MARGIN, bottom, "Schedule tree", 13, bold=True)
    canvas.text(middle, bottom, "Robot", 13, bold=True)
    note = (
        "assembled from below, in the circle: process; then joint number, boundary joints k, cost"
    )
    canvas.text(MARGIN, bottom + 15, note, 10, fill=MUTED)
    canvas.text(
        middle, bottom + 15, "joint under joint, in the same colours; joint number", 10, fill=MUTED
    )
    bottom += 34
    process_of = {joint: node.processes[0] for joint, node in nodes.items()}
    draw_outline(canvas, left, process_of, MARGIN, bottom)
    draw_outline(canvas, right, process_of, middle, bottom)
    return canvas.document(width, bottom + ROW * len(left) + MARGIN, title)


def _chart_width(nodes: dict[int, Node]) -> float:
    """Return the width at which most bars of the busiest lane can hold the number of a joint."""
    busiest = max(Counter(node.processes[0] for node in nodes.values()).values())
    return min(max(LEAST_WIDTH, 240 + 2 * busiest * 26.0), MOST_WIDTH)


Label = Callable[[Row], tuple[str, str]]


def tree_label(nodes: dict[int, Node], topology: Topology) -> Label:
    """Return what rows of a schedule tree say: the name, and joint number, k and cost."""

    def label(row: Row) -> tuple[str, str]:
        node = nodes[row.joint]
        a, b = node.processes
        parts = [f"{row.joint}:  k={node.boundary}", f"{node.cost:.2f} µs"]
        parts += [row.label] if row.label else []
        parts += [f"processes {a}–{b - 1}"] if b - a > 1 else []
        return shorten(topology.names[row.joint], NAME, SIZE), ", ".join(parts)

    return label


def robot_label(topology: Topology) -> Label:
    """Return what rows of a robot say: the name, and joint number and freedoms."""

    def label(row: Row) -> tuple[str, str]:
        dofs = topology.dofs[row.joint]
        note = f"{row.joint}:  {dofs} DOF" if dofs > 1 else f"{row.joint}"
        return shorten(topology.names[row.joint], NAME, SIZE), note

    return label


Captioned = list[tuple[Row, str, str]]
"""Rows of an outline, each with its name and note."""


def captioned(rows: list[Row], label: Label) -> Captioned:
    """Return rows with what they say."""
    return [(row, *label(row)) for row in rows]


def _note_column(rows: Captioned) -> float:
    """Return where the notes of an outline begin, from its left edge."""
    return max(row.indent * INDENT + text_width(name, SIZE) for row, name, _ in rows) + 30


def outline_width(rows: Captioned) -> float:
    """Return how wide an outline is, pixels."""
    return _note_column(rows) + max(text_width(note, 9) for _, _, note in rows)


def _head(canvas: Canvas, schedule: Schedule, title: str, width: float) -> float:
    canvas.text(MARGIN, 34, shorten(title, width - 2 * MARGIN, 18), 18, bold=True)
    count = "1 process" if schedule.processes == 1 else f"{schedule.processes} processes"
    line = (
        f"{count}: predicted {schedule.makespan:.2f} µs ({schedule.proven}; "
        f"costs: {schedule.profile}; strategy: {schedule.strategy}; tie-break: {schedule.tie})"
    )
    canvas.text(MARGIN, 54, line, SIZE, fill=MUTED)
    return 84.0


def _gantt(
    canvas: Canvas, schedule: Schedule, topology: Topology, top: float, width: float
) -> float:
    """Draw the chart of both sweeps; return where the next part begins."""
    timeline = predict(schedule)
    lanes = sorted({bar.process for bar in timeline.bars})
    hidden = schedule.processes - len(lanes[:MOST_LANES])
    lanes = lanes[:MOST_LANES]
    labels = [f"process {p}" for p in lanes]
    start = MARGIN + max(text_width(label, SIZE) for label in labels) + 30
    scale = (width - MARGIN - start - 70) / timeline.end
    canvas.text(MARGIN, top, "Predicted time", 13, bold=True)
    _gantt_legend(canvas, MARGIN, top + 18)
    top += 32
    place = {p: top + i * LANE for i, p in enumerate(lanes)}
    busy = dict.fromkeys(lanes, 0.0)
    for p, label in zip(lanes, labels, strict=True):
        canvas.rect(MARGIN, place[p] + 5, 12, 12, colour(p)[0])
        canvas.text(MARGIN + 18, place[p] + 15, label, SIZE)
        canvas.rect(start, place[p] + 2, timeline.end * scale, LANE - 4, WAIT)
    for bar in timeline.bars:
        if bar.process in place:
            busy[bar.process] += bar.end - bar.start
    _bars(canvas, timeline, topology, place, start, scale)
    for p in lanes:
        share = f"{100 * busy[p] / timeline.end:.0f} % busy"
        canvas.text(start + timeline.end * scale + 8, place[p] + 15, share, 10, fill=MUTED)
    _messages(canvas, timeline, place, start, scale)
    bottom = top + LANE * len(lanes) + 4
    time_axis(canvas, timeline.end, start, scale, bottom)
    if hidden:
        what = "1 process computes" if hidden == 1 else f"{hidden} processes compute"
        canvas.text(MARGIN, bottom + 28, f"{what} nothing or are not shown", 10, fill=MUTED)
    return bottom + 56


def _gantt_legend(canvas: Canvas, x: float, y: float) -> None:
    first = colour(0)[0]
    canvas.rect(x, y - 9, 18, 11, first)
    canvas.text(x + 24, y, "assembly", 10, fill=MUTED)
    canvas.rect(x + 84, y - 9, 18, 11, first)
    canvas.rect(x + 84, y - 5.5, 18, 4, "#ffffff")
    canvas.text(x + 108, y, "disassembly (half of a cost each)", 10, fill=MUTED)
    canvas.rect(x + 296, y - 9, 18, 11, WAIT)
    canvas.text(x + 320, y, "waiting", 10, fill=MUTED)
    canvas.path([(x + 376, y - 4), (x + 394, y - 4)], INK)
    canvas.circle(x + 394, y - 4, 2, INK)
    canvas.text(x + 402, y, "message", 10, fill=MUTED)


def _bars(
    canvas: Canvas,
    timeline: Timeline,
    topology: Topology,
    place: dict[int, float],
    start: float,
    scale: float,
) -> None:
    for bar in timeline.bars:
        if bar.process not in place:
            continue
        x, y = start + bar.start * scale, place[bar.process] + 2
        width = (bar.end - bar.start) * scale
        fill, ink = colour(bar.process)
        name = topology.names[bar.joint]
        note = f"{name}: {bar.sweep}, {bar.start:.3f} to {bar.end:.3f} µs"
        canvas.rect(x, y, width, LANE - 4, fill, stroke="#ffffff", note=note)
        if bar.sweep == "disassembly":
            canvas.rect(x + 0.5, y + 13, width - 1, 3, "#ffffff")
        short = printable(name)
        if text_width(short, 9) > width - 4:
            short = str(bar.joint)
        if text_width(short, 9) <= width - 4:
            baseline = y + (12.5 if bar.sweep == "assembly" else 10)
            canvas.text(x + width / 2, baseline, short, 9, fill=ink, anchor="middle")


def _messages(
    canvas: Canvas, timeline: Timeline, place: dict[int, float], start: float, scale: float
) -> None:
    for message in timeline.messages:
        if message.sender not in place or message.receiver not in place:
            continue
        x, x2 = start + message.sent * scale, start + message.used * scale
        down = place[message.receiver] > place[message.sender]
        y = place[message.sender] + (LANE - 2 if down else 2)
        y2 = place[message.receiver] + (2 if down else LANE - 2)
        canvas.path([(x, y), (x2, y2)], INK)
        canvas.circle(x2, y2, 2, INK)


def draw_outline(
    canvas: Canvas,
    rows: Captioned,
    process_of: Mapping[int, int],
    x: float,
    y: float,
) -> None:
    """Draw an outline, each row with its process in a circle."""

    def centre(row: int) -> tuple[float, float]:
        return x + 7 + rows[row][0].indent * INDENT, y + row * ROW

    for i, (row, _, _) in enumerate(rows):
        if row.above >= 0:
            (px, py), (cx, cy) = centre(row.above), centre(i)
            canvas.path([(px, py), (px, cy), (cx, cy)] if px != cx else [(px, py), (cx, cy)])
    notes = x + _note_column(rows)
    for i, (row, name, note) in enumerate(rows):
        cx, cy = centre(i)
        process = process_of[row.joint]
        fill, ink = colour(process)
        canvas.circle(cx, cy, 7, fill)
        canvas.text(cx, cy + 3, str(process), 8.5, fill=ink, anchor="middle")
        canvas.text(cx + 12, cy + 4, name, SIZE)
        canvas.text(notes, cy + 4, note, 9, fill=MUTED)
