"""Schedules from JSON files: read, checked and priced."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

from adagen.errors import InputError
from adagen.schedule import CostProfile, InvalidSchedule, Schedule, Topology, deepjson
from adagen.schedule.tree import Gathered, Meeting
from adagen.schedule.tree_draft import Draft
from adagen.search.named import as_schedule, named_schedule

MOST_PARTS = 64
"""Parts of a chain that a schedule may ask for; SIMD lanes are at most 16."""


def schedule_from_json(
    text: str, topology: Topology, profile: CostProfile, file: str | None = None
) -> Schedule:
    """Return the schedule of a JSON text, checked and priced.

    Read are ``root``: joints by name, their ``processes`` and ``children``; and, if they are there,
    ``meeting`` and the number of ``processes``, where some are idle. Which side a child is on
    follows from the robot; where the file tells it, it must agree.

    Args:
        text: as written by :func:`adagen.schedule.schedule_to_json`, or by a person.
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
    if isinstance(data, dict) and "gathered" in data:
        try:
            return _read_gathered(data, topology, profile)
        except InvalidSchedule as error:
            raise InputError(f"{error}: correct the schedule or leave it to adagen", file) from None
    root = data.get("root") if isinstance(data, dict) else None
    if not isinstance(root, dict):
        raise InputError('not a schedule: expected {"root": {"joint": ..., ...}}', file)
    try:
        found = as_schedule(_read(root, topology), topology, profile, "file", _meeting(data))
        found = _with_idle(found, data)
        return replace(found, shape=_shape(data), fan=_fan(data), parts=_parts(data))
    except InvalidSchedule as error:
        raise InputError(f"{error}: correct the schedule or leave it to adagen", file) from None


def _read_gathered(data: dict[str, Any], topology: Topology, profile: CostProfile) -> Schedule:
    """The schedule of processes that gather; its tree stands for nothing."""
    gathered, processes = data["gathered"], _processes(data)
    if not isinstance(gathered, dict) or not isinstance(gathered.get("owners"), dict):
        raise InvalidSchedule('"gathered" holds "roots" and "owners"')
    index = {name: j + 1 for j, name in enumerate(topology.names)}
    owners: list[int | None] = []
    for name in topology.names:
        if name not in gathered["owners"]:
            raise InvalidSchedule(f"joint '{name}' has no owner; null: the core")
        owner = gathered["owners"][name]
        if owner is not None and not (type(owner) is int and 0 <= owner < processes):
            raise InvalidSchedule(f"the owner of joint '{name}' is no process of {processes}")
        owners.append(owner)
    if unknown := sorted(set(gathered["owners"]) - set(index)):
        raise InvalidSchedule(f"the robot has no joint '{unknown[0]}'")
    roots = gathered.get("roots")
    if not isinstance(roots, list) or any(r is not None and r not in index for r in roots):
        raise InvalidSchedule('"roots" names the joint above each root; null: the ground')
    told = gathered.get("told", False)
    if not isinstance(told, bool):
        raise InvalidSchedule('"told" is true or false')
    gathered = Gathered(tuple(0 if r is None else index[r] for r in roots), tuple(owners), told)
    found = named_schedule("sequential", topology, processes, profile=profile)
    return replace(
        found,
        strategy="file",
        meeting="gather",
        gathered=gathered,
        lower_bound=0.0,
        shape=_shape(data),
    )


def _with_idle(found: Schedule, data: dict[str, Any]) -> Schedule:
    """A schedule with the processes that an exchange leaves idle, of which its tree has none."""
    if found.meeting != "exchange" or "processes" not in data:
        return found
    idle = _processes(data) - found.processes
    if idle < 0:
        raise InvalidSchedule('"processes" are no fewer than those of the root')
    loads = (*found.loads, *([0.0] * idle))
    return replace(found, processes=found.processes + idle, loads=loads)


def _processes(data: dict[str, Any]) -> int:
    processes = data.get("processes")
    if type(processes) is not int or not 1 <= processes <= 1024:
        raise InvalidSchedule('"processes" is a number from 1 to 1024')
    return processes


def _shape(data: dict[str, Any]) -> str:
    shape = data.get("shape", "auto")
    if shape not in ("auto", "kernels", "joints", "unrolled"):
        raise InvalidSchedule('"shape" is "auto", "kernels", "joints" or "unrolled"')
    return str(shape)


def _fan(data: dict[str, Any]) -> int:
    fan = data.get("fan", 2)
    if type(fan) is not int or not (2 <= fan <= 1024 and fan & (fan - 1) == 0):
        raise InvalidSchedule('"fan" is a power of two from 2 to 1024')
    return fan


def _parts(data: dict[str, Any]) -> int:
    parts = data.get("parts", 0)
    if type(parts) is not int or not (parts == 0 or 2 <= parts <= MOST_PARTS):
        raise InvalidSchedule(f'"parts" is a number from 2 to {MOST_PARTS}, or 0')
    return parts


def _meeting(data: dict[str, Any]) -> Meeting:
    match data.get("meeting", "join"):
        case "join":
            return "join"
        case "exchange":
            return "exchange"
        case "gather":
            return "gather"
    raise InvalidSchedule('"meeting" is "join", "exchange" or "gather"')


def _read(root: dict[str, Any], topology: Topology) -> Draft:
    index = {name: j for j, name in enumerate(topology.names)}
    draft = Draft(len(topology))
    seen: set[int] = set()
    stack: list[tuple[Any, int]] = [(root, -1)]
    while stack:
        entry, above = stack.pop()
        joint = _joint(entry, index, seen)
        draft.ranges[joint] = a, b = _range(entry, joint, topology)
        if above < 0:
            if a != 0:
                raise InvalidSchedule(f"the root must have the processes [0, {b}]")
            draft.root = joint
        else:
            if not (draft.ranges[above][0] <= a and b <= draft.ranges[above][1]):
                raise InvalidSchedule(
                    f"joint '{topology.names[joint]}' has processes that joint "
                    f"'{topology.names[above]}' above it has not"
                )
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
