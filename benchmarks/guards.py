"""What the guards of emitted code cost: each solver beside itself without them, by turns.

    python -m benchmarks.guards [URDF ...] [--floating] [--shape NAME] [--rounds N]

A guard ends in ``fail``, which notes the failure in the status. Where that does nothing, the
compiler drops what is looked at only for its sake. Nothing is asserted: figures of one machine are
no test.
"""

from __future__ import annotations

from pathlib import Path
from statistics import median

from adagen.emit import stem_of
from adagen.emit.runtime import joined
from adagen.emit.shapes import SHAPES
from adagen.model import Model
from adagen.plan import FORMS
from adagen.studies.bench.contest import Contestant
from adagen.studies.bench.report import table
from adagen.studies.chart import Variant
from adagen.urdf import read_robot
from benchmarks.page import MODELS, command, publish
from benchmarks.solvers import by_turns, contestant, tell

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


_FORMS = {"kernels": ("segment",), "joints": ("ada",)}
"""Forms of shapes that take one alone."""


def pair(model: Model, name: str, form: str, shape: str) -> tuple[Contestant, Contestant]:
    """Return a robot's solver on one process and the same without guards, compiled."""
    variant = Variant(form, shape=shape)
    _, plan = variant.plan(model)
    text = variant.files(plan)[f"{stem_of(plan)}.cpp"]
    return (
        contestant(f"{name} {form} guarded", model, plan, text),
        contestant(f"{name} {form} unguarded", model, plan, unguarded(text)),
    )


def main() -> None:
    """Measure what the command line names and print a table."""
    parser = command(__doc__)
    parser.add_argument("urdf", nargs="*", help="robots; the shipped humanoid if none")
    parser.add_argument("--floating", action="store_true", help="put them on a floating base")
    parser.add_argument("--shape", choices=("auto", *SHAPES), default="auto")
    parser.add_argument("--rounds", type=int, default=15)
    options = parser.parse_args()
    pairs: dict[tuple[str, str], tuple[Contestant, Contestant]] = {}
    for path in map(Path, options.urdf or [MODELS / "humanoid.urdf"]):
        model = read_robot(path, floating=options.floating).model
        for form in _FORMS.get(options.shape, FORMS):
            tell(f"compiling {path.stem}, form {form}")
            pairs[path.stem, form] = pair(model, path.stem, form, options.shape)
    times = by_turns([one for both in pairs.values() for one in both], options.rounds)
    rows = []
    for key, both in pairs.items():
        if all(one.name in times for one in both):
            guarded, bare = (times[one.name]["in_place"] for one in both)
            ratio = median(a / b for a, b in zip(guarded.turns, bare.turns, strict=True))
            ratios = (f"{ratio:.3f}", f"{guarded.least / bare.least:.3f}")
            rows.append((*key, *ratios, f"{guarded.median:.0f}", f"{bare.median:.0f}"))
    head = ("robot", "form", "time with / without", "least time with / without", "with, ns")
    publish(options, "guards", "\n".join(table((*head, "without"), rows)))


if __name__ == "__main__":
    main()
