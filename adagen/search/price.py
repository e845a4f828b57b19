"""The price that is played, as the search sees it: nothing else here knows how steps are priced.

A schedule is priced by its plan as a whole (``played``), the share of one process by itself
(``Pricing.share``): what the processes of a layout take is composed of such shares.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from adagen.emit.segments import segments_of
from adagen.emit.shapes import SHAPES
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.stages import stages
from adagen.plan.steps import Kinematics
from adagen.plan.types import Message, PlanJoint, Process
from adagen.predict.features import Together, passed_together, work_time
from adagen.predict.simulate import message_numbers, predict
from adagen.schedule import CostProfile, Schedule
from adagen.schedule.costs import ChannelCosts, StepCosts


def played(model: Model, schedule: Schedule, profile: CostProfile) -> float:
    """Return what a schedule takes by its plan, played through; microseconds.

    Args:
        model: the robot.
        schedule: of its joints.
        profile: a profile with the costs of steps.
    """
    return predict(make_plan(model, schedule), profile).makespan


def is_emitted(model: Model, schedule: Schedule) -> bool:
    """Return whether the shape that gathers takes the plan of a schedule."""
    return SHAPES["kernels"].why_not(make_plan(model, schedule)) is None


@dataclass(frozen=True)
class Share:
    """What one process takes on a core of speed 1, without messages; microseconds.

    Attributes:
        kinematics: of all joints that it passes, long runs in segments unless another process
            parts them.
        least_kinematics: the same however others part its runs, at least.
        inwards: up to the messages that it sends.
        between: from then on up to those that it takes.
        outwards: all after them.
        process: its steps; messages stand for all that there are.
        together: what it passes its joints with.
    """

    kinematics: float
    least_kinematics: float
    inwards: float
    between: float
    outwards: float
    process: Process
    together: Together


class Pricing:
    """Prices of what single processes do.

    Args:
        plan: any plan of the robot, for its joints.
        profile: a profile with the costs of steps.
    """

    def __init__(self, plan: Plan, profile: CostProfile) -> None:
        assert profile.steps is not None  # as the caller has made sure
        self.costs: StepCosts = profile.steps
        self.channel: ChannelCosts = self.costs.channel(plan.channel)
        self._plan = plan

    @property
    def joints(self) -> tuple[PlanJoint, ...]:
        """The robot's joints."""
        return self._plan.joints

    def share(self, process: Process, messages: tuple[Message, ...]) -> Share | None:
        """Return what a process takes; None where no shape gathers with such steps.

        Args:
            process: its steps, with one message for all that it sends and takes at a time.
            messages: those messages, by number.
        """
        plan = replace(self._plan, processes=(process,), messages=messages)
        if SHAPES["kernels"].why_not(plan) is not None:
            return None
        (together,) = passed_together(plan, "kernels")
        phases = [0.0, 0.0, 0.0, 0.0]  # kinematics, then as messages part the rest, or else sweeps
        phase = 1
        for stage in stages(process):
            if stage.message is not None:
                phase = 2 if stage.what == "send" else 3
                continue
            steps = process.steps[stage.first : stage.last]
            time = work_time(steps, plan.joints, self.costs, 0, together)
            if stage.what == "disassembly":
                phase = 3
            phases[0 if stage.what == "kinematics" else phase] += time
        kinematics, inwards, between, outwards = phases
        least = self._least_kinematics(process, together) if together.outward else kinematics
        return Share(kinematics, least, inwards, between, outwards, process, together)

    def sweeps(self, process: Process, *, singly: bool) -> tuple[float, float]:
        """Return what a process that exchanges nothing takes in its first and second sweep.

        Long runs are taken to be passed outwards as is best; nothing is known of a process that
        shape kernels does not take.

        Args:
            process: its steps.
            singly: whether it may be that nothing is passed together, as in shape joints.
        """
        share = self.share(process, ())
        if share is None:
            return 0.0, 0.0
        inwards, outwards = share.least_kinematics + share.inwards, share.outwards
        if singly:
            later = [stage.first for stage in stages(process) if stage.what == "disassembly"]
            first = process.steps[: min(later, default=len(process.steps))]
            rest = process.steps[len(first) :]
            inwards = min(inwards, work_time(first, self.joints, self.costs))
            outwards = min(outwards, work_time(rest, self.joints, self.costs))
        return inwards, outwards

    def _least_kinematics(self, process: Process, together: Together) -> float:
        """What kinematics take at least, each joint by itself or in a segment, or in its limbs."""
        steps = [step for step in process.steps if isinstance(step, Kinematics)]
        beside = [step for step in steps if step.joint in together.limbs]
        total = work_time(beside, self.joints, self.costs, 0, together)
        for step in steps:
            if step.joint not in together.limbs:
                kind = self.joints[step.joint].kind
                total += min(
                    self.costs[f"kinematics.{kind}"], self.costs[f"kinematics_segments.{kind}"]
                )
        return total

    def kinematics(self, shares: Sequence[Share]) -> list[float]:
        """Return what the kinematics of processes take that part each other's long runs."""
        processes = tuple(
            replace(s.process, steps=tuple(t for t in s.process.steps if isinstance(t, Kinematics)))
            for s in shares
        )
        limbs = [list(dict.fromkeys(share.together.limbs.values())) for share in shares]
        found = segments_of(replace(self._plan, processes=processes), limbs)
        outward = {j: run for run in found for j in range(run.first, run.last + 1)}
        return [
            work_time(
                process.steps,
                self.joints,
                self.costs,
                0,
                replace(share.together, outward=outward),
            )
            for process, share in zip(processes, shares, strict=True)
        ]

    def numbers(self, message: Message) -> int:
        """Return how many numbers a message holds."""
        return message_numbers(self._plan, message)
