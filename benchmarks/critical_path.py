"""The critical path of an evaluation: from its end back, along what was waited for."""

from __future__ import annotations

from dataclasses import dataclass

from adagen.cost.simulation import Interval, Timeline
from adagen.plan.steps import (
    Append,
    Arrive,
    Disassemble,
    InvertRoot,
    Join,
    Propagate,
    Receive,
    Send,
    Step,
    Traverse,
)
from adagen.program import Program

JOINTS, PASSAGES, SHOWING = "own joints", "passages", "showing"
JOINS, NUMBERS, LATENCY = "joins", "numbers", "latency"
KINDS = (JOINTS, PASSAGES, SHOWING, JOINS, NUMBERS, LATENCY)
"""Kinds of work and waiting.

Own joints: kinematics, sweeps inwards and outwards. Passages: how parts move others' links, found,
put together and brought to their own. Showing: the mobility of a part at its handles. Joins: of
parts, and forces after them. Numbers: written into messages and read from them.
"""

_OF: tuple[tuple[str, tuple[type[Step], ...]], ...] = (
    (NUMBERS, (Send, Receive)),
    (PASSAGES, (Traverse, Append, Arrive)),
    (SHOWING, (Propagate, InvertRoot)),
    (JOINS, (Join, Disassemble)),
)


@dataclass(frozen=True)
class Limits:
    """The parts of an evaluation's time along its critical path; microseconds.

    Attributes:
        times: by each of ``KINDS``.
        hops: messages on the way.
    """

    times: dict[str, float]
    hops: int

    @property
    def most(self) -> str:
        """The kind of the largest part."""
        return max(KINDS, key=lambda kind: self.times[kind])


def limits(program: Program, line: Timeline) -> Limits:
    """Return the critical path of a timeline.

    The way goes back from the end of the last process. Where a process waited, it goes on at the
    sender: in between is latency. What a process does before its first step counts as its joints.

    Args:
        program: what runs.
        line: how it is predicted to go.
    """
    own: dict[int, list[Interval]] = {}
    for interval in line.intervals:
        own.setdefault(interval.process, []).append(interval)
    sent = {
        each.message: (p, k)
        for p, intervals in own.items()
        for k, each in enumerate(intervals)
        if each.what == "send"
    }
    times, hops = dict.fromkeys(KINDS, 0.0), 0
    p = max(own, key=lambda process: own[process][-1].end)
    k = len(own[p]) - 1
    while k >= 0:
        interval = own[p][k]
        if interval.what == "wait":
            p, k = sent[interval.message]
            times[LATENCY] += interval.end - own[p][k].end
            hops += 1
            continue
        times[_kind(program, interval)] += interval.end - interval.start
        if k == 0:
            times[JOINTS] += interval.start
        k -= 1
    return Limits(times, hops)


def _kind(program: Program, interval: Interval) -> str:
    assert interval.operation is not None  # as played
    steps = program.processes[interval.process].operations[interval.operation].steps
    for kind, classes in _OF:
        if steps and isinstance(steps[0], classes):
            return kind
    return JOINTS
