"""``adagen info``: what was read from a robot file, and a states file to fill in."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from adagen.cli.console import Stages
from adagen.cli.options import add_model
from adagen.cli.parser import Parser, make_parser, parse, whole
from adagen.cli.tables import table_of, wrapped
from adagen.errors import printable

MOST_STATES = 1_000_000

_EPILOG = """\
examples:
  adagen info robot.urdf                joints, their places in q and v, masses
  adagen info robot.urdf --json         the same for programs
  adagen info robot.urdf --floating --states 2 > states.json    to fill in"""


def command_parser() -> Parser:
    """Return the parser of ``adagen info``."""
    parser = make_parser(
        "adagen info", "Show what is read from a robot file, and what is not modelled.", _EPILOG
    )
    add_model(parser)
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--json", action="store_true", help="print everything as JSON")
    what.add_argument(
        "--states",
        type=whole(1, MOST_STATES),
        metavar="N",
        help="print a states file instead: N states at rest, without torques, to fill in",
    )
    return parser


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen info`` with the arguments after the verb; return the exit status."""
    options = parse(command_parser(), argv)

    from adagen.cli import pipeline

    model, reading = pipeline.read_whole(options, Stages(), options.gravity)
    if options.states is not None:
        from adagen.library.robot_data import states_to_fill_in
        from adagen.states import states_text

        print(states_text(states_to_fill_in(model, options.states), model), end="")
        return 0
    from adagen.library.robot_data import robot_data

    data = robot_data(model)
    if options.json:
        print(json.dumps({**data, "not_modelled": list(reading.ignored)}, indent=1))
    else:
        _show(data, reading.ignored)
    return 0


def _show(data: dict[str, Any], ignored: Sequence[str]) -> None:
    """Print the robot as a table, for people."""
    from rich.console import Console

    base = "floating" if data["floating"] else "fixed"
    gravity = " ".join(f"{g:g}" for g in data["gravity"])
    joints, freedoms = len(data["joints"]), data["nv"]
    head = f"{data['name']}: {joints} joints, {freedoms} degrees of freedom, {base} base"
    print(wrapped(f"{printable(head)}, {data['mass']:.6g} kg, gravity {gravity} m/s^2"))
    rows = (
        (
            each["name"],
            _kind(each),
            each["parent"],
            each["child"],
            _places(each["q"]),
            _places(each["v"]),
            f"{each['mass']:.6g}",
        )
        for each in data["joints"]
    )
    heads = ("joint", "kind", "from link", "to link", "q", "v", "kg")
    Console().print(table_of(heads, rows))
    if data["forces"]:
        on = ", ".join(map(printable, data["forces"]))
        print(wrapped(f"outer forces on {on}: six numbers each behind tau"))
    for loop in data["loops"]:
        one, two = map(printable, loop["frames"])
        print(wrapped(f"loop {printable(loop['name'])}: {loop['kind']}, {one} to {two}", 2))
    for tie in data["couplings"]:
        terms = " + ".join(f"{x:g} {printable(name)}" for name, x in tie["terms"].items())
        text = f"coupling {printable(tie['name'])}: {terms} = {tie['offset']:g}"
        print(wrapped(text.replace("+ -", "- "), 2))
    for line in ignored:
        print(wrapped(line, 2))


def _kind(joint: dict[str, Any]) -> str:
    """The kind of a joint, and what makes it special."""
    if joint["mimic"] is not None:
        return f"{joint['kind']}, follows {joint['mimic']['joint']}"
    return f"{joint['kind']}, prescribed" if joint["prescribed"] else str(joint["kind"])


def _places(at: list[int]) -> str:
    """Where a joint's numbers are, as "3" or "3-9"."""
    first, count = at
    return str(first) if count == 1 else f"{first}-{first + count - 1}"
