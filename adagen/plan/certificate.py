"""Plans that can be certified, and the allowance for rounding.

If several processes share a robot, each computes the residuals of its own limbs. Process 0 adds the
core links and finishes the certificate (adagen/executor/shared_bound.py).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from adagen.errors import UsageError
from adagen.plan.closure_steps import nothing_moves
from adagen.plan.messages import CERTIFICATE, Message
from adagen.plan.steps import (
    Accelerate,
    Articulate,
    CarryRows,
    Certify,
    Correct,
    Deliver,
    FreeAcceleration,
    FreeBase,
    FusedJoin,
    HoldMobility,
    InvertRoot,
    Join,
    Kinematics,
    Load,
    LoadRoot,
    Propagate,
    Receive,
    Send,
    Share,
    SolveMobility,
    SolveRoot,
    StartEmpty,
    StartLink,
    Step,
)
from adagen.plan.types import Plan, Process

ROUNDING = 8.0
"""How many units in the last place of what is added up count as uncertain."""
IN_LOOPS = ("revolute", "prismatic")
"""Kinds of joints whose residuals a loop of a straight line can sweep."""


def certified(plan: Plan) -> Plan:
    """Return a plan whose processes bound the error of each answer after it.

    Closures that may carry their rows or not do not.

    Raises:
        UsageError: the plan cannot be certified; the message says why.
    """
    plan = plan.held_back()
    reason = why_not(plan) or why_not_shared(plan)
    if reason is not None:
        raise UsageError(f"answers cannot be certified: {reason}; leave out --certify")
    if plan.several:
        return _shared(plan)

    def weighed(steps: tuple[Step, ...]) -> tuple[Step, ...]:
        """Steps with their certificate: closed loops compute it by a correction not added."""
        correction = (Correct(0, 0, len(steps)),) if plan.closed else ()
        return (*steps, *correction, Certify()) if steps else ()

    return replace(plan, processes=tuple(each.changed(weighed) for each in plan.processes))


def looped(plan: Plan, rows: int) -> Plan | None:
    """Return a certified plan whose straight line has a loop sweep residuals of its outermost rows.

    None where it cannot: a loop sweeps hinges and slides of one process, of closed loops those
    beyond their tops. Statements sweep joints of other kinds, and what these hang on.

    Args:
        plan: the plan.
        rows: how many; where there are fewer, all.
    """
    if not plan.certified or plan.several or plan.reproducible:
        return None
    if has_inner_root(plan) or any(plan.steps_of(Join)):
        return None
    if not any(joint.kind in IN_LOOPS for joint in plan.joints):
        return None
    return plan.with_looped(rows)


def why_not(plan: Plan) -> str | None:
    """Return why a plan's residuals cannot be swept, None where they can."""
    if plan.form != "segment":
        return f"that is for form segment, not {plan.form}"
    if plan.slaved:
        return f'joint "{plan.joints[plan.slaved[0]].name}" is slaved to another'
    for joint in plan.joints:
        if joint.prescribed:
            return f'the motion of joint "{joint.name}" is prescribed'
    if nothing_moves(plan):
        return "its loops let no joint move: all accelerations are zero, and have no relative error"
    if plan.closed and (plan.wanted or plan.outputs):
        return "a scene wants other outputs than all accelerations of closed loops"
    steps = [step for each in plan.alternatives for step in each.steps]
    if any(isinstance(step, FusedJoin) for step in steps):
        return "joints are joined as one over links without mass"
    if not plan.several and any(isinstance(step, Join) for step in steps):
        return _why_not_parted(plan)
    if any(isinstance(step, CarryRows) for step in steps):
        return (
            "a closure of many joints carries its loops through them, and what rounding does to "
            "that is not bounded (--refine 1 estimates errors)"
        )
    return None


def _why_not_parted(plan: Plan) -> str | None:
    """Why a chain in parts of one process cannot be certified (executor/floating_parts.py)."""
    if plan.wanted or plan.outputs:
        return "a scene wants other outputs than all accelerations of a chain in parts"
    roots = {step.link for step in plan.steps_of(InvertRoot)}
    joined = {step.joint for step in plan.steps_of(Join)}
    serial = all(joint.parent == j for j, joint in enumerate(plan.joints))
    if not serial or roots != {j + 1 for j in joined} or min(joined) > 0:
        return "its process joins more than the parts of a chain"
    return None


# -- several processes -----------------------------------------------------------------------------

_GATHERED = (
    *(Kinematics, StartLink, StartEmpty, FreeBase, Articulate, SolveRoot),
    *(Accelerate, FreeAcceleration, Send, Receive),
    *(Propagate, HoldMobility, SolveMobility, Load, LoadRoot, Deliver),
)
"""Steps of processes that gather, and take the ground for a body where it is beyond the root."""


def why_not_shared(plan: Plan) -> str | None:
    """Return why several processes cannot certify their answer, None if they can."""
    if not plan.several:
        return None
    if plan.closed or not all(isinstance(step, _GATHERED) for step in plan.steps):
        return (
            "several processes share the robot otherwise than by limbs of a link where they "
            "gather: no process has the factors of all that is beyond a joint"
        )
    if plan.reproducible:
        return "reproducible processes share the robot, and copy one line of statements"
    if plan.wanted or plan.outputs:
        return "processes share a robot of which a scene wants other outputs than accelerations"
    if plan.sets_inertias:
        return "processes share a robot whose masses can be set"
    first = {step.link for step in plan.processes[0].steps if isinstance(step, StartLink)}
    met = {link for message in plan.messages for link in message.inertias}
    if not plan.processes[0].steps or not met <= first:
        return "process 0 does not add up the links that processes share"
    return _why_not_held(plan)


def has_inner_root(plan: Plan) -> bool:
    """Return whether processes gather at a root that is neither the base nor the ground."""
    turned = any(getattr(step, "reversed", False) for step in plan.steps)
    return turned or any(plan.steps_of(HoldMobility, SolveMobility))


def _why_not_held(plan: Plan) -> str | None:
    """Why a robot whose ground is beyond the root cannot be certified."""
    if not has_inner_root(plan):
        return None
    if any(any(process.steps_of(Propagate, FreeBase)) for process in plan.processes[1:]):
        return "another process than the first one is on the way to the ground"
    alone = sum(joint.parent == 0 for joint in plan.joints) == 1
    if any(plan.steps_of(Propagate)) and not alone:
        return "links that are held by the ground have others beside them"
    return None


def _shared(plan: Plan) -> Plan:
    """The plan with a certificate in parts of several processes."""
    messages = list(plan.messages)
    steps = _with_shares(plan, [process.steps for process in plan.processes], messages)
    recovery = [process.recovery for process in plan.processes]
    if any(recovery):
        recovery = _with_shares(plan, recovery, messages)
    processes = [
        replace(process, steps=own, recovery=again)
        for process, own, again in zip(plan.processes, steps, recovery, strict=True)
    ]
    return replace(plan, processes=tuple(processes), messages=tuple(messages))


def _with_shares(
    plan: Plan, steps: Sequence[tuple[Step, ...]], messages: list[Message]
) -> list[tuple[Step, ...]]:
    """Steps of each process with its part of the certificate; adds the messages."""
    met = {j for process in plan.processes for j in process.shares}
    found, shares, hears = list(steps), list[Share](), list[Step]()
    for p, process in enumerate(plan.processes):
        if p == 0 or not steps[p]:
            continue
        told = {link for m in plan.messages if m.source == p for link in m.inertias}
        share = Share(p, tuple(sorted(told)))
        own = tuple(j for j in process.owns if j not in met)
        hears.append(Receive(len(messages)))
        found[p] = (*steps[p], Certify(own, tells=share), Send(len(messages)))
        messages.append(Message(p, 0, CERTIFICATE, 0, weighed=share.links))
        shares.append(share)
    certify = Certify(tuple(plan.processes[0].treated), hears=tuple(shares))
    begins = _let_go_on(found, shares, messages)
    found[0] = (*begins, *steps[0], *hears, certify)
    return found


def _let_go_on(
    steps: list[tuple[Step, ...]], shares: Iterable[Share], messages: list[Message]
) -> list[Step]:
    """Have process 0 say that an evaluation begins to processes that hear nothing from others.

    Their shares would otherwise overwrite those of earlier evaluations that process 0 still reads
    (adagen/program/message_reuse.py). The message is empty; they take it when their share is ready.

    Args:
        steps: of each process; those of such processes are changed.
        shares: that process 0 hears.
        messages: of the plan; more are added.

    Returns:
        The first steps of process 0.
    """
    begins: list[Step] = []
    for p in (share.process for share in shares):
        if any(isinstance(step, Receive) for step in steps[p]):
            continue
        *work, send = steps[p]
        begins.append(Send(len(messages)))
        steps[p] = (*work, Receive(len(messages)), send)
        messages.append(Message(0, p, "disassembly", 0))
    return begins


def own_links(process: Process) -> Iterator[int]:
    """Yield the links whose own inertia a process adds."""
    return (step.link for step in process.steps_of(StartLink))
