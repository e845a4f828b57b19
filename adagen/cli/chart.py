"""``adagen chart``: accuracy beside speed, and the variant that keeps a budget."""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from adagen.cli.console import Stages, note, warn
from adagen.cli.options import Parser, add_model, make_parser, parse, seconds
from adagen.errors import AdagenError, UsageError

if TYPE_CHECKING:
    from adagen.bench.contest import Contestant
    from adagen.chart import Budget, Chart, Point, Variant
    from adagen.chart.truth import Truth
    from adagen.model import Model

_DESCRIPTION = """\
Draw each robot's work-precision diagram: the time of an evaluation against the largest forward
error, from a truth of a hundred digits, of every algorithm, schedule, number type, number of
processes and refinement. Or, with --simulate, of integrators and steps."""

_EPILOG = """\
For each MODEL it writes chart_NAME.svg, .png, .json and .csv. The first run compiles some dozens of
programs, which takes minutes; they are kept for the next one.

examples:
  adagen chart arm.urdf                                  pictures and data of one robot
  adagen chart arm.urdf --budget "error<1e-10"           the fastest that is right enough, emitted
  adagen chart arm.urdf --budget "time<2us" --out fast   the most accurate in time
  adagen chart arm.urdf --procs 1 --scalars double --quick
  adagen chart arm.urdf --simulate 1                     integrators: wall time against error"""

_SCALARS = ("double", "float")
_LEAST_STATES = 20


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen chart`` with the arguments after the verb; return the exit status."""
    options = parse(_parser(), argv)
    if options.budget is not None and options.simulate is not None:
        raise UsageError("--budget and --simulate exclude each other")
    if options.picture:
        from adagen.chart.draw import pyplot

        pyplot()  # missing: said before anything is measured
    for name in options.models:
        one = argparse.Namespace(**vars(options), model=name)
        if options.simulate is not None:
            from adagen.cli.chart_motion import chart_motion

            chart_motion(one)
        else:
            _chart(one)
    return 0


def _parser() -> Parser:
    from adagen.chart.variants import NAMES, SCHEDULES
    from adagen.emit.shapes import BASELINES, SHAPES

    parser = make_parser("adagen chart", _DESCRIPTION, _EPILOG)
    add_model(parser, several=True)
    add = parser.add_argument
    add(
        "--budget",
        type=_budget,
        metavar="TERMS",
        help="say which variant to use and emit it: error<1e-10, time<2us, or both with a comma",
    )
    add("--out", type=Path, default=Path(), metavar="DIR", help="where to write (default: here)")
    add(
        "--procs",
        type=_list_of(int, range(1, 65)),
        default=(1, 2, 4),
        metavar="P,...",
        help="numbers of processes (default: 1,2,4); what exceeds the cores is not timed",
    )
    add(
        "--scalars",
        type=_list_of(str, _SCALARS),
        default=_SCALARS,
        metavar="NAME,...",
        help="number types (default: double,float)",
    )
    add(
        "--refine",
        type=_list_of(int, range(10)),
        default=(0, 1, 2),
        metavar="N,...",
        help="steps of iterative refinement (default: 0,1,2)",
    )
    add(
        "--shapes",
        type=_list_of(str, ("auto", *SHAPES)),
        default=("auto",),
        metavar="NAME,...",
        help=f"code shapes, of auto, {', '.join(SHAPES)} (default: auto)",
    )
    add(
        "--algorithms",
        type=_list_of(str, NAMES),
        default=tuple(NAMES),
        metavar="NAME,...",
        help=f"of {', '.join(NAMES)}; {', '.join(BASELINES)} are baselines (default: all)",
    )
    add(
        "--schedules",
        type=_list_of(str, SCHEDULES),
        default=SCHEDULES,
        metavar="NAME,...",
        help=f"of {', '.join(SCHEDULES)} (default: all)",
    )
    add(
        "--whole", action="store_true", help="the whole product: schedules in float and refined too"
    )
    add("--peers", action="store_true", help="pinocchio, casadi and MuJoCo beside, if installed")
    add(
        "--states",
        type=_states,
        default=_LEAST_STATES,
        metavar="N",
        help=f"states that errors are the largest of (default and least: {_LEAST_STATES})",
    )
    add(
        "--rounds",
        type=_list_of(int, range(1, 1001)),
        default=(5,),
        metavar="N",
        help="rounds of timing by turns (default: 5)",
    )
    add("--quick", action="store_true", help="two rounds, one schedule, no refinement: for a look")
    add(
        "--simulate",
        type=seconds,
        metavar="S",
        help="chart integrators instead, over S seconds of motion without torques",
    )
    add(
        "--step",
        type=seconds,
        default=0.008,
        metavar="H",
        help="largest step of --simulate, in seconds (default: 0.008)",
    )
    add("--no-picture", dest="picture", action="store_false", help="data alone")  # fmt: skip
    return parser


def _list_of(kind: Callable[[str], Any], known: Any) -> Callable[[str], tuple[Any, ...]]:
    """Return what reads a list with commas, each item among the known ones."""

    def read(text: str) -> tuple[Any, ...]:
        items = []
        for word in text.split(","):
            try:
                item = kind(word.strip())
            except ValueError:
                item = None
            if item is None or item not in known:
                names = known if not isinstance(known, range) else (known[0], "...", known[-1])
                raise argparse.ArgumentTypeError(
                    f"{word.strip()!r} is none of {', '.join(map(str, names))}"
                )
            items.append(item)
        return tuple(dict.fromkeys(items))

    return read


def _states(text: str) -> int:
    (count,) = _list_of(int, range(_LEAST_STATES, 10001))(text)
    return int(count)


def _budget(text: str) -> Budget:
    from adagen.chart import parse_budget

    try:
        return parse_budget(text)
    except UsageError as error:
        raise argparse.ArgumentTypeError(str(error).removeprefix("error: ")) from None


def _chart(options: argparse.Namespace) -> None:
    """Measure, write and show one robot's chart, and emit what keeps the budget."""
    from adagen.build import find_toolchain
    from adagen.chart import Study, chart_of
    from adagen.chart.truth import truth_of
    from adagen.cli import pipeline

    model = pipeline.read_model(options, Stages(), options.gravity)
    with speaking(Path(options.model).stem) as said, tempfile.TemporaryDirectory() as folder:
        truth = truth_of(model, options.states, said=said)
        others = _peers(model, truth, Path(folder), said) if options.peers else []
        rounds = 2 if options.quick else options.rounds[0]
        study = Study(_variants(options), rounds, repeat=10 if options.quick else 20)
        chart = chart_of(model, truth, study, find_toolchain(), others, said)
    _write(chart, options)
    _show(chart)
    if options.budget is not None:
        _answer(options.budget.best(chart.points), model, options)


def _variants(options: argparse.Namespace) -> list[Variant]:
    from adagen.chart import every_variant

    refinements = (0,) if options.quick else options.refine
    schedules = ("auto",) if options.quick else options.schedules
    found = every_variant(
        options.procs, options.scalars, refinements, options.shapes, whole=options.whole
    )
    return [v for v in found if v.algorithm in options.algorithms and v.schedule in schedules]


def _peers(
    model: Model, truth: Truth, folder: Path, said: Callable[[str], None]
) -> list[Contestant]:
    """Return the peers that are installed and can treat the robot, with notes on the others."""
    from adagen.bench.peers import PEERS, missing
    from adagen.model import canonical

    found: list[Contestant] = []
    for name, (_, make) in PEERS.items():
        reason = missing(name)
        if reason is None:
            said(f"compiling {name}")
            try:
                found += make(canonical(model), truth.states, folder)
            except AdagenError as error:
                reason = str(error).removeprefix("error: ")
        if reason is not None:
            warn(f"warning: without {name}: {reason}")
    return found


def _write(chart: Chart, options: argparse.Namespace) -> None:
    from adagen.chart import write_csv, write_json

    options.out.mkdir(parents=True, exist_ok=True)
    path = options.out / f"chart_{Path(options.model).stem}"
    paths = [path.with_name(f"{path.name}{ending}") for ending in (".json", ".csv")]
    write_json(chart, paths[0])
    write_csv(chart, paths[1])
    if options.picture:
        from adagen.chart.draw import save, work_precision

        paths += save(work_precision(chart), path)
    note(f"wrote {', '.join(map(str, paths))}")


def _show(chart: Chart) -> None:
    """Print the points on the front and what failed, for people."""
    from rich import box
    from rich.console import Console
    from rich.table import Table

    title = f"{chart.model}: what nothing else beats in both time and error"
    table = Table(box=box.SIMPLE, title=title)
    for column in ("variant", "us", "ratio", "error", "residual"):
        table.add_column(column, justify="left" if column == "variant" else "right")
    for point in sorted((p for p in chart.points if p.front), key=lambda p: p.time_ns or 0.0):
        assert point.time_ns is not None
        ratio = "" if point.ratio is None else f"{point.ratio:.2f}"
        figures = (f"{point.error:.1e}", f"{point.residual:.1e}")
        table.add_row(point.label, f"{point.time_ns / 1e3:.2f}", ratio, *figures)
    console = Console()
    console.print(table)
    for point in chart.points:
        if point.failed:
            console.print(f"no answer: {point.label}: {point.why}", soft_wrap=True, markup=False)


def _answer(point: Point, model: Model, options: argparse.Namespace) -> None:
    """Say which variant keeps the budget, and emit it."""
    from adagen.chart import Variant
    from adagen.cli import pipeline
    from adagen.cli.files import write_files

    assert point.time_ns is not None
    variant = Variant(
        point.algorithm, point.schedule, point.scalar, point.processes, point.refine, point.shape
    )
    schedule, plan = variant.plan(model, pipeline.source_hash(Path(options.model)))
    files = variant.files(plan, Path(options.model).stem, pipeline.draw(schedule, model))
    write_files(options.out, files)
    print(f"{point.label}: {point.time_ns / 1e3:.3g} us, error {point.error:.1e}")
    note(f"wrote {', '.join(str(options.out / name) for name in sorted(files))}")


@contextmanager
def speaking(about: str) -> Iterator[Callable[[str], None]]:
    """Show what is being done: in one changing line on a terminal, else each sort of it once."""
    import sys

    if sys.stderr.isatty():
        from rich.console import Console

        with Console(stderr=True).status(about) as status:
            yield lambda text: status.update(f"{about}: {text}")
        return
    sorts: set[str] = set()

    def say(text: str) -> None:
        sort = text.rstrip("0123456789 of")
        if sort not in sorts:
            sorts.add(sort)
            note(f"{about}: {text} ...")

    yield say
