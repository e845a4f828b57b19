"""Random mechanisms with closed loops in their worst closed states: right, refused, wrong.

    python -m benchmarks.mechanisms [--count 300] [--states 8] [--seed 1] [--write FILE]

Mechanisms are of the families of adagen/studies/stability/mechanisms.py; their plans are carried
out in double as straight lines are, and in 400 bits. Wrong is an error of 1e-6 of the largest
acceleration or more that nothing was said of. Strange is an answer that dense algebra in the null
space of J does not share, to the digits that it has.
"""

from __future__ import annotations

import argparse
import platform
import sys
from pathlib import Path

from adagen.studies.stability.mechanisms import FAMILIES, Outcome, audit, mechanisms
from benchmarks.page import write_between_marks


def table(found: dict[str, Outcome]) -> list[str]:
    """Return the table of all families."""
    lines = [
        "| family | mechanisms | refused at emission | answered | refused | wrong | strange"
        " | largest error |",
        "|---|--:|--:|--:|--:|--:|--:|--:|",
    ]
    for name, one in found.items():
        cells = (one.mechanisms, one.never, one.answered, one.refused, one.wrong, one.strange)
        lines.append(f"| {name} | {' | '.join(map(str, cells))} | {one.worst:.0e} |")
    return lines


def main() -> int:
    """Print the table, or put it into a document."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--states", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--write", type=Path)
    options = parser.parse_args()
    found = {name: Outcome() for name in FAMILIES}
    for k, (family, model) in enumerate(mechanisms(options.count, options.seed)):
        audit(model, options.states, found[family], seed=options.seed + k)
        if k % 20 == 19:
            print(f"{k + 1} of {options.count}", file=sys.stderr)
    lines = [
        f"{options.count} mechanisms, seed {options.seed}, {options.states} states each at most;"
        f" {platform.machine()}, Python {platform.python_version()}.",
        "",
        *table(found),
    ]
    if options.write is None:
        print("\n".join(lines))
    else:
        write_between_marks(options.write, "mechanisms", "\n".join(lines))
    return 1 if any(one.wrong or one.strange for one in found.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
