"""What the same answers everywhere cost: ``python -m benchmarks.reproducible URDF ... [--page]``.

Each robot's solver on one process as it is emitted by itself, as a straight line, as the same that
fuses no products with sums, and reproducible; of single states and of batches, by turns, so that a
noisy minute hits all alike. A robot whose
links do not hang on the ground is named as FILE:floating.
--page writes docs/records/reproducible.md.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path

import adagen
from adagen.build import find_toolchain
from adagen.studies.bench.contest import Contestant, Rules, Times, hold
from adagen.studies.bench.emitted import Emitted
from adagen.studies.bench.machine import machine
from benchmarks.page import write_between_marks

ROOT = Path(__file__).resolve().parents[1]
UNFUSED = "nothing fused"
WAYS: dict[str, dict[str, object]] = {
    "fastest": {},
    "straight line": {"shape": "unrolled"},
    UNFUSED: {"shape": "unrolled"},
    "reproducible": {"reproducible": True},
}
"""What is compared, and how it is asked for."""


def contestants(robot: adagen.Robot, *, batch: bool) -> list[Contestant]:
    """Return a robot's solvers on one process, compiled."""
    found = []
    for name, asked in WAYS.items():
        made = adagen.compile(robot, batch=batch, **asked)
        shape = made.program.shape
        source = Emitted(
            name, made.model, f"{made.stem}.cpp", made.source, shape, 1, "double", None
        )
        toolchain = find_toolchain()
        if name == UNFUSED:
            toolchain = replace(toolchain, flags=(*toolchain.flags, "-ffp-contract=off"))
        found.append(source.contestant(toolchain))
    return found


def row(name: str, freedoms: int, what: str, times: dict[str, Times]) -> str:
    """Return a row of the table: least medians of a turn in ns, and what is paid."""
    fastest, line, unfused, same = (min(times[way].turns) for way in WAYS)
    shares = (f"{same / other - 1:+.0%}" for other in (unfused, line, fastest))
    numbers = (f"{x:.0f}" for x in (fastest, line, unfused, same))
    return f"| {' | '.join((name, str(freedoms), what, *numbers, *shares))} |"


def main() -> None:
    """Measure, and print or write what came of it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("urdf", nargs="+", help="robots, FILE or FILE:floating")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument(
        "--page", action="store_true", help="write it into docs/records/reproducible.md"
    )
    options = parser.parse_args()
    lines = [
        "| robot | degrees of freedom | solves | fastest, ns | straight line, ns "
        "| nothing fused, ns | reproducible, ns | beside nothing fused | beside the line "
        "| beside the fastest |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    before = machine()
    for word in options.urdf:
        path, _, how = word.partition(":")
        robot = adagen.read(path, floating=how == "floating")
        for what, batch in (("a state", False), ("a batch", True)):
            print(f"compiling {path}, {what}", file=sys.stderr)
            rules = Rules(options.rounds, repeat=15 if batch else 300)
            times, gone = hold(
                contestants(robot, batch=batch), rules, lambda text: print(text, file=sys.stderr)
            )
            if gone:
                raise SystemExit(str(gone))
            found = {name: kinds["in_place"] for name, kinds in times.items()}
            lines.append(row(Path(path).stem, robot.nv, what, found))
            print(lines[-1], flush=True)
    lines += [
        "",
        f"Least median of {options.rounds} turns each, {before['processor']}, "
        f"`{' '.join(find_toolchain().flags)}`, load before {before['load_before']}.",
    ]
    text = "\n".join(lines)
    print(text)
    if options.page:
        write_between_marks(ROOT / "docs" / "records" / "reproducible.md", "reproducible", text)


if __name__ == "__main__":
    main()
