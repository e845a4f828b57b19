"""Target `embedded`: solvers for programs without operating system, heap or clock."""

from __future__ import annotations

from adagen.emit.kernels.mobility import passes_free
from adagen.emit.settings import needs_eigen
from adagen.emit.symbols import Symbols
from adagen.errors import UsageError
from adagen.plan import Plan
from adagen.plan.operations import operations
from adagen.program.lower import LOOPS

TARGETS = ("host", "embedded")
TEXT = 200
"""Characters of a failure's message, the end among them."""
_LANES = 64  # bytes of numbers side by side, whatever the machine's registers hold
_LINE = 64  # what a solver is aligned to
_SOME = 8  # bytes of an index, or of something empty, beside numbers
_BODY, _MOTION, _BLOCK, _COLUMNS = 27, 6, 43, 24  # numbers


def check_target(
    target: str, processes: int, refine: int, *, batch: bool, single_file: bool = False
) -> None:
    """Refuse options that a target does not support.

    Raises:
        UsageError: an embedded solver of several processes or states, one that refines, or one with
            the program around it.
    """
    if target == "host":
        return
    if processes != 1 or batch:
        raise UsageError("an embedded solver is for one process and one state at a time")
    if single_file:
        raise UsageError("an embedded solver has no program around it: leave out --single-file")
    if refine:
        raise UsageError("an embedded solver does not refine; leave out --refine")


def embedded_values(symbols: Symbols, values: dict[str, object]) -> dict[str, object]:
    """Return the templates' values for an embedded solver.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        values: the values of the shape's template.

    Raises:
        UsageError: in this shape it needs Eigen.
    """
    if needs_eigen(values):
        raise UsageError(
            f"shape {symbols.program.shape} needs Eigen here, which an embedded solver cannot "
            "have: use --shape unrolled"
        )
    return {"bytes": _bytes(symbols, values), "work": _work(symbols.plan, values)}


def _listed(value: object) -> list[object]:
    assert isinstance(value, list)
    return value


def _number(value: object) -> int:
    assert isinstance(value, int)
    return value


def _bytes(symbols: Symbols, values: dict[str, object]) -> int:
    """Largest size of a solver's memory in bytes, at any alignment."""
    size = 4 if symbols.plan.scalar == "float" else 8
    numbers, results = len(symbols.plan.parameter_values), symbols.plan.nqdd
    if symbols.program.shape == LOOPS:
        pointers = 8 * 8
        whole = _in_loops(symbols, values, size) + (results + numbers) * size + pointers
        return _lines(whole + TEXT + 2 * _LINE)
    angles, rows = _number(values["angle_count"]) * size, _number(values["wide_results"]) * size
    # Parts of StraightMemory begin on lines of their own: pointers, angles, sines, cosines with
    # results, rows, places. What is empty takes some bytes all the same.
    parts = (_SOME, angles, angles, angles + _SOME + results * size, rows + _SOME)
    whole = sum(max(_LINE, _lines(part)) for part in (*parts, _number(values["places"]) * size))
    if numbers or values.get("near_lock"):
        whole += _lines(numbers * size + _SOME)
    tangents = _number(values["tangent_count"]) * size
    whole += _lines(tangents + _LINE) if tangents else 0
    return _lines(whole + 2 * _SOME + TEXT) + _LINE


def _lines(size: int) -> int:
    """A size in bytes, as whole lines."""
    return -(-size // _LINE) * _LINE


def _in_loops(symbols: Symbols, values: dict[str, object], size: int) -> int:
    """Bytes of the links' and joints' data in loops."""
    plan, count = symbols.plan, len(symbols.plan.joints)
    kinds = {joint.kind for joint in plan.joints}
    factors = 24 if "planar" in kinds else 18 if "spherical" in kinds else 8
    per_block, slots = _LANES // size, symbols.program.slots.count
    blocks = -(-slots // per_block)
    of_joint = (8 + factors) * size + _LINE  # what is kept from sweep to sweep
    whole = blocks * per_block * _BLOCK * size + count * of_joint
    whole += 2 * slots * (3 + factors) * size if values["limbs"] else 0
    whole += (count + 1) * _COLUMNS * size if values["by_columns"] else 0
    whole += (count + 1) * (_BODY + _MOTION) * size
    whole += plan.nv * size if any(joint.loads for joint in plan.joints) else 0
    whole += count * _BODY * size if passes_free(plan) else 0
    if plan.sets_inertias:
        whole += count * 10 * size + blocks * (per_block * 19 * size + _LINE)
    return whole + 8 * _LINE


def _work(plan: Plan, values: dict[str, object]) -> str:
    """Number of operations of an evaluation, in words."""
    sines = sum(joint.kind in ("revolute", "planar") for joint in plan.joints)
    turned = f", {sines} sine{'s' * (sines != 1)} with cosine{'s' * (sines != 1)}"
    lines = values.get("unrolled")
    if lines is None:
        return f"about {operations(plan)} products and sums{turned}"
    counted = _listed(lines)[0]["operations"]  # type: ignore[index]
    found = f"{counted.multiply} products, {counted.add} sums, {counted.divide} quotients"
    return f"{found}{turned}"
