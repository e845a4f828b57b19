"""``adagen stability``: where forward dynamics loses its digits, and what becomes of it here."""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from adagen.cli.console import note, progress, say
from adagen.cli.parser import Parser, make_parser, parse

if TYPE_CHECKING:
    from adagen.studies.stability import Outcome

_EPILOG = """\
Every case shows a weak method failing as it is expected to, and the shipped one
keeping its digits or refusing with a reason. The exit status is 1 where a
figure is not what it must be.

examples:
  adagen stability                             all cases (about a minute)
  adagen stability --quick --case 1 --case 3   two of them, shorter chains
  adagen stability --map build/maps            a map for each family of robots,
                                               errors against the condition of H
  adagen stability --map . --family light      one map"""


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen stability`` with the arguments after the verb; return the exit status."""
    parser = command_parser()
    options = parse(parser, argv)
    if options.family and options.map is None:
        parser.error("--family needs --map DIR")
    return _draw(options, parser.error) if options.map else _judge(options, parser.error)


def command_parser() -> Parser:
    """Return the parser of ``adagen stability``."""
    parser = make_parser(
        "adagen stability", "Show where methods fail and how many digits are kept.", _EPILOG
    )
    parser.add_argument(
        "--case", type=int, action="append", metavar="N", help="only this case, 1 to 13"
    )
    parser.add_argument("--quick", action="store_true", help="shorter chains where a case is slow")
    parser.add_argument("--json", action="store_true", help="print the findings as JSON")
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


def _judge(options: argparse.Namespace, refuse: object) -> int:
    from adagen.studies.stability import CASES, run_case

    assert callable(refuse)
    known = {case.number: case for case in CASES}
    for number in options.case or ():
        if number not in known:
            refuse(f"there is no case {number}; there are 1 to {len(CASES)}")
    outcomes = []
    for number in sorted(set(options.case or known)):
        with progress(f"case {number}: {known[number].title}"):
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
                "said": finding.said,
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
            words = (title, name, finding.said, finding.must, "ok" if finding.good else "NOT OK")
            table.add_row(*(escape(word) for word in words))
        table.add_section()
    Console().print(table)


def _draw(options: argparse.Namespace, refuse: object) -> int:
    from adagen.studies.stability.draw import draw_conditions, draw_map
    from adagen.studies.stability.maps import NAMES, make_map

    assert callable(refuse)
    for name in options.family or ():
        if name not in NAMES:
            refuse(f"there is no family {name!r}; there are {', '.join(NAMES)}")
    options.map.mkdir(parents=True, exist_ok=True)
    maps = []
    for name in options.family or NAMES:
        note(f"family {name} ...")
        found = make_map(name)
        draw_map(found, options.map / f"stability_{name}.svg")
        maps.append(found)
    if any(found.conditions for found in maps):
        draw_conditions(maps, options.map / "stability_condition.svg")
    if options.json:
        print(json.dumps([found.listed() for found in maps], indent=1))
    return 0
