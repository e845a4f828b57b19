"""Summaries of a program: how its processes meet, owners of joints, limbs in lanes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from adagen.errors import printable
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Join, SolveMobility, SolveRoot
from adagen.plan.types import Process
from adagen.program.runs import spans
from adagen.program.types import Program

Meeting = Literal["alone", "joined", "exchanged", "gathered"]
TREES = ("joined", "exchanged")
"""Ways to meet in which the schedule's tree says what is joined when."""


@dataclass(frozen=True)
class Gathering:
    """How processes gather (adagen/plan/gather.py).

    Attributes:
        roots: links whose accelerations all processes solve for.
        core: joints that every process sweeps for itself, ascending.
    """

    roots: tuple[int, ...]
    core: tuple[int, ...]


def meeting(program: Program) -> Meeting:
    """Return how the processes of a program meet."""
    plan = program.plan
    if not plan.several:
        return "alone"
    if not any(plan.steps_of(Join)):
        return "gathered"
    return "exchanged" if any(process.shares for process in plan.processes) else "joined"


def gathering(program: Program) -> Gathering:
    """Return where the processes of a program gather."""
    roots = {step.link for step in program.plan.steps_of(SolveRoot, SolveMobility)}
    core = {joint for process in program.plan.processes for joint in process.shares}
    return Gathering(tuple(sorted(roots)), tuple(sorted(core)))


def owners(program: Program) -> dict[str, int]:
    """Return the process that outputs the acceleration of each joint, by its name."""
    by_joint = {j: p for p, process in enumerate(program.plan.processes) for j in process.owns}
    return {joint.name: by_joint[j] for j, joint in enumerate(program.plan.joints)}


def lanes(program: Program) -> list[tuple[int, Limbs]]:
    """Return the limbs that lie side by side in SIMD lanes, each with its process."""
    return [(p, limbs) for p, own in enumerate(program.slots.limbs) for limbs in own]


def groups(program: Program, process: int, *, whole: bool = False) -> list[str]:
    """Return the joints of a process, run by run and limbs by limbs, in words.

    Args:
        program: the program.
        process: one of its processes.
        whole: whether all joints of a run are named, but for long chains, and not its first and
            last alone.
    """
    own: Process = program.plan.processes[process]
    side_by_side = program.slots.limbs[process]
    found = []
    for limbs in side_by_side:
        chains = (_run_words(program, chain, whole) for chain in zip(*limbs.rows, strict=True))
        found.append(f"{' | '.join(chains)} in {limbs.lanes} lanes")
    taken = {j for limbs in side_by_side for j in limbs.members()}
    left = spans(set(own.owns) - taken)
    return found + [_run_words(program, range(a, b + 1), whole) for a, b in left]


_LISTED = 12
"""Joints of a chain, each on the link of the one before, up to which all are named."""


def _run_words(program: Program, run: Sequence[int], whole: bool) -> str:
    joints = program.plan.joints
    if not whole:
        return " .. ".join(joints[j].name for j in dict.fromkeys((run[0], run[-1])))
    words: list[str] = []
    begins = [k for k, j in enumerate(run) if not k or joints[j].parent != run[k - 1] + 1]
    for begin, end in pairwise([*begins, len(run)]):
        names = [joints[j].name for j in run[begin:end]]
        if len(names) > _LISTED:
            names = [f"{names[0]} .. {names[-1]} ({len(names)} joints)"]
        words += names
    return ", ".join(words)


def a_state(program: Program) -> str:
    """Return what is said behind a time: that of a batch is shared by the states in a register."""
    return " a state" if program.batch else ""


def title(program: Program) -> str:
    """Return the number of processes and how they meet, in a few words."""
    count = len(program.plan.processes)
    if count == 1:
        return "1 process"
    match meeting(program):
        case "alone":
            how = "one of them used"
        case "joined":
            how = "joined at cuts"
        case "exchanged":
            how = "joined at cuts, by both sides of each"
        case "gathered":
            found = gathering(program)
            where = named([program.plan.links[k].name if k else "the ground" for k in found.roots])
            apart = any(message.sides for message in program.plan.messages)
            own = "each with trees of its own" if apart else "each with limbs of its own"
            how = f"gathered at {where}" if where else own
            if found.core:
                how += f", core {named([program.plan.joints[j].name for j in found.core])}"
    return f"{count} processes, {how}"


_NAMED = 4


def named(names: list[str]) -> str:
    """Return a few names, and the number of others."""
    more = f" and {len(names) - _NAMED} more" if len(names) > _NAMED else ""
    return ", ".join(names[:_NAMED]) + more


def program_text(program: Program) -> str:
    """Return the joints of each process as lines of text, for people."""
    lines = [title(program)]
    if program.shape == "unrolled":
        lines[0] += ", straight lines of statements"
    for p in range(len(program.plan.processes)):
        own = groups(program, p, whole=True) or ["nothing"]
        lines.append(f"process {p}")
        lines += [f"  {printable(words)}" for words in own]
    return "\n".join(lines) + "\n"
