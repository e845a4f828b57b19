"""Operations as counts of the coefficients of a cost profile.

Both predictions and the fit of measured times use these counts.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache

from adagen.model.kinds import KINDS
from adagen.plan import Plan
from adagen.plan.robot import PlanJoint
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import (
    Accelerate,
    AccelerateRoot,
    Append,
    ApplyCoupling,
    Arrive,
    Articulate,
    Certify,
    Correct,
    Deliver,
    Disassemble,
    FreeAcceleration,
    FreeBase,
    FusedJoin,
    GiveOutput,
    HoldMobility,
    InvertRoot,
    Join,
    Kinematics,
    LinkBias,
    Load,
    LoadRoot,
    Propagate,
    Receive,
    Refine,
    Send,
    SolveCoupling,
    SolveMobility,
    SolveRoot,
    StartEmpty,
    StartLink,
    Step,
    Traverse,
)
from adagen.program import Operation
from adagen.program.names import PASSING
from adagen.program.runs import Run
from adagen.schedule.costs import PRESCRIBED, REPEATED, block_rows

Features = dict[str, float]
"""How often each coefficient counts; names as in ``adagen.schedule.costs.NAMES``."""

_Swept = Kinematics | Articulate | Accelerate
_SWEPT = (Kinematics, Articulate, Accelerate)
_PLAIN: dict[type, str] = {
    LinkBias: "link.bias",
    StartLink: "link.start",
    InvertRoot: "root.invert",
    SolveRoot: "root.solve",
    SolveMobility: "root.mobility",
    HoldMobility: "root.invert",
    LoadRoot: "deliver.load",
    AccelerateRoot: "root.accelerate",
    FreeBase: "free.base",
    FreeAcceleration: "free.acceleration",
    Load: "deliver.load",
    SolveCoupling: "slaved.solve",
    ApplyCoupling: "slaved.apply",
    Append: "kinematics.floating",  # a run that is passed on moves its link as a free joint does
    Arrive: "kinematics.floating",
}


def joins_of(plan: Plan) -> str:
    """Return the group of coefficients that prices a plan's joins: few, or all of form `ada`."""
    return REPEATED if plan.form == "ada" else "join"


def step_features(step: Step, joints: Sequence[PlanJoint], joins: str = "join") -> Features:
    """Return the features of a step that is an operation by itself; none for a message.

    Args:
        step: a step of a plan.
        joints: the plan's joints.
        joins: the group that prices its joins (``joins_of``).
    """
    if isinstance(step, _SWEPT):
        return dict(_of_joint(step, joints[step.joint], "step"))
    known = _without_joint(step, joints)
    if known is not None:
        return known
    joint = joints[step.joint]  # type: ignore[union-attr]
    kind = joint.priced_as
    match step:
        case FusedJoin():
            freedoms = sum(KINDS[joints[j].kind].nv for j in step.run)
            own = _join(step, "spherical" if freedoms < 6 else "floating", joins)
            return {**own, "kinematics.revolute": len(step.run)}
        case Join():
            return _join(step, kind, joins)
        case Disassemble():
            kind = "ground" if joint.parent == 0 and kind != "floating" else kind
            return {f"disassemble.{kind}": 1, "disassemble.coupling": len(step.forces)}
        case Propagate():
            first = "ground" if step.near is None else kind
            found = _turned("propagate", first, step.reversed)
            return {**found, "propagate.spread": len(step.spreads)}
        case Deliver():
            return _turned("deliver", kind, step.reversed)
    raise AssertionError(f"unknown step {step}")


def _of_joint(step: _Swept, joint: PlanJoint, method: str, does: str = "") -> Features:
    """Features of a joint in a sweep, by the method of its operation."""
    backwards = not isinstance(step, Kinematics) and step.reversed
    grounded = joint.parent == 0 and not backwards
    kinds = joint.kind, joint.priced_as
    return _swept(step.does, *kinds, method, grounded, backwards, does == PASSING)


@lru_cache(maxsize=1024)  # of a large robot it is asked for some hundred thousand times
def _swept(
    sort: str,
    kind: str,
    priced_as: str,
    method: str,
    grounded: bool,
    backwards: bool,
    passing: bool,
) -> Features:
    """Features of a joint in a sweep; not to be changed. ``sort`` is what its step does."""
    if sort == "accelerate":
        return _turned("accelerate", priced_as, backwards)
    if sort == "articulate":
        if method in ("columns", "tiles"):
            here = {"articulate.ground": 1.0}
            return here if grounded else _turned("articulate_columns", kind, backwards)
        if grounded and priced_as == PRESCRIBED:  # nothing is passed to the ground
            return {}
        return _turned("articulate", "ground" if grounded else priced_as, backwards)
    match method:
        case "traversed":
            return {f"kinematics_traversed.{kind}": 1}
        case "strips":
            return {f"{'passing' if passing else 'kinematics'}_strips.{kind}": 1}
        case "tiles":
            return {f"{group}.{kind}": 1 for group in ("passing_strips", "kinematics_strips")}
        case "each" | "base":
            return {f"kinematics.{kind}": 1}
    return {f"kinematics.{kind}": 1, "kinematics.step": 1}


def _join(step: Join, kind: str, group: str) -> Features:
    grounded = step.a is None and kind != "floating"
    on_a = sum(coupling.side == "A" for coupling in step.couplings)
    across = sum(block.across for block in step.blocks)
    rows = block_rows(kind)
    return {
        f"{group}.{'ground' if grounded else kind}": 1,
        f"{group}.coupling_a": on_a,
        f"{group}.coupling_b": len(step.couplings) - on_a,
        f"{group}.block": rows * (len(step.blocks) - across),
        f"{group}.across": rows * across,
    }


def _without_joint(step: Step, joints: Sequence[PlanJoint]) -> Features | None:
    """Features of a step that does not depend on the joint; None for others."""
    if isinstance(step, Certify | Refine):
        return added(_weighed(joints[j]) for j in weighed_joints(step, len(joints)))
    if isinstance(step, Traverse):
        run = range(step.passage.first, step.passage.last + 1)
        return added({f"kinematics.{joints[j].kind}": 1} for j in run)
    if isinstance(step, Send | Receive | StartEmpty | GiveOutput | Correct):
        return {}
    plain = _PLAIN.get(type(step))
    return None if plain is None else {plain: 1}


def weighed_joints(step: Step, joints: int) -> Sequence[int]:
    """Return the joints of a residual sweep, once for each time; none of other steps.

    Args:
        step: a step of a plan.
        joints: how many joints the plan has.
    """
    if isinstance(step, Refine):
        return step.count * [*range(joints)]
    return (step.joints or range(joints)) if isinstance(step, Certify) else ()


def _weighed(joint: PlanJoint) -> Features:
    """Features of a joint in a residual sweep: those of forces through it, and a bias."""
    if joint.parent == 0 and joint.kind == "floating":
        return {"root.solve": 1, "link.bias": 1}
    return {f"deliver.{joint.kind}": 1, "link.bias": 1}


def _turned(group: str, key: str, turned: bool) -> Features:
    """Features of a joint with rotation into its own axes, which cost the same by columns."""
    return {f"{group}.{key}": 1, **({f"{group.split('_')[0]}.reversed": 1} if turned else {})}


_IN_PARTS: dict[type, Features] = {
    Articulate: {"parts.inwards": 1},  # unit wrenches carried along
    InvertRoot: {},
    Propagate: {},
    Deliver: {},
    Accelerate: {"parts.outwards": 1},
    Join: {},
    Disassemble: {},
    Load: {},
    AccelerateRoot: {},
}
_WEIGHED_IN_PARTS = {"parts.inwards": 0.8}
"""A joint of a chain in parts that is weighed, outwards and inwards: 0.8 of what it takes inwards,
unit wrenches included (measured with 200 to 1000 joints)."""
_OF_LEVELS = {"join": "parts.join", "disassemble": "parts.release"}
"""What the joins between parts take, level by level."""
_LANES = {2: "two", 4: "four"}


def operation_features(
    operation: Operation, joints: Sequence[PlanJoint], joins: str = "join"
) -> Features:
    """Return the features of an operation; none for a message.

    Args:
        operation: an operation of a program.
        joints: the joints of its plan.
        joins: the group that prices the plan's joins (``joins_of``).
    """
    block = operation.block
    if isinstance(block, Limbs):
        return _limbs_features(operation, block, joints)
    if operation.does == "certify" and operation.method == "parts":
        found = len(joints) * [_WEIGHED_IN_PARTS]
    elif operation.method == "parts":
        found = [_IN_PARTS[type(step)] for step in operation.steps]
        if operation.does in _OF_LEVELS:
            # Parts are as many as a power of two; what the ground holds takes no level of its own.
            levels = len(operation.steps).bit_length() - (len(operation.steps) % 2 == 0)
            found.append({_OF_LEVELS[operation.does]: levels})
    else:
        found = [_of_step(step, operation, joints, joins) for step in operation.steps]
    if isinstance(block, Run):
        if block.length % operation.lanes:
            found = [_of_rows(block.length, operation.lanes, added(found))]
        found.append(_run_features(operation, block, joints))
    return added(found)


def _of_rows(joints: int, lanes: int, found: Features) -> Features:
    """Features of joints side by side in lanes: those of whole rows."""
    share = -(-joints // lanes) * lanes / joints
    return {name: count * share for name, count in found.items()}


_RUNS = {
    ("articulate", "each"): "articulate.run",
    ("articulate", "turned"): "articulate.run",
    ("articulate", "columns"): "articulate_columns.run",
    ("articulate", "tiles"): "articulate_columns.run",
    ("kinematics", "each"): "kinematics.run",
    (PASSING, "each"): "kinematics.run",
    ("kinematics", "strips"): "kinematics_strips.run",
    ("kinematics", "traversed"): "kinematics_traversed.run",
    ("kinematics", "tiles"): "kinematics_strips.run",
    (PASSING, "strips"): "kinematics_strips.run",
    ("traverse", "each"): "kinematics.run",
    ("traverse", "strips"): "kinematics_strips.run",
    ("accelerate", "each"): "accelerate.run",
    ("accelerate", "along"): "accelerate.run",
    ("articulate", "parts"): "parts.run",
}


def _run_features(operation: Operation, run: Run, joints: Sequence[PlanJoint]) -> Features:
    """Features of a run beside its joints: once, and for each joint in own axes.

    A single joint on the ground is no run: it starts from nothing, hands nothing on, and is
    computed between other work.
    """
    found: Features = {}
    name = _RUNS.get((operation.does, operation.method))
    single = run.first == run.last and not run.reversed
    if name and not (single and joints[run.first].parent == 0):
        found[name] = 1
    if operation.method == "turned":
        found["articulate.turned"] = len(operation.steps)
    first, last = operation.steps[0], operation.steps[-1]
    if isinstance(last, Propagate) and operation.method in ("carried", "along"):
        from_ground = isinstance(first, Propagate) and first.near is None
        found["propagate_run.run"] = 1
        found["propagate_run.product"] = (0 if from_ground else 2) + len(last.spreads)
    return found


def added(parts: Iterable[Features]) -> Features:
    """Return the sum of several features."""
    total: Features = {}
    for part in parts:
        for name, count in part.items():
            total[name] = total.get(name, 0) + count
    return total


def _limbs_features(operation: Operation, limbs: Limbs, joints: Sequence[PlanJoint]) -> Features:
    """Features of limbs side by side: row by row, and once for all rows of a sweep."""
    does, lanes = operation.does, _LANES[limbs.lanes]
    inwards = does == "articulate"
    rows = [f"{does}_{lanes}.{joints[row[0]].kind}" for row in limbs.rows]
    grounded = all(joints[j].parent == 0 for j in limbs.rows[0])
    if inwards and grounded:
        rows[0] = "articulate.ground"
    found: list[Features] = [{name: 1} for name in rows]
    if inwards and not (grounded and len(rows) == 1):
        found.append({f"limbs.{lanes}": 1})
    if operation.nested:
        found.append({"limbs.nested_inwards" if inwards else "limbs.nested_outwards": 1})
    if operation.method == "turned":
        found.append({"limbs.turned": len(limbs.rows)})
    return added(found)


def _of_step(step: Step, operation: Operation, joints: Sequence[PlanJoint], joins: str) -> Features:
    """Features of a step by the method of its operation."""
    if isinstance(step, _SWEPT):
        return _of_joint(step, joints[step.joint], operation.method, operation.does)
    match step, operation.method:
        case Traverse(passage), "strips":
            run = range(passage.first, passage.last + 1)
            return added({f"passing_strips.{joints[j].kind}": 1} for j in run)
        case Propagate(), "carried":
            return {f"propagate_run.{joints[step.joint].kind}": 1}
        case Propagate(), "along":
            return {f"propagate_along.{joints[step.joint].kind}": 1}
        case Deliver(), "along":
            return {"deliver.along": 1}
        case Load(), "through":
            return {}
    return step_features(step, joints, joins)
