"""A program as a picture: operations in time, and owners of joints."""

from __future__ import annotations

from adagen.cost import Interval, Timeline
from adagen.drawing.gantt import Caption, Captions
from adagen.drawing.outline import Row, outline
from adagen.drawing.page import NAME, Outline, page, robot_outline
from adagen.drawing.svg import SIZE, shorten
from adagen.drawing.tree import tree_outline
from adagen.plan.edges import edges_from, joints_at
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Receive, Send
from adagen.program import Operation, Program
from adagen.program.runs import Run
from adagen.program.summary import TREES, gathering, lanes, meeting, title
from adagen.schedule import Schedule, Topology


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
    owner = {j: p for p, process in enumerate(program.plan.processes) for j in process.owns}
    joined = meeting(program) in TREES
    if joined:
        left = tree_outline(schedule, topology, costs=False)
    else:
        left = _swept(program, topology, owner)
    return page(
        name,
        f"{title(program)}: {caption}",
        line,
        _captions(program),
        max(len(process.operations) for process in program.processes),
        left,
        robot_outline(topology, owner, "its owner's colour"),
    )


def _captions(program: Program) -> Captions:
    """Captions of the bars of operations: their names, and their joints or links."""

    def caption(i: Interval) -> Caption:
        if i.operation is None:
            return Caption(i.what)
        operation = program.processes[i.process].operations[i.operation]
        name = operation_name(program, operation)
        lanes = operation.block.lanes if isinstance(operation.block, Limbs) else 1
        return Caption(name, (name.partition(" ")[2] or name,), lanes)

    return caption


_HOW = {
    "columns": "by columns",
    "turned": "by turned",
    "strips": "by strips",
    "parts": "in parts",
}
"""How an operation passes a run, in words, where that is worth one."""


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
            how = _HOW.get(operation.method)
            return f"{does} {about}" if how is None else f"{does} {about}, {how}"
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


def _swept(program: Program, topology: Topology, owner: dict[int, int]) -> Outline:
    """The robot as it is swept: names, and joint number and method."""
    where = "from the ground outwards"
    if meeting(program) == "gathered":
        links = [program.plan.links[k].name or "the ground" for k in gathering(program).roots]
        where = f"from {', '.join(links)} outwards"
    how, core = _methods(program), set(gathering(program).core)
    rows = []
    for row in swept_rows(program):
        parts = ["core, swept by every process"] if row.joint in core else []
        parts += [how[row.joint]] if row.joint in how else []
        note = f"{row.joint}: {', '.join(parts)}" if parts else f"{row.joint}"
        rows.append((row, shorten(topology.names[row.joint], NAME, SIZE), note))
    about = f"{where}; in the circle: owner; then joint number, method"
    return Outline("How it is swept", about, rows, owner)


def _methods(program: Program) -> dict[int, str]:
    """How each joint is swept inwards, where that is not by itself."""
    found: dict[int, str] = {}
    for process in program.processes:
        for operation in process.operations:
            if operation.does == "articulate" and operation.method in (
                "columns",
                "turned",
                "parts",
            ):
                found |= {getattr(step, "joint", 0): operation.method for step in operation.steps}
    for number, (_, limbs) in enumerate(lanes(program), start=1):
        for row in limbs.rows:
            for lane, joint in enumerate(row, start=1 + limbs.idle):
                found[joint] = f"group {number}, lane {lane} of {limbs.lanes}"
    return found
