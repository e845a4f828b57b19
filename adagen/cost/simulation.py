"""The timeline of a program: simulated execution of its processes and messages."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

from adagen.cost.batches import of_registers, states_at_once
from adagen.cost.features import joins_of, operation_features
from adagen.cost.straight import straight_times
from adagen.plan.passive import tangents
from adagen.plan.stages import Stage, stages
from adagen.plan.steps import Receive, Send
from adagen.plan.turns import by_turns
from adagen.program import Operation, Program
from adagen.program.lower import LOOPS
from adagen.program.names import PREPARED
from adagen.schedule.costs import ChannelCosts, StepCosts
from adagen.schedule.fat_tree import Links
from adagen.schedule.profile import CostProfile


@dataclass(frozen=True)
class Interval:
    """An interval in which a process works or waits; microseconds from the start.

    Attributes:
        process: which process.
        what: kinematics, assembly, disassembly, slaved, send, receive or wait; call where a
            process has not begun its steps (``Timeline.calls``).
        joint: the joint that the work ends with (disassembly: begins with), for people.
        message: number of the message that is sent, received or waited for.
        start: when it begins.
        end: when it ends.
        operation: place of the operation in the process's program; None where that is not known.
    """

    process: int
    what: str
    joint: int | None
    message: int | None
    start: float
    end: float
    operation: int | None = None


@dataclass(frozen=True)
class Exchange:
    """A message between processes; microseconds from the start."""

    sender: int
    receiver: int
    sent: float
    used: float


@dataclass(frozen=True)
class Timeline:
    """The timeline of an evaluation, predicted or measured; times in microseconds.

    Attributes:
        intervals: process by process, in order.
        exchanges: messages between processes.
        makespan: when the last process is done.
        source: ``predicted`` or ``measured``.
        states: how many are solved at once: in a batch, those that a register holds.
    """

    intervals: tuple[Interval, ...]
    exchanges: tuple[Exchange, ...]
    makespan: float
    source: str
    states: int = 1

    @property
    def state_time(self) -> float:
        """Time of a process for one state."""
        return self.makespan / self.states

    @property
    def calls(self) -> tuple[Interval, ...]:
        """Time of each process before its first step: the call, and its arguments."""
        first: dict[int, float] = {}
        for i in self.intervals:
            first[i.process] = min(i.start, first.get(i.process, i.start))
        return tuple(
            Interval(p, "call", None, None, 0.0, start) for p, start in first.items() if start > 0
        )

    def busy(self, process: int) -> float:
        """Return the time in which a process works, from when it is called."""
        return sum(
            i.end - i.start
            for i in (*self.calls, *self.intervals)
            if i.process == process and i.what != "wait"
        )

    def waiting(self, process: int) -> float:
        """Return the time in which a process waits for others, before its own end."""
        return sum(
            i.end - i.start for i in self.intervals if i.process == process and i.what == "wait"
        )

    def by_stage(self) -> Timeline:
        """Return the same with the operations of each stage as one interval, as in traces."""
        found: list[Interval] = []
        for interval in self.intervals:
            last = found[-1] if found else None
            if (
                last is not None
                and interval.message is None is last.message
                and (interval.process, interval.what) == (last.process, last.what)
            ):
                found[-1] = replace(last, end=interval.end, operation=None)
            else:
                found.append(replace(interval, operation=None))
        return replace(self, intervals=tuple(found))


def timeline(program: Program, profile: CostProfile, links: Links | None = None) -> Timeline:
    """Return the predicted timeline of an evaluation.

    Each process is assumed to have a core of its own, and all to begin at the same instant. An
    evaluation of a batch solves a register full of states.

    Args:
        program: what runs.
        profile: a profile with the costs of steps.
        links: what messages cost between processes that share no memory; all share it where
            that is not given.

    Raises:
        ValueError: the profile prices joins alone, as the paper's does.
    """
    return _Play(program, profile.measured, links).play()


def state_time(program: Program, profile: CostProfile) -> float:
    """Return the predicted time of a process for one state, microseconds.

    Args:
        program: of a batch, or of one state after the other.
        profile: a profile with the costs of steps.

    Raises:
        ValueError: the profile prices joins alone, as the paper's does.
    """
    return timeline(program, profile).state_time


@dataclass
class _Play:
    program: Program
    costs: StepCosts
    links: Links | None = None
    sent: dict[int, float] = field(default_factory=dict)  # message -> when its sender was done

    def __post_init__(self) -> None:
        plan = self.program.plan
        self.plan = plan
        self.near: ChannelCosts = self.costs.channel(plan.channel)
        self.stages = [stages(process) for process in plan.processes]
        self.time = _times(self.program, self.costs)
        self.at = [0] * len(plan.processes)  # operation of each process that is played
        self.clock = [
            self._evaluation(p) / self.costs.speed(p) if process.operations else 0.0
            for p, process in enumerate(self.program.processes)
        ]
        self.intervals: list[Interval] = []
        self.exchanges: list[Exchange] = []

    def _evaluation(self, p: int) -> float:
        """Time before a process's first step: the call, and what friction asks for."""
        if self.program.batch:
            return 0.0
        straight = self.program.shape == "unrolled"
        call = self.costs["unrolled.evaluation" if straight else "process.evaluation"]
        return call + self.costs["process.tangent"] * tangents(self.plan, self.plan.processes[p])

    def play(self) -> Timeline:
        """Run every process as far as possible, until all are done."""
        lengths = {p: len(own.operations) for p, own in enumerate(self.program.processes)}
        reached = by_turns(lengths, self._advance)
        assert reached == lengths, "a program whose processes wait for each other"
        order = sorted(self.intervals, key=lambda i: (i.process, i.start, i.end))
        states = states_at_once(self.program, self.costs["process.register"])
        end = max(self.clock)
        return Timeline(tuple(order), tuple(self.exchanges), end, "predicted", states)

    def _advance(self, p: int, place: int) -> bool:
        """Run an operation of a process; return whether that is possible now."""
        start, self.at[p] = self.clock[p], place
        operation = self.program.processes[p].operations[place]
        stage = self.stages[p][operation.stage]
        match operation.steps:
            case (Send() as step,):
                self._note(p, stage, start, start + self._channel(step).send + self._copied(step))
                self.sent[step.message] = self.clock[p]
            case (Receive() as step,):
                if step.message not in self.sent:
                    return False
                self._receive(p, stage, step)
            case _:
                time = self.time(p, place, operation) / self.costs.speed(p)
                self._note(p, stage, start, start + time)
        return True

    def _channel(self, step: Send | Receive) -> ChannelCosts:
        """Return the costs of a message between two processes."""
        message = self.plan.messages[step.message]
        far = None if self.links is None else self.links(message.source, message.target)
        return self.near if far is None else far

    def _copied(self, step: Send | Receive) -> float:
        """Time to write a message's numbers, or to read them."""
        plan = self.plan
        numbers = plan.messages[step.message].numbers(plan.right_hand_sides, plan.joints)
        return numbers * self._channel(step).number / 2

    def _receive(self, p: int, stage: Stage, step: Receive) -> None:
        start, sent = self.clock[p], self.sent[step.message]
        begin = max(start, sent + self._channel(step).latency)
        if begin > start:
            self.intervals.append(Interval(p, "wait", None, step.message, start, begin))
        self._note(p, stage, begin, begin + self._copied(step))
        source = self.plan.messages[step.message].source
        self.exchanges.append(Exchange(source, p, sent, self.clock[p]))

    def _note(self, p: int, stage: Stage, start: float, end: float) -> None:
        found = Interval(p, stage.what, stage.joint, stage.message, start, end, self.at[p])
        self.intervals.append(found)
        self.clock[p] = end


Times = Callable[[int, int, Operation], float]
"""Time of an operation, microseconds on a core of speed 1, by its process and place there."""


def _times(program: Program, costs: StepCosts) -> Times:
    """Return a function that gives the time of each operation."""
    if program.batch:
        times = of_registers(program, costs, _listed(program, _of_one_state(program, costs)))
        return lambda p, place, _: times[p][place]
    return _of_one_state(program, costs)


def _listed(program: Program, time: Times) -> list[list[float]]:
    return [
        [time(p, place, operation) for place, operation in enumerate(process.operations)]
        for p, process in enumerate(program.processes)
    ]


def _of_one_state(program: Program, costs: StepCosts) -> Times:
    if program.shape == "unrolled":
        straight = straight_times(program, costs)
        return lambda p, place, _: straight[p][place]
    plan = program.plan
    loops, joins = program.shape == LOOPS, joins_of(plan)
    sides = len(plan.slaved)  # right-hand sides of every step beside the motion
    share = 1 + sides * costs["slaved.column"]

    def time(_p: int, _place: int, operation: Operation) -> float:
        once = costs.total(operation_features(operation, plan.joints, joins))
        if not loops:
            return once * share
        return once * (1 if operation.does in PREPARED else 1 + sides)

    return time
