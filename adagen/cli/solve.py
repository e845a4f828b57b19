"""``adagen solve``: joint accelerations for the states in a file."""

from __future__ import annotations

import argparse
import json
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from adagen.cli.console import Stages, note, progress, say, timed, warn
from adagen.cli.options import add_emission, add_model, add_schedule, check_emission
from adagen.cli.parser import Parser, make_parser, parse, seconds
from adagen.errors import EnvironmentFault

if TYPE_CHECKING:
    from adagen.build import Toolchain
    from adagen.model import Model
    from adagen.states import States

_EPILOG = """\
The states file is JSON: {"floating": false, "gravity": [0, 0, -9.81],
"joints": {NAME: {"q": [...], "v": [...], "tau": [...]}}}, one entry per state
in each list (a number for one degree of freedom, a list for more; the floating
base is called "__base__"). The result is {"joints": {NAME: {"qdd": [...]}}}.

examples:
  adagen solve robot.urdf --procs 2 --states states.json --result result.json
  adagen solve robot.urdf --procs 4 --states states.json | python -m json.tool"""


def command_parser() -> Parser:
    """Return the parser of ``adagen solve``."""
    parser = make_parser(
        "adagen solve", "Compute joint accelerations for the states in a file.", _EPILOG
    )
    add_model(parser, gravity=False)
    add_schedule(parser)
    add_emission(parser)
    parser.add_argument(
        "--states",
        type=Path,
        required=True,
        metavar="FILE",
        help="states to solve for (JSON); - is standard input",
    )
    parser.add_argument(
        "--result", type=Path, metavar="FILE", help="where to write (default: standard output)"
    )
    parser.add_argument(
        "--timeout",
        type=seconds,
        default=600.0,
        metavar="S",
        help="end a run that takes longer (default: 600 s)",
    )
    return parser


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen solve`` with the arguments after the verb; return the exit status."""
    parser = command_parser()
    options = parse(parser, argv)
    check_emission(parser, options)
    options.name = None
    with timed(told=options.verbose) as stages:
        return _solve(options, stages)


CHECKED = 4096
"""States up to which answers are judged: that takes some five evaluations of each."""


def _solve(options: argparse.Namespace, stages: Stages) -> int:
    from adagen.build import build_executable, find_toolchain
    from adagen.build.toolchain import with_compiler
    from adagen.cli import pipeline
    from adagen.cli.files import write_file
    from adagen.states import StatesFile

    file = StatesFile.read(options.states)
    gravity = file.gravity
    model = pipeline.read_model(options, stages, None if gravity is None else gravity.tolist())
    with stages.stage("states"):
        reduction = getattr(options, "reduction", None)  # refused before anything is built
        missing = None if reduction is None else reduction.why_missing
        states = file.states(model, missing)
    made = pipeline.generate(model, options, stages)
    with stages.stage("build"):
        toolchain = with_compiler(find_toolchain(), made.request.compiler)
        executable = build_executable(made.source, made.stem, toolchain, progress=progress)
    processes = 1 if made.plan.threads else made.request.procs  # of a batch the plan is for one
    with stages.stage("run"):
        status, result = _run(executable, processes, toolchain, options, model, states)
    if not result:
        return status
    if options.result is None:
        print(result, end="")
    else:
        write_file(options.result, result)
    return status


def _run(
    executable: Path,
    processes: int,
    toolchain: Toolchain,
    options: argparse.Namespace,
    model: Model,
    states: States,
) -> tuple[int, str]:
    """Run the executable on the states; return its status and the result file's text."""
    from adagen.run import launch
    from adagen.states import write_states

    with (
        tempfile.TemporaryDirectory(prefix="adagen-") as folder,
        progress(f"running on {processes} process{'es' if processes > 1 else ''}", states.count),
    ):
        given, result = Path(folder, "states.json"), Path(folder, "result.json")
        write_states(states, model, given)  # complete: slaved joints may be left out in a file
        words = ["--states", str(given), "--result", str(result), "--json"]
        if states.count <= CHECKED:
            words.append("--check")
        done = launch(executable, processes, words, toolchain, options.timeout)
        report = _report(done.stdout)
        for line in done.stderr.splitlines():
            if report is None or report["fault"] != "solver" or result.name not in line:
                tell = note if done.status == 0 else say
                tell(line.replace(str(given), str(options.states)))
        if report is not None:
            _tell(report, options)
        if done.status != 0 and report is None:
            return done.status, ""
        try:
            return done.status, result.read_text(encoding="utf-8")
        except OSError:
            raise EnvironmentFault(f"{executable.name} ended without a result") from None


def _report(text: str) -> dict[str, Any] | None:
    """What the solver's own check says; None where there was none."""
    try:
        report = json.loads(text)["check"]
    except (ValueError, KeyError):
        return None
    return report if isinstance(report, dict) else None


def _tell(report: dict[str, Any], options: argparse.Namespace) -> None:
    """Warn where answers are wrong, or hardly any digits of them are sure."""
    if report["fault"] is None:
        return
    from adagen.urdf.notes import quoted

    place = f"state {report['state']}, joint {quoted([report['joint']])}"
    if report["fault"] == "solver":
        error = report["backward_error_max"]
        what = "no number" if error is None else f"a backward error of {error:.0e}"
        warn(f"{options.states}: warning: WRONG answers, {what}: {place}; another form may work")
        return
    warn(
        f"{options.states}: warning: {report['digits']:.1f} digits of the accelerations are "
        f"certain: {place}: the robot is ill-conditioned there; --shape unrolled or --refine 1 "
        "may keep more"
    )
