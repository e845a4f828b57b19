"""Parts of the bound of an answer's error that processes send to each other.

Each process sweeps the residuals of its own limbs to the core links; process 0 continues from
there. Each process has solved for the core by itself, so the core's accelerations may differ in the
last digits, and the answer contains those of process 0. The difference moves a limb as one body;
its energy is at most ``spread`` (adagen/plan/certificate.py), which is added as a length: with
|a + b|^2 <= 9/8 |a|^2 + 9 |b|^2.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.allowance import Allowance
from adagen.graph import Expression, total
from adagen.plan.certificate import spread
from adagen.plan.steps import Certify, Share

Array = NDArray[Any]


def told(found: Allowance, step: Certify, sums: Sequence[Expression]) -> Array:
    """Return the contents of a process's message: three sums, and the data of each core link."""
    assert step.tells is not None
    content = list(sums)
    for link in step.tells.links:
        for _, name in _kept(found):
            content += list(found.memory[name, link])
        content += list(found.memory["a", link][:, 0])
        content += spread_of(found, step.joints, link)
    return np.array(content, dtype=object)


def _kept(found: Allowance) -> list[tuple[int, str]]:
    """The numbers stored of a core link, by name, and how many they are."""
    return [(6, "left"), (4, "noise"), *([(4, "bare")] if found.bases else [])]


def spread_of(found: Allowance, joints: Sequence[int], link: int) -> list[Expression]:
    """Return the energy bounds of limbs at a link for relative rotation and translation."""
    graph, limbs = found.state.graph, spread(found.state.plan, joints, link)
    distances = [graph.input(f"q[{entry}]") * scale**0.5 for entry, scale in limbs.along]
    turning = total([graph.constant(limbs.turning), found.square(distances)])
    return [turning, graph.constant(limbs.sliding)]


class Heard:
    """The part of another process: adds its limbs' residuals to the core links.

    Attributes:
        seen: the square of what shows of the error.
        rounded: that of what may be rounding.
        energy: that of the answer.
        parted: squares of what the limbs take for moving with other accelerations.
    """

    def __init__(self, found: Allowance, share: Share) -> None:
        content = list(found.memory["share", share.process])
        self.seen, self.rounded, self.energy = content[:3]
        self.parted: list[Expression] = []
        place = 3
        for link in share.links:
            for count, name in _kept(found):
                own = np.array(content[place : place + count], dtype=object)
                found.state.rows.add(name, [link], 1, own)
                place += count
            a = np.array(content[place : place + 6], dtype=object)
            limbs = content[place + 6 : place + 8]
            place += 8
            self.parted += parting(found, a - found.memory["a", link][:, 0], limbs)


def parting(found: Allowance, apart: Array, limbs: Sequence[Expression]) -> list[Expression]:
    """Return squared energies of limbs for the difference of their link's acceleration."""
    turning, sliding = limbs
    return [turning * found.square(apart[:3]), sliding * found.square(apart[3:])]


def seen_with(seen: Expression, parted: Sequence[Expression]) -> Expression:
    """Return the square of a sum: of the residual error, and of the other parts."""
    return seen * 1.125 + total(parted) * 9
