"""Code shape `joints`: joint-local frames, a function for each joint and step, one after another.

It is how the paper's form is written, and takes plans of form ada alone. Clusters in these
(adagen/plan/clusters.py) are articulated bodies.
"""

from __future__ import annotations

from adagen.emit.combinations import FORM_ADA_ALONE
from adagen.emit.forces import has_effects
from adagen.emit.joints.refine import add_corrections, corrections
from adagen.emit.joints.rows import joint_rows
from adagen.emit.joints.steps import step_rows
from adagen.emit.refine import refinement_values
from adagen.emit.symbols import Symbols
from adagen.plan import Plan
from adagen.plan.steps import FusedJoin, StartLink

__all__ = ["values", "why_not"]


def why_not(plan: Plan) -> str | None:
    """Return why a plan cannot be emitted in this shape; None where it can."""
    if plan.form != "ada":
        return FORM_ADA_ALONE
    if plan.sets_inertias:
        return "in it masses are constants"
    if plan.closed:
        return "robots with closed loops are emitted as straight lines"
    if plan.outputs:
        return "outputs beside accelerations are computed in straight lines only"
    return None


def values(symbols: Symbols) -> dict[str, object]:
    """Return the values of joints.cpp.j2, its runtime headers among them."""
    clusters = any(symbols.plan.steps_of(StartLink))
    fused = any(symbols.plan.steps_of(FusedJoin))
    runtime = ["articulated.hpp" if clusters else "joins.hpp"]
    runtime += ["fused.hpp"] * fused
    if has_effects(symbols.plan):
        runtime += ["effects.hpp", *["geared.hpp"] * clusters]
    rows = joint_rows(symbols)
    if symbols.refine:
        runtime += ["wide.hpp", "refine.hpp", "refine_joins.hpp"]
        runtime += ["refine_segment.hpp"] * clusters + ["refine_fused.hpp"] * fused
        add_corrections(symbols, rows)
    return {
        "runtime": runtime,
        "joint_functions": rows,
        "steps": step_rows(symbols),
        **(refinement_values(symbols, corrections(symbols), []) if symbols.refine else {}),
    }
