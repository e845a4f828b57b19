"""Random mechanisms with closed loops in their worst closed states: right, refused, wrong.

    python -m benchmarks.mechanisms [--count 2000] [--states 8] [--seed 1] [--kept FILE]
        [--from 0] [--to N] [--write FILE]

Mechanisms are of the families of benchmarks/stability/mechanisms.py; their plans are carried
out in double as straight lines are, and in 400 bits. Wrong is an error of 1e-6 of the largest
acceleration or more without a failure or a warning. Strange is an answer that dense algebra in the
null space of J does not share, to the digits that it has.

With --kept each mechanism's outcome is added to a file, a line each, and the command again goes on
from there; several may work on parts (--from, --to) and one file. The last one writes the table.
"""

from __future__ import annotations

import platform
import sys
from dataclasses import asdict, fields
from functools import partial
from pathlib import Path
from typing import Any

from adagen.model import Model
from adagen.studies.bench.report import table
from benchmarks.page import Record, command, publish
from benchmarks.solvers import tell
from benchmarks.stability.mechanisms import FAMILIES, Outcome, audit, mechanisms

FIGURES = ("mechanisms", "never", "answered", "refused", "wrong", "strange")
HEAD = ("family", "mechanisms", "refused at emission", *FIGURES[2:], "largest error")


def _sum(parts: list[Outcome]) -> Outcome:
    total = Outcome(worst=max((part.worst for part in parts), default=0.0))
    for name in (field.name for field in fields(Outcome) if field.name != "worst"):
        setattr(total, name, sum(getattr(part, name) for part in parts))
    return total


def _found(model: Model, states: int, seed: int) -> dict[str, Any]:
    outcome = Outcome()
    audit(model, states, outcome, seed=seed)
    return asdict(outcome)


def main() -> int:
    """Print the table, or put it into a document; 1 if something is wrong or strange."""
    parser = command(__doc__)
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--states", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kept", type=Path)
    parser.add_argument("--from", dest="first", type=int, default=0)
    parser.add_argument("--to", type=int)
    options = parser.parse_args()
    record, of = Record(options.kept), [options.seed, options.states]
    families, found = {}, {}
    for k, (family, model) in enumerate(mechanisms(options.count, options.seed)):
        families[k] = family
        if options.first <= k < (options.to or options.count):
            find = partial(_found, model, options.states, options.seed + k)
            record.of({"number": k, "of": of}, find)
        if k % 20 == 19:
            tell(f"{k + 1} of {options.count}")
    for row in record.rows:
        if row["of"] == of and row["number"] in families:
            found[row["number"]] = Outcome(**row["found"])
    sums = {name: _sum([found[k] for k in found if families[k] == name]) for name in FAMILIES}
    rows = [
        (name, *(getattr(one, each) for each in FIGURES), f"{one.worst:.0e}")
        for name, one in sums.items()
    ]
    lines = [
        f"{len(found)} mechanisms, seed {options.seed}, {options.states} states each at most;"
        f" {platform.machine()}, Python {platform.python_version()}.",
        "",
        *table(HEAD, rows),
    ]
    publish(options, "mechanisms", "\n".join(lines))
    bad = [k for k in sorted(found) if found[k].wrong or found[k].strange]
    if bad:
        tell(f"wrong or strange: mechanisms {', '.join(map(str, bad))}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
