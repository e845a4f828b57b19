"""Passages of inner runs of joints, sent to the processes beyond them.

A process with joints far from the ground needs the motion of the link before its own joints, so it
computes the kinematics of all joints in between, though another process computes them as well.
Along a serial chain that process can send the motion instead: its passage (pose and motion of the
run's last link) is known long before its inward sweep ends.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from adagen.plan.gather_trees import Tree
from adagen.plan.messages import Message
from adagen.plan.robot import PlanJoint
from adagen.plan.steps import Arrive, Kinematics, Passage, Receive, Send, Step, Traverse
from adagen.plan.types import Process

PASSED = frozenset({"revolute", "spherical"})
"""Kinds of joints whose passages are computed in registers."""


def can_send_passage(run: Iterable[PlanJoint]) -> bool:
    """Return whether the passage of a run of joints can be sent, as far as their kinds go."""
    return PASSED.issuperset(joint.priced_as for joint in run)


class InnerRun(NamedTuple):
    """The run of joints between the ground and a process, all of which one other process has.

    Attributes:
        sender: that process.
        passage: of these joints.
    """

    sender: int
    passage: Passage


def inner_runs(
    joints: Sequence[PlanJoint], trees: Iterable[Tree], processes: Sequence[Process]
) -> dict[int, InnerRun]:
    """Return for each process that can receive a passage the run of joints before its own.

    Its joints begin at the last link of a serial run from the ground, which another process has.

    Args:
        joints: the robot's joints.
        trees: the layout of processes in them.
        processes: their steps.
    """
    owner = {j: p for tree in trees for j, p in tree.owner.items()}
    found: dict[int, InnerRun] = {}
    for p, process in enumerate(processes):
        own = set(process.treated)
        passed = [j for j in process.reads if j not in own]
        senders = {owner.get(j, p) for j in passed}
        hang = {joints[j].parent for j in own} - {j + 1 for j in own}
        serial = all(joints[j].parent == j == k for k, j in enumerate(passed))
        others = len(senders) == 1 and p not in senders
        serial = serial and hang == {len(passed)}
        if others and serial and can_send_passage(joints[j] for j in passed):
            found[p] = InnerRun(senders.pop(), Passage(0, passed[-1]))
    return found


def with_sent_passages(
    joints: Sequence[PlanJoint],
    runs: Mapping[int, InnerRun],
    processes: Sequence[Process],
    messages: Sequence[Message],
) -> tuple[tuple[Process, ...], tuple[Message, ...]]:
    """Return the same processes, some with received passages, and their messages.

    Args:
        joints: the robot's joints.
        runs: the inner run of each process that receives a passage.
        processes: each of which computes the kinematics of all joints up to its own.
        messages: their messages.
    """
    every = list(messages)
    usual = _with_messages(joints, runs, [process.steps for process in processes], every)
    again = [process.recovery for process in processes]
    if any(again):
        again = _with_messages(joints, runs, again, every)
    found = []
    for p, process in enumerate(processes):
        beyond = runs[p].passage.last if p in runs else -1
        reads = tuple(j for j in process.reads if j > beyond)
        found.append(replace(process, steps=usual[p], reads=reads, recovery=again[p]))
    return tuple(found), tuple(every)


def _with_messages(
    joints: Sequence[PlanJoint],
    runs: Mapping[int, InnerRun],
    steps: Sequence[tuple[Step, ...]],
    messages: list[Message],
) -> list[tuple[Step, ...]]:
    """Steps of each process with sent and received passages; the messages are added.

    The receiver computes the passage of its own joints meanwhile, if they are a run, too.
    """
    before: list[list[Step]] = [[] for _ in steps]
    found = list(steps)
    for p, (sender, run) in sorted(runs.items()):
        number = len(messages)
        messages.append(Message(sender, p, "kinematics", run.last, passages=(run,)))
        if (traverse := Traverse(run)) not in before[sender]:
            before[sender].append(traverse)
        before[sender].append(Send(number))
        rest = [s for s in steps[p] if not (isinstance(s, Kinematics) and s.joint <= run.last)]
        own = [step.joint for step in rest if isinstance(step, Kinematics)]
        if all(joints[j].parent == j for j in own) and can_send_passage(joints[j] for j in own):
            before[p].append(Traverse(Passage(own[0], own[-1])))
        found[p] = (Receive(number), Arrive(run, 0), *rest)
    return [(*first, *rest) for first, rest in zip(before, found, strict=True)]
