"""``adagen report``: one HTML page about a robot and its program."""

from __future__ import annotations

import argparse
import json
import shlex
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from adagen.cli.console import progress, speaking, timed, warn, warned, wrote
from adagen.cli.options import add_emission, add_model, add_out, add_schedule, check_emission
from adagen.cli.parser import Parser, make_parser, parse
from adagen.errors import EnvironmentFault, InputError, printable

if TYPE_CHECKING:
    from adagen.library import Compiled
    from adagen.model import Model
    from adagen.report import Accuracy, Measured, Scene
    from adagen.studies.chart import Chart

_DESCRIPTION = """\
Write one HTML page about a robot and its solver: a posable skeleton, a timeline
of the program, predicted and measured times. It needs no network."""

_EPILOG = """\
examples:
  adagen report robot.urdf --out page               what is predicted
  adagen report robot.urdf --procs 2 --run --out page     and measured here
  adagen report robot.urdf --record chart_robot.json      and error against time"""

TIMEOUT = 600.0
"""Seconds that a run may take."""


def command_parser() -> Parser:
    """Return the parser of ``adagen report``."""
    parser = make_parser("adagen report", _DESCRIPTION, _EPILOG)
    parser.usage = "adagen report MODEL [--procs P] [--run] [--out DIR] [option ...]"
    add_model(parser)
    add_schedule(parser)
    add_emission(parser)
    add_out(parser)
    parser.add_argument(
        "--run", action="store_true", help="build and run it: measured and predicted times"
    )
    parser.add_argument(
        "--record", type=Path, metavar="FILE", help="chart_NAME.json that adagen chart wrote"
    )
    return parser


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen report`` with the arguments after the verb; return the exit status."""
    parser = command_parser()
    options = parse(parser, argv)
    check_emission(parser, options)
    if options.run and options.batch:
        parser.error("--run is for one state at a time: leave out --batch")
    options.name = None

    from adagen.atomic_files import write_files
    from adagen.cli import pipeline
    from adagen.report import document, page

    with timed(told=options.verbose) as stages:
        model, reading = pipeline.read_whole(options, stages, options.gravity)
        chart = None if options.record is None else _chart(options.record, model, options.scene)
        made = pipeline.generate(model, options, stages)
        measured, accuracy = None, None
        if options.run:
            with stages.stage("run"):
                measured, accuracy = _measured(made)
        data = document(
            made,
            _commands(made, argv, run=options.run),
            measured=measured,
            accuracy=accuracy,
            scene=_scene(made, options),
            chart=chart,
            remarks=[*warned(), *reading.ignored],
        )
        name = f"{made.stem}_report.html"
        with stages.stage("write"):
            write_files(options.out, {name: page(data)})
    wrote([options.out / name])
    return 0 if measured is None or measured.right else 1


def _chart(path: Path, model: Model, scene: str | None) -> Chart:
    """Read the chart of a robot.

    Raises:
        InputError: it is none, or another robot's, or of this one with another scene or base.
    """
    from adagen.studies.chart import mechanism_of, read_chart

    found = read_chart(path)
    if found.model not in (model.name, path.stem.removeprefix("chart_")):
        raise InputError(f"a chart of {printable(found.model)}, not of {model.name}", str(path))
    if found.dof != model.nv or found.mechanism not in ("", mechanism_of(model)):
        raise InputError(
            f"a chart of {printable(found.model)} with another scene or base, or of an earlier "
            "version of it: make it with the options of this report",
            str(path),
        )
    if scene is not None and not found.mechanism:
        warn(f"{path}: warning: an old record does not say whether it was made with the scene")
    return found


def _scene(made: Compiled, options: argparse.Namespace) -> Scene | None:
    if options.scene is None:
        return None
    from adagen.library.savings import predicted_savings
    from adagen.report import Scene
    from adagen.scene.report import removed

    lines = removed(options.reduction)
    if options.reduction.all_left:
        lines.append("it leaves out nothing of the robot")
    else:
        lines.append(
            predicted_savings(made.plan, made.schedule, options.reduction, made.request)[0]
        )
    return Scene(str(options.scene), tuple(each.removeprefix("scene: ") for each in lines))


def _measured(made: Compiled) -> tuple[Measured, Accuracy]:
    """Build and run a solver, with its check, its clock and its trace; and judge its answers.

    Raises:
        EnvironmentFault: it cannot be built, or a run fails.
    """
    from adagen.build import build_executable, find_toolchain
    from adagen.build.toolchain import with_compiler
    from adagen.report import accuracy_of
    from adagen.run import launch
    from adagen.run.trace import read_trace

    toolchain = with_compiler(find_toolchain(), made.request.compiler)
    executable = build_executable(made.source, made.stem, toolchain, progress=progress)
    processes = 1 if made.plan.threads else made.request.procs
    with (
        tempfile.TemporaryDirectory(prefix="adagen-") as folder,
        progress(f"measuring {made.stem}", 1),
    ):
        trace = Path(folder, "trace.json")
        words = ["--check", "--time", "--json", "--trace", str(trace)]
        done = launch(executable, processes, words, toolchain, TIMEOUT)
        report = _reported(done.stdout)
        if report is None:
            raise EnvironmentFault(done.stderr.removeprefix("error: ") or "the run printed nothing")
        names = [joint.name for joint in made.model.joints]
        line = read_trace(str(trace), names, made.request.procs) if trace.is_file() else None

    def run(words: list[str]) -> None:
        _ = launch(executable, processes, words, toolchain, TIMEOUT).printed

    with speaking("judging answers") as on_progress:
        return _as_measured(report, line), accuracy_of(made, run, on_progress)


def _reported(text: str) -> dict[str, Any] | None:
    try:
        report = json.loads(text)
    except ValueError:
        return None
    complete = isinstance(report, dict) and {"time", "check"} <= report.keys()
    return report if complete else None


def _as_measured(report: dict[str, Any], line: Any) -> Measured:
    from adagen.report import Measured

    time, check = report["time"], report["check"]
    spent = time["in_place"]
    return Measured(
        median=spent["median_ns"] / 1e3,
        least=spent["min_ns"] / 1e3,
        source=time["source"],
        error=check["forward_error"],
        digits=check["digits"],
        right=bool(check["ok"]),
        timeline=line,
    )


def _launcher() -> list[str]:
    """Return how several processes are started by hand, by root with its permission."""
    from adagen.build import find_toolchain

    allowed = [f"{n}={v}" for n, v in find_toolchain().environment if "RUN_AS_ROOT" in n]
    return [*(["env", *allowed] if allowed else []), "mpiexec", "-n"]


def _commands(made: Compiled, argv: Sequence[str], *, run: bool) -> dict[str, str]:
    """Return the command behind each part of the page."""
    from adagen.library.command import command_of, robot_words

    here = Path()
    robot, solver = (
        list(robot_words(made.origin, here)),
        command_of(made.origin, made.request, here),
    )
    found = {
        "page": ["adagen", "report", *argv],
        "robot": ["adagen", "info", *robot],
        "program": solver,
        "scene": [*solver, "-v"],
        "chart": ["adagen", "chart", *robot],
        "run": ["adagen", "report", *argv, "--run"],
        "record": ["adagen", "report", *argv, "--record", f"chart_{made.origin.path.stem}.json"],
    }
    if run:
        found["accuracy"] = found["page"]
        start = [] if made.request.procs == 1 else [*_launcher(), str(made.request.procs)]
        words = ["--check", "--time", "--trace", "trace.json"]
        found["measured"] = [*start, f"./{made.stem}", *words]
    return {part: printable(shlex.join(words)) for part, words in found.items()}
