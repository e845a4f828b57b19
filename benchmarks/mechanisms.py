"""Random mechanisms with closed loops in their worst closed states: right, refused, wrong.

    python -m benchmarks.mechanisms [--count 2000] [--states 8] [--seed 1] [--kept FILE]
        [--from 0] [--to N] [--write FILE]

Mechanisms are of the families of adagen/studies/stability/mechanisms.py; their plans are carried
out in double as straight lines are, and in 400 bits. Wrong is an error of 1e-6 of the largest
acceleration or more without a failure or a warning. Strange is an answer that dense algebra in the
null space of J does not share, to the digits that it has.

With --kept each mechanism's outcome is added to a file, a line each, and the command again goes on
from there; several may work on parts (--from, --to) and one file. The last one writes the table.
"""

from __future__ import annotations

import argparse
import json
import platform
import sys
from dataclasses import asdict, fields
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


def _known(path: Path | None, of: list[int]) -> dict[int, Outcome]:
    """Outcomes of mechanisms that were tried before, with the same states and seed."""
    if path is None or not path.is_file():
        return {}
    rows = (json.loads(line) for line in path.read_text(encoding="utf-8").splitlines())
    return {row["number"]: Outcome(**row["outcome"]) for row in rows if row["of"] == of}


def _sum(parts: list[Outcome]) -> Outcome:
    total = Outcome(worst=max((part.worst for part in parts), default=0.0))
    for name in (field.name for field in fields(Outcome) if field.name != "worst"):
        setattr(total, name, sum(getattr(part, name) for part in parts))
    return total


def main() -> int:
    """Print the table, or put it into a document."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--states", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kept", type=Path)
    parser.add_argument("--from", dest="first", type=int, default=0)
    parser.add_argument("--to", type=int)
    parser.add_argument("--write", type=Path)
    options = parser.parse_args()
    of = [options.seed, options.states]
    found = _known(options.kept, of)
    names = {}
    for k, (family, model) in enumerate(mechanisms(options.count, options.seed)):
        names[k] = family
        if k in found or not options.first <= k < (options.to or options.count):
            continue
        found[k] = Outcome()
        audit(model, options.states, found[k], seed=options.seed + k)
        if options.kept is not None:
            row = {"number": k, "of": of, "family": family, "outcome": asdict(found[k])}
            with options.kept.open("a", encoding="utf-8") as file:
                file.write(json.dumps(row) + "\n")
        if k % 20 == 19:
            print(f"{k + 1} of {options.count}", file=sys.stderr)
    tried = [k for k in names if k in found]
    sums = {name: _sum([found[k] for k in tried if names[k] == name]) for name in FAMILIES}
    lines = [
        f"{len(tried)} mechanisms, seed {options.seed}, {options.states} states each at most;"
        f" {platform.machine()}, Python {platform.python_version()}.",
        "",
        *table(sums),
    ]
    if options.write is None:
        print("\n".join(lines))
    else:
        write_between_marks(options.write, "mechanisms", "\n".join(lines))
    bad = [k for k in tried if found[k].wrong or found[k].strange]
    if bad:
        print(f"wrong or strange: mechanisms {', '.join(map(str, bad))}", file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
