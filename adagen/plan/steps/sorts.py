"""Sorts of steps: a stage of a process's work consists of successive steps of one sort."""

from __future__ import annotations

from typing import ClassVar, Literal

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
