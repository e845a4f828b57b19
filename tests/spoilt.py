"""States files with one thing wrong, and what must be said of it."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

Change = Callable[[dict[str, Any], str], None]


@dataclass(frozen=True)
class Spoilt:
    """What is done to a good states file, and a part of the line that must come."""

    name: str
    says: str
    change: Change | None = None
    text: Callable[[str], str] | None = None
    line: int | None = None


def _set(*path: str, to: Any) -> Change:
    def change(data: dict[str, Any], joint: str) -> None:
        for key in path[:-1]:
            data = data[joint if key == "JOINT" else key]
        data[joint if path[-1] == "JOINT" else path[-1]] = to

    return change


def _drop(*path: str) -> Change:
    def change(data: dict[str, Any], joint: str) -> None:
        for key in path[:-1]:
            data = data[joint if key == "JOINT" else key]
        del data[joint if path[-1] == "JOINT" else path[-1]]

    return change


def _pop(data: dict[str, Any], joint: str) -> None:
    data["joints"][joint]["tau"].pop()


def _first(word: str) -> Callable[[str], str]:
    """Return what puts a word in the place of the first number after a "v"."""

    def change(text: str) -> str:
        start = text.index("[", text.index('"v"')) + 1
        while text[start] == "[":
            start += 1
        end = min(text.index(c, start) for c in ",]" if c in text[start:])
        return text[:start] + word + text[end:]

    return change


def _twice(key: str) -> Callable[[str], str]:
    return lambda text: text.replace(f'"{key}":', f'"{key}": [0], "{key}":', 1)


NUMBER = "v: expected a finite number"
SPOILT = (
    Spoilt("nan", NUMBER, text=_first("NaN"), line=4),
    Spoilt("infinity", NUMBER, text=_first("-Infinity"), line=4),
    Spoilt("beyond double", NUMBER, text=_first("1e400"), line=4),
    Spoilt("hexadecimal", "v: expected", text=_first("0x10"), line=4),
    Spoilt("leading plus", NUMBER, text=_first("+1"), line=4),
    Spoilt("no digits before the point", NUMBER, text=_first(".5"), line=4),
    Spoilt("a number in quotes", NUMBER, text=_first('"1"'), line=4),
    Spoilt("null", NUMBER, text=_first("null"), line=4),
    Spoilt("true", NUMBER, text=_first("true"), line=4),
    Spoilt("a word", NUMBER, text=_first("zero"), line=4),
    Spoilt("empty file", "the file ends too early", text=lambda _: "", line=1),
    Spoilt("cut in half", "error: ", text=lambda t: t[: len(t) // 2]),
    Spoilt("not an object", "expected '{'", text=lambda _: "[1, 2]", line=1),
    Spoilt("text behind", "text behind the end", text=lambda t: t + "{}"),
    Spoilt("binary", "expected '{'", text=lambda _: "\0\1\2\x7f", line=1),
    Spoilt(
        "nested deeply",
        "nested too deeply",
        text=lambda t: t.replace('"v":', '"qdd": ' + "[" * 100000, 1),
    ),
    Spoilt("q twice", "q comes twice", text=_twice("q")),
    Spoilt("joint missing", "is missing", change=_drop("joints", "JOINT")),
    Spoilt("no joints", '"joints" is missing', change=_drop("joints")),
    Spoilt("unknown joint", 'unknown joint "elbw\\u000a"', change=_set("joints", "elbw\n", to={})),
    Spoilt("unknown member", 'unknown member "gravty"', change=_set("gravty", to=[0, 0, 0])),
    Spoilt("unknown field", 'unknown member "p"', change=_set("joints", "JOINT", "p", to=[0])),
    Spoilt("v missing", "needs q, v and tau", change=_drop("joints", "JOINT", "v")),
    Spoilt("a state less", "tau: 1 states, but others have 2", change=_pop),
    Spoilt("no state", "q: there is no state", change=_set("joints", "JOINT", "q", to=[])),
    Spoilt(
        "too many numbers",
        "q: state 1 has 9 numbers",
        change=_set("joints", "JOINT", "q", to=[[0.0] * 9] * 2),
    ),
    Spoilt("a joint is a list", "expected '{'", change=_set("joints", "JOINT", to=[])),
    Spoilt("a field is a number", "expected '['", change=_set("joints", "JOINT", "q", to=1.0)),
    Spoilt("other base", '"floating"', change=_set("floating", to=True)),
    Spoilt("other gravity", "another gravity", change=_set("gravity", to=[0, 0, -1.62])),
    Spoilt("half a surrogate", "half a surrogate pair", text=lambda t: '{"\\ud800": 1, ' + t[1:]),
    Spoilt("unknown escape", "an unknown escape", text=lambda t: '{"\\x": 1, ' + t[1:]),
    Spoilt("control character", "a control character", text=lambda t: '{"\t": 1, ' + t[1:]),
)


def spoil(case: Spoilt, good: dict[str, Any], joint: str, folder: Path) -> Path:
    """Write the spoilt file and return its path."""
    data = copy.deepcopy(good)
    if case.change is not None:
        case.change(data, joint)
    rows = ",\n".join(
        f"{json.dumps(k)}: {json.dumps(v)}" for k, v in data.pop("joints", {}).items()
    )
    head = "".join(f"{json.dumps(k)}: {json.dumps(v)},\n" for k, v in data.items())
    text = "{" + head + '"joints": {\n' + rows + "\n}}\n"
    if case.name == "no joints":
        text = "{" + head.rstrip(",\n") + "}\n"
    if case.text is not None:
        text = case.text(text)
    path = folder / "spoilt.json"
    path.write_text(text)
    return path
