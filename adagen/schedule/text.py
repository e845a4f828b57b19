"""A schedule as JSON, as an indented tree and in one line; and back from JSON."""

from __future__ import annotations

import json
import re
from typing import Any

from adagen.errors import InputError, printable
from adagen.schedule import deepjson
from adagen.schedule.draft import Draft
from adagen.schedule.named import as_schedule
from adagen.schedule.profile import CostProfile
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Meeting, Node, Schedule, postorder
from adagen.schedule.validity import InvalidSchedule


def schedule_to_dict(schedule: Schedule, topology: Topology) -> dict[str, Any]:
    """Return a schedule as plain data (microseconds); the nodes nest as deep as the tree.

    Use :func:`schedule_to_json` for its text: the json module cannot write deep trees.
    """
    made: dict[int, dict[str, Any]] = {}
    for node in postorder(schedule.root):
        made[node.joint] = {
            "joint": topology.names[node.joint],
            "index": node.joint,
            "processes": list(node.processes),
            "cost": node.cost,
            "boundary": node.boundary,
            "children": [made.pop(child.joint) for child in node.children],
        }
        for child, side in ((node.root_side, "root"), (node.end_side, "end")):
            if child is not None:
                below = made[node.joint]["children"]
                entry = below[0] if side == "root" else below[-1]
                entry["side"] = side
    return {
        "makespan": schedule.makespan,
        "verdict": schedule.verdict,
        "gap": schedule.gap,
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
        "expanded": schedule.expanded,
        "root": made[schedule.root.joint],
    }


def schedule_to_json(schedule: Schedule, topology: Topology) -> str:
    """Return a schedule as JSON in one line, without a newline at its end."""
    return deepjson.dumps(schedule_to_dict(schedule, topology))


def schedule_from_json(
    text: str, topology: Topology, profile: CostProfile, file: str | None = None
) -> Schedule:
    """Return the schedule that a JSON text describes, checked and priced anew.

    Read are ``root``: joints by name, their ``processes`` and ``children``; and ``meeting``, if it
    is there. Which side a child is on follows from the robot; where the file tells it, it must
    agree.

    Args:
        text: as written by :func:`schedule_to_json`, or by a person.
        topology: the robot.
        profile: prices the tree.
        file: what messages call it.

    Raises:
        InputError: it is not JSON, not a schedule, or not one of this robot.
    """
    try:
        data = deepjson.loads(text)
    except json.JSONDecodeError as error:
        raise InputError(f"not JSON: {error.msg}", file, error.lineno) from None
    except (ValueError, RecursionError) as error:
        raise InputError(f"not JSON: {error}", file) from None
    root = data.get("root") if isinstance(data, dict) else None
    if not isinstance(root, dict):
        raise InputError('not a schedule: expected {"root": {"joint": ..., ...}}', file)
    try:
        return as_schedule(_read(root, topology), topology, profile, "file", _meeting(data))
    except InvalidSchedule as error:
        raise InputError(f"{error}: correct the schedule or leave it to adagen", file) from None


def _meeting(data: dict[str, Any]) -> Meeting:
    match data.get("meeting", "join"):
        case "join":
            return "join"
        case "gather":
            return "gather"
    raise InvalidSchedule('"meeting" is "join" or "gather"')


def _read(root: dict[str, Any], topology: Topology) -> Draft:
    index = {name: j for j, name in enumerate(topology.names)}
    draft = Draft(len(topology))
    seen: set[int] = set()
    stack: list[tuple[Any, int]] = [(root, -1)]
    while stack:
        entry, above = stack.pop()
        joint = _joint(entry, index, seen)
        draft.ranges[joint] = _range(entry, joint, topology)
        if above < 0:
            draft.root = joint
        else:
            _hang(draft, topology, above, joint, entry)
        children = entry.get("children", [])
        if not isinstance(children, list):
            raise InvalidSchedule(f"the children of joint '{topology.names[joint]}' are no list")
        stack += [(child, joint) for child in reversed(children)]
    missing = next((j for j in range(len(topology)) if j not in seen), None)
    if missing is not None:
        raise InvalidSchedule(f"joint '{topology.names[missing]}' is missing")
    return draft


def _joint(entry: Any, index: dict[str, int], seen: set[int]) -> int:
    name = entry.get("joint") if isinstance(entry, dict) else None
    if not isinstance(name, str):
        raise InvalidSchedule('a node without "joint": NAME')
    if name not in index:
        raise InvalidSchedule(f"the robot has no joint '{name}'")
    joint = index[name]
    if joint in seen:
        raise InvalidSchedule(f"joint '{name}' appears more than once")
    if entry.get("index", joint) != joint:
        raise InvalidSchedule(f"joint '{name}' has the index {joint}, not {entry['index']!r}")
    seen.add(joint)
    return joint


def _range(entry: dict[str, Any], joint: int, topology: Topology) -> tuple[int, int]:
    match entry.get("processes"):
        case [int(a), int(b)] if 0 <= a < b <= 1 << 20:
            return a, b
    raise InvalidSchedule(f"joint '{topology.names[joint]}' needs \"processes\": [first, last + 1]")


def _hang(draft: Draft, topology: Topology, above: int, joint: int, entry: Any) -> None:
    is_end = topology.is_below(above, joint)
    side = "end" if is_end else "root"
    name = topology.names[joint]
    if entry.get("side", side) != side:
        raise InvalidSchedule(f"joint '{name}' is on the {side} side of its parent in the tree")
    slots = draft.end_child if is_end else draft.root_child
    if slots[above] >= 0:
        raise InvalidSchedule(
            f"joint '{topology.names[above]}' has two descendants on its {side} side"
        )
    slots[above] = joint


def schedule_tree(schedule: Schedule, topology: Topology) -> str:
    """Return the tree as indented text, one joint a line, for people."""
    width = len(str(schedule.processes))
    lines = []
    stack: list[tuple[Node, str, str, str]] = [(schedule.root, "", "", "")]
    while stack:
        node, lead, branch, side = stack.pop()
        a, b = node.processes
        where = f"{a:{width}}" if b - a == 1 else f"{a:{width}}-{b - 1}"
        name = printable(topology.names[node.joint])
        figures = f"[{where}]  k={node.boundary}  {node.cost:.3f} us"
        lines.append(f"{lead}{branch}{side}{name}  {figures}")
        # A lone descendant continues at the same indent: chains are deep, screens are not.
        children = node.children
        inner = lead + {"": "", "├ ": "│ ", "└ ": "  "}[branch]
        for i in reversed(range(len(children))):
            label = "root: " if children[i] is node.root_side else "end: "
            if len(children) == 1:
                stack.append((children[0], inner, "", ""))
            else:
                stack.append((children[i], inner, "├ " if i == 0 else "└ ", label))
    return "\n".join(lines) + "\n"


def schedule_line(schedule: Schedule, topology: Topology) -> str:
    """Return the schedule in one line of printable ASCII, for the header of an emitted file.

    ``NAME@a-b(ROOT SIDE | END SIDE)``; a bare link is left empty and a range is told where it
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
