"""Plain data: a robot as a tree of rigid links and joints."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import accumulate

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import JointKind
from adagen.model.links import Frame, Link
from adagen.model.loops import Coupling, Loop
from adagen.model.paths import joints_on_links

Array = NDArray[np.float64]

BASE = "__base__"
"""Name of the floating joint that a robot is put on where the user asks for one."""


@dataclass(frozen=True)
class Mimic:
    """q of a joint as multiplier * q[source] + offset, source being a joint's index."""

    source: int
    multiplier: float
    offset: float


@dataclass(frozen=True)
class Passive:
    """Passive forces of a joint, for each of its degrees of freedom.

    The torque that moves the links is tau - damping qd - stiffness (q - rest)
    - friction tanh(qd / friction_speed) - rotor_inertia qdd.

    Attributes:
        damping: N m s/rad (N s/m for a prismatic joint).
        friction: N m (N), what it comes to at speeds well above ``friction_speed``.
        friction_speed: rad/s (m/s), over which friction changes its sign; more than 0.
        stiffness: of a spring, N m/rad (N/m).
        rest: where the spring has no torque, rad (m).
        rotor_inertia: of the drive as felt at the joint, kg m^2 (kg).
    """

    damping: float = 0.0
    friction: float = 0.0
    friction_speed: float = 0.01
    stiffness: float = 0.0
    rest: float = 0.0
    rotor_inertia: float = 0.0

    @property
    def loads(self) -> bool:
        """Whether it changes the torque at a given state."""
        return bool(self.damping or self.friction or self.stiffness)

    @property
    def tangents(self) -> int:
        """How many hyperbolic tangents its friction takes in an evaluation."""
        return 1 if self.friction else 0  # only joints of one degree of freedom have any


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint between ``parent`` and the link whose index is one more than the joint's.

    Attributes:
        name: its name in the robot description.
        kind: its kind.
        parent: index of the parent link; 0 is the ground.
        rotation: of the joint frame in the parent link's frame, shape (3, 3).
        translation: origin of the joint frame in the parent link's frame, shape (3,), m.
        axis: unit vector in the joint frame, shape (3,): axis of a revolute or prismatic joint,
            normal of a planar one, (0, 0, 1) otherwise. At q = 0 the child link's frame is the
            joint frame.
        mimic: set where the joint is slaved to another one.
        passive: damping, friction, spring and rotor inertia, as far as its kind takes them.
        prescribed: whether its acceleration is known in advance: an input in place of its torque.
    """

    name: str
    kind: JointKind
    parent: int
    rotation: Array
    translation: Array
    axis: Array
    mimic: Mimic | None = None
    passive: Passive = Passive()
    prescribed: bool = False

    def __post_init__(self) -> None:
        for effect in ("damping", "friction", "stiffness", "rotor_inertia"):
            if getattr(self.passive, effect) and not self.kind.takes(effect):
                raise ValueError(f'{self.kind.name} joint "{self.name}" has {effect}')


@dataclass(frozen=True, eq=False)
class Wrench:
    """An outer force and moment that is an input: [force; moment] at a link's origin in its axes.

    Attributes:
        link: index of the link that feels it.
        frame: the named link's frame in that link's (another one where it is lumped).
    """

    link: int
    frame: Frame


LINK_ACCELERATION, REACTION_FORCE = "link acceleration", "reaction force"
INVERSE_INERTIA = "inverse inertia"
OUTPUT_SIZES = {LINK_ACCELERATION: 6, REACTION_FORCE: 6, INVERSE_INERTIA: 36}
"""What can be computed beside accelerations, and how many numbers that is."""


@dataclass(frozen=True, eq=False)
class Output:
    """What is computed beside accelerations; its numbers follow those of the joints in qdd.

    Attributes:
        what: "link acceleration": [linear; angular] acceleration of a frame's origin in its axes,
            m/s^2 and rad/s^2; "reaction force": [force; moment] by which the parent link acts on
            the child link through a joint, at the child frame's origin in its axes, N and N m;
            "inverse inertia": accelerations [linear; angular] of a frame for each unit of a
            [force; moment] on it, 6x6 row by row (Featherstone, RBDA 2.15; inverse of the
            operational-space inertia).
        link: index of the link; of a reaction force the joint's child link.
        frame: the named link's frame in that link's.
        name: of the link, or of the joint of a reaction force.
    """

    what: str
    link: int
    frame: Frame
    name: str


@dataclass(frozen=True, eq=False)
class Model:
    """A robot: joint j joins links[joints[j].parent] to links[j + 1]; links[0] is the ground.

    Joints are in depth-first order (siblings by name), so that parents come before children.

    Attributes:
        name: the robot's name.
        links: N + 1 links, the ground first; the ground's inertia plays no part.
        joints: N joints.
        gravity: acceleration of free fall in ground coordinates, shape (3,), m/s^2.
        floating: whether joint 0 is the floating base ``__base__`` that the user asked for.
        wrenches: outer forces that are inputs; they follow the joints' torques in tau.
        loops: joints that close loops of the tree.
        couplings: joints whose coordinates are tied.
        wanted: joints whose accelerations are asked for, ascending; none stands for all.
        outputs: what is asked for beside accelerations; it follows them in qdd.
        at_rest: whether all velocities are zero.
    """

    name: str
    links: tuple[Link, ...]
    joints: tuple[Joint, ...]
    gravity: Array = field(default_factory=lambda: np.array([0.0, 0.0, -9.81]))
    floating: bool = False
    wrenches: tuple[Wrench, ...] = ()
    loops: tuple[Loop, ...] = ()
    couplings: tuple[Coupling, ...] = ()
    wanted: tuple[int, ...] = ()
    outputs: tuple[Output, ...] = ()
    at_rest: bool = False

    @property
    def closed(self) -> bool:
        """Whether constraints tie its joints: loops or couplings."""
        return bool(self.loops or self.couplings)

    @cached_property
    def nq(self) -> int:
        """Numbers in a configuration."""
        return sum(joint.kind.nq for joint in self.joints)

    @cached_property
    def nv(self) -> int:
        """Degrees of freedom (a slaved joint counts its own)."""
        return sum(joint.kind.nv for joint in self.joints)

    @property
    def ntau(self) -> int:
        """Numbers in tau: one for each degree of freedom, then six for each outer force."""
        return self.nv + 6 * len(self.wrenches)

    @property
    def nqdd(self) -> int:
        """Numbers in qdd: one for each degree of freedom, then those of all outputs."""
        return self.nv + sum(OUTPUT_SIZES[output.what] for output in self.outputs)

    @cached_property
    def q_start(self) -> tuple[int, ...]:
        """Where each joint's configuration starts in q; length N."""
        return tuple(accumulate((j.kind.nq for j in self.joints), initial=0))[:-1]

    @cached_property
    def v_start(self) -> tuple[int, ...]:
        """Where each joint's velocity starts in v; length N."""
        return tuple(accumulate((j.kind.nv for j in self.joints), initial=0))[:-1]

    @cached_property
    def children(self) -> tuple[tuple[int, ...], ...]:
        """For each link the joints that it is the parent of, ascending; length N + 1."""
        return joints_on_links(self.joints)

    def with_gravity(self, gravity: Array) -> Model:
        """Return the same robot under another gravity, shape (3,), m/s^2."""
        return replace(self, gravity=np.asarray(gravity, dtype=np.float64))
