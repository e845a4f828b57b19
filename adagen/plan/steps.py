"""The steps of a plan and the buffers that they read and set.

Three kinds of buffers are named, each living in the memory of the process that computes or receives
it:

* ``Block``: Phi_gh of a partial chain, 6x6, row handle g and column handle h (links), g <= h;
* ``Bias``: b_h of a partial chain, 6 numbers for each right-hand side;
* ``Force``: the wrench that acts on handle h of a partial chain from outside, likewise.

Handles are links, in the link's own frame: all joints at one link share its block, seen through
their constant or joint-dependent transforms. A partial chain is named by the joint that completed
it; ``joint is None`` names a bare link. Blocks between handles that do not feel each other (they
meet in the ground only) do not exist.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, order=True)
class Block:
    """Phi_gh (paper, Eq. 2) of the chain that ``joint`` completed; a bare link's if None."""

    joint: int | None
    row: int
    column: int


@dataclass(frozen=True, order=True)
class Bias:
    """b_h (paper, Eq. 2) of the chain that ``joint`` completed; a bare link's if None."""

    joint: int | None
    handle: int


@dataclass(frozen=True, order=True)
class Force:
    """The outer wrench on link ``handle`` of the chain that ``joint`` completed."""

    joint: int
    handle: int


@dataclass(frozen=True)
class Kinematics:
    """Transform and velocity of a joint's child link."""

    joint: int


@dataclass(frozen=True)
class LinkBias:
    """b of a bare link: its acceleration when nothing acts on it."""

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
class Join:
    """Assembly of a joint between chains A (parent side) and B (child side): Eq. (3)-(7).

    Attributes:
        joint: the joint i.
        a: chain A's block at the parent link; None where that is the ground, whose Phi is zero.
        a_bias: chain A's bias there; None for the ground, which accelerates upwards against
            gravity (all accelerations are relative to free fall).
        b: chain B's block at the child link.
        b_bias: chain B's bias there.
        couplings: the handles of C that feel the joint, in the order of their links.
        blocks: the blocks of C that change.
        biases: the biases of C that change.
        velocity_product: whether c = v x S qd can differ from zero: not next to the ground.
    """

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

    run: tuple[int, ...]


@dataclass(frozen=True)
class ForceUpdate:
    """Wrench on the joined handle of a part: what acted on C there, and f_i or its reaction."""

    target: Force
    source: Force | None
    side: str


@dataclass(frozen=True)
class Disassemble:
    """Disassembly of a joint: its acceleration and force, Eq. (8)-(10).

    Attributes:
        joint: the joint i.
        forces: the outer wrenches on the handles that the join coupled, in its order.
        updates: the wrenches that the two parts get to feel.
    """

    joint: int
    forces: tuple[Force, ...]
    updates: tuple[ForceUpdate, ...]


@dataclass(frozen=True)
class Send:
    """Hand a message to its target."""

    message: int


@dataclass(frozen=True)
class Receive:
    """Wait for a message."""

    message: int


@dataclass(frozen=True)
class SolveCoupling:
    """The torques that keep slaved joints in step, from all processes' accelerations."""


@dataclass(frozen=True)
class ApplyCoupling:
    """Add what these torques do to this process's accelerations."""


@dataclass(frozen=True)
class StartLink:
    """I^A and p^A of a link start as its own inertia and v x* I v (Featherstone, RBDA 7.3)."""

    link: int


@dataclass(frozen=True)
class StartEmpty:
    """I^A and p^A of a link start as zero: the link itself is another process's to add."""

    link: int


@dataclass(frozen=True)
class FreeBase:
    """A floating joint on the ground only adds its torque to the link: nothing holds the link."""

    joint: int


@dataclass(frozen=True)
class Articulate:
    """I^A and p^A of the link on a joint's far side, through the joint, onto its near side.

    Far and near are seen from the root of the segment: far is the child link, or the parent link
    where ``reversed`` (the segment's root lies below the joint). By exact projection.
    """

    joint: int
    reversed: bool


@dataclass(frozen=True)
class InvertRoot:
    """Phi = (I^A)^-1 and b = -Phi p^A of a segment's root that is a handle."""

    link: int
    block: Block
    bias: Bias


@dataclass(frozen=True)
class SolveRoot:
    """Acceleration of a segment's root that is no handle: I^A a = -p^A."""

    link: int


@dataclass(frozen=True)
class SolveMobility:
    """Acceleration of a link whose one side shows its mobility: (1 + Phi I^A) a = b - Phi p^A."""

    link: int
    block: Block
    bias: Bias


@dataclass(frozen=True)
class HoldMobility:
    """I^A and p^A of a link become those of what holds it: Phi^-1 and -Phi^-1 b.

    The outward recursion from the ground: beyond the joints that make Phi regular, the ground is
    only one more body. Where Phi is too near to a singular matrix (a straight arm), the evaluation
    is done again by the processes' ``recovery`` steps.
    """

    link: int
    block: Block
    bias: Bias


@dataclass(frozen=True)
class Spread:
    """Phi between the link reached and a handle passed before: L times the near link's.

    Where ``target_transposed`` (``source_transposed``) the block has the handle in its rows and
    the link reached (the near link) in its columns.
    """

    handle: int
    target: Block
    target_transposed: bool
    source: Block
    source_transposed: bool


@dataclass(frozen=True)
class Propagate:
    """Mobility outwards across a joint: Omega = L Omega L^T + S D^-1 S^T, Psi = L Psi.

    Attributes:
        joint: the joint.
        reversed: as in ``Articulate``.
        block: Omega of the far link.
        near: Omega of the near link; None for the ground, which does not move.
        bias: acceleration of the far link under no handle forces.
        near_bias: the near link's; None for the ground.
        spreads: couplings with handles passed before.
    """

    joint: int
    reversed: bool
    block: Block
    near: Block | None
    bias: Bias
    near_bias: Bias | None
    spreads: tuple[Spread, ...]


@dataclass(frozen=True)
class Load:
    """What handle forces load a link with, before the joints beyond it add theirs."""

    link: int
    force: Force | None


@dataclass(frozen=True)
class LoadRoot:
    """What I^A and p^A load a link with whose acceleration is known: -(I^A a + p^A).

    With ``held``, I^A and p^A are what holds the link, and its load is the opposite.
    """

    link: int
    held: bool = False


@dataclass(frozen=True)
class Deliver:
    """The load on a joint's far link, through the joint, onto its near link: L^T."""

    joint: int
    reversed: bool


@dataclass(frozen=True)
class AccelerateRoot:
    """Acceleration of a root that is a handle: a = b + Phi load."""

    link: int
    block: Block
    bias: Bias


@dataclass(frozen=True)
class FreeAcceleration:
    """qdd of a floating joint on the ground, from its link's acceleration."""

    joint: int


@dataclass(frozen=True)
class Accelerate:
    """qdd of a joint and the acceleration of its far link."""

    joint: int
    reversed: bool


Step = (
    Kinematics
    | LinkBias
    | Join
    | FusedJoin
    | Disassemble
    | StartLink
    | StartEmpty
    | FreeBase
    | Articulate
    | InvertRoot
    | SolveRoot
    | SolveMobility
    | HoldMobility
    | Propagate
    | Load
    | LoadRoot
    | Deliver
    | AccelerateRoot
    | FreeAcceleration
    | Accelerate
    | Send
    | Receive
    | SolveCoupling
    | ApplyCoupling
)


def blocks_set_by(step: Step) -> tuple[Block, ...]:
    """Return the blocks that a step computes."""
    match step:
        case Join():
            return tuple(update.target for update in step.blocks)
        case InvertRoot():
            return (step.block,)
        case Propagate():
            return (step.block, *(spread.target for spread in step.spreads))
        case _:
            return ()


def biases_set_by(step: Step) -> tuple[Bias, ...]:
    """Return the biases that a step computes, those of bare links left out."""
    match step:
        case Join():
            return tuple(update.target for update in step.biases)
        case InvertRoot() | Propagate():
            return (step.bias,)
        case _:
            return ()
