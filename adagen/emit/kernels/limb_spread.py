"""Energy bounds of limbs that move as one body, in shape kernels (adagen/plan/limb_spread.py).

See templates/include/adagen/kernels/shared_bound.hpp.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from adagen.emit.symbols import Symbols
from adagen.plan.limb_spread import Spread
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Share
from adagen.program import Operation
from adagen.program.slots import Slots


@dataclass(frozen=True)
class _Lane:
    """A joint's place among limbs side by side: their number, and the joint's lane and row."""

    limbs: int
    side: int
    row: int


class LimbSpread:
    """Writes calls with two arguments, the energy bounds for rotation and for translation.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        slots: where joints lie in memory.
        operations: all of the process.
    """

    def __init__(self, symbols: Symbols, slots: Slots, operations: Iterable[Operation]) -> None:
        self.symbols, self.joints = symbols, symbols.plan.joints
        self.lanes = {
            j: _Lane(slots.numbers[op.block], side, k)
            for op in operations
            if op.does == "articulate" and isinstance(op.block, Limbs)
            for k, row in enumerate(op.block.rows)
            for side, j in enumerate(row, start=op.block.idle)
        }

    def lines(
        self, limbs: Spread, link: int, call: Callable[[str], str], hears: Sequence[Share] = ()
    ) -> list[str]:
        """Return the lines of a call.

        Args:
            limbs: constants of the bounds.
            link: the limbs' link.
            call: the call with its last arguments.
            hears: what other processes tell of their limbs.
        """
        number = self.symbols.printer.number
        terms = [number(limbs.turning)]
        terms += [f"{number(scale)} * w.q[{k}] * w.q[{k}]" for k, scale in limbs.along]
        turning, sliding = " + ".join(terms), number(limbs.sliding)
        if not limbs.distances and not limbs.hears:
            return [call(f"{turning}, {sliding}")]
        told = [
            (far, f"w.heard[{k}] + kSums + {place} * kAtLink")
            for k, share in enumerate(hears)
            for place, far in enumerate(share.links)
        ] * limbs.hears
        return [
            f"{{  // what limbs of {self.symbols.quoted_link(link)} take for moving with it",
            f"  Value turning = {turning}, sliding = {sliding};",
            *(f"  {line}" for line in self._distances(limbs, link, dict(told))),
            *(f"  {line}" for line in _told(told, link)),
            f"  {call('turning, sliding')}",
            "}",
        ]

    def _distances(self, limbs: Spread, link: int, told: Mapping[int, str]) -> Iterator[str]:
        """Yield the lines that add squares of distances, run by run."""
        joints = [far - 1 for far, _ in limbs.distances]
        near = {self.joints[j].parent for j in joints if self.joints[j].parent != j}
        for run in self._runs(joints, near | set(told)):
            parent, far = self.joints[run[0]].parent, run[-1] + 1
            kept = far in told or any(self.joints[j].parent == far for j in joints)
            start = "{}" if parent == link else f"p_{parent}"
            found = f"const Vector<Value> p_{far} = " if kept else ""
            yield f"{found}{self._call(run)}(w, {start}, turning);"

    def _runs(self, joints: Iterable[int], ends: set[int]) -> Iterator[list[int]]:
        """Yield runs of joints, each on the link of the one before, up to some links."""
        run: list[int] = []
        for j in joints:
            if run and not (self._follows(run[-1], j) and run[-1] + 1 not in ends):
                yield run
                run = []
            run.append(j)
        if run:
            yield run

    def _follows(self, before: int, j: int) -> bool:
        """Whether a joint lies behind another one, in memory too."""
        if self.joints[j].parent != before + 1 or j != before + 1:
            return False
        one, other = self.lanes.get(before), self.lanes.get(j)
        if one is None or other is None:
            return one is other
        return other == _Lane(one.limbs, one.side, one.row + 1)

    def _call(self, run: Sequence[int]) -> str:
        first, last = self.lanes.get(run[0]), self.lanes.get(run[-1])
        if first is None or last is None:
            return f"spread_along<{run[0]}, {run[-1]}>"
        return f"spread_in_lane<kLimbs{first.limbs}, {first.side}, {first.row}, {last.row}>"


def _told(told: Iterable[tuple[int, str]], link: int) -> Iterator[str]:
    """Yield the lines that add what other processes tell of their limbs."""
    for far, place in told:
        at = "" if far == link else f"p_{far}, "
        yield f"spread_told({place}, {at}turning, sliding);"
