"""Messages and progress on standard error, for people."""

from __future__ import annotations

import re
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from adagen.cli.tables import wrapped
from adagen.cli.time_estimates import expected, learn, left
from adagen.errors import printable

if TYPE_CHECKING:
    from adagen.urdf import Reading

_PATIENCE_SECONDS = 1.0
_SILENCE_SECONDS = 10.0  # between two lines that tell how far the same work is


class _Session:
    """What this command has printed, and whether it prints more than warnings."""

    quiet = False
    warnings: ClassVar[list[str]] = []


def start(*, quiet: bool) -> None:
    """Begin a command.

    Args:
        quiet: whether it says warnings and errors alone.
    """
    _Session.quiet = quiet
    _Session.warnings.clear()


def warn(message: str) -> None:
    """Print a warning to stderr: one line, which is wrapped on a terminal."""
    text = printable(message)
    text = text if "warning:" in text else f"warning: {text}"
    _Session.warnings.append(text)
    say(text)


def warned() -> list[str]:
    """Return the warnings of this command so far."""
    return list(_Session.warnings)


def note(message: str) -> None:
    """Print a line for people to stderr."""
    if not _Session.quiet:
        say(message)


def long_note(message: str) -> None:
    """Print a note in lines that fit the terminal."""
    for line in wrapped(printable(message), indent=2).splitlines():
        note(line)


def wrote(paths: Sequence[Path]) -> None:
    """Say which files were written: each folder once, in lines that fit the terminal."""
    for folder in dict.fromkeys(path.parent for path in paths):
        names = ", ".join(path.name for path in paths if path.parent == folder)
        long_note(f"wrote {names if folder == Path() else f'{folder}: {names}'}")


def say(message: str) -> None:
    """Print a line to stderr that quiet commands print, too: it reports a failure.

    On a terminal it is wrapped between words; programs that read it get one line.
    """
    text = printable(message)
    print(wrapped(text, indent=2) if sys.stderr.isatty() else text, file=sys.stderr, flush=True)


def tell(reading: Reading, verbose: bool) -> None:
    """Pass on what the reader of a robot description has to say."""
    for warning in reading.warnings:
        warn(warning)
    if verbose:
        for line in (*reading.mentions, *reading.ignored):
            note(f"note: {line}")


@contextmanager
def progress(doing: str, size: float = 0.0) -> Iterator[None]:
    """Show that something goes on: a spinner on a terminal, else one line after a second.

    Where work of its kind was done before, about how long it takes follows.

    Args:
        doing: what; its first word is the kind of work.
        size: how much work it is, in a unit of its kind; 0 where nobody can say.
    """
    kind, begun = doing.split()[0], time.monotonic()
    with nullcontext() if _Session.quiet else _shown(doing, expected(kind, size)):
        yield
    learn(kind, size, time.monotonic() - begun)


@contextmanager
def _shown(doing: str, seconds: float | None) -> Iterator[None]:
    if sys.stderr.isatty():
        from rich.console import Console

        over, end = threading.Event(), time.monotonic() + (seconds or 0.0)

        def count() -> None:
            while (rest := end - time.monotonic()) > _WORTH_SECONDS:
                status.update(f"{printable(doing)} (about {left(rest)} left) ...")
                if over.wait(1.0):
                    return
            status.update(f"{printable(doing)} ...")

        with Console(stderr=True).status(f"{printable(doing)} ...") as status:
            counting = threading.Thread(target=count, daemon=True)
            counting.start()
            try:
                yield
            finally:
                over.set()
                counting.join()
        return
    worth = seconds is not None and seconds >= _WORTH_SECONDS
    about = f" (about {left(seconds)})" if worth and seconds is not None else ""
    timer = threading.Timer(_PATIENCE_SECONDS, note, [f"{doing}{about} ..."])
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


@contextmanager
def speaking(about: str) -> Iterator[Callable[[str], None]]:
    """Show what is being done: one changing line on a terminal, else now and then a line.

    Where the work is counted ("compiling 3 of 20"), an estimate of what is left follows.
    """
    if _Session.quiet:
        yield lambda _text: None
        return
    left = _Left()
    if sys.stderr.isatty():
        from rich.console import Console

        with Console(stderr=True).status(about) as status:
            yield lambda text: status.update(f"{about}: {text}{left.after(text)}")
        return
    sort, spoken = "", 0.0

    def say(text: str) -> None:
        nonlocal sort, spoken
        estimate = left.after(text)
        new, now = text.rstrip("0123456789 of"), time.monotonic()
        if new != sort or now > spoken + _SILENCE_SECONDS:
            sort, spoken = new, now
            note(f"{about}: {text}{estimate} ...")

    yield say


class _Left:
    """How long the rest of counted work takes, if it goes on as fast as so far."""

    def __init__(self) -> None:
        self._sort: str | None = None
        self._first, self._since = 0, 0.0

    def after(self, text: str) -> str:
        """Return what is left after a line, from 2 s on; nothing where work is not counted.

        Args:
            text: the line; "... 3 of 20" says that the third part of twenty begins.
        """
        counted = _COUNTED.search(text)
        if counted is None:
            return ""
        now, sort, part = time.monotonic(), text[: counted.start()], int(counted[1])
        if sort != self._sort or part <= self._first:
            self._sort, self._first, self._since = sort, part, now
            return ""
        rest = (now - self._since) / (part - self._first) * (int(counted[2]) - part + 1)
        if rest < _WORTH_SECONDS:
            return ""
        return f" (about {left(rest)} left)"


_COUNTED = re.compile(r"(\d+) of (\d+)")
_WORTH_SECONDS = 2.0


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


@contextmanager
def timed(*, told: bool) -> Iterator[Stages]:
    """Give stages to be timed, which are told at the end if wanted, also when one fails."""
    stages = Stages()
    try:
        yield stages
    finally:
        if told:
            long_note(str(stages))
