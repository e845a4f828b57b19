"""Steps of closed loops.

A *closure* is a set of loops and couplings that share joints. Its *unknowns* are the accelerations
of its joints, freedom by freedom, then the constraint forces of its rows. They are carried inwards
with the articulated inertia to the closure's top, the last link that all its joints have in common,
and are eliminated there. Links above the top are not affected.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar

from adagen.plan.steps.names import InwardStep, OutwardStep


@dataclass(frozen=True)
class CloseLoop(InwardStep):
    """The constraint rows of a loop at its two links; refuses a state in which the loop is open.

    Attributes:
        loop: its number in the plan.
        closure: number of its closure.
        rows: the kept rows, by number; the others are redundant.
        first: number of the first kept row's force among the closure's unknowns.
    """

    does: ClassVar[str] = "close_loop"
    about: ClassVar[str] = "constraint rows of a loop at its two links"

    loop: int
    closure: int
    rows: tuple[int, ...]
    first: int

    @staticmethod
    def of(loop: int, closure: int, rows: range, numbers: Mapping[int, int]) -> CloseLoop:
        """Return the step of a loop.

        Args:
            loop: its number.
            closure: number of its closure.
            rows: its rows among all constraints.
            numbers: of the unknown forces, by rows; those without are redundant.
        """
        kept = [row for row in rows if row in numbers]
        first = numbers[kept[0]] if kept else 0
        return CloseLoop(loop, closure, tuple(row - rows.start for row in kept), first)


@dataclass(frozen=True)
class CloseCoupling(InwardStep):
    """The constraint row of a coupling: its factors. A redundant one is only checked.

    Attributes:
        coupling: its number in the plan.
        closure: number of its closure.
        unknown: number of its force among the closure's unknowns; None if it is redundant.
    """

    does: ClassVar[str] = "close_coupling"
    about: ClassVar[str] = "constraint row of a coupling"

    coupling: int
    closure: int
    unknown: int | None


@dataclass(frozen=True)
class HoldBack(InwardStep):
    """Inward sweep through a joint without elimination: its acceleration becomes an unknown.

    Attributes:
        joint: the joint.
        closure: number of its closure.
        first: number of its first freedom among the closure's unknowns.
    """

    does: ClassVar[str] = "hold_back"
    about: ClassVar[str] = (
        "inertia and bias force of what is beyond; its acceleration is an unknown"
    )
    about_row: ClassVar[str] = (
        "inertia and bias force of what is beyond; their accelerations are unknowns"
    )

    joint: int
    closure: int
    first: int


@dataclass(frozen=True)
class CarryRows(InwardStep):
    """Carries a closure's unknowns from beyond an eliminated joint through that joint."""

    does: ClassVar[str] = "carry_rows"
    about: ClassVar[str] = "constraint forces of loops beyond it"
    about_row: ClassVar[str] = "constraint forces of loops beyond them"

    joint: int
    closure: int


@dataclass(frozen=True)
class Eliminate(InwardStep):
    """Elimination of a closure's unknowns at its top.

    If all joints of the closure are unknowns, the dependent accelerations follow from the
    independent ones by the kept rows, z = G y + g; if the ground is at the other end of its loops,
    from that of the top, too, z = A a + G y + g. Or all accelerations follow from an orthogonal
    basis of the null space of the rows, w = N y + g: more arithmetic, but it loses no digits where
    every choice of z is poor. The inertia of y is positive definite. If joints of the closure were
    eliminated by the inward sweep, rows are coupled through them, and all unknowns are solved for
    at once.

    Attributes:
        link: the top; 0 is the ground.
        closure: number of the closure.
        moved: dependent accelerations z, as many as rows; none: use an orthogonal basis N.
        rows: forces of the kept rows.
        scales: powers of two that bring these rows to one size.
        followers: forces of redundant rows, which are only checked.
        singles: independent accelerations.
        limit: largest size of G; beyond it digits would be lost in this pose.
        recovers: whether there is another choice to fall back on.
        grounded: whether the ground is at the other end of its loops, so that rows act on the top.
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
class Release(OutwardStep):
    """The unknowns of a closure from the acceleration of its top."""

    does: ClassVar[str] = "release"
    about: ClassVar[str] = "accelerations and constraint forces of loops below it"

    link: int
    closure: int


@dataclass(frozen=True)
class AccelerateHeld(OutwardStep):
    """The acceleration of the link beyond a joint whose acceleration was an unknown."""

    does: ClassVar[str] = "accelerate_held"
    about: ClassVar[str] = "acceleration of the link beyond it"
    about_row: ClassVar[str] = "accelerations of the links beyond them"

    joint: int
    closure: int


ClosedStep = CloseLoop | CloseCoupling | HoldBack | CarryRows | Eliminate | Release | AccelerateHeld
"""Steps of closed loops."""
