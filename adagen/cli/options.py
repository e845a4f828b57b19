"""The options that subcommands share, and a parser that fails in one line."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Sequence
from typing import NoReturn

from adagen import __version__
from adagen.errors import UsageError, printable

MOST_PROCESSES = 1024
AUTO = 0
"""What --procs is where it is to be chosen."""


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


def add_model(
    parser: argparse.ArgumentParser, *, gravity: bool = True, several: bool = False
) -> None:
    """Add the robot, or several, and how to read it."""
    if several:
        parser.add_argument("models", nargs="+", metavar="MODEL", help="robot descriptions (URDF)")
    else:
        parser.add_argument("model", metavar="MODEL", help="robot description (URDF)")
    parser.add_argument(
        "--floating", action="store_true", help="put the robot on a floating base (__base__)"
    )
    parser.add_argument(
        "--mimic", action="store_true", help="slave mimic joints instead of leaving them free"
    )
    parser.add_argument(
        "--scene",
        metavar="FILE",
        help="what is asked of the robot (TOML, docs/scenes.md): base, locked joints, damping, "
        "forces, ...; only the model that this needs is treated",
    )
    if gravity:
        parser.add_argument(
            "--gravity",
            nargs=3,
            type=_finite,
            metavar=("X", "Y", "Z"),
            help="m/s^2 in ground axes (default: 0 0 -9.81)",
        )


def add_schedule(parser: argparse.ArgumentParser) -> None:
    """Add the number of processes and how the schedule is searched."""
    parser.add_argument(
        "--procs",
        type=_processes,
        required=True,
        metavar="P",
        help=f"number of processes, 1 to {MOST_PROCESSES}, or auto: as many as the cost profile "
        "predicts to pay on this machine's cores",
    )
    parser.add_argument(
        "--profile",
        default="default",
        metavar="NAME|FILE",
        help="what operations cost: a shipped profile (default, paper), one that adagen calibrate "
        "has stored, or a TOML file",
    )
    parser.add_argument(
        "--tie",
        choices=("work", "lex"),
        default="work",
        help="among equally fast schedules: least work (default) or the paper's first",
    )
    parser.add_argument(
        "--strategy",
        choices=("exact", "astar", "paper"),
        default="exact",
        help="how it is searched: over partial chains (exact, default), by A*, or by A* with the "
        "paper's own bounds and successors",
    )
    parser.add_argument(
        "--naive",
        action="store_true",
        help="let A* use the paper's naive NextNodes() instead of the improved one",
    )
    parser.add_argument(
        "--expansions",
        type=_whole(1, 10**9),
        metavar="N",
        help="how much the search may expand (default: what takes seconds); a schedule that is "
        "not proven optimal says so",
    )
    parser.add_argument(
        "--split",
        choices=("always", "free", "any"),
        default="always",
        help="whether two branches always divide their processes (default, as in the paper), may "
        "share them (free), or may also divide them unevenly (any)",
    )
    parser.add_argument(
        "--objective",
        choices=("time", "accuracy", "both"),
        default="both",
        help="what the schedule is searched for: time alone, accuracy above all, or time among "
        "cuts that lose no more than a few digits (both, default)",
    )
    parser.add_argument(
        "--schedule",
        default="auto",
        metavar="NAME|FILE",
        help="search the best one (auto, default), or take this: balanced (Featherstone's divide "
        "and conquer), sequential (from the ends to the ground), middle-out (from the ends to the "
        "middle), or a file as `adagen schedule --json` prints it",
    )
    parser.add_argument(
        "--form",
        choices=("segment", "ada"),
        default="segment",
        help="form of the algorithm: articulated bodies inside each process and joins at the cuts "
        "(segment, default), or the paper's, joint by joint (ada)",
    )
    parser.add_argument(
        "--scalar",
        choices=("double", "float"),
        default="double",
        help="number type (default: double)",
    )


def add_emission(parser: argparse.ArgumentParser) -> None:
    """Add how the code is shaped."""
    parser.add_argument(
        "--refine",
        type=_whole(0, 9),
        default=0,
        metavar="N",
        help="refine each answer N times with wider residuals, and tell its error (default: 0)",
    )
    parser.add_argument(
        "--shape",
        choices=("auto", "unrolled", "kernels", "joints"),
        default="auto",
        help="shape of the code: a straight line of scalar statements (unrolled), loops over runs "
        "of joints (kernels), a function for each joint and step (joints), or what should be "
        "fastest for the robot (auto, default)",
    )
    parser.add_argument(
        "--batch",
        action="store_true",
        help="solve many states at once, one in each lane of the widest registers; processes share "
        "the states of a batch instead of the robot",
    )
    parser.add_argument(
        "--tune",
        action="store_true",
        help="build every shape with every compiler at hand, time them, and keep the fastest",
    )
    parser.add_argument(
        "--channel",
        choices=("auto", "window", "message"),
        default="auto",
        help="between processes: shared window on one node and messages elsewhere (auto), or "
        "one of them",
    )


def _processes(text: str) -> int:
    """Return a number of processes; 0 for auto."""
    return AUTO if text == "auto" else _whole(1, MOST_PROCESSES)(text)


def seconds(text: str) -> float:
    """Return a time limit in s, above 0."""
    value = _finite(text)
    if value <= 0:
        raise argparse.ArgumentTypeError(f"must be more than 0 s, not {text}")
    return value


def _finite(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"not a number: {text!r}") from None
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"not a finite number: {text!r}")
    return value


def _whole(least: int, most: int) -> Callable[[str], int]:
    """Return what reads a whole number within limits."""

    def read(text: str) -> int:
        digits = text.isascii() and text.isdigit() and len(text) < 12
        if not digits or not least <= int(text) <= most:
            raise argparse.ArgumentTypeError(
                f"must be a whole number from {least} to {most}, not {text!r}"
            )
        return int(text)

    return read
