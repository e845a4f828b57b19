"""Emitted solvers in hard states of random small robots: what is right, refused, and wrong.

    python -m benchmarks.adversary [--robots 120] [--states 200] [--seed 1] [--write FILE]

The robots are of the families of adagen/studies/stability/adversary.py; each is solved in loops and
as a straight line, on one thread and, where it can be, on two that are joined. An answer is wrong
from 1e-6 of the largest acceleration on (float: 0.1), beside certified accelerations. It is wrong
in silence where neither the solver refused nor its emission warned of few digits.
"""

from __future__ import annotations

import argparse
import platform
import sys
from collections import Counter
from pathlib import Path

from adagen.build import find_toolchain
from adagen.studies.stability.adversary import hard_states, robots
from adagen.studies.stability.audit import Audit, Way, audited
from benchmarks.page import write_between_marks

WAYS = [
    Way("kernels"),
    Way("unrolled"),
    Way("kernels", scalar="float"),
    Way("unrolled", scalar="float"),
    Way("kernels", 2),
    Way("unrolled", 2),
]


def counted(found: dict[Way, Audit], sums: dict[Way, Counter[str]]) -> None:
    """Add what became of a robot's evaluations to the sums."""
    for way, audit in found.items():
        sums[way].update(audit.counts)
        sums[way]["robots"] += 1
        if not audit.wrong:
            continue
        silent = "silent" if not audit.warned else "warned"
        sums[way][silent] += len(audit.wrong)
        sums[way][f"robots {silent}"] += 1


def table(sums: dict[Way, Counter[str]]) -> list[str]:
    """Return the table of all ways."""
    lines = [
        "| emitted | robots | answered | refused | wrong, warned | wrong, silent |",
        "|---|--:|--:|--:|--:|--:|",
    ]
    for way, n in sums.items():
        silent = f"{n['silent']}" + f", on {n['robots silent']} robots" * bool(n["silent"])
        cells = (way, n["robots"], n["answered"], n["refused"], n["warned"], silent)
        lines.append(f"| {' | '.join(map(str, cells))} |")
    return lines


def main() -> int:
    """Print the table, or put it into a document."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--robots", type=int, default=120)
    parser.add_argument("--states", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--write", type=Path)
    options = parser.parse_args()
    toolchain, sums = find_toolchain(), {way: Counter[str]() for way in WAYS}
    for k, model in enumerate(robots(options.robots, options.seed)):
        states = hard_states(model, options.states, options.seed)
        found = audited(model, states, WAYS, toolchain)
        counted(found, sums)
        for way, audit in found.items():
            if audit.wrong:
                worst = max(audit.wrong, key=lambda wrong: wrong.error)
                said = "warned" if audit.warned else "silent"
                print(
                    f"{k} {model.name}: {way}: {len(audit.wrong)} wrong, {said}, the worst "
                    f"{worst.error:.1e} in state {worst.state}",
                    file=sys.stderr,
                )
        print(f"{k + 1} of {options.robots} robots", end="\r", file=sys.stderr)
    lines = [
        f"{options.robots} robots, {options.states} states each, {platform.machine()}, "
        f"`python -m benchmarks.adversary --robots {options.robots} --states {options.states} "
        f"--seed {options.seed}`",
        "",
        *table(sums),
    ]
    if options.write is None:
        print("\n".join(lines))
    else:
        write_between_marks(options.write, "adversary", "\n".join(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main())
