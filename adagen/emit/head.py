"""What the head of an emitted file says of the program, read off the program itself."""

from __future__ import annotations

import re
import textwrap

from adagen.cost import timeline
from adagen.program import Program
from adagen.program.summary import groups, meeting, title
from adagen.schedule import CostProfile

_WIDTH = 103  # of a comment's text
_SHOWN = 8  # groups of joints of a process that are named

_FRAMES = {
    "kernels": "Spatial vectors are [angular; linear], in the axes of the base, about each link's "
    "origin.",
    "other": "Spatial vectors are [angular; linear], in link frames turned so that every joint "
    "axis is z.",
}
_ABA = (
    "The articulated-body algorithm: I^A and p^A (IA, pA), a link's inertia and bias force with "
    "all that hangs on it, are swept to the base, and the accelerations come back."
)
_SEGMENTS = (
    "Each process treats a segment of the robot by the articulated-body algorithm: I^A and p^A "
    "(IA, pA), a link's inertia and bias force with all that hangs on it, are swept to the "
    "segment's root, and the accelerations come back."
)
_GATHERED = (
    "Each process sweeps its own limbs by the articulated-body algorithm: I^A and p^A, a link's "
    "inertia and bias force with all that hangs on it. Processes meet once: each tells the others "
    "the I^A and p^A that it found at the links where limbs of several processes meet. What lies "
    "between those links, up to the root, every process then sweeps for itself, solves for the "
    "root's acceleration and goes outwards again through its own limbs."
)
_JOINED = (
    "Where segments meet, the assembly-disassembly algorithm of Yamane and Nakamura joins them: "
    "Phi = (I^A)^-1 and b are what a segment shows at a cut; joint i joins chain A (its parent "
    "link's side) and chain B (its child link's side), Eq. (3)-(7), and gives back its force, Eq. "
    "(8)-(10)."
)
_EXCHANGED = (
    "Both sides of a cut tell each other what they show, and both join it: no forces are sent back."
)
_ADA = (
    "The assembly-disassembly algorithm of Yamane and Nakamura. Phi are inverse articulated-body "
    "inertias, b bias accelerations. Joint i joins chain A (its parent link's side) and chain B "
    "(its child link's side) to chain C: assembly, Eq. (3)-(7), goes up the schedule, disassembly, "
    "Eq. (8)-(10), comes down."
)
_CLOSED = (
    "Where loops are closed, accelerations of their joints and the constraint forces are held back "
    "as unknowns, and eliminated at the last link that the joints have in common "
    "(docs/explanation/loops.md)."
)
_BATCH = "Each SIMD lane holds a state; the processes share the states of a batch, not the robot."


def algorithm(program: Program) -> list[str]:
    """Return in lines how the accelerations are computed."""
    match program.plan.form, meeting(program):
        case "ada", _:
            parts = [_ADA]
        case _, "alone":
            parts = [_ABA]
        case _, "gathered":
            parts = [_GATHERED]
        case _, how:
            parts = [_SEGMENTS, _JOINED] + [_EXCHANGED] * (how == "exchanged")
    parts += [_CLOSED] * program.plan.closed
    parts.append(_FRAMES.get(program.shape, _FRAMES["other"]))
    parts += [_BATCH] * program.batch
    return textwrap.wrap(" ".join(parts), _WIDTH)


def program_lines(program: Program, profile: CostProfile) -> list[str]:
    """Return in lines what runs where, and what that is predicted to take.

    Args:
        program: what is emitted.
        profile: prices it, unless it prices joins alone.
    """
    head = title(program)
    if not program.batch and profile.steps is not None and program.shape in _PRICED:
        time = timeline(program, profile).makespan
        head += f"; {time:.3g} us predicted ({profile.name} profile)"
    lines = [head]
    for p, process in enumerate(program.plan.processes):
        own = groups(program, p)
        rest = f", and {len(own) - _SHOWN} more" if len(own) > _SHOWN else ""
        said = ", ".join(own[:_SHOWN]) + rest if process.owns else "nothing"
        lines.append(f"process {p}: {said}")
    return [line for text in lines for line in textwrap.wrap(_fit_for_comment(text), _WIDTH - 10)]


_PRICED = ("kernels", "unrolled", "joints")


def _fit_for_comment(text: str) -> str:
    """Names from a URDF, without characters that could end a comment or leave ASCII."""
    return re.sub(r"[^A-Za-z0-9_.:+|,;() -]", "_", text)
