"""What the guards of emitted code cost: each solver beside itself without them, by turns.

    python -m benchmarks.guards [URDF ...] [--floating] [--shape NAME] [--rounds N]

A guard ends in ``fail``, which notes the failure in the status. Where that does nothing, the
compiler drops what is looked at only for its sake. Nothing is asserted: figures of one machine are
no test.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from statistics import median

from adagen.build import find_toolchain
from adagen.emit import stem_of
from adagen.emit.runtime import joined
from adagen.emit.shapes import SHAPES
from adagen.model import Model
from adagen.plan import FORMS
from adagen.studies.bench.contest import Contestant, Rules, Times, hold
from adagen.studies.bench.emitted import Emitted
from adagen.studies.chart import Variant
from adagen.urdf import read_robot

HUMANOID = Path(__file__).resolve().parents[1] / "generated_examples/models/humanoid.urdf"
_NOTES = "  Channel::fail(w.status, failure(kind, joint));\n"
_NOTHING = "  static_cast<void>(w), static_cast<void>(kind), static_cast<void>(joint);\n"


def unguarded(text: str) -> str:
    """Return an emitted source, with its headers, in which failures of an evaluation go unnoticed.

    Raises:
        ValueError: it does not have the one place where they are noted.
    """
    text = joined(text)
    if text.count(_NOTES) != 1:
        raise ValueError("the emitted source notes failures in another way")
    return text.replace(_NOTES, _NOTHING)


def pair(model: Model, name: str, form: str, shape: str) -> tuple[Contestant, Contestant]:
    """Return a robot's solver on one process and the same without guards, compiled."""
    variant = Variant(form, shape=shape)
    _, plan = variant.plan(model)
    stem, toolchain = stem_of(plan), find_toolchain()
    text = variant.files(plan)[f"{stem}.cpp"]
    with_guards, without = (
        Emitted(f"{name} {form} {what}", model, f"{stem}.cpp", source, shape, 1, "double", None)
        for what, source in (("guarded", text), ("unguarded", unguarded(text)))
    )
    return with_guards.contestant(toolchain), without.contestant(toolchain)


def line(name: str, form: str, guarded: Times, bare: Times) -> str:
    """Return a row of the table: median and least ratio and the medians, ns."""
    ratio = median(a / b for a, b in zip(guarded.turns, bare.turns, strict=True))
    return (
        f"| {name} | {form} | {ratio:.3f} | {guarded.least / bare.least:.3f} "
        f"| {guarded.median:.0f} | {bare.median:.0f} |"
    )


def main() -> None:
    """Measure what the command line names and print a table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("urdf", nargs="*", help="robots; the shipped humanoid if none")
    parser.add_argument("--floating", action="store_true", help="put them on a floating base")
    parser.add_argument("--shape", choices=("auto", *SHAPES), default="auto")
    parser.add_argument("--rounds", type=int, default=15)
    options = parser.parse_args()
    rows: list[tuple[str, str, Contestant, Contestant]] = []
    for path in map(Path, options.urdf or [HUMANOID]):
        model = read_robot(path, floating=options.floating).model
        for form in FORMS:
            print(f"compiling {path.stem}, form {form}", file=sys.stderr)
            rows.append((path.stem, form, *pair(model, path.stem, form, options.shape)))
    contestants = [one for _, _, *both in rows for one in both]
    times, gone = hold(
        contestants, Rules(options.rounds), lambda text: print(text, file=sys.stderr)
    )
    for name, reason in gone.items():
        print(f"{name}: {reason}", file=sys.stderr)
    print("| robot | form | time with / without | least time with / without | with, ns | without |")
    print("|---|---|---|---|---|---|")
    for name, form, guarded, bare in rows:
        if guarded.name not in gone and bare.name not in gone:
            both = (times[one.name]["in_place"] for one in (guarded, bare))
            print(line(name, form, *both))


if __name__ == "__main__":
    main()
