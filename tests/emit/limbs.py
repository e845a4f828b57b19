"""Robots with limbs of the same kinds of joints, which have nothing else in common."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from adagen.model import BASE, FLOATING, REVOLUTE, JointKind, Model
from adagen.plan import Plan
from adagen.plan.simd_groups import Limbs
from tests.models import Part, assemble, random_inertia, random_rotation


@dataclass(frozen=True)
class Alike:
    """A robot and which limbs go together."""

    model: Model
    names: tuple[tuple[str, ...], ...]

    def limbs(self, plan: Plan) -> Limbs:
        """Return them by the numbers of their joints."""
        number = {joint.name: j for j, joint in enumerate(plan.joints)}
        return Limbs(tuple(tuple(number[name] for name in row) for row in self.names))


def alike(
    rng: np.random.Generator,
    count: int,
    kinds: Sequence[JointKind],
    *,
    trunk: int = 2,
    floating: bool = True,
    oblique: bool = True,
    beside: int = 0,
) -> Alike:
    """Return a trunk with limbs of one sequence of kinds.

    Args:
        rng: where axes, offsets, inertias, and the trunk links that limbs hang on, come from.
        count: how many limbs.
        kinds: of a limb's joints, the innermost first.
        trunk: joints of the trunk; limbs hang on their links, and on the ground if it is fixed.
        floating: whether the first of these floats.
        oblique: whether axes and rotations are of any direction instead of coordinate axes.
        beside: further joints that hang on links of limbs.
    """

    def part(name: str, above: str | None, kind: JointKind) -> Part:
        turn = random_rotation(rng) if oblique else np.eye(3)[rng.permutation(3)]
        turn = turn * np.linalg.det(turn)
        axis = rng.normal(size=3) if oblique else np.eye(3)[rng.integers(3)]
        place = rng.uniform(-0.3, 0.3, size=3)
        return Part(
            name, above, kind, random_inertia(rng), place, turn, axis / np.linalg.norm(axis)
        )

    parts = [part(BASE, None, FLOATING)] if floating else [part("trunk0", None, REVOLUTE)]
    parts += [part(f"trunk{k}", parts[0].name, REVOLUTE) for k in range(1, trunk)]
    roots = [each.name for each in parts] + [None] * (not floating)
    rows = [tuple(f"limb{n}_{k}" for n in range(count)) for k in range(len(kinds))]
    for n in range(count):
        above = roots[int(rng.integers(len(roots)))]
        for row, kind in zip(rows, kinds, strict=True):
            parts.append(part(row[n], above, kind))
            above = row[n]
    for k in range(beside):
        row = rows[int(rng.integers(len(rows)))]
        parts.append(part(f"beside{k}", row[int(rng.integers(count))], REVOLUTE))
    return Alike(assemble("alike", parts, floating), tuple(rows))
