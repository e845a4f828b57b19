"""JSON files, read strictly and written completely or not at all."""

from __future__ import annotations

import difflib
import json
import math
import re
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, NoReturn


class Refusal(Exception):
    """What is wrong with a file, and the line where that is known, if it is."""

    def __init__(self, message: str, line: int | None = None) -> None:
        super().__init__(message)
        self.line = line


def load_object(path: Path | str, known: Sequence[str]) -> dict[str, Any]:
    """Return the file's one JSON object.

    Raises:
        Refusal: the file cannot be read, is not JSON, has a member twice, or one at the top that is
            not among the known.
    """
    try:
        text = Path(path).read_bytes().decode("utf-8-sig")
    except OSError as error:
        raise Refusal(f"cannot read the file: {error.strerror or error}") from None
    except UnicodeDecodeError as error:
        raise Refusal(f"not UTF-8 text (byte {error.start}); give a JSON file") from None

    def literal(word: str) -> NoReturn:
        tokens = re.finditer(r'"(?:[^"\\]|\\.)*"|-?\b(?:NaN|Infinity)\b', text)
        start = next((t.start() for t in tokens if t.group()[0] != '"'), 0)
        line = text.count("\n", 0, start) + 1
        raise Refusal(f"{word} is neither JSON nor a state; give finite numbers", line)

    try:
        document = json.loads(text, parse_constant=literal, object_pairs_hook=_members)
    except json.JSONDecodeError as error:
        raise Refusal(f"not JSON: {error.msg} (column {error.colno})", error.lineno) from None
    except RecursionError:
        raise Refusal("not a states file: lists nested too deeply") from None
    except ValueError:  # an integer of more digits than Python converts
        raise Refusal("a number has too many digits; give finite numbers") from None
    members = as_object(document, "the file")
    for name in members:
        if name not in known:
            raise Refusal(f"unknown member '{name}'{nearest(name, known)}")
    return members


def _members(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    result: dict[str, Any] = {}
    for name, value in pairs:
        if name in result:
            raise Refusal(f"'{name}' is there twice; keep one")
        result[name] = value
    return result


def as_object(value: Any, what: str) -> dict[str, Any]:
    """Return the value, which must be an object.

    Raises:
        Refusal: it is not.
    """
    if not isinstance(value, dict):
        problem = "is missing" if value is None else "is not an object"
        raise Refusal(f'{what} {problem}; give {{"joints": {{NAME: {{"q": [...], ...}}}}}}')
    return value


def as_number(value: Any, where: str) -> float:
    """Return the value, which must be a finite number.

    Raises:
        Refusal: it is not.
    """
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise Refusal(f"{where}: {json.dumps(value)[:40]} is not a number")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise Refusal(f"{where}: the number is too large for double precision")
    return number


def nearest(name: str, names: Iterable[str]) -> str:
    """Return "; did you mean ...?" where one of the names is like the given one, else nothing."""
    near = difflib.get_close_matches(name, list(names), n=1)
    return f"; did you mean '{near[0]}'?" if near else ""
