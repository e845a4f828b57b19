"""Rigid links: their inertia, and the frames of what is fixed to them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Inertia:
    """Mass distribution of a rigid link.

    Attributes:
        mass: kg.
        com: centre of mass in link coordinates, shape (3,), m.
        tensor: rotational inertia about the centre of mass in link axes, shape (3, 3), kg m^2.
    """

    mass: float
    com: Array
    tensor: Array

    @staticmethod
    def zero() -> Inertia:
        """Return the inertia of a link without mass."""
        return Inertia(0.0, np.zeros(3), np.zeros((3, 3)))


@dataclass(frozen=True, eq=False)
class Frame:
    """Where the frame of a link is that is fixed to another one.

    Attributes:
        name: the fixed link's name.
        rotation: its axes in the other link's frame, shape (3, 3).
        translation: its origin in the other link's frame, shape (3,), m.
    """

    name: str
    rotation: Array
    translation: Array


@dataclass(frozen=True, eq=False)
class Link:
    """A rigid link.

    Attributes:
        name: its name in the robot description.
        inertia: of the link and all that is fixed to it.
        frames: of the links that fixed (or locked) joints hold to it.
    """

    name: str
    inertia: Inertia
    frames: tuple[Frame, ...] = ()

    @property
    def merged(self) -> tuple[str, ...]:
        """Names of the links that are fixed to it."""
        return tuple(frame.name for frame in self.frames)
