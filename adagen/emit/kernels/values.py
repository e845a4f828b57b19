"""Code shape `kernels`: a plan's steps as loops over runs of joints, in base axes.

A run is a sequence of joints, each on the link of the one before. Work without recursion (sines and
cosines, inertias and bias forces of bare links) is done for as many joints at once as a register
has lanes; recursive work is carried along a run in registers, or along several limbs at once, one
in each lane (templates/include/adagen/kernels/).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from adagen.emit.kernels import mobility
from adagen.emit.kernels.lines import KernelLines
from adagen.emit.refine import refinement_values
from adagen.emit.settings import overridden
from adagen.emit.symbols import Symbols
from adagen.plan import Plan
from adagen.plan.certificate import ROUNDING, own_links
from adagen.plan.digits import EPSILON
from adagen.plan.edges import is_base
from adagen.plan.messages import CERTIFICATE
from adagen.plan.own_axes import ENOUGH, OwnAxes
from adagen.plan.robot import PlanLink
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Join
from adagen.plan.types import Process
from adagen.program.lower import LOOPS, lower
from adagen.program.runs import own_axes_in_loops
from adagen.program.slots import Slots
from adagen.program.strips import LANES


def why_not(plan: Plan) -> str | None:
    """Return why a plan cannot be emitted in this shape; None where it can."""
    if plan.form != "segment":
        return f"it is for form segment, not {plan.form}"
    if plan.closed:
        return "robots with closed loops are emitted as straight lines"
    if plan.outputs:
        return "outputs beside accelerations are computed in straight lines only"
    reason = why_not_weighed(plan) if plan.weighed else None
    if reason is None and plan.certified and not plan.several and any(plan.steps_of(Join)):
        (*_, certify) = lower(plan, LOOPS).processes[0].operations
        if certify.method != "parts":
            return "loops cannot sweep the parts of its chain side by side"
    return reason


def why_not_weighed(plan: Plan) -> str | None:
    """Return why loops cannot sweep residuals inwards; None where they can.

    Certificates and corrections in the solver's own numbers need that.
    """
    if plan.wanted or plan.outputs:
        return "the scene requests other results than all accelerations"
    if plan.wrenches:
        return "outer forces act on links"
    at_ground = [joint for joint in plan.joints if joint.parent == 0]
    if len(at_ground) > 1 and any(map(is_base, at_ground)):
        return "they certify a floating robot only if it is the only one"
    for joint in plan.joints:
        if joint.kind == "spherical" and joint.rotor_inertia:
            return f'they do not certify ball joint "{joint.name}" with a rotor'
    return None


def values(symbols: Symbols) -> dict[str, object]:
    """Return the values of kernels.cpp.j2."""
    plan = symbols.plan
    cuts = mobility.has_cuts(plan)
    program = symbols.program
    slots = program.slots
    own_axes = own_axes_in_loops(plan, slots.limbs, program.batch)
    writers = _writers(symbols, own_axes)
    lines = [writer.all_lines() for writer in writers]
    by_columns = any(writer.columns for writer in writers)
    along = any(writer.along for writer in writers)
    in_parts = any(writer.parted for writer in writers)
    runtime, refined = _joined_runtime(symbols, writers)
    return {
        "runtime": runtime,
        "copied": bool(plan.slaved),
        "loaded": [own for writer in writers if (own := writer.loaded)["joints"]],
        "responses": [writer.responses() for writer in writers] if plan.slaved else [],
        **refined,
        "cuts": cuts,
        "fused": mobility.has_fused(plan),
        "holds": mobility.holds_ground(plan),
        "carries": mobility.carries(program),
        "carries_along": along,
        "passages": [symbols.span(run.first, run.last) for run in symbols.passages],
        "cut_joints": [
            {"type": f"Joint_{symbols.joints[j]}", "id": f"j_{symbols.joints[j]}", "members": lines}
            for j, lines in mobility.members(symbols).items()
        ],
        "turned": bool(own_axes.always or own_axes.if_lost),
        "loop_settings": _loop_settings(symbols, own_axes, by_columns, along, in_parts),
        "inertias": [_inertia(symbols, link) for link in plan.links[1:]],
        "roles": [writer.roles() for writer in writers],
        "starts": [_starts(plan, writer.process) for writer in writers] if plan.weighed else [],
        "shares": sum(message.sweep == CERTIFICATE for message in plan.messages),
        "steps": lines[: len(plan.processes)],
        "recovery": lines[len(plan.processes) :],
        "tile": slots.tile,
        "in_strips": bool(slots.in_strips),
        "in_parts": in_parts,
        "quaternions": any(writer.oriented for writer in writers),
        "by_columns": by_columns,
        "limbs": [_limbs(symbols, slots, limbs) for limbs in slots.numbers],
    }


def _writers(symbols: Symbols, own_axes: OwnAxes) -> list[KernelLines]:
    """The writers of each process, and behind them those of its recovery, if there is any."""
    plan, program = symbols.plan, symbols.program
    rows = [
        (process, own.operations)
        for process, own in zip(plan.processes, program.processes, strict=True)
    ]
    if any(process.recovery for process in plan.processes):
        again = zip(plan.recovering().processes, program.processes, strict=True)
        rows += [(process, own.recovery) for process, own in again]
    return [
        KernelLines(symbols, p, *row, program.slots, own_axes.always) for p, row in enumerate(rows)
    ]


def _joined_runtime(
    symbols: Symbols, writers: Sequence[KernelLines]
) -> tuple[list[str], dict[str, object]]:
    """Headers for cuts, slaved joints and refinement, and the values of refinement."""
    plan = symbols.plan
    parts = mobility.runtime(plan) if mobility.has_cuts(plan) else []
    if plan.slaved:
        parts += ["spatial.hpp", "joins.hpp"]
    refined: dict[str, object] = {}
    if symbols.refine:
        parts += ["spatial.hpp", "joins.hpp", "wide.hpp", "refine.hpp"]
        corrections = [writer.corrections() for writer in writers]
        count = len(plan.processes)
        refined = refinement_values(symbols, corrections[:count], corrections[count:])
    return list(dict.fromkeys(parts)), refined


def _loop_settings(
    symbols: Symbols, own_axes: OwnAxes, by_columns: bool, along: bool, in_parts: bool
) -> list[str]:
    """Settings of a solver's loops: slots of joints, and methods."""
    plan, slots = symbols.plan, symbols.program.slots
    block_kinds = _block_kinds(symbols)
    joints = range(len(plan.joints))
    grouped = [j for limbs in slots.numbers for j in limbs.members()]
    lines = overridden(
        [
            ("int", "kSlotCount", slots.count, len(joints)),
            ("bool", "kReordered", not slots.plain, False),
            ("int", "kSlots[kJointCount]", _braced(slots.slots), _braced(joints)),
            ("int", "kTile", slots.tile, 0),
            ("bool", "kInLanes", bool(slots.numbers), False),
            ("bool", "kPrescribedInLanes", any(plan.joints[j].prescribed for j in grouped), False),
            ("bool", "kByColumns", by_columns, False),
            ("int", "kBlockKindCount", len(block_kinds["first"]), 0),
            ("int", "kBlockKinds[]", _braced(block_kinds["kinds"]), "{}"),
            ("int", "kFirstOfKind[]", _braced(block_kinds["first"]), "{}"),
            ("bool", "kAnyTurned", bool(own_axes.always), False),
            ("bool", "kAnyTurnedIfLost", bool(own_axes.if_lost), False),
            *(
                ("bool", f"{name}[kJointCount]", _braced(int(j in own) for j in joints), none)
                for name, own in (("kTurned", own_axes.always), ("kTurnedIfLost", own_axes.if_lost))
                for none in (_braced(0 for _ in joints),)
            ),
            ("double", "kLosing", ENOUGH if own_axes.if_lost else 1, 1),
            ("bool", "kCarriesAlong", along, False),
            ("bool", "kInParts", in_parts, False),
            ("bool", "kPassesFree", mobility.passes_free(plan), False),
        ]
    )
    if plan.weighed:
        unit = symbols.printer.number(ROUNDING * EPSILON[plan.scalar])
        floats = ("bool", "kFloats", any(map(is_base, plan.joints)), False)
        lines += overridden([floats, ("double", "kUnit", unit, "")])
    return lines


def _starts(plan: Plan, process: Process) -> list[int]:
    """Whether a process starts the inertia of the link beyond each joint."""
    own = set(own_links(process))
    return [int(j + 1 in own) for j in range(len(plan.joints))]


def _braced(numbers: Iterable[object]) -> str:
    return f"{{{', '.join(map(str, numbers))}}}"


def pseudo_inertia(link: PlanLink) -> tuple[Fraction, ...]:
    """Return sum of m x x^T about the link's origin, upper triangle row by row, exactly.

    With the rotational inertia I about the centre of mass c: J = tr(I) / 2 - I + m c c^T.
    """
    mass, c = Fraction(link.mass), [Fraction(x) for x in link.com]
    half = sum((Fraction(link.tensor[k][k]) for k in range(3)), Fraction(0)) / 2
    return tuple(
        (half if i == k else 0) - Fraction(link.tensor[i][k]) + mass * c[i] * c[k]
        for i in range(3)
        for k in range(i, 3)
    )


def _inertia(symbols: Symbols, link: PlanLink) -> dict[str, str]:
    number, numbers = symbols.printer.number, symbols.printer.numbers
    mass = Fraction(link.mass)
    return {
        "mass": number(link.mass),
        "moments": numbers(float(mass * Fraction(x)) for x in link.com),
        "tensor": numbers(float(x) for x in pseudo_inertia(link)),
    }


def _block_kinds(symbols: Symbols) -> dict[str, list[int]]:
    """Blocks of slots grouped by equal constants."""
    plan = symbols.plan
    if plan.sets_inertias:
        return {"kinds": [], "first": []}
    links = ((link.mass, link.com, link.tensor) for link in plan.links[1:])
    own = [
        (joint.rotation, joint.translation, link)
        for joint, link in zip(plan.joints, links, strict=True)
    ]
    width = 1 if symbols.program.batch else LANES[plan.scalar]
    kinds, first = symbols.program.slots.block_kinds(own, width)
    return {"kinds": kinds, "first": first}


def _limbs(symbols: Symbols, slots: Slots, limbs: Limbs) -> dict[str, object]:
    return {
        "lanes": limbs.lanes,
        "joints": len(limbs.rows),
        "slot": slots.slots[limbs.rows[0][0]] - limbs.idle,
        "idle": limbs.idle,
        # An idle lane goes by the name of the next one's joint, which has the last word.
        "rows": [(row[0],) * limbs.idle + row for row in limbs.rows],
        "names": [symbols.span(*ends) for ends in zip(limbs.rows[0], limbs.rows[-1], strict=True)],
    }
