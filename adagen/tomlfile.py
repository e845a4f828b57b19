"""TOML files, read strictly, with line numbers that ``tomllib`` does not give."""

from __future__ import annotations

import re
import stat
import tomllib
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from adagen.errors import InputError

LARGEST_FILE = 2**20
"""Bytes; a scene that names ten thousand joints has half of it."""

_AT = re.compile(r"\s*\(at (?:line (\d+), column \d+|end of document)\)$")


@dataclass(frozen=True)
class Source:
    """A TOML document as text.

    Attributes:
        file: its path as the user gave it; None for a document that is no file's.
        text: the whole of it.
    """

    file: str | None = None
    text: str = ""

    def error(self, message: str, *path: str | int) -> InputError:
        """Return (not raise) a refusal, with the line of ``path``."""
        return InputError(message, self.file, self.line(*path) if path else None)

    def known(
        self, table: Mapping[str, object], keys: Collection[str], *path: str, expected: str = ""
    ) -> None:
        """Raise InputError if a table has a key that is none of some.

        Args:
            table: the table.
            keys: those that it may have.
            path: of the table.
            expected: what the refusal says is expected; the keys if nothing is given.
        """
        for key in table:
            if key not in keys:
                name = ".".join((*path, key))
                expected = expected or ", ".join(keys)
                raise self.error(f"unknown key '{name}': expected {expected}", *path, key)

    def number(self, table: Mapping[str, object], key: str, *path: str) -> float:
        """Return a number of microseconds of the table at a path, nan among them.

        Raises:
            InputError: it is missing, no number, or too large for one.
        """
        name = ".".join((*path, key))
        if key not in table:
            raise self.error(f"{name} is missing: add '{key} = ...' (microseconds)")
        value = table[key]
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.error(f"{name} must be a number of microseconds", *path, key)
        try:
            return float(value)
        except OverflowError:
            raise self.error(f"{name} is too large", *path, key) from None

    def line(self, *path: str | int) -> int | None:
        """Return the line, from 1, that starts what is at ``path`` (keys and places in lists).

        It is the line after the longest beginning of the file that is a document without ``path``:
        whatever TOML allows, its own parser decides.
        """
        lines = self.text.split("\n")
        if not self._holds(lines, len(lines), path):
            return None
        low, high = 0, len(lines)  # the first `low` lines are a document without it, `high` with
        while high - low > 1:
            middle = (low + high) // 2
            while middle > low and not self._complete(lines, middle):
                middle -= 1
            if middle == low:  # every shorter beginning ends inside a value: look above
                middle = (low + high) // 2
                while middle < high and not self._complete(lines, middle):
                    middle += 1
                if middle == high:
                    break
            if self._holds(lines, middle, path):
                high = middle
            else:
                low = middle
        while low < high - 1 and _blank(lines[low]):
            low += 1
        return low + 1

    @staticmethod
    def _complete(lines: list[str], count: int) -> bool:
        try:
            tomllib.loads("\n".join(lines[:count]))
        except tomllib.TOMLDecodeError:
            return False
        return True

    @staticmethod
    def _holds(lines: list[str], count: int, path: tuple[str | int, ...]) -> bool:
        at: Any = tomllib.loads("\n".join(lines[:count]))  # a dict or list: only they are asked
        for key in path:
            inside = key in at if isinstance(at, dict) else isinstance(key, int) and key < len(at)
            if not inside:
                return False
            at = at[key]
        return True


def _blank(line: str) -> bool:
    return not line.strip() or line.lstrip().startswith("#")


def read_text(path: Path | str, what: str) -> str:
    """Return the text of a file, its lines ended by newlines.

    Args:
        path: of the file.
        what: should be in it, for the refusals: "a scene file (TOML)".

    Raises:
        InputError: it cannot be read or is no text.
    """
    file = str(path)
    try:
        if not stat.S_ISREG(Path(path).stat().st_mode):
            raise InputError(f"is not a regular file: give {what}", file)
        data = Path(path).read_bytes()
    except (OSError, ValueError) as fault:
        reason = fault.strerror if isinstance(fault, OSError) else str(fault)
        raise InputError(f"cannot read it: {reason}", file) from None
    if len(data) > LARGEST_FILE:
        raise InputError(f"larger than {LARGEST_FILE // 2**20} MiB, the limit for {what}", file)
    try:
        return data.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as fault:
        line = data.count(b"\n", 0, fault.start) + 1
        raise InputError(
            f"not UTF-8 text (byte {fault.start}): save it as UTF-8", file, line
        ) from None


def parse_toml(text: str, file: str, what: str) -> tuple[Source, dict[str, Any]]:
    """Return a TOML text with its lines, and what it says.

    Args:
        text: the text.
        file: what refusals call it.
        what: should be in it: "a scene".

    Raises:
        InputError: it is not TOML.
    """
    try:
        return Source(file, text), tomllib.loads(text)
    except tomllib.TOMLDecodeError as fault:
        problem = str(fault)
        place = _AT.search(problem)
        at = text.count("\n") + 1 if place is None or place[1] is None else int(place[1])
        said = problem if place is None else problem[: place.start()]
        raise InputError(f"not TOML: {said[:1].lower()}{said[1:]}", file, at) from None
    except (RecursionError, ValueError):
        raise InputError(f"not {what}: nested too deeply, or a number too long", file) from None
