"""Emitted solvers in hard states of random small robots: what is right, refused, and wrong.

    python -m benchmarks.adversary [--robots 120] [--states 200] [--seed 1 ...]
                                   [--record FILE] [--write FILE]

The robots are of the families of benchmarks/stability/adversary.py; each is solved in loops and
as a straight line, on one thread and, where it can be, on two that are joined. An answer is wrong
from 1e-6 of the largest acceleration on (float: 0.1), beside certified accelerations. It is wrong
in silence where neither the solver refused nor its emission warned of few digits.

With --record, what became of each robot is a line of JSON in a file: the command again goes on with
the robots that are not there yet.
"""

from __future__ import annotations

import platform
from collections import Counter
from collections.abc import Iterable
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import Any

from adagen.build import Toolchain, find_toolchain
from adagen.model import Model
from adagen.states import States
from adagen.studies.bench.report import table
from adagen.studies.stability.audit import Way
from benchmarks.hard import Asked, hard_robots
from benchmarks.page import Record, command, publish
from benchmarks.solvers import tell
from benchmarks.stability.audit import Audit, audited

WAYS = [
    Way("kernels"),
    Way("unrolled"),
    Way("kernels", scalar="float"),
    Way("unrolled", scalar="float"),
    Way("kernels", 2),
    Way("unrolled", 2),
]


def figures(found: dict[Way, Audit]) -> dict[str, dict[str, Any]]:
    """Return what became of a robot's evaluations, for each way, as JSON has it."""
    return {
        str(way): {
            "answered": audit.counts["answered"],
            "refused": audit.counts["refused"],
            "warned": audit.warned,
            "wrong": [asdict(wrong) for wrong in audit.wrong],
        }
        for way, audit in found.items()
    }


def _figures(model: Model, states: States, toolchain: Toolchain) -> dict[str, dict[str, Any]]:
    return figures(audited(model, states, WAYS, toolchain))


def summed(records: Iterable[dict[str, dict[str, Any]]]) -> dict[str, Counter[str]]:
    """Return the sums over all robots, for each way."""
    sums = {str(way): Counter[str]() for way in WAYS}
    for found in records:
        for way, one in found.items():
            n = sums[way]
            n["robots"] += 1
            for key in ("answered", "refused"):
                n[key] += one[key]
            if one["wrong"]:
                kind = "warned" if one["warned"] else "silent"
                n[kind] += len(one["wrong"])
                n[f"robots {kind}"] += 1
    return sums


def lines_of(sums: dict[str, Counter[str]]) -> list[str]:
    """Return the table of all ways, and what it comes to."""
    counted = ("robots", "answered", "refused", "warned")
    rows = []
    for way, n in sums.items():
        where = f", on {n['robots silent']} robots" * bool(n["silent"])
        rows.append((way, *(n[key] for key in counted), f"{n['silent']}{where}"))
    head = ("emitted", "robots", "answered", "refused", "wrong, warned", "wrong, silent")
    evaluations = sum(n["answered"] + n["refused"] for n in sums.values())
    wrong = sum(n["silent"] for n in sums.values())
    return [*table(head, rows), "", f"{evaluations} evaluations, {wrong} wrong in silence."]


def tell_wrong(k: int, name: str, found: dict[str, dict[str, Any]]) -> None:
    """Say which ways have answered wrongly."""
    for way, one in found.items():
        if not one["wrong"]:
            continue
        worst = max(one["wrong"], key=lambda wrong: float(wrong["error"]))
        manner = "warned" if one["warned"] else "silent"
        tell(
            f"{k} {name}: {way}: {len(one['wrong'])} wrong, {manner}, the worst "
            f"{worst['error']:.1e} in state {worst['state']}"
        )


def main() -> None:
    """Print the table, or put it into a document."""
    parser = command(__doc__)
    parser.add_argument("--robots", type=int, default=120)
    parser.add_argument("--states", type=int, default=200)
    parser.add_argument("--seed", type=int, nargs="+", default=[1], metavar="SEED")
    parser.add_argument("--record", type=Path)
    options = parser.parse_args()
    toolchain, record, records = find_toolchain(), Record(options.record), []
    for seed in options.seed:
        asked = Asked(options.robots, options.states, seed)
        for k, (_, model, states) in enumerate(hard_robots(asked)):
            found = record.of(asked.key(k), partial(_figures, model, states, toolchain))
            records.append(found)
            tell_wrong(k, model.name, found)
    seeds = " ".join(map(str, options.seed))
    lines = [
        f"{len(records)} robots, {options.states} states each, {platform.machine()}, `python -m "
        f"benchmarks.adversary --robots {options.robots} --states {options.states} --seed {seeds}`",
        "",
        *lines_of(summed(records)),
    ]
    publish(options, "adversary", "\n".join(lines))


if __name__ == "__main__":
    main()
