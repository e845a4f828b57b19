"""Predicted times for the search: the only module here that prices steps.

A schedule is priced by its plan as a whole (``played``), the share of one process by itself
(``Pricing.share``): what the processes of a layout take is composed of such shares.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from adagen.cost import operation_features
from adagen.cost.lane_choice import cheapest_loops
from adagen.emit.shapes import SHAPES, predict
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.messages import Message
from adagen.plan.passive import tangents
from adagen.plan.robot import PlanJoint
from adagen.plan.simd_groups import Limbs
from adagen.plan.stages import stages
from adagen.plan.steps import Kinematics, Receive, Send
from adagen.plan.types import Process
from adagen.program import Operation
from adagen.program.loops import Loops
from adagen.program.names import PASSING
from adagen.program.slots import Slots
from adagen.program.strips import runs_in_strips
from adagen.schedule import CostProfile, Schedule
from adagen.schedule.costs import ChannelCosts, StepCosts


def played(model: Model, schedule: Schedule, profile: CostProfile, scalar: str = "double") -> float:
    """Return the predicted time of a schedule as loops; microseconds.

    Args:
        model: the robot.
        schedule: of its joints.
        profile: a profile with the costs of steps.
        scalar: "double" or "float".
    """
    return predict(make_plan(model, schedule, scalar=scalar), profile, "kernels").makespan


@dataclass(frozen=True)
class Share:
    """Predicted time of one process on a core of speed 1, without messages; microseconds.

    Attributes:
        kinematics: of all joints that it passes, long runs in strips unless another process
            parts them.
        least_kinematics: the same however others part its runs, at least.
        inwards: up to the messages that it sends, with the tangents of its joints' friction.
        between: from then on up to those that it takes.
        outwards: all after them.
        process: its steps; messages stand for all that there are.
        limbs: those that it passes side by side.
    """

    kinematics: float
    least_kinematics: float
    inwards: float
    between: float
    outwards: float
    process: Process
    limbs: tuple[Limbs, ...]


class Pricing:
    """Predicted times of single processes.

    Args:
        plan: any plan of the robot, for its joints.
        profile: a profile with the costs of steps.
    """

    def __init__(self, plan: Plan, profile: CostProfile) -> None:
        self.costs: StepCosts = profile.measured
        self.channel: ChannelCosts = self.costs.channel(plan.channel)
        self._plan = plan

    @property
    def joints(self) -> tuple[PlanJoint, ...]:
        """The robot's joints."""
        return self._plan.joints

    def share(self, process: Process, messages: tuple[Message, ...]) -> Share | None:
        """Return the predicted time of a process; None where no shape has such steps.

        Args:
            process: its steps, with one message for all that it sends and takes at a time.
            messages: those messages, by number.
        """
        plan = replace(self._plan, processes=(process,), messages=messages)
        if SHAPES["kernels"].why_not(plan) is not None:
            return None
        loops = cheapest_loops(plan, self.costs)
        phases = [0.0, 0.0, 0.0, 0.0]  # kinematics, then as messages part the rest, or else sweeps
        phase = 1
        found, parts = loops.operations, stages(process)
        for operation in found:
            match operation.steps:
                case (Send(),):
                    phase = 2
                case (Receive(),):
                    phase = 3
                case _:
                    what = parts[operation.stage].what
                    phase = 3 if what == "disassembly" else phase
                    phases[0 if what == "kinematics" else phase] += self._time(operation)
        moving, inwards, between, outwards = phases
        inwards += self.costs["process.tangent"] * tangents(plan, process)
        least = self._least_kinematics(found) if loops.slots.in_strips else moving
        return Share(moving, least, inwards, between, outwards, process, loops.slots.limbs[0])

    def _operations(
        self, plan: Plan, process: Process, slots: Slots, limbs: tuple[Limbs, ...]
    ) -> tuple[Operation, ...]:
        return Loops(plan, process, slots, limbs, batch=False, costs=self.costs).operations()

    def sweeps(self, process: Process) -> tuple[float, float]:
        """Return the times of the first and second sweep of a process without messages.

        Long runs are assumed to be passed outwards as is best; nothing is known of a process that
        shape kernels does not take.
        """
        share = self.share(process, ())
        if share is None:
            return 0.0, 0.0
        return share.least_kinematics + share.inwards, share.outwards

    def _time(self, operation: Operation) -> float:
        return self.costs.total(operation_features(operation, self.joints))

    def _least_kinematics(self, operations: Sequence[Operation]) -> float:
        """Least time of kinematics: each joint alone, in a strip, or in its limbs."""
        total = 0.0
        for operation in operations:
            moves = [step for step in operation.steps if isinstance(step, Kinematics)]
            if operation.method == "lanes" and moves:
                total += self._time(operation)
                continue
            for step in moves:
                kind = self.joints[step.joint].kind
                passing = ("passing_strips",) if operation.does == PASSING else ()
                groups = ("kinematics", "kinematics_strips", *passing)
                total += min(self.costs[f"{group}.{kind}"] for group in groups)
        return total

    def kinematics(self, shares: Sequence[Share]) -> list[float]:
        """Return the times of processes' kinematics that divide each other's long runs."""
        processes = tuple(
            replace(s.process, steps=tuple(t for t in s.process.steps if isinstance(t, Kinematics)))
            for s in shares
        )
        limbs = tuple(share.limbs for share in shares)
        plan = replace(self._plan, processes=processes)
        in_strips = tuple(runs_in_strips(plan, limbs, self.costs))
        slots = replace(Slots.plainly(plan), limbs=limbs, in_strips=in_strips)
        return [
            sum(map(self._time, self._operations(plan, process, slots, own)))
            for process, own in zip(processes, limbs, strict=True)
        ]

    def numbers(self, message: Message) -> int:
        """Return the count of numbers in a message."""
        return message.numbers(self._plan.right_hand_sides, self._plan.joints)
