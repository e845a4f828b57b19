"""Failures, by whose fault they are, with their exit status."""

from __future__ import annotations

from typing import Any


class AdagenError(Exception):
    """A failure that a person can act on: one line of text and an exit status.

    Attributes:
        status: process exit status (1 the input, 2 the usage, 3 the environment).
    """

    status = 3

    @property
    def reason(self) -> str:
        """The line without ``error:`` in front of it."""
        return str(self).removeprefix("error: ")


class InputError(AdagenError):
    """The input is at fault; shown as ``file:line: error: message``.

    Args:
        message: what is wrong and what to do about it, in one line.
        file: the file at fault, if one is known.
        line: the line in that file, counted from 1.
    """

    status = 1

    def __init__(self, message: str, file: str | None = None, line: int | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.file = file
        self.line = line

    def __str__(self) -> str:
        place = "" if self.file is None else f"{printable(self.file)}:"
        if place and self.line is not None:
            place += f"{self.line}:"
        return f"{place}{' ' if place else ''}error: {printable(self.message)}"


class UsageError(AdagenError):
    """The command line is at fault."""

    status = 2

    def __str__(self) -> str:
        return f"error: {super().__str__()}"


class EnvironmentFault(AdagenError):
    """The tool itself or its surroundings failed: no compiler, no MPI, a process that died."""

    status = 3

    def __str__(self) -> str:
        return f"error: {super().__str__()}"


class JointError(UsageError, LookupError):
    """There is no joint of this name."""

    def __str__(self) -> str:
        return super().__str__().removeprefix("error: ")


class SolveError(AdagenError, ArithmeticError):
    """A state has no accelerations that can be computed.

    Args:
        text: why, with the joint's name.
        joint: the name of the joint that it is about, or None.
        state: the first state that failed, counted from 0; None of a single state.
        count: how many states failed.
        out: the accelerations of all states, shape (S, nv), not numbers where they failed; None
            of a single state.
    """

    status = 1

    def __init__(
        self,
        text: str,
        joint: str | None = None,
        state: int | None = None,
        count: int = 1,
        out: Any = None,
    ) -> None:
        super().__init__(text, joint, state, count, out)
        self.text, self.joint, self.state, self.count, self.out = text, joint, state, count, out

    def __str__(self) -> str:
        place = "" if self.state is None else f"state {self.state}: "
        more = f" (and {self.count - 1} more states)" if self.count > 1 else ""
        return f"{place}{printable(self.text)}{more}"


def printable(text: str) -> str:
    """Return text in one line without control characters (names in a URDF are hostile data)."""
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)
