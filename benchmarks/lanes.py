"""What sharing a straight line saves limbs that are alike: beside loops and single ones, by turns.

    python -m benchmarks.lanes URDF ... [--floating] [--rounds N] [--compiler NAME] [--build]
    python -m benchmarks.lanes --chains N ... [--rounds N] [--compiler NAME] [--build]

Chains of N hinges are timed twice: planar, all hinges about y, and with hinges about x, y and z by
turns. One process. The ratio is that of the faster of the first two to the last; `auto` is the
shape that is chosen by default. --build compiles everything and times nothing: programs are kept.
Nothing is asserted: figures of one machine are no test.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Iterator
from pathlib import Path

from adagen.build import find_toolchain
from adagen.build.toolchain import with_compiler
from adagen.emit.shapes import chosen_shape
from adagen.executor import straight_line
from adagen.model import Model
from adagen.studies.bench.contest import Contestant, Times
from adagen.studies.bench.figures import AXES, chain
from adagen.studies.bench.report import table
from adagen.studies.chart import Variant
from adagen.urdf import read_robot
from benchmarks.page import command, publish
from benchmarks.solvers import by_turns, contestant, source_of, tell

WAYS = {
    "loops": ("kernels", True),
    "single": ("unrolled", False),
    "in lanes": ("unrolled", True),
}
"""What is compared: shape, and whether limbs may share a straight line."""


def contestants(model: Model, name: str, compiler: str = "") -> list[Contestant]:
    """Return a robot's solvers on one process, compiled."""
    toolchain = with_compiler(find_toolchain(), compiler)
    _, plan = Variant("segment").plan(model)
    found = []
    for way, (shape, lanes) in WAYS.items():
        text = source_of(plan, shape=shape, limbs=None if lanes else ((),))
        found.append(contestant(f"{name} {way}", model, plan, text, toolchain))
    return found


def instructions(model: Model) -> tuple[int, int]:
    """Return about how many instructions the single limbs' line has, and that in lanes."""
    _, plan = Variant("segment").plan(model)
    alone, together = (straight_line(plan, lanes=lanes)[0].operations for lanes in (False, True))
    return alone.instructions, together.instructions


def row(name: str, model: Model, times: list[Times]) -> tuple[object, ...]:
    """Return a row of the table: least medians of a turn, ns, and the counts of instructions."""
    loops, single, lanes = (min(one.turns) for one in times)
    ratio = min(loops, single) / lanes
    _, plan = Variant("segment").plan(model)
    figures = (f"{x:.0f}" for x in (loops, single, lanes))
    return name, model.nv, *instructions(model), *figures, f"{ratio:.2f}", chosen_shape(plan)


def subjects(options: argparse.Namespace) -> Iterator[tuple[str, Model]]:
    """Yield the robots that are timed, by name."""
    for path in map(Path, options.urdf):
        yield path.stem, read_robot(path, floating=options.floating).model
    for joints in options.chains:
        for name, axes in (("planar", AXES[1:2]), ("x y z", AXES)):
            with tempfile.TemporaryDirectory() as folder:
                file = Path(folder, f"chain{joints}.urdf")
                file.write_text(chain(joints, axes), encoding="utf-8")
                yield f"chain of {joints}, {name}", read_robot(file).model


def main() -> None:
    """Measure what the command line names and print a table."""
    parser = command(__doc__)
    parser.add_argument("urdf", nargs="*", help="robots")
    parser.add_argument(
        "--chains", type=int, nargs="+", default=[], metavar="N", help="of N hinges"
    )
    parser.add_argument("--floating", action="store_true", help="put robots on a floating base")
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--compiler", default="", help="what the MPI wrapper is to call")
    parser.add_argument("--build", action="store_true", help="compile alone")
    options = parser.parse_args()
    rows = []
    for name, model in subjects(options):
        tell(f"compiling {name}")
        ways = contestants(model, name, options.compiler)
        if options.build:
            continue
        times = by_turns(ways, options.rounds)
        if len(times) == len(ways):
            rows.append(row(name, model, [times[way.name]["in_place"] for way in ways]))
            tell(", ".join(map(str, rows[-1])))
    head = ("robot", "freedoms", "instructions, single", "in lanes", "loops, ns", "single")
    publish(options, "lanes", "\n".join(table((*head, "in lanes", "ratio", "auto"), rows)))


if __name__ == "__main__":
    main()
