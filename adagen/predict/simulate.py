"""The steps of a plan, played through in time: who works, who waits, what is under way when."""

from __future__ import annotations

from dataclasses import dataclass, field

from adagen.plan import Plan
from adagen.plan.stages import Stage, stages
from adagen.plan.types import Message
from adagen.predict.features import passed_together, work_time
from adagen.predict.straight import goes_straight, straight_timeline
from adagen.schedule.costs import ChannelCosts, StepCosts
from adagen.schedule.profile import CostProfile
from adagen.schedule.timeline import Exchange, Interval, MachineTimeline


def message_numbers(plan: Plan, message: Message) -> int:
    """Return how many numbers a message holds."""
    columns = plan.right_hand_sides
    if message.sweep == "torques":
        return columns - 1
    vectors = len(message.biases) + len(message.forces) + len(message.inertias)
    matrices = 36 * len(message.blocks) + 21 * len(message.inertias)
    return matrices + 6 * columns * vectors + columns * len(message.joints)


def predict(plan: Plan, profile: CostProfile, shape: str = "auto") -> MachineTimeline:
    """Return how one evaluation is predicted to go.

    Each process is taken to have a core of its own, and all to begin at the same instant. One
    process that goes through a straight line of statements is priced by its operations, all others
    step by step, as the fastest shape that does them so.

    Args:
        plan: what each process does, in either form.
        profile: a profile with the costs of steps.
        shape: of the code, as ``adagen.emit.emit`` takes it.

    Raises:
        ValueError: the profile prices joins alone, as the paper's does.
    """
    if profile.steps is None:
        raise ValueError(f"the profile {profile.name} has no costs of steps")
    if goes_straight(plan, shape):
        return straight_timeline(plan, profile.steps)
    return _Run(plan, profile.steps, shape).play()


@dataclass
class _Run:
    plan: Plan
    costs: StepCosts
    shape: str
    sent: dict[int, float] = field(default_factory=dict)  # message -> when its sender was done

    def __post_init__(self) -> None:
        self.channel: ChannelCosts = self.costs.channel(self.plan.channel)
        count = len(self.plan.processes)
        self.stages = [stages(process) for process in self.plan.processes]
        self.together = passed_together(self.plan, self.shape)
        self.at = [0] * count  # next stage of each process
        first = self.costs["process.evaluation"]
        busy = [bool(process.steps) for process in self.plan.processes]
        self.clock = [first / self.costs.speed(p) if busy[p] else 0.0 for p in range(count)]
        self.intervals: list[Interval] = []
        self.exchanges: list[Exchange] = []

    def play(self) -> MachineTimeline:
        """Let every process go on as far as it can, until all are done."""
        left = True
        while left:
            moved = left = False
            for p, row in enumerate(self.stages):
                while self.at[p] < len(row) and self._advance(p, row[self.at[p]]):
                    self.at[p] += 1
                    moved = True
                left = left or self.at[p] < len(row)
            assert moved or not left, "a plan whose processes wait for each other"
        order = sorted(self.intervals, key=lambda i: (i.process, i.start, i.end))
        return MachineTimeline(tuple(order), tuple(self.exchanges), max(self.clock), "predicted")

    def _advance(self, p: int, stage: Stage) -> bool:
        """Do a stage of a process; return whether that is possible yet."""
        start = self.clock[p]
        if stage.message is None:
            joints, slaved = self.plan.joints, len(self.plan.slaved)
            steps = self.plan.processes[p].steps[stage.first : stage.last]
            time = work_time(steps, joints, self.costs, slaved, self.together[p])
            self._note(p, stage, start, start + time / self.costs.speed(p))
            return True
        message = self.plan.messages[stage.message]
        numbers = message_numbers(self.plan, message) * self.channel.number / 2
        if stage.what == "send":
            self._note(p, stage, start, start + self.channel.send + numbers)
            self.sent[stage.message] = self.clock[p]
            return True
        if stage.message not in self.sent:
            return False
        sent = self.sent[stage.message]
        begin = max(start, sent + self.channel.latency)
        if begin > start:
            self.intervals.append(Interval(p, "wait", None, stage.message, start, begin))
        self._note(p, stage, begin, begin + numbers)
        self.exchanges.append(Exchange(message.source, p, sent, self.clock[p]))
        return True

    def _note(self, p: int, stage: Stage, start: float, end: float) -> None:
        self.intervals.append(Interval(p, stage.what, stage.joint, stage.message, start, end))
        self.clock[p] = end
