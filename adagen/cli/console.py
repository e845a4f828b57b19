"""What people see while the tool works: on stderr, and nothing that a program would read."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from adagen.cli.tables import wrapped
from adagen.errors import printable

if TYPE_CHECKING:
    from adagen.urdf import Reading

_PATIENCE_SECONDS = 1.0
_SILENCE_SECONDS = 10.0  # between two lines that tell how far the same work is


class _Said:
    """What this command has said, and whether it says more than warnings."""

    quiet = False
    warnings: ClassVar[list[str]] = []


def start(*, quiet: bool) -> None:
    """Begin a command.

    Args:
        quiet: whether it says warnings and errors alone.
    """
    _Said.quiet = quiet
    _Said.warnings.clear()


def warn(message: str) -> None:
    """Print a warning to stderr."""
    text = printable(message)
    text = text if "warning:" in text else f"warning: {text}"
    _Said.warnings.append(text)
    print(text, file=sys.stderr)


def warned() -> list[str]:
    """Return the warnings of this command so far."""
    return list(_Said.warnings)


def note(message: str) -> None:
    """Print a line for people to stderr."""
    if not _Said.quiet:
        say(message)


def wrote(paths: Sequence[Path]) -> None:
    """Say which files were written: each folder once, in lines that fit the terminal."""
    for folder in dict.fromkeys(path.parent for path in paths):
        names = ", ".join(path.name for path in paths if path.parent == folder)
        text = f"wrote {names if folder == Path() else f'{folder}: {names}'}"
        for line in wrapped(printable(text), indent=2).splitlines():
            note(line)


def say(message: str) -> None:
    """Print a line to stderr that quiet commands say, too: it tells of a failure."""
    print(printable(message), file=sys.stderr)


def tell(reading: Reading, verbose: bool) -> None:
    """Pass on what the reader of a robot description has to say."""
    for warning in reading.warnings:
        warn(warning)
    if verbose:
        for line in (*reading.mentions, *reading.ignored):
            note(f"note: {line}")


@contextmanager
def progress(doing: str) -> Iterator[None]:
    """Show that something goes on: a spinner on a terminal, else one line after a second."""
    if _Said.quiet:
        yield
        return
    if sys.stderr.isatty():
        from rich.console import Console

        with Console(stderr=True).status(f"{printable(doing)} ..."):
            yield
        return
    timer = threading.Timer(_PATIENCE_SECONDS, note, [f"{doing} ..."])
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


@contextmanager
def speaking(about: str) -> Iterator[Callable[[str], None]]:
    """Show what is being done: one changing line on a terminal, else now and then a line."""
    if _Said.quiet:
        yield lambda _text: None
        return
    if sys.stderr.isatty():
        from rich.console import Console

        with Console(stderr=True).status(about) as status:
            yield lambda text: status.update(f"{about}: {text}")
        return
    sort, spoken = "", 0.0

    def say(text: str) -> None:
        nonlocal sort, spoken
        new, now = text.rstrip("0123456789 of"), time.monotonic()
        if new != sort or now > spoken + _SILENCE_SECONDS:
            sort, spoken = new, now
            note(f"{about}: {text} ...")

    yield say


class Stages:
    """How long each stage took."""

    def __init__(self) -> None:
        """Start with none."""
        self._spent: list[tuple[str, float]] = []

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Time what happens inside, also when it fails."""
        start = time.perf_counter()
        try:
            yield
        finally:
            self._spent.append((name, time.perf_counter() - start))

    def __str__(self) -> str:
        """All stages in one line, in ms."""
        total = sum(spent for _, spent in self._spent)
        words = [f"{name} {spent * 1e3:.0f} ms" for name, spent in self._spent]
        return (
            ", ".join(["stages: " + words[0], *words[1:], f"total {total * 1e3:.0f} ms"])
            if words
            else "stages: none"
        )
