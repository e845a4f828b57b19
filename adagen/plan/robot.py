"""The robot's constants in a plan: links, joints, outer forces, loops and couplings."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import accumulate

from adagen.model import OUTPUT_SIZES
from adagen.model.loops import LOOP_KINDS
from adagen.model.paths import paths_to_ground
from adagen.schedule.costs import PRESCRIBED

OPTIONAL = {"optional": True}
"""Marks fields that a plan's JSON leaves out where they have their default."""


@dataclass(frozen=True)
class PlanLink:
    """A link's constants in its canonical frame (every joint axis z).

    Attributes:
        name: its name.
        mass: kg.
        com: centre of mass, 3 numbers, m.
        tensor: rotational inertia about the centre of mass, 3x3, kg m^2.
        tensor_inverse: its inverse, 3x3; empty where it was not needed.
        phi: inverse spatial inertia at the link's origin, 6x6; empty for the ground.
    """

    name: str
    mass: float
    com: tuple[float, ...]
    tensor: tuple[tuple[float, ...], ...]
    tensor_inverse: tuple[tuple[float, ...], ...]
    phi: tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class PlanJoint:
    """A joint's constants.

    Attributes:
        name: its name.
        kind: name of its kind (adagen.model.kinds).
        parent: parent link; the child link is the joint's index + 1.
        q: where its configuration starts in q.
        v: where its velocity starts in v.
        rotation: of the joint frame in the parent link's frame, 3x3.
        translation: of the joint frame in the parent link's frame, 3 numbers, m.
        mimic: (source joint, multiplier, offset) where it is slaved.
        damping: the torque at work is tau - damping qd - stiffness (q - rest)
            - friction tanh(qd / friction_speed); N m s/rad or N s/m.
        friction: N m or N.
        friction_speed: rad/s or m/s.
        stiffness: N m/rad or N/m.
        rest: rad or m.
        rotor_inertia: J in D = S^T U + J, kg m^2 or kg.
        prescribed: whether tau holds its acceleration instead of its torque.
        lent: artificial inertia that form ada adds to the tree without loops, and compensates by a
            right-hand side of its own (adagen/plan/artificial_inertia.py), kg m^2 or kg.
    """

    name: str
    kind: str
    parent: int
    q: int
    v: int
    rotation: tuple[tuple[float, ...], ...]
    translation: tuple[float, ...]
    mimic: tuple[int, float, float] | None
    damping: float = field(default=0.0, metadata=OPTIONAL)
    friction: float = field(default=0.0, metadata=OPTIONAL)
    friction_speed: float = field(default=0.01, metadata=OPTIONAL)
    stiffness: float = field(default=0.0, metadata=OPTIONAL)
    rest: float = field(default=0.0, metadata=OPTIONAL)
    rotor_inertia: float = field(default=0.0, metadata=OPTIONAL)
    prescribed: bool = field(default=False, metadata=OPTIONAL)
    lent: float = field(default=0.0, metadata=OPTIONAL)

    @property
    def loads(self) -> bool:
        """Whether passive forces act on it, of which a rotor's inertia is none."""
        return bool(self.damping or self.friction or self.stiffness)

    @property
    def tangents(self) -> int:
        """How many hyperbolic tangents its friction takes in an evaluation."""
        return 1 if self.friction else 0  # as ``adagen.model.Passive`` has it

    @property
    def priced_as(self) -> str:
        """The kind by which it is priced, apart from kinematics, or prescribed."""
        return PRESCRIBED if self.prescribed else self.kind


@dataclass(frozen=True)
class PlanWrench:
    """An outer force [force; moment] that is an input: in tau behind all torques, 6 numbers each.

    Attributes:
        name: of the link in whose frame it is expressed.
        link: the link that it acts on.
        rotation: of that frame in the link's, 3x3.
        translation: of that frame in the link's, 3 numbers, m.
    """

    name: str
    link: int
    rotation: tuple[tuple[float, ...], ...]
    translation: tuple[float, ...]


@dataclass(frozen=True)
class PlanOutput:
    """An output beside accelerations: in qdd behind all of them (``model.Output``).

    Attributes:
        what: a key of ``adagen.model.OUTPUT_SIZES``.
        name: of the link in whose frame it is expressed, or of the joint of a reaction force.
        link: the link; of a reaction force the joint's child link.
        rotation: of the named frame in the link's, 3x3.
        translation: of the named frame in the link's, 3 numbers, m.
    """

    what: str
    name: str
    link: int
    rotation: tuple[tuple[float, ...], ...]
    translation: tuple[float, ...]

    @property
    def size(self) -> int:
        """How many numbers it is."""
        return OUTPUT_SIZES[self.what]


def slaved_joint(joints: Iterable[PlanJoint]) -> str | None:
    """Return in words which joint is slaved to another; None where none is.

    Processes that gather, or exchange pair by pair, have no coupling torques.
    """
    slaved = (joint.name for joint in joints if joint.mimic is not None)
    return next((f'joint "{name}" is slaved to another' for name in slaved), None)


@dataclass(frozen=True)
class PlanLoop:
    """A joint that closes a loop.

    Attributes:
        name: its name.
        kind: name of its kind (adagen.model.loops).
        link1: the link that frame 1 is fixed to; 0 is the ground.
        rotation1: of frame 1 in that link's, 3x3; z is the loop joint's axis.
        translation1: of frame 1 in that link's, 3 numbers, m.
        link2: the link that frame 2 is fixed to.
        rotation2: likewise, 3x3.
        translation2: likewise, 3 numbers, m.
        tolerance: how far it may be open in a state, m and rad.
        turn2: of frame 2 in the frame that its description has there, 3x3; empty for the same.
    """

    name: str
    kind: str
    link1: int
    rotation1: tuple[tuple[float, ...], ...]
    translation1: tuple[float, ...]
    link2: int
    rotation2: tuple[tuple[float, ...], ...]
    translation2: tuple[float, ...]
    tolerance: float
    turn2: tuple[tuple[float, ...], ...] = field(default=(), metadata=OPTIONAL)

    @property
    def links(self) -> tuple[int, int]:
        """Both links."""
        return self.link1, self.link2

    @property
    def rotations(self) -> tuple[tuple[tuple[float, ...], ...], tuple[tuple[float, ...], ...]]:
        """Rotations of both frames."""
        return self.rotation1, self.rotation2

    @property
    def translations(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Translations of both frames."""
        return self.translation1, self.translation2

    def exchanged(self) -> PlanLoop:
        """Return the loop with its links in the other order; of a weld that is the same one."""
        return replace(
            self,
            link1=self.link2,
            rotation1=self.rotation2,
            translation1=self.translation2,
            link2=self.link1,
            rotation2=self.rotation1,
            translation2=self.translation1,
        )


@dataclass(frozen=True)
class PlanCoupling:
    """Coupled joint coordinates: the sum of factor * q is ``offset``.

    Attributes:
        name: its name.
        terms: joints with their factors.
        offset: m or rad.
        tolerance: how far it may be off in a state.
    """

    name: str
    terms: tuple[tuple[int, float], ...]
    offset: float
    tolerance: float


@dataclass(frozen=True)
class PlanParameter:
    """A constant that can be set at run time.

    Attributes:
        what: "gravity", "mass" or "center".
        values: what it is until then, SI units: gravity in ground axes, a link's mass, or its
            centre of mass in its canonical frame.
        link: whose mass or centre of mass it is.
        name: that link's name in the robot description.
        rotation: of the link's frame in the description, in which a centre of mass is set, in its
            canonical frame, 3x3.
        turn: of that one in the frame that the link has now, 3x3; empty where it is the same.
    """

    what: str
    values: tuple[float, ...]
    link: int = field(default=0, metadata=OPTIONAL)
    name: str = field(default="", metadata=OPTIONAL)
    rotation: tuple[tuple[float, ...], ...] = field(default=(), metadata=OPTIONAL)
    turn: tuple[tuple[float, ...], ...] = field(default=(), metadata=OPTIONAL)


def bound_by_loops(
    joints: Sequence[PlanJoint], loops: Sequence[PlanLoop], couplings: Sequence[PlanCoupling]
) -> frozenset[int]:
    """Return the joints that a loop or coupling is at, or beyond."""
    links = {link for loop in loops for link in loop.links}
    coupled = {j for coupling in couplings for j, _ in coupling.terms}
    return frozenset(paths_to_ground(joints, {link - 1 for link in links} | coupled))


def first_rows(loops: Sequence[PlanLoop], couplings: Sequence[PlanCoupling] = ()) -> list[int]:
    """Return the first row of each loop, then of each coupling, and the number of all rows."""
    counts = [LOOP_KINDS[loop.kind].rows for loop in loops] + [1] * len(couplings)
    return [0, *accumulate(counts)]
