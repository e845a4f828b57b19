"""Values that a process computes all at once, in a list of their own."""

from __future__ import annotations

from typing import TypeVar

T = TypeVar("T")


class Placed(list[T]):
    """What functions are taken of, in order; what is asked for again is where it was."""

    def __init__(self) -> None:
        super().__init__()
        self._places: dict[tuple[T, ...], int] = {}

    def place_of(self, own: tuple[T, ...]) -> int:
        """Return where values lie, one for each lane, behind all others if they are new."""
        k = self._places.setdefault(own, len(self))
        if k == len(self):
            self.extend(own)
            for place, single in enumerate(own, start=k):
                self._places.setdefault((single,), place)
        return k
