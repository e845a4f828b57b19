"""A record as pictures: times as boxes, against joints, over processes, beside predictions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import cycle, product
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from adagen.studies.bench.contest import from_stretches
from adagen.studies.bench.record import ModelRecord, Record, Row

# Okabe and Ito's colours, distinct for everybody.
SERIES: dict[str, tuple[str, str]] = {
    "pinocchio": ("pinocchio ABA, best build", "#0072b2"),
    "mujoco": ("MuJoCo smooth dynamics", "#999999"),
    "casadi": ("casadi-generated ABA, best build", "#e69f00"),
    "adagen 1": ("adagen, one process", "#d55e00"),
    "adagen 2": ("adagen, two processes", "#009e73"),
    "adagen 4": ("adagen, four processes", "#cc79a7"),
}
STYLE: Any = {
    "font.size": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e4e4e4",
    "axes.axisbelow": True,
    "svg.hashsalt": "adagen",
}
PLACES = {
    "in_place": ("#009e73", "in place"),
    "through_root": ("#56b4e9", "through process 0"),
}
"""Colour and words for what is timed on several processes."""
MARKS = {2: "o", 4: "D"}
"""By number of processes; hollow where a time is from stretches."""
FORMS = "os^Dv"
"""Of the marks of solvers, in turn."""
PLAYED = "from stretches"
CHAIN = "chain"


def draw_all(record: Record, folder: Path, endings: Sequence[str] = ("svg",)) -> list[Path]:
    """Write every picture that the record has something for; return the files.

    Args:
        record: what was measured.
        folder: where they go, as bench_NAME.ENDING.
        endings: svg, png.
    """
    makers: dict[str, Callable[[Record], Figure | None]] = {
        "models": boxes,
        "chains": against_joints,
        "processes": over_processes,
        "prediction": beside_prediction,
    }
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    with mpl.rc_context(STYLE):
        for name, maker in makers.items():
            figure = maker(record)
            if figure is None:
                continue
            written += saved(figure, folder / f"bench_{name}", endings)
    return written


def saved(figure: Figure, stem: Path, endings: Sequence[str]) -> list[Path]:
    """Write a figure as files of some endings, the same bytes each time; return them."""
    paths = [stem.with_name(f"{stem.name}.{ending}") for ending in endings]
    for path in paths:
        metadata = {"Date": None} if path.suffix == ".svg" else None
        figure.savefig(path, metadata=metadata, dpi=110)
    return paths


def rows_of(model: ModelRecord) -> Iterator[tuple[str, Row]]:
    """Yield the best row of each series of SERIES that has one, states and results in place."""
    for key in SERIES:
        team, _, processes = key.partition(" ")
        row = model.timed(team, scalar="double", processes=int(processes or 1))
        if row is not None:
            yield key, row


def _label(key: str, rows: Iterable[Row]) -> str:
    """Return what a series is called, and whether its times are not the clock's."""
    return SERIES[key][0] + (f" ({PLAYED})" if any(row.played for row in rows) else "")


def _is_chain(model: ModelRecord) -> bool:
    return model.name.startswith(CHAIN) and model.name.removeprefix(CHAIN).isdigit()


def figure_of(
    machine: Mapping[str, Any], title: str, width: float, height: float
) -> tuple[Figure, Any]:
    """Return a figure with one axes, headed by a title and the machine."""
    figure = Figure(figsize=(width, height), layout="constrained")
    axes = figure.add_subplot()
    axes.set_title(title, loc="left", fontweight="bold", pad=19)
    where = f"{machine['processor']}, {machine['cores']} cores"
    axes.text(0, 1.0, where, transform=axes.transAxes, va="bottom", fontsize=8.5, color="#555555")
    return figure, axes


def microseconds(axis: Any) -> None:
    """Label a logarithmic axis of nanoseconds in plain microseconds."""
    axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter(FuncFormatter(lambda ns, _: f"{ns / 1e3:g}"))
    axis.set_minor_formatter(NullFormatter())


def logarithmic(axes: Any, ticks: Sequence[int]) -> None:
    """Make both axes logarithmic, with some numbers below."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xticks(ticks, [str(n) for n in ticks], minor=False)
    axes.xaxis.set_minor_formatter(NullFormatter())


def boxes(record: Record) -> Figure | None:
    """Return box plots of the rounds' medians, a group for each robot but chains."""
    timed = [m for m in record.models if any(rows_of(m))]
    models = [m for m in timed if not _is_chain(m)] or timed
    if not models:
        return None
    figure, axes = figure_of(record.machine, "Time of one evaluation", 9.5, 2.4 + 0.8 * len(models))
    pitch = 1.0 / (len(SERIES) + 1)
    shown: dict[str, list[Row]] = {}
    for place, model in enumerate(models):
        for key, row in rows_of(model):
            k = list(SERIES).index(key)
            _box(axes, row, place + (k - (len(SERIES) - 1) / 2) * pitch, pitch, SERIES[key][1])
            shown.setdefault(key, []).append(row)
    axes.set_xscale("log")
    turns = [ns for model in models for _, row in rows_of(model) for ns in row.turns]
    axes.set_xlim(min(turns) / 1.2, 1.5 * max(turns))  # with room for what is written beside
    axes.set_yticks(range(len(models)), [f"{m.name}\n{m.dofs} DOF" for m in models])
    axes.set_ylim(len(models) - 0.45, -0.55)
    for line in range(1, len(models)):
        axes.axhline(line - 0.5, color="#bbbbbb", linewidth=0.7)
    axes.grid(visible=False, axis="y")
    axes.set_xlabel("µs (boxes: medians of the rounds; whiskers: their range)")
    microseconds(axes.xaxis)
    for key in filter(shown.__contains__, SERIES):
        label = _label(key, shown[key])
        axes.plot([], [], color=SERIES[key][1], linewidth=6, label=label)
    figure.legend(loc="outside lower center", ncols=3, frameon=False, fontsize=9)
    return figure


def _box(axes: Any, row: Row, at: float, pitch: float, colour: str) -> None:
    """Draw one row's turns, with its median beside it in microseconds."""
    parts = axes.boxplot(
        [row.turns],
        positions=[at],
        orientation="horizontal",
        widths=0.8 * pitch,
        whis=(0, 100),
        patch_artist=True,
        manage_ticks=False,
    )
    for part in (*parts["boxes"], *parts["whiskers"], *parts["caps"]):
        part.set(color=colour, linewidth=1.6)
    parts["medians"][0].set(color="white", linewidth=1.2)
    text = f"{row.median / 1e3:.3g}"
    axes.text(max(row.turns) * 1.05, at, text, va="center", fontsize=7.5, color=colour)


def against_joints(record: Record) -> Figure | None:
    """Return time against joints on logarithmic axes: serial chains as lines."""
    chains = sorted(filter(_is_chain, record.models), key=lambda m: m.joints)
    if len(chains) < 2:
        return None
    figure, axes = figure_of(
        record.machine, "Serial chains: time of one evaluation against joints", 8, 5.2
    )
    for key, (_, colour) in SERIES.items():
        rows = [(m.joints, row) for m in chains if (row := dict(rows_of(m)).get(key))]
        if rows:
            points = [(joints, row.median) for joints, row in rows]
            label = _label(key, (row for _, row in rows))
            axes.plot(*zip(*points, strict=True), "o-", color=colour, label=label, markersize=4)
    logarithmic(axes, [m.joints for m in chains])
    microseconds(axes.yaxis)
    axes.set_xlabel("joints")
    axes.set_ylabel("µs")
    axes.legend(frameon=False, fontsize=9)
    return figure


def _by_robot(record: Record, title: str, models: Sequence[ModelRecord]) -> tuple[Figure, Any]:
    """Return a figure with a line for each robot, the first at the top."""
    figure, axes = figure_of(record.machine, title, 8.5, 2.4 + 0.36 * len(models))
    axes.set_yticks(range(len(models)), [f"{m.name}, {m.dofs} DOF" for m in models])
    axes.set_ylim(len(models) - 0.5, -0.5)
    return figure, axes


def over_processes(record: Record) -> Figure | None:
    """Return times on several processes, as shares of the best on one."""
    points: dict[tuple[int, str, bool], list[tuple[float, int]]] = {}
    shown: list[ModelRecord] = []
    for model in record.models:
        one = model.best("adagen", processes=1, scalar="double")
        many = {row.processes for row in model.rows} - {1}
        if one is None or not many:
            continue
        for processes, place in product(many, PLACES):
            for what in (place, from_stretches(place)):
                row = model.best("adagen", what, processes=processes, scalar="double")
                if row is not None:
                    share = 100 * row.median / one.median
                    key = processes, place, row.played
                    points.setdefault(key, []).append((share, len(shown)))
        shown.append(model)
    if not shown:
        return None
    figure, axes = _by_robot(record, "Several processes, against the best on one", shown)
    axes.axvline(100, color=SERIES["adagen 1"][1], linewidth=1.2, label="P=1")
    for (processes, place, played), some in sorted(points.items()):
        colour, label = PLACES[place]
        label = f"P={processes}, {label}" + (f", {PLAYED}" if played else "")
        face, mark = "none" if played else colour, MARKS.get(processes, "s")
        axes.plot(*zip(*some, strict=True), mark, color=colour, mfc=face, label=label, markersize=7)
    axes.set_xlim(left=0)
    axes.set_xlabel("time, % of the best on one process (median)")
    figure.legend(loc="outside lower center", ncols=2, frameon=False, fontsize=9)
    return figure


def _beside(model: ModelRecord, row: Row) -> bool:
    """Whether a row is in place, by the clock, or from stretches where it has no time by that."""
    clocked = any(other.name == row.name and not other.played for other in model.rows)
    return row.what == ("in_place" if clocked else from_stretches("in_place"))


def beside_prediction(record: Record) -> Figure | None:
    """Return measured times, as shares of what the cost profile predicts."""
    points: dict[tuple[int, str], list[tuple[float, int, bool]]] = {}
    shown: list[ModelRecord] = []
    for model in record.models:
        rows = [row for row in model.rows if row.scalar == "double" and _beside(model, row)]
        predicted = [(row, row.predicted) for row in rows if row.predicted]
        for row, ns in predicted:
            point = 100 * row.median / ns, len(shown), row.played
            points.setdefault((row.processes, row.name), []).append(point)
        if predicted:
            shown.append(model)
    if not shown:
        return None
    figure, axes = _by_robot(record, "Measured, against what the cost profile predicts", shown)
    axes.axvline(100, color="#555555", linewidth=1, label="as predicted")
    for ((processes, name), some), mark in zip(sorted(points.items()), cycle(FORMS), strict=False):
        _, colour = SERIES.get(f"adagen {processes}", ("", "#999999"))
        shares, places, played = zip(*some, strict=True)
        label = name.removeprefix("adagen ") + (f", {PLAYED}" if any(played) else "")
        face = "none" if all(played) else colour
        axes.plot(shares, places, mark, color=colour, mfc=face, label=label, markersize=7)
    axes.set_xlabel("time, % of the predicted one (median)")
    figure.legend(loc="outside lower center", ncols=3, frameon=False, fontsize=9)
    return figure
