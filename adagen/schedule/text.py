"""A schedule as JSON, as an indented tree and in one line.

The way back is adagen/search/schedule_file.py.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from typing import Any

from adagen.errors import printable
from adagen.schedule import deepjson
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Gathered, Node, Schedule, postorder


def schedule_to_dict(
    schedule: Schedule, topology: Topology, *, costs: bool = True
) -> dict[str, Any]:
    """Return a schedule as plain data (microseconds); the nodes nest as deep as the tree.

    Costs of nodes are left out where the times are not those of the tree.

    Use :func:`schedule_to_json` for its text: the json module cannot write deep trees.
    """
    made: dict[int, dict[str, Any]] = {}
    for node in postorder(schedule.root):
        made[node.joint] = {
            "joint": topology.names[node.joint],
            "index": node.joint,
            "processes": list(node.processes),
            **({"cost": node.cost} if costs else {}),
            "boundary": node.boundary,
            "children": [made.pop(child.joint) for child in node.children],
        }
        for child, side in ((node.root_side, "root"), (node.end_side, "end")):
            if child is not None:
                below = made[node.joint]["children"]
                entry = below[0] if side == "root" else below[-1]
                entry["side"] = side
    meeting: dict[str, Any] = {"root": made[schedule.root.joint]}
    if schedule.gathered is not None:  # the tree is one of several that say the same
        meeting = {"gathered": _gathered_to_dict(schedule.gathered, topology)}
    elif schedule.fan != 2:
        meeting["fan"] = schedule.fan
    if schedule.parts:
        meeting["parts"] = schedule.parts
    return {
        "makespan": schedule.makespan,
        "verdict": schedule.verdict,
        "among": schedule.among,
        "gap": schedule.gap if math.isfinite(schedule.gap) else None,
        "lower_bound": schedule.lower_bound,
        "processes": schedule.processes,
        "loads": list(schedule.loads),
        "profile": schedule.profile,
        "strategy": schedule.strategy,
        "tie": schedule.tie,
        "tie_proven": schedule.tie_proven,
        "split": schedule.split,
        "meeting": schedule.meeting,
        "families": list(schedule.families),
        "candidates": schedule.candidates,
        "straight_lines": schedule.straight_lines,
        "expanded": schedule.expanded,
        **meeting,
    }


def _gathered_to_dict(gathered: Gathered, topology: Topology) -> dict[str, Any]:
    """Where processes gather: roots by the joint above them (null: the ground), owners by name."""
    return {
        "roots": [topology.names[root - 1] if root else None for root in gathered.roots],
        "owners": dict(zip(topology.names, gathered.owners, strict=True)),
        **({"told": True} if gathered.told else {}),
    }


def schedule_to_json(schedule: Schedule, topology: Topology) -> str:
    """Return a schedule as JSON in one line, without a newline at its end."""
    return deepjson.dumps(schedule_to_dict(schedule, topology))


def schedule_tree(schedule: Schedule, topology: Topology, *, costs: bool = True) -> str:
    """Return the tree as indented text for people: names, processes, k, and costs.

    Costs are for schedules whose times are those of the tree, and then each joint has a line.
    Without them, joints below one another share a line where nothing else differs.
    """
    width = len(str(schedule.processes))
    lines = []
    stack: list[tuple[Node, str, str, str]] = [(schedule.root, "", "", "")]
    while stack:
        node, lead, branch, side = stack.pop()
        a, b = node.processes
        where = f"{a:{width}}" if b - a == 1 else f"{a:{width}}-{b - 1}"
        name = printable(topology.names[node.joint])
        figures = f"[{where}]  k={node.boundary}"
        last = node
        if costs:
            figures += f"  {node.cost:.3f} us"
        else:
            count, last = _line_below(node)
            if count > 1:
                name += f" .. {printable(topology.names[last.joint])}"
                figures += f"  {count} joints"
        lines.append(f"{lead}{branch}{side}{name}  {figures}")
        # A lone descendant continues at the same indent: chains are deep, screens are not.
        children = last.children
        inner = lead + {"": "", "├ ": "│ ", "└ ": "  "}[branch]
        for i in reversed(range(len(children))):
            label = "root: " if children[i] is last.root_side else "end: "
            if len(children) == 1:
                stack.append((children[0], inner, "", ""))
            else:
                stack.append((children[i], inner, "├ " if i == 0 else "└ ", label))
    return "\n".join(lines) + "\n"


def _line_below(node: Node) -> tuple[int, Node]:
    """Return how many nodes follow each other like one, and the last of them.

    Each but the last has one descendant, on the same processes and with as many boundary joints.
    """
    count = 1
    while len(node.children) == 1:
        below = node.children[0]
        if (below.processes, below.boundary) != (node.processes, node.boundary):
            break
        count, node = count + 1, below
    return count, node


def gathered_line(gathered: Gathered, topology: Topology) -> str:
    """Return root and owners of a gathered layout in one line of printable ASCII.

    ``gathered at JOINT ...: core JOINT ...; 0: JOINT ...; 1: ...``, a root by the joint above it.
    """

    def words(joints: Iterable[int]) -> str:
        return " ".join(re.sub(r"[^A-Za-z0-9_.:+-]", "_", topology.names[j]) for j in joints)

    def owned(owner: int | None) -> str:
        return words(j for j, p in enumerate(gathered.owners) if p == owner)

    roots = ["the ground" if root == 0 else words([root - 1]) for root in gathered.roots]
    parts = [f"core {owned(None)}"] if None in gathered.owners else []
    parts += [f"{p}: {owned(p)}" for p in sorted({p for p in gathered.owners if p is not None})]
    return f"gathered at {', '.join(roots)}: {'; '.join(parts)}"


def schedule_line(schedule: Schedule, topology: Topology) -> str:
    """Return the schedule in one line of printable ASCII, for the header of an emitted file.

    ``NAME@a-b(ROOT SIDE | END SIDE)``; a bare link is left empty and a range is given where it
    differs from that of the node above. Characters that could end a comment become underscores.
    """
    out: list[str] = []
    stack: list[Node | str] = [schedule.root]
    ranges: dict[int, tuple[int, int]] = {}
    while stack:
        item = stack.pop()
        if isinstance(item, str):
            out.append(item)
            continue
        name = re.sub(r"[^A-Za-z0-9_.:+-]", "_", topology.names[item.joint])
        a, b = item.processes
        at = f"@{a}" if b - a == 1 else f"@{a}-{b - 1}"
        out.append(name if ranges.get(item.joint) == (a, b) else name + at)
        for child in item.children:
            ranges[child.joint] = (a, b)
        if item.children:
            stack += [")"]
            stack += [item.end_side] if item.end_side else []
            stack += [" | " if item.root_side and item.end_side else "|"]
            stack += [item.root_side] if item.root_side else []
            stack += ["("]
    return "".join(out)
