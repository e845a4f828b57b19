"""Steps of closed loops.

A *closure* is a set of loops and couplings that share joints. Its *unknowns* are the accelerations
of its joints, freedom by freedom, then the constraint forces of its rows. They are carried inwards
with the articulated inertia to the closure's top, the last link that all its joints have in common,
and are eliminated there. Links above the top are not affected.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar


@dataclass(frozen=True)
class CloseLoop:
    """A loop's rows, as they act on its two links; refuses a state in which the loop is open.

    Attributes:
        loop: its number in the plan.
        closure: of which closure.
        rows: which of its constraints are kept, by number; others follow from these.
        first: number of the first one's force among the closure's unknowns.
    """

    does: ClassVar[str] = "close_loop"
    about: ClassVar[str] = "directions in which a loop holds its two links"

    loop: int
    closure: int
    rows: tuple[int, ...]
    first: int


@dataclass(frozen=True)
class CloseCoupling:
    """Likewise of a coupling, whose row is its factors; one that follows from others is kept out.

    Attributes:
        coupling: its number in the plan.
        closure: of which closure.
        unknown: number of its force among the closure's unknowns; None where it follows.
    """

    does: ClassVar[str] = "close_coupling"
    about: ClassVar[str] = "constraint that couples joints"

    coupling: int
    closure: int
    unknown: int | None


@dataclass(frozen=True)
class HoldBack:
    """A joint is passed as if it were rigid; its acceleration becomes an unknown.

    Attributes:
        joint: the joint.
        closure: of which closure.
        first: number of its first freedom among the closure's unknowns.
    """

    does: ClassVar[str] = "hold_back"
    about: ClassVar[str] = "inertia and bias force of what is beyond, its own motion left open"
    about_row: ClassVar[str] = "inertia and bias force of what is beyond, their motion left open"

    joint: int
    closure: int
    first: int


@dataclass(frozen=True)
class CarryRows:
    """What a closure holds back beyond a joint that was articulated, through that joint."""

    does: ClassVar[str] = "carry_rows"
    about: ClassVar[str] = "constraint forces of loops beyond it"
    about_row: ClassVar[str] = "constraint forces of loops beyond them"

    joint: int
    closure: int


@dataclass(frozen=True)
class Eliminate:
    """The unknowns of a closure are eliminated at its top.

    Where all joints of the closure are held back, some accelerations follow from the others by the
    kept rows, z = G y + g; where the ground is at the other end of its loops, from that of the top,
    too, z = A a + G y + g. Or all follow from what is orthogonal to the rows, w = N y + g, which is
    more arithmetic, and loses nothing where every choice of z is poor. What y says has a positive
    definite inertia. Where joints were articulated in between, rows push each other through these,
    and all unknowns are solved for at once.

    Attributes:
        link: the top; 0 is the ground.
        closure: the closure.
        moved: accelerations z that follow, as many as rows; none: by an orthogonal basis N.
        rows: forces of the kept rows.
        scales: of these rows, powers of two that bring them to a size.
        followers: forces of rows that follow from these: they are looked at, and left out.
        singles: the other accelerations.
        limit: on the size of G, beyond which digits would be lost in this pose.
        recovers: whether there is another way to fall back on.
        grounded: whether its rows act on the top, too: the ground is at their other end.
    """

    does: ClassVar[str] = "eliminate"
    about: ClassVar[str] = "accelerations and constraint forces of loops below it are eliminated"

    link: int
    closure: int
    moved: tuple[int, ...]
    rows: tuple[int, ...]
    scales: tuple[float, ...]
    followers: tuple[int, ...]
    singles: tuple[int, ...]
    limit: float
    recovers: bool
    grounded: bool = field(default=False, metadata={"optional": True})


@dataclass(frozen=True)
class Release:
    """The unknowns of a closure from the acceleration of its top."""

    does: ClassVar[str] = "release"
    about: ClassVar[str] = "accelerations and constraint forces of loops below it"

    link: int
    closure: int


@dataclass(frozen=True)
class AccelerateHeld:
    """The acceleration of the link beyond a joint that was held back."""

    does: ClassVar[str] = "accelerate_held"
    about: ClassVar[str] = "acceleration of the link beyond it"
    about_row: ClassVar[str] = "accelerations of the links beyond them"

    joint: int
    closure: int


ClosedStep = CloseLoop | CloseCoupling | HoldBack | CarryRows | Eliminate | Release | AccelerateHeld
"""Steps of closed loops."""
