"""The command in the head of an emitted source, which makes it again."""

from __future__ import annotations

import json
import os
import re
import shlex
from collections.abc import Iterable, Iterator
from dataclasses import fields
from pathlib import Path

from adagen.emit.names import prefix_of
from adagen.errors import UsageError, printable
from adagen.library.request import Request
from adagen.library.robot import Origin
from adagen.library.scheduling import KNOWN
from adagen.schedule.profile import SHIPPED, stored_profiles

_MARK = "// command   "
_HEAD_LINES = 30
_HEAD_CHARACTERS = 10_000
_DESCRIPTION = re.compile("description sha256 ([0-9a-f]+)")
_SAID_BY_ITSELF = {"procs", "schedule", "profile", "chunk", "compiler", "tuned", "shape"}


def command_of(origin: Origin, request: Request, folder: Path) -> list[str]:
    """Return the command that writes a solver into a folder, its paths seen from there.

    Args:
        origin: where the robot comes from, seen from the working directory.
        request: what was asked for, with what was left to be chosen.
        folder: where the source is written.
    """
    return ["adagen", *robot_words(origin, folder), *_of_request(request, folder)]


def robot_words(origin: Origin, folder: Path) -> Iterator[str]:
    """Yield the arguments of a command that name a robot and its reading; paths from a folder."""
    model = _seen_from(folder, origin.path)
    yield model if not model.startswith("-") else f"./{model}"
    for name in ("floating", "mimic", "strict"):
        if getattr(origin, name):
            yield f"--{name}"
    yield from (f"--xacro-arg={name}:={value}" for name, value in origin.arguments)
    if origin.scene is not None:
        yield f"--scene={_seen_from(folder, origin.scene)}"
    if origin.loops is not None:
        yield f"--loops={_seen_from(folder, origin.loops)}"
    if origin.gravity is not None:
        yield from ("--gravity", *map(repr, origin.gravity))


def _of_request(request: Request, folder: Path) -> Iterator[str]:
    yield from ("--procs", str(request.procs))
    if request.profile in (*SHIPPED, *stored_profiles()):
        if request.profile != "default":
            yield f"--profile={request.profile}"
    else:
        yield f"--profile={_seen_from(folder, Path(request.profile))}"
    if request.schedule not in KNOWN:
        yield f"--schedule={_seen_from(folder, Path(request.schedule))}"
    elif request.schedule != "auto":
        yield f"--schedule={request.schedule}"
    if request.tuned:
        yield f"--tuned={request.shape}:{request.chunk}:{request.compiler}"
    elif request.shape != "auto":
        yield f"--shape={request.shape}"
    for field in fields(Request):
        value = getattr(request, field.name)
        if field.name in _SAID_BY_ITSELF or value == field.default:
            continue
        option = f"--{field.name.replace('_', '-')}"
        yield option if value is True else f"{option}={value}"


def _seen_from(folder: Path, path: Path) -> str:
    return Path(os.path.relpath(path, folder)).as_posix()


def with_command(source: str, command: list[str], inputs: Iterable[str] = ()) -> str:
    """Return an emitted source with a command in its head, and lines about its inputs."""
    text = shlex.join(command)
    if not (text.isascii() and text.isprintable()):
        text = json.dumps(text)
    place = source.index("// options ")
    lines = "".join(f"{line}\n" for line in (f"{_MARK}{text}", *inputs))
    return f"{source[:place]}{lines}{source[place:]}"


def command_in(source: str) -> list[str] | None:
    """Return the command in the head of a source, or None where it has none."""
    for line in source.split("\n", _HEAD_LINES)[:_HEAD_LINES]:
        if line.startswith(_MARK):
            text = line.removeprefix(_MARK)
            try:
                return shlex.split(json.loads(text) if text.startswith('"') else text)
            except ValueError:
                return None
    return None


def refuse_another(path: Path, source: str) -> None:
    """Refuse to overwrite a source that was made of another robot.

    A robot is another one where neither the place of its description nor the description is the
    same. Refused, too, is a source beside another one whose C functions have the same names.

    Raises:
        UsageError: it is another one.
    """
    for other in sorted(path.parent.glob(f"*{path.suffix}")):
        if other.stem != path.stem and prefix_of(other.stem) == prefix_of(path.stem):
            raise UsageError(
                f"the C functions of {printable(path.stem)} would have the same names as those of "
                f"{printable(str(other))}, {prefix_of(path.stem)}_...; choose another --name or "
                "--out, or remove it"
            )
    try:
        with path.open(encoding="utf-8", errors="replace") as file:
            head = file.read(_HEAD_CHARACTERS)
    except OSError:  # nothing is there, or what is there is judged by who writes
        return
    before, now = command_in(head), command_in(source)
    if not before or not now or before[1:2] == now[1:2]:
        return
    if _DESCRIPTION.findall(head) != _DESCRIPTION.findall(source[:_HEAD_CHARACTERS]):
        raise UsageError(
            f"{printable(str(path))} was made of another robot, {printable(before[1])}; choose "
            "another --name or --out, or remove it"
        )
