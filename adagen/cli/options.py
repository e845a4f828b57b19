"""The options that subcommands share, in groups, and their checks."""

from __future__ import annotations

import argparse
import re
from dataclasses import dataclass
from pathlib import Path

from adagen.cli.parser import Parser, finite, whole

MOST_PROCESSES = 1024
AUTO = 0
"""What --procs is where it is to be chosen."""

_SEARCH = {
    "--tie": "work",
    "--strategy": "exact",
    "--naive": False,
    "--expansions": None,
    "--split": "always",
    "--parts": "auto",
    "--objective": "both",
}
"""Options of the search for a schedule, and their defaults."""


def add_model(parser: Parser, *, gravity: bool = True, several: bool = False) -> None:
    """Add the robot, or several, and how to read it."""
    if several:
        parser.add_argument(
            "models", nargs="+", metavar="MODEL", help="robot descriptions (URDF, .xacro, MJCF)"
        )
    else:
        parser.add_argument("model", metavar="MODEL", help="robot description (URDF, .xacro, MJCF)")
    group = parser.add_argument_group("robot")
    group.add_argument(
        "--floating", action="store_true", help="put the robot on a floating base (__base__)"
    )
    group.add_argument(
        "--mimic", action="store_true", help="make mimic joints follow instead of leaving them free"
    )
    group.add_argument(
        "--strict",
        action="store_true",
        help="reject harmless mistakes of the file instead of warning about them",
    )
    group.add_argument(
        "--xacro-arg",
        action="append",
        type=_argument,
        metavar="NAME:=VALUE",
        help="value of an <xacro:arg>, where MODEL's name ends in .xacro; may be repeated",
    )
    group.add_argument(
        "--scene",
        metavar="FILE",
        help="scene file: base, locked joints, springs, payloads, ...",
    )
    group.add_argument(
        "--loops",
        metavar="FILE",
        help="close loops by the frame pairs of this file (YAML)",
    )
    if gravity:
        group.add_argument(
            "--gravity",
            nargs=3,
            type=finite,
            metavar=("X", "Y", "Z"),
            help="m/s^2 in ground axes (default: 0 0 -9.81)",
        )


RARE = frozenset(
    [
        "--strict",
        "--xacro-arg",
        "--loops",
        "--gravity",
        "--profile",
        "--schedule",
        "--tie",
        "--strategy",
        "--naive",
        "--expansions",
        "--split",
        "--parts",
        "--objective",
        "--form",
        "--shape",
        "--tune",
        "--tuned",
        "--channel",
        "--refine",
        "--reproducible",
        "--loop-forces",
        "--residual",
        "--runtime",
        "--target",
        "--single-file",
        "--cmake-dir",
        "--name",
    ]
)
"""What most users never say: --help-all shows it."""


def add_schedule(parser: Parser) -> None:
    """Add the number of processes, the schedule, how it is searched, and the algorithm."""
    parser.rare |= RARE
    group = parser.add_argument_group("schedule")
    group.add_argument(
        "--procs",
        type=_processes,
        default=AUTO,
        metavar="P",
        help=f"processes, 1 to {MOST_PROCESSES}, or auto (default): as many as pay",
    )
    group.add_argument(
        "--profile",
        type=profile,
        default="default",
        metavar="NAME|FILE",
        help="cost profile: default, xeon, zen4, avx2, native (the one of these that fits this "
        "machine), paper, one that adagen calibrate has stored, or a TOML file",
    )
    group.add_argument(
        "--schedule",
        default="auto",
        metavar="NAME|FILE",
        help="auto (default: search the best one), balanced (Featherstone's divide and "
        "conquer), sequential (from the ends to the ground), middle-out (from the ends to the "
        "middle), or a file as `adagen schedule --json` prints it",
    )
    _add_search(parser)
    _add_algorithm(parser)


def _add_search(parser: Parser) -> None:
    group = parser.add_argument_group("search for the schedule")
    group.add_argument(
        "--tie",
        choices=("work", "lex"),
        default=_SEARCH["--tie"],
        help="among equally fast schedules: least work (default) or the paper's first",
    )
    group.add_argument(
        "--strategy",
        choices=("exact", "astar", "paper"),
        default=_SEARCH["--strategy"],
        help="search method: branch and bound over partial chains (exact, default), A* (astar), "
        "or A* with the paper's own bounds and successors (paper)",
    )
    group.add_argument(
        "--naive",
        action="store_true",
        help="let A* use the paper's naive NextNodes() instead of the improved one",
    )
    group.add_argument(
        "--expansions",
        type=whole(1, 10**9),
        metavar="N",
        help="limit of the search, in expanded nodes (default: some seconds); a schedule that "
        "is not proven optimal says so",
    )
    group.add_argument(
        "--split",
        choices=("always", "free", "any"),
        default=_SEARCH["--split"],
        help="whether two branches always divide their processes (default, as in the paper), may "
        "share them (free), or may also divide them unevenly (any)",
    )
    group.add_argument(
        "--parts",
        choices=("auto", "none"),
        default=_SEARCH["--parts"],
        help="auto (default): long chains are swept in parts, one in each SIMD lane, where the "
        "profile predicts that it pays; none: never",
    )
    group.add_argument(
        "--objective",
        choices=("time", "accuracy", "both"),
        default=_SEARCH["--objective"],
        help="goal of the search: time only, accuracy first, or time among cuts that lose no "
        "more than a few digits (both, default)",
    )


def _add_algorithm(parser: Parser) -> None:
    group = parser.add_argument_group("algorithm")
    group.add_argument(
        "--form",
        choices=("segment", "ada"),
        default="segment",
        help="algorithm: articulated bodies inside each process and joins at the cuts (segment, "
        "default), or the paper's, joint by joint (ada)",
    )
    group.add_argument(
        "--scalar",
        choices=("double", "float"),
        default="double",
        metavar="TYPE",
        help="double (default) or float",
    )
    group.add_argument(
        "--reproducible",
        action="store_true",
        help="the same answers to the last bit on any number of processes, with any compiler and "
        "on any x86-64 processor",
    )


def add_emission(parser: Parser) -> None:
    """Add how the code is shaped."""
    group = parser.add_argument_group("emitted code")
    group.add_argument(
        "--loop-forces",
        action="store_true",
        help="also give the forces of loops and couplings (docs/how_to/loops.md)",
    )
    group.add_argument(
        "--refine",
        type=whole(0, 9),
        metavar="N",
        help="refine answers N times and report their error",
    )
    group.add_argument(
        "--residual",
        choices=("auto", "own", "wide"),
        default="auto",
        help="find residuals of --refine in the solver's own numbers (own: quick), in wide ones "
        "(wide: exact), or in its own where loops have them (auto, default)",
    )
    group.add_argument(
        "--certify",
        action="store_true",
        help="give an error bound with each answer",
    )
    group.add_argument(
        "--shape",
        choices=("auto", "unrolled", "kernels", "joints"),
        default="auto",
        help="shape of the code: a straight line of scalar statements (unrolled), loops over runs "
        "of joints (kernels), a function for each joint and step (joints, form ada alone), or what "
        "should be fastest for the robot (auto, default)",
    )
    group.add_argument(
        "--batch",
        action="store_true",
        help="solve many states at once, one per SIMD lane",
    )
    group.add_argument(
        "--tune",
        action="store_true",
        help="build every shape with every compiler found, time them, keep the fastest",
    )
    group.add_argument(
        "--tuned",
        type=_tuned,
        metavar="SHAPE:N:COMPILER",
        help="repeat a result of --tune, as written in the head of a source",
    )
    group.add_argument(
        "--channel",
        choices=("auto", "window", "message", "threads"),
        default="auto",
        help="exchange between processes: shared window on one node and messages elsewhere "
        "(auto, default), or one of them; threads: threads of one program, without MPI",
    )


def add_out(parser: Parser) -> None:
    """Add where files are written."""
    parser.add_argument(
        "--out", type=Path, default=Path(), metavar="DIR", help="where to write (default: here)"
    )


def refinement(options: argparse.Namespace) -> int:
    """Return how many steps of refinement the options ask for."""
    from adagen.emit.refine import checked_steps

    return checked_steps(getattr(options, "refine", None))


def check_search(parser: Parser, options: argparse.Namespace) -> None:
    """Refuse options of a search that is not done.

    Raises:
        UsageError: such an option is given.
    """
    if options.naive and options.strategy == "exact":
        parser.error("--naive is for --strategy astar or paper")
    if options.schedule == "auto":
        return
    for name, default in _SEARCH.items():
        if getattr(options, name.removeprefix("--")) != default:
            parser.error(
                f"{name} is for a schedule that is searched: leave out {name} or --schedule"
            )


def check_emission(parser: Parser, options: argparse.Namespace) -> None:
    """Refuse what cannot be emitted, whatever the robot.

    Raises:
        UsageError: options exclude each other.
    """
    from adagen.emit import check_batch, check_form, check_reproducible
    from adagen.emit.refine import checked_shape

    check_search(parser, options)
    steps = refinement(options)
    if options.reproducible:
        check_reproducible(options.form, steps, options.shape)
    checked_shape(steps, options.shape)
    if options.batch:
        check_batch(options.shape, steps, options.channel)
        if options.tune or options.tuned is not None:
            parser.error("batches are not tuned: leave out --tune or --batch")
    check_form(options.form, options.shape if options.tuned is None else options.tuned.shape)
    if options.tuned is not None and (options.tune or options.shape != "auto"):
        parser.error("--tuned replaces --tune and --shape: leave those out")


@dataclass(frozen=True)
class Tuned:
    """What was found by trying: shape, values of a function (0: default), compiler ("": any)."""

    shape: str
    chunk: int
    compiler: str


def _tuned(text: str) -> Tuned:
    """Return what --tune had found."""
    shape, _, rest = text.partition(":")
    chunk, _, compiler = rest.partition(":")
    if shape not in ("unrolled", "kernels", "joints") or not re.fullmatch(r"[\w+.-]*", compiler):
        raise argparse.ArgumentTypeError(f"not SHAPE:N:COMPILER: {text!r}")
    return Tuned(shape, whole(0, 10**9)(chunk), compiler)


def _argument(text: str) -> tuple[str, str]:
    """Return name and value of an argument for xacro."""
    name, sign, value = text.partition(":=")
    if not (name and sign):
        raise argparse.ArgumentTypeError(f"not NAME:=VALUE: {text!r}")
    return name, value


def profile(text: str) -> str:
    """Return the name of a cost profile, or its file; of native, that of the one that fits."""
    from adagen.build.native_profile import profile_named

    return profile_named(text)


def _processes(text: str) -> int:
    """Return a number of processes; 0 for auto."""
    return AUTO if text == "auto" else whole(1, MOST_PROCESSES)(text)
