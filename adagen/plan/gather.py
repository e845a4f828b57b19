"""Form `segment` with one exchange: all processes gather their articulated bodies at a core.

A root link is chosen for each tree of moving links. Joints with two or more processes beyond them,
seen from the root, are its *core*; all other joints are in branches of one process each. A process
sweeps its branches to the core's links and sends the results: inertias and bias forces, 27 numbers
for each link. Then each process sweeps the core, solves for the root's acceleration and sweeps
outwards, through the core and its own branches. With two processes and one cut, the core is a
single link, and the total work is that of the serial algorithm, with one exchange. Inertias are
only added, so nothing needs to be inverted at a cut.

If the ground is beyond the root, its side is swept outwards from the ground: the mobility of the
first link that enough joints hold is inverted, and from there on the ground is a body like others.
In a pose where that mobility is nearly singular, the evaluation is repeated without this inverse:
the mobility Phi and bias b are carried to the root, and (1 + Phi I) a = b - Phi p is solved.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from adagen.errors import InputError
from adagen.plan.gather_steps import ProcessSteps, about, contribution
from adagen.plan.gather_trees import Tree, given_trees, laid_out_trees
from adagen.plan.messages import Message
from adagen.plan.robot import PlanJoint
from adagen.plan.segment import SegmentPlanner
from adagen.plan.sent_passages import inner_runs, with_sent_passages
from adagen.plan.steps import Step
from adagen.plan.types import Process
from adagen.schedule import postorder
from adagen.schedule.tree import Gathered


def trees_of(joints: Sequence[PlanJoint], gathered: Gathered) -> list[Tree]:
    """Return the trees of moving links in the layout of a schedule.

    Raises:
        InputError: it asks for what processes cannot do.
    """
    try:
        return given_trees(joints, gathered.roots, gathered.owners)
    except ValueError as error:
        raise InputError(f"processes cannot gather as the schedule has it: {error}") from None


class GatherPlanner(SegmentPlanner):
    """Builds the processes and messages of form `segment` with one exchange."""

    def trees(self) -> list[Tree]:
        """Return the trees of moving links in the layout for the schedule's processes.

        Raises:
            InputError: the schedule asks for what processes cannot do.
        """
        if self.schedule.gathered is not None:
            return trees_of(self.joints, self.schedule.gathered)
        assigned: dict[int, int] = {}  # process of each joint inside a segment
        first: dict[int, int] = {}  # of every joint
        for node in postorder(self.schedule.root):
            first[node.joint] = node.processes[0]
            if node.joint in self.members:
                assigned[node.joint] = node.processes[0]
        return laid_out_trees(self.joints, assigned, first)

    def gathered(self) -> Gathered:
        """Return the layout: where processes gather, and the owners of joints."""
        owners: list[int | None] = [None] * len(self.joints)
        trees = self.trees()
        for tree in trees:
            for joint, p in tree.owner.items():
                owners[joint] = p
            if tree.base is not None:
                owners[tree.base] = tree.link_owner(tree.base + 1)
        return Gathered(tuple(tree.root for tree in trees), tuple(owners))

    def plan(self) -> tuple[tuple[Process, ...], tuple[Message, ...]]:
        """Return every process's steps, and the messages between them.

        Raises:
            InputError: as ``trees``; or no process can receive a passage as scheduled.
        """
        trees = self.trees()
        steps = self._evaluation(trees)
        recovery: list[list[Step]] = [[] for _ in steps]
        if any(tree.hold for tree in trees):
            recovery = self._evaluation([replace(tree, hold=0) for tree in trees])
        processes = [
            ProcessSteps(self.joints, trees, p).process_of(own, again)
            for p, (own, again) in enumerate(zip(steps, recovery, strict=True))
        ]
        if self.schedule.gathered is None or not self.schedule.gathered.told:
            return tuple(processes), tuple(self.messages)
        runs = inner_runs(self.joints, trees, processes)
        if not runs:
            raise InputError(
                "no process needs the motion of joints at the ground that another one has: "
                'leave "told" out'
            )
        return with_sent_passages(self.joints, runs, processes, self.messages)

    def _evaluation(self, trees: Sequence[Tree]) -> list[list[Step]]:
        """Return the steps of every process without kinematics; messages are added."""
        first = len(self.messages)
        self.messages += exchange(trees)
        sides = sides_of(self.messages, len(self.steps), first)
        return [ProcessSteps(self.joints, trees, p).evaluation(*own) for p, own in enumerate(sides)]


def sides_of(
    messages: Sequence[Message], processes: int, first: int = 0
) -> list[tuple[list[int], list[int]]]:
    """Return for each process the numbers of the messages that it sends, and that it receives."""
    sides: list[tuple[list[int], list[int]]] = [([], []) for _ in range(processes)]
    for number, message in enumerate(messages[first:], start=first):
        sides[message.source][0].append(number)
        sides[message.target][1].append(number)
    return sides


def exchange(trees: Iterable[Tree]) -> Iterator[Message]:
    """Yield the messages between processes that share cores."""
    for tree in trees:
        if len(tree.participants) > 1:
            for p in tree.participants:
                if (own := contribution(tree, p)) is not None:
                    others = (other for other in tree.participants if other != p)
                    yield from (own.message(p, other, about(tree)) for other in others)
