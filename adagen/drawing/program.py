"""A program as a picture: operations in time, what meets where, and who has which joint."""

from __future__ import annotations

from adagen.cost import Timeline
from adagen.drawing.gantt import legend, process_rows
from adagen.drawing.outline import Row, outline, robot_rows, schedule_rows
from adagen.drawing.svg import MUTED, Canvas, shorten
from adagen.drawing.tree import (
    MARGIN,
    NAME,
    ROW,
    SIZE,
    Label,
    captioned,
    draw_outline,
    outline_width,
    robot_label,
    tree_label,
)
from adagen.plan.edges import edges_from, joints_at
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Receive, Send
from adagen.program import Operation, Program
from adagen.program.runs import Run
from adagen.program.summary import TREES, gathering, lanes, meeting, title
from adagen.schedule import Schedule, Topology, preorder

LEAST_WIDTH, MOST_WIDTH = 960.0, 1920.0
_PER_OPERATION = 26.0  # pixels of the chart's width for each operation of the busiest process


def program_svg(
    program: Program,
    line: Timeline | None,
    schedule: Schedule,
    topology: Topology,
    name: str,
    caption: str,
) -> str:
    """Return a drawing of a program.

    A chart of its operations in time; then, where processes are joined, the paper's schedule tree,
    and elsewhere the robot as it is swept from the root; and the robot joint under joint.

    Args:
        program: what runs.
        line: how it is predicted to go; None for no chart.
        schedule: of its joints; its tree is drawn where processes are joined.
        topology: the robot.
        name: the robot's name.
        caption: what is predicted and proven, in words.

    Returns:
        An SVG document that needs no other resource; the same bytes for the same arguments.
    """
    canvas = Canvas()
    joined = meeting(program) in TREES
    owner = {j: p for p, process in enumerate(program.plan.processes) for j in process.owns}
    right = captioned(robot_rows(topology), robot_label(topology))
    if joined:
        nodes = {node.joint: node for node in preorder(schedule.root)}
        left = captioned(schedule_rows(schedule, topology), tree_label(nodes, topology))
        process_of = {joint: node.processes[0] for joint, node in nodes.items()}
    else:
        left = captioned(swept_rows(program), _swept_label(program, topology))
        process_of = owner
    middle = MARGIN + outline_width(left) + 2 * MARGIN
    width = max(middle + outline_width(right) + MARGIN, _chart(program))
    middle = max(middle, width / 2)
    canvas.text(MARGIN, 34, shorten(name, width - 2 * MARGIN, 18), 18, bold=True)
    canvas.text(MARGIN, 54, shorten(f"{title(program)}: {caption}", width - 2 * MARGIN, SIZE), SIZE)
    bottom = 90.0
    if line is not None:
        canvas.text(MARGIN, 84, "Predicted time", 13, bold=True)
        legend(canvas, MARGIN, 102)
        bottom = process_rows(canvas, line, _names(program), MARGIN, 112, width)
    heading, note = _headings(program)
    canvas.text(MARGIN, bottom, heading, 13, bold=True)
    canvas.text(middle, bottom, "Robot", 13, bold=True)
    canvas.text(MARGIN, bottom + 15, note, 10, fill=MUTED)
    owned = "joint under joint, in its owner's colour; joint number"
    canvas.text(middle, bottom + 15, owned, 10, fill=MUTED)
    bottom += 34
    draw_outline(canvas, left, process_of, MARGIN, bottom)
    draw_outline(canvas, right, owner, middle, bottom)
    return canvas.document(width, bottom + ROW * max(len(left), len(right)) + MARGIN, name)


def _headings(program: Program) -> tuple[str, str]:
    """The heading of the left outline, and what its rows say."""
    match meeting(program):
        case "joined" | "exchanged":
            return (
                "Schedule tree",
                "assembled from below, in the circle: process; then joint number, boundary joints "
                "k, cost",
            )
        case "gathered":
            links = [program.plan.links[k].name or "the ground" for k in gathering(program).roots]
            where = f"from {', '.join(links)} outwards"
        case "alone":
            where = "from the ground outwards"
    return "How it is swept", f"{where}; in the circle: owner; then joint number, method"


def _chart(program: Program) -> float:
    """The width at which most bars of the busiest process can be distinguished."""
    busiest = max(len(process.operations) for process in program.processes)
    return min(max(LEAST_WIDTH, 240 + busiest * _PER_OPERATION), MOST_WIDTH)


def _names(program: Program) -> dict[tuple[int, int], tuple[str, int]]:
    """What each operation is called, and its SIMD lanes, by its process and place there."""
    return {
        (p, place): (operation_name(program, operation), _lanes(operation))
        for p, process in enumerate(program.processes)
        for place, operation in enumerate(process.operations)
    }


def _lanes(operation: Operation) -> int:
    return operation.block.lanes if isinstance(operation.block, Limbs) else 1


def operation_name(program: Program, operation: Operation) -> str:
    """Return what an operation does to which joints or links, in words."""
    plan = program.plan
    does = operation.does.replace("_", " ")
    match operation.block:
        case Limbs() as limbs:
            ends = zip(limbs.rows[0], limbs.rows[-1], strict=True)
            about = " | ".join(_span(program, *pair) for pair in ends)
            return f"{does} {about} in {limbs.lanes} lanes"
        case Run() as run:
            about = _span(program, run.first, run.last)
            by = (
                f", by {operation.method}"
                if operation.method in ("columns", "turned", "strips")
                else ""
            )
            return f"{does} {about}{by}"
    if operation.block is not None:
        return does
    (step,) = operation.steps
    if isinstance(step, Send | Receive):
        message = plan.messages[step.message]
        return f"{does}: process {message.source} to {message.target}"
    joint, link = getattr(step, "joint", None), getattr(step, "link", None)
    if joint is not None:
        return f"{does} {plan.joints[joint].name}"
    return does if link is None else f"{does} {plan.links[link].name}"


def _span(program: Program, first: int, last: int) -> str:
    return " .. ".join(program.plan.joints[j].name for j in dict.fromkeys((first, last)))


def swept_rows(program: Program) -> list[Row]:
    """Return the outline of a robot as it is swept: from the root of its tree outwards."""
    joints = program.plan.joints
    at = joints_at(joints, range(len(joints)))
    roots = gathering(program).roots if meeting(program) == "gathered" else ()
    below: dict[int, list[int]] = {}
    first: list[int] = []
    seen: set[int] = set()
    for root in (*roots, 0):
        beyond: dict[int, int] = {}  # the joint by which a link was reached
        for edge in edges_from(root, joints, at):
            if edge.joint in seen:
                continue
            seen.add(edge.joint)
            if edge.near in beyond and edge.near != 0:
                below.setdefault(beyond[edge.near], []).append(edge.joint)
            else:
                first.append(edge.joint)
            beyond[edge.far] = edge.joint
    sizes = [1] * len(joints)

    def size(joint: int) -> None:
        sizes[joint] = 1 + sum(sizes[k] for k in below.get(joint, []))

    order, stack = [], list(first)
    while stack:
        joint = stack.pop()
        order.append(joint)
        stack += below.get(joint, [])
    for joint in reversed(order):
        size(joint)
    return outline(first, lambda joint: below.get(joint, []), lambda _: False, sizes)


def _swept_label(program: Program, topology: Topology) -> Label:
    how = _methods(program)
    core = set(gathering(program).core)

    def label(row: Row) -> tuple[str, str]:
        parts = ["core, swept by every process"] if row.joint in core else []
        parts += [how[row.joint]] if row.joint in how else []
        note = f"{row.joint}: {', '.join(parts)}" if parts else f"{row.joint}"
        return shorten(topology.names[row.joint], NAME, SIZE), note

    return label


def _methods(program: Program) -> dict[int, str]:
    """How each joint is swept inwards, where that is not by itself."""
    found: dict[int, str] = {}
    for process in program.processes:
        for operation in process.operations:
            if operation.does == "articulate" and operation.method in ("columns", "turned"):
                found |= {getattr(step, "joint", 0): operation.method for step in operation.steps}
    for number, (_, limbs) in enumerate(lanes(program), start=1):
        for row in limbs.rows:
            for lane, joint in enumerate(row, start=1 + limbs.idle):
                found[joint] = f"group {number}, lane {lane} of {limbs.lanes}"
    return found
