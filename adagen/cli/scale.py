"""``adagen bench --scale``: chains on more and more processes, batches on more and more hosts."""

from __future__ import annotations

import argparse
import dataclasses
import json
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from adagen.cli.console import note, speaking, wrote
from adagen.cli.parser import Parser, listed, whole
from adagen.cli.tables import table_of, wrapped
from adagen.errors import UsageError

if TYPE_CHECKING:
    from adagen.schedule import Fabric
    from adagen.schedule.costs import StepCosts
    from adagen.studies.bench.record import Record
    from adagen.studies.bench.scale import Wanted
    from adagen.studies.bench.scale_record import Scale

JOINTS, PROCESSES = (50, 100, 200, 500, 1000), (1, 2, 4, 8, 16)
QUICK = (32, 64), (1, 2)
"""Joints and processes for a look."""
OF_BATCHES = 16
"""Joints of the chain whose batches are timed where no robot is named."""
PEER = "pinocchio"
Result = TypeVar("Result", bound="Record | Scale")

RECORD = "scale.json"


def add_scale(parser: Parser) -> None:
    """Add --scale and its own options."""
    parser.add_argument(
        "--scale",
        action="store_true",
        help="instead, chains on more and more processes beside pinocchio, and batches "
        "(of MODEL, if given) on processes and hosts",
    )
    joints, processes = (",".join(map(str, numbers)) for numbers in (JOINTS, PROCESSES))
    parser.add_argument(
        "--joints",
        type=listed(whole(2, 100_000)),
        metavar="N,N,...",
        help=f"with --scale: joints of the chains (default: {joints})",
    )
    parser.add_argument(
        "--processes",
        type=listed(whole(1, 64)),
        metavar="P,P,...",
        help=f"with --scale: processes that share a chain (default: {processes})",
    )
    parser.add_argument(
        "--hosts",
        type=Path,
        metavar="FILE",
        help="with --scale: levels of a cluster (TOML), on which batches are predicted (default: "
        "a fat tree of 1024 cores)",
    )
    parser.add_argument(
        "--priority",
        type=whole(1, 99),
        metavar="N",
        help="with --scale: real-time priority of what is timed, for a machine that is not idle "
        "(needs the right to it)",
    )
    parser.add_argument(
        "--resume",
        action="store_true",
        help="with --scale --out DIR: go on from DIR/scale.json, which is written after each chain",
    )
    parser.rare |= {"--joints", "--processes", "--hosts", "--priority", "--resume"}


def check_scale(parser: Parser, options: argparse.Namespace) -> None:
    """Refuse options that do not go together."""
    if not options.scale:
        for name in ("joints", "processes", "hosts", "priority", "resume"):
            if getattr(options, name) not in (None, False):
                parser.error(f"--{name} is for --scale")
        if not options.models:
            parser.error("the following arguments are required: MODEL")
        return
    for name in ("floating", "scene", "variant"):
        if getattr(options, name):
            parser.error(f"--scale takes no --{name}: leave it out")
    if options.resume and options.out is None:
        parser.error("--resume goes on from a record: --out DIR says where it is")
    if len(options.models) > 1:
        parser.error("--scale times the batches of one MODEL at most")
    if set(options.peers or ()) - {PEER}:
        parser.error(f"--scale compares with {PEER} alone: --peers {PEER}, or none")


def run_scale(options: argparse.Namespace) -> int:
    """Measure, show and write what was asked for; return the exit status.

    Raises:
        AdagenError: the profile, the hosts or MODEL are refused, or nothing could be timed.
    """
    from adagen.schedule import load_profile, read_fabric, shipped_fabric
    from adagen.studies.bench.scale import measure_chains
    from adagen.studies.bench.scale_report import markdown

    profile = load_profile(options.profile)
    if profile.steps is None:
        raise UsageError(f"--scale needs a profile with costs of steps; {profile.name} has none")
    fabric = shipped_fabric() if options.hosts is None else read_fabric(options.hosts)
    wanted = _wanted(options)
    before, done = _record(options, profile.name)
    with speaking("scale") as on_progress:
        scale = measure_chains(wanted, on_progress, done, before)
        scale = _with_batches(scale, options, wanted, on_progress, fabric, profile.steps)
    for name, why in scale.absent.items():
        note(f"without {name}: {why}")
    give(scale, options, _show, "scale", markdown)
    return 0


def _record(
    options: argparse.Namespace, profile: str
) -> tuple[Scale | None, Callable[[Scale], None]]:
    """Return the record to go on from, and what keeps the record so far.

    Raises:
        AdagenError: there is one that cannot be gone on from.
    """
    from adagen.studies.bench.scale_record import read_scale
    from adagen.studies.records import write_record

    if options.out is None:
        return None, lambda _: None
    file, before = options.out / RECORD, None
    if options.resume and file.is_file():
        before = read_scale(file)
        if before.profile != profile:
            raise UsageError(f"{file} was measured with the profile {before.profile}")
    options.out.mkdir(parents=True, exist_ok=True)
    return before, lambda scale: write_record(scale, file)


def _wanted(options: argparse.Namespace) -> Wanted:
    from adagen.studies.bench.contest import Rules
    from adagen.studies.bench.scale import Wanted

    joints, processes = QUICK if options.quick else (JOINTS, PROCESSES)
    joints, processes = options.joints or joints, options.processes or processes
    return Wanted(
        [(count, processes) for count in sorted(set(joints))],
        Rules(rounds=2, repeat=2) if options.quick else Rules(options.rounds, repeat=10),
        options.profile,
        peer=options.peers is None or PEER in options.peers,
        priority=options.priority or 0,
    )


def _with_batches(
    scale: Scale,
    options: argparse.Namespace,
    wanted: Wanted,
    on_progress: Callable[[str], None],
    fabric: Fabric,
    costs: StepCosts,
) -> Scale:
    """Return a record with the batches of MODEL, or of a chain."""
    from adagen.library import read
    from adagen.studies.bench.figures import chain
    from adagen.studies.bench.scale import measure_batches, predicted_batches

    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        file = Path(folder, f"chain{OF_BATCHES}.urdf")
        if options.models:
            file = Path(options.models[0])
        else:
            file.write_text(chain(OF_BATCHES), encoding="utf-8")
        on_progress(f"batches of {file.stem}")
        model = read(file).model
        rows = measure_batches(file, wanted)
        state = 1e6 / rows[0].in_place  # on one process, as measured
        rows += predicted_batches(model, fabric, costs, state)
    return dataclasses.replace(scale, robot=file.stem, batches=rows)


def _show(scale: Scale) -> None:
    """Print the tables."""
    from rich.console import Console

    from adagen.studies.bench.scale_report import BATCHES, NOTE, TIMES, batches, times

    console = Console()
    ideal = TIMES.index("ideal")  # left out, for 80 columns
    heads, *rows = ((*row[:ideal], *row[ideal + 1 :]) for row in (TIMES, *times(scale)))
    console.print(table_of(heads, rows, title="chains", named=False))
    print(wrapped(NOTE))
    title = f"batches of {scale.robot} (≈: predicted)"
    console.print(table_of(BATCHES, batches(scale), title=title, named=False))


def give(
    record: Result,
    options: argparse.Namespace,
    show: Callable[[Result], None],
    name: str,
    markdown: Callable[[Result], str],
) -> None:
    """Print a record; with --out also write it, its tables and its pictures.

    Args:
        record: what was measured.
        options: of the command: ``json`` and ``out``.
        show: prints its tables.
        name: of the files, without ending.
        markdown: its tables as text.

    Raises:
        EnvironmentFault: writing failed.
    """
    if options.json:
        print(json.dumps(dataclasses.asdict(record), indent=1))
    else:
        show(record)
    if options.out is not None:
        from adagen.atomic_files import write_files
        from adagen.studies.records import write_record

        write_files(options.out, {f"{name}.md": markdown(record)})
        write_record(record, options.out / f"{name}.json")
        draw(record, options.out)


def draw(record: Record | Scale, folder: Path, endings: Sequence[str] = ("svg",)) -> list[Path]:
    """Write a record's pictures into a folder, where matplotlib is installed; return the files."""
    from adagen.studies.bench.record import Record

    try:
        from adagen.studies.bench.pictures import draw_all
        from adagen.studies.bench.scale_pictures import draw_scale
    except ImportError:
        note("without pictures: matplotlib is not installed (pip install 'adagen[bench]')")
        return []
    if isinstance(record, Record):
        written = draw_all(record, folder, endings)
    else:
        written = draw_scale(record, folder, endings)
    if written:
        wrote(written)
    return written
