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
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from adagen.build import find_toolchain
from adagen.build.toolchain import with_compiler
from adagen.emit import emit, stem_of
from adagen.emit.shapes import chosen_shape
from adagen.executor import straight_line
from adagen.model import Model
from adagen.studies.bench.contest import Contestant, Rules, Times, hold
from adagen.studies.bench.emitted import Emitted
from adagen.studies.bench.figures import AXES, chain
from adagen.studies.chart import Variant
from adagen.urdf import read_robot

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
    stem = stem_of(plan)
    found = []
    for way, (shape, lanes) in WAYS.items():
        text = emit(plan, shape=shape, limbs=None if lanes else ((),))[f"{stem}.cpp"]
        source = Emitted(f"{name} {way}", model, f"{stem}.cpp", text, shape, 1, "double", None)
        found.append(source.contestant(toolchain))
    return found


def instructions(model: Model) -> tuple[int, int]:
    """Return about how many instructions the single limbs' line has, and that in lanes."""
    _, plan = Variant("segment").plan(model)
    alone, together = (straight_line(plan, lanes=lanes)[0].operations for lanes in (False, True))
    return alone.instructions, together.instructions


def line(name: str, model: Model, times: list[Times]) -> str:
    """Return a row of the table: least medians of a turn, ns, and the counts of instructions."""
    loops, single, lanes = (min(one.turns) for one in times)
    ratio = min(loops, single) / lanes
    _, plan = Variant("segment").plan(model)
    cells = (
        *(name, model.nv, *instructions(model)),
        *(f"{x:.0f}" for x in (loops, single, lanes)),
        *(f"{ratio:.2f}", chosen_shape(plan)),
    )
    return f"| {' | '.join(map(str, cells))} |"


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
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("urdf", nargs="*", help="robots")
    parser.add_argument(
        "--chains", type=int, nargs="+", default=[], metavar="N", help="of N hinges"
    )
    parser.add_argument("--floating", action="store_true", help="put robots on a floating base")
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--compiler", default="", help="what the MPI wrapper is to call")
    parser.add_argument("--build", action="store_true", help="compile alone")
    options = parser.parse_args()
    print(
        "| robot | freedoms | instructions, single | in lanes | loops, ns | single | in lanes "
        "| ratio | auto |"
    )
    print("|---|---|---|---|---|---|---|---|---|")
    for name, model in subjects(options):
        print(f"compiling {name}", file=sys.stderr)
        ways = contestants(model, name, options.compiler)
        if options.build:
            continue
        times, gone = hold(ways, Rules(options.rounds), lambda text: print(text, file=sys.stderr))
        for way, reason in gone.items():
            print(f"{way}: {reason}", file=sys.stderr)
        if not gone:
            found = [times[way.name]["in_place"] for way in ways]
            print(line(name, model, found), flush=True)


if __name__ == "__main__":
    main()
