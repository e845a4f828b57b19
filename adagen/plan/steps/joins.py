"""Steps of assembly and disassembly, joint by joint (the paper, Section II)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from adagen.plan.steps.names import Bias, Block, Force, InwardStep, OutwardStep


@dataclass(frozen=True)
class LinkBias(InwardStep):
    """b of a bare link: its acceleration when nothing acts on it."""

    does: ClassVar[str] = "link_bias"
    about: ClassVar[str] = "acceleration where nothing acts on it"

    link: int


@dataclass(frozen=True)
class Coupling:
    """Phi between the joined joint's own handle on ``side`` and another handle of that side."""

    handle: int
    side: str
    source: Block
    transposed: bool


@dataclass(frozen=True)
class BlockUpdate:
    """Phi_C = Phi -/+ Z_row^T Z_column: Eq. (3), (4) on one side, Eq. (5) across."""

    target: Block
    source: Block | None
    across: bool


@dataclass(frozen=True)
class BiasUpdate:
    """b_C = b -/+ Phi gamma: Eq. (6) on side A, Eq. (7) on side B."""

    target: Bias
    source: Bias
    side: str


@dataclass(frozen=True)
class Join(InwardStep):
    """Assembly of a joint between chains A (parent side) and B (child side): Eq. (3)-(7).

    Attributes:
        joint: the joint i.
        a: chain A's block at the parent link; None where that is the ground, whose Phi is zero.
        a_bias: chain A's bias there; None for the ground, which accelerates upwards against
            gravity (all accelerations are relative to free fall).
        b: chain B's block at the child link.
        b_bias: chain B's bias there.
        couplings: the handles of C that are coupled to the joint, in the order of their links.
        blocks: the blocks of C that change.
        biases: the biases of C that change.
        velocity_product: whether c = v x S qd can differ from zero: not next to the ground.
    """

    does: ClassVar[str] = "join"
    about: ClassVar[str] = "assembly: its two sides become one chain"

    joint: int
    a: Block | None
    a_bias: Bias | None
    b: Block
    b_bias: Bias
    couplings: tuple[Coupling, ...]
    blocks: tuple[BlockUpdate, ...]
    biases: tuple[BiasUpdate, ...]
    velocity_product: bool


@dataclass(frozen=True)
class FusedJoin(Join):
    """Assembly of several joints in a row as one: the links between them have no mass.

    Chain A is at the parent link of the first one, chain B at the child link of the last one, in
    whose frame S = [X_(last<-j) S_j] and c = sum X_(last<-j) (v_j x S_j qd_j). ``joint`` is the
    last one; its disassembly gives the accelerations of all.

    Attributes:
        run: the joints, outwards.
    """

    does: ClassVar[str] = "fused_join"
    about: ClassVar[str] = "assembly of the run that it ends: its two sides become one chain"

    run: tuple[int, ...]


@dataclass(frozen=True)
class ForceUpdate:
    """Wrench on the joined handle of a part: that on C there, and f_i or its reaction."""

    target: Force
    source: Force | None
    side: str


@dataclass(frozen=True)
class Disassemble(OutwardStep):
    """Disassembly of a joint: its acceleration and force, Eq. (8)-(10).

    Attributes:
        joint: the joint i.
        forces: the outer wrenches on the handles that the join coupled, in its order.
        updates: the wrenches on the two parts.
    """

    does: ClassVar[str] = "disassemble"
    about: ClassVar[str] = "disassembly: its acceleration and force"

    joint: int
    forces: tuple[Force, ...]
    updates: tuple[ForceUpdate, ...]
