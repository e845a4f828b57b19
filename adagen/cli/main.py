"""Chooses the subcommand, and turns failures into one line and an exit status."""

from __future__ import annotations

import difflib
import os
import re
import signal
import sys
import traceback
from collections.abc import Callable, Sequence
from contextlib import suppress
from importlib import import_module
from itertools import takewhile
from types import FrameType

from adagen.cli.console import say, start
from adagen.errors import AdagenError, UsageError, printable
from adagen.garbage import seldom_collected

VERBS = (
    *("info", "schedule", "solve", "verify", "calibrate", "env", "bench", "stability", "chart"),
    *("report", "completion"),
)
EMITTING = ("build", "compile", "emit", "generate", "make")
"""What people call what needs no command."""

INTERNAL = 3
INTERRUPTED = 130

ALONE = "OPENBLAS_NUM_THREADS"
"""Matrices are small here, and numpy's threads wait longer for each other than they compute."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line and return the exit status.

    0 done, 1 the input is at fault, 2 usage, 3 the tool or its surroundings, 130 interrupted.

    Args:
        argv: the arguments, those of this process by default.
    """
    words = list(sys.argv[1:] if argv is None else argv)
    _end_by_exception()
    start(quiet=not {"-q", "--quiet"}.isdisjoint(takewhile("--".__ne__, words)))
    os.environ.setdefault(ALONE, "1")  # numpy, which is imported later, reads it
    try:
        with seldom_collected():
            return _status(words)
    finally:
        start(quiet=False)


def _status(words: Sequence[str]) -> int:
    """Carry the words out, and return the exit status; failures are printed."""
    try:
        status = _command(words)(words[1:] if _verb(words) else words)
        sys.stdout.flush()
    except SystemExit as leaving:
        return leaving.code if isinstance(leaving.code, int) else INTERNAL
    except AdagenError as error:
        return _fail(str(error), error.status, _debugging(words))
    except BrokenPipeError:
        _silence_stdout()
        return 128 + int(signal.SIGPIPE)
    except KeyboardInterrupt:
        return _fail("interrupted", INTERRUPTED, False)
    except OSError as error:
        what = f"{error.strerror or error}{f' ({error.filename})' if error.filename else ''}"
        return _fail(f"error: {printable(what)}", INTERNAL, _debugging(words))
    except MemoryError:
        return _fail("error: not enough memory", INTERNAL, _debugging(words))
    except RecursionError:
        return _fail("error: the input is nested too deeply", INTERNAL, _debugging(words))
    except Exception as error:
        what = printable(f"{type(error).__name__}: {error}")
        return _fail(
            f"error: internal error ({what}); please report it with the command and its input "
            "(ADAGEN_DEBUG=1 shows where)",
            INTERNAL,
            _debugging(words),
        )
    return status


def _verb(words: Sequence[str]) -> str | None:
    return words[0] if words and words[0] in VERBS else None


def _command(words: Sequence[str]) -> Callable[[Sequence[str]], int]:
    """Return what carries the words out; only its own module is imported.

    Raises:
        UsageError: the first word could be a command and is none.
    """
    first = words[0] if words else ""
    if re.fullmatch("[a-z]+", first) and first not in VERBS and not os.path.lexists(first):
        near = [] if first in EMITTING else difflib.get_close_matches(first, VERBS, n=1)
        hint = (
            f"did you mean '{near[0]}'?"
            if near
            else f"to write a solver: adagen MODEL [--out DIR]; commands: {', '.join(VERBS)}"
        )
        raise UsageError(f"neither a command nor a file: {first}; {hint}")
    module = import_module(f"adagen.cli.{_verb(words) or 'generate'}")
    run: Callable[[Sequence[str]], int] = module.run
    return run


def _fail(line: str, status: int, with_traceback: bool) -> int:
    with suppress(BrokenPipeError):
        if with_traceback:
            traceback.print_exc()
        say(line)
    return status


def _debugging(words: Sequence[str]) -> bool:
    return os.environ.get("ADAGEN_DEBUG", "") not in ("", "0") or "-vv" in words


def _silence_stdout() -> None:
    """Keep Python from complaining at exit about a reader that has gone."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _end_by_exception() -> None:
    """Let SIGTERM unwind like an exit, so that running processes and half-written files go too."""

    def leave(number: int, _frame: FrameType | None) -> None:
        sys.exit(128 + number)

    with suppress(ValueError):  # only the main thread may set handlers
        signal.signal(signal.SIGTERM, leave)
