"""Processes by turns: each as far as it comes without a message that is not there yet."""

from __future__ import annotations

from collections.abc import Callable, Mapping


def by_turns(lengths: Mapping[int, int], advance: Callable[[int, int], bool]) -> dict[int, int]:
    """Return how far each process comes; less than its length where all wait for each other.

    Args:
        lengths: how much each process has to do, by its number.
        advance: does what is at a place of a process, given both; returns False where the process
            has to wait for another one.
    """
    at = dict.fromkeys(lengths, 0)
    moved = True
    while moved:
        moved = False
        for p, length in lengths.items():
            while at[p] < length and advance(p, at[p]):
                at[p] += 1
                moved = True
    return at
