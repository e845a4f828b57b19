"""Pictures of how far solvers scale: time against joints, and batches against processes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.figure import Figure

from adagen.studies.bench.pictures import SERIES, STYLE, figure_of, logarithmic, microseconds, saved
from adagen.studies.bench.scale_record import CLOCK, PREDICTED, STRETCHES, BatchRow, Scale

COLOURS = ("#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#333333", "#999999")
"""Of P = 1, 2, 4, ... in turn; those of SERIES as far as it has them."""
PLACES = {"in_place": ("o", "each process its own"), "distributed": ("D", "distributed")}


def draw_scale(scale: Scale, folder: Path, endings: Sequence[str] = ("svg",)) -> list[Path]:
    """Write the pictures that a record has something for; return the files.

    Args:
        scale: what was measured.
        folder: where they go, as scale_NAME.ENDING.
        endings: svg, png.
    """
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    with mpl.rc_context(STYLE):
        if len(scale.joints) > 1:
            written += saved(against_joints(scale), folder / "scale_joints", endings)
        if scale.batches:
            written += saved(of_batches(scale), folder / "scale_batches", endings)
    return written


def against_joints(scale: Scale) -> Figure:
    """Return time against joints, a line for each number of processes, with the ideal ones.

    The ideal line of P processes is the time on one process divided by P.
    """
    title = "Chains: time of one evaluation against joints"
    figure, axes = figure_of(scale.machine, title, 8, 5.6)
    alone = {n: row.least for n in scale.joints if (row := scale.row(n, 1)) is not None}
    for processes, colour in zip(scale.processes, COLOURS, strict=False):
        rows = [row for n in scale.joints if (row := scale.row(n, processes)) is not None]
        played = any(row.source == STRETCHES for row in rows)
        _line(
            axes,
            [(row.joints, row.least) for row in rows],
            f"adagen P={processes}" + (" (from stretches)" if played else ""),
            colour,
            "none" if played else colour,
        )
        if processes > 1:
            points = [(n, time / processes) for n, time in alone.items()]
            (line,) = axes.plot(*zip(*points, strict=True), ":", color=colour, linewidth=1)
            line.set_gid(f"ideal P={processes}")
    peers = [(n, row.least) for n in scale.joints if (row := scale.peer(n)) is not None]
    if peers:
        label, colour = SERIES["pinocchio"]
        _line(axes, peers, label, colour, colour)
    axes.plot([], [], ":", color="#555555", linewidth=1, label="ideal: P=1 divided by P")
    logarithmic(axes, scale.joints)
    microseconds(axes.yaxis)
    axes.set_xlabel("joints")
    axes.set_ylabel("µs (fastest evaluation)")
    axes.legend(frameon=False, fontsize=9)
    return figure


def of_batches(scale: Scale) -> Figure:
    """Return states per second against processes: measured here, predicted on hosts."""
    title = f"Batches of {scale.robot}: states per second"
    figure, axes = figure_of(scale.machine, title, 8, 5.2)
    for source, colour in ((CLOCK, "#d55e00"), (PREDICTED, "#0072b2")):
        rows = [row for row in scale.batches if row.source == source]
        if not rows:
            continue
        for what, (mark, words) in PLACES.items():
            points = [(row.processes, getattr(row, what)) for row in rows]
            label = f"{words}, {'measured' if source == CLOCK else 'predicted'}"
            _line(axes, points, label, colour, colour if what == "in_place" else "none", mark)
        ideal = [(row.processes, row.processes * _each(rows[0])) for row in rows]
        (line,) = axes.plot(*zip(*ideal, strict=True), ":", color=colour, linewidth=1)
        line.set_gid(f"ideal {source}")
    for row in scale.batches:
        if row.source == PREDICTED:
            words = f"{row.hosts} host{'s' if row.hosts > 1 else ''}"
            place = row.processes, row.distributed
            axes.annotate(words, place, (0, -12), textcoords="offset points", fontsize=7.5)
    logarithmic(axes, sorted({row.processes for row in scale.batches}))
    axes.set_xlabel("processes")
    axes.set_ylabel("states per second")
    axes.legend(frameon=False, fontsize=9)
    return figure


def _each(row: BatchRow) -> float:
    """Return the states per second of one of a row's processes."""
    return row.in_place / row.processes


def _line(
    axes: Any,
    points: Sequence[tuple[int, float]],
    label: str,
    colour: str,
    face: str,
    mark: str = "o",
) -> None:
    """Draw a line that the file calls by its label."""
    form = f"{mark}-"
    (line,) = axes.plot(
        *zip(*points, strict=True), form, color=colour, mfc=face, label=label, markersize=4.5
    )
    line.set_gid(label)
