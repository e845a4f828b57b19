"""Chains and batches on up to 1024 processes of a cluster, as they are predicted, and the check.

    python -m benchmarks.beyond [--joints N ...] [--processes P ...] [--profile NAME] [--hosts FILE]
                                [--check RECORD] [--write PAGE]

Every chain is cut for exchanges pair by pair, and played through with every message at the price of
the levels that it passes. RECORD is what benchmarks.chains or adagen bench --scale has measured.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

from adagen.cli.console import speaking
from adagen.errors import AdagenError
from adagen.library import read
from adagen.model import Model
from adagen.schedule import CostProfile, Fabric, load_profile, read_fabric, shipped_fabric
from adagen.search.several_hosts import batch_state_time
from adagen.studies.bench.figures import chain
from adagen.studies.bench.report import table
from adagen.studies.bench.scale import predicted_batches
from adagen.studies.bench.scale_record import STRETCHES, Scale, read_scale
from benchmarks.cluster_chains import Beyond, Chain
from benchmarks.critical_path import KINDS
from benchmarks.page import command, publish

JOINTS = (1000, 2000, 5000)
PROCESSES = (4, 16, 64, 256, 1024)
BATCHES = (8, 32, 200)
"""Joints of the chains whose batches are predicted."""

Found = dict[int, tuple[float, list[Beyond]]]
"""By joints: microseconds on one process, and on several."""


def predicted(
    joints: Sequence[int], processes: Sequence[int], profile: CostProfile, fabric: Fabric
) -> Found:
    """Return what is predicted of chains."""
    found: Found = {}
    with speaking("predicting") as on_progress:
        for count in joints:
            on_progress(f"chain of {count}")
            one = Chain(robot(count), profile)
            each = [one.on(p, fabric.links) for p in processes if p <= fabric.processes]
            found[count] = one.alone(), [some for some in each if some is not None]
    return found


def robot(joints: int) -> Model:
    """Return a chain."""
    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        file = Path(folder, f"chain{joints}.urdf")
        file.write_text(chain(joints), encoding="utf-8")
        return read(file).model


def of_times(found: Found) -> Iterator[str]:
    """Yield the table of times: a row for each number of processes, a column for each chain."""
    head = ["P", *(f"chain of {joints}, us" for joints in found)]
    rows = [["1", *(f"{alone:.1f}" for alone, _ in found.values())]]
    for processes in sorted({one.processes for _, each in found.values() for one in each}):
        cells = []
        for alone, each in found.values():
            one = next((one for one in each if one.processes == processes), None)
            saved = "" if one is None else f"{one.time:.2f} ({1 - one.time / alone:.1%})"
            cells.append(saved)
        rows.append([str(processes), *cells])
    yield from table(head, rows)


def of_limits(found: Found) -> Iterator[str]:
    """Yield the table of what the longest way consists of, per cent of the time."""
    rows = []
    for joints, (_, each) in found.items():
        for one in each:
            times = one.limits.times
            shares = [f"{times[kind] / one.time:.0%}" for kind in KINDS]
            rows.append((joints, one.processes, *shares, one.limits.hops))
    yield from table(("joints", "P", *KINDS, "messages"), rows)


def of_batches(profile: CostProfile, fabric: Fabric) -> Iterator[str]:
    """Yield the table of batches on hosts."""
    assert profile.steps is not None  # as main has made sure
    rows = []
    for joints in BATCHES:
        model = robot(joints)
        state = batch_state_time(model, profile)
        rows += [
            (
                *(joints, f"{1e3 * state:.0f}", one.hosts, one.processes),
                *(f"{one.in_place:.3g}", f"{one.distributed:.3g}", one.limit),
            )
            for one in predicted_batches(model, fabric, profile.steps, state)
        ]
    head = ("joints", "ns a state", "hosts", "P", "own states/s", "distributed/s", "limited by")
    yield from table(head, rows)


def of_check(scale: Scale) -> Iterator[str]:
    """Yield the table of measured times beside predicted ones."""
    rows = []
    for row in scale.rows:
        if row.predicted is None or row.scaled is None:
            continue
        one = scale.row(row.joints, 1)
        saved = "" if one is None else f"{1 - row.least / one.least:.1%}"
        foretold = "" if one is None or not one.scaled else f"{1 - row.scaled / one.scaled:.1%}"
        mark = "≈" if row.source == STRETCHES else ""
        rows.append(
            (
                *(row.joints, row.processes, row.meeting, f"{mark}{row.least / 1e3:.2f}"),
                *(f"{row.predicted / 1e3:.2f}", f"{row.least / row.predicted - 1:+.0%}"),
                *(f"{row.scaled / 1e3:.2f}", f"{row.least / row.scaled - 1:+.0%}"),
                *(saved, foretold),
            )
        )
    head = ("joints", "P", "meeting", "us", "predicted", "off", "at this speed", "off")
    yield from table((*head, "saved", "predicted to be saved"), rows)


def main(words: Sequence[str] | None = None) -> int:
    """Predict what the command line names, print tables, and return the exit status."""
    parser = command(__doc__)
    parser.add_argument("--joints", type=int, nargs="+", default=JOINTS)
    parser.add_argument("--processes", type=int, nargs="+", default=PROCESSES)
    parser.add_argument("--profile", default="default", help="a measured one")
    parser.add_argument("--hosts", type=Path, metavar="FILE", help="levels of a cluster (TOML)")
    parser.add_argument("--check", type=Path, metavar="RECORD", help="of measured chains")
    options = parser.parse_args(words)
    try:
        profile = load_profile(options.profile)
        if profile.steps is None:
            parser.error(f"the profile {profile.name} has no costs of steps")
        fabric = shipped_fabric() if options.hosts is None else read_fabric(options.hosts)
        found = predicted(options.joints, options.processes, profile, fabric)
        blocks = {
            "times": "\n".join(of_times(found)),
            "limits": "\n".join(of_limits(found)),
            "batches": "\n".join(of_batches(profile, fabric)),
        }
        if options.check is not None:
            blocks["check"] = "\n".join(of_check(read_scale(options.check)))
    except AdagenError as error:
        print(error, file=sys.stderr)
        return error.status
    for name, text in blocks.items():
        publish(options, f"beyond.{name}", f"{text}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
