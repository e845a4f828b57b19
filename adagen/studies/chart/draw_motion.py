"""Charts of integrators as pictures."""

from __future__ import annotations

import math
from typing import Any

from adagen.studies.chart.draw import label_steps, pyplot
from adagen.studies.chart.motion import INTEGRATORS, MotionChart, MotionPoint

_LOOKS = {  # colour, marker and its size: what lies below another one is larger
    "euler": ("#d55e00", "s", 9),
    "semi-implicit": ("#cc79a7", "D", 5),
    "implicit": ("#e69f00", "v", 5),
    "rk4": ("#0072b2", "o", 9),
    "rkmk4": ("#009e73", "^", 5),
}


def motion_picture(chart: MotionChart) -> Any:
    """Return the figure: state error against wall time, then drifts against the step."""
    plt = pyplot()
    drifts = [w for w in ("energy", "momentum") if any(_finite(p, w) for p in chart.points)]
    figure, grid = plt.subplots(
        1, 1 + len(drifts), figsize=(5.4 * (1 + len(drifts)), 4.8), squeeze=False
    )
    axes = grid[0]
    _panel(axes[0], chart, "wall_s", "error")
    axes[0].set(
        xlabel="wall time per simulated second, s", ylabel=f"state error after {chart.seconds:g} s"
    )
    if chart.reference_error > 0:
        axes[0].axhline(chart.reference_error, color="black", lw=0.8, ls="--", alpha=0.6)
        axes[0].text(
            0.02, chart.reference_error * 1.2, "the reference's own error", fontsize=7,
            transform=axes[0].get_yaxis_transform(),
        )  # fmt: skip
    for panel, what in zip(axes[1:], drifts, strict=True):
        _panel(panel, chart, "step", what)
        name = "energy" if what == "energy" else "angular momentum"
        panel.set(xlabel="step, s", ylabel=f"relative drift of {name}")
    figure.suptitle(
        f"{chart.model}: integrators over {chart.seconds:g} s without torques; "
        f"reference RK4 at {chart.reference_step:g} s"
    )
    figure.tight_layout()
    return figure


def _finite(point: MotionPoint, what: str) -> bool:
    value = getattr(point, what)
    return value is not None and math.isfinite(value)


def _panel(axes: Any, chart: MotionChart, across: str, what: str) -> None:
    for integrator in INTEGRATORS:
        colour, marker, size = _LOOKS[integrator]
        rows = [
            (getattr(p, across), max(getattr(p, what), 1e-17))
            for p in chart.points
            if p.integrator == integrator and p.wall_s is not None and _finite(p, what)
        ]
        order = chart.order(integrator, what)
        label = integrator if order is None else f"{integrator}, order {order:.1f}"
        if rows:
            axes.loglog(*zip(*rows, strict=True), marker=marker, ms=size, color=colour, label=label)
    axes.grid(alpha=0.25)
    axes.margins(0.08)
    axes.tick_params(axis="y", which="minor", left=False)
    label_steps(axes)
    axes.legend(fontsize=8, ncols=2, frameon=False, loc="lower center", bbox_to_anchor=(0.5, 1.0))
