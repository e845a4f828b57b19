"""Steps of the articulated-body algorithm inside a segment, and at links where segments meet."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from adagen.plan.steps.names import Bias, Block, Force, InwardStep, OutwardStep


@dataclass(frozen=True)
class StartLink(InwardStep):
    """I^A and p^A of a link start as its own inertia and v x* I v (Featherstone, RBDA 7.3)."""

    does: ClassVar[str] = "link_inertia"
    about: ClassVar[str] = "bias force in the reference field"

    link: int


@dataclass(frozen=True)
class StartEmpty(InwardStep):
    """I^A and p^A of a link start as zero: another process adds the link's own inertia."""

    does: ClassVar[str] = "clear_inertia"
    about: ClassVar[str] = "nothing: another process adds it"

    link: int


@dataclass(frozen=True)
class FreeBase(InwardStep):
    """A floating joint on the ground only adds its torque to the link."""

    does: ClassVar[str] = "free_base"
    about: ClassVar[str] = "its torque on the base"

    joint: int


@dataclass(frozen=True)
class Articulate(InwardStep):
    """I^A and p^A of the link on a joint's far side, through the joint, onto its near side.

    Far and near are seen from the root of the segment: far is the child link, or the parent link
    where ``reversed`` (the segment's root lies below the joint). By exact projection.
    """

    does: ClassVar[str] = "articulate"
    about: ClassVar[str] = "articulated-body inertia and bias force through it"
    about_row: ClassVar[str] = "articulated-body inertia and bias force through them"

    joint: int
    reversed: bool


@dataclass(frozen=True)
class InvertRoot(InwardStep):
    """Phi = (I^A)^-1 and b = -Phi p^A of a segment's root that is a handle."""

    does: ClassVar[str] = "invert_root"
    about: ClassVar[str] = "mobility from its articulated-body inertia"

    link: int
    block: Block
    bias: Bias


@dataclass(frozen=True)
class SolveRoot(InwardStep):
    """Acceleration of a segment's root that is no handle: I^A a = -p^A."""

    does: ClassVar[str] = "solve_root"
    about: ClassVar[str] = "acceleration from its articulated-body inertia"

    link: int


@dataclass(frozen=True)
class SolveMobility(OutwardStep):
    """Acceleration of a link of known mobility Phi: (1 + Phi I^A) a = b - Phi p^A."""

    does: ClassVar[str] = "solve_mobility"
    about: ClassVar[str] = "acceleration from its mobility and its articulated-body inertia"

    link: int
    block: Block
    bias: Bias


@dataclass(frozen=True)
class HoldMobility(InwardStep):
    """I^A = Phi^-1 and p^A = -Phi^-1 b of a link, from its mobility towards the ground.

    This starts the outward recursion from the ground: beyond the joints that make Phi regular, the
    ground is only one more body. If Phi is nearly singular (a straight arm), the evaluation is
    repeated by the processes' ``recovery`` steps.
    """

    does: ClassVar[str] = "hold_mobility"
    about: ClassVar[str] = "the ground's side of it, treated as a body"

    link: int
    block: Block
    bias: Bias


@dataclass(frozen=True)
class Spread:
    """Phi between a joint's far link and an earlier handle: L times the near link's.

    With ``target_transposed`` (``source_transposed``) the block has the handle in its rows and the
    far link (the near link) in its columns.
    """

    handle: int
    target: Block
    target_transposed: bool
    source: Block
    source_transposed: bool


@dataclass(frozen=True)
class Propagate(InwardStep):
    """Mobility outwards across a joint: Omega = L Omega L^T + S D^-1 S^T, Psi = L Psi.

    Attributes:
        joint: the joint.
        reversed: as in ``Articulate``.
        block: Omega of the far link.
        near: Omega of the near link; None for the ground, which does not move.
        bias: acceleration of the far link without handle forces.
        near_bias: the near link's; None for the ground.
        spreads: couplings with earlier handles.
    """

    does: ClassVar[str] = "propagate"
    about: ClassVar[str] = "mobility and acceleration beyond it"

    joint: int
    reversed: bool
    block: Block
    near: Block | None
    bias: Bias
    near_bias: Bias | None
    spreads: tuple[Spread, ...]


@dataclass(frozen=True)
class Load(OutwardStep):
    """Load of a link by handle forces, before the joints beyond it add theirs."""

    does: ClassVar[str] = "load"
    about: ClassVar[str] = "handle forces on it"

    link: int
    force: Force | None


@dataclass(frozen=True)
class LoadRoot(OutwardStep):
    """Load of a link with known acceleration: -(I^A a + p^A).

    With ``held``, I^A and p^A are those of ``HoldMobility``, and the load is the opposite.
    """

    does: ClassVar[str] = "load_root"
    about: ClassVar[str] = "load from its known acceleration"

    link: int
    held: bool = False


@dataclass(frozen=True)
class Deliver(OutwardStep):
    """Transfers the load of a joint's far link through the joint to its near link: L^T."""

    does: ClassVar[str] = "deliver"
    about: ClassVar[str] = "handle forces through it"

    joint: int
    reversed: bool


@dataclass(frozen=True)
class AccelerateRoot(OutwardStep):
    """Acceleration of a root that is a handle: a = b + Phi load."""

    does: ClassVar[str] = "accelerate_root"
    about: ClassVar[str] = "acceleration under the handle forces"

    link: int
    block: Block
    bias: Bias


@dataclass(frozen=True)
class FreeAcceleration(OutwardStep):
    """qdd of a floating joint on the ground, from its link's acceleration."""

    does: ClassVar[str] = "free_acceleration"
    about: ClassVar[str] = "acceleration of the base"

    joint: int


@dataclass(frozen=True)
class Accelerate(OutwardStep):
    """qdd of a joint and the acceleration of its far link."""

    does: ClassVar[str] = "accelerate"
    about: ClassVar[str] = "its acceleration, and that of the link beyond"
    about_row: ClassVar[str] = "their accelerations, and those of the links beyond"

    joint: int
    reversed: bool
