"""Form `segment` by pairwise exchanges: the processes of both sides of a cut join it.

The schedule's tree gives the order of joins, as for the paper's joins. But where two chains meet,
processes of both sides exchange their mobilities and bias accelerations, and all of them join the
two chains. After the last join every process knows all forces on its own part. There are log2(P)
exchanges, instead of log2(P) messages up and as many back.

Along a serial chain, motions are told outwards. Each process computes the passage of its own joints
(pose and motion of their last link relative to the link before the first), and groups of processes
combine passages level by level: two groups at a time, or as many as the schedule's fan says, each
sending its passage to all processes beyond it. So no process computes joints of others on the path
to its own, but for a floating base or a rail that the chain hangs on. How the joint at a cut lies
is known to the process whose part begins with it. It goes with the mobility of the chain that hangs
on that joint, so that nobody waits for motions of others than those before it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from adagen.errors import UsageError
from adagen.plan import steps as do
from adagen.plan.ada import Chain, assembled, bare
from adagen.plan.edges import on_the_way
from adagen.plan.fusions import Run
from adagen.plan.messages import Message
from adagen.plan.robot import PlanJoint, slaved_joint
from adagen.plan.segment import SegmentPlanner
from adagen.plan.sent_passages import can_send_passage
from adagen.plan.steps import Force, Passage, Step
from adagen.plan.types import Process
from adagen.schedule import Node, Schedule, postorder


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


TOLD_BY_ONE = 8
"""Processes that one tells its passage, one after the other: some 30 ns each, where a message that
is told on takes 250."""


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
        self.told: frozenset[int] = frozenset()  # of these joints, those that others place

    def plan(self) -> tuple[tuple[Process, ...], tuple[Message, ...]]:
        """Return every process's steps, and the messages between them."""
        parts = self._parts(self.schedule.root)
        passages = None if parts is None else Passages(self, parts)
        if parts is not None:
            self.told = frozenset(part.start for part in parts[1:])
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
                every: list[Step] = [*map(do.Kinematics, reads), *steps]
            else:
                before = passages.hung_on(p)
                reads = (*before, *own)
                every = [
                    *map(do.Kinematics, before),
                    *passages.steps[p],
                    *map(do.Kinematics, own),
                    *steps,
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
                self._told(part, source, target)
                for part, others in ((a, b), (b, a))
                for source, target in pairs(self._knows(part), self._strange(part, others))
            )

    def _strange(self, part: Chain, others: Chain) -> list[int]:
        """The processes that know another chain and not this one."""
        known = self._knows(part)
        return [p for p in self._knows(others) if p not in known]

    def _told(self, part: Chain, source: int, target: int) -> Message:
        """The message about a chain: what it shows, and how the joint lies that it hangs on."""
        hangs_on = tuple(sorted(link - 1 for link in part.biases if link - 1 in self.told))
        return replace(assembled(part, source, target), placements=hangs_on)

    def _bare(self, link: int, process: int) -> Chain:
        """Return a bare link as a chain; who joins it finds its bias (``_show_bare``)."""
        return bare(link, process)

    def _show_bare(self, process: int, a: Chain, b: Chain) -> None:
        """Steps for a bare link's bias on every process that joins it."""
        links = [link for part in (a, b) if part.joint is None for link in part.biases]
        for p in self._joining_parts(a, b) or {process}:
            self.steps[p] += map(do.LinkBias, links)

    def _joining_parts(self, *parts: Chain) -> set[int]:
        """The processes that know one of two parts; what the ground holds shows nothing."""
        return {p for part in parts if part.biases for p in self._knows(part)}

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
            to[message.source].append(do.Send(number))
        for number, message in numbered:
            to[message.target].append(do.Receive(number))

    def _join(self, run: Run, process: int, a: Chain, b: Chain) -> Chain:
        """Join two parts on all processes that know them."""
        knowing = self._joining_parts(a, b) or {process}
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
        cuts[0] = joints_before_passages(joints)
        ends = [*cuts[1:], len(joints)]
        parts = [range(first, beyond) for first, beyond in zip(cuts, ends, strict=True)]
        return parts if parts[0] else None

    def _inner_cuts(self, node: Node, cut: int = 0) -> Iterator[tuple[int, int]]:
        """Yield for each process, outwards along the chain, the first joint of its part."""
        if len({self.at_work[child.joint] for child in node.children}) < 2:  # one joins both
            yield self.at_work[node.joint][0], cut
            return
        for child in node.children:  # the root side comes first
            yield from self._inner_cuts(child, node.joint if child.joint > node.joint else cut)


class Passages:
    """The motions of a serial chain, told outwards level by level.

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

    def _passage(self, at_work: Sequence[int]) -> Passage:
        return Passage(self.parts[at_work[0]].start, self.parts[at_work[-1]].stop - 1)

    def _groups(self, node: Node) -> list[Node]:
        """The groups of a node's processes, outwards, as many as the schedule combines at once."""
        groups = [node]
        while len(groups) < self.planner.schedule.fan:
            halves = (
                g.children if len(self.planner.at_work[g.joint]) > 1 else (g,) for g in groups
            )
            finer = [one for parts in halves for one in parts]
            if len(finer) == len(groups):
                break
            groups = finer
        return groups

    def _put_together(self, node: Node) -> tuple[int, ...]:
        """Compute the passages before each of a node's processes, and their own if one asks for it.

        The outermost process finds that of its own joints, too: it waits meanwhile, and then knows
        how they lie to each other when it hears how its part moves.

        Returns:
            The processes that know the passage of all of them.
        """
        at_work = self.planner.at_work[node.joint]
        if len(at_work) == 1:
            self.steps[at_work[0]].append(do.Traverse(self._passage(at_work)))
            return at_work
        groups = self._groups(node)
        knowing = [self._put_together(group) for group in groups]
        members = [self.planner.at_work[group.joint] for group in groups]
        self._tell(members, knowing)
        asked = at_work[-1] < len(self.parts) - 1
        for k, own in enumerate(members):
            for p in own:
                self._append(p, members[: k + 1] if asked and p in knowing[-1] else members[:k])
        return knowing[-1]

    def _tell(self, members: Sequence[Sequence[int]], knowing: Sequence[Sequence[int]]) -> None:
        """Send the passage of each group to all processes of those beyond it.

        The outermost of these, which others wait for, are told first. Where they are more than
        those who know it can tell soon, they tell the rest.
        """
        left = [
            (self._passage(own), list(known), list(others))
            for k, others in reversed(list(enumerate(members)))  # who has most to do first
            for own, known in zip(members[:k], knowing, strict=False)
        ]
        while any(others for _, _, others in left):
            told = []
            for passage, known, others in left:
                now = others[-TOLD_BY_ONE * len(known) :]
                told += [self._message(passage, *pair) for pair in pairs(known, now)]
                del others[-len(now) :]
                known += now
            self.planner.exchange(told, self.steps)

    def _append(self, p: int, members: Sequence[Sequence[int]]) -> None:
        """The passage of successive groups on a process that knows that of each."""
        for k in range(1, len(members)):
            near = (members[0][0], members[k - 1][-1])
            passages = ((members[0][0], members[k][-1]), near, members[k])
            self.steps[p].append(do.Append(*map(self._passage, passages)))

    @staticmethod
    def _message(passage: Passage, source: int, target: int) -> Message:
        return Message(source, target, "kinematics", passage.last, passages=(passage,))

    def _arrive(self, node: Node, start: int) -> None:
        """Compute the motions of the links before cuts, from the tree's top downwards.

        Args:
            node: whose processes do that.
            start: the link that their part hangs on.
        """
        at_work = self.planner.at_work[node.joint]
        if len(at_work) == 1:
            return
        for group in self._groups(node):
            own, near = self.planner.at_work[group.joint], start
            if own[0] > at_work[0]:
                before = self._passage((at_work[0], own[0] - 1))
                near = before.link
                for p in own:
                    self.steps[p].append(do.Arrive(before, start))
            self._arrive(group, near)


def joints_before_passages(joints: Sequence[PlanJoint]) -> int:
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
