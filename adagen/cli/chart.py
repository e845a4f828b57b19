"""``adagen chart``: error against time, and the variant that meets a budget."""

from __future__ import annotations

import argparse
import dataclasses
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from adagen.cli.chart_options import command_parser
from adagen.cli.console import Stages, speaking, warn, wrote
from adagen.cli.parser import parse
from adagen.cli.tables import table_of
from adagen.errors import UsageError

if TYPE_CHECKING:
    from adagen.model import Model
    from adagen.states import States
    from adagen.studies.bench.contest import Contestant
    from adagen.studies.chart import Chart, Point, Variant
    from adagen.studies.truth import Truth


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen chart`` with the arguments after the verb; return the exit status."""
    parser = command_parser()
    options = parse(parser, argv)
    if options.budget is not None and options.simulate is not None:
        parser.error("--budget and --simulate exclude each other")
    if options.step is not None and options.simulate is None:
        parser.error("--step is for --simulate S")
    if options.picture:
        from adagen.studies.chart.draw import pyplot

        pyplot()  # if missing, fail before anything is measured
    if isinstance(options.states, str) and (len(options.models) > 1 or options.simulate):
        parser.error("--states FILE is for one MODEL, and not for --simulate")
    for name in options.models:
        one = argparse.Namespace(**vars(options), model=name)
        if name.endswith(".json"):
            _redraw(Path(name), one)
        elif options.simulate is not None:
            from adagen.cli.chart_motion import chart_motion

            chart_motion(one)
        else:
            _chart(one)
    return 0


def _chart(options: argparse.Namespace) -> None:
    """Measure, write and show one robot's chart, and emit what keeps the budget."""
    from adagen.build import find_toolchain
    from adagen.studies.chart import Study, chart_of
    from adagen.studies.truth import truth_of

    model, states = _given(options)
    with speaking(Path(options.model).stem) as on_progress, tempfile.TemporaryDirectory() as folder:
        truth = truth_of(model, states, on_progress=on_progress)
        others = _peers(model, truth, Path(folder), on_progress) if options.peers else []
        rounds = 2 if options.quick else options.rounds
        study = Study(_variants(options), rounds, repeat=10 if options.quick else 20)
        chart = chart_of(model, truth, study, find_toolchain(), others, on_progress)
    _write(chart, options)
    _show(chart)
    if options.budget is not None:
        _answer(options.budget.best(chart.points), model, options)


def _given(options: argparse.Namespace) -> tuple[Model, int | States]:
    """The robot, and its states: how many are to be drawn, or those of a file."""
    from adagen.cli import pipeline
    from adagen.states import StatesFile

    given, gravity = options.states, options.gravity
    file = StatesFile.read(given) if isinstance(given, str) else None
    if file is not None and file.gravity is not None:
        gravity = file.gravity.tolist()
    model = pipeline.read_model(options, Stages(), gravity)
    if model.wanted or model.outputs:
        raise UsageError(
            "charts compare all accelerations, and nothing else: leave accelerations and [outputs]"
            " out of the scene"
        )
    return model, given if file is None else file.states(model)


def _redraw(path: Path, options: argparse.Namespace) -> None:
    """Draw a record's picture, and show it, anew."""
    from adagen.studies.chart import read_chart
    from adagen.studies.chart.draw import save, work_precision
    from adagen.studies.chart.record import marked

    chart = read_chart(path)
    chart = dataclasses.replace(chart, points=marked(chart.points))
    options.out.mkdir(parents=True, exist_ok=True)
    if options.picture:
        paths = save(work_precision(chart), options.out / path.stem)
        wrote(paths)
    _show(chart)


def _variants(options: argparse.Namespace) -> list[Variant]:
    from adagen.studies.chart import every_variant

    refinements = (0,) if options.quick else options.refine
    schedules = ("auto",) if options.quick else options.schedules
    found = every_variant(
        options.procs,
        options.scalars,
        refinements,
        options.shapes,
        schedules,
        options.objective,
        whole=options.whole,
    )
    return [v for v in found if v.algorithm in options.algorithms and v.schedule in schedules]


def _peers(
    model: Model, truth: Truth, folder: Path, on_progress: Callable[[str], None]
) -> list[Contestant]:
    """Return the peers that are installed and can treat the robot, with notes on the others."""
    from adagen.studies.bench.peers import PEERS, entered

    absent: dict[str, str] = {}
    found = entered(PEERS, model, truth.states, folder, absent, on_progress)
    for name, reason in absent.items():
        warn(f"warning: without {name}: {reason}")
    return found


def _write(chart: Chart, options: argparse.Namespace) -> None:
    from adagen.studies.records import write_record

    options.out.mkdir(parents=True, exist_ok=True)
    path = options.out / f"chart_{Path(options.model).stem}"
    paths = [path.with_name(f"{path.name}.json")]
    write_record(chart, paths[0], allow_nan=False)
    if options.picture:
        from adagen.studies.chart.draw import save, work_precision

        paths += save(work_precision(chart), path)
    wrote(paths)


def _show(chart: Chart) -> None:
    """Print the points on the front and what failed, for people."""
    from rich.console import Console

    title = f"{chart.model}: Pareto front of time and error, one state at a time"
    rows = []
    for point in sorted((p for p in chart.points if p.front), key=lambda p: p.time_ns or 0.0):
        assert point.time_ns is not None
        ratio = "" if point.ratio is None else f"{point.ratio:.2f}"
        figures = (f"{point.error:.1e}", f"{point.residual:.1e}")
        rows.append((point.label, f"{point.time_ns / 1e3:.2f}", ratio, *figures))
    console = Console()
    console.print(table_of(("variant", "us", "ratio", "error", "residual"), rows, title=title))
    for point in chart.points:
        if point.why is not None:
            what = "no answer" if point.failed else "not timed"
            console.print(f"{what}: {point.label}: {point.why}", soft_wrap=True, markup=False)


def _answer(point: Point, model: Model, options: argparse.Namespace) -> None:
    """Say which variant keeps the budget, and emit it."""
    from adagen.atomic_files import write_files
    from adagen.cli.pipeline import origin_of
    from adagen.drawing import draw
    from adagen.library.robot import source_hash
    from adagen.schedule import Topology, load_profile
    from adagen.studies.chart import Variant
    from adagen.urdf import model_stem

    assert point.time_ns is not None
    names = (field.name for field in dataclasses.fields(Variant))
    variant = Variant(**{name: getattr(point, name) for name in names})
    schedule, plan = variant.plan(model, source_hash(origin_of(options, None)))
    program, profile = variant.program(plan), load_profile("default")
    picture = draw(schedule, Topology.of(model), program, profile, model.name)
    files = variant.files(plan, model_stem(options.model), picture)
    write_files(options.out, files)
    print(f"{point.label}: {point.time_ns / 1e3:.3g} us, error {point.error:.1e}")
    wrote([options.out / name for name in sorted(files)])
