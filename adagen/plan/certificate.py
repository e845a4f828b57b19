"""Which plans can be certified, and how much rounding a certificate allows for."""

from __future__ import annotations

from dataclasses import replace

from adagen.errors import UsageError
from adagen.plan.steps import CarryRows, Certify, Correct, FusedJoin, Step
from adagen.plan.types import Plan

ROUNDING = 8.0
"""How many units in the last place of what is added up count as uncertain."""


def certified(plan: Plan) -> Plan:
    """Return a plan whose process bounds the error of each answer after it.

    Raises:
        UsageError: the plan cannot be certified; the message says why.
    """
    reason = why_not(plan)
    if reason is not None:
        raise UsageError(f"answers cannot be certified: {reason}; leave out --certify")
    processes = tuple(
        replace(
            process,
            steps=_weighed(plan, process.steps),
            recovery=_weighed(plan, process.recovery),
            others=tuple(_weighed(plan, steps) for steps in process.others),
        )
        for process in plan.processes
    )
    return replace(plan, processes=processes)


def _weighed(plan: Plan, steps: tuple[Step, ...]) -> tuple[Step, ...]:
    """Steps and their certificate: loops have one by a correction, which is not added."""
    if not steps:
        return ()
    correction = (Correct(0, 0, len(steps)),) if plan.closed else ()
    return (*steps, *correction, Certify())


def why_not(plan: Plan) -> str | None:
    """Return why a plan cannot be certified, None where it can."""
    if plan.form != "segment":
        return f"that is for form segment, not {plan.form}"
    if sum(bool(process.steps) for process in plan.processes) > 1:
        return "several processes share the robot"
    if plan.slaved:
        return f'joint "{plan.joints[plan.slaved[0]].name}" is slaved to another'
    for joint in plan.joints:
        if joint.prescribed:
            return f'the motion of joint "{joint.name}" is prescribed'
    if plan.closed and (plan.wanted or plan.outputs):
        return "a scene wants other outputs than all accelerations of closed loops"
    steps = [s for each in plan.alternatives for process in each.processes for s in process.steps]
    if any(isinstance(step, FusedJoin) for step in steps):
        return "joints are joined as one over links without mass"
    if any(isinstance(step, CarryRows) for step in steps):
        return (
            "a closure of many joints carries its loops through them, and what rounding does to "
            "that is not bounded (--refine 1 estimates errors)"
        )
    return None
