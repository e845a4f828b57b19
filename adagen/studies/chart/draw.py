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
from adagen.studies.chart.variants import METHODS

COLOURS = {
    "straight": "#0072b2",
    "loops": "#d55e00",
    "batches": "#009e73",
    "reproducible": "#56b4e9",
    "joints": "#cc79a7",
    "articulated": "#777777",
    "composite": "#b09000",
}
_PEER_COLOURS = ("#7b3294", "#a6611a", "#1b7837", "#e69f00")
_MARKERS = ("o", "^", "D", "v", "P")  # by steps of refinement
_CERTIFIED = "s"
_FACES = {"float": ("white", "hollow")}
_STEPS = ((1.8, (1.0, 2.0, 5.0)), (3.2, (1.0, 3.0)))  # decades of an axis, and where labels are
_LEAST = 1e-17  # errors below are drawn here
_LINES = 14  # below the panel; the record has them all
_TITLE, _PANEL, _GAP, _LINE, _LEGEND = 0.6, 5.6, 0.55, 0.155, 0.55  # heights in inches
_NEAR, _AROUND = (13.0, 22.0, 32.0, 44.0), 12  # where a number may stand: points away, directions


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
    """Return the figure: forward error against time, a line for each method.

    Below stand, in words, the front of what adagen emits and why some have no answer or no time.
    """
    words = [_pareto(chart), _failures(chart)]
    below = _LINE * max(text.count("\n") + 2 for text in words)
    height = _TITLE + _PANEL + _GAP + below + _LEGEND
    figure = pyplot().figure(figsize=(12, height))
    grid = figure.add_gridspec(
        2, 2, height_ratios=(_PANEL, below), hspace=2 * _GAP / (_PANEL + below), left=0.08,
        right=0.88, top=1 - _TITLE / height, bottom=_LEGEND / height, width_ratios=(3, 2),
    )  # fmt: skip
    axes = figure.add_subplot(grid[0, :])
    colours = _colours(chart.points)
    _panel(axes, chart, colours)
    axes.set_ylabel(
        f"largest forward error over {chart.states} states, " r"$\sqrt{e^T H e\,/\,t^T H t}$"
    )
    figure.suptitle(
        f"{chart.model}, {chart.dof} degrees of freedom: error against time on {chart.machine}\n"
        f"truth to {chart.digits} digits; medians over {chart.rounds} rounds, by turns",
        y=1.0,
    )
    for k, text in enumerate(words):
        words_axes = figure.add_subplot(grid[1, k])
        words_axes.axis("off")
        words_axes.text(0, 1, text, fontsize=8, va="top", transform=words_axes.transAxes)
    figure.legend(
        handles=_handles(chart, colours), loc="lower center", ncols=5, fontsize=8, frameon=False
    )
    return figure


def _colours(points: Sequence[Point]) -> dict[str, str]:
    peers = sorted({p.method for p in points} - set(COLOURS) - {""})
    more = {name: _PEER_COLOURS[k % len(_PEER_COLOURS)] for k, name in enumerate(peers)}
    shown = {p.method for p in points if _drawn(p)}
    return {name: colour for name, colour in (COLOURS | more).items() if name in shown}


def _drawn(point: Point) -> bool:
    """Whether a point has a place in the panel; the others are listed below."""
    return not point.failed and point.time_ns is not None


def _panel(axes: Any, chart: Chart, colours: dict[str, str]) -> None:
    """Draw errors against times; the axes go as far as they do."""
    shown = [p for p in chart.points if _drawn(p)]
    axes.set(xscale="log", yscale="log", xlabel="ns per evaluation")
    times = [p.time_ns or 0.0 for p in shown] or [1e3]
    errors = [_height(p) for p in shown] or [1e-16]
    axes.set_xlim(min(times) / 1.25, max(times) * 1.25)
    axes.set_ylim(min(errors) / 8, max(errors) * 5)
    axes.grid(alpha=0.25, which="major")
    label_steps(axes)
    for name, colour in colours.items():
        _line(axes, [p for p in shown if p.method == name], colour)
    _guides(axes, chart)
    _staircase(axes, chart)
    _number(axes, chart)


def _line(axes: Any, points: Sequence[Point], colour: str) -> None:
    """Draw the points of a method, those that none of them beats joined by a line."""
    least, best = math.inf, []
    for point in sorted(points, key=lambda p: (p.time_ns or 0.0, _height(p))):
        if _height(point) < least and point.source != "stretches":
            least = _height(point)
            best.append(point)
    axes.plot(
        [p.time_ns for p in best], [_height(p) for p in best], color=colour, lw=1.4, alpha=0.7
    )
    for point in points:
        marker = _CERTIFIED if point.certify else _refined(point.refine)
        face = _FACES[point.scalar][0] if point.scalar in _FACES else colour
        x, y = point.time_ns, _height(point)
        axes.plot(x, y, marker, color=colour, mfc=face, ms=7 if point.front else 5.5, alpha=0.9)
        if point.source == "stretches":
            axes.plot(x, y, "o", color=colour, mfc="none", ms=11, mew=0.8, alpha=0.7)


def _refined(steps: int) -> str:
    """Return the marker of so many steps of refinement."""
    return _MARKERS[min(steps, len(_MARKERS) - 1)]


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


def _height(point: Point) -> float:
    return max(point.error or 0.0, _LEAST)


def _guides(axes: Any, chart: Chart) -> None:
    """Draw the rounding of each scalar, and what joining is predicted to lose, where in sight."""
    found = []
    for scalar in sorted({p.scalar for p in chart.points} & set(EPSILON)):
        found.append((EPSILON[scalar], f"rounding of\n{scalar}"))
        found += [
            (p.predicted, f"predicted:\n{scalar}, joints")
            for p in chart.points
            if p.predicted and p.method == "joints" and p.schedule == "auto"
            if p.scalar == scalar and p.processes == 1 and not p.refine
        ][:1]
    low, high = axes.get_ylim()
    found = sorted(each for each in found if low < each[0] < high)
    tall = math.log10(high / low)
    least = -1.0
    for height, text in found:
        axes.axhline(height, color="black", lw=0.7, ls="--", alpha=0.5)
        at = max(math.log10(height / low) / tall, least)  # of the axis, above the label below
        least = at + _OF_LABEL
        axes.text(1.01, at, text, fontsize=7, alpha=0.8, va="center", transform=axes.transAxes)


_OF_LABEL = 0.06  # height of two lines of text in the panel


def _on_front(chart: Chart) -> list[Point]:
    return sorted((p for p in chart.points if p.front), key=lambda p: p.time_ns or 0.0)


def _staircase(axes: Any, chart: Chart) -> None:
    """Join what adagen emits and nothing beats by a staircase."""
    on = _on_front(chart)
    xs, ys = [p.time_ns for p in on], [_height(p) for p in on]
    axes.step(xs, ys, where="post", color="black", lw=1.1, alpha=0.5, zorder=0)


def _number(axes: Any, chart: Chart) -> None:
    """Number the front as in the list below, each number where it covers nothing."""
    from matplotlib.transforms import Bbox

    pixels = axes.figure.dpi / 72

    def box(at: Sequence[float], wide: float, high: float) -> Any:
        (x, y), half = at, (wide * pixels / 2, high * pixels / 2)
        return Bbox.from_extents(x - half[0], y - half[1], x + half[0], y + half[1])

    def spot(point: Point) -> Sequence[float]:
        found: Sequence[float] = axes.transData.transform((point.time_ns, _height(point)))
        return found

    taken = [box(spot(p), 9, 9) for p in chart.points if _drawn(p)]
    turns = [2 * math.pi * (k / _AROUND + 0.625) for k in range(_AROUND)]  # first below, left
    places = [(r * math.cos(turn), r * math.sin(turn)) for r in _NEAR for turn in turns]
    for k, point in enumerate(_on_front(chart), start=1):
        x, y = spot(point)
        for place in places:
            own = box((x + place[0] * pixels, y + place[1] * pixels), 7.0 * len(str(k)) + 2, 11)
            inside = axes.bbox.contains(*own.min) and axes.bbox.contains(*own.max)
            if inside and not any(own.overlaps(other) for other in taken):
                break
        else:
            continue  # there is no room; the list has it
        taken.append(own)
        axes.annotate(
            str(k), (point.time_ns, _height(point)), fontsize=8, weight="bold", ha="center",
            va="center", xytext=place, textcoords="offset points",
            arrowprops={"arrowstyle": "-", "lw": 0.5, "alpha": 0.6},
        )  # fmt: skip


def _pareto(chart: Chart) -> str:
    """Return the points that nothing beats, in words."""
    lines = ["Front of what adagen emits, one state at a time (time, ratio to the default, error):"]
    for k, point in enumerate(_on_front(chart), start=1):
        ratio = "" if point.ratio is None else f", {point.ratio:.2f}x"
        error = f"{_height(point):.1e}"
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
    """Return the entries of the legend."""
    from matplotlib.lines import Line2D

    def handle(marker: str, colour: str, face: str, text: str, line: str = "") -> Any:
        return Line2D([], [], marker=marker, color=colour, mfc=face, ls=line, label=text)

    shown = [p for p in chart.points if _drawn(p)]
    rows = [handle("o", c, c, METHODS.get(name, name), "-") for name, c in colours.items()]
    for scalar, (face, look) in _FACES.items():
        if any(p.scalar == scalar for p in shown):
            rows.append(handle("o", "black", face, f"{scalar} ({look})"))
    for n in sorted({p.refine for p in shown if p.refine}):
        times = {1: "once", 2: "twice"}.get(n, f"{n} times")
        rows.append(handle(_refined(n), "black", "black", f"refined {times}"))
    if any(p.certify for p in shown):
        rows.append(handle(_CERTIFIED, "black", "black", "certified"))
    if any(p.source == "stretches" for p in shown):
        ring = handle(
            "o", "black", "none", "ringed: time from measured stretches (more processes than cores)"
        )
        ring.set_markersize(11)
        rows.append(ring)
    return rows
