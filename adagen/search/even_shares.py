"""First layouts: limbs distributed by their costs, before any bound."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

_ROUNDED = 1e-12
"""Share of a load that its rounding may be: less is no difference."""


def halves(processes: int) -> list[int]:
    """Return P, P / 2, P / 4, .. down to 2: more processes are not always faster."""
    found = [processes]
    while found[-1] > 3:
        found.append(found[-1] // 2)
    return found


@dataclass(frozen=True)
class EvenShares:
    """Limbs distributed evenly.

    Attributes:
        time: of the busiest process.
        shares: the numbers of each one's limbs; none is empty.
    """

    time: float
    shares: tuple[tuple[int, ...], ...]


def evenly(weights: Sequence[float], processes: int) -> EvenShares:
    """Distribute limbs, the heaviest first to the least busy process, then exchange some.

    Args:
        weights: what each limb takes.
        processes: P.
    """
    shares, loads = heaviest_first(weights, processes)
    while _exchange(weights, shares, loads):
        pass
    given = tuple(tuple(sorted(own)) for own in shares if own)
    return EvenShares(max(loads, default=0.0), given)


def heaviest_first(weights: Sequence[float], processes: int) -> tuple[list[list[int]], list[float]]:
    """Distribute limbs, the heaviest first, each to who has least.

    Returns:
        the numbers of each process's limbs, and what they take together.
    """
    shares: list[list[int]] = [[] for _ in range(processes)]
    loads = [0.0] * processes
    for k in sorted(range(len(weights)), key=lambda k: (-weights[k], k)):
        p = loads.index(min(loads))
        shares[p].append(k)
        loads[p] += weights[k]
    return shares, loads


def _exchange(weights: Sequence[float], shares: list[list[int]], loads: list[float]) -> bool:
    """Move a limb from the busiest process, perhaps in exchange, if both then take less."""
    busiest = loads.index(max(loads))
    for p in range(len(loads)):
        difference = loads[busiest] - loads[p]
        offers = product(shares[busiest], (None, *shares[p])) if p != busiest else ()
        best, least = None, difference * (1 - 1e-9) - _ROUNDED * loads[busiest]
        for give, take in offers:
            moved = weights[give] - (0.0 if take is None else weights[take])
            if abs(difference - 2 * moved) < least:
                best, least = (give, take, moved), abs(difference - 2 * moved)
        if best is not None:
            give, take, moved = best
            shares[busiest].remove(give)
            shares[p].append(give)
            if take is not None:
                shares[p].remove(take)
                shares[busiest].append(take)
            loads[busiest] -= moved
            loads[p] += moved
            return True
    return False
