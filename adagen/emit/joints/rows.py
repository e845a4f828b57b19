"""Values of the template for each joint: its memory, and a function for each step."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from typing import Any

from adagen.emit import forces
from adagen.emit.joints import articulated, fused, joins
from adagen.emit.joints.fused import freedoms, type_of
from adagen.emit.joints.kinematics import kinematics_lines
from adagen.emit.symbols import Symbols
from adagen.plan import steps as do
from adagen.plan.steps import Bias, Block, Force, Step, biases_set_by, blocks_set_by

# Steps that are functions of a joint in emitted code, and what these are called.
VERBS: dict[type, str] = {
    do.Kinematics: "kinematics",
    do.Join: "assemble",
    do.FusedJoin: "assemble",
    do.Disassemble: "disassemble",
    do.FreeBase: "free_base",
    do.Articulate: "articulate",
    do.Propagate: "propagate",
    do.Deliver: "deliver",
    do.Accelerate: "accelerate",
    do.FreeAcceleration: "free_acceleration",
}

_LINES: dict[type, Callable[[Symbols, Any], list[str]]] = {
    do.FreeBase: articulated.free_base,
    do.Articulate: articulated.articulate,
    do.Propagate: articulated.propagate,
    do.Deliver: articulated.deliver,
    do.Accelerate: articulated.accelerate,
    do.FreeAcceleration: articulated.free_acceleration,
}


def function_of(symbols: Symbols, step: Step) -> str | None:
    """Return the name of the emitted function of a step, if it is a joint's."""
    verb = VERBS.get(type(step))
    joint = getattr(step, "joint", None)
    return None if verb is None or joint is None else f"{verb}_{symbols.joints[joint]}"


def joint_rows(symbols: Symbols) -> list[dict[str, object]]:
    """Return a row for each joint: names, memory, functions in the order of their first use."""
    plan = symbols.plan
    members = Members(symbols)
    functions: list[dict[str, dict[str, object]]] = [{} for _ in plan.joints]
    ends = {step.joint: step for step in plan.steps_of(do.Disassemble)}
    joined = {step.joint: step for step in plan.steps_of(do.Join)}
    for step in plan.steps:
        name = function_of(symbols, step)
        if name is not None:
            of_joint = functions[getattr(step, "joint", -1)]
            of_joint.setdefault(name, _function(symbols, step, name, joined, ends))
    return [
        {
            "id": f"j_{symbols.joints[j]}",
            "type": f"Joint_{symbols.joints[j]}",
            "quoted": symbols.quoted_joint(j),
            "kind": joint.kind,
            "parent_quoted": symbols.quoted_link(joint.parent),
            "child_quoted": symbols.quoted_link(j + 1),
            "members": members.lines[j],
            "functions": list(functions[j].values()),
        }
        for j, joint in enumerate(plan.joints)
    ]


def _function(
    symbols: Symbols,
    step: Step,
    name: str,
    joined: dict[int, do.Join],
    ends: dict[int, do.Disassemble],
) -> dict[str, object]:
    comment = ""
    match step:
        case do.Kinematics():
            lines = kinematics_lines(symbols, step.joint)
        case do.FusedJoin():
            comment = joins.parts(symbols, step, ends[step.joint])
            lines = fused.assembly(symbols, step)
        case do.Join():
            comment = joins.parts(symbols, step, ends[step.joint])
            lines = joins.assembly(symbols, step)
        case do.Disassemble():
            join = joined[step.joint]
            if isinstance(join, do.FusedJoin):
                lines = fused.disassembly(symbols, join, step)
            else:
                lines = joins.disassembly(symbols, join, step)
        case _:
            lines = _LINES[type(step)](symbols, step)
    return {"name": name, "comment": comment, "lines": lines}


def _of_started_link(symbols: Symbols, link: int) -> list[str]:
    return [
        f"Inertia IA;  // articulated-body inertia of link {symbols.quoted_link(link)}",
        "Columns6 pA;  // and its bias force",
        "Columns6 a;  // acceleration of the link, relative to free fall",
    ]


class Members:
    """Collects the members of every joint's memory from all processes' steps."""

    def __init__(self, symbols: Symbols) -> None:
        self.symbols = symbols
        plan = symbols.plan
        self.lines: list[list[str]] = [
            [
                f"Transform X;  // frame of {symbols.quoted_link(joint.parent)} to that of "
                f"{symbols.quoted_link(j + 1)}",
                f"Vec6 v;  // velocity of link {symbols.quoted_link(j + 1)}",
            ]
            for j, joint in enumerate(plan.joints)
        ]
        handle_forces: dict[int, set[Force]] = defaultdict(set)
        for step in plan.steps:
            self._add(step, handle_forces)
        for joint, named in handle_forces.items():
            for force in sorted(named):
                member = symbols.force_member(force)
                self.lines[joint].append(f"Columns6 {member};  // outer wrench on that chain")
        if plan.right_hand_sides > 1:
            for j, lines in enumerate(self.lines):
                lines.append(f"{forces.freedoms_type(symbols, j)} qdd;")

    def _add(self, step: Step, handle_forces: dict[int, set[Force]]) -> None:
        symbols = self.symbols
        for block in blocks_set_by(step):
            self._block(block)
        for bias in biases_set_by(step):
            self._bias(bias)
        match step:
            case do.LinkBias():
                name = symbols.quoted_link(step.link)
                self.lines[step.link - 1].append(f"Columns6 b;  // bias of the bare link {name}")
            case do.Join():
                self._joined(step)
            case do.Disassemble():
                for update in step.updates:
                    handle_forces[update.target.joint].add(update.target)
            case do.StartLink():
                self.lines[step.link - 1] += _of_started_link(symbols, step.link)
            case do.Articulate():
                self.lines[step.joint].append(f"{forces.body_type(symbols, step.joint)} body;")
            case do.Load():
                self.lines[step.link - 1].append("Columns6 load;  // what handle forces add")

    def _joined(self, step: do.Join) -> None:
        symbols = self.symbols
        kind = forces.joined_type(symbols, step.joint)
        if isinstance(step, do.FusedJoin):
            kind = type_of(symbols, step)
            run = f"Run<{freedoms(symbols, step)}> run;"
            self.lines[step.joint].append(f"{run}  // that it is joined with")
            if symbols.refine:
                own = f"Eigen::Matrix<Real, {freedoms(symbols, step)}, {freedoms(symbols, step)}>"
                self.lines[step.joint].append(f"{own} P;  // mobility along the run")
        self.lines[step.joint].append(f"Joined<{kind}> joined;")
        if symbols.plan.joints[step.joint].rotor_inertia:
            own = forces.freedoms_type(symbols, step.joint)
            self.lines[step.joint].append(f"{own} tau;  // drives rotor and joint")
        for coupling in step.couplings:
            handle = symbols.links[coupling.handle]
            self.lines[step.joint].append(f"Coupled<{kind}> at_{handle};")

    def _block(self, block: Block) -> None:
        assert block.joint is not None  # bare links' blocks are constants
        member = self.symbols.block_member(block)
        self.lines[block.joint].append(f"Mat6 {member};  // of the chain it completes")

    def _bias(self, bias: Bias) -> None:
        assert bias.joint is not None  # a bare link's bias belongs to the link
        self.lines[bias.joint].append(f"Columns6 b_{self.symbols.links[bias.handle]};")
