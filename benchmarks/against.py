"""This revision's solvers beside another revision's: ``python -m benchmarks.against REVISION``.

    python -m benchmarks.against REVISION [--robots NAME ...] [--build] [--page] [--kept]

The robots and variants of ``benchmarks.bench`` (docs/records/benchmarks.md). The other revision is
checked out into a temporary git worktree and emits its solvers itself. All solvers are built first
(--build ends there); sources and executables are kept, so that a run that was ended goes on. Then
they are timed by turns, robot by robot, each figure's two solvers one after the other. --page
writes the table into docs/records/against.md, --kept from what was measured before. Nothing is
asserted: figures of one machine are no test.
"""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import mean, median

from adagen.build import build_executable, find_toolchain
from adagen.cli.console import note, speaking
from adagen.cli.contest import Entry
from adagen.emit.runtime import FOLDER
from adagen.emit.solver_program import PROGRAM_FILE, standalone
from adagen.model import Model
from adagen.run import cores
from adagen.studies.bench.contest import WORDS, Contestant, Rules, Times, hold
from adagen.studies.bench.emitted import Emitted
from adagen.studies.bench.machine import machine
from adagen.studies.bench.report import table
from adagen.studies.bench.variants import MOST_TEXT, VARIANTS
from adagen.urdf import read_robot
from benchmarks.bench import entries
from benchmarks.page import ROOT, command, publish

WORK = ROOT / "build" / "against"
RECORD = WORK / "record.json"
SLOWER = 1.03
"""Ratio of times from which a figure counts as slower."""
THIS = "this"
HEAD = ("robot", "figure", "before, ns", "this, ns", "ratio", "ratio of least", "")


@dataclass(frozen=True)
class Source:
    """What a revision emits for a robot and a variant: one C++ file, or why there is none."""

    file: str
    text: str
    refused: str

    @property
    def wanted(self) -> bool:
        """Whether it is built: with more text, a contest would be one of compilers."""
        return not self.refused and len(self.text) <= MOST_TEXT


@dataclass(frozen=True)
class Row:
    """A figure of both revisions; nanoseconds of an evaluation, or of a state in a batch.

    Attributes:
        robot: its name.
        figure: the variant in the words of the command line, and what of it was timed.
        before: the other revision's time, :func:`typical` of its turns.
        now: this revision's.
        least_before: the other revision's fastest evaluation.
        least_now: this revision's.
    """

    robot: str
    figure: str
    before: float
    now: float
    least_before: float
    least_now: float

    @property
    def ratio(self) -> float:
        """This revision's time over the other's."""
        return self.now / self.before

    @property
    def least_ratio(self) -> float:
        """The same of the fastest evaluations."""
        return self.least_now / self.least_before


def typical(turns: Sequence[float]) -> float:
    """Return the mean of the middle half of the turns' medians.

    Many clocks tick in tens of nanoseconds, and a median is one tick or the next: the mean of
    several tells what is between, and the middle half leaves noisy turns out.
    """
    quarter = len(turns) // 4
    return mean(sorted(turns)[quarter : len(turns) - quarter])


def digest(checkout: Path) -> str:
    """Return what tells one compiler from another: the hash of all that emission reads of it."""
    found = hashlib.sha256()
    for folder in ("adagen", "templates"):
        for path in sorted((checkout / folder).rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts:
                found.update(f"{path.relative_to(checkout)}\0".encode() + path.read_bytes())
    return found.hexdigest()[:16]


@contextmanager
def checked_out(commit: str) -> Iterator[Path]:
    """Lend a worktree of a commit of this repository."""
    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        checkout = Path(folder, "checkout")
        _git("worktree", "add", "--detach", "--quiet", str(checkout), commit)
        try:
            yield checkout
        finally:
            _git("worktree", "remove", "--force", str(checkout))


def _git(*words: str) -> str:
    done = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(done.stderr.strip())
    return done.stdout.strip()


def emitted(checkout: Path, kept: Path, entry: Entry, variant: str) -> Source:
    """Return what a checkout emits, now or before; a refusal is kept, too.

    Args:
        checkout: folder of the revision.
        kept: where its sources are kept.
        entry: the robot.
        variant: words of the command line.
    """
    words = [*entry.words, *variant.split()]
    place = kept / f"{entry.name}{''.join(words)}.json"
    if not place.is_file():
        with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
            command = [sys.executable, "-m", "adagen", str(entry.file), *words, "--out", folder]
            environment = {**os.environ, "PYTHONPATH": str(checkout)}
            done = subprocess.run(
                command, cwd=checkout, env=environment, capture_output=True, text=True, check=False
            )
            if done.returncode == 0:
                file = next(Path(folder).glob("*_p[0-9]*.cpp"))
                text = file.read_text(encoding="utf-8")
                program = file.with_name(PROGRAM_FILE)
                if program.is_file():  # of that revision, as the solver is, and its headers
                    headers = {
                        header.relative_to(folder).as_posix(): header.read_text(encoding="utf-8")
                        for header in Path(folder, FOLDER).rglob("*.hpp")
                    }
                    text = standalone(text, program.read_text(encoding="utf-8"), headers)
                found = Source(file.name, text, "")
            else:
                found = Source("", "", done.stderr.strip())
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(json.dumps(asdict(found)), encoding="utf-8")
    return Source(**json.loads(place.read_text(encoding="utf-8")))


Pair = tuple[Source, Source]
"""What the other revision emits, and what this one does."""


def all_sources(commit: str, robots: Sequence[Entry]) -> dict[tuple[str, str], Pair]:
    """Return both revisions' sources by robot and variant, all of them built."""
    jobs = [(entry, variant) for entry in robots for variant in entry.variants or VARIANTS]

    def made(checkout: Path, kept: Path, whose: str) -> list[Source]:
        def one(job: tuple[Entry, str]) -> Source:
            note(f"{whose}: emitting {job[0].name} {job[1]}")
            return emitted(checkout, kept, *job)

        with ThreadPoolExecutor(cores()) as pool:
            found = list(pool.map(one, jobs))
        build_all(found, whose)
        return found

    with checked_out(commit) as checkout:
        before = made(checkout, WORK / commit, commit[:10])
    now = made(ROOT, WORK / digest(ROOT), THIS)
    keys = [(entry.name, variant) for entry, variant in jobs]
    return dict(zip(keys, zip(before, now, strict=True), strict=True))


def build_all(sources: Sequence[Source], whose: str) -> None:
    """Compile what is wanted and not yet in the cache, as many at a time as there are cores."""
    toolchain = find_toolchain()
    texts = {one.text: one for one in sources if one.wanted}

    def build(number_and_source: tuple[int, Source]) -> None:
        number, one = number_and_source
        note(f"{whose}: building {number} of {len(texts)}, {one.file}")
        build_executable(one.text, one.file.removesuffix(".cpp"), toolchain)

    with ThreadPoolExecutor(cores()) as pool:
        list(pool.map(build, enumerate(texts.values(), start=1)))


def times_of(
    entry: Entry, pairs: dict[str, Pair], rules: Rules, on_progress: Callable[[str], None]
) -> list[Row]:
    """Time a robot's solvers by turns, and return a row for each figure."""
    model = read_robot(entry.file, floating="--floating" in entry.words).model
    toolchain = find_toolchain()
    by_text: dict[str, Contestant] = {}  # variants often come to the same source
    names: dict[tuple[str, str], list[str]] = {}
    for variant, (before, now) in pairs.items():
        if not (before.wanted and now.wanted):
            continue
        for whose, source in (("before", before), (THIS, now)):
            if source.text not in by_text:
                solver = _emitted(f"{variant} {whose}", model, source, variant)
                by_text[source.text] = solver.contestant(toolchain, stretches=True)
        both = by_text[before.text].name, by_text[now.text].name
        names.setdefault(both, []).append(variant.replace("--procs ", "P="))
    times, gone = hold(list(by_text.values()), rules, on_progress)
    for name, why in gone.items():
        note(f"{entry.name} {name}: {why}")
    return [
        row
        for (before, now), variants in names.items()
        if before in times and now in times
        for row in _rows(entry.name, "; ".join(variants), times[before], times[now])
    ]


def _emitted(name: str, model: Model, source: Source, variant: str) -> Emitted:
    words = variant.split()
    processes = int(words[words.index("--procs") + 1])
    return Emitted(name, model, source.file, source.text, variant, processes, "", None)


def _rows(
    robot: str, variants: str, before: dict[str, Times], now: dict[str, Times]
) -> Iterator[Row]:
    for what in before.keys() & now.keys():
        old, new = before[what], now[what]
        yield Row(
            robot,
            f"{variants}{WORDS[what]}",
            typical(old.turns),
            typical(new.turns),
            old.least,
            new.least,
        )


def report(rows: Sequence[Row]) -> str:
    """Return the rows, slowest figure of a robot first, and what they come to, as Markdown."""
    lines = []
    names = list(dict.fromkeys(row.robot for row in rows))
    for row in sorted(rows, key=lambda row: (names.index(row.robot), -row.ratio)):
        mark = "slower" if row.ratio > SLOWER else ""
        ratios = (f"{row.ratio:.3f}", f"{row.least_ratio:.3f}")
        lines.append((row.robot, row.figure, _ns(row.before), _ns(row.now), *ratios, mark))
    every = [row.ratio for row in rows]
    slower = sum(ratio > SLOWER for ratio in every)
    return "\n".join(
        [
            *table(HEAD, lines),
            "",
            f"{len(rows)} figures: {slower} take more than {SLOWER} x the other revision's time; "
            f"ratios from {min(every):.2f} to {max(every):.2f}, median {median(every):.3f}.",
        ]
    )


def _ns(time: float) -> str:
    return f"{time:.0f}" if time >= 100 else f"{time:.1f}"


def main() -> None:
    """Build and measure what the command line names, and print the table."""
    parser = command(__doc__, "records/against.md")
    parser.add_argument("revision", help="the other revision, as git names it")
    parser.add_argument("--robots", nargs="+", metavar="NAME", help="these alone")
    parser.add_argument("--rounds", type=int, default=Rules().rounds)
    parser.add_argument("--build", action="store_true", help="emit and build, time nothing")
    parser.add_argument("--kept", action="store_true", help="measure nothing: use the record")
    options = parser.parse_args()
    commit = _git("rev-parse", "--verify", f"{options.revision}^{{commit}}")
    if not options.kept:
        every = list(entries())
        robots = [one for one in every if options.robots is None or one.name in options.robots]
        if unknown := set(options.robots or ()) - {one.name for one in every}:
            parser.error(f"no robot here is called {', '.join(sorted(unknown))}")
        sources = all_sources(commit, robots)
        if options.build:
            return
        _measure(commit, robots, sources, Rules(rounds=options.rounds))
    record = json.loads(RECORD.read_text(encoding="utf-8"))
    text = report([Row(**row) for row in record["rows"]])
    publish(options, "against", f"{_about(record)}\n\n{text}")


def _measure(
    commit: str, robots: Sequence[Entry], sources: dict[tuple[str, str], Pair], rules: Rules
) -> None:
    """Time robot by robot; the record so far is kept after each."""
    rows: list[Row] = []
    where = machine()
    for number, entry in enumerate(robots, start=1):
        own = {variant: pair for (name, variant), pair in sources.items() if name == entry.name}
        for variant, (before, now) in own.items():
            if before.refused != now.refused:
                note(f"{entry.name} {variant}: {before.refused or now.refused}")
        with speaking(f"{entry.name}, robot {number} of {len(robots)}") as on_progress:
            rows += times_of(entry, own, rules, on_progress)
        record = {
            "commit": commit,
            "machine": where,
            "rounds": rules.rounds,
            "repeat": rules.repeat,
            "rows": [asdict(row) for row in rows],
        }
        RECORD.parent.mkdir(parents=True, exist_ok=True)
        RECORD.write_text(json.dumps(record, indent=1), encoding="utf-8")


def _about(record: dict[str, object]) -> str:
    where = record["machine"]
    assert isinstance(where, dict)
    built_by = ", ".join(where["compilers"].values())
    return (
        f"Beside revision {str(record['commit'])[:10]}. {where['processor']}, {built_by}; "
        f"{record['rounds']} rounds by turns, {record['repeat']} evaluations of each of 64 random "
        "states in a turn."
    )


if __name__ == "__main__":
    main()
