"""``adagen schedule``: which joint is joined when and by whom, and what that should cost."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from adagen.cli.console import Stages, note
from adagen.cli.options import add_model, add_schedule, check_search
from adagen.cli.parser import make_parser, parse
from adagen.cli.predicted import (
    accuracy_line,
    predicted_accuracy,
    prediction,
    timeline,
    with_accuracy,
)
from adagen.cli.tables import table_of

if TYPE_CHECKING:
    import argparse

    from adagen.model import Model
    from adagen.schedule import Schedule
    from adagen.schedule.timeline import MachineTimeline

_EPILOG = """\
examples:
  adagen schedule robot.urdf --procs 4                    a summary for people
  adagen schedule robot.urdf --procs 4 --svg tree.svg     a drawing
  adagen schedule robot.urdf --procs 4 --json             the tree, for programs
  adagen schedule robot.urdf --procs 4 --profile paper --tie lex    as in the paper's Table I"""


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen schedule`` with the arguments after the verb; return the exit status."""
    parser = make_parser("adagen schedule", "Find and show the schedule of a robot.", _EPILOG)
    add_model(parser, gravity=False)
    add_schedule(parser)
    parser.add_argument("--json", action="store_true", help="print the schedule tree as JSON")
    parser.add_argument("--svg", type=Path, metavar="FILE", help="draw the schedule tree")
    parser.add_argument(
        "--trace",
        metavar="FILE",
        help="with --svg: draw what a run measured (its --trace) under what is predicted",
    )
    options = parse(parser, argv)
    check_search(parser, options)
    if options.trace is not None and options.svg is None:
        parser.error("--trace needs --svg FILE: the drawing to make")

    from adagen.cli import pipeline
    from adagen.cli.files import write_file
    from adagen.schedule import Topology, schedule_to_json

    stages = Stages()
    try:
        model = pipeline.read_model(options, stages, None)
        schedule = pipeline.schedule_model(model, options, stages)
        if options.svg is not None:
            with stages.stage("draw"):
                write_file(options.svg, _drawing(model, schedule, options))
    finally:
        if options.verbose:
            note(str(stages))
    topology = Topology.of(model)
    digits = predicted_accuracy(model, schedule, options)
    if options.json:
        print(with_accuracy(schedule_to_json(schedule, topology), digits))
        return 0
    _show(model, schedule, options)
    print(accuracy_line(digits))
    return 0


def _show(model: Model, schedule: Schedule, options: argparse.Namespace) -> None:
    """Print the tree, what each process does, and what is predicted, for people."""
    from adagen.schedule import Topology, schedule_tree

    print(schedule_tree(schedule, Topology.of(model)))
    line = timeline(model, schedule, options)
    if line is None:
        _show_loads(schedule)
    else:
        _show_machine(schedule, line, options.form)
    print(prediction(schedule, line))


def _drawing(model: Model, schedule: Schedule, options: argparse.Namespace) -> str:
    """Return the schedule as SVG, or predicted and measured timelines where there is a trace."""
    from adagen.cli import pipeline

    if options.trace is None:
        return pipeline.draw(schedule, model)
    from adagen.schedule.draw_trace import machine_svg
    from adagen.schedule.trace import read_trace

    names = [joint.name for joint in model.joints]
    lines = [read_trace(options.trace, names, schedule.processes)]
    predicted = timeline(model, schedule, options)
    if predicted is not None:
        lines.insert(0, predicted)
    count = f"{schedule.processes} process{'es' if schedule.processes > 1 else ''}"
    return machine_svg(lines, names, f"{model.name}, {count}, form {options.form}")


def _show_machine(schedule: Schedule, line: MachineTimeline, form: str) -> None:
    """Print how long each process works and waits by the steps of its plan, for people."""
    from rich.console import Console

    times = [(line.busy(process), line.waiting(process)) for process in range(schedule.processes)]
    rows = (
        (str(process), f"{busy:.2f}", f"{waiting:.2f}", f"{busy / line.makespan:.0%}")
        for process, (busy, waiting) in enumerate(times)
    )
    console = Console()
    console.print(table_of(("process", "busy (us)", "waiting (us)", "share"), rows, named=False))
    if line.straight:
        return
    proof = ""
    by_steps = schedule.split == "always" and schedule.strategy not in ("astar", "paper")
    # What is proven is of one step after the other; limbs side by side can be faster than that.
    if form == "segment" and by_steps and line.makespan >= schedule.lower_bound:
        above = line.makespan / schedule.lower_bound - 1
        proof = f", at most {above:.1%} above what is proven to be the least"
    said = f"{line.makespan:.2f} us step by step, waiting and messages included{proof}"
    console.print(said, soft_wrap=True)


def _show_loads(schedule: Schedule) -> None:
    """Print how long each process is busy, for people."""
    from rich.console import Console

    rows = (
        (str(process), f"{load:.2f}", f"{load / schedule.makespan:.0%}")
        for process, load in enumerate(schedule.loads)
    )
    Console().print(table_of(("process", "active (us)", "share"), rows, named=False))
