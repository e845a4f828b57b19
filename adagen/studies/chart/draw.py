"""Work-precision diagrams as pictures."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from adagen.errors import EnvironmentFault
from adagen.plan.digits import EPSILON
from adagen.studies.chart.record import Chart, Point
from adagen.studies.chart.variants import NAMES

COLOURS = {
    "segment": "#0072b2",
    "ada": "#d55e00",
    "aba": "#999999",
    "aba_exact": "#555555",
    "crba": "#cc79a7",
}
_PEER_COLOURS = ("#009e73", "#56b4e9", "#e69f00", "#b09000")
_MARKERS = ("o", "^", "D", "v", "P")  # by steps of refinement
_FACES = {"float": ("white", "hollow"), "mixed": ("0.8", "grey inside")}
_CLOSE = 0.05  # of an axis: two numbers so near each other cannot be told apart
_STEPS = ((1.8, (1.0, 2.0, 5.0)), (3.2, (1.0, 3.0)))  # decades of an axis, and where labels are
_LEAST = 1e-17  # errors below are drawn here
_LINES = 11  # below the panels; the data has them all
_TITLE, _PANELS, _GAP, _LINE, _LEGEND = 0.6, 5.2, 0.55, 0.155, 0.3  # heights in inches


def pyplot() -> Any:
    """Return matplotlib's pyplot, drawing to files alone.

    Raises:
        EnvironmentFault: it is not installed.
    """
    try:
        import matplotlib as mpl
    except ImportError:
        raise EnvironmentFault(
            "charts are drawn by matplotlib, which is not installed: pip install 'adagen[chart]' "
            "(--no-picture does without)"
        ) from None
    mpl.use("Agg")
    from matplotlib import pyplot as plt

    plt.rcParams.update({"svg.hashsalt": "adagen", "font.size": 9, "svg.fonttype": "path"})
    return plt


def save(figure: Any, path: Path) -> list[Path]:
    """Write a figure as SVG and PNG beside each other; return both paths.

    Args:
        figure: matplotlib's.
        path: without ending.

    Raises:
        EnvironmentFault: writing failed.
    """
    paths = [path.with_name(f"{path.name}{ending}") for ending in (".svg", ".png")]
    try:
        figure.savefig(paths[0], metadata={"Date": None}, bbox_inches="tight")
        figure.savefig(paths[1], dpi=150, bbox_inches="tight")
    except OSError as error:
        raise EnvironmentFault(f"cannot write the picture: {error.strerror}") from None
    finally:
        pyplot().close(figure)
    return paths


def work_precision(chart: Chart) -> Any:
    """Return the figure: forward error and torque residual, each against time.

    Below stand, in words, the Pareto front and why some have no answer or no time.
    """
    words = [_pareto(chart), _failures(chart)]
    below = _LINE * max(text.count("\n") + 2 for text in words)
    height = _TITLE + _PANELS + _GAP + below + _LEGEND
    figure = pyplot().figure(figsize=(13, height))
    grid = figure.add_gridspec(
        2, 2, height_ratios=(_PANELS, below), hspace=2 * _GAP / (_PANELS + below),
        top=1 - _TITLE / height, bottom=_LEGEND / height, width_ratios=(3, 2), wspace=0.27,
    )  # fmt: skip
    left = figure.add_subplot(grid[0, 0])
    right = figure.add_subplot(grid[0, 1], sharex=left)
    colours = _colours(chart.points)
    _panel(left, chart, "error", colours)
    _panel(right, chart, "residual", colours)
    _guides(left, chart)
    left.set_ylabel(
        f"largest forward error over {chart.states} states, " r"$\sqrt{e^T H e\,/\,t^T H t}$"
    )
    right.set_ylabel("largest torque residual")
    figure.suptitle(
        f"{chart.model}, {chart.dof} degrees of freedom: error against time on {chart.machine}\n"
        f"truth to {chart.digits} digits; medians over {chart.rounds} rounds, by turns",
        y=1.0,
    )
    _staircase(left, chart)
    for k, text in enumerate(words):
        words_axes = figure.add_subplot(grid[1, k])
        words_axes.axis("off")
        words_axes.text(0, 1, text, fontsize=8, va="top", transform=words_axes.transAxes)
    figure.legend(
        handles=_handles(chart, colours), loc="lower center", ncols=6, fontsize=8, frameon=False
    )
    return figure


def _colours(points: Sequence[Point]) -> dict[str, str]:
    peers = sorted({p.algorithm for p in points} - set(COLOURS))
    more = {name: _PEER_COLOURS[k % len(_PEER_COLOURS)] for k, name in enumerate(peers)}
    return {
        name: c for name, c in (COLOURS | more).items() if any(p.algorithm == name for p in points)
    }


def _panel(axes: Any, chart: Chart, what: str, colours: dict[str, str]) -> None:
    """Draw one kind of error against time."""
    times = [p.time_ns for p in chart.points if p.time_ns is not None] or [1e3]
    right = max(times) * 2.2  # where points without a time go
    values = [_height(p, what) for p in chart.points if not p.failed]
    failed = any(p.failed for p in chart.points)
    top = max([*values, 1e-6]) * (1e4 if failed else 4)  # where points without an answer go
    least = min([*values, 1e-16])
    axes.set(xscale="log", yscale="log", ylim=(least / 300, top * 6), xlabel="ns per evaluation")
    untimed = any(p.time_ns is None for p in chart.points)
    axes.set_xlim(min(times) / 1.5, right * 1.5 if untimed else max(times) * 1.5)
    axes.grid(alpha=0.25, which="major")
    label_steps(axes)
    if untimed:
        axes.axvline(right / 1.4, color="black", lw=0.6, ls=":")
        axes.text(right, least / 200, "not\ntimed", ha="center", va="bottom", fontsize=7)
    for point in chart.points:
        x = right if point.time_ns is None else point.time_ns
        y = top if point.failed else _height(point, what)
        _mark(axes, point, x, y, colours[point.algorithm])
    if failed:
        axes.axhline(top / 4, color="black", lw=0.6, ls=":")
        axes.text(0.01, top * 1.3, "no answer", fontsize=7, va="center",
                  transform=axes.get_yaxis_transform())  # fmt: skip


def label_steps(axes: Any) -> None:
    """Label a panel's logarithmic x axis in plain numbers, as many as there is room for.

    That is at 1, 2 and 5 times the powers of ten, at 1 and 3 times, or at these alone.
    """
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    low, high = axes.get_xlim()
    decades = math.log10(high / low)
    subs = next((subs for most, subs in _STEPS if decades <= most), (1.0,))
    axes.xaxis.set_major_locator(LogLocator(subs=subs))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:.10g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.tick_params(axis="x", labelsize=7)


def _height(point: Point, what: str) -> float:
    value = point.error if what == "error" else point.residual
    return max(value or 0.0, _LEAST)


def _mark(axes: Any, point: Point, x: float, y: float, colour: str) -> None:
    marker = "x" if point.failed else _MARKERS[min(point.refine, len(_MARKERS) - 1)]
    face = _FACES[point.scalar][0] if point.scalar in _FACES and not point.failed else colour
    axes.plot(x, y, marker, color=colour, mfc=face, ms=7 if point.front else 5.5, alpha=0.85)
    if point.source == "stretches":
        axes.plot(x, y, "o", color=colour, mfc="none", ms=11, mew=0.8, alpha=0.7)
    if point.processes > 1 and not point.failed:
        up = 2.5 if point.processes == 2 else -7  # what takes as long on more stays legible
        axes.annotate(str(point.processes), (x, y), fontsize=6, xytext=(3.5, up),
                      textcoords="offset points", color=colour)  # fmt: skip


def _guides(axes: Any, chart: Chart) -> None:
    """Draw the rounding of each scalar, and what the joins of form ada are predicted to lose."""
    for scalar in sorted({p.scalar for p in chart.points} - {"mixed"}):
        lines = [(EPSILON[scalar], f"eps,\n{scalar}")]
        grown = [
            p.predicted
            for p in chart.points
            if p.predicted and p.algorithm == "ada" and p.schedule == "auto"
            if p.scalar == scalar and p.processes == 1
        ]
        lines += [(grown[0], f"eps Σg, ada,\n{scalar}")] if grown else []
        for height, text in lines:
            axes.axhline(height, color="black", lw=0.7, ls="--", alpha=0.5)
            axes.text(1.01, height, text, fontsize=7, alpha=0.8, va="center",
                      transform=axes.get_yaxis_transform())  # fmt: skip


def _on_front(chart: Chart) -> list[Point]:
    return sorted((p for p in chart.points if p.front), key=lambda p: p.time_ns or 0.0)


def _staircase(axes: Any, chart: Chart) -> None:
    """Join the points that nothing beats by a staircase, numbered as in the list below."""
    on = _on_front(chart)
    xs = [p.time_ns for p in on if p.time_ns is not None]  # all of them have one
    ys = [_height(p, "error") for p in on]
    axes.step(xs, ys, where="post", color="black", lw=1.1, alpha=0.6, zorder=0)
    for first, last in _close_together(axes, xs, ys):
        text = f"{first + 1}" if first == last else f"{first + 1}-{last + 1}"
        axes.annotate(text, (xs[first], ys[last]), fontsize=8, weight="bold", xytext=(-4, -16),
                      textcoords="offset points")  # fmt: skip


def _close_together(axes: Any, xs: Sequence[float], ys: Sequence[float]) -> list[tuple[int, int]]:
    """Return the first and the last of each run of points that one number must stand for."""
    spans = [abs(math.log10(high / low)) for low, high in (axes.get_xlim(), axes.get_ylim())]
    runs: list[tuple[int, int]] = []
    for k, point in enumerate(zip(xs, ys, strict=True)):
        first = runs[-1][0] if runs else 0
        apart = [
            abs(math.log10(a / b)) / span
            for a, b, span in zip(point, (xs[first], ys[first]), spans, strict=True)
        ]
        if runs and max(apart) < _CLOSE:
            runs[-1] = first, k
        else:
            runs.append((k, k))
    return runs


def _pareto(chart: Chart) -> str:
    """Return the points that nothing beats, in words."""
    lines = ["Pareto front (time, ratio to the serial articulated-body solver, error):"]
    for k, point in enumerate(_on_front(chart), start=1):
        ratio = "" if point.ratio is None else f", {point.ratio:.2f}x"
        error = f"{_height(point, 'error'):.1e}"
        lines.append(f"{k}  {point.label}: {point.time_ns:.0f} ns{ratio}, {error}")
    return _shortened(lines) if len(lines) > 1 else ""


def _failures(chart: Chart) -> str:
    """Return who has no answer or no time and why, each reason once."""
    lines: list[str] = []
    for title, failed in (("No answer:", True), ("Not timed:", False)):
        reasons: dict[str, list[str]] = {}
        for point in chart.points:
            if point.failed == failed and (failed or point.why):
                reasons.setdefault(point.why or "unknown", []).append(point.label)
        lines += [title] if reasons else []
        for why, names in reasons.items():
            more = f" and {len(names) - 1} more" if len(names) > 1 else ""
            lines += textwrap.wrap(f"{names[0]}{more}: {why}", 78, subsequent_indent="   ")
    return _shortened(lines)


def _shortened(lines: list[str]) -> str:
    """Return as many lines as there is room for."""
    if len(lines) > _LINES:
        lines = [*lines[: _LINES - 1], "... (all of them are in the data)"]
    return "\n".join(lines)


def _handles(chart: Chart, colours: dict[str, str]) -> list[Any]:
    """Return what the legend holds."""
    from matplotlib.lines import Line2D

    def handle(marker: str, colour: str, face: str, text: str) -> Any:
        return Line2D([], [], marker=marker, color=colour, mfc=face, ls="", label=text)

    rows = [handle("o", c, c, NAMES.get(name, name)) for name, c in colours.items()]
    for scalar, (face, look) in _FACES.items():
        if any(p.scalar == scalar for p in chart.points):
            rows.append(handle("o", "black", face, f"{scalar} ({look})"))
    for n in sorted({p.refine for p in chart.points if p.refine}):
        rows.append(handle(_MARKERS[min(n, len(_MARKERS) - 1)], "black", "black", f"refined {n}x"))
    if any(p.source == "stretches" for p in chart.points):
        ring = handle("o", "black", "none", "ringed: time from measured stretches (P > cores)")
        ring.set_markersize(11)
        rows.append(ring)
    if any(p.processes > 1 for p in chart.points):
        rows.append(handle("$2$", "black", "black", "processes (1 if none)"))
    return rows
