"""Joint kinds: degrees of freedom, configuration and motion subspace.

Spatial vectors are [angular; linear]. A kind is described in its canonical joint frame, in which
the axis of a revolute or prismatic joint and the normal of a planar joint is z. There the motion
subspace S consists of unit vectors, so that row numbers alone define it, and the constraint
space N (paper, after Eq. 7; N S = 0) by the rows that are left.
"""

from __future__ import annotations

from dataclasses import dataclass

_ABOUT_ANY_AXIS = ("damping", "rotor_inertia")


@dataclass(frozen=True)
class JointKind:
    """A kind of joint.

    Attributes:
        name: the name that plans and messages use.
        nq: numbers in its configuration q.
        nv: degrees of freedom, n_i in the paper.
        free: for each component of the joint velocity, in order, the row of the spatial velocity
            [angular; linear] (canonical frame) that it is; the columns of S are these unit vectors.
        has_axis: whether the URDF's <axis> has a meaning.
    """

    name: str
    nq: int
    nv: int
    free: tuple[int, ...]
    has_axis: bool

    def takes(self, effect: str) -> bool:
        """Return whether a passive effect has one meaning for all degrees of freedom.

        Args:
            effect: a field of ``Passive``. A spherical joint is damped, and has a rotor, about any
                axis alike; friction and springs are for one degree of freedom, and nothing is for
                freedoms that are partly angles, partly lengths.
        """
        return self.nv == 1 or (self.name == "spherical" and effect in _ABOUT_ANY_AXIS)

    @property
    def constrained(self) -> tuple[int, ...]:
        """The rows of the spatial velocity that the joint forbids, ascending: the rows of N."""
        return tuple(row for row in range(6) if row not in self.free)

    @property
    def quaternion(self) -> int | None:
        """Where in q the quaternion (x, y, z, w) starts, if the configuration has one."""
        return self.nq - 4 if self.nq >= 4 else None


REVOLUTE = JointKind("revolute", 1, 1, (2,), True)
PRISMATIC = JointKind("prismatic", 1, 1, (5,), True)
SPHERICAL = JointKind("spherical", 4, 3, (0, 1, 2), False)
PLANAR = JointKind("planar", 3, 3, (3, 4, 2), True)
FLOATING = JointKind("floating", 7, 6, (3, 4, 5, 0, 1, 2), False)

HELD = JointKind("held", 0, 0, (), False)
"""What a joint is to the forces when its acceleration is known: it frees nothing."""

KINDS = {kind.name: kind for kind in (REVOLUTE, PRISMATIC, SPHERICAL, PLANAR, FLOATING)}
