"""Emitted solvers beside pinocchio, casadi and MuJoCo on 15 robots: ``make bench``.

    python -m benchmarks.bench [--quick] [--resume] [--only NAME ...] [--profile NAME] [--out DIR]

Arms, a quadruped, humanoids, the paper's human figures, chains of 16 to 1000 joints. Writes the
record (JSON) beside this file and tables and pictures into docs; --out DIR puts everything there
instead. After each robot the record so far is kept: --resume goes on from it, and with --only it
measures those robots again among the others.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from adagen.cli.console import note
from adagen.cli.contest import Entry, contest
from adagen.cli.scale import draw
from adagen.errors import AdagenError
from adagen.studies.bench.contest import Rules
from adagen.studies.bench.record import Record, read_record
from adagen.studies.bench.report import markdown
from adagen.studies.records import write_record
from benchmarks.page import ROOT, write_between_marks
from benchmarks.paper import robots
from benchmarks.real_robots import FLOATING, file_of

WORK = ROOT / "build" / "bench"
REAL = ("ur5", "panda", "anymal_b", "g1", "icub", "talos")
"""Of benchmarks.real_robots."""
CHAINS = (16, 50, 100, 200, 500, 1000)
TOO_LONG = {
    1000: {
        "pinocchio": "pinocchio::Data holds four tensors of 1000^3 numbers, 32 GB",
        "mujoco": "its rounds would take minutes",
    }
}
"""Peers that are left out by joints of a chain, and why."""
LONG, FEW = 500, ("--procs 1", "--procs 2", "--procs 1 --batch")
"""Chains from so many joints on take part with these variants alone: others compile for minutes."""
QUICK = ("ur5", "human40")


def entries() -> Iterator[Entry]:
    """Yield the robots; those of example-robot-data where it is installed."""
    for name in REAL:
        if file_of(name).is_file():
            words = ("--floating",) * (name in FLOATING)
            yield Entry(name.removesuffix("_b"), file_of(name), words)
        else:
            note(f"without {name}: pip install example-robot-data")
    for dofs in robots.HUMANS:
        yield _made(f"human{dofs}", robots.human(dofs))
    for joints in CHAINS:
        made = _made(f"chain{joints}", robots.chain(joints))
        variants = FEW if joints >= LONG else ()
        yield replace(made, without=TOO_LONG.get(joints, {}), variants=variants)


def _made(name: str, text: str) -> Entry:
    """Return a robot whose description is written here."""
    path = WORK / f"{name}.urdf"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return Entry(name, path)


def publish(record: Record, out: Path | None) -> None:
    """Write record, tables and pictures into a folder, or where the project keeps them."""
    if out is not None:
        out.mkdir(parents=True, exist_ok=True)
        write_record(record, out / "bench.json")
        (out / "bench.md").write_text(markdown(record), encoding="utf-8")
        draw(record, out, ("svg", "png"))
        return
    write_record(record, ROOT / "benchmarks" / "bench.json")
    pictures = draw(record, ROOT / "docs" / "records" / "pictures")
    shown = "\n\n".join(f"![{path.stem}](pictures/{path.name})" for path in pictures)
    page = ROOT / "docs" / "records" / "benchmarks.md"
    write_between_marks(page, "bench", f"{shown}\n\n{markdown(record)}")


def main(words: Sequence[str] | None = None) -> int:
    """Measure, write what came of it, and return the exit status.

    Args:
        words: the command line, that of this process by default.
    """
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--quick", action="store_true", help="two robots, few turns")
    parser.add_argument("--resume", action="store_true", help="keep robots measured before")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="these robots alone")
    parser.add_argument("--profile", default="default", metavar="NAME", help="cost profile")
    parser.add_argument("--out", type=Path, metavar="DIR", help="write everything there")
    options = parser.parse_args(words)
    wanted = options.only or (QUICK if options.quick else None)
    by_profile = ("--profile", options.profile)
    every = [replace(entry, words=(*entry.words, *by_profile)) for entry in entries()]
    for name in set(wanted or ()) - {entry.name for entry in every}:
        parser.error(f"no robot here is called {name}")
    rules = Rules(rounds=3, repeat=5) if options.quick else Rules()
    so_far = WORK / "so_far.json"
    try:
        before = read_record(so_far).models if options.resume and so_far.is_file() else ()
        before = tuple(model for model in before if model.name not in (options.only or ()))
        kept = {model.name for model in before}
        some = [e for e in every if wanted is None or e.name in wanted or e.name in kept]
        start = time.perf_counter()
        record = contest(
            some,
            rules,
            done=lambda found: write_record(found, so_far),
            before=before,
            keep_going=True,
        )
    except AdagenError as error:
        print(error, file=sys.stderr)
        return error.status
    note(f"measured in {time.perf_counter() - start:.0f} s")
    publish(record, options.out or (WORK / "quick" if options.quick else None))
    return 0


if __name__ == "__main__":
    sys.exit(main())
