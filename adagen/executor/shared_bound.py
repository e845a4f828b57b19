"""Parts of the bound of an answer's error that processes send to each other.

Each process sweeps the residuals of its own limbs to the core links; process 0 continues from
there. Each process has solved for the core by itself, so the core's accelerations may differ in the
last digits, and the answer contains those of process 0. The difference moves a limb as one body;
its energy is at most ``spread`` (adagen/plan/limb_spread.py), which is added as a length: with
|a + b|^2 <= 9/8 |a|^2 + 9 |b|^2.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.allowance import Allowance
from adagen.executor.frames import Transform
from adagen.graph import Expression, total
from adagen.plan.limb_spread import Spread, spread
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
        content += spread_of(found, spread(found.state.plan, step.joints, link), link)
    return np.array(content, dtype=object)


def _kept(found: Allowance) -> list[tuple[int, str]]:
    """The numbers stored of a core link, by name, and how many they are."""
    return [(6, "left"), (4, "noise"), *([(4, "bare")] if found.bases else [])]


def spread_of(
    found: Allowance, limbs: Spread, link: int, shares: Sequence[Heard] = ()
) -> list[Expression]:
    """Return the energy bounds of limbs at a link for relative rotation and translation.

    Args:
        found: the memory of the process.
        limbs: constants of the bounds.
        link: the limbs' link.
        shares: what other processes tell of their limbs.
    """
    graph = found.state.graph
    offsets = [graph.input(f"q[{entry}]") * scale**0.5 for entry, scale in limbs.along]
    ways = _Ways(found, link, {far for far, _ in limbs.distances})
    turning = [graph.constant(limbs.turning), found.square(offsets)]
    turning += [found.square(ways.to(far)) * scale for far, scale in limbs.distances]
    sliding = [graph.constant(limbs.sliding)]
    for far, (turns, slides) in (each for share in shares for each in share.limbs):
        if not limbs.hears:
            break
        if far == link:
            turning.append(turns)
            sliding.append(slides)
        else:
            turning += [turns, found.square(ways.to(far)) * (slides * 2)]
            sliding.append(slides * 2)
    return [total(turning), total(sliding)]


class _Ways:
    """Vectors from a link to links beyond it, in the axes of these.

    Args:
        found: the memory of the process.
        link: the first link.
        links: beyond it, with all between.
    """

    def __init__(self, found: Allowance, link: int, links: set[int]) -> None:
        self.state, self.links = found.state, links
        self.known: dict[int, Array] = {link: self.state.zeros(3)}

    def to(self, link: int) -> Array:
        """Return the vector to a link, shape (3,); finds those to links in its row with it."""
        if link not in self.known:
            self._find(link)
        return self.known[link]

    def _find(self, link: int) -> None:
        rows = self.state.rows
        lead = rows.name_of(link) - 1
        ends = [j + 1 for j in rows.lanes(lead)]
        near = [
            self.to(self.state.plan.joints[end - 1].parent)
            if end in self.links
            else self.state.zeros(3)
            for end in ends
        ]
        x: Transform = self.state.memory["X", lead]
        way = x.rotation.transposed().vector(rows.packed(near) + x.origin)
        for j, own in rows.apart(lead, way):
            if j + 1 in self.links:
                self.known[j + 1] = own


class Heard:
    """The part of another process: adds its limbs' residuals to the core links.

    Attributes:
        seen: the square of what shows of the error.
        rounded: that of what may be rounding.
        energy: that of the answer.
        parted: squares of what the limbs take for moving with other accelerations.
        limbs: links that limbs hang on, and their energy bounds there.
    """

    def __init__(self, found: Allowance, share: Share) -> None:
        content = list(found.memory["share", share.process])
        self.seen, self.rounded, self.energy = content[:3]
        self.parted: list[Expression] = []
        self.limbs: list[tuple[int, tuple[Expression, Expression]]] = []
        place = 3
        for link in share.links:
            for count, name in _kept(found):
                own = np.array(content[place : place + count], dtype=object)
                found.state.rows.add(name, [link], 1, own)
                place += count
            a = np.array(content[place : place + 6], dtype=object)
            limbs = content[place + 6 : place + 8]
            place += 8
            self.limbs.append((link, (limbs[0], limbs[1])))
            self.parted += parting(found, a - found.memory["a", link][:, 0], limbs)


def parting(found: Allowance, apart: Array, limbs: Sequence[Expression]) -> list[Expression]:
    """Return squared energies of limbs for the difference of their link's acceleration."""
    turning, sliding = limbs
    return [turning * found.square(apart[:3]), sliding * found.square(apart[3:])]


def seen_with(seen: Expression, parted: Sequence[Expression]) -> Expression:
    """Return the square of a sum: of the residual error, and of the other parts."""
    return seen * 1.125 + total(parted) * 9
