"""The lines of a certificate in shape kernels: one more sweep inwards (kernels/certify.hpp)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from adagen.emit.kernels import shared_bound
from adagen.emit.kernels.limb_spread import LimbSpread
from adagen.emit.symbols import Symbols
from adagen.plan import steps as do
from adagen.plan.limb_spread import spread_beyond
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Step
from adagen.program import Links, Operation
from adagen.program.runs import Run
from adagen.program.slots import Slots


def word(first: bool) -> str:
    """Return whether the inertia at a link is the first there, as a template argument."""
    return "true" if first else "false"


def blocks_of(slots: Slots, joints: Iterable[int]) -> list[tuple[str, str]]:
    """Return the first block of each range of slots that holds joints, and one past its last."""
    return [(f"block({a})", f"block({b}) + 1") for a, b in slots.ranges(joints)]


def links_looked_at(step: Step) -> set[int]:
    """Return the links whose accelerations are compared between processes."""
    if not isinstance(step, do.Certify):
        return set()
    shares = [*step.hears, *([] if step.tells is None else [step.tells])]
    return {link for share in shares for link in share.links}


class ResidualSweep:
    """The operations of a process as lines that sweep the residuals of its answer.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        p: the process that the calls name.
        slots: where joints lie in memory.
    """

    def __init__(self, symbols: Symbols, p: int, slots: Slots) -> None:
        self.symbols, self.p, self.slots = symbols, p, slots
        self.joints = symbols.plan.joints

    def lines(self, step: Step, operations: Sequence[Operation]) -> list[str]:
        """Return the lines of a step that certifies or refines, block by block.

        Args:
            step: the step.
            operations: all of the process.
        """
        weigh = {
            "link_inertia": self._links,
            "place_inertia": self._placed,
            "free_base": self._free_base,
            "articulate": self._sweep,
            "solve_root": self._root,
            "receive": self._received,
            "hold_mobility": self._held,
            "clear_inertia": self._cleared,
            "solve_mobility": self._shown,
        }
        share = step if isinstance(step, do.Certify) else do.Certify()
        lines = ["begin_weighing(w);", *["begin_shared_weighing(w);"] * bool(share.hears)]
        self.hears = share.hears
        self.limb_spread = LimbSpread(self.symbols, self.slots, operations)
        self._look_at(operations)
        for op in operations:
            if op.does in weigh and _is_own(share, op):
                lines += weigh[op.does](op)
        if share.tells is not None:
            return lines
        end = "end_shared_weighing(w);" if share.hears else "end_weighing(w);"
        return [*lines, *shared_bound.sums(share), end]

    def _look_at(self, operations: Sequence[Operation]) -> None:
        """Find the links whose joint is swept outwards, and the held link."""
        steps = [step for op in operations for step in op.steps]
        swept = [step for step in steps if isinstance(step, do.Articulate)]
        self.forward = {step.joint + 1 for step in swept if not step.reversed}
        self.held = {step.link for step in steps if isinstance(step, do.LoadRoot)}
        self.steps = steps

    def _links(self, operation: Operation) -> list[str]:
        assert isinstance(operation.block, Links)
        blocks = blocks_of(self.slots, (link - 1 for link in operation.block.numbers))
        return [f"weigh_links<{self.p}, {a}, {b}>(w);" for a, b in blocks]

    def _placed(self, operation: Operation) -> list[str]:
        assert isinstance(operation.block, Links)
        (link,) = operation.block.numbers
        whole = word(link not in self.forward)
        placed = f"weigh_placed<{link}, {word(operation.first[0])}, {whole}>(w);"
        return [placed, *[f"weigh_load<{link}>(w);"] * (link in self.held)]

    def _held(self, operation: Operation) -> list[str]:
        (step,) = operation.steps
        assert isinstance(step, do.HoldMobility)
        return ["begin_rest(w);", *self._beyond(step.link, f"weigh_held<{step.link}>(w, {{}});")]

    def _beyond(self, link: int, call: str) -> list[str]:
        """A call with the energy bounds of everything beyond a link."""
        limbs = spread_beyond(self.symbols.plan, self.steps, link)
        return self.limb_spread.lines(limbs, link, call.format, self.hears)

    def _cleared(self, operation: Operation) -> list[str]:
        """Residuals at a link of known mobility come after those of its ground's side."""
        assert isinstance(operation.block, Links)
        held = self.held.intersection(operation.block.numbers)
        return ["begin_rest(w);"] if held else []

    def _shown(self, operation: Operation) -> list[str]:
        (step,) = operation.steps
        assert isinstance(step, do.SolveMobility)
        if step.link not in self.held:
            return []
        phi = self.symbols.block(step.block)
        return self._beyond(step.link, f"weigh_shown<{self.p}, {step.link}>(w, {phi}, {{}});")

    def _free_base(self, operation: Operation) -> list[str]:
        assert isinstance(operation.block, Run)
        return [f"weigh_free_base<{operation.block.first}, {word(operation.first[0])}>(w);"]

    def _root(self, operation: Operation) -> list[str]:
        (step,) = operation.steps
        assert isinstance(step, do.SolveRoot)
        return [f"weigh_root<{self.p}, {step.link}>(w);"]

    def _received(self, operation: Operation) -> list[str]:
        """Residuals of other processes' limbs come where their inertias came."""
        if shared_bound.tells(self.symbols, operation):
            return []
        return shared_bound.at_links(self.symbols, operation)

    def _sweep(self, operation: Operation) -> list[str]:
        block, first = operation.block, operation.first
        if isinstance(block, Limbs):
            sweep = f"weigh_group<{self.p}, kLimbs{self.slots.numbers[block]}>(w);"
            nears = [self.joints[j].parent for j in block.rows[0]]
            left = [
                f"  leave_left<{word(first[k])}>(w, {near}, lane(X, {k + block.idle}));"
                for k, near in enumerate(nears)
                if near > 0
            ]
            return ["{", f"  const auto X = {sweep}", *left, "}"] if left else [sweep]
        assert isinstance(block, Run)
        ends = f"{self.p}, {block.first}, {block.last}, {word(first[0])}"
        verb = "weigh_reversed" if block.reversed else "weigh"
        return [f"{verb}<{ends}>(w);  // {self.symbols.span(block.first, block.last)}"]


def _is_own(share: do.Certify, operation: Operation) -> bool:
    """Whether an operation belongs to a process's part of a certificate."""
    if operation.does == "receive":
        return bool(share.hears)
    swept = next(iter(operation.steps), None)
    if not share.joints or not isinstance(swept, do.Articulate | do.FreeBase | do.SolveRoot):
        return True
    joint = swept.link - 1 if isinstance(swept, do.SolveRoot) else swept.joint
    return joint in share.joints
