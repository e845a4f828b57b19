"""Removes mpiexec's own messages from a program's output."""

from __future__ import annotations

import re

_RULE = re.compile(r"^-{60,}\s*$")
_PREFIXED = re.compile(
    r"^\[[^\s\]]+:\d+\]|^\[[^\s\]]+:\d+,\d+\]|^\[[^\s\]]+\] \d+ more process"
    r"|^\[(?:warn|err)\] "  # libevent, as processes end
)
_LAUNCHER = re.compile(r"^(prterun|mpiexec|mpirun|orterun)\b.*")


def without_launcher_noise(text: str) -> tuple[str, str]:
    """Split what was written to stderr into the program's words and the launcher's.

    Open MPI frames its notices in dashed lines and marks others with ``[host:pid]``.

    Args:
        text: everything on stderr.

    Returns:
        The program's lines, and the most telling notice of the launcher in one line ("" if none).
    """
    own: list[str] = []
    framed: list[str] = []
    marked: list[str] = []
    block: list[str] | None = None
    for line in text.replace("\0", "").splitlines():  # prterun writes a zero byte on an abort
        if _RULE.match(line):
            if block is None:
                block = []
            else:
                framed.append(_one_line(block))
                block = None
        elif block is not None:
            block.append(line)
        elif _PREFIXED.match(line) or _LAUNCHER.match(line):
            marked.append(_one_line([line]))
        elif line.strip():
            own.append(line)
    if block:
        framed.append(_one_line(block))  # a frame that was not closed
    return "\n".join(own), next((notice for notice in framed + marked if notice), "")


def framed_notice(text: str) -> str:
    """Return the first notice in a frame of dashes, in one line; nothing if there is none.

    Open MPI's launcher writes some to standard output: that it has lost a host, for one.
    """
    lines = text.splitlines()
    rules = [k for k, line in enumerate(lines) if _RULE.match(line)]
    return _one_line(lines[rules[0] + 1 : rules[1]]) if len(rules) > 1 else ""


def _one_line(lines: list[str]) -> str:
    return " ".join(" ".join(lines).split())
