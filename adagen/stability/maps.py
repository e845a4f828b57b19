"""Maps: digits that each method keeps along a family of robots, as data and as a picture."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from adagen.errors import EnvironmentFault
from adagen.stability.methods import METHODS, Trial, digits
from adagen.stability.motion import swing
from adagen.stability.robots import FAMILIES

STEPS = (1e-5, 2e-5, 5e-5, 1e-4, 1e-3, 1e-2)  # each goes into 20 ms
_STEP_METHODS = ("explicit damping", "RK4", "implicit damping")
_WORDS = {"explicit damping": "explicit", "RK4": "rk4", "implicit damping": "implicit"}
_COMPARED = tuple(name for name in METHODS if name != "form ada, joints not fused")
NAMES = (*FAMILIES, "step")


@dataclass(frozen=True)
class Map:
    """Digits kept, 0 to 16.

    Attributes:
        family: its name.
        axis: what varies, with its unit.
        values: of that.
        methods: names.
        digits: a row for each method, a column for each value.
    """

    family: str
    axis: str
    values: tuple[float, ...]
    methods: tuple[str, ...]
    digits: tuple[tuple[float, ...], ...]


def make_map(family: str, progress: Callable[[str], None] = lambda _: None) -> Map:
    """Return the map of a family, one of ``NAMES``.

    Args:
        family: its name.
        progress: is told what is being worked at.
    """
    if family == "step":
        return _step_map(progress)
    axis, robot, values = FAMILIES[family]
    columns = []
    for value in values:
        progress(f"{family} {value:g}")
        trial = Trial(robot(value))
        columns.append([digits(trial.outcome(METHODS[name])[0]) for name in _COMPARED])
    rows = tuple(tuple(row) for row in zip(*columns, strict=True))
    return Map(family, axis, values, _COMPARED, rows)


def _step_map(progress: Callable[[str], None]) -> Map:
    """Digits of the velocities of the damped chain after 20 ms."""
    progress("step: reference")
    truth = swing(5e-6, "rk4")
    rows = []
    for method in _STEP_METHODS:
        progress(f"step: {method}")
        errors = [np.abs(swing(h, _WORDS[method]) - truth).max() for h in STEPS]
        rows.append(tuple(digits(float(e / np.abs(truth).max())) for e in errors))
    return Map(
        "step",
        "step (s); the tip's damping allows 2/lambda = 6.7e-5",
        STEPS,
        _STEP_METHODS,
        tuple(rows),
    )


def draw_map(found: Map, path: Path) -> None:
    """Draw a map: green where digits are kept, red where none is left.

    Args:
        found: the map.
        path: where to, .svg or .png.

    Raises:
        EnvironmentFault: matplotlib is missing.
    """
    try:
        import matplotlib as mpl
        from matplotlib.figure import Figure
    except ImportError:
        raise EnvironmentFault(
            "drawing needs matplotlib; install adagen[chart], or leave --map out"
        ) from None
    mpl.rcParams["svg.hashsalt"] = "adagen"
    mpl.rcParams["svg.fonttype"] = "none"
    rows, columns = len(found.methods), len(found.values)
    figure = Figure(figsize=(3.4 + 0.8 * columns, 1.3 + 0.36 * rows), layout="constrained")
    axes = figure.add_subplot()
    table = np.array(found.digits)
    image = axes.imshow(table, cmap="RdYlGn", vmin=0, vmax=16, aspect="auto")
    axes.set_xticks(range(columns), [f"{value:g}" for value in found.values])
    axes.set_yticks(range(rows), found.methods)
    axes.set_xlabel(found.axis)
    axes.set_title(f"{found.family}: decimal digits kept", loc="left")
    for row in range(rows):
        for column in range(columns):
            kept = table[row, column]
            text = f"{kept:.0f}" if kept >= 0.5 else "fails"
            colour = "white" if kept < 2 or kept > 14.5 else "black"
            axes.text(column, row, text, ha="center", va="center", fontsize=9, color=colour)
    figure.colorbar(image, label="digits")
    metadata = {"Date": None} if path.suffix == ".svg" else None
    figure.savefig(path, dpi=110, metadata=metadata)
