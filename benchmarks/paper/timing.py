"""Fig. 4 and Table II: what the model predicts, and what this machine takes."""

from __future__ import annotations

from rich.console import Console
from rich.table import Table

from adagen.schedule import Schedule, Topology, load_profile
from adagen.schedule.draft import Draft
from adagen.search import find_schedule, named_schedule
from adagen.search.named import as_schedule
from benchmarks.paper import robots
from benchmarks.paper.measured import build, machine, measure, model_of
from benchmarks.paper.pictures import Line, save_chart

PAPER = load_profile("paper")
JOINTS = 200
ROOTS = (0, 24, 49, 74, 99, 124, 149, 174, 199)
PRINTED = {40: (0.249, 0.155, 0.153), 52: (0.301, 0.186, 0.177), 161: (0.773, 0.443, 0.356)}


def rooted(topology: Topology, root: int) -> Schedule:
    """Return the schedule of Fig. 4 on two processes: a root, all others one by one outwards."""
    n = len(topology)
    draft = Draft(n)
    draft.root = draft.contract(topology, [*range(root), *range(n - 1, root, -1), root])
    draft.assign(draft.root, (0, 2))
    return as_schedule(draft, topology, PAPER, "file")


def figure_4(*, run: bool = True) -> None:
    """Time of a 200-joint chain on two processes against the index of the root."""
    topology = Topology.serial(JOINTS)
    predicted = [(r, rooted(topology, r).makespan) for r in range(JOINTS)]
    one = named_schedule("sequential", topology, 1, profile=PAPER).makespan
    best = min(time for _, time in predicted)
    lines = [
        Line("two processes", predicted),
        Line("one process", [(0, one), (JOINTS - 1, one)], dashed=True),
    ]
    save_chart("fig4_predicted", "Fig. 4, predicted with the paper's constants", lines)
    print(f"predicted: one process {one:.1f} us, two {best:.1f} us: {1 - best / one:.1%} less")
    if run:
        _measured_4()


def _measured_4() -> None:
    model = model_of(robots.chain(JOINTS))
    topology = Topology.of(model)
    single = build(model, named_schedule("sequential", topology, 1, profile=PAPER))
    programs = [single, *(build(model, rooted(topology, root)) for root in ROOTS)]
    one, *two = measure(programs)
    table = Table("root", "median us", "least us", "against one process")
    table.add_row("one process", f"{one.median:.1f}", f"{one.least:.1f}", "")
    for root, times in zip(ROOTS, two, strict=True):
        saved = f"{times.median / one.median - 1:+.0%}"
        table.add_row(str(root), f"{times.median:.1f}", f"{times.least:.1f}", saved)
    Console().print(table)
    print(machine())
    ends = (0, JOINTS - 1)
    lines = [
        Line("two processes, median", [(r, t.median) for r, t in zip(ROOTS, two, strict=True)]),
        Line("two processes, least", [(r, t.least) for r, t in zip(ROOTS, two, strict=True)]),
        Line("one process, median", [(end, one.median) for end in ends], dashed=True),
        Line("one process, least", [(end, one.least) for end in ends], dashed=True),
    ]
    save_chart("fig4_measured", f"Fig. 4, measured: {machine()}", lines)


def table_2(*, run: bool = True) -> None:
    """Times of the three human figures on 1, 2 and 4 processes."""
    table = Table("DOF", "joints", "P", "root", "paper us", "saved", "predicted us", "saved")
    if run:
        table.add_column("measured us")
        table.add_column("saved")
    for dofs, printed in PRINTED.items():
        model = model_of(robots.human(dofs))
        topology = Topology.of(model)
        found = [find_schedule(topology, p, profile=PAPER, tie="lex") for p in (1, 2, 4)]
        times = measure([build(model, s) for s in found], 9, 200) if run else []
        for i, s in enumerate(found):
            row = [str(dofs), str(len(topology)), str(s.processes), topology.names[s.root.joint]]
            row += [f"{1e3 * printed[i]:.0f}", _saved(printed[i], printed[0])]
            row += [f"{s.makespan:.1f}", _saved(s.makespan, found[0].makespan)]
            if i < len(times):
                median = times[i].median
                about = "≈" if times[i].played else ""
                row += [f"{about}{median:.2f} ({times[i].least:.2f})"]
                row += [_saved(median, times[0].median)]
            table.add_row(*row)
    Console(width=120).print(table)
    if run:
        print(f"{machine()}; medians (least in brackets)")
        print("≈: more processes than cores; from measured stretches of computing, played through")


def _saved(time: float, one: float) -> str:
    return "" if time == one else f"{1 - time / one:.0%}"
