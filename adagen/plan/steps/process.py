"""Steps of every form: motion of the joints, messages, and slaved joints held in step."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Kinematics:
    """Transform and velocity of a joint's child link."""

    joint: int


@dataclass(frozen=True)
class Send:
    """Hand a message to its target."""

    message: int


@dataclass(frozen=True)
class Receive:
    """Wait for a message."""

    message: int


@dataclass(frozen=True)
class SolveCoupling:
    """The torques that keep slaved joints in step, from all processes' accelerations."""


@dataclass(frozen=True)
class ApplyCoupling:
    """Add what these torques do to this process's accelerations."""
