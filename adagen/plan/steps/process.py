"""Steps of every form: kinematics, messages, slaved joints, outputs, refinement, certificates."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar

from adagen.plan.steps.names import KinematicsStep, OutwardStep, Passage, What

_OPTIONAL = {"optional": True}  # fields that are not written where they have their default


@dataclass(frozen=True)
class Kinematics(KinematicsStep):
    """Transform and velocity of a joint's child link."""

    does: ClassVar[str] = "kinematics"
    about: ClassVar[str] = "placement, velocity and reference acceleration of its link"
    about_row: ClassVar[str] = "placement, velocity and reference acceleration of their links"

    joint: int


@dataclass(frozen=True)
class Traverse(KinematicsStep):
    """Passage of a run: pose and motion of its last link relative to the link before it."""

    does: ClassVar[str] = "traverse"
    about: ClassVar[str] = "motion of their last link, relative to the link that they hang on"

    passage: Passage


@dataclass(frozen=True)
class Append(KinematicsStep):
    """Passage of two successive runs, from the passages of both.

    Attributes:
        passage: of both together.
        near: of the inner run.
        far: of the outer run.
    """

    does: ClassVar[str] = "append"
    about: ClassVar[str] = "motion of their last link, from those of both parts"

    passage: Passage
    near: Passage
    far: Passage


@dataclass(frozen=True)
class Arrive(KinematicsStep):
    """Motion of a run's last link, from that of the link before the run and its passage.

    Attributes:
        passage: of the run.
        near: the link before its first joint; 0 is the ground.
    """

    does: ClassVar[str] = "arrive"
    about: ClassVar[str] = "placement, velocity and reference acceleration of their last link"

    passage: Passage
    near: int


@dataclass(frozen=True)
class Send:
    """Hand a message to its target."""

    stage: ClassVar[What] = "send"
    does: ClassVar[str] = "send"
    about: ClassVar[str] = "message sent"

    message: int


@dataclass(frozen=True)
class Receive:
    """Wait for a message."""

    stage: ClassVar[What] = "receive"
    does: ClassVar[str] = "receive"
    about: ClassVar[str] = "message received"

    message: int


@dataclass(frozen=True)
class GiveOutput(OutwardStep):
    """One of the plan's outputs beside accelerations."""

    does: ClassVar[str] = "output"
    about: ClassVar[str] = "outputs other than accelerations"

    output: int


@dataclass(frozen=True)
class SolveCoupling:
    """Coupling torques of slaved joints, from all processes' accelerations."""

    stage: ClassVar[What] = "slaved"
    does: ClassVar[str] = "solve_coupling"
    about: ClassVar[str] = "coupling torques of slaved joints"


@dataclass(frozen=True)
class ApplyCoupling:
    """Adds the effect of the coupling torques to this process's accelerations."""

    stage: ClassVar[What] = "slaved"
    does: ClassVar[str] = "apply_coupling"
    about: ClassVar[str] = "accelerations with the coupling torques"


@dataclass(frozen=True)
class Correct(OutwardStep):
    """Repeats steps of the process for the residuals of its answer: part of a correction.

    Kinematics and factors are those of the answer. Messages between such parts have steps of their
    own.

    Attributes:
        round: number of the correction, from 0.
        first: index of the first of these steps.
        last: one past the last of them.
    """

    does: ClassVar[str] = "correct"
    about: ClassVar[str] = "correction from the residuals of equations of motion and loops"

    round: int
    first: int
    last: int


@dataclass(frozen=True)
class Refine(OutwardStep):
    """The answer, corrected by the residuals of the equations of motion.

    Loops do all of it in this step; straight lines have steps ``Correct`` before it.

    Attributes:
        count: number of corrections.
    """

    count: int
    does: ClassVar[str] = "refine"
    about: ClassVar[str] = "corrections from the residuals of the equations of motion"


@dataclass(frozen=True)
class Share:
    """The part of a certificate that one process computes and another one needs.

    Attributes:
        process: the process that computes it.
        links: core links to which its limbs are attached, ascending.
    """

    process: int
    links: tuple[int, ...]


@dataclass(frozen=True)
class Certify(OutwardStep):
    """A bound of the answer's error, from the residuals of the equations of motion.

    Attributes:
        joints: joints whose part the process computes, ascending; none stands for all.
        tells: the part that it sends, if another process finishes the certificate.
        hears: the parts that it receives from other processes.
        looped: rows of joints whose residuals a loop sweeps in a straight line, from the outermost.
    """

    does: ClassVar[str] = "certify"
    about: ClassVar[str] = "bound of the answer's error"

    joints: tuple[int, ...] = field(default=(), metadata=_OPTIONAL)
    tells: Share | None = field(default=None, metadata=_OPTIONAL)
    hears: tuple[Share, ...] = field(default=(), metadata=_OPTIONAL)
    looped: int = field(default=0, metadata=_OPTIONAL)
