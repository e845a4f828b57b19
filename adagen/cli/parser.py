"""An argument parser with one-line errors and common help for all subcommands.

``--help`` shows what is used often, ``--help-all`` everything.
"""

from __future__ import annotations

import argparse
import difflib
import math
import re
from collections.abc import Callable, Sequence
from typing import NoReturn, TypeVar

from adagen.errors import UsageError, printable
from adagen.version import __version__

Item = TypeVar("Item")


class Parser(argparse.ArgumentParser):
    """An argument parser whose complaints are ``error:`` lines with status 2."""

    words: Sequence[str] = ()
    """What is being parsed."""

    rare: frozenset[str] = frozenset()
    """Options that --help leaves to --help-all."""

    short_epilog: str | None = None
    """What --help ends with where --help-all ends otherwise."""

    def format_help(self) -> str:
        """Return what --help prints: one list without the rare options, what all have last."""
        shown = [each for each in self._actions if not self._is_rare(each)]
        shown.sort(key=lambda each: not _EVERYWHERE.isdisjoint(each.option_strings))
        shown.sort(key=lambda each: bool(each.option_strings))
        formatter = self._get_formatter()
        formatter.add_usage(self.usage or self._short_usage(), [], [])
        formatter.add_text(self.description)
        formatter.start_section("options")
        formatter.add_arguments(shown)
        formatter.end_section()
        formatter.add_text(self.short_epilog or self.epilog)
        return formatter.format_help()

    def _is_rare(self, action: argparse.Action) -> bool:
        return not (self.rare or {"--help-all"}).isdisjoint(action.option_strings)

    def _short_usage(self) -> str:
        """Return the usage line of --help: what must be given, and that there are options."""
        needed = [
            " ".join([*each.option_strings[:1], str(each.metavar or each.dest)])
            + (" ..." if each.nargs == "+" else "")
            for each in self._actions
            if each.required
        ]
        return " ".join([self.prog, *needed, "[option ...]"])

    def format_help_all(self) -> str:
        """Return what --help-all prints: all options."""
        return super().format_help()

    def error(self, message: str) -> NoReturn:
        """Raise the complaint with where to read on; what is misspelt goes before what follows."""
        unknown = next(filter(self._is_unknown, self.words), None)
        if unknown is not None:
            message = f"unknown option {unknown}{self._nearest(unknown)}"
        raise UsageError(f"{printable(message)}; see {self.prog} --help")

    def _is_unknown(self, word: str) -> bool:
        """Tell whether a word is an option that this parser does not have."""
        name = _OPTION.match(word)
        known = self._option_string_actions
        return name is not None and name[0] not in known and not re.fullmatch("-v+", word)

    def _nearest(self, unknown: str) -> str:
        names = {name.lstrip("-"): name for name in self._option_string_actions}
        word = unknown.lstrip("-").partition("=")[0]
        near = difflib.get_close_matches(word, names, n=1)
        return f" (did you mean {names[near[0]]}?)" if near else ""


_EVERYWHERE = frozenset({"--help", "--help-all", "--version", "-v", "--quiet"})
"""Options that every command has."""


class _HelpAll(argparse.Action):
    """Prints the help of all options and leaves."""

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> NoReturn:
        assert isinstance(parser, Parser)
        print(parser.format_help_all(), end="")
        parser.exit()


_OPTION = re.compile(r"(--?[A-Za-z][A-Za-z0-9_-]+)(?=$|=)")
"""An option and not its value: values with blanks may hold options of another command."""


def parse(parser: Parser, argv: Sequence[str]) -> argparse.Namespace:
    """Return the options that the words say.

    Raises:
        UsageError: the words are not a command line of this parser.
    """
    words = list(argv)
    parser.words = words[: words.index("--")] if "--" in words else words
    options = parser.parse_args(words)
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
    parser.add_argument("--help-all", action=_HelpAll, nargs=0, help="show all options")
    parser.add_argument("--version", action="version", version=f"adagen {__version__}")
    words = parser.add_mutually_exclusive_group()
    words.add_argument(
        "-v",
        dest="verbose",
        action="count",
        default=0,
        help="print what was ignored, and the time of each stage",
    )
    words.add_argument("-q", "--quiet", action="store_true", help="print warnings and errors only")
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


def among(known: Sequence[str]) -> Callable[[str], str]:
    """Return what reads one of some words."""

    def read(text: str) -> str:
        if text not in known:
            raise argparse.ArgumentTypeError(f"{text!r} is none of {', '.join(known)}")
        return text

    return read


def listed(one: Callable[[str], Item]) -> Callable[[str], tuple[Item, ...]]:
    """Return what reads a list with commas, each item by itself and once."""
    return lambda text: tuple(dict.fromkeys(one(word.strip()) for word in text.split(",")))
