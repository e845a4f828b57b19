"""How runs of joints move, told by the process that has them to those that hang beyond.

Whoever has joints far from the ground must know how the link moves that they hang on. It passes the
joints in between, though another process passes them as well. Along a serial chain the other one
can tell it instead: as soon as it knows how its run moves the last link (a passage), long before it
has swept the run.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from adagen.plan.gather_trees import Tree
from adagen.plan.robot import PlanJoint
from adagen.plan.steps import Arrive, Kinematics, Passage, Receive, Send, Step, Traverse
from adagen.plan.types import Message, Process

PASSED = frozenset({"revolute", "spherical"})
"""Kinds of joints whose motion is told: those that are passed in registers."""


def passable(joints: Sequence[PlanJoint], run: Iterable[int]) -> bool:
    """Return whether the motion of a run of joints can be told as a whole."""
    return all(joints[j].kind in PASSED and not joints[j].prescribed for j in run)


class Way(NamedTuple):
    """Joints between the ground and those of a process, all of which one other process has.

    Attributes:
        teller: that process.
        passage: of these joints.
    """

    teller: int
    passage: Passage


def ways_told(
    joints: Sequence[PlanJoint], trees: Iterable[Tree], processes: Sequence[Process]
) -> dict[int, Way]:
    """Return of each process that can be told how what it hangs on moves the way to there.

    It hangs on the last link of a serial run from the ground, all of which another process has.

    Args:
        joints: the robot's joints.
        trees: as processes meet in them.
        processes: what they do.
    """
    owner = {j: p for tree in trees for j, p in tree.owner.items()}
    found: dict[int, Way] = {}
    for p, process in enumerate(processes):
        own = set(process.treated)
        passed = [j for j in process.reads if j not in own]
        tellers = {owner.get(j, p) for j in passed}
        hang = {joints[j].parent for j in own} - {j + 1 for j in own}
        serial = all(joints[j].parent == j == k for k, j in enumerate(passed))
        others = len(tellers) == 1 and p not in tellers
        if others and serial and hang == {len(passed)} and passable(joints, passed):
            found[p] = Way(tellers.pop(), Passage(0, passed[-1]))
    return found


def telling(
    joints: Sequence[PlanJoint],
    ways: Mapping[int, Way],
    processes: Sequence[Process],
    messages: Sequence[Message],
) -> tuple[tuple[Process, ...], tuple[Message, ...]]:
    """Return the same processes with some told of others' joints, and their messages.

    Args:
        joints: the robot's joints.
        ways: those that processes are told of.
        processes: each of which passes all joints up to its own.
        messages: theirs.
    """
    every = list(messages)
    usual = _told(joints, ways, [process.steps for process in processes], every)
    again = [process.recovery for process in processes]
    if any(again):
        again = _told(joints, ways, again, every)
    found = []
    for p, process in enumerate(processes):
        beyond = ways[p].passage.last if p in ways else -1
        reads = tuple(j for j in process.reads if j > beyond)
        found.append(replace(process, steps=usual[p], reads=reads, recovery=again[p]))
    return tuple(found), tuple(every)


def _told(
    joints: Sequence[PlanJoint],
    ways: Mapping[int, Way],
    steps: Sequence[tuple[Step, ...]],
    messages: list[Message],
) -> list[tuple[Step, ...]]:
    """Steps of each process whose motions some are told of; the messages are added.

    Whoever is told finds meanwhile how its own joints lie to each other, if they are a run, too.
    """
    before: list[list[Step]] = [[] for _ in steps]
    found = list(steps)
    for p, (teller, run) in sorted(ways.items()):
        number = len(messages)
        messages.append(Message(teller, p, "kinematics", run.last, passages=(run,)))
        if (traverse := Traverse(run)) not in before[teller]:
            before[teller].append(traverse)
        before[teller].append(Send(number))
        rest = [s for s in steps[p] if not (isinstance(s, Kinematics) and s.joint <= run.last)]
        own = [step.joint for step in rest if isinstance(step, Kinematics)]
        if all(joints[j].parent == j for j in own) and passable(joints, own):
            before[p].append(Traverse(Passage(own[0], own[-1])))
        found[p] = (Receive(number), Arrive(run, 0), *rest)
    return [(*first, *rest) for first, rest in zip(before, found, strict=True)]
