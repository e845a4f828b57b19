"""Pictures of the maps, and of all errors against the condition of H."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.errors import EnvironmentFault
from adagen.plan.digits import EPSILON
from adagen.studies.stability.emitted import Cell, digits
from adagen.studies.stability.maps import Map

Array = NDArray[np.float64]

_PANELS = (
    "composite bodies",
    "composite bodies, float",
    "articulated bodies, textbook",
    "form ada",
    "form segment",
    "form segment, refined once",
)
_LEAST, _MOST = 1e-17, 1e2  # smaller errors are drawn at the lower edge, failures at the upper one
_MARKERS = "os^vDP*X<>h"


def _figure(width: float, height: float) -> Any:
    """Return an empty figure of matplotlib, its size in inches.

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
    return Figure(figsize=(width, height), layout="constrained")


def _save(figure: Any, path: Path) -> None:
    metadata = {"Date": None} if path.suffix == ".svg" else None
    figure.savefig(path, dpi=110, metadata=metadata)


def draw_map(found: Map, path: Path) -> None:
    """Draw a map: green where digits are kept, red where none is left.

    Args:
        found: the map.
        path: where to, .svg or .png.

    Raises:
        EnvironmentFault: matplotlib is missing.
    """
    rows, columns = len(found.methods), len(found.values)
    figure = _figure(3.4 + 0.8 * columns, 1.3 + 0.36 * rows)
    axes = figure.add_subplot()
    words = [[f"{kept:.0f}" if kept >= 0.5 else "fails" for kept in row] for row in found.digits]
    image = _digits_table(axes, np.array(found.digits), words, size=9)
    axes.set_xticks(range(columns), [f"{value:g}" for value in found.values])
    axes.set_yticks(range(rows), found.methods)
    axes.set_xlabel(found.axis)
    axes.set_title(f"{found.family}: decimal digits kept", loc="left")
    figure.colorbar(image, label="digits")
    _save(figure, path)


def _digits_table(axes: Any, table: Array, words: Sequence[Sequence[str]], size: int) -> Any:
    """Draw digits as a table from red to green, with words in each cell; return its image."""
    for row, column in np.ndindex(table.shape):
        kept, text = table[row, column], words[row][column]
        colour = "white" if kept < 2 or kept > 14.5 else "black"
        axes.text(column, row, text, ha="center", va="center", fontsize=size, color=colour)
    return axes.imshow(table, cmap="RdYlGn", vmin=0, vmax=16, aspect="auto")


def draw_conditions(maps: Sequence[Map], path: Path) -> None:
    """Draw errors against cond(H) eps, a panel for each method, a marker for each family.

    Args:
        maps: of families of robots; those without conditions are left out.
        path: where to, .svg or .png.

    Raises:
        EnvironmentFault: matplotlib is missing.
    """
    shown = [found for found in maps if found.conditions]
    figure = _figure(11.5, 6.6)
    grid = figure.subplots(2, 3, sharey=True)
    for panel, method in zip(grid.flat, _PANELS, strict=True):
        epsilon = EPSILON["float" if "float" in method else "double"]
        for k, found in enumerate(shown):
            errors = found.errors[found.methods.index(method)]
            panel.loglog(
                np.array(found.conditions) * epsilon,
                np.clip(errors, _LEAST, _MOST),
                _MARKERS[k % len(_MARKERS)],
                color=f"C{k % 10}",
                ms=6,
                alpha=0.8,
                label=found.family,
            )
        ends = np.array(panel.get_xlim())
        panel.plot(ends, ends, color="black", lw=0.8, ls="--", scalex=False)
        panel.axhline(epsilon, color="black", lw=0.8, ls=":")
        panel.set_ylim(_LEAST / 3, _MOST * 3)
        panel.set_title(method, loc="left", fontsize=10)
        panel.grid(alpha=0.25)
    figure.supxlabel("cond(H) eps, eps being the rounding unit of the method's numbers")
    figure.supylabel("forward error in the energy norm")
    figure.suptitle("dashed: error = cond(H) eps; dotted: eps; failures at the upper edge")
    handles, names = grid.flat[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside right center", frameon=False)
    _save(figure, path)


def compared(found: Map) -> dict[str, object]:
    """Return what a picture against cond(H) shows of a family; an error is None for a failure."""
    errors = {name: found.errors[found.methods.index(name)] for name in _PANELS}
    return {
        "conditions": found.conditions,
        "errors": {
            name: [error if math.isfinite(error) else None for error in row]
            for name, row in errors.items()
        },
    }


def draw_study(cells: Sequence[Cell], path: Path) -> None:
    """Draw the digits that emitted solvers keep: a row for each variant, a column for each robot.

    Args:
        cells: of the study.
        path: where to, .svg or .png.

    Raises:
        EnvironmentFault: matplotlib is missing.
    """
    names = list(dict.fromkeys(cell.robot for cell in cells))
    shown = [cell for cell in cells if not cell.same]
    kinds = list(dict.fromkeys(cell.way for cell in shown if not cell.why))
    table = np.full((len(kinds), len(names)), np.nan)
    words = [[""] * len(names) for _ in kinds]
    for cell in shown:
        if cell.way not in kinds:
            continue
        row, column = kinds.index(cell.way), names.index(cell.robot)
        words[row][column] = _kept(cell)
        if not cell.why:
            table[row, column] = digits(cell.error, cell.way.scalar)
    figure = _figure(3.6 + 0.75 * max(len(names), 3), 2.2 + 0.3 * len(kinds))
    axes = figure.add_subplot()
    image = _digits_table(axes, table, words, size=8)
    axes.set_xticks(range(len(names)), names, rotation=35, ha="right")
    axes.set_yticks(range(len(kinds)), [way.words for way in kinds])
    title = "decimal digits kept by emitted solvers, in the worst state"
    figure.suptitle(title, x=0.01, ha="left", fontsize=11)  # from the figure's edge: it is narrow
    figure.colorbar(image, label="digits")
    _save(figure, path)


def _kept(cell: Cell) -> str:
    if cell.why:
        return "-"
    if cell.error is None:
        return "refused"
    kept = digits(cell.error, cell.way.scalar)
    return f"{kept:.0f}" if kept >= 0.5 else "wrong"
