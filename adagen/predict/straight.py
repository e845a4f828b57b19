"""What a straight line of statements takes: shape `unrolled` on one process.

Its statements are an expression graph, so that what a robot's structure saves is known exactly.
Its time is told by the operations, by the sines and cosines, and by the longest chain of
operations that wait for each other.
"""

from __future__ import annotations

from itertools import pairwise

from adagen.emit.shapes import SHAPES, chosen_shape, stepwise
from adagen.executor import straight_line
from adagen.graph import live_nodes
from adagen.plan import Plan
from adagen.plan.stages import stages
from adagen.predict.features import Features
from adagen.schedule.costs import StepCosts
from adagen.schedule.timeline import Interval, MachineTimeline

_COMPUTED = ("add", "sub", "mul", "reciprocal")


def goes_straight(plan: Plan, shape: str = "auto") -> bool:
    """Return whether a plan on one process is emitted as a straight line.

    Args:
        plan: the plan.
        shape: what was asked for, as ``adagen.emit.emit`` takes it.
    """
    if len(plan.processes) > 1 or SHAPES["unrolled"].why_not(plan) is not None:
        return False
    return (chosen_shape(plan) if shape == "auto" else shape) == "unrolled"


def is_priced(plan: Plan, shape: str) -> bool:
    """Return whether cost profiles price a plan in a shape, and not only in a faster one.

    Args:
        plan: the plan.
        shape: one of ``adagen.emit.shapes.KNOWN``.
    """
    return goes_straight(plan, shape) or shape == stepwise(plan)


def straight_features(plan: Plan) -> Features:
    """Return what the straight line of a plan on one process is made of."""
    (process,) = straight_line(plan)
    found = process.operations
    return {
        "unrolled.evaluation": 1,
        # A product is added in one go; what is done in lanes is done once.
        "unrolled.operation": found.arithmetic - found.fused + found.moves,
        "unrolled.sine": len(process.machine.angles),
        "unrolled.cycle": found.ready,
    }


def straight_timeline(plan: Plan, costs: StepCosts) -> MachineTimeline:
    """Return how the straight line of a plan on one process is predicted to go.

    Its stages share the time by their operations; no message interrupts them.
    """
    total = costs.total(straight_features(plan)) / costs.speed(0)
    start = costs["unrolled.evaluation"] / costs.speed(0)
    ends = _done_after_stages(plan)
    times = [start + (total - start) * end / max(1, ends[-1]) for end in (0, *ends)]
    intervals = [
        Interval(0, stage.what, stage.joint, None, *between)
        for stage, between in zip(stages(plan.processes[0]), pairwise(times), strict=True)
    ]
    return MachineTimeline(tuple(intervals), (), total, "predicted", straight=True)


def _done_after_stages(plan: Plan) -> list[int]:
    """Return how many operations are done after each stage of a process."""
    (process,) = straight_line(plan)
    nodes = process.machine.graph.nodes
    marks = [
        nodes[index].mark
        for index in live_nodes(process.machine.graph, process.machine.roots())
        if nodes[index].op in _COMPUTED
    ]
    return [sum(mark < stage.last for mark in marks) for stage in stages(plan.processes[0])]
