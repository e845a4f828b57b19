"""Disjoint sets that are merged, each represented by one of its members (union-find)."""

from __future__ import annotations

from collections.abc import Hashable
from typing import Generic, TypeVar

Item = TypeVar("Item", bound=Hashable)


class UnionFind(Generic[Item]):
    """The leader of each item's set; at first every item is a set of its own."""

    def __init__(self) -> None:
        self._above: dict[Item, Item] = {}  # another item of the same set, nearer to its leader

    def of(self, item: Item) -> Item:
        """Return the leader of an item's set."""
        path = []
        while (above := self._above.get(item)) is not None:
            path.append(item)
            item = above
        self._above.update((each, item) for each in path)  # shorter next time
        return item

    def join(self, below: Item, above: Item) -> None:
        """Put two sets, other ones or the same, under the leader of the second item."""
        below, above = self.of(below), self.of(above)
        if below != above:
            self._above[below] = above
