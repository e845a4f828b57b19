"""Places of joints in memory in shape kernels: joints that are computed together are adjacent."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

from adagen.plan import Plan
from adagen.plan.simd_groups import Limbs
from adagen.program.runs import OF_ONE_FREEDOM, Run
from adagen.program.strips import LANES, runs_in_strips, slots_of
from adagen.program.tiles import TILE, fits_tiles, tiles_of
from adagen.schedule.costs import StepCosts


@dataclass(frozen=True)
class Slots:
    """The slots of all joints, and the limbs side by side.

    Attributes:
        slots: of each joint; the joint beyond which a link lies stands for the link too.
        count: number of slots, some of which may be empty.
        limbs: those that each process takes side by side.
        in_strips: runs that are passed outwards in strips, outwards from the base.
        tile: joints that share memory with others as tiles of a run; 0 where all have their own.
    """

    slots: tuple[int, ...]
    count: int
    limbs: tuple[tuple[Limbs, ...], ...]
    in_strips: tuple[Run, ...]
    tile: int = 0

    @cached_property
    def numbers(self) -> dict[Limbs, int]:
        """The limbs of all processes in order, and how they are numbered in emitted code."""
        return {limbs: k for k, limbs in enumerate(chain.from_iterable(self.limbs))}

    def block_kinds(self, of: Sequence[object], width: int) -> tuple[list[int], list[int]]:
        """Blocks with equal constants: the kind of each, and the first block of each kind.

        Args:
            of: what tells the constants of each joint.
            width: slots of a block.

        Returns:
            Two empty lists where there are few blocks, or not half of them are like others.
        """
        blocks: list[list[object]] = [[None] * width for _ in range(-(-self.count // width))]
        for constants, slot in zip(of, self.slots, strict=True):
            blocks[slot // width][slot % width] = constants
        kinds: dict[tuple[object, ...], int] = {}
        first: list[int] = []
        found: list[int] = []
        for number, block in enumerate(map(tuple, blocks)):
            if block not in kinds:
                kinds[block] = len(first)
                first.append(number)
            found.append(kinds[block])
        alike = len(blocks) >= _MANY_BLOCKS and 2 * len(first) <= len(blocks)
        return (found, first) if alike else ([], [])

    @property
    def plain(self) -> bool:
        """Whether every joint lies at its own number; slots behind the last may be empty."""
        return self.slots == tuple(range(len(self.slots)))

    def ranges(self, joints: Iterable[int]) -> list[tuple[int, int]]:
        """First and last slots of ranges that hold joints and in which no block is empty."""
        found: list[tuple[int, int]] = []
        for slot in sorted(self.slots[j] for j in joints):
            if found and slot - found[-1][1] < _WIDEST:
                found[-1] = (found[-1][0], slot)
            else:
                found.append((slot, slot))
        return found

    @staticmethod
    def plainly(plan: Plan) -> Slots:
        """Slots equal to joint numbers, without limbs side by side."""
        count = len(plan.joints)
        return Slots(tuple(range(count)), count, ((),) * len(plan.processes), ())

    @staticmethod
    def of(
        plan: Plan,
        limbs: tuple[tuple[Limbs, ...], ...],
        costs: StepCosts,
        *,
        again: bool = False,
    ) -> Slots:
        """Lay out a plan's joints.

        Args:
            plan: the plan.
            limbs: those that each process takes side by side.
            costs: what the methods take that runs can be passed by.
            again: whether sweeps are done again, so that all joints keep what they are swept with.
        """
        in_strips, tile = tuple(runs_in_strips(plan, limbs, costs)), 0
        if not again and fits_tiles(plan, in_strips, costs):
            in_strips, tile = tuple(tiles_of(in_strips[0], TILE)), TILE
        count, width = len(plan.joints), LANES[plan.scalar]
        if not in_strips and not any(limbs):
            return Slots(tuple(range(count)), count, limbs, in_strips)
        slots = [-1] * count
        next_ = _lay_strips(in_strips, width, slots)
        for process, own in zip(plan.processes, limbs, strict=True):
            next_ = _up(next_, width)  # blocks of its own
            widest = sorted(own, key=lambda each: -each.lanes)  # so that all are aligned
            for side_by_side in widest:
                for row in side_by_side.rows:
                    for lane, j in enumerate(row, start=side_by_side.idle):
                        slots[j] = next_ + lane
                    next_ += side_by_side.lanes
            for j in _packed(plan, [j for j in process.owns if slots[j] < 0], next_):
                slots[j], next_ = next_, next_ + 1
        for j in range(count):
            if slots[j] < 0:
                slots[j], next_ = next_, next_ + 1
        return Slots(tuple(slots), next_, limbs, in_strips, tile)


def _packed(plan: Plan, joints: list[int], first: int) -> list[int]:
    """Order joints from a slot on so that those of one freedom lie in as few blocks as they can.

    Links beyond such joints are set up by columns, where those pay: all of a block or none.
    """
    one = [j for j in joints if plan.joints[j].kind in OF_ONE_FREEDOM]
    others = [j for j in joints if plan.joints[j].kind not in OF_ONE_FREEDOM]

    def blocks(order: list[int]) -> int:
        return len({slot // COLUMNS for slot, j in enumerate(order, first) if j in one})

    return min((joints, one + others, others + one), key=blocks)


def _lay_strips(in_strips: Iterable[Run], width: int, slots: list[int]) -> int:
    """Assign slots to the joints of runs in strips, and return the first free slot."""
    next_ = 0
    for run in in_strips:
        own_slots = slots_of(run, width)
        for j, slot in enumerate(own_slots, start=run.first):
            slots[j] = next_ + slot
        next_ = _up(next_ + max(own_slots) + 1, width)
    return next_


COLUMNS = 8
"""Slots whose links are set up by columns at once (set_up_columns, kernels/inward_columns.hpp)."""
_MANY_BLOCKS = 32
_WIDEST = 16  # joints in the widest block: two apart by less may share one


def _up(slot: int, width: int) -> int:
    """Return the start of the next block."""
    return -(-slot // width) * width
