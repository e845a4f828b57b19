"""Long chains: what they take to generate, to compile and to run, on one process and on several.

    python -m benchmarks.chains [--joints N ...] [--processes P ...] [--profile NAME] [--rounds R]
                                [--priority N] [--peer] [--resume | --again] [--write PAGE]

Chains of hinges about x, y and z by turns, measured as ``adagen bench --scale`` does. The record so
far is kept after each chain (build/chains/scale.json): --resume goes on from it, and --again times
all anew and keeps from it what programs took to compile that are in the cache since.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

from adagen.cli.console import speaking
from adagen.cli.scale import draw
from adagen.errors import AdagenError
from adagen.studies.bench.contest import Rules
from adagen.studies.bench.scale import Wanted, measure_chains
from adagen.studies.bench.scale_record import read_scale
from adagen.studies.bench.scale_report import markdown
from adagen.studies.records import write_record
from benchmarks.page import ROOT, command, publish

RECORD = ROOT / "build" / "chains" / "scale.json"
JOINTS = (200, 500, 1000, 2000, 5000, 10000)
PROCESSES = (1, 2, 4, 8, 16)
MOST_SHARED = 2000
"""Joints up to which chains are shared by processes here."""


def main(words: Sequence[str] | None = None) -> int:
    """Measure what the command line names, print tables, and return the exit status."""
    parser = command(__doc__)
    parser.add_argument("--joints", type=int, nargs="+", default=JOINTS)
    parser.add_argument("--processes", type=int, nargs="+", default=PROCESSES)
    parser.add_argument("--profile", default="default", help="what solvers are made with")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--repeat", type=int, default=10, help="evaluations of a state in a turn")
    parser.add_argument("--priority", type=int, default=0, help="real-time, of what is timed")
    parser.add_argument("--peer", action="store_true", help="beside pinocchio")
    parser.add_argument("--resume", action="store_true", help="keep chains measured before")
    parser.add_argument("--again", action="store_true", help="keep what making them took")
    options = parser.parse_args(words)
    chains = [
        (joints, options.processes if joints <= MOST_SHARED else (1,)) for joints in options.joints
    ]
    rules = Rules(rounds=options.rounds, repeat=options.repeat)
    wanted = Wanted(chains, rules, options.profile, options.peer, options.priority)
    RECORD.parent.mkdir(parents=True, exist_ok=True)
    try:
        known = (options.resume or options.again) and RECORD.is_file()
        before = read_scale(RECORD) if known else None
        with speaking("chains") as on_progress:
            scale = measure_chains(
                wanted,
                on_progress,
                lambda found: write_record(found, RECORD),
                before if options.resume else None,
                before,
            )
    except AdagenError as error:
        print(error, file=sys.stderr)
        return error.status
    shown = ""
    if options.write is not None:
        pictures = draw(scale, options.write.parent / "pictures")
        for path in pictures:
            write_record(scale, path.with_suffix(".json"))
        shown = "".join(f"![{path.stem}](pictures/{path.name})\n\n" for path in pictures)
    publish(options, "chains", f"{shown}{markdown(scale)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
