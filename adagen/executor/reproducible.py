"""The straight line of one process, divided among the processes of a reproducible plan.

Each number is then computed by the same operations on any process, in lanes or not. The straight
line is that of one process, with its limbs in the best lanes. Each process copies what its own
accelerations need into a graph of its own. The contributions of other processes' limbs to the core
come by message. Lanes with limbs of other processes are left out; if a process has none side by
side, each lane is copied by itself.

Copies are the same to the last bit except for the signs of zeros: nothing is reordered, and
constants are folded operation by operation (RoundedGraph).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache

from adagen.executor.lanes import Grouping
from adagen.executor.line import Line, Pair, line_of
from adagen.executor.line_copies import WaitingLanesError, copied
from adagen.executor.needed_values import NeededValues, Sender
from adagen.executor.run import Simulated
from adagen.plan.edges import is_free_base
from adagen.plan.shared_line import serial_plan
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Eliminate, Send
from adagen.plan.types import Plan


def own_limbs(plan: Plan) -> Grouping:
    """Return the limbs that each process of a reproducible plan may compute side by side.

    They are those of the line of one process, as far as they are the process's own; none where
    joints that all processes compute are among them, or where one lane is to be sent before a
    message that another waits for.
    """
    core = _core(plan)
    limbs = line_of(serial_plan(plan)).machine.limbs
    if any(not core.isdisjoint(each.members()) for each in limbs):
        return tuple(() for _ in plan.processes)
    own = tuple(tuple(_own(limbs, frozenset(p.owns))) for p in plan.processes)
    try:
        shared_line(plan, own)
    except WaitingLanesError:
        return tuple(() for _ in plan.processes)
    return own


def _own(all_limbs: Iterable[Limbs], owns: frozenset[int]) -> Iterator[Limbs]:
    for limbs in all_limbs:
        rows = tuple(tuple(j for j in row if j in owns) for row in limbs.rows)
        if len(rows[0]) > 1:
            yield Limbs(rows)


def _core(plan: Plan) -> set[int]:
    """Joints that every process computes for itself."""
    return {j for process in plan.processes for j in process.shares}


@lru_cache(maxsize=12)  # a plan is judged, priced and emitted one after the other, in lanes or not
def shared_line(plan: Plan, grouping: Grouping | None = None) -> tuple[Simulated, ...]:
    """Return the processes of a reproducible plan, each after all its steps.

    Args:
        plan: the plan.
        grouping: for each process the limbs that share code, as ``own_limbs`` has them, or none;
            None for none at all.
    """
    line = line_of(serial_plan(plan))
    senders = _senders(plan, line)
    wants = [NeededValues(plan, line, p, senders) for p in range(len(plan.processes))]
    for want in wants:
        for pair, sender in want.missing.items():
            wants[sender.process].sends.setdefault(want.process, {})[pair] = sender
    limbs = grouping or tuple(() for _ in plan.processes)
    return tuple(copied(want, own) for want, own in zip(wants, limbs, strict=True))


def _senders(plan: Plan, line: Line) -> dict[Pair, Sender]:
    """Values that one process alone can compute of a core link, and its sender.

    It is what its limbs and closures hand to the core, and sums of that. Where nobody sends
    anything, each computes everything for itself.
    """
    if not any(plan.steps_of(Send)):
        return {}
    core = _core(plan) | {j for j, joint in enumerate(plan.joints) if is_free_base(joint)}
    found = {
        pair: Sender(p, plan.joints[j].parent)
        for p, process in enumerate(plan.processes)
        for j in process.owns
        if plan.joints[j].parent - 1 in core and j not in core
        for pair in line.passed.get(j, [])
    }
    for p, process in enumerate(plan.processes):
        for step in process.steps_of(Eliminate):
            if step.link - 1 in core:
                own = line.eliminated.get(step.closure, [])
                found.update((pair, Sender(p, step.link)) for pair in own)
    for pair in line.sums():
        first, second = (found.get(line.unpacked(each)) for each in line.operands(pair))
        if first is not None and first == second:
            found[pair] = first
    return found
