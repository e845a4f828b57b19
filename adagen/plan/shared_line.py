"""The plan for one process whose straight line all processes of a reproducible plan share.

Answers are the same to the last bit for every number of processes if each number is computed by the
same operations on whichever process. So there is one straight line, that of one process, and
several processes divide it (adagen/executor/reproducible.py). This is possible where they gather at
a core around the base or the ground, because every limb is then swept as on one process.
"""

from __future__ import annotations

from dataclasses import replace

from adagen.errors import UsageError
from adagen.plan import steps as do
from adagen.plan.gather_steps import ProcessSteps
from adagen.plan.gather_trees import Tree, given_trees, moving_trees
from adagen.plan.types import Plan, Process
from adagen.schedule.tree import Gathered


def serial_plan(plan: Plan) -> Plan:
    """Return a reproducible plan for one process.

    Where processes of the robot can gather, its steps follow from the joints alone, so that they
    are the same whatever the plan's processes are.
    """
    if not (plan.slaved or plan.outputs or plan.closed):  # those are computed by one process
        of_one = ProcessSteps(plan.joints, _of_one(plan), 0)
        evaluation = sorted(of_one.evaluation([], []), key=lambda step: _SWEEPS.index(type(step)))
        process = of_one.process_of(evaluation)
        if plan.certified:
            process = replace(process, steps=(*process.steps, do.Certify()))
    elif plan.closed:
        every = tuple(range(len(plan.joints)))
        steps = next(process.steps for process in plan.processes if process.steps)
        process = Process(plan.line or steps, every, every)  # of others, each does everything
    else:
        (process,) = (process for process in plan.processes if process.steps)
    return replace(
        plan,
        processes=(process,),
        messages=(),
        schedule="",
        channel="auto",
        profile="default",
        line=(),
    )


_SWEEPS = (
    do.StartLink,
    do.FreeBase,
    do.Articulate,
    do.SolveRoot,
    do.Accelerate,
    do.FreeAcceleration,
)
"""The steps of one process in their order, so that limbs of several trees are swept together."""


def _of_one(plan: Plan) -> list[Tree]:
    roots = [tree.own_root for tree in moving_trees(plan.joints)]
    bases = {root - 1 for root in roots}
    owners = [None if j in bases else 0 for j in range(len(plan.joints))]
    return given_trees(plan.joints, roots, owners)


def check_reproducible(plan: Plan, gathered: Gathered | None) -> None:
    """Refuse a plan whose answers depend on its number of processes.

    Args:
        plan: the plan.
        gathered: where its processes gather; None where they do not.

    Raises:
        UsageError: it does; the message says why.
    """
    if plan.form != "segment":
        raise UsageError("only form segment is reproducible")
    if not plan.several:
        return
    if gathered is None:
        raise UsageError(
            "processes that are joined at a cut round differently from one process: reproducible "
            "ones gather at the base or the ground; leave out --schedule or --reproducible"
        )
    for tree, root in zip(moving_trees(plan.joints), gathered.roots, strict=True):
        owners = {gathered.owners[j] for j in tree.joints}
        if root != tree.own_root and len(owners) > 1:
            where = "the base" if tree.own_root else "the ground"
            raise UsageError(
                f"processes that gather at link {plan.links[root].name!r} round differently from "
                f"one process: reproducible ones gather at {where}; leave out --schedule or "
                "--reproducible"
            )
    if any(message.sides for message in plan.messages):
        raise UsageError(
            "processes that share a loop add up its rows otherwise than one process: leave out "
            "--schedule or --reproducible"
        )
    if plan.recovers and not _all_exchange(plan):
        raise UsageError(
            "processes that do not hear of each other's poor poses would go different ways: leave "
            "out --schedule or --reproducible"
        )


def _all_exchange(plan: Plan) -> bool:
    """Whether each process tells all others what its limbs do to the links that they share."""
    told = {(m.source, m.target) for m in plan.messages if m.inertias}
    own = [p for p, process in enumerate(plan.processes) if process.steps]
    return told.issuperset((p, q) for p in own for q in own if p != q)
