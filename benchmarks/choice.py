"""What ``--shape auto`` takes beside every shape and grouping: ``python -m benchmarks.choice``.

    python -m benchmarks.choice --build [--profile NAME] [--only NAME ...]
    python -m benchmarks.choice --time [--rounds N]
    python -m benchmarks.choice --page

Robots of example-robot-data and the shipped examples on one process and on two, in every shape,
limbs singly and side by side in every grouping that is compared. --build compiles what is not in
the cache, two programs at a time, and may be interrupted; what was chosen and predicted goes to
build/choice.json, where --only keeps what it has of other robots by the same profile. --time runs
all programs by turns: a round runs a fresh copy of each once, and the least median of all rounds
counts, since other work on the machine only ever adds to a time; it goes on where it was stopped.
--page writes the table into docs/records/choice.md. Where a second process gets nothing to do, one
process it is: that is not timed again.
"""

from __future__ import annotations

import json
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import asdict, dataclass, field
from pathlib import Path
from statistics import median
from typing import Any

from adagen.build import Toolchain, build_executable, find_toolchain
from adagen.build.cache import uses_mpi
from adagen.cost import programmed, timeline
from adagen.cost.lane_choice import offered_limbs
from adagen.emit import emit, stem_of
from adagen.emit.names import prefix_of
from adagen.emit.shapes import SHAPES, chosen_shape
from adagen.errors import AdagenError, EnvironmentFault
from adagen.executor import Grouping, groupings
from adagen.library.choice import choose
from adagen.library.request import Request
from adagen.plan import Plan, make_plan
from adagen.program import lower
from adagen.run import fresh_copy, launch
from adagen.schedule import CostProfile, load_profile, step_costs
from adagen.studies.bench.machine import machine
from adagen.studies.bench.report import table
from adagen.urdf import read_robot
from benchmarks.page import MODELS, ROOT, command, publish
from benchmarks.real_robots import FIXED, FLOATING, file_of
from benchmarks.solvers import tell

RECORD = ROOT / "build" / "choice.json"
FASTEST, SLOWEST = 1.05, 1.15
"""Ratios to the fastest shape that nearly all choices, and all, are to keep."""
HEAD = ("robot", "DOF", "P", "auto", "ns", "predicted", "fastest", "ns", "ratio")
MOST_TEXT = 2_500_000  # characters of a source: beyond, compilers take minutes

LEFT_OUT = ("alex_nub_hands", "centauro", "human", "icub_reduced", "romeo_small", "talos_reduced")
SHIPPED = {"arm7": False, "chain16": False, "human40": False, "humanoid": True, "mobile": False}
"""Shipped robots, and whether the base floats."""
ROBOTS = {
    **{name: (file_of(name), False) for name in FIXED if name not in LEFT_OUT},
    **{name: (file_of(name), True) for name in FLOATING if name not in LEFT_OUT},
    **{name: (MODELS / f"{name}.urdf", floating) for name, floating in SHIPPED.items()},
}
"""Files, and whether the base floats."""


@dataclass
class Way:
    """A program of a robot; times in microseconds.

    Attributes:
        label: shape and grouping.
        shape: its code shape.
        predicted: by the profile.
        executable: where it is.
        times: medians of the rounds.
    """

    label: str
    shape: str
    predicted: float
    executable: str
    times: list[float] = field(default_factory=list)

    @property
    def time(self) -> float:
        """The least median."""
        return min(self.times)


@dataclass
class Case:
    """A robot on a number of processes.

    Attributes:
        robot: its name.
        freedoms: degrees of freedom.
        processes: P.
        working: how many of them have something to do.
        chosen: the label of what ``--shape auto`` emits.
        ways: all programs.
    """

    robot: str
    freedoms: int
    processes: int
    working: int
    chosen: str
    ways: list[Way]

    @property
    def auto(self) -> Way:
        """The way that is chosen."""
        return next(way for way in self.ways if way.label == self.chosen)

    @property
    def best(self) -> Way:
        """The fastest way."""
        return min(self.ways, key=lambda way: way.time)

    @property
    def ratio(self) -> float:
        """How much slower than the fastest program the chosen one is, as a ratio."""
        return self.auto.time / self.best.time


def built(name: str, path: Path, floating: bool, priced: str) -> list[Case]:
    """Build all programs of a robot on one process and on two, by a profile of that name."""
    model, profile, found = read_robot(path, floating=floating).model, load_profile(priced), []
    for processes in (1, 2):
        asked = Request(procs=processes, profile=priced)
        plan = make_plan(model, choose(model, asked).schedule)
        working = sum(bool(process.owns) for process in plan.processes)
        if working == processes:
            ways, chosen = _built(plan, profile)
            found.append(Case(name, model.nv, processes, working, chosen, ways))
    return found


def _built(plan: Plan, profile: CostProfile) -> tuple[list[Way], str]:
    """Every program of a plan, and the label of the one that auto takes."""
    toolchain, stem = find_toolchain(), stem_of(plan)
    chosen = programmed(plan, chosen_shape(plan, profile=profile), profile)
    texts: dict[str, Way] = {}
    label = ""
    # What auto takes comes first, so that it is there whatever else cannot be built.
    tried = [(chosen.shape, chosen.slots.limbs), *_alternatives(plan, profile)]
    for number, (shape, limbs) in enumerate(tried):
        text = emit(plan, shape=shape, profile=profile, limbs=limbs)[f"{stem}.cpp"]
        # Without comments: what a profile predicts is no reason to build anew.
        code = "\n".join(line for line in text.splitlines() if not line.startswith("//"))
        if code in texts or len(text) > MOST_TEXT:
            continue
        program = lower(plan, shape, limbs=limbs, costs=step_costs(profile))
        counts = [f"{each.count}x{len(each.rows)}" for own in limbs for each in own]
        way = Way(
            " ".join([shape, *counts]),
            shape,
            timeline(program, profile).makespan,
            str(build_executable(_timed(code, stem), stem, toolchain)),
        )
        if way.label in {other.label for other in texts.values()}:
            way.label += f" ({number})"
        texts[code] = way
        label = label or way.label
    return list(texts.values()), label


def _timed(text: str, stem: str) -> str:
    """A solver with a small program that times it, in place of its own."""
    main = (Path(__file__).parent / "choice_program.cpp").read_text(encoding="utf-8")
    opening = 'MPI_COMM_WORLD, "auto", 10' if uses_mpi(text) else ""
    main = main.replace("OPENING", opening).replace("STEM", prefix_of(stem))
    return f"#define ADAGEN_NO_MAIN\n{text}{main}"


def measured(way: Way, processes: int, toolchain: Toolchain) -> float:
    """Return the median time of a program in one run, microseconds."""
    with fresh_copy(Path(way.executable)) as copy:
        done = launch(copy, processes, ["20"], toolchain, 60.0)
    if done.status != 0:
        raise EnvironmentFault(f"{way.executable} cannot be timed: {done.stderr}")
    return float(done.stdout) / 1e3


def _alternatives(plan: Plan, profile: CostProfile) -> Iterator[tuple[str, Grouping]]:
    """Shapes, and the groupings of limbs that are compared in each; all processes likewise."""
    if SHAPES["kernels"].why_not(plan) is None:
        offers = [offered_limbs(plan, process, step_costs(profile)) for process in plan.processes]
        for k in range(max(map(len, offers))):
            yield "kernels", tuple(own[min(k, len(own) - 1)] for own in offers)
    if SHAPES["unrolled"].why_not(plan) is None:
        for grouping in groupings(plan):
            yield "unrolled", grouping


def report(found: Sequence[Case]) -> str:
    """Return the rows and what they come to, as Markdown."""
    rows = []
    for case in found:
        auto, best = case.auto, case.best
        cells = [case.robot, case.freedoms, case.processes, auto.label, _ns(auto.time)]
        cells += [_ns(auto.predicted), best.label, _ns(best.time), f"{case.ratio:.2f}"]
        rows.append(cells)
    ratios = [case.ratio for case in found]
    near = sum(ratio <= FASTEST for ratio in ratios) / len(ratios)
    off = [way.predicted / way.time - 1 for case in found for way in case.ways]
    robots, programs = len({case.robot for case in found}), sum(len(c.ways) for c in found)
    return "\n".join(
        [
            *table(HEAD, rows),
            "",
            f"{robots} robots, {programs} programs. Of {len(found)} choices {near:.0%} take at "
            f"most {FASTEST} x the fastest program; the largest ratio is {max(ratios):.2f} (asked: "
            f"95 %, and {SLOWEST}). Predicted times are off by {median(map(abs, off)):.0%} "
            "(median).",
        ]
    )


def _ns(time: float) -> str:
    return f"{1e3 * time:.0f}"


def main() -> None:
    """Do what the command line says."""
    parser = command(__doc__, "records/choice.md")
    parser.add_argument("--build", action="store_true", help="build what is not built yet")
    parser.add_argument("--time", action="store_true", help="time all that was built")
    parser.add_argument("--profile", default="default", help="what auto goes by")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--only", nargs="*", metavar="NAME", help="these robots")
    options = parser.parse_args()
    if options.build:
        _build(options.profile, options.only)
    if options.time:
        _time(options.rounds)
    cases = _read()
    if not cases or not all(way.times for case in cases for way in case.ways):
        return
    record = _recorded()
    where, by = record["machine"], ", ".join(record["machine"]["compilers"].values())
    about = f"{where['processor']}, {by}; {record['rounds']} rounds by turns; profile"
    publish(options, "choice", f"{about} {record['profile']}.\n\n{report(cases)}")


def _build(name: str, only: Sequence[str] | None) -> None:
    wanted = [name for name in only or ROBOTS if ROBOTS[name][0].is_file()]
    profile, began = load_profile(name), time.monotonic()
    before = _recorded().get("profile") if only else None
    cases = _read() if before == profile.name else []
    order = list(ROBOTS)
    with ProcessPoolExecutor(2) as pool:
        futures = {pool.submit(built, each, *ROBOTS[each], name): each for each in wanted}
        for done in as_completed(futures):
            robot = futures[done]
            try:
                found = done.result()
            except AdagenError as error:
                tell(f"{robot} is left out: {error}")
                continue
            ways = ", ".join(f"{len(c.ways)} on {c.processes}" for c in found)
            tell(f"{time.monotonic() - began:.0f} s: {robot}: {ways}")
            cases = [*(c for c in cases if c.robot != robot), *found]
            cases.sort(key=lambda case: (order.index(case.robot), case.processes))
            _write({"profile": profile.name, "cases": list(map(asdict, cases))})


def _time(rounds: int) -> None:
    record, cases, toolchain = _recorded(), _read(), find_toolchain()
    record |= {"machine": machine(), "rounds": rounds}
    for k in range(rounds):
        for case in cases:
            left = [way for way in case.ways if len(way.times) == k]
            for way in left:
                way.times.append(measured(way, case.processes, toolchain))
            if left:
                _write(record | {"cases": list(map(asdict, cases))})
        tell(f"round {k + 1} of {rounds}")


def _recorded() -> dict[str, Any]:
    if not RECORD.is_file():
        return {"cases": []}
    found: dict[str, Any] = json.loads(RECORD.read_text(encoding="utf-8"))
    return found


def _read() -> list[Case]:
    cases = _recorded()["cases"]
    return [Case(**c | {"ways": [Way(**way) for way in c["ways"]]}) for c in cases]


def _write(record: dict[str, object]) -> None:
    RECORD.parent.mkdir(parents=True, exist_ok=True)
    RECORD.write_text(json.dumps(record, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
