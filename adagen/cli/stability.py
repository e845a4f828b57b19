"""``adagen stability``: cases in which forward dynamics loses digits."""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from adagen.cli.console import say, speaking, warn
from adagen.cli.console import tell as tell_reading
from adagen.cli.parser import Parser, among, listed, make_parser, parse, whole

if TYPE_CHECKING:
    from adagen.studies.stability import Outcome
    from adagen.studies.stability.emitted import Cell, Subject

_EPILOG = """\
Every case shows a weak method that fails as expected, and adagen's own method
that keeps its digits or refuses with a reason. The exit status is 1 if a result
is not the expected one.

examples:
  adagen stability                             all cases (some minutes)
  adagen stability --quick --case 1 --case 3   two of them, shorter chains
  adagen stability --map build/maps            a map for each family of robots,
                                               errors against the condition of H
  adagen stability --map . --family light      one map
  adagen stability robot.urdf                  where each shape and scalar
                                               fails on this robot here
  adagen stability robot.urdf --shape kernels --procs 1,2 --scalar float
  adagen stability --emitted --out DIR         the built-in robots likewise, a
                                               picture and a record in DIR"""


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen stability`` with the arguments after the verb; return the exit status."""
    parser = command_parser()
    options = parse(parser, argv)
    if options.family and options.map is None:
        parser.error("--family needs --map DIR")
    if options.models or options.emitted:
        if options.case or options.map:
            parser.error("--case and --map are not for emitted solvers: leave them out")
        return _emitted(options, parser.error)
    return _draw(options, parser.error) if options.map else _judge(options, parser.error)


def command_parser() -> Parser:
    """Return the parser of ``adagen stability``."""
    parser = make_parser(
        "adagen stability", "Show where methods fail, and how many digits they keep.", _EPILOG
    )
    parser.add_argument(
        "--case", type=int, action="append", metavar="N", help="only this case, 1 to 18"
    )
    parser.rare |= {"--meeting", "--seed", "--mimic", "--scene", "--quick"}
    _add_emitted(parser)
    parser.add_argument("--quick", action="store_true", help="shorter chains where a case is slow")
    parser.add_argument("--json", action="store_true", help="print the results as JSON")
    parser.add_argument(
        "--map",
        type=Path,
        metavar="DIR",
        help="instead of the cases: draw maps of digits kept, and errors against cond(H)",
    )
    parser.add_argument(
        "--family", action="append", metavar="NAME", help="with --map: only this family"
    )
    return parser


def _add_emitted(parser: Parser) -> None:
    """Add the options for solvers that are emitted and built."""
    from adagen.studies.stability.emitted import MEETINGS, PROCESSES, SCALARS, SHAPES

    group = parser.add_argument_group("emitted solvers")
    group.add_argument(
        "models",
        nargs="*",
        default=(),
        metavar="MODEL",
        help="robots (URDF, xacro or MJCF) to test",
    )
    group.add_argument("--emitted", action="store_true", help="test the built-in robots")
    for name, known in (
        ("--shape", SHAPES),
        ("--procs", tuple(map(str, PROCESSES))),
        ("--scalar", SCALARS),
        ("--meeting", MEETINGS),
    ):
        group.add_argument(
            name,
            type=listed(among(known)),
            default=known,
            metavar="A,B",
            help=f"only these of {', '.join(known)}",
        )
    group.add_argument(
        "--states",
        type=whole(1, MOST_STATES),
        default=16,
        metavar="N",
        help="number of random states (default: 16)",
    )
    group.add_argument(
        "--seed", type=int, default=1, metavar="N", help="seed of the states (default: 1)"
    )
    group.add_argument(
        "--time",
        type=float,
        default=600.0,
        metavar="S",
        help="start no new test after S seconds (default: 600); the next run continues",
    )
    group.add_argument("--floating", action="store_true", help="put the robots on a floating base")
    group.add_argument("--mimic", action="store_true", help="make mimic joints follow")
    group.add_argument("--scene", metavar="FILE", help="apply a scene file")
    group.add_argument(
        "--out", type=Path, metavar="DIR", help="where to write the picture and the record"
    )


MOST_STATES = 10_000


def _emitted(options: argparse.Namespace, refuse: object) -> int:
    """Build solvers in all ways and compare them with the truth."""
    from adagen.build import find_toolchain
    from adagen.studies.stability.emitted import Study, suite, ways

    assert callable(refuse)
    if options.emitted and options.models:
        refuse("--emitted is for the suite's robots: leave it out, or the models")
    subjects = suite(options.states) if options.emitted else _subjects(options)
    asked = ways(options.shape, [int(p) for p in options.procs], options.scalar, options.meeting)
    study = Study(subjects, asked, find_toolchain(), options.time)
    with speaking("stability") as tell:
        study.run(tell)
    if options.out is not None:
        from adagen.atomic_files import write_whole
        from adagen.studies.stability.draw import draw_study

        options.out.mkdir(parents=True, exist_ok=True)
        record = json.dumps([cell.listed() for cell in study.cells], indent=1) + "\n"
        write_whole(options.out / "stability_emitted.json", record)
        draw_study(study.cells, options.out / "stability_emitted.svg")
    if options.json:
        print(json.dumps([cell.listed() for cell in study.cells], indent=1))
    else:
        _show_cells(study.cells)
    if study.left:
        warn(
            f"warning: {study.left} of {study.left + len(study.cells)} tests were not run in "
            f"{options.time:g} s: raise --time, or repeat the command, which continues from here"
        )
    silent = [cell for cell in study.cells if cell.silent and cell.way.shape in ADAGENS]
    for cell in silent:
        say(f"{cell.robot}, {cell.way.words}: wrong in state {cell.state + 1}, without a warning")
    return 1 if silent else 0


ADAGENS = ("kernels", "unrolled")
"""Shapes that are emitted by default: none of their answers may be wrong in silence."""


def _subjects(options: argparse.Namespace) -> list[Subject]:
    """The robots of the command line, each as its scene leaves it."""
    from adagen.library import Origin
    from adagen.library.robot import read_whole
    from adagen.scene import apply_scene
    from adagen.studies.stability.emitted import subject

    found = []
    for name in options.models:
        scene = None if options.scene is None else Path(options.scene)
        origin = Origin(Path(name), options.floating, options.mimic, scene=scene)
        reading, given = read_whole(origin)
        tell_reading(reading, verbose=False)
        model = reading.model if given is None else apply_scene(reading.model, given).model
        if model.wanted or model.outputs:
            model = replace(model, wanted=(), outputs=())  # all accelerations are compared
        found.append(subject(Path(name).stem, model, options.states, options.seed))
    return found


def _show_cells(cells: Sequence[Cell]) -> None:
    """Print a table for people."""
    from rich import box
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    from adagen.studies.stability.emitted import tables

    table = Table(box=box.SIMPLE, title="decimal digits that are kept in the worst state")
    for column in ("robot", "way", "emitted", "executor", "predicted", ""):
        table.add_column(column, overflow="fold")
    last = ""
    for robot, *row in sorted(tables(cells), key=lambda row: row[0]):
        table.add_row(*(escape(word) for word in ("" if robot == last else robot, *row)))
        last = robot
    Console().print(table)


def _judge(options: argparse.Namespace, refuse: object) -> int:
    from adagen.studies.stability import CASES, run_case

    assert callable(refuse)
    known = {case.number: case for case in CASES}
    for number in options.case or ():
        if number not in known:
            refuse(f"there is no case {number}; there are 1 to {len(CASES)}")
    outcomes = []
    numbers = sorted(set(options.case or known))
    with speaking("stability") as tell:
        for k, number in enumerate(numbers, start=1):
            tell(f"{k} of {len(numbers)}: case {number}, {known[number].title}")
            outcomes.append(run_case(known[number], options.quick))
    if options.json:
        print(json.dumps([_listed(outcome) for outcome in outcomes], indent=1))
    else:
        _show(outcomes)
    bad = [outcome.number for outcome in outcomes if not outcome.good]
    if bad:
        say(f"unexpected result: case {', '.join(map(str, bad))}")
    return 1 if bad else 0


def _listed(outcome: Outcome) -> dict[str, object]:
    return {
        "case": outcome.number,
        "title": outcome.title,
        "ok": outcome.good,
        "findings": [
            {
                "method": finding.method,
                "weak": finding.weak,
                "figure": finding.figure if math.isfinite(finding.figure) else None,
                "result": finding.result,
                "must": finding.must,
                "ok": finding.good,
            }
            for finding in outcome.findings
        ],
    }


def _show(outcomes: Sequence[Outcome]) -> None:
    """Print a table for people."""
    from rich import box
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    table = Table(box=box.SIMPLE)
    for column in ("case", "method", "found", "must be", ""):
        table.add_column(column, overflow="fold")
    for outcome in outcomes:
        for k, finding in enumerate(outcome.findings):
            title = f"{outcome.number}. {outcome.title}" if k == 0 else ""
            name = f"{finding.method} (weak)" if finding.weak else finding.method
            words = (title, name, finding.result, finding.must, "ok" if finding.good else "NOT OK")
            table.add_row(*(escape(word) for word in words))
        table.add_section()
    Console().print(table)


def _draw(options: argparse.Namespace, refuse: object) -> int:
    from adagen.studies.stability.draw import compared, draw_conditions, draw_map
    from adagen.studies.stability.maps import NAMES, make_map

    assert callable(refuse)
    for name in options.family or ():
        if name not in NAMES:
            refuse(f"there is no family {name!r}; there are {', '.join(NAMES)}")
    options.map.mkdir(parents=True, exist_ok=True)
    maps = []
    with speaking("maps") as tell:
        for name in options.family or NAMES:
            found = make_map(name, tell)
            path = options.map / f"stability_{name}.svg"
            draw_map(found, path)
            _record(found.listed(), path)
            maps.append(found)
    if any(found.conditions for found in maps):
        path = options.map / "stability_condition.svg"
        draw_conditions(maps, path)
        _record({found.family: compared(found) for found in maps if found.conditions}, path)
    if options.json:
        print(json.dumps([found.listed() for found in maps], indent=1))
    return 0


def _record(data: object, picture: Path) -> None:
    """Write the record behind a picture beside it."""
    from adagen.atomic_files import write_whole

    write_whole(picture.with_suffix(".json"), json.dumps(data, indent=1, allow_nan=False) + "\n")
