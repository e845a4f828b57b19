"""Code shapes: the forms in which the steps of a plan become C++ functions.

* ``kernels``: loops over runs of joints in base axes, several links at once where there is no
  recursion. It takes plans of form segment.
* ``joints``: joint-local frames, a function for each joint and step, one call after the other: the
  shape of the paper's form, for reading. It takes plans of form ada alone.
* ``unrolled``: a straight line of scalar statements from an expression graph, the fastest up to
  about 10 joints.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache

from adagen.cost import Timeline, programmed, timeline
from adagen.emit import baselines, joints, kernels, unrolled
from adagen.emit.symbols import Symbols
from adagen.errors import UsageError
from adagen.plan import Plan
from adagen.plan.certificate import why_not as why_not_corrected
from adagen.plan.own_axes import balls_lose
from adagen.plan.refine import corrected, refinable, why_not_in_lines
from adagen.plan.robot import slaved_joint
from adagen.plan.steps import Join
from adagen.program import Program
from adagen.schedule import CostProfile, step_costs, with_steps


@dataclass(frozen=True)
class Shape:
    """A code shape.

    Attributes:
        why_not: says why a plan cannot be emitted in it; None where it can.
        values: what its template (SHAPE.cpp.j2 or baseline.cpp.j2: functions and processes) needs.
    """

    why_not: Callable[[Plan], str | None]
    values: Callable[[Symbols], dict[str, object]]


SHAPES: dict[str, Shape] = {
    "kernels": Shape(kernels.why_not, kernels.values),
    "joints": Shape(joints.why_not, joints.values),
    "unrolled": Shape(lambda _: None, unrolled.values),
}


BASELINES = {
    name: Shape(baselines.why_not, baselines.values) for name in ("crba", "aba", "aba_exact")
}
"""Textbook algorithms as loops over any tree, to compare with; never chosen by themselves."""

KNOWN = {**SHAPES, **BASELINES}


MOST_FREEDOMS = 128
"""Degrees of freedom of a robot up to which straight lines are priced: beyond, their statements
take longer to make than to find that loops are faster."""

MOST_FREEDOMS_IN_NARROW_REGISTERS = 256
"""The same where no register holds the eight numbers that loops compute with."""


MOST_FREEDOMS_IN_BATCHES = 512
"""Likewise of batches, whose instructions are fetched once for all lanes: with more freedoms
compilers take minutes."""


def stepwise(plan: Plan) -> str:
    """Return the fastest shape in which a plan is priced step by step.

    Refined plans are emitted in it, too. Masses that can be set are no constants in straight lines,
    where loops do not take a plan; closed loops and outputs are straight lines alone.
    """
    names = ("kernels", "joints", "unrolled")
    return next(name for name in names if SHAPES[name].why_not(plan) is None)


def chosen_shape(
    plan: Plan, shape: str = "auto", *, batch: bool = False, profile: CostProfile | None = None
) -> str:
    """Return the shape of a plan: the requested one, or the one of least price.

    Args:
        plan: the plan.
        shape: one of ``KNOWN``, or "auto".
        batch: whether it is emitted for batches.
        profile: prices the shapes; without it, or where it prices joins alone, the shipped one.

    Raises:
        UsageError: the plan cannot be emitted in the shape asked for.
    """
    if plan.reproducible:
        return _reproducible(plan, shape)
    if shape == "auto":
        if not batch:
            return _cheapest(plan, profile)
        shape = _of_batch(plan, profile)
    reason = KNOWN[shape].why_not(plan)
    if reason is None and batch and shape == "kernels":
        reason = slaved_joint(plan.joints)
    if reason is not None:
        raise UsageError(f"shape {shape} cannot be emitted: {reason}")
    return shape


def _reproducible(plan: Plan, shape: str) -> str:
    """The shape of a reproducible plan; loops would have other last digits."""
    if shape not in ("auto", "unrolled"):
        raise UsageError(f"shape {shape} cannot be emitted: only straight lines are reproducible")
    if plan.nv > MOST_FREEDOMS_IN_BATCHES:
        raise UsageError(
            f"this robot has {plan.nv} degrees of freedom: only straight lines are reproducible, "
            f"and beyond {MOST_FREEDOMS_IN_BATCHES} they take compilers minutes; leave out "
            "--reproducible"
        )
    return "unrolled"


def _of_batch(plan: Plan, profile: CostProfile | None) -> str:
    """The faster shape for a batch: loops, or a straight line."""
    if len(plan.processes) > 1:
        return "kernels"
    if plan.slaved or kernels.why_not(plan) is not None:
        return "unrolled"
    if plan.nv > MOST_FREEDOMS_IN_BATCHES:
        return "kernels"
    return _fastest(plan, ("kernels", "unrolled"), profile, batch=True)


def shape_to_refine(plan: Plan, shape: str) -> str:
    """Return the shape in which answers are refined: the requested one, or loops."""
    return stepwise(plan) if shape == "auto" else shape


def why_not_own(plan: Plan, shape: str) -> str | None:
    """Return why a refined solver has no residuals in its own precision; None where it has."""
    if plan.closed:
        return why_not_in_lines(plan)
    if shape != "kernels":
        return f"shape {shape} computes residuals in higher precision only"
    reason = why_not_corrected(plan) or kernels.why_not_weighed(plan)
    if reason is None and plan.several:
        reason = "several processes share the robot"
    if reason is None and any(plan.steps_of(Join)):
        reason = "its process joins parts of a chain"
    return None if reason is None else f"residuals are in wider numbers here: {reason}"


def to_be_refined(plan: Plan, shape: str, steps: int, residual: str) -> Plan:
    """Return the plan of a solver that refines its answers.

    Args:
        plan: of a solver that does not.
        shape: of the code.
        steps: of refinement, at least one.
        residual: one of ``adagen.emit.refine.RESIDUALS``.

    Raises:
        UsageError: it cannot be refined so.
    """
    why = None if residual == "wide" else why_not_own(plan, shape)
    if why is None and residual != "wide":
        return corrected(plan, steps)
    if residual == "own":
        raise UsageError(f"{why}; leave out --residual own")
    if plan.closed:
        why = "closed loops have residuals in their own numbers" if why is None else why
        raise UsageError(f"{why}; leave out --residual wide" if residual == "wide" else why)
    if shape == "unrolled":
        raise UsageError(
            "shape unrolled has no refinement, but for closed loops; leave --shape out"
        )
    if plan.sets_inertias:
        raise UsageError("masses cannot be set where answers are refined: leave one of both out")
    return refinable(plan)


def offered(plan: Plan, profile: CostProfile | None = None) -> tuple[str, ...]:
    """Return the shapes among which "auto" takes the one of least price, the default first.

    How wide registers are is by the profile, the shipped one if not given. Form `ada` is read joint
    by joint on several processes. Loops sweep ball joints in axes of the base, where links that are
    slender beyond them lose digits: those are straight lines.
    """
    if plan.reproducible:
        return ("unrolled",)
    loops = (stepwise(plan),)
    if plan.closed or plan.outputs:
        return loops
    if plan.form == "ada" and plan.several:
        return loops
    narrow = step_costs(profile).narrow
    if plan.nv > (MOST_FREEDOMS_IN_NARROW_REGISTERS if narrow else MOST_FREEDOMS):
        return loops
    return ("unrolled",) if balls_lose(plan) else (*loops, "unrolled")


@lru_cache(maxsize=8)  # a plan is judged, priced and emitted one after the other
def _cheapest(plan: Plan, profile: CostProfile | None) -> str:
    """The shape of least predicted time."""
    names = offered(plan, profile)
    return names[0] if len(names) == 1 else _fastest(plan, names, profile)


def _fastest(
    plan: Plan, shapes: Sequence[str], profile: CostProfile | None, *, batch: bool = False
) -> str:
    """The first of some shapes that none of the others is faster than."""
    profile = with_steps(profile)
    programs = {shape: programmed(plan, shape, profile, batch=batch) for shape in shapes}
    return min(shapes, key=lambda shape: timeline(programs[shape], profile).makespan)


def priced_program(plan: Plan, shape: str = "auto", profile: CostProfile | None = None) -> Program:
    """Return the program by which a plan is priced, for one state at a time.

    Args:
        plan: what each process computes.
        shape: of the code, as ``adagen.emit.emit`` takes it; where the plan cannot be had in it,
            the fastest that does the plan step by step.
        profile: what shape, limbs side by side and methods are chosen by; the shipped one if not
            given.
    """
    if shape == "auto":
        return programmed(plan, chosen_shape(plan, profile=profile), profile)
    known = shape in SHAPES and SHAPES[shape].why_not(plan) is None
    return programmed(plan, shape if known else stepwise(plan), profile)


def predict(plan: Plan, profile: CostProfile, shape: str = "auto") -> Timeline:
    """Return the predicted timeline of an evaluation.

    Args:
        plan: what each process does, in either form.
        profile: a profile with the costs of steps.
        shape: of the code, as ``priced_program`` takes it.

    Raises:
        ValueError: the profile prices joins alone, as the paper's does.
    """
    return timeline(priced_program(plan, shape, profile), profile)
