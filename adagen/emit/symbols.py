"""C++ names of a plan's joints, links and buffers."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

from adagen.emit.expressions import Printer
from adagen.emit.names import distinct, identifiers, quoted
from adagen.model.kinds import KINDS, JointKind
from adagen.plan import Plan
from adagen.plan.steps import Append, Bias, Block, Force, Load, Passage, Traverse, blocks_set_by
from adagen.program import Program
from adagen.program.lower import LOOPS
from adagen.schedule import step_costs
from adagen.schedule.costs import StepCosts


@dataclass(frozen=True)
class Symbols:
    """C++ names and number format of one plan."""

    program: Program
    refine: int = 0  # steps of refinement whose residuals are in wider numbers
    chunk: int = 0  # values of one function in shape unrolled; 0 for its default
    costs: StepCosts = field(default_factory=lambda: step_costs(None))  # what order goes by
    embedded: bool = False  # for a processor that may have no vectors of numbers

    @property
    def plan(self) -> Plan:
        """The plan that is carried out."""
        return self.program.plan

    @property
    def columns(self) -> int:
        """Number of right-hand sides of a step; loops compute them one after the other."""
        return 1 if self.program.shape == LOOPS else self.plan.right_hand_sides

    @property
    def batch(self) -> bool:
        """Whether SIMD lanes are for states."""
        return self.program.batch

    @cached_property
    def joints(self) -> tuple[str, ...]:
        """An identifier for each joint."""
        return identifiers(joint.name for joint in self.plan.joints)

    @cached_property
    def links(self) -> tuple[str, ...]:
        """An identifier for each link."""
        return identifiers(link.name for link in self.plan.links)

    @cached_property
    def passages(self) -> tuple[Passage, ...]:
        """Runs whose passages are computed."""
        return tuple(sorted({step.passage for step in self.plan.steps_of(Traverse, Append)}))

    def passage(self, passage: Passage) -> str:
        """Return the member of a passage."""
        return f"w.passages[{self.passages.index(passage)}]"

    @cached_property
    def printer(self) -> Printer:
        """Prints numbers of the plan's number type."""
        return Printer(self.plan.scalar)

    @cached_property
    def loaded(self) -> frozenset[int]:
        """Links that are loaded by handle forces."""
        return frozenset(step.link for step in self.plan.steps_of(Load))

    def kind(self, joint: int) -> JointKind:
        """A joint's kind."""
        return KINDS[self.plan.joints[joint].kind]

    def type_of(self, joint: int) -> str:
        """The C++ type of a joint's kind."""
        return self.kind(joint).name.capitalize()

    def memory(self, joint: int) -> str:
        """A joint's part of the workspace."""
        return f"w.j_{self.joints[joint]}"

    def link_memory(self, link: int) -> str:
        """The part of the workspace of a link: that of the joint above it."""
        return self.memory(link - 1)

    @cached_property
    def _members(self) -> dict[tuple[int, int], str]:
        """An identifier for each pair of handles: links "a", "b" and "a_b" must not clash."""
        targets = (block for step in self.plan.all_steps for block in blocks_set_by(step))
        pairs = sorted({(block.row != block.column, block.row, block.column) for block in targets})
        symbols = distinct(
            f"{self.links[row]}_{self.links[column]}" if apart else self.links[row]
            for apart, row, column in pairs
        )
        return {(row, column): word for (_, row, column), word in zip(pairs, symbols, strict=True)}

    def block_member(self, block: Block) -> str:
        """The member that holds a block in the memory of the joint that completed its chain."""
        return f"Phi_{self._members[block.row, block.column]}"

    def bare_block(self, link: int) -> str:
        """The constant with a bare link's block; distinct from the locals Phi_A and X_Phi_A."""
        return f"kPhi_{self.links[link]}"

    def inertia(self, link: int) -> str:
        """The constant with a link's spatial inertia."""
        return f"kInertia_{self.links[link]}"

    def block(self, block: Block) -> str:
        """A block, wherever it is stored."""
        if block.joint is None:
            return self.bare_block(block.row)
        return f"{self.memory(block.joint)}.{self.block_member(block)}"

    def bias(self, bias: Bias) -> str:
        """A bias; a bare link's is stored with the joint above the link."""
        if bias.joint is None:
            return f"{self.memory(bias.handle - 1)}.b"
        return f"{self.memory(bias.joint)}.b_{self.links[bias.handle]}"

    def force(self, force: Force) -> str:
        """An outer wrench."""
        return f"{self.memory(force.joint)}.{self.force_member(force)}"

    def force_member(self, force: Force) -> str:
        """The member that holds an outer wrench (not F_OK, which is a macro)."""
        return f"F_on_{self.links[force.handle]}"

    def quoted_joint(self, joint: int) -> str:
        """A joint's name as a string literal."""
        return quoted(self.plan.joints[joint].name)

    def span(self, first: int, last: int) -> str:
        """Joints first .. last by their names, for comments."""
        names = [self.quoted_joint(j) for j in dict.fromkeys((first, last))]
        return " .. ".join(names)

    def quoted_link(self, link: int) -> str:
        """A link's name as a string literal."""
        return quoted(self.plan.links[link].name)
