"""``python -m benchmarks.search [TABLE ...]``: what is proven of schedules, and how fast.

Writes tables of docs/records/search.md: of joins (Eq. 11, the paper's constants), and of real
robots, with and without friction, and long chains as they are played (form segment, the shipped
costs).
Robots of adagen's test environment (example-robot-data) that are not there are left out.
"""

from __future__ import annotations

import argparse
import random
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from adagen import paper
from adagen.calibrate.robots import rubbing
from adagen.emit.shapes import chosen_shape, predict
from adagen.garbage import seldom_collected
from adagen.model import Model
from adagen.paper.restricted import joined_between_processes
from adagen.plan import make_plan
from adagen.schedule import Schedule, Topology, load_profile
from adagen.schedule.tree import Split
from adagen.search import best_schedule, find_schedule
from adagen.studies.stability.robots import chain, rod
from benchmarks.page import ROOT
from benchmarks.paper import robots
from benchmarks.paper.measured import machine, model_of
from benchmarks.real_robots import FLOATING, file_of
from benchmarks.real_robots import model_of as real_model

PAPER = load_profile("paper")
DEFAULT = load_profile("default")
PAGE = ROOT / "docs" / "records" / "search.md"
REAL = {"talos": "talos", "g1": "g1_hands", "icub": "icub_reduced", "tiago_dual": "tiago_dual"}
"""Robots of the table of joins, as it calls them; all of them float."""
PLAYED = (
    *("a1", "alex_nub_hands", "allegro_left", "anymal_kinova", "b1_z1", "baxter", "bolt"),
    *("centauro", "g1_hands", "human", "icub", "panda", "pr2", "romeo_small", "simple_humanoid"),
    *("solo12", "talos", "talos_reduced", "tiago", "tiago_dual", "tiago_pro", "ur5", "xarm7"),
)
"""Robots that are played, on a base as they are used."""
CHAINS = ((200, 4), (200, 8), (2000, 4), (10_000, 16))  # joints that turn, processes
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
    for shown_as, name in REAL.items():
        model = real_model(name, floating=True)
        if model is not None:
            yield shown_as, model


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
            paper.find_schedule,
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


def played() -> Iterator[str]:
    """Yield the lines of the table of real robots, under the default budget."""
    for name, model in shown():
        for processes in (2, 4, 8):
            yield searched(name, model, processes)


def friction() -> Iterator[str]:
    """Yield the lines of the table of the same robots with friction at all joints."""
    for name, model in shown():
        for processes in (2, 4):
            yield searched(name, rubbing(model), processes)


def chains() -> Iterator[str]:
    """Yield the lines of the table of long chains, under the default budget."""
    for joints, processes in CHAINS:
        yield searched(f"chain {joints}", turning(joints), processes)


def searched(name: str, model: Model, processes: int) -> str:
    """Return what is found and proven of a robot as a line; its times are of what is emitted."""
    found, _, busy = timed(best_schedule, model, processes, DEFAULT)
    never = [False] * len(model.joints)
    one = find_schedule(Topology.of(model), processes, profile=DEFAULT, cuttable=never)
    alone = predict(make_plan(model, one), DEFAULT).makespan
    return line(
        *(name, len(model.joints), processes, f"{alone:.3f}", f"{found.makespan:.3f}"),
        *(f"{found.lower_bound:.3f}", proof(found), family(found)),
        chosen_shape(make_plan(model, found), profile=DEFAULT),
        *(found.candidates, found.straight_lines, found.expanded, f"{busy:.1f}"),
    )


def shown() -> Iterator[tuple[str, Model]]:
    """Yield the real robots that there are."""
    for name in PLAYED:
        model = real_model(name)
        if model is not None:
            yield file_of(name).stem + ", floating" * (name in FLOATING), model


def turning(joints: int) -> Model:
    """Return a chain of rods whose joints turn about x, y and z in turn."""
    return chain(f"chain {joints}", [rod()] * joints, axes="xyz")


def family(schedule: Schedule) -> str:
    """Return the family of a schedule that was chosen from several."""
    if schedule.meeting in ("gather", "exchange"):
        return {"gather": "gathered", "exchange": "exchanged"}[schedule.meeting]
    return "joined" if joined_between_processes(schedule.root) else "alone"


def timed(
    search: Callable[..., Schedule], *arguments: Any, **options: Any
) -> tuple[Schedule, float, float]:
    """Return what a search finds, and the seconds by the clock and of the processor."""
    begin, busy = time.perf_counter(), time.process_time()
    found = search(*arguments, **options)
    return found, time.perf_counter() - begin, time.process_time() - busy


def proof(schedule: Schedule) -> str:
    """Return the verdict in words."""
    exact = schedule.verdict == "optimal"
    return "optimal" if exact else f"gap <= {100 * schedule.gap:.1f} %"


def line(*cells: object) -> str:
    """Return a line of a table."""
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


HEAD = "# The search, measured\n"
TITLES = {
    "joins": """## By joins

Written by `python -m benchmarks.search joins` ({machine}, with other work beside it, which affects
the seconds and, where the budget was used up, the bound). Strategy `exact`, the paper's
constants, tie-break `work`; makespans are in the paper's microseconds. `split`: `always` as
in Section III-C; `free`: two descendants may share their range, one after the other;
`any`: they may also divide it unevenly. A bound holds for all schedules under the same
rule, so bounds under different rules cannot be compared; makespans can. One row by hand:
`adagen schedule ROBOT --procs P --profile paper --form ada --split SPLIT`.

| robot | joints | P | split | makespan | bound | verdict | expanded | seconds | of CPU | budget |
|---|---|---|---|---|---|---|---|---|---|---|
""",
    "played": """## By predicted time

Written by `python -m benchmarks.search played` ({machine}). Form
`segment`, the shipped costs. Times are predicted times of the emitted program in microseconds.
*Alone*: one process, in its best shape. *Bound*: a lower bound for all programs in shape `kernels`
and for the `unrolled` programs that were priced
([what the verdict means](../explanation/search.md#what-the-verdict-means)). *Family*: one process
alone, processes that gather at a core, or processes that are joined. The search ends after a fixed
budget, the same on every machine. One row by hand: `adagen schedule ROBOT --procs P`, with
`--floating` where the table says so; it leaves all work to one process where others save less than
the profile's `process.margin`, which the table does not.

{columns}
""",
    "friction": """## With friction

Written by `python -m benchmarks.search friction` ({machine}). The same robots with friction at all
hinges and sliders, whose hyperbolic tangents the process takes that has the joint; the columns as
above.

{columns}
""",
    "chains": """## Long chains

Written by `python -m benchmarks.search chains` ({machine}). Chains of joints that turn about x, y
and z in turn; the columns as above. *Exchanged*: the processes of both sides join each cut.

{columns}
""",
}
COLUMNS = """| robot | joints | P | alone | makespan | bound | verdict | family | shape | as loops | as lines | expanded | seconds of CPU |
|---|---|---|---|---|---|---|---|---|---|---|---|---|"""  # noqa: E501
TABLES: dict[str, Callable[[], Iterator[str]]] = {
    "joins": joins,
    "played": played,
    "friction": friction,
    "chains": chains,
}


def page(name: str, rows: Sequence[str]) -> str:
    """Return the page with one of its tables written anew."""
    made = TITLES[name].format(machine=machine(), columns=COLUMNS) + "\n".join(rows) + "\n"
    heading = made.splitlines()[0]
    old = PAGE.read_text(encoding="utf-8").split("\n## ")[1:] if PAGE.exists() else []
    sections = {text.splitlines()[0]: f"## {text.rstrip()}\n" for text in old}
    sections[heading.removeprefix("## ")] = made
    return "\n".join([HEAD, *sections.values()])


def main(words: Sequence[str]) -> int:
    """Write the tables."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.search", description=__doc__)
    parser.add_argument("tables", nargs="*", metavar="TABLE", help=", ".join(TABLES) + "; all")
    names = parser.parse_args(words).tables or list(TABLES)
    if unknown := set(names) - set(TABLES):
        parser.error(f"no table {', '.join(sorted(unknown))}; there are {', '.join(TABLES)}")
    for name in names:
        rows = []
        with seldom_collected():  # as the command line does it
            for row in TABLES[name]():
                rows.append(row)
                print(row, flush=True)
        PAGE.write_text(page(name, rows), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
