"""The file of an emitted program's --trace, as a timeline beside the predicted one."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

from adagen.cost.simulation import Exchange, Interval, Timeline
from adagen.errors import InputError

_SORTS = ("kinematics", "assembly", "disassembly", "slaved", "send", "receive")


def read_trace(path: str, names: Sequence[str], processes: int) -> Timeline:
    """Return the timeline in a trace file; times become microseconds.

    A process that receives is shown as waiting until the message is sent.

    Args:
        path: the file.
        names: the robot's joints.
        processes: P of the schedule that it is to be compared with.

    Raises:
        InputError: it cannot be read, is not a trace, or is one of another robot or P.
    """
    try:
        data = json.loads(Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"cannot read the trace: {error.strerror}", path) from None
    except (ValueError, RecursionError):
        raise InputError("not a trace: not JSON", path) from None
    rows = data.get("stages") if isinstance(data, dict) else None
    if not isinstance(rows, list):
        raise InputError("not a trace: it has no list of stages", path)
    if data.get("processes") != processes:
        raise InputError(
            f"this trace is of {data.get('processes')} processes, the schedule of {processes}", path
        )
    place = {name: j for j, name in enumerate(names)}
    try:
        found = [_interval(row, place, processes) for row in rows]
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"not a trace of this robot: {error}", path) from None
    if not found:
        raise InputError("the trace is empty", path)
    return _timeline(found)


def _interval(row: Mapping[str, Any], place: Mapping[str, int], processes: int) -> Interval:
    what, process, message = row["what"], row["process"], row["message"]
    start, length = float(row["start_ns"]), float(row["length_ns"])
    if what not in _SORTS:
        raise ValueError(f"unknown stage {what!r}")
    if not isinstance(process, int) or not 0 <= process < processes:
        raise ValueError(f"no process {process!r}")
    if not (message is None or isinstance(message, int)):
        raise ValueError(f"no message {message!r}")
    if not (math.isfinite(start + length) and length >= 0):
        raise ValueError("times must be finite")
    name = row["joint"]
    if name is not None and name not in place:
        raise ValueError(f"no joint {name!r}")
    joint = None if name is None else place[name]
    return Interval(process, what, joint, message, start / 1e3, (start + length) / 1e3)


def _timeline(found: list[Interval]) -> Timeline:
    found.sort(key=lambda i: i.process)  # stable: the file has each process's stages in order
    ends = [i.end for i in found]
    for k, (before, after) in enumerate(pairwise(found)):
        if before.process == after.process:  # medians of neighbours need not meet
            ends[k] = max(before.start, after.start)
    sent = {i.message: end for i, end in zip(found, ends, strict=True) if i.what == "send"}
    sender = {i.message: i.process for i in found if i.what == "send"}
    intervals: list[Interval] = []
    exchanges: list[Exchange] = []
    for i, end in zip(found, ends, strict=True):
        start = i.start
        if i.what == "receive" and i.message in sent:
            arrived = min(end, max(start, sent[i.message]))
            if arrived > start:
                intervals.append(Interval(i.process, "wait", None, i.message, start, arrived))
            exchanges.append(Exchange(sender[i.message], i.process, sent[i.message], end))
            start = arrived
        intervals.append(Interval(i.process, i.what, i.joint, i.message, start, end))
    return Timeline(tuple(intervals), tuple(exchanges), max(ends), "measured")
