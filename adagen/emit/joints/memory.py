"""Memory of each joint in a process: the members of its part of the workspace."""

from __future__ import annotations

from collections import defaultdict

from adagen.emit import forces
from adagen.emit.joints.fused import freedoms, type_of
from adagen.emit.symbols import Symbols
from adagen.plan import steps as do
from adagen.plan.steps import Bias, Block, Force, Step, biases_set_by, blocks_set_by


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
