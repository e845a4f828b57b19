"""Hosts and their numbers of processes, from mpiexec's host files."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from adagen.errors import InputError

_LINE = re.compile(
    r"(?P<name>[A-Za-z0-9][A-Za-z0-9._-]*)"
    r"(?::(?P<colon>[0-9]{1,5})|(?P<words>(?:\s+(?:slots|max_slots|max-slots)\s*=\s*[0-9]{1,5})*))"
)
_SLOTS = re.compile(r"\sslots\s*=\s*([0-9]+)")


@dataclass(frozen=True)
class Host:
    """A host and its number of processes."""

    name: str
    slots: int


def read_hosts(path: Path) -> tuple[Host, ...]:
    """Return the hosts of a file, in order; repeated hosts add up their processes.

    A line is ``NAME``, ``NAME slots=N`` (Open MPI) or ``NAME:N`` (MPICH); # begins a remark.

    Raises:
        InputError: the file cannot be read, has no host, or a line that is none.
    """
    try:
        lines = path.read_text("utf-8").splitlines()
    except UnicodeDecodeError:
        raise InputError("a file of hosts must be UTF-8 text", str(path)) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or "not a usable path"
        raise InputError(f"cannot read the hosts: {reason}", str(path)) from None
    slots: dict[str, int] = {}
    for number, line in enumerate(lines, 1):
        text = line.partition("#")[0].strip()
        if not text:
            continue
        found = _LINE.fullmatch(text)
        count = 0 if found is None else _slots(found)
        if found is None or count < 1:
            raise InputError(
                "not a host: a line is NAME, NAME slots=N or NAME:N, N at least 1",
                str(path),
                number,
            )
        slots[found["name"]] = slots.get(found["name"], 0) + count
    if not slots:
        raise InputError("names no host: a line each, such as node1 slots=16", str(path))
    return tuple(Host(name, count) for name, count in slots.items())


def _slots(line: re.Match[str]) -> int:
    if line["colon"]:
        return int(line["colon"])
    slots = _SLOTS.search(line["words"] or "")
    return int(slots[1]) if slots else 1
