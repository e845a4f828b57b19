"""The options of ``adagen chart``."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from adagen.cli.options import add_model, add_out
from adagen.cli.parser import Parser, among, listed, make_parser, seconds, whole
from adagen.errors import UsageError

if TYPE_CHECKING:
    from adagen.studies.chart import Budget

_DESCRIPTION = """\
Draw a work-precision diagram of each robot: time per evaluation against largest
forward error (reference: 100 digits), for every algorithm, schedule, number
type, number of processes and refinement; with --simulate, for integrators."""

_EPILOG = """\
For each MODEL it writes chart_NAME.svg, .png and the record, .json. The first
run compiles some dozens of programs, which takes minutes; they are kept.

examples:
  adagen chart arm.urdf                          pictures, data of one robot
  adagen chart arm.urdf --budget "error<1e-10"   emit the fastest that fits
  adagen chart arm.urdf --states mine.json       errors in states of your own
  adagen chart chart_arm.json                    draw a record again
  adagen chart arm.urdf --simulate 1             integrators: error against time"""

_RARE = frozenset(
    [
        *("--strict", "--xacro-arg", "--gravity", "--refine", "--shapes", "--algorithms"),
        *(
            "--schedules",
            "--objective",
            "--whole",
            "--peers",
            "--states",
            "--rounds",
            "--step",
            "--no-picture",
        ),
        *("--mimic", "--loops"),
    ]
)
"""What --help leaves to --help-all."""

_SCALARS = ("double", "float")
_LEAST_STATES = 20
LARGEST_STEP = 0.008
"""Largest step of a chart of integrators where none is given, s."""


def command_parser() -> Parser:
    """Return the parser of ``adagen chart``."""
    parser = make_parser("adagen chart", _DESCRIPTION, _EPILOG)
    parser.rare |= _RARE
    add_model(parser, several=True)
    parser.add_argument(
        "--budget",
        type=_budget,
        metavar="TERMS",
        help="say which variant to use and emit it: error<1e-10, time<2us, or both with a comma",
    )
    add_out(parser)
    parser.add_argument("--no-picture", dest="picture", action="store_false", help="data alone")
    _add_variants(parser)
    _add_measurement(parser)
    _add_simulation(parser)
    return parser


def _add_variants(parser: Parser) -> None:
    from adagen.search.objective import OBJECTIVES

    add = parser.add_argument_group("what takes part").add_argument
    add(
        "--procs",
        type=listed(whole(1, 64)),
        default=(1, 2, 4),
        metavar="P,...",
        help="numbers of processes (default: 1,2,4); where they exceed the cores, times are from "
        "measured stretches of computing",
    )
    add(
        "--scalars",
        type=listed(among(_SCALARS)),
        default=_SCALARS,
        metavar="NAME,...",
        help="number types (default: double,float)",
    )
    add(
        "--refine",
        type=listed(whole(0, 9)),
        metavar="N,...",
        default=(0, 1),
        help="steps of iterative refinement (default: 0,1)",
    )
    _add_names(add)
    add(
        "--objective",
        choices=OBJECTIVES,
        default="both",
        help="what schedules and shapes are searched for: both (default), time or accuracy",
    )
    add(
        "--whole", action="store_true", help="all combinations: schedules in float and refined, too"
    )
    add("--peers", action="store_true", help="also pinocchio, casadi and MuJoCo, if installed")


def _add_names(add: Callable[..., Any]) -> None:
    """Add the options that name what is tried, by the argument group's ``add_argument``."""
    from adagen.emit.shapes import BASELINES
    from adagen.studies.chart.variants import ALGORITHMS, SCHEDULES, SHAPES

    for name, what, known, default in (
        ("--shapes", "code shapes of form segment, ", SHAPES, None),
        ("--algorithms", f"{', '.join(BASELINES)} are baselines; ", ALGORITHMS, None),
        ("--schedules", "", tuple(SCHEDULES), SCHEDULES[:1]),
    ):
        shown = "all" if default is None else ", ".join(default)
        add(
            name,
            type=listed(among(known)),
            default=known if default is None else default,
            metavar="NAME,...",
            help=f"{what}of {', '.join(known)} (default: {shown})",
        )


def _add_measurement(parser: Parser) -> None:
    add = parser.add_argument_group("measurement").add_argument
    add(
        "--states",
        type=_states,
        default=_LEAST_STATES,
        metavar="N|FILE",
        help="number of random states over which the largest error counts (default and minimum: "
        f"{_LEAST_STATES}), or a states file",
    )
    add(
        "--rounds",
        type=whole(1, 1000),
        default=5,
        metavar="N",
        help="rounds of interleaved timing (default: 5)",
    )
    add("--quick", action="store_true", help="two rounds, one schedule, no refinement")


def _add_simulation(parser: Parser) -> None:
    add = parser.add_argument_group("integrators").add_argument
    add(
        "--simulate",
        type=seconds,
        metavar="S",
        help="chart integrators instead, over S seconds of motion without torques",
    )
    add(
        "--step",
        type=seconds,
        metavar="H",
        help=f"largest step of --simulate, in seconds (default: {LARGEST_STEP})",
    )


def _states(text: str) -> int | str:
    """How many states, or the file of given ones."""
    return text if not text.isdecimal() else int(whole(_LEAST_STATES, 10_000)(text))


def _budget(text: str) -> Budget:
    from adagen.studies.chart import parse_budget

    try:
        return parse_budget(text)
    except UsageError as error:
        raise argparse.ArgumentTypeError(error.reason) from None
