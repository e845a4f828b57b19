"""Inputs of a solver beside the robot: scene, frame pairs, schedule file, cost profile."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from adagen.library.request import Request
from adagen.library.robot import Origin
from adagen.library.scheduling import KNOWN
from adagen.schedule.profile import profile_text
from adagen.version import __version__


@dataclass(frozen=True)
class Input:
    """A text that a solver is made from.

    Attributes:
        what: "scene", "loops", "schedule" or "profile", with the name of a profile behind it.
        text: the whole text.
    """

    what: str
    text: str

    @property
    def sha256(self) -> str:
        """SHA-256 of the text in UTF-8, in hexadecimal."""
        return hashlib.sha256(self.text.encode("utf-8")).hexdigest()


def inputs_of(origin: Origin, request: Request) -> tuple[Input, ...]:
    """Return the inputs of a solver as they are now in their files, which have been read."""
    return tuple(_inputs(origin, request))


def _inputs(origin: Origin, request: Request) -> Iterator[Input]:
    files = {"scene": origin.scene, "loops": origin.loops}
    if request.schedule not in KNOWN:
        files["schedule"] = Path(request.schedule)
    for what, path in files.items():
        if path is not None:
            yield Input(what, path.read_bytes().decode("utf-8"))
    yield Input(f"profile {Path(request.profile).stem}", profile_text(request.profile)[0])


def head_lines(inputs: Sequence[Input]) -> Iterator[str]:
    """Yield the lines that name the inputs in the head of a source."""
    for each in inputs:
        what = each.what if each.what.isascii() and each.what.isprintable() else "profile"
        yield f"// input     {what}, sha256 {each.sha256}"


def with_inputs(plan: str, command: Sequence[str], inputs: Sequence[Input]) -> str:
    """Return a plan as JSON that ends with the command that makes it and the text of all inputs."""
    texts = [{"what": i.what, "sha256": i.sha256, "text": i.text} for i in inputs]
    made = {"adagen": __version__, "command": list(command), "inputs": texts}
    return plan.removesuffix("\n}\n") + f',\n"made": {json.dumps(made)}\n}}\n'
