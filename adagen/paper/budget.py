"""Budgets of a search, and recursion without a deep call stack."""

from __future__ import annotations

from collections.abc import Generator
from time import monotonic
from typing import Any, TypeVar

T = TypeVar("T")


class OutOfBudget(Exception):
    """The search has used up what it was given."""


class Budget:
    """What a search may spend.

    Args:
        expansions: partial chains or search nodes; the same on every machine.
        deadline: on the monotonic clock; None for no such limit.
    """

    def __init__(self, expansions: int, deadline: float | None = None) -> None:
        self.left = expansions
        self.expanded = 0
        self._deadline = deadline

    def spend(self) -> None:
        """Count one expansion.

        Raises:
            OutOfBudget: there is nothing left.
        """
        self.expanded += 1
        self.left -= 1
        if self.left < 0:
            raise OutOfBudget
        if self._deadline is not None and monotonic() > self._deadline:
            raise OutOfBudget


Task = Generator[Any, Any, T]


def run(task: Task[T]) -> T:
    """Run a generator that yields the generators whose results it needs."""
    stack: list[Task[Any]] = [task]
    value: Any = None
    while True:
        try:
            request = stack[-1].send(value)
        except StopIteration as done:
            stack.pop()
            value = done.value
            if not stack:
                return value  # type: ignore[no-any-return]
        else:
            stack.append(request)
            value = None
