"""The head of an emitted file, from its program."""

from __future__ import annotations

import re
import textwrap

from adagen.cost import state_time
from adagen.program import Program
from adagen.program.summary import a_state, groups, meeting, title
from adagen.schedule import CostProfile

_WIDTH = 103  # of a comment's text
_SHOWN = 8  # groups of joints of a process that are named

_FRAMES = {
    "kernels": "in the axes of the base, about each link's origin",
    "other": "in link frames whose joint axes are z",
}
_SEGMENTS = (
    "Each process solves a segment of the robot with the articulated-body algorithm: the "
    "articulated-body inertias I^A and bias forces p^A (IA, pA) are computed from the ends to the "
    "segment's root, then the accelerations from there outwards."
)
_GATHERED = (
    "Each process computes articulated-body inertias I^A and bias forces p^A of its own limbs, "
    "from their ends inwards. One exchange follows: each process sends its I^A and p^A at the "
    "links where limbs of several processes meet. Every process then computes the links between "
    "those and the root, solves for the root's acceleration, and computes the accelerations of "
    "its own limbs outwards."
)
_JOINED = (
    "Where segments meet, the assembly-disassembly algorithm of Yamane and Nakamura joins them: "
    "Phi = (I^A)^-1 and b are a segment's inverse inertia and bias acceleration at a cut; joint i "
    "joins chain A (on its parent link's side) and chain B (on its child link's side), Eq. "
    "(3)-(7), and its force follows from Eq. (8)-(10)."
)
_EXCHANGED = (
    "Both sides of a cut exchange their mobilities and bias accelerations, and both join it: no "
    "forces are sent back."
)
_ADA = (
    "Assembly-disassembly algorithm of Yamane and Nakamura. Phi are inverse articulated-body "
    "inertias, b bias accelerations. Joint i joins chain A (its parent link's side) and chain B "
    "(its child link's side) to chain C: assembly, Eq. (3)-(7), goes up the schedule, disassembly, "
    "Eq. (8)-(10), comes down."
)
_CLOSED = (
    "Closed loops: accelerations of their joints and constraint forces stay unknown until the last "
    "link that these joints have in common, where they are eliminated "
    "(docs/explanation/loops.md)."
)
_BATCH = "Each SIMD lane holds a state; the processes share the states of a batch, not the robot."
_ONE_BY_ONE = (
    "The states of a batch are solved one after the other, each in parts of the chain, one in each"
    " SIMD lane: what as many states work on as there are lanes would not fit the second-level"
    " cache. The processes share the states, not the robot."
)


def method(program: Program) -> str:
    """Return the algorithm of the accelerations in a few words."""
    name = "assembly-disassembly" if program.plan.form == "ada" else "articulated-body"
    return f"{name} algorithm"


def frames(program: Program) -> str:
    """Return the frames of vectors in the code in a few words."""
    where = _FRAMES.get(program.shape, _FRAMES["other"])
    return f"spatial vectors [angular; linear] {where}"


def algorithm(program: Program, *, batch: bool = False) -> list[str]:
    """Return as lines how processes meet, how loops are solved and how batches are solved."""
    match program.plan.form, meeting(program):
        case "ada", _:
            parts = [_ADA]
        case _, "alone":
            parts = []
        case _, "gathered":
            parts = [_GATHERED]
        case _, how:
            parts = [_SEGMENTS, _JOINED] + [_EXCHANGED] * (how == "exchanged")
    parts += [_CLOSED] * program.plan.closed
    if batch:
        parts += [_BATCH if program.batch else _ONE_BY_ONE]
    return textwrap.wrap(" ".join(parts), _WIDTH)


def program_lines(program: Program, profile: CostProfile) -> list[str]:
    """Return as lines the joints of each process, and the predicted time.

    Args:
        program: what is emitted.
        profile: prices it, unless it prices joins alone.
    """
    head = title(program)
    if profile.steps is not None and program.shape in _PRICED:
        time = state_time(program, profile)
        head += f"; {time:.3g} us{a_state(program)} predicted ({profile.name} profile)"
    lines = [head]
    for p, process in enumerate(program.plan.processes):
        own = groups(program, p)
        rest = f", and {len(own) - _SHOWN} more" if len(own) > _SHOWN else ""
        owned = ", ".join(own[:_SHOWN]) + rest if process.owns else "nothing"
        lines.append(f"process {p}: {owned}")
    return [line for text in lines for line in textwrap.wrap(_fit_for_comment(text), _WIDTH - 10)]


_PRICED = ("kernels", "unrolled", "joints")


def _fit_for_comment(text: str) -> str:
    """Names from a URDF, without characters that could end a comment or leave ASCII."""
    return re.sub(r"[^A-Za-z0-9_.:+|,;() -]", "_", text)
