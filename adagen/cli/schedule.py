"""``adagen schedule``: the schedule of a robot and its predicted time."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from adagen.cli.console import timed
from adagen.cli.hosts import show_hosts
from adagen.cli.options import AUTO, add_model, add_schedule, check_search
from adagen.cli.parser import Parser, make_parser, parse
from adagen.cli.predicted import accuracy_line, prediction, with_accuracy
from adagen.cli.tables import table_of, wrapped

if TYPE_CHECKING:
    import argparse

    from adagen.cost import Timeline
    from adagen.library.assessment import Assessed
    from adagen.model import Model
    from adagen.program import Program
    from adagen.schedule import Schedule

_EPILOG = """\
examples:
  adagen schedule robot.urdf --procs 4                    a summary for people
  adagen schedule robot.urdf --procs 4 --svg tree.svg     a drawing
  adagen schedule robot.urdf --procs 4 --json             the tree, for programs
  adagen schedule robot.urdf --procs 4 --program          what runs, as JSON
  adagen schedule robot.urdf --procs 4 --profile paper --tie lex    the paper's
  adagen schedule robot.urdf --hosts hosts            predict for several hosts"""


def command_parser() -> Parser:
    """Return the parser of ``adagen schedule``."""
    parser = make_parser("adagen schedule", "Find and show the schedule of a robot.", _EPILOG)
    add_model(parser, gravity=False)
    add_schedule(parser)
    printed = parser.add_mutually_exclusive_group()
    printed.add_argument("--json", action="store_true", help="print the schedule tree as JSON")
    printed.add_argument(
        "--program",
        action="store_true",
        help="print the program as JSON: operations of each process in order, messages, lanes",
    )
    parser.add_argument("--svg", type=Path, metavar="FILE", help="draw the schedule tree")
    parser.add_argument(
        "--hosts",
        type=Path,
        metavar="FILE",
        help="predict on how many hosts single evaluations and batches pay; FILE as mpiexec "
        "--hostfile reads it, profile from adagen calibrate --hosts; or FILE.toml, the levels of a "
        "cluster",
    )
    parser.add_argument(
        "--trace",
        metavar="FILE",
        help="with --svg: draw the measured times of a run (its --trace) below the predicted",
    )
    return parser


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen schedule`` with the arguments after the verb; return the exit status."""
    parser = command_parser()
    options = parse(parser, argv)
    check_search(parser, options)
    if options.trace is not None and options.svg is None:
        parser.error("--trace needs --svg FILE: the drawing to make")
    if options.hosts is not None:
        _check_hosts(parser, options)

    from adagen.cli import pipeline
    from adagen.cli.files import write_file
    from adagen.cost.document import schedule_document
    from adagen.errors import UsageError
    from adagen.library.assessment import assessed
    from adagen.program import program_to_json
    from adagen.schedule import Topology

    with timed(told=options.verbose) as stages:
        model = pipeline.read_model(options, stages, None)
        if options.hosts is not None:
            if model.closed:
                raise UsageError(
                    "--hosts does not support closed loops: leave them out of the scene"
                )
            show_hosts(model, options)
            return 0
        chosen = pipeline.choose_schedule(model, options, stages)
        found = assessed(model, chosen.schedule, chosen.request)
        if options.svg is not None:
            with stages.stage("draw"):
                write_file(options.svg, _drawing(model, found, options))
    if options.json:
        document = schedule_document(
            found.schedule, Topology.of(model), found.program, found.timeline
        )
        print(with_accuracy(document, found.digits))
        return 0
    if options.program:
        print(program_to_json(found.program), end="")
        return 0
    _show(model, found)
    print(wrapped(accuracy_line(found.digits), 2))
    return 0


def _check_hosts(parser: Parser, options: argparse.Namespace) -> None:
    """Refuse what the hosts leave no room for."""
    if options.svg is not None:
        parser.error("--hosts makes no drawing: leave out --svg")
    for name, usual in (("procs", AUTO), ("form", "segment"), ("schedule", "auto")):
        if getattr(options, name) != usual:
            parser.error(f"--hosts chooses it: leave out --{name}")
    if options.reproducible:
        parser.error("--hosts does not support it: leave out --reproducible")


def _show(model: Model, found: Assessed) -> None:
    """Print the tree, the joints of each process, and predictions, for people."""
    from adagen.program.summary import TREES, meeting, program_text
    from adagen.schedule import Topology, schedule_tree

    print(wrapped(program_text(found.program), 2) + "\n")
    if meeting(found.program) in TREES:  # there the tree says what is joined when, and by whom
        print(schedule_tree(found.schedule, Topology.of(model), costs=found.timeline is None))
    if found.timeline is None:
        _show_loads(found.schedule)
    else:
        _show_machine(found.program, found.timeline)
    print(wrapped(prediction(found.schedule, found.timeline)))


def _drawing(model: Model, found: Assessed, options: argparse.Namespace) -> str:
    """Return the schedule as SVG, or predicted and measured timelines where there is a trace."""
    from adagen.drawing import draw
    from adagen.schedule import Topology, load_profile

    processes = found.schedule.processes
    if options.trace is None:
        profile, topology = load_profile(options.profile), Topology.of(model)
        return draw(found.schedule, topology, found.program, profile, model.name)
    from adagen.drawing.trace import machine_svg
    from adagen.run.trace import read_trace

    names = [joint.name for joint in model.joints]
    lines = [read_trace(options.trace, names, processes)]
    if found.timeline is not None:
        lines.insert(0, found.timeline.by_stage())
    count = f"{processes} process{'es' if processes > 1 else ''}"
    return machine_svg(lines, names, f"{model.name}, {count}, form {options.form}")


def _show_machine(program: Program, line: Timeline) -> None:
    """Print what each process has, and how long it works and waits, for people."""
    from rich.console import Console

    rows = (
        (
            str(p),
            f"{line.busy(p):.2f}",
            f"{line.waiting(p):.2f}",
            f"{line.busy(p) / line.makespan:.0%}",
        )
        for p in range(len(program.processes))
    )
    Console().print(table_of(("process", "busy (us)", "waiting (us)", "share"), rows, named=False))


def _show_loads(schedule: Schedule) -> None:
    """Print how long each process is busy, for people."""
    from rich.console import Console

    rows = (
        (str(process), f"{load:.2f}", f"{load / schedule.makespan:.0%}")
        for process, load in enumerate(schedule.loads)
    )
    Console().print(table_of(("process", "active (us)", "share"), rows, named=False))
