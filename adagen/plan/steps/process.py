"""Steps of every form: kinematics, messages, slaved joints, outputs, refinement, certificates."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar

from adagen.plan.steps.names import Passage

_OPTIONAL = {"optional": True}  # fields that are not written where they have their default


@dataclass(frozen=True)
class Kinematics:
    """Transform and velocity of a joint's child link."""

    does: ClassVar[str] = "kinematics"
    about: ClassVar[str] = "placement, velocity and reference acceleration of its link"
    about_row: ClassVar[str] = "placement, velocity and reference acceleration of their links"

    joint: int


@dataclass(frozen=True)
class Traverse:
    """How a run of joints moves its last link, seen from the link that it hangs on."""

    does: ClassVar[str] = "traverse"
    about: ClassVar[str] = "motion of their last link, relative to the link that they hang on"

    passage: Passage


@dataclass(frozen=True)
class Append:
    """Two runs, one hanging on the last link of the other, as one.

    Attributes:
        passage: of both together.
        near: of the one that comes first.
        far: of the other.
    """

    does: ClassVar[str] = "append"
    about: ClassVar[str] = "motion of their last link, from those of both parts"

    passage: Passage
    near: Passage
    far: Passage


@dataclass(frozen=True)
class Arrive:
    """The motion of a run's last link from that of the link that it hangs on.

    Attributes:
        passage: how the run moves it.
        near: the link that the run hangs on; 0 is the ground.
    """

    does: ClassVar[str] = "arrive"
    about: ClassVar[str] = "placement, velocity and reference acceleration of their last link"

    passage: Passage
    near: int


@dataclass(frozen=True)
class Send:
    """Hand a message to its target."""

    does: ClassVar[str] = "send"
    about: ClassVar[str] = "message sent"

    message: int


@dataclass(frozen=True)
class Receive:
    """Wait for a message."""

    does: ClassVar[str] = "receive"
    about: ClassVar[str] = "message received"

    message: int


@dataclass(frozen=True)
class GiveOutput:
    """What is asked for beside accelerations: one of the plan's outputs."""

    does: ClassVar[str] = "output"
    about: ClassVar[str] = "outputs other than accelerations"

    output: int


@dataclass(frozen=True)
class SolveCoupling:
    """The torques that keep slaved joints in step, from all processes' accelerations."""

    does: ClassVar[str] = "solve_coupling"
    about: ClassVar[str] = "torques that keep slaved joints in step"


@dataclass(frozen=True)
class ApplyCoupling:
    """Add what these torques do to this process's accelerations."""

    does: ClassVar[str] = "apply_coupling"
    about: ClassVar[str] = "accelerations under these torques"


@dataclass(frozen=True)
class Correct:
    """Steps of the process again, for what its answer leaves over: part of a correction.

    Kinematics and factors are those of the answer. Messages between such parts have steps of their
    own.

    Attributes:
        round: of which correction, from 0.
        first: the first of these steps, by its place.
        last: one past the last of them.
    """

    does: ClassVar[str] = "correct"
    about: ClassVar[str] = "correction from the residuals of equations of motion and loops"

    round: int
    first: int
    last: int


@dataclass(frozen=True)
class Refine:
    """The answer, corrected by what its links' equations of motion leave over.

    Loops over runs do all of it here; in straight lines, corrections were found before.

    Attributes:
        count: how many times.
    """

    count: int
    does: ClassVar[str] = "refine"
    about: ClassVar[str] = "corrections from the residuals of the equations of motion"


@dataclass(frozen=True)
class Share:
    """What one process finds of a certificate that another one needs to finish it.

    Attributes:
        process: who finds it.
        links: where its limbs hang on what all processes solve for, ascending.
    """

    process: int
    links: tuple[int, ...]


@dataclass(frozen=True)
class Certify:
    """A bound of the answer's error, from what its links' equations of motion leave over.

    Attributes:
        joints: those whose share the process finds, ascending; none stands for all.
        tells: what it is for, where another process finishes the certificate.
        hears: what other processes have found.
    """

    does: ClassVar[str] = "certify"
    about: ClassVar[str] = "bound of the answer's error"

    joints: tuple[int, ...] = field(default=(), metadata=_OPTIONAL)
    tells: Share | None = field(default=None, metadata=_OPTIONAL)
    hears: tuple[Share, ...] = field(default=(), metadata=_OPTIONAL)
