"""``python -m benchmarks.search``: what is proven of schedules and how fast, to docs/search.md.

Robots of adagen's test environment (example-robot-data) that are not there are left out.
"""

from __future__ import annotations

import random
import sys
import sysconfig
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from adagen.schedule import Schedule, Topology, find_schedule, load_profile
from adagen.schedule.tree import Split
from adagen.urdf import read_robot
from benchmarks.paper import robots
from benchmarks.paper.measured import machine, model_of

PAPER = load_profile("paper")
ROOT = Path(__file__).resolve().parents[1]
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


def tasks() -> Iterator[Task]:
    """Yield what is asked of the search."""
    yield Task("serial 200", Topology.serial(200), 8, "always", 1.0)
    yield Task("serial 512", Topology.serial(512), 16, "always", 5.0)
    known = {f"human {dofs}": Topology.of(model_of(robots.human(dofs))) for dofs in robots.HUMANS}
    folder = Path(sysconfig.get_paths()["purelib"], PACKAGE)
    for name, (floating, file) in REAL.items():
        if (folder / file).exists():
            known[name] = Topology.of(read_robot(folder / file, floating=floating).model)
    for name, topology in known.items():
        for processes in (2, 4, 8) if name != "tiago_dual" else (8,):
            for split in SPLITS if processes == 8 else SPLITS[:2]:
                budget = 10.0 if name == "tiago_dual" else 1.0
                yield Task(name, topology, processes, split, budget)
    for name, topology in branched(200).items():
        for split in SPLITS:
            yield Task(name, topology, 8, split, 2.0)


def row(task: Task) -> str:
    """Return the line of a task in the table."""
    begin, busy = time.perf_counter(), time.process_time()
    s: Schedule = find_schedule(
        task.topology,
        task.processes,
        profile=PAPER,
        split=task.split,
        expansions=10**6,
        time_budget=task.budget,
    )
    spent, busy = time.perf_counter() - begin, time.process_time() - busy
    proof = "optimal" if s.verdict == "optimal" else f"gap <= {100 * s.gap:.1f} %"
    cells = (
        task.name,
        len(task.topology),
        task.processes,
        task.split,
        f"{s.makespan:.1f}",
        f"{s.lower_bound:.1f}",
        proof,
        s.expanded,
        f"{spent:.2f}",
        f"{busy:.2f}",
        f"{task.budget:g}",
    )
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


TEXT = """# How far the search gets

Written by `python -m benchmarks.search` ({machine}; other work went on at the same time, which
costs seconds and, where a budget strikes, some of the proof). Strategy `exact`, the paper's
constants, tie-break `work`; times of schedules are the paper's microseconds. `split`: `always` as
in Section III-C; `free`: two descendants may share their range, one after the other;
`any`: they may also divide it unevenly. A gap is proven against all schedules under the same
rule, so that bounds under different rules do not compare; the schedules do.

| robot | joints | P | split | makespan | bound | verdict | expanded | seconds | of CPU | budget |
|---|---|---|---|---|---|---|---|---|---|---|
{rows}
"""


def main() -> int:
    """Write the table."""
    rows = []
    for task in tasks():
        rows.append(row(task))
        print(rows[-1], flush=True)
    text = TEXT.format(machine=machine(), rows="\n".join(rows))
    (ROOT / "docs" / "search.md").write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
