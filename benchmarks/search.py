"""``python -m benchmarks.search [joins] [steps]``: what is proven of schedules and how fast.

Writes docs/search.md, the table of joins (Eq. 11, the paper's constants), that of steps (form
segment, the shipped costs), or both.
Robots of adagen's test environment (example-robot-data) that are not there are left out.
"""

from __future__ import annotations

import random
import sys
import sysconfig
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from adagen.model import Model
from adagen.schedule import Schedule, Topology, find_schedule, load_profile
from adagen.schedule.tree import Split
from adagen.urdf import read_robot
from benchmarks.paper import robots
from benchmarks.paper.measured import machine, model_of

PAPER = load_profile("paper")
DEFAULT = load_profile("default")
PAGE = Path(__file__).resolve().parents[1] / "docs" / "search.md"
PACKAGE = "cmeel.prefix/share/example-robot-data/robots"
REAL = {  # floating base or not, file within the package
    "talos": (True, "talos_data/robots/talos_full_v2.urdf"),
    "g1": (True, "g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf"),
    "icub": (True, "icub_description/robots/icub_reduced.urdf"),
    "tiago_dual": (True, "tiago_description/robots/tiago_dual.urdf"),
}
SPLITS: tuple[Split, ...] = ("always", "free", "any")


@dataclass(frozen=True)
class Task:
    """A robot, how many processes, which rule of division, and the seconds it may take."""

    name: str
    topology: Topology
    processes: int
    split: Split
    budget: float


def comb(joints: int) -> tuple[int, ...]:
    """Return a spine with a limb of three joints at each of its links."""
    parents: list[int] = []
    spine = 0
    while len(parents) < joints:
        parents.append(spine)
        spine = at = len(parents)
        for _ in range(3):
            if len(parents) < joints:
                parents.append(at)
                at = len(parents)
    return tuple(parents)


def branched(joints: int) -> dict[str, Topology]:
    """Return four branched robots."""
    draw = random.Random(1)
    limb = joints // 8
    shapes = {
        "binary": tuple(j // 2 for j in range(joints)),
        "comb": comb(joints),
        "random": tuple(draw.randint(0, j) for j in range(joints)),
        "star": tuple(0 if j % limb == 0 else j for j in range(joints)),
    }
    return {f"{name} {joints}": Topology.bare(parents) for name, parents in shapes.items()}


def real() -> Iterator[tuple[str, Model]]:
    """Yield the three human figures, and the real robots that there are."""
    for dofs in robots.HUMANS:
        yield f"human {dofs}", model_of(robots.human(dofs))
    folder = Path(sysconfig.get_paths()["purelib"], PACKAGE)
    for name, (floating, file) in REAL.items():
        if (folder / file).exists():
            yield name, read_robot(folder / file, floating=floating).model


def tasks() -> Iterator[Task]:
    """Yield what is asked of the search by joins."""
    yield Task("serial 200", Topology.serial(200), 8, "always", 1.0)
    yield Task("serial 512", Topology.serial(512), 16, "always", 5.0)
    for name, model in real():
        for processes in (2, 4, 8) if name != "tiago_dual" else (8,):
            for split in SPLITS if processes == 8 else SPLITS[:2]:
                budget = 10.0 if name == "tiago_dual" else 1.0
                yield Task(name, Topology.of(model), processes, split, budget)
    for name, topology in branched(200).items():
        for split in SPLITS:
            yield Task(name, topology, 8, split, 2.0)


def joins() -> Iterator[str]:
    """Yield the lines of the table of joins."""
    for task in tasks():
        s, spent, busy = timed(
            task.topology,
            task.processes,
            profile=PAPER,
            split=task.split,
            expansions=10**6,
            time_budget=task.budget,
        )
        yield line(
            *(task.name, len(task.topology), task.processes, task.split, f"{s.makespan:.1f}"),
            *(f"{s.lower_bound:.1f}", proof(s), s.expanded),
            *(f"{spent:.2f}", f"{busy:.2f}", f"{task.budget:g}"),
        )


def steps() -> Iterator[str]:
    """Yield the lines of the table of steps: times played through, and the default budget."""
    chains = [(f"serial {n}", Topology.serial(n), p) for n, p in ((64, 8), (200, 4), (200, 8))]
    known = [(name, Topology.of(model), p) for name, model in real() for p in (2, 4, 8)]
    for name, topology, processes in [*chains, ("serial 512", Topology.serial(512), 16), *known]:
        s, _, busy = timed(topology, processes, profile=DEFAULT)
        one = find_schedule(topology, 1, profile=DEFAULT)
        yield line(
            *(name, len(topology), processes, f"{one.makespan:.2f}", f"{s.makespan:.3f}"),
            *(f"{s.lower_bound:.3f}", proof(s), s.expanded, f"{busy:.2f}"),
        )


def timed(*arguments: Any, **options: Any) -> tuple[Schedule, float, float]:
    """Return what is found, and the seconds by the clock and of the processor."""
    begin, busy = time.perf_counter(), time.process_time()
    found = find_schedule(*arguments, **options)
    return found, time.perf_counter() - begin, time.process_time() - busy


def proof(schedule: Schedule) -> str:
    """Return the verdict in words."""
    exact = schedule.verdict == "optimal"
    return "optimal" if exact else f"gap <= {100 * schedule.gap:.1f} %"


def line(*cells: object) -> str:
    """Return a line of a table."""
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


HEAD = "# The search, and how far it gets\n"
TITLES = {
    "joins": """## By joins

Written by `python -m benchmarks.search joins` ({machine}; other work went on at the same time,
which costs seconds and, where a budget strikes, some of the proof). Strategy `exact`, the paper's
constants, tie-break `work`; times of schedules are the paper's microseconds. `split`: `always` as
in Section III-C; `free`: two descendants may share their range, one after the other;
`any`: they may also divide it unevenly. A gap is proven against all schedules under the same
rule, so that bounds under different rules do not compare; the schedules do. One row by hand:
`adagen schedule ROBOT --procs P --profile paper --form ada --split SPLIT`.

| robot | joints | P | split | makespan | bound | verdict | expanded | seconds | of CPU | budget |
|---|---|---|---|---|---|---|---|---|---|---|
""",
    "steps": """## By steps, as the machine sees it

Written by `python -m benchmarks.search steps` ({machine}). Form `segment`, the shipped costs,
ranges divided in any way (up to 16 processes; beyond, in halves); times in microseconds. The
makespan is that of the plan played through: both sweeps, waiting, messages, kinematics towards
cuts, which side stays local. So the verdict is about that, against all such schedules. The search
ends after a fixed number of expansions, the same on every machine. One row by hand:
`adagen schedule ROBOT --procs P`.

| robot | joints | P | on one process | makespan | bound | verdict | expanded | seconds of CPU |
|---|---|---|---|---|---|---|---|---|
""",
}
TABLES: dict[str, Callable[[], Iterator[str]]] = {"joins": joins, "steps": steps}


def page(name: str, rows: Sequence[str]) -> str:
    """Return the page with one of its tables written anew."""
    made = TITLES[name].format(machine=machine()) + "\n".join(rows) + "\n"
    heading = made.splitlines()[0]
    old = PAGE.read_text(encoding="utf-8").split("\n## ")[1:] if PAGE.exists() else []
    sections = {text.splitlines()[0]: f"## {text.rstrip()}\n" for text in old}
    sections[heading.removeprefix("## ")] = made
    return "\n".join([HEAD, *sections.values()])


def main(names: Sequence[str]) -> int:
    """Write the tables."""
    for name in names or TABLES:
        rows = []
        for row in TABLES[name]():
            rows.append(row)
            print(row, flush=True)
        PAGE.write_text(page(name, rows), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
