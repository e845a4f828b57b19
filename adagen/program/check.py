"""Proof that a program is well formed, on every emission, in linear time.

It proves: every value is set before it is read, and none is overwritten or added to at a wrong
time; every message is sent once by its source, contains what its source has computed, and is
received once by its target; processes do not deadlock, and none overtakes another so far that it
overwrites what that one still reads; every joint's acceleration is computed by its owner, and has
one owner; loops store the first inertia at a link and add all others.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import zip_longest

from adagen.plan import steps as do
from adagen.plan.messages import ENERGIES
from adagen.plan.order import ends_of
from adagen.plan.simd_groups import Limbs, placed_links
from adagen.plan.steps import Step
from adagen.plan.turns import by_turns
from adagen.plan.types import Plan
from adagen.program.effects import Effects, Place, added_by, contents, effects, joined_runs
from adagen.program.message_reuse import overwritten
from adagen.program.names import PASSING, PREPARES
from adagen.program.runs import Run, ends_of_run, parts_in
from adagen.program.types import Links, Operation, Program


class ProgramError(Exception):
    """A program that would compute something else than its plan, or nothing at all."""


def check(program: Program) -> None:
    """Check a program, its recovery steps included.

    Raises:
        ProgramError: it is not well formed; the message names the process and the operation.
    """
    _check_owners(program.plan)
    runs: list[Sequence[Sequence[Operation]]] = [[p.operations for p in program.processes]]
    if any(process.recovery for process in program.processes):
        runs.append([process.recovery for process in program.processes])
    runs += zip_longest(*(each.others for each in program.processes), fillvalue=())
    for plan, operations in zip(program.plan.alternatives, runs, strict=True):
        _check_run(plan, operations, placed_links(program.plan))  # where loops keep inertias


def _check_owners(plan: Plan) -> None:
    owners: dict[int, int] = {}
    for p, process in enumerate(plan.processes):
        for joint in process.owns:
            if joint in owners:
                raise ProgramError(
                    f'joint "{plan.joints[joint].name}" is owned by processes {owners[joint]} '
                    f"and {p}"
                )
            owners[joint] = p
    for joint, known in enumerate(plan.joints):
        if joint not in owners:
            raise ProgramError(f'no process owns joint "{known.name}"')


def _check_run(
    plan: Plan, operations: Sequence[Sequence[Operation]], placed: Collection[int]
) -> None:
    """Run each process as far as messages have come, until all are done."""
    mail: set[int] = set()
    received: set[int] = set()
    runs = joined_runs(plan)
    memories = [_Memory(plan, p, runs, placed) for p in range(len(operations))]
    lengths = dict(enumerate(map(len, operations)))
    at = by_turns(lengths, lambda p, k: memories[p].run(operations[p][k], mail, received))
    for p, own in enumerate(operations):
        if at[p] < len(own):
            raise ProgramError(f"process {p} waits for ever at {own[at[p]].does}")
        memories[p].finish()
    exchanged = {
        step.message
        for own in operations
        for operation in own
        for step in operation.steps
        if isinstance(step, do.Send)
    }
    if lost := exchanged - received:
        raise ProgramError(f"message {min(lost)} is sent and never received")
    if early := overwritten(plan.messages, operations):
        raise ProgramError(f"message {early[0]} may be overwritten before it was read")


class _Memory:
    """The buffers that one process has set, and whether they have been read since."""

    def __init__(
        self, plan: Plan, p: int, runs: dict[int, tuple[int, ...]], placed: Collection[int]
    ) -> None:
        self.plan, self.p, self.runs = plan, p, runs
        self.read: dict[Place, bool] = {}  # of each place that is set: whether it has been read
        self.left: dict[int, bool] = {}  # of links at which loops left an inertia: likewise
        self.prepared: set[tuple[str, int]] = set()  # what loops have prepared
        self.placed = placed
        self.where = ""

    def run(self, operation: Operation, mail: set[int], received: set[int]) -> bool:
        """Run an operation; return False if it has to wait for a message."""
        self.where = f"process {self.p}, {operation.does}"
        if isinstance(operation.block, Links):
            words = (operation.does,) if operation.does in PREPARES else ()
            self.prepared |= {(word, k) for word in words for k in operation.block.numbers}
        for place in self._needed(operation):
            if place not in self.prepared:
                raise ProgramError(f"{self.where}: {place[0]} of {place[1]} is missing")
        for step in operation.steps:
            match step:
                case do.Receive():
                    if not self._receive(step.message, mail, received):
                        return False
                case do.Send():
                    self._send(step.message, mail)
                case _:
                    self._apply(effects(self.plan, self.p, step, self.runs))
        self._forget(operation)
        self._leave(operation)
        return True

    def _forget(self, operation: Operation) -> None:
        """Joints that are passed on the way to others leave nothing but their last link's frame."""
        if operation.does == PASSING and isinstance(operation.block, Run):
            run = operation.block
            for j in run.joints():
                del self.read["transform", j]
                if j < run.last:
                    del self.read["velocity", j + 1]

    def finish(self) -> None:
        """Check that all accelerations are there."""
        self.where = f"process {self.p}"
        for joint in self.plan.processes[self.p].owns:
            if self.plan.wants(joint) and ("qdd", joint) not in self.read:
                name = self.plan.joints[joint].name
                raise ProgramError(f'{self.where}: the acceleration of "{name}" is not computed')

    def _apply(self, found: Effects) -> None:
        for place in (*found.reads, *found.alters):
            self._known(place)
            self.read[place] = True
        for place in found.adds:
            self._known(place)
            if self.read[place]:
                raise ProgramError(f"{self.where}: {place} is added to after it was read")
        for place in found.sets:
            self._set(place)
        for place in found.alters:
            self.read[place] = False

    def _known(self, place: Place) -> None:
        if place not in self.read:
            raise ProgramError(f"{self.where}: {place} is read before it is set")

    def _set(self, place: Place) -> None:
        if self.read.get(place) is False:
            raise ProgramError(f"{self.where}: {place} is overwritten before it was read")
        self.read[place] = False

    def _send(self, number: int, mail: set[int]) -> None:
        message = self.plan.messages[number]
        if message.source != self.p or number in mail:
            raise ProgramError(f"{self.where}: message {number} is not this process's to send")
        mail.add(number)
        inertias: Iterable[Place] = (("inertia", link) for link in added_by(message))
        for place in (*contents(message), *inertias):
            self._known(place)
            # An inertia that is sent is this process's share of a sum that goes on here.
            inertia = isinstance(place, tuple) and place[0] == "inertia"
            self.read[place] = self.read[place] or not inertia

    def _receive(self, number: int, mail: set[int], received: set[int]) -> bool:
        message = self.plan.messages[number]
        if message.target != self.p or number in received:
            raise ProgramError(f"{self.where}: message {number} is not this process's to receive")
        if number not in mail:
            return False
        received.add(number)
        if message.sweep == ENERGIES:
            self._apply(Effects(alters=contents(message)))
        else:
            self._apply(Effects(sets=contents(message)))
        for link in added_by(message):
            if ("inertia", link) in self.read:
                self._apply(Effects(adds=(("inertia", link),)))
            else:
                self._set(("inertia", link))
        return True

    def _needed(self, operation: Operation) -> Iterator[tuple[str, int]]:
        """The buffers that an operation of loops needs."""
        for step in operation.steps:
            match step, operation.method:
                case do.Kinematics(), "each" | "strips" | "traversed" | "lanes" | "base":
                    yield "angles", step.joint
                case do.Traverse(passage), _ if self.prepared:
                    yield from (("angles", j) for j in range(passage.first, passage.last + 1))
                case do.Articulate(), "columns":
                    link = ends_of(self.plan.joints, step.joint, step.reversed).far
                    if ("inertia", link) in self.read and link not in self.placed:
                        yield "link_columns", link
                case do.SolveRoot() | do.SolveMobility(), _ if self.prepared:
                    if step.link in self.placed and ("own", step.link) in self.prepared:
                        yield "place_inertia", step.link

    def _leave(self, operation: Operation) -> None:
        """Check that loops store the first inertia at a link, and add others."""
        for step in operation.steps:
            for link in self._used_up(step):
                if link in self.left:
                    self.left[link] = True
            if isinstance(step, do.StartLink) and self.prepared and step.link in self.placed:
                self.prepared.add(("own", step.link))
            if isinstance(step, do.StartEmpty):
                self.left.pop(step.link, None)
            if isinstance(step, do.HoldMobility):
                self.left[step.link] = False
        for link, first in zip(self._left_at(operation), operation.first, strict=True):
            if link == 0:
                continue
            if first and self.left.get(link) is False:
                raise ProgramError(f"{self.where}: the inertia left at link {link} is lost")
            if not first and link not in self.left:
                raise ProgramError(f"{self.where}: nothing was left at link {link} to add to")
            self.left[link] = False

    def _used_up(self, step: Step) -> tuple[int, ...]:
        """Links whose inertia a step uses up."""
        match step:
            case do.Articulate():
                return (ends_of(self.plan.joints, step.joint, step.reversed).far,)
            case do.SolveRoot() | do.SolveMobility() | do.InvertRoot() | do.LoadRoot():
                return (step.link,)
        return ()

    def _left_at(self, operation: Operation) -> tuple[int, ...]:
        """Links at which an operation adds an inertia, as ``first`` has them."""
        match operation.does, operation.block:
            case _ if not operation.first:
                return ()
            case "articulate", Limbs() as limbs:
                return tuple(self.plan.joints[j].parent for j in limbs.rows[0])
            case "articulate", Run() if operation.method == "parts":
                return tuple(part.first for part in parts_in(operation.steps))  # of a serial chain
            case "articulate", Run() as run:
                return (ends_of_run(self.plan.joints, run)[0],)
            case "free_base", Run() as run:
                return (run.first + 1,)
            case "place_inertia", Links() as links:
                return links.numbers
            case "receive", _:
                (step,) = operation.steps
                assert isinstance(step, do.Receive)
                return self.plan.messages[step.message].inertias
        raise ProgramError(f"{self.where} says what it leaves, and leaves nothing")
