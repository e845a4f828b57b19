"""What people see while the tool works: on stderr, and nothing that a program would read."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

from adagen.errors import printable

_PATIENCE_SECONDS = 1.0


def warn(message: str) -> None:
    """Print a warning to stderr."""
    text = printable(message)
    print(text if "warning:" in text else f"warning: {text}", file=sys.stderr)


def note(message: str) -> None:
    """Print a line for people to stderr."""
    print(printable(message), file=sys.stderr)


@contextmanager
def progress(doing: str) -> Iterator[None]:
    """Show that something goes on: a spinner on a terminal, else one line after a second."""
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
