"""``adagen schedule``: which joint is joined when and by whom, and what that should cost."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from adagen.cli.console import Stages, note
from adagen.cli.options import add_model, add_schedule, make_parser, parse

if TYPE_CHECKING:
    from adagen.schedule import Schedule

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
    options = parse(parser, argv)

    from adagen.cli import pipeline
    from adagen.cli.files import write_file
    from adagen.schedule import Topology, schedule_to_json, schedule_tree

    stages = Stages()
    try:
        model = pipeline.read_model(options, stages, None)
        schedule = pipeline.schedule_model(model, options, stages)
        if options.svg is not None:
            with stages.stage("draw"):
                write_file(options.svg, pipeline.draw(schedule, model))
    finally:
        if options.verbose:
            note(str(stages))
    topology = Topology.of(model)
    if options.json:
        print(schedule_to_json(schedule, topology))
        return 0
    print(schedule_tree(schedule, topology))
    _show_loads(schedule)
    print(pipeline.prediction(schedule))
    return 0


def _show_loads(schedule: Schedule) -> None:
    """Print how long each process is busy, for people."""
    from rich import box
    from rich.console import Console
    from rich.table import Table

    table = Table(box=box.SIMPLE)
    for column in ("process", "active (us)", "share"):
        table.add_column(column, justify="right")
    for process, load in enumerate(schedule.loads):
        table.add_row(str(process), f"{load:.2f}", f"{load / schedule.makespan:.0%}")
    Console().print(table)
