"""Values for the templates about refinement: number of steps, messages and tables."""

from __future__ import annotations

from collections.abc import Iterable

from adagen.emit.symbols import Symbols
from adagen.errors import UsageError
from adagen.model.kinds import KINDS
from adagen.plan.refine import (
    exchanges,
    handed_on,
    joints_around,
    links_of_process,
    moving,
    paths_of,
)
from adagen.plan.types import Plan, Process

MOST_STEPS = 9


def checked_steps(asked: int | None) -> int:
    """Return the number of refinement steps of a solver, 0 by default.

    Raises:
        UsageError: the number is out of range.
    """
    asked = asked or 0
    if not 0 <= asked <= MOST_STEPS:
        raise UsageError(f"steps of refinement must be 0 to {MOST_STEPS}, not {asked}")
    return asked


RESIDUALS = ("auto", "own", "wide")
"""Numbers of residuals: the solver's own where loops have them (auto), always, or wider ones."""


def checked_shape(refine: int, shape: str) -> str:
    """Return the requested shape, if it can be refined.

    Raises:
        UsageError: the shape has no refinement.
    """
    if refine and shape not in ("auto", "kernels", "joints", "unrolled"):
        raise UsageError(f"shape {shape} has no refinement; leave --shape out")
    return shape


def refinement_values(
    symbols: Symbols, corrections: list[list[str]], again: list[list[str]]
) -> dict[str, object]:
    """Return the values of refine.cpp.j2.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        corrections: the lines of a correction, for each process.
        again: the same where the processes recover from a singular pose; nothing if they never do.
    """
    plan = symbols.plan
    return {
        "corrections": corrections,
        "corrections_again": again,
        "refined": [_tables(plan, process) for process in plan.processes],
        "exchanges": [
            {
                "source": exchange.source,
                "target": exchange.target,
                "entries": _entries(plan, exchange.accelerations),
                "forces": list(exchange.forces),
            }
            for exchange in exchanges(plan)
        ],
        "sharing": _sharing(plan),
    }


def _tables(plan: Plan, process: Process) -> list[list[int]]:
    """The tables of a RefinedProcess in the order of its members."""
    path, at = paths_of(plan, process), joints_around(plan, process)
    slaved = sorted(set(plan.slaved).intersection({*path, *process.owns}))
    runs = handed_on(process)
    inner = [j for j, _ in runs]
    return [
        _entries(plan, process.owns),
        _entries(plan, moving(plan, process)),
        [j for j in process.owns if j not in inner],
        list(path),
        list(at),
        list(links_of_process(process)),
        slaved,
        inner,
        [beyond for _, beyond in runs],
    ]


def _entries(plan: Plan, joints: Iterable[int]) -> list[int]:
    return [plan.joints[j].v + k for j in joints for k in range(KINDS[plan.joints[j].kind].nv)]


def _sharing(plan: Plan) -> list[int]:
    return [p for p, process in enumerate(plan.processes) if p > 0 and process.owns]


def refinement_messages(symbols: Symbols) -> list[dict[str, object]]:
    """Return the messages of the refinement, which come behind all others."""
    if not symbols.refine:
        return []
    plan = symbols.plan
    rows: list[dict[str, object]] = [
        {
            "source": exchange.source,
            "target": exchange.target,
            "size": len(_entries(plan, exchange.accelerations)) + 6 * len(exchange.forces),
            "comment": "step of refinement",
        }
        for exchange in exchanges(plan)
    ]
    sharing = _sharing(plan)
    rows += [{"source": p, "target": 0, "size": 3, "comment": "energies"} for p in sharing]
    return rows + [
        {"source": 0, "target": p, "size": 2, "comment": "size of the correction"} for p in sharing
    ]
