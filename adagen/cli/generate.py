"""``adagen MODEL --procs P``: from a robot description to C++/MPI, ready for make."""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from adagen.cli.console import note, timed, warned, wrote
from adagen.cli.options import add_emission, add_model, add_out, add_schedule, check_emission
from adagen.cli.parser import Parser, make_parser, parse
from adagen.errors import EnvironmentFault

if TYPE_CHECKING:
    from adagen.library import Compiled

_DESCRIPTION = """\
Compile a robot description into C++ code for its forward dynamics."""

_SHORT_EPILOG = """\
commands, each with --help (exit status: 0 done, 1 input, 2 usage, 3 tool):
  info MODEL       joints, coordinates    report MODEL      an HTML report
  schedule MODEL   who computes what      chart MODEL       error against time
  solve MODEL      build, run on states   bench MODEL       compare with others
  verify DIR       generate, compare      stability         where methods fail
  calibrate        this machine's costs   completion SHELL  bash, zsh, fish
  env              compiler, MPI, Eigen
examples:
  adagen robot.urdf --out robot_solver && make -C robot_solver check time"""

_EPILOG = """\
commands (each has a --help of its own):
  adagen info MODEL                     joints, coordinates, what is ignored
  adagen schedule MODEL                 which process does what; predicted time
  adagen verify DIR ...                 generate again and compare
  adagen solve MODEL --states FILE      generate, build, run for given states
  adagen calibrate                      measure this machine's costs
  adagen bench MODEL ...                compare with Pinocchio, casadi, MuJoCo
  adagen chart MODEL ...                chart error against time
  adagen stability                      where methods fail; digits kept
  adagen report MODEL --out DIR         an HTML report
  adagen env                            the compiler, MPI and Eigen in use
  adagen completion SHELL               for bash, zsh or fish

examples:
  adagen robot.urdf --out robot_solver  write the solver
  make -C robot_solver check time       build it, check its answers, time it

exit status: 0 done, 1 bad input, 2 wrong usage, 3 fault of tool or environment"""

_LESS_COMMON = frozenset(
    ["--mimic", "--scalar", "--batch", "--certify", "--help", "--version", "-v"]
)
"""What --help leaves to --help-all, so that it fits a screen of 24 lines."""


class _CMakeFolder(argparse.Action):
    """Prints the folder and ends."""

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        from adagen.emit.templates import templates_folder

        print(templates_folder() / "cmake")
        parser.exit()


def command_parser() -> Parser:
    """Return the parser of ``adagen MODEL``."""
    parser = make_parser("adagen", _DESCRIPTION, _EPILOG)
    parser.usage = "adagen MODEL [--procs P] [--out DIR] [option ...]"
    parser.short_epilog = _SHORT_EPILOG
    add_model(parser)
    add_schedule(parser)
    add_emission(parser)
    add_out(parser)
    parser.add_argument("--name", help="name of the files (default: MODEL's)")
    parser.add_argument(
        "--target",
        choices=("host", "embedded"),
        default="host",
        help="embedded: no heap, exceptions, threads or output; the caller gives the memory",
    )
    parser.add_argument(
        "--runtime",
        default="",
        metavar="WORDS",
        help="constants that can be set at run time, comma-separated: gravity, mass:LINK, "
        "center:LINK",
    )
    parser.add_argument(
        "--single-file",
        action="store_true",
        help="include the program around the solver, so that the source stands alone",
    )
    parser.add_argument(
        "--cmake-dir",
        action=_CMakeFolder,
        nargs=0,
        help="print where CMake's find_package(adagen) finds adagen_add_solver",
    )
    parser.add_argument(
        "--json", action="store_true", help="print what was written and predicted as JSON"
    )
    parser.rare |= _LESS_COMMON
    return parser


def options_of(argv: Sequence[str]) -> argparse.Namespace:
    """Return the options of ``adagen MODEL``.

    Raises:
        UsageError: the words are no such command line.
    """
    parser = command_parser()
    options = parse(parser, argv)
    check_emission(parser, options)
    return options


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen MODEL`` with the given arguments; return the exit status."""
    options = options_of(argv)

    from adagen.cli import pipeline
    from adagen.cli.predicted import batch_prediction, prediction

    with timed(told=options.verbose) as stages:
        model = pipeline.read_model(options, stages, options.gravity)
        made = pipeline.generate(model, options, stages)
        line = batch_prediction(made) if options.batch else prediction(made.schedule, made.timeline)
        with stages.stage("write"):
            written = made.write(options.out)
    if options.json:
        print(json.dumps(_report(made, written), indent=1))
    else:
        wrote(written)
        note(line)
    if options.profile == "default" and options.target == "host":
        _tell_native_profile()
    return 0


def _tell_native_profile() -> None:
    """Say which shipped profile fits this machine, if that is not the default."""
    from adagen.build.native_profile import profile_named
    from adagen.schedule.profile import NATIVE

    try:
        fitting = profile_named(NATIVE)
    except EnvironmentFault:
        return  # there is no compiler here: the solver is for another machine
    if fitting != "default":
        note(f"this processor is more like that of profile {fitting}: --profile {NATIVE} takes it")


def _report(made: Compiled, written: Sequence[Path]) -> dict[str, Any]:
    """Return the written files and the predictions as plain data."""
    digits, hard = made.digits, made.hard_digits
    return {
        "robot": made.model.name,
        "floating": made.model.floating,
        "joints": len(made.model.joints),
        "nq": made.model.nq,
        "nv": made.model.nv,
        "processes": made.request.procs,
        "batch": made.request.batch,
        "form": made.request.form,
        "scalar": made.request.scalar,
        "shape": made.program.shape,
        "profile": made.request.profile,
        "predicted_us": made.predicted,
        "proven": made.schedule.verdict == "optimal",
        "digits": None if digits is None else round(digits, 2),
        "hard_digits": None if hard is None else round(hard, 2),
        "source": next(str(path) for path in written if path.name == f"{made.stem}.cpp"),
        "files": [str(path) for path in written],
        "warnings": warned(),
    }
