"""Sanitised and quoted names: names from a robot description are untrusted data."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable

LONGEST = 48
_MARK = 8  # hexadecimal digits that tell shortened file names apart

# Never used bare: every identifier gets a prefix (see symbols.py) that no macro of the C library or
# MPI has, so that keywords and names of others cannot be met.


def identifiers(names: Iterable[str]) -> tuple[str, ...]:
    """Return for each name a distinct word of [A-Za-z0-9_], at most ``LONGEST`` + a number long.

    Symbols do not start or end with an underscore and hold no two in a row, so that a prefix makes
    them legal identifiers that are not reserved. Names that meet once cleaned get numbers.
    """
    return distinct(_word(name) for name in names)


def distinct(words: Iterable[str]) -> tuple[str, ...]:
    """Return the words, repeated ones with a number added."""
    taken: set[str] = set()
    result = []
    for word in words:
        unique, number = word, 2
        while unique in taken:
            unique = f"{word}_{number}"
            number += 1
        taken.add(unique)
        result.append(unique)
    return tuple(result)


def _word(name: str) -> str:
    word = re.sub(r"[^A-Za-z0-9]+", "_", name)[:LONGEST].strip("_")
    return word or "unnamed"


def file_stem(name: str) -> str:
    """Return a file name without folders, dots or anything but [A-Za-z0-9_-] made of a name.

    One that would be longer than ``LONGEST`` ends in the first digits of the name's SHA-256, so
    that names with the same beginning do not meet.
    """
    stem = re.sub(r"[^A-Za-z0-9_-]+", "_", name).strip("_-")
    if len(stem) > LONGEST:
        mark = hashlib.sha256(name.encode("utf-8", errors="replace")).hexdigest()[:_MARK]
        stem = f"{stem[: LONGEST - _MARK - 1].rstrip('_-')}_{mark}"
    return stem or "robot"


def prefix_of(stem: str) -> str:
    """Return the prefix of a file's C functions: its stem as an identifier."""
    prefix = re.sub(r"[-_]+", "_", stem)
    return prefix if prefix[0].isalpha() else f"robot_{prefix}"


def quoted(name: str) -> str:
    r"""Return a name as a C++ string literal in ASCII, fit for code and for one-line comments.

    Bytes beyond printable ASCII are octal escapes of UTF-8, which unlike ``\x`` end after three
    digits; ``?`` is escaped against trigraphs. The result never ends in a backslash.
    """
    text = []
    for byte in name.encode("utf-8", errors="replace"):
        character = chr(byte)
        if character in '"\\?':
            text.append("\\" + character)
        elif 0x20 <= byte < 0x7F:
            text.append(character)
        else:
            text.append(f"\\{byte:03o}")
    return '"' + "".join(text) + '"'
