"""Names of the buffers that steps read and set, and sorts of steps.

Five kinds of buffers are named, each in the memory of the process that computes or receives it:

* ``Block``: Phi_gh of a partial chain, 6x6, row handle g and column handle h (links), g <= h;
* ``Bias``: b_h of a partial chain, 6 numbers for each right-hand side;
* ``Force``: the wrench that acts on handle h of a partial chain from outside, likewise;
* ``Passage``: pose and motion of a run's last link relative to the link before it, 24 numbers;
* ``SideOfLoops``: the contribution of one of the trees between which loops close to their rows.

Handles are links, in the link's own frame: all joints at one link share its block, seen through
their constant or joint-dependent transforms. A partial chain is named by the joint that completed
it; ``joint is None`` names a bare link. Blocks between handles that are coupled only through the
ground do not exist.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal


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


@dataclass(frozen=True, order=True)
class Passage:
    """Pose and motion of the last link of joints ``first`` .. ``last``, a run.

    They are relative to the link before the run, as if that were at rest and all joint
    accelerations zero: orientation R (9 numbers), angular velocity and acceleration, position of
    the origin, its velocity and its acceleration (3 each), in axes of that link, SI units.
    """

    first: int
    last: int

    @property
    def link(self) -> int:
        """The link beyond the last joint."""
        return self.last + 1


@dataclass(frozen=True, order=True)
class SideOfLoops:
    """Contribution of one tree to the rows of a closure between separate trees.

    L, the accelerations of the rows for unit constraint forces (a symmetric matrix), and b, the
    accelerations of the rows without constraint forces, for each right-hand side.

    Attributes:
        closure: number of the closure.
        joints: all its joints on that side, ascending.
        rows: number of its rows.
    """

    closure: int
    joints: tuple[int, ...]
    rows: int


What = Literal["kinematics", "assembly", "disassembly", "slaved", "send", "receive"]


class KinematicsStep:
    """A step that computes poses and velocities."""

    stage: ClassVar[What] = "kinematics"


class InwardStep:
    """A step of the first sweep: assembly, and articulated bodies."""

    stage: ClassVar[What] = "assembly"


class OutwardStep:
    """A step of the second sweep, which finds accelerations, or of what follows it."""

    stage: ClassVar[What] = "disassembly"
