"""What the same answers everywhere cost: ``python -m benchmarks.reproducible URDF ... [--page]``.

Each robot's solver on one process as it is emitted by itself, as a straight line, as the same that
fuses no products with sums, and reproducible; of single states and of batches, by turns, so that a
noisy minute hits all alike. A robot whose links do not hang on the ground is named as
FILE:floating, one with a scene (closed loops, for example) as FILE:SCENE.toml, and one with
constants that are set at run time as FILE:runtime=WORDS.
--page writes docs/records/reproducible.md.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import adagen
from adagen.build import find_toolchain
from adagen.studies.bench.contest import Contestant, Times
from adagen.studies.bench.machine import machine
from adagen.studies.bench.report import table
from benchmarks.page import command, publish
from benchmarks.solvers import by_turns, contestant, tell

UNFUSED = "nothing fused"
WAYS: dict[str, dict[str, Any]] = {
    "fastest": {},
    "straight line": {"shape": "unrolled"},
    UNFUSED: {"shape": "unrolled"},
    "reproducible": {"reproducible": True},
}
"""What is compared, and how it is asked for."""


def contestants(robot: adagen.Robot, runtime: str, *, batch: bool) -> list[Contestant]:
    """Return a robot's solvers on one process, compiled."""
    found = []
    for name, asked in WAYS.items():
        made = adagen.compile(robot, batch=batch, runtime=runtime, **asked)
        toolchain = find_toolchain()
        if name == UNFUSED:
            toolchain = replace(toolchain, flags=(*toolchain.flags, "-ffp-contract=off"))
        found.append(contestant(name, made.model, made.plan, made.source, toolchain))
    return found


def row(name: str, freedoms: int, what: str, times: dict[str, Times]) -> tuple[str, ...]:
    """Return a row of the table: least medians of a turn in ns, and what is paid."""
    fastest, line, unfused, same = (min(times[way].turns) for way in WAYS)
    shares = (f"{same / other - 1:+.0%}" for other in (unfused, line, fastest))
    numbers = (f"{x:.0f}" for x in (fastest, line, unfused, same))
    return name, str(freedoms), what, *numbers, *shares


def main() -> None:
    """Measure, and print or write what came of it."""
    parser = command(__doc__, "records/reproducible.md")
    parser.add_argument(
        "urdf", nargs="+", help="robots, FILE[:floating][:SCENE.toml][:runtime=WORDS]"
    )
    parser.add_argument("--rounds", type=int, default=7)
    options = parser.parse_args()
    before, rows = machine(), []
    for word in options.urdf:
        word, _, runtime = word.partition(":runtime=")
        path, *how = word.split(":")
        scene = next((each for each in how if each.endswith(".toml")), None)
        robot = adagen.read(path, floating="floating" in how, scene=scene)
        for what, batch in (("a state", False), ("a batch", True)):
            tell(f"compiling {path}, {what}")
            own = contestants(robot, runtime, batch=batch)
            times = by_turns(own, options.rounds, repeat=15 if batch else 300)
            found = {one.name: times[one.name]["in_place"] for one in own}
            name = ", ".join(filter(None, [Path(path).stem, runtime]))
            rows.append(row(name, robot.nv, what, found))
            tell(", ".join(rows[-1]))
    figures = ("fastest, ns", "straight line, ns", "nothing fused, ns", "reproducible, ns")
    beside = ("beside nothing fused", "beside the line", "beside the fastest")
    lines = [
        *table(("robot", "degrees of freedom", "solves", *figures, *beside), rows),
        "",
        f"Least median of {options.rounds} turns each, {before['processor']}, "
        f"`{' '.join(find_toolchain().flags)}`, load before {before['load_before']}.",
    ]
    publish(options, "reproducible", "\n".join(lines))


if __name__ == "__main__":
    main()
