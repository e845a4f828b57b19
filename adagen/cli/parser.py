"""A parser that fails in one line, with help in the shape that all subcommands have."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Sequence
from typing import NoReturn

from adagen import __version__
from adagen.errors import UsageError, printable


class Parser(argparse.ArgumentParser):
    """An argument parser whose complaints are ``error:`` lines with status 2."""

    def error(self, message: str) -> NoReturn:
        """Raise the complaint with where to read on."""
        raise UsageError(f"{printable(message)}; see {self.prog} --help")


def parse(parser: Parser, argv: Sequence[str]) -> argparse.Namespace:
    """Return the options that the words say.

    Raises:
        UsageError: the words are not a command line of this parser.
    """
    options = parser.parse_args(argv)
    if [] in vars(options).values():  # what argparse makes of --name=--
        parser.error("an option cannot have the value --")
    return options


def make_parser(prog: str, description: str, epilog: str) -> Parser:
    """Return a parser with help in the shape that all subcommands have."""
    parser = Parser(
        prog=prog,
        description=description,
        epilog=epilog,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=f"adagen {__version__}")
    parser.add_argument(
        "-v",
        dest="verbose",
        action="count",
        default=0,
        help="say how long each stage took and what was ignored (-vv: tracebacks too)",
    )
    return parser


def seconds(text: str) -> float:
    """Return a time limit in s, above 0."""
    value = finite(text)
    if value <= 0:
        raise argparse.ArgumentTypeError(f"must be more than 0 s, not {text}")
    return value


def finite(text: str) -> float:
    """Return a finite number."""
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"not a number: {text!r}") from None
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"not a finite number: {text!r}")
    return value


def whole(least: int, most: int) -> Callable[[str], int]:
    """Return what reads a whole number within limits."""

    def read(text: str) -> int:
        digits = text.isascii() and text.isdigit() and len(text) < 12
        if not digits or not least <= int(text) <= most:
            raise argparse.ArgumentTypeError(
                f"must be a whole number from {least} to {most}, not {text!r}"
            )
        return int(text)

    return read
