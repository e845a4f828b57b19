"""The plan: what each process does, step by step, frozen and printable.

A plan is the whole input of the emitter and of the executor. Its steps and the buffers that they
name are in adagen/plan/steps/.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from functools import cached_property

from adagen.model.kinds import KINDS
from adagen.plan.steps import Bias, Block, Force, Step

THREADS = "threads"
"""The channel between processes that are threads of one program."""
FACTORS = {"double": "double", "float": "float", "mixed": "float"}
"""Scalars, and the number type in which each factorizes and solves; all else of "mixed" is double,
and what it solves for is refined."""


@dataclass(frozen=True)
class Message:
    """What one process tells another once in an evaluation.

    Attributes:
        source: sending process.
        target: receiving process.
        sweep: "assembly", "disassembly", "slaved" (accelerations of slaved joints and their
            sources, to be solved for) or "torques" (the answer).
        joint: the joint that completed the chain that is spoken of; None for the last two.
        blocks: blocks in it, 36 numbers each.
        biases: biases in it, 6 numbers for each right-hand side.
        forces: wrenches in it, likewise.
        joints: joints whose accelerations are in it, for every right-hand side.
        inertias: links whose I^A and p^A, as far as the source knows them, are in it: 21 numbers,
            and 6 for each right-hand side. The target adds them to its own.
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

    def numbers(self, columns: int) -> int:
        """Return how many numbers it holds, with so many right-hand sides."""
        if self.sweep == "torques":
            return columns - 1
        vectors = len(self.biases) + len(self.forces) + len(self.inertias)
        matrices = 36 * len(self.blocks) + 21 * len(self.inertias)
        return matrices + 6 * columns * vectors + columns * len(self.joints)


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


OPTIONAL = {"optional": True}
"""Marks fields that a plan's JSON leaves out where they have their default."""


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


@dataclass(frozen=True)
class PlanWrench:
    """An outer force [force; moment] that is an input: in tau behind all torques, 6 numbers each.

    Attributes:
        name: of the link in whose frame it is told.
        link: the link that feels it.
        rotation: of that frame in the link's, 3x3.
        translation: of that frame in the link's, 3 numbers, m.
    """

    name: str
    link: int
    rotation: tuple[tuple[float, ...], ...]
    translation: tuple[float, ...]


@dataclass(frozen=True)
class Process:
    """What one process does.

    Attributes:
        steps: in order.
        reads: joints whose q and v it reads, ascending.
        owns: joints whose torque it reads and whose acceleration it gives, ascending.
        shares: further joints whose torque it reads and whose acceleration it computes for itself.
        recovery: what is done instead where ``HoldMobility`` cannot be; empty where it is not used.
    """

    steps: tuple[Step, ...]
    reads: tuple[int, ...]
    owns: tuple[int, ...]
    shares: tuple[int, ...] = ()
    recovery: tuple[Step, ...] = field(default=(), metadata=OPTIONAL)

    @property
    def treated(self) -> list[int]:
        """Joints whose acceleration it computes, ascending."""
        return sorted((*self.owns, *self.shares))


@dataclass(frozen=True)
class Plan:
    """A frozen answer to "who computes what, when, from what".

    Attributes:
        name: the robot's name (data, not fit for code).
        source_hash: of the robot description, hexadecimal.
        form: "ada" or "segment".
        scalar: a key of ``FACTORS``.
        channel: "auto", "window" or "message": what the emitted program prefers; or "threads":
            processes are threads of one program.
        schedule: the schedule in one line.
        floating: whether joint 0 is the floating base ``__base__``.
        gravity: 3 numbers, m/s^2.
        links: the ground first.
        joints: in depth-first order.
        slaved: slaved joints; each adds a right-hand side.
        processes: one entry per process.
        messages: numbered by their place.
        wrenches: outer forces.
        profile: name of the cost profile by which its program was chosen.
    """

    name: str
    source_hash: str
    form: str
    scalar: str
    channel: str
    schedule: str
    floating: bool
    gravity: tuple[float, ...]
    links: tuple[PlanLink, ...]
    joints: tuple[PlanJoint, ...]
    slaved: tuple[int, ...]
    processes: tuple[Process, ...]
    messages: tuple[Message, ...]
    wrenches: tuple[PlanWrench, ...] = field(default=(), metadata=OPTIONAL)
    profile: str = field(default="default", metadata=OPTIONAL)

    @property
    def right_hand_sides(self) -> int:
        """Columns of every bias, force and acceleration: the motion, and one per slaved joint."""
        return 1 + len(self.slaved)

    @cached_property
    def children(self) -> tuple[tuple[int, ...], ...]:
        """For each link the joints that it is the parent of, ascending."""
        below: list[list[int]] = [[] for _ in self.links]
        for j, joint in enumerate(self.joints):
            below[joint.parent].append(j)
        return tuple(map(tuple, below))

    @property
    def threads(self) -> bool:
        """Whether its processes are threads of one program, which needs no MPI."""
        return self.channel == THREADS and len(self.processes) > 1

    @property
    def launched(self) -> int:
        """How many processes a launcher starts."""
        return 1 if self.threads else len(self.processes)

    def recovering(self) -> Plan:
        """Return the plan of what is done where a mobility cannot be taken for an inertia."""
        processes = (replace(p, steps=p.recovery, recovery=()) for p in self.processes)
        return replace(self, processes=tuple(processes))

    def entry_of_wrench(self, k: int) -> int:
        """Return where the six numbers of outer force ``k`` start in tau."""
        return sum(KINDS[joint.kind].nv for joint in self.joints) + 6 * k

    def paths(self, joints: Iterable[int]) -> set[int]:
        """Return the joints from the ground down to some joints, these included."""
        found: set[int] = set()
        for joint in joints:
            while joint >= 0 and joint not in found:
                found.add(joint)
                joint = self.joints[joint].parent - 1
        return found
