"""JSON without recursion: the schedule tree of a long chain is as deep as the chain.

Python's json module recurses once or twice per level, and gives up at a few hundred.
"""

from __future__ import annotations

import json
import re
from typing import Any

_SPACE = re.compile(r"[ \t\n\r]*")
_SCALAR = json.JSONDecoder(parse_constant=lambda text: _refuse(text))


def _refuse(constant: str) -> Any:
    raise ValueError(f"{constant} is not JSON")


def dumps(value: Any) -> str:
    """Return value (dicts with text keys, lists, tuples, scalars) as JSON in one line.

    Raises:
        ValueError: a number is not finite.
    """
    out: list[str] = []
    stack: list[Any] = [value]
    while stack:
        item = stack.pop()
        if isinstance(item, _Raw):
            out.append(item.text)
        elif isinstance(item, dict):
            parts: list[Any] = [_Raw("{")]
            for i, (key, inner) in enumerate(item.items()):
                parts += [_Raw(f"{', ' if i else ''}{json.dumps(key)}: "), inner]
            stack.extend(reversed([*parts, _Raw("}")]))
        elif isinstance(item, list | tuple):
            parts = [_Raw("[")]
            for i, inner in enumerate(item):
                parts += [_Raw(", "), inner] if i else [inner]
            stack.extend(reversed([*parts, _Raw("]")]))
        else:
            out.append(json.dumps(item, allow_nan=False))
    return "".join(out)


class _Raw:
    """Text that goes into the output as it is."""

    def __init__(self, text: str) -> None:
        self.text = text


def loads(text: str) -> Any:
    """Return the data of a JSON text.

    Raises:
        json.JSONDecodeError: it is not JSON; tells the line.
        ValueError: a number is not finite, or a key is given twice.
    """
    root: list[Any] = []
    stack: list[Any] = [root]
    at = 0
    while True:
        at = _skip(text, at)
        mark = text[at : at + 1]
        if mark in ("{", "["):
            inner: Any = {} if mark == "{" else []
            _put(stack, inner)
            stack.append(inner)
            at = _skip(text, at + 1)
            if text[at : at + 1] == ("}" if mark == "{" else "]"):
                at = _close(text, at, stack)
            elif mark == "{":
                at = _key(text, at, stack)
        else:
            value, at = _SCALAR.raw_decode(text, at)
            _put(stack, value)
            at = _close(text, at, stack, scalar=True)
        if len(stack) == 1:
            if _skip(text, at) != len(text):
                raise json.JSONDecodeError("Extra data", text, _skip(text, at))
            return root[0]


class _Key(str):
    """A key that waits for its value."""


def _put(stack: list[Any], value: Any) -> None:
    top = stack[-1]
    if isinstance(top, _Key):
        stack.pop()
        stack[-1][str(top)] = value
    else:
        top.append(value)


def _skip(text: str, at: int) -> int:
    found = _SPACE.match(text, at)
    return found.end() if found else at


def _key(text: str, at: int, stack: list[Any]) -> int:
    at = _skip(text, at)
    if text[at : at + 1] != '"':
        raise json.JSONDecodeError("Expecting property name in double quotes", text, at)
    key, after = _SCALAR.raw_decode(text, at)
    if key in stack[-1]:
        raise json.JSONDecodeError(f"Key {key!r} given twice", text, at)
    after = _skip(text, after)
    if text[after : after + 1] != ":":
        raise json.JSONDecodeError("Expecting ':'", text, after)
    stack.append(_Key(key))
    return after + 1


def _close(text: str, at: int, stack: list[Any], scalar: bool = False) -> int:
    """Step past closing brackets at ``at`` and past the comma (and key) that follows, if any."""
    closing = not scalar
    while len(stack) > 1:
        at = _skip(text, at)
        mark = text[at : at + 1]
        ours = "}" if isinstance(stack[-1], dict) else "]"
        if mark == ours:
            stack.pop()
            at += 1
        elif mark == "," and not closing:
            return _key(text, at + 1, stack) if ours == "}" else at + 1
        else:
            raise json.JSONDecodeError(f"Expecting ',' or '{ours}'", text, at)
        closing = False
    return at
