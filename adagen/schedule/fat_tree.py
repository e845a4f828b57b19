"""Machines in levels, a fat tree: cores of a node, nodes under a switch, switches under a core.

Links are as wide upwards as downwards, so that a message waits for no other. What it costs is
decided by the lowest level that holds both ends.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib import resources
from math import prod
from pathlib import Path

from adagen.errors import InputError
from adagen.schedule.costs import CHANNEL_KEYS, LIMIT, ChannelCosts
from adagen.schedule.hosts import Host
from adagen.tomlfile import parse_toml

Links = Callable[[int, int], ChannelCosts | None]
"""What a message costs from one process to another; None where they share memory."""

Network = Callable[[int, int], ChannelCosts]
"""What a message costs from one host to another one."""

MOST = 1 << 16
"""Processes that a fabric has at most."""


@dataclass(frozen=True)
class Level:
    """A level of a fabric.

    Attributes:
        name: what people call it.
        size: how many of the level below it holds; the lowest one: processes.
        costs: of a message that passes it; None of the lowest, whose processes share memory.
    """

    name: str
    size: int
    costs: ChannelCosts | None


@dataclass(frozen=True)
class Fabric:
    """Levels from the lowest up. Processes fill it in order: 0 .. size - 1 are on node 0."""

    levels: tuple[Level, ...]

    @property
    def processes(self) -> int:
        """How many processes it has room for."""
        return prod(level.size for level in self.levels)

    @property
    def hosts(self) -> tuple[Host, ...]:
        """The nodes, in order."""
        cores, *above = (level.size for level in self.levels)
        return tuple(Host(f"{self.levels[0].name}{k}", cores) for k in range(prod(above)))

    def level(self, a: int, b: int) -> Level:
        """Return the lowest level that contains two processes."""
        for level in self.levels:
            a, b = a // level.size, b // level.size
            if a == b:
                return level
        raise ValueError("a process that the fabric has no room for")

    def links(self, a: int, b: int) -> ChannelCosts | None:
        """Return the costs of a message between two processes; None where they share memory."""
        return self.level(a, b).costs

    def network(self, a: int, b: int) -> ChannelCosts:
        """Return the costs of a message between two nodes, by their numbers."""
        cores = self.levels[0].size
        costs = self.links(a * cores, b * cores)
        assert costs is not None  # of two nodes, not of one
        return costs


def between_hosts(places: Sequence[int], network: Network) -> Links:
    """Return the links of processes by the numbers of their hosts.

    Args:
        places: of each process, the number of its host.
        network: between hosts.
    """

    def links(a: int, b: int) -> ChannelCosts | None:
        return None if places[a] == places[b] else network(places[a], places[b])

    return links


def read_fabric(path: Path) -> Fabric:
    """Return the fabric of a TOML file (docs/how_to/hosts.md), which is read strictly.

    Raises:
        InputError: it cannot be read, or is none; the message names the line where it can.
    """
    try:
        return parse_fabric(path.read_text("utf-8"), str(path))
    except UnicodeDecodeError:
        raise InputError("a file of levels must be UTF-8 text", str(path)) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or "not a usable path"
        raise InputError(f"cannot read the levels: {reason}", str(path)) from None


def shipped_fabric() -> Fabric:
    """Return the fat tree that comes with adagen: assumed, not measured."""
    file = resources.files("adagen.schedule") / "profiles" / "fat_tree.toml"
    return parse_fabric(file.read_text("utf-8"), "fat_tree.toml")


def parse_fabric(text: str, file: str) -> Fabric:
    """Return the fabric written in TOML; ``file`` is its name in messages.

    Raises:
        InputError: as ``read_fabric``.
    """
    source, document = parse_toml(text, file, "a file of levels")
    source.known(document, ("level",), expected="tables [[level]]")
    rows = document.get("level")
    if not isinstance(rows, list) or not rows or not all(isinstance(row, dict) for row in rows):
        raise InputError("give the levels in tables [[level]], the cores of a node first", file)
    levels = tuple(_level(row, k, file) for k, row in enumerate(rows))
    found = Fabric(levels)
    if found.processes > MOST:
        raise InputError(f"{found.processes} processes: at most {MOST} are played through", file)
    return found


def _level(row: Mapping[str, object], number: int, file: str) -> Level:
    """Return a level; the lowest has no costs of its own."""
    where = f"level {number + 1}"
    keys = ("name", "size", *(CHANNEL_KEYS if number else ()))
    for key in row:
        if key not in keys:
            raise InputError(f"{where}: unknown key '{key}': expected {', '.join(keys)}", file)
    for key in keys:
        if key not in row:
            raise InputError(f"{where}: {key} is missing", file)
    name, size = row["name"], row["size"]
    if not isinstance(name, str) or not name.isidentifier():
        raise InputError(f"{where}: name must be a word", file)
    if not isinstance(size, int) or isinstance(size, bool) or not 1 <= size <= MOST:
        raise InputError(f"{where}: size must be a whole number from 1 to {MOST}", file)
    costs = [_microseconds(row[key], f"{where}: {key}", file) for key in keys[2:]]
    return Level(name, size, ChannelCosts(*costs) if costs else None)


def _microseconds(value: object, what: str, file: str) -> float:
    number = isinstance(value, int | float) and not isinstance(value, bool)
    if not number or not 0 <= float(value) <= LIMIT:  # type: ignore[arg-type]
        raise InputError(f"{what} must be a number of microseconds from 0 to {LIMIT:g}", file)
    return float(value)  # type: ignore[arg-type]
