"""Where the joints of shape kernels lie in memory: those that are passed together, side by side."""

from __future__ import annotations

from dataclasses import dataclass

from adagen.plan import Plan
from adagen.plan.abreast import Limbs, limbs_abreast

_BLOCK = {"double": 8, "float": 16}  # slots in a block of the widest registers


@dataclass(frozen=True)
class Layout:
    """The slots of all joints, and which limbs each process takes side by side.

    Attributes:
        slots: of each joint; the joint beyond which a link lies stands for the link too.
        count: number of slots, some of which may be empty.
        limbs: of each process.
    """

    slots: tuple[int, ...]
    count: int
    limbs: tuple[tuple[Limbs, ...], ...]

    @property
    def all_limbs(self) -> list[Limbs]:
        """The limbs of all processes, as they are numbered in emitted code."""
        return [limbs for own in self.limbs for limbs in own]

    @property
    def plain(self) -> bool:
        """Whether every joint lies at its own number."""
        return not self.all_limbs

    @staticmethod
    def of(plan: Plan, batch: bool) -> Layout:
        """Lay out a plan's joints; those of a batch have their lanes for states."""
        limbs = tuple(
            () if batch else tuple(limbs_abreast(plan, process)) for process in plan.processes
        )
        count = len(plan.joints)
        if not any(limbs):
            return Layout(tuple(range(count)), count, limbs)
        slots, next_ = [-1] * count, 0
        for process, own in zip(plan.processes, limbs, strict=True):
            next_ = -(-next_ // _BLOCK[plan.scalar]) * _BLOCK[plan.scalar]  # blocks of its own
            widest = sorted(own, key=lambda each: -each.count)  # so that all are aligned
            taken = [j for each in widest for j in each.members()]
            for j in (*taken, *(j for j in process.owns if j not in set(taken))):
                slots[j], next_ = next_, next_ + 1
        for j in range(count):
            if slots[j] < 0:
                slots[j], next_ = next_, next_ + 1
        return Layout(tuple(slots), next_, limbs)
