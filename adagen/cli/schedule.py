"""``adagen schedule``: which joint is joined when and by whom, and what that should cost."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from adagen.cli.console import Stages, note
from adagen.cli.options import add_model, add_schedule, make_parser

if TYPE_CHECKING:
    from adagen.model import Model
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
    options = parser.parse_args(argv)

    from adagen.cli import pipeline
    from adagen.cli.files import write_file

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
    if options.json:
        from adagen.schedule import Topology

        print(json.dumps(schedule.to_json(Topology.of(model)), indent=2))
    else:
        _show(schedule, model)
    return 0


def _show(schedule: Schedule, model: Model) -> None:
    """Print the tree and the load of each process, for people."""
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table
    from rich.tree import Tree

    from adagen.cli.pipeline import prediction
    from adagen.errors import printable
    from adagen.schedule.tree import Node

    def label(node: Node) -> str:
        first, end = node.processes
        where = f"process {first}" if end == first + 1 else f"processes {first}-{end - 1}"
        name = escape(printable(model.joints[node.joint].name))
        return f"{name} [dim]{where}, {node.cost:.2f} us, k = {node.boundary}[/dim]"

    console = Console()
    tree = Tree(label(schedule.root))
    waiting = [(schedule.root, tree)]
    while waiting:  # a chain makes a tree as deep as it is long: no recursion
        node, branch = waiting.pop()
        waiting += [(child, branch.add(label(child))) for child in node.children]
    table = Table("process", "active (us)", "share")
    for process, load in enumerate(schedule.loads):
        table.add_row(str(process), f"{load:.2f}", f"{load / schedule.makespan:.0%}")
    console.print(tree)
    console.print(table)
    console.print(escape(prediction(schedule)))
