"""Rigidly joined bodies: composed poses and lumped inertias, exact and rounded once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb

from adagen.exact import Exact, exact, identity, rotated_inertia, rounded
from adagen.model.links import Frame, Inertia

Part = tuple[arb, Exact, Exact]
"""Mass (kg), centre of mass (3,) and tensor about it (3, 3), all in one frame."""


@dataclass(frozen=True)
class Pose:
    """A frame in another one: x = rotation x' + translation, exact."""

    rotation: Exact
    translation: Exact

    @staticmethod
    def home() -> Pose:
        """Return the pose of a frame in itself."""
        return Pose(identity(), exact([0.0, 0.0, 0.0]))

    def then(self, rotation: Exact, translation: Exact) -> Pose:
        """Return the pose of a frame that has the given pose in this one."""
        shift = self.rotation.dot(translation) + self.translation
        return Pose(_middle(self.rotation.dot(rotation)), _middle(shift))

    def frame(self, name: str) -> Frame:
        """Return this pose as that of a named link, rounded."""
        return Frame(name, rounded(self.rotation), rounded(self.translation))

    def part(self, inertia: Inertia) -> Part:
        """Return the masses of a body whose frame is at this pose."""
        return self.moved((arb(inertia.mass), exact(inertia.com), exact(inertia.tensor)))

    def moved(self, part: Part) -> Part:
        """Return masses given in the frame at this pose as seen in the outer frame."""
        mass, com, tensor = part
        com = self.rotation.dot(com) + self.translation
        return mass, _middle(com), _middle(rotated_inertia(self.rotation, tensor))


def _middle(values: Exact) -> Exact:
    """Drop the error bounds: along a chain of fixed joints they grow far faster than the errors."""
    result = np.empty(values.shape, dtype=object)
    for index, value in np.ndenumerate(values):
        result[index] = value.mid()
    return result


def lump(parts: Sequence[Part]) -> Inertia:
    """Return the inertia of several rigidly joined masses, all in the same frame.

    Sums are exact and rounded once. The centre of mass of a body without mass is the origin.
    """
    if not parts:
        return Inertia.zero()
    massive = [part for part in parts if part[0] != 0]
    mass = sum((m for m, _, _ in parts), arb(0))
    if len(massive) == 1:  # one part alone keeps its numbers, and its zeros, to the bit
        com = massive[0][1]
    elif massive:
        com = sum((m * c for m, c, _ in massive), exact([0.0, 0.0, 0.0])) / mass
    else:
        com = exact([0.0, 0.0, 0.0])
    tensor = exact(np.zeros((3, 3)))
    for m, c, about_c in parts:
        tensor = tensor + about_c
        if len(massive) > 1 and m != 0:
            d = c - com
            tensor = tensor + m * (identity() * d.dot(d) - np.outer(d, d))
    tensor = (tensor + tensor.T) / 2
    return Inertia(float(mass), rounded(com), rounded(tensor))
