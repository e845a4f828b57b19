"""Form `segment` by pairwise exchanges: the processes of both sides of a cut join it.

The schedule's tree gives the order of joins, as for the paper's joins. But where two chains meet,
processes of both sides exchange their mobilities and bias accelerations, and all of them join the
two chains. After the last join every process knows all forces on its own part. There are log2(P)
exchanges, instead of log2(P) messages up and as many back.

Along a serial chain, motions are exchanged likewise. Each process computes the passage of its own
joints (pose and motion of their last link relative to the link before the first), and groups of
processes combine passages level by level: two groups at a time, or as many as the schedule's fan
says, each sending its passage to all processes that need it. So no process computes joints of
others on the path to its own, but for a floating base or a rail that the chain hangs on. Work for
the joints at the cuts is done after a process has sent its own passage, while it would wait for the
others.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from adagen.errors import UsageError
from adagen.plan.ada import Chain, assembled
from adagen.plan.edges import on_the_way
from adagen.plan.fusions import Run
from adagen.plan.robot import PlanJoint, slaved_joint
from adagen.plan.segment import SegmentPlanner
from adagen.plan.sent_passages import can_send_passage
from adagen.plan.steps import (
    Append,
    Arrive,
    Force,
    Join,
    Kinematics,
    LinkBias,
    Passage,
    Receive,
    Send,
    Step,
    Traverse,
)
from adagen.plan.types import Message, Process
from adagen.schedule import Node, Schedule, postorder

_MEETING = (Receive, Join, LinkBias)
"""Steps of a sweep from which on a process needs the motions of the joints that it only joins."""


def why_not_exchange(joints: Sequence[PlanJoint], schedule: Schedule) -> str | None:
    """Return why a schedule's processes cannot exchange pair by pair, None where they can."""
    if (slaved := slaved_joint(joints)) is not None:
        return slaved
    at_work = at_work_of(schedule)
    for node in postorder(schedule.root):
        sides = [set(at_work[child.joint]) for child in node.children]
        if len(sides) == 2 and sides[0] != sides[1] and sides[0] & sides[1]:
            return f'processes share both sides of joint "{joints[node.joint].name}"'
    return None


def at_work_of(schedule: Schedule) -> dict[int, tuple[int, ...]]:
    """Return the processes that have joints at or below each node of a schedule, ascending."""
    found: dict[int, tuple[int, ...]] = {}
    for node in postorder(schedule.root):
        below = {p for child in node.children for p in found[child.joint]}
        found[node.joint] = tuple(sorted(below or {node.processes[0]}))
    return found


class ExchangePlanner(SegmentPlanner):
    """Builds the processes and messages of form `segment` by pairwise exchanges.

    Raises:
        UsageError: the schedule's processes cannot exchange pair by pair.
    """

    def __init__(
        self, joints: tuple[PlanJoint, ...], schedule: Schedule, runs: Sequence[Run] = ()
    ) -> None:
        super().__init__(joints, schedule, runs)
        reason = why_not_exchange(joints, schedule)
        if any(len(run) > 1 for run in runs):
            reason = "some joints are joined as one, past links without mass"
        if reason is not None:
            raise UsageError(f"processes cannot exchange pair by pair: {reason}")
        self.at_work = at_work_of(schedule)
        self.knowing: dict[int, tuple[int, ...]] = {}  # who joins a joint, of those that are cut

    def plan(self) -> tuple[tuple[Process, ...], tuple[Message, ...]]:
        """Return every process's steps, and the messages between them."""
        parts = self._parts(self.schedule.root)
        passages = None if parts is None else Passages(self, parts)
        top = self._assemble()
        self._disassemble(top)
        owns = self._owned() if passages is None else passages.owns()
        return self._processes(owns, passages), tuple(self.messages)

    def _owned(self) -> list[list[int]]:
        """The joints whose accelerations each process gives: the first one that knows them."""
        owns: list[list[int]] = [[] for _ in self.steps]
        for p, own in enumerate(self.owns):
            for j in own:
                owns[self.knowing.get(j, (p,))[0]].append(j)
        return [sorted(own) for own in owns]

    def _processes(
        self, owns: Sequence[list[int]], passages: Passages | None
    ) -> tuple[Process, ...]:
        found = []
        for p, (steps, own) in enumerate(zip(self.steps, owns, strict=True)):
            shares = sorted(
                j for j, knowing in self.knowing.items() if p in knowing and j not in own
            )
            if passages is None:
                reads = on_the_way(self.joints, (*own, *shares))
                every: list[Step] = [*map(Kinematics, reads), *steps]
            else:
                before = passages.hung_on(p)
                reads = tuple(sorted((*before, *own, *shares)))
                asked, left = passages.asked_for(p)
                first_message = next(
                    (k for k, s in enumerate(steps) if isinstance(s, _MEETING)), len(steps)
                )
                late = [*left, *map(Kinematics, shares)]
                every = [
                    *map(Kinematics, before),
                    *asked,
                    *map(Kinematics, own),
                    *steps[:first_message],
                    *late,
                    *steps[first_message:],
                ]
            found.append(Process(tuple(every), reads, tuple(own), tuple(shares)))
        return tuple(found)

    def _parts_of(self, node: Node) -> int:  # noqa: ARG002 (each process begins with a cut)
        return self.schedule.parts

    # --- mobilities and forces -------------------------------------------------------------------

    def _knows(self, part: Chain) -> tuple[int, ...]:
        """The processes that know a part's mobility and bias, ascending."""
        if part.joint is None:
            return ()
        return self.knowing.get(part.joint, (part.process,))

    def _meet(self, process: int, parts: tuple[Chain, Chain]) -> None:
        """Send each side's mobility and bias to the other side of a joint."""
        a, b = parts
        if a.joint is None or b.joint is None:
            self._show_bare(process, a, b)
        elif a.biases and b.biases and self._knows(a) != self._knows(b):
            self.exchange(
                assembled(part, source, target)
                for part, others in ((a, b), (b, a))
                for source, target in pairs(self._knows(part), self._knows(others))
            )

    def _show_bare(self, process: int, a: Chain, b: Chain) -> None:
        """Steps for a bare link's bias on every process of a chain that it is joined to."""
        links = [link for part in (a, b) if part.joint is None for link in part.biases]
        for p in (*self._knows(a), *self._knows(b)):
            self.steps[p] += [LinkBias(link) for link in links if p != process]

    def exchange(self, messages: Iterable[Message], steps: list[list[Step]] | None = None) -> None:
        """Add messages, all of which are sent before any is received.

        Args:
            messages: those of one level.
            steps: of each process, to which they are added; those of the sweeps if not given.
        """
        to = self.steps if steps is None else steps
        first = len(self.messages)
        self.messages += messages
        numbered = list(enumerate(self.messages[first:], start=first))
        for number, message in numbered:
            to[message.source].append(Send(number))
        for number, message in numbered:
            to[message.target].append(Receive(number))

    def _join(self, run: Run, process: int, a: Chain, b: Chain) -> Chain:
        """Join two parts on all processes that know them."""
        knowing = {p for part in (a, b) if part.biases for p in self._knows(part)} or {process}
        first, *others = sorted(knowing)
        whole = super()._join(run, first, a, b)
        join = self.steps[first][-1]
        for p in others:
            self.steps[p].append(join)
        if others or first != process:
            self.knowing[run[-1]] = (first, *others)
        return whole

    def _joining(self, chain: Chain) -> Iterable[int]:
        return self._knows(chain)

    def _send_forces(self, chain: Chain, part: Chain, forces: dict[int, Force]) -> None:
        """Nothing is sent: the processes of a part have computed the forces on it."""

    # --- motions ---------------------------------------------------------------------------------

    def _parted(self, node: Node) -> bool:
        """Whether several processes join a node's two sides."""
        return len({self.at_work[child.joint] for child in node.children}) == 2

    def _parts(self, root: Node) -> list[range] | None:
        """The part of a serial chain of each process, inner cut first; None without motions.

        The first part begins behind the joints on which the chain hangs.
        """
        joints = self.joints
        if not all(joint.parent == j for j, joint in enumerate(joints)):
            return None
        cuts: list[int] = []
        last = -1
        for p, cut in self._inner_cuts(root):
            if p != last + 1 or (cuts and cut <= cuts[-1]):
                return None  # processes do not follow each other along the chain
            cuts.append(cut)
            last = p
        if last < 1:
            return None
        cuts[0] = hung_on(joints)
        ends = [*cuts[1:], len(joints)]
        parts = [range(first, beyond) for first, beyond in zip(cuts, ends, strict=True)]
        return parts if parts[0] else None

    def _inner_cuts(self, node: Node, cut: int = 0) -> Iterator[tuple[int, int]]:
        """Yield for each process, outwards along the chain, the first joint of its part."""
        if not self._parted(node):
            yield self.at_work[node.joint][0], cut
            return
        for child in node.children:  # the root side comes first
            yield from self._inner_cuts(child, node.joint if child.joint > node.joint else cut)


class Passages:
    """Exchange of the motions of a serial chain, level by level.

    Args:
        planner: whose messages these are put among.
        parts: the joints of each process, outwards along the chain.

    Attributes:
        steps: of each process, before the kinematics of its own joints.
    """

    def __init__(self, planner: ExchangePlanner, parts: Sequence[range]) -> None:
        self.planner, self.parts = planner, parts
        self.steps: list[list[Step]] = [[] for _ in planner.steps]
        self._put_together(planner.schedule.root)
        self._arrive(planner.schedule.root, parts[0].start)

    def hung_on(self, process: int) -> range:
        """Return the joints before all passages, whose motion a process finds by itself."""
        return range(self.parts[0].start if 0 < process < len(self.parts) else 0)

    def owns(self) -> list[list[int]]:
        """Return the joints whose accelerations each process gives."""
        idle = len(self.steps) - len(self.parts)
        inner, *outer = self.parts
        return [[*range(inner.stop)], *map(list, outer), *([] for _ in range(idle))]

    def asked_for(self, process: int) -> tuple[list[Step], list[Step]]:
        """Return the steps that the process or others wait for, and the remaining ones.

        Where its own joints start must be known before these are swept. How the links move at which
        it joins others' parts is asked only when it has told what its own part shows, and then it
        waits for them.
        """
        parts = self.parts[process : process + 1]  # none of a process without work
        links, passages = {part.start for part in parts}, set[Passage]()
        asked: list[Step] = []
        left: list[Step] = []
        for step in reversed(self.steps[process]):
            now = True
            match step:
                case Send(number):
                    passages.update(self.planner.messages[number].passages)
                case Receive(number):
                    now = not passages.isdisjoint(self.planner.messages[number].passages)
                case Append(whole, near, far):
                    now = whole in passages
                    passages.update((near, far) if now else ())
                case Arrive(passage, near_link):
                    now = passage.link in links
                    if now:
                        passages.add(passage)
                        links.add(near_link)
            (asked if now else left).append(step)
        return asked[::-1], left[::-1]

    def _passage(self, at_work: Sequence[int]) -> Passage:
        return Passage(self.parts[at_work[0]].start, self.parts[at_work[-1]].stop - 1)

    def _division(self, node: Node) -> Division:
        """The groups of a node's processes, as many as the schedule combines at once."""
        whole = Division([node], [])
        while len(whole.groups) < self.planner.schedule.fan:
            finer = whole.finer(self.planner.at_work)
            if len(finer.groups) == len(whole.groups):
                break
            whole = finer
        return whole

    def _put_together(self, node: Node) -> None:
        """Compute the passage of a node's processes; of several, only if another process needs it.

        The outermost process finds its own, too: it waits meanwhile, and then knows how its joints
        lie to each other when it hears how its part moves.
        """
        at_work = self.planner.at_work[node.joint]
        if len(at_work) == 1:
            self.steps[at_work[0]].append(Traverse(self._passage(at_work)))
            return
        division = self._division(node)
        for group in division.groups:
            self._put_together(group)
        members = [self.planner.at_work[group.joint] for group in division.groups]
        wanted = self._wanted(division, members)
        self.planner.exchange(
            [
                self._message(self._passage(own), source, target)
                for k, others in reversed(list(enumerate(members)))  # who has most to do first
                for i, own in enumerate(members)
                if i != k
                for source, target in pairs(own, [p for p in others if i < wanted[p]])
            ],
            self.steps,
        )
        for p in at_work:
            near = members[0]
            for own in members[1 : wanted[p]]:
                both = (*near, *own)
                append = Append(self._passage(both), self._passage(near), self._passage(own))
                self.steps[p].append(append)
                near = both

    def _wanted(self, division: Division, members: Sequence[tuple[int, ...]]) -> dict[int, int]:
        """By process, the number of groups whose passages it needs, from the innermost on.

        All, where processes beyond them ask for that of all; else up to the cuts that it joins.
        """
        if members[-1][-1] < len(self.parts) - 1:
            return {p: len(members) for own in members for p in own}
        wanted = {p: 0 for own in members for p in own}
        for cut in division.cuts:
            for p in self._hanging(cut, members):
                wanted[p] = max(wanted[p], cut.at)
        return wanted

    @staticmethod
    def _hanging(cut: Cut, members: Sequence[tuple[int, ...]]) -> list[int]:
        """The processes that need the motion of the link before a cut.

        The one whose own joints end there knows it by these.
        """
        joining = [p for own in members[cut.first : cut.beyond] for p in own]
        return [p for p in joining if p != members[cut.at - 1][-1]]

    @staticmethod
    def _message(passage: Passage, source: int, target: int) -> Message:
        return Message(source, target, "kinematics", passage.last, passages=(passage,))

    def _arrive(self, node: Node, start: int) -> None:
        """Compute the motions of the links before cuts, from the tree's top downwards.

        Args:
            node: whose processes do that.
            start: the link that their part hangs on.
        """
        if len(self.planner.at_work[node.joint]) == 1:
            return
        division = self._division(node)
        members = [self.planner.at_work[group.joint] for group in division.groups]
        before = [
            self._passage((members[0][0], own[-1])) for own in members
        ]  # of all groups up to each
        for cut in division.cuts:
            for p in self._hanging(cut, members):
                self.steps[p].append(Arrive(before[cut.at - 1], start))
        for k, group in enumerate(division.groups):
            self._arrive(group, before[k - 1].link if k else start)


class Cut(NamedTuple):
    """A cut between successive groups: groups first .. at .. beyond."""

    first: int
    at: int
    beyond: int


@dataclass(frozen=True)
class Division:
    """Groups of processes that combine their passages at once, and the cuts between them.

    Attributes:
        groups: outwards along the chain, the nodes whose processes they are.
        cuts: where they meet, those of the most groups first.
    """

    groups: list[Node]
    cuts: list[Cut]

    def finer(self, at_work: Mapping[int, tuple[int, ...]]) -> Division:
        """Return the same with each group of several processes divided in two."""
        groups: list[Node] = []
        own: list[Cut] = []
        ends = [0]
        for group in self.groups:
            sides = group.children if len(at_work[group.joint]) > 1 else (group,)
            if len(sides) == 2:
                own.append(Cut(ends[-1], ends[-1] + 1, ends[-1] + 2))
            groups += sides
            ends.append(len(groups))
        cuts = [Cut(*(ends[end] for end in cut)) for cut in self.cuts]
        return Division(groups, [*cuts, *own])


def hung_on(joints: Sequence[PlanJoint]) -> int:
    """Return how many joints of a serial chain are before all whose passages are exchanged.

    A floating base, for one: every process finds its motion by itself, and passages begin there.
    """
    return 1 + max(
        (j for j, joint in enumerate(joints) if not can_send_passage([joint])), default=-1
    )


def pairs(sources: Sequence[int], targets: Sequence[int]) -> Iterator[tuple[int, int]]:
    """Yield for each target the source that sends to it, sources taking turns."""
    for k, target in enumerate(targets):
        yield sources[k % len(sources)], target
