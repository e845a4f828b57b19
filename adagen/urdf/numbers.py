"""The numbers of a URDF: decimal, in ASCII, finite, and of a reasonable size."""

from __future__ import annotations

import math
import re

LARGEST = 1e40
"""Products such as (mass * length^2)^2 of numbers up to this stay far below overflow."""

SMALLEST_MASS = 1e-40
"""A mass or moment of inertia below this, and not zero, has no inverse worth computing."""

_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_NOT_FINITE = re.compile(r"[+-]?(?:nan|inf|infinity)", re.IGNORECASE)
_NOT_ZERO = re.compile(r"[^eE]*[1-9]")
_WORD = re.compile(r"[^ \t\r\n]+")
_SHOWN = 40
_LONGEST = 1000


def number(text: str) -> float:
    """Return the number that ``text`` (without white space) spells.

    Raises:
        ValueError: saying what is wrong with it, in words that follow the name of the attribute.
    """
    shown = f'"{text if len(text) <= _SHOWN else text[:_SHOWN] + "..."}"'
    if len(text) > _LONGEST or not _NUMBER.fullmatch(text):
        if "${" in text or "$(" in text:
            raise ValueError(f"{shown} is an unexpanded xacro expression: run xacro first")
        if _NOT_FINITE.fullmatch(text):
            raise ValueError(f"{shown} is not finite: write a finite number")
        raise ValueError(f"{shown} is not a number: write one like 1, -0.5 or 2.5e-3")
    value = float(text)
    if math.isinf(value):
        raise ValueError(f"{shown} is not representable as a double: write a smaller number")
    if abs(value) > LARGEST:
        raise ValueError(
            f"{shown} is too large to compute with: give at most {LARGEST:g}, in SI units"
        )
    if value == 0.0 and _NOT_ZERO.match(text):
        raise ValueError(f"{shown} is too small for a double: write 0")
    return value


def numbers(text: str, count: int) -> tuple[float, ...]:
    """Return the ``count`` numbers in ``text``, separated by white space.

    Raises:
        ValueError: as for ``number``, and where there are more or fewer.
    """
    words = _WORD.findall(text)
    if len(words) != count:
        if "${" in text or "$(" in text:
            number(text)  # whose complaint is to the point
        needed = {1: "one number", 3: "three numbers"}.get(count, f"{count} numbers")
        raise ValueError(f"has {len(words)} numbers: it needs {needed}, separated by spaces")
    return tuple(number(word) for word in words)
