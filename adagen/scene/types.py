"""A scene file as plain data, with line numbers for messages."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from adagen.errors import InputError
from adagen.model import (
    INVERSE_INERTIA,
    LINK_ACCELERATION,
    REACTION_FORCE,
    NamedCoupling,
    NamedLoop,
)
from adagen.tomlfile import Source

EFFECTS = ("damping", "friction", "friction_speed", "stiffness", "rest", "rotor_inertia")
"""Members of ``adagen.model.Passive``, as the scene file names them."""

OUTPUTS = {
    "link_accelerations": LINK_ACCELERATION,
    "reaction_forces": REACTION_FORCE,
    "inverse_inertia": INVERSE_INERTIA,
}
"""What a scene may ask for beside accelerations, by its key in ``[outputs]``."""

URDF = "urdf"
"""What a scene says to take damping or friction from the robot description."""


@dataclass(frozen=True)
class Base:
    """How the root link is held: kind is "fixed", "floating" or a restricted joint's kind.

    Attributes:
        kind: "fixed", "floating", "planar", "prismatic", "revolute" or "spherical".
        axis: of a prismatic or revolute base, normal of a planar one, in ground axes.
    """

    kind: str
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0)


@dataclass(frozen=True)
class PointMass:
    """A mass (kg) fixed to a link at a position (m) in the link's frame."""

    link: str
    mass: float
    position: tuple[float, float, float]


@dataclass(frozen=True)
class JointScene:
    """What a scene says of one joint.

    Attributes:
        effects: some of ``EFFECTS``.
        prescribed: whether its acceleration is an input.
    """

    effects: Mapping[str, float] = field(default_factory=dict)
    prescribed: bool = False


@dataclass(frozen=True)
class Scene:
    """What a scene file says; names are not yet looked up in a robot.

    Attributes:
        source: the file.
        gravity: m/s^2 in ground axes, if it says so.
        base: how the root link is held, if it says so.
        mimic: whether mimic joints are slaved, if it says so.
        lock: configuration of each locked joint.
        lock_all_but: the joints that stay, where all others are locked.
        keep: links whose motion is wanted.
        accelerations: joints whose accelerations are wanted; None for all.
        link_accelerations: links whose accelerations are given beside those of joints.
        reaction_forces: joints through which the forces are given.
        inverse_inertia: links at which the inverse of the inertia is given.
        at_rest: whether all velocities are zero.
        forces: links on which an external force acts, each an input.
        damping: of every joint that says nothing: a number or "urdf"; None is none, undecided.
        friction: likewise.
        friction_speed: likewise, a number.
        joints: what it says of single joints.
        point_masses: masses that are added.
        loops: joints that close loops.
        couplings: joints whose coordinates are tied.
    """

    source: Source
    gravity: tuple[float, float, float] | None = None
    base: Base | None = None
    mimic: bool | None = None
    lock: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    lock_all_but: tuple[str, ...] | None = None
    keep: tuple[str, ...] = ()
    accelerations: tuple[str, ...] | None = None
    link_accelerations: tuple[str, ...] = ()
    reaction_forces: tuple[str, ...] = ()
    inverse_inertia: tuple[str, ...] = ()
    at_rest: bool = False
    forces: tuple[str, ...] = ()
    damping: float | str | None = None
    friction: float | str | None = None
    friction_speed: float | None = None
    joints: Mapping[str, JointScene] = field(default_factory=dict)
    point_masses: tuple[PointMass, ...] = ()
    loops: tuple[NamedLoop, ...] = ()
    couplings: tuple[NamedCoupling, ...] = ()

    @property
    def floating(self) -> bool:
        """Whether the robot needs a joint ``__base__`` between the world and its root link."""
        return self.base is not None and self.base.kind != "fixed"

    @property
    def from_urdf(self) -> frozenset[str]:
        """Which effects of joints the robot description is asked for."""
        return frozenset(name for name, value in self._of_all.items() if value == URDF)

    @property
    def _of_all(self) -> dict[str, float | str | None]:
        return {"damping": self.damping, "friction": self.friction}

    def decides(self, effect: str, joint: str) -> bool:
        """Return whether a joint's effect is set here, or cannot matter as the joint is locked."""
        own = self.joints.get(joint)
        free = self.lock_all_but
        return (
            self._of_all.get(effect) is not None
            or (own is not None and effect in own.effects)
            or joint in self.lock
            or (free is not None and joint not in free)
        )

    def error(self, message: str, *path: str | int) -> InputError:
        """Return (not raise) the refusal of what the scene says at ``path``."""
        return self.source.error(message, *path)
