"""``adagen info``: what was read of a robot, and a states file to fill in."""

from __future__ import annotations

import json
from collections.abc import Sequence
from math import fsum
from typing import TYPE_CHECKING, Any

from adagen.cli.console import Stages
from adagen.cli.options import add_model
from adagen.cli.parser import Parser, make_parser, parse, whole
from adagen.cli.tables import table_of, wrapped
from adagen.errors import InputError, printable

if TYPE_CHECKING:
    from adagen.model import Model
    from adagen.states import States

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
        from adagen.states import states_text

        print(states_text(_states(model, options.states), model), end="")
    elif options.json:
        print(json.dumps({**robot_data(model), "not_modelled": list(reading.ignored)}, indent=1))
    else:
        _show(model, reading.ignored)
    return 0


def _states(model: Model, count: int) -> States:
    """States to fill in: at rest, closed where the robot has loops.

    Raises:
        InputError: the loops cannot be closed.
    """
    import numpy as np

    from adagen.states import States, resting_states

    if not model.closed:
        return resting_states(model, count)
    from adagen.plan.closable import why_open
    from adagen.reference.closed import closed_states

    q, _ = closed_states(model, count)
    if not len(q):
        raise InputError(why_open(model))
    return States(
        np.resize(q, (count, model.nq)), np.zeros((count, model.nv)), np.zeros((count, model.ntau))
    )


def robot_data(model: Model) -> dict[str, Any]:
    """Return what a model is as plain data: joints in order, places in q and v, masses (kg, m)."""
    return {
        "name": model.name,
        "floating": model.floating,
        "gravity": model.gravity.tolist(),
        "nq": model.nq,
        "nv": model.nv,
        "mass": fsum(link.inertia.mass for link in model.links[1:]),
        "joints": [_joint_data(model, j) for j in range(len(model.joints))],
        "forces": [wrench.frame.name for wrench in model.wrenches],
        "loops": [
            {
                "name": loop.name,
                "kind": loop.kind.name,
                "links": [model.links[link].name for link, _ in loop.ends],
                "frames": [frame.name for _, frame in loop.ends],
                "tolerance": loop.tolerance,
            }
            for loop in model.loops
        ],
        "couplings": [
            {
                "name": coupling.name,
                "terms": {model.joints[j].name: factor for j, factor in coupling.terms},
                "offset": coupling.offset,
                "tolerance": coupling.tolerance,
            }
            for coupling in model.couplings
        ],
    }


def _joint_data(model: Model, j: int) -> dict[str, Any]:
    joint, child = model.joints[j], model.links[j + 1]
    follows = None
    if joint.mimic is not None:
        source = model.joints[joint.mimic.source].name
        follows = {
            "joint": source,
            "multiplier": joint.mimic.multiplier,
            "offset": joint.mimic.offset,
        }
    return {
        "name": joint.name,
        "kind": joint.kind.name,
        "parent": model.links[joint.parent].name,
        "child": child.name,
        "q": [model.q_start[j], joint.kind.nq],
        "v": [model.v_start[j], joint.kind.nv],
        "axis": joint.axis.tolist() if joint.kind.has_axis else None,
        "mimic": follows,
        "prescribed": joint.prescribed,
        "mass": child.inertia.mass,
        "com": child.inertia.com.tolist(),
        "fixed_to_it": list(child.merged),
    }


def _show(model: Model, ignored: Sequence[str]) -> None:
    """Print the robot as a table, for people."""
    from rich.console import Console

    data = robot_data(model)
    base = "floating" if model.floating else "fixed"
    gravity = " ".join(f"{g:g}" for g in data["gravity"])
    head = f"{model.name}: {len(model.joints)} joints, {model.nv} degrees of freedom, {base} base"
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
