"""Fig. 4 and Table II: what the model predicts, and what this machine takes."""

from __future__ import annotations

from rich.console import Console
from rich.table import Table

from adagen.schedule import Schedule, Topology, load_profile
from adagen.schedule.tree_draft import Draft
from adagen.search import find_schedule, named_schedule
from adagen.search.named import as_schedule
from benchmarks.paper import robots
from benchmarks.paper.measured import build, machine, measure, model_of, played
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
    single = build("one", model, named_schedule("sequential", topology, 1, profile=PAPER))
    two = [build(f"root {root}", model, rooted(topology, root)) for root in ROOTS]
    programs = [single, *two]
    one, *both = ((t.median / 1e3, t.least / 1e3) for t in measure(programs))
    table = Table("root", "median us", "least us", "against one process")
    table.add_row("one process", f"{one[0]:.1f}", f"{one[1]:.1f}", "")
    for root, (median, least) in zip(ROOTS, both, strict=True):
        table.add_row(str(root), f"{median:.1f}", f"{least:.1f}", f"{median / one[0] - 1:+.0%}")
    Console().print(table)
    print(machine())
    ends = (0, JOINTS - 1)
    lines = [
        *(
            Line(f"two processes, {what}", [(r, t[k]) for r, t in zip(ROOTS, both, strict=True)])
            for k, what in enumerate(("median", "least"))
        ),
        *(
            Line(f"one process, {what}", [(end, one[k]) for end in ends], dashed=True)
            for k, what in enumerate(("median", "least"))
        ),
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
        built = [build(f"P={s.processes}", model, s) for s in found] if run else []
        times = measure(built, 9, 200)
        for i, s in enumerate(found):
            row = [str(dofs), str(len(topology)), str(s.processes), topology.names[s.root.joint]]
            row += [f"{1e3 * printed[i]:.0f}", _saved(printed[i], printed[0])]
            row += [f"{s.makespan:.1f}", _saved(s.makespan, found[0].makespan)]
            if i < len(times):
                about = "≈" if played(built[i]) else ""
                row += [f"{about}{times[i].median / 1e3:.2f} ({times[i].least / 1e3:.2f})"]
                row += [_saved(times[i].median, times[0].median)]
            table.add_row(*row)
    Console(width=120).print(table)
    if run:
        print(f"{machine()}; medians (least in brackets)")
        print("≈: more processes than cores; from measured stretches of computing, played through")


def _saved(time: float, one: float) -> str:
    return "" if time == one else f"{1 - time / one:.0%}"
