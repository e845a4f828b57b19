"""Charts of integrators as pictures."""

from __future__ import annotations

import math
from typing import Any

from adagen.chart.draw import pyplot
from adagen.chart.motion import INTEGRATORS, MotionChart

_LOOKS = {
    "euler": ("#d55e00", "s"),
    "semi-implicit": ("#cc79a7", "D"),
    "implicit": ("#e69f00", "v"),
    "rk4": ("#0072b2", "o"),
    "rkmk4": ("#009e73", "^"),
}


def motion_picture(chart: MotionChart) -> Any:
    """Return the figure: state error against wall time, then drifts against the step."""
    plt = pyplot()
    whats = ["error", "energy"]
    whats += ["momentum"] if any(p.momentum is not None for p in chart.points) else []
    figure, axes = plt.subplots(1, len(whats), figsize=(5.2 * len(whats), 4.6))
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
    for panel, what in zip(axes[1:], whats[1:], strict=True):
        _panel(panel, chart, "step", what)
        name = "energy" if what == "energy" else "angular momentum"
        panel.set(xlabel="step, s", ylabel=f"relative drift of {name}")
    figure.suptitle(
        f"{chart.model}: integrators over {chart.seconds:g} s without torques; "
        f"reference RK4 at {chart.reference_step:g} s"
    )
    figure.tight_layout()
    return figure


def _panel(axes: Any, chart: MotionChart, across: str, what: str) -> None:
    for integrator in INTEGRATORS:
        colour, marker = _LOOKS[integrator]
        rows = [
            (getattr(p, across), max(getattr(p, what), 1e-17))
            for p in chart.points
            if p.integrator == integrator
            and p.wall_s is not None
            and getattr(p, what) is not None
            and math.isfinite(getattr(p, what))
        ]
        order = chart.order(integrator, what)
        label = integrator if order is None else f"{integrator}, order {order:.1f}"
        if rows:
            axes.loglog(*zip(*rows, strict=True), marker=marker, color=colour, label=label)
    axes.grid(alpha=0.25)
    axes.minorticks_off()
    axes.margins(0.08)
    axes.legend(fontsize=8, framealpha=0.7, loc="center left" if what == "error" else "best")
