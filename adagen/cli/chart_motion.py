"""``adagen chart --simulate``: integrators and step sizes of a robot."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from adagen.cli.chart_options import LARGEST_STEP
from adagen.cli.console import Stages, speaking, wrote
from adagen.cli.tables import table_of

if TYPE_CHECKING:
    from adagen.studies.chart.motion import MotionChart

_HALVINGS = 4


def chart_motion(options: argparse.Namespace) -> None:
    """Simulate one robot with every integrator and step; write, draw and show the chart.

    Raises:
        AdagenError: the robot is refused, or its reference motion fails.
    """
    from adagen.build import build_executable, find_toolchain
    from adagen.cli import pipeline
    from adagen.emit import stem_of
    from adagen.studies.chart.motion import Player, motion_chart
    from adagen.studies.chart.variants import REFERENCE

    model = pipeline.read_model(options, Stages(), options.gravity)
    toolchain = find_toolchain()
    with speaking(Path(options.model).stem) as on_progress:
        _, plan = REFERENCE.plan(model)
        stem = stem_of(plan)
        on_progress(f"compiling {stem}")
        program = build_executable(REFERENCE.files(plan)[f"{stem}.cpp"], stem, toolchain)
        largest = LARGEST_STEP if options.step is None else options.step
        steps = [largest / 2**k for k in range(_HALVINGS + 1)]
        player = Player(model, program, len(plan.processes), toolchain)
        chart = motion_chart(player, options.simulate, steps, on_progress)
    _write(chart, options)
    _show(chart)


def _write(chart: MotionChart, options: argparse.Namespace) -> None:
    from adagen.studies.records import write_record

    options.out.mkdir(parents=True, exist_ok=True)
    path = options.out / f"chart_motion_{Path(options.model).stem}"
    paths = [path.with_name(f"{path.name}.json")]
    write_record(chart, paths[0])
    if options.picture:
        from adagen.studies.chart.draw import save
        from adagen.studies.chart.draw_motion import motion_picture

        paths += save(motion_picture(chart), path)
    wrote(paths)


def _show(chart: MotionChart) -> None:
    """Print fitted orders and the errors at the least step, for people."""
    from rich.console import Console

    from adagen.studies.chart.motion import INTEGRATORS

    title = f"{chart.model}: order of convergence, over {chart.seconds:g} s"
    columns = ("integrator", "state", "energy", "momentum", "error at least step")
    rows = []
    for integrator in INTEGRATORS:
        orders = [chart.order(integrator, what) for what in ("error", "energy", "momentum")]
        own = [p for p in chart.points if p.integrator == integrator]
        if not own:
            continue
        error = "failed" if own[-1].error is None else f"{own[-1].error:.1e}"
        rows.append((integrator, *("-" if x is None else f"{x:.2f}" for x in orders), error))
    console = Console()
    console.print(table_of(columns, rows, title=title))
    for point in chart.points:
        if point.why is not None:
            console.print(f"{point.integrator}, step {point.step:g} s: {point.why}", markup=False)
