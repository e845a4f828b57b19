"""Messages between processes: what is in them, and how long they are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from adagen.model.kinds import KINDS
from adagen.plan.robot import OPTIONAL, PlanJoint
from adagen.plan.steps import Bias, Block, Force, Passage, SideOfLoops

ENERGIES = "energies"
"""Messages with the sizes of corrections."""
MOST_ENERGIES = 11
"""Energies in them: of the answer, of all link accelerations, and of up to nine corrections."""

CERTIFICATE = "certificate"
"""Messages with a process's part of a certificate."""
NUMBERS_OF_SHARE, NUMBERS_AT_LINK = 3, 22
"""Most numbers in them, and at each link (adagen/executor/certificate.py)."""


@dataclass(frozen=True)
class Message:
    """The contents of a message between two processes, sent once in an evaluation.

    Attributes:
        source: sending process.
        target: receiving process.
        sweep: "kinematics", "assembly", "disassembly", "slaved" (accelerations of slaved joints
            and their sources), "torques" (their coupling torques), "energies" or
            "certificate".
        joint: the joint that completed the chain concerned; None for the last two.
        blocks: blocks in it: 21 numbers of a handle's own, which is symmetric, 36 of two handles.
        biases: biases in it, 6 numbers for each right-hand side.
        forces: wrenches in it, likewise.
        joints: joints whose accelerations are in it, for every right-hand side.
        inertias: links whose I^A and p^A, summed over the source's limbs, are in it: 21 numbers,
            and 6 for each right-hand side. The target adds them to its own.
        passages: passages of runs, 24 numbers each.
        placements: joints of which it says how they lie: where the child link is, and how it is
            turned, 12 numbers each.
        sides: contributions of the source's joints to the rows of closures, which the target adds
            to its own: for n rows n (n + 1) / 2 numbers, and n for each right-hand side.
        repeats: number of the message that it repeats for a correction, without blocks, inertias
            and motions.
        weighed: in a certificate, core links of the source's limbs.
    """

    source: int
    target: int
    sweep: str
    joint: int | None
    blocks: tuple[Block, ...] = ()
    biases: tuple[Bias, ...] = ()
    forces: tuple[Force, ...] = ()
    joints: tuple[int, ...] = ()
    inertias: tuple[int, ...] = ()
    passages: tuple[Passage, ...] = field(default=(), metadata=OPTIONAL)
    placements: tuple[int, ...] = field(default=(), metadata=OPTIONAL)
    sides: tuple[SideOfLoops, ...] = field(default=(), metadata=OPTIONAL)
    repeats: int | None = field(default=None, metadata=OPTIONAL)
    weighed: tuple[int, ...] = field(default=(), metadata=OPTIONAL)

    def numbers(self, columns: int, joints: Sequence[PlanJoint]) -> int:
        """Return how many numbers it holds, with so many right-hand sides, of a plan's joints."""
        if self.sweep == "torques":
            return columns - 1
        if self.sweep == ENERGIES:
            return MOST_ENERGIES
        if self.sweep == CERTIFICATE:
            return NUMBERS_OF_SHARE + NUMBERS_AT_LINK * len(self.weighed)
        vectors = len(self.biases) + len(self.forces) + len(self.inertias)
        matrices = sum(21 if block.row == block.column else 36 for block in self.blocks)
        matrices += 21 * len(self.inertias) + 24 * len(self.passages)
        matrices += 12 * len(self.placements)
        matrices += sum(side.rows * (side.rows + 1) // 2 for side in self.sides)
        matrices = matrices if self.repeats is None else 0
        rows = sum(side.rows for side in self.sides)
        freedoms = sum(KINDS[joints[j].kind].nv for j in self.joints)
        return matrices + columns * (6 * vectors + freedoms + rows)
