"""From a schedule to the steps of the assembly-disassembly algorithm, joint by joint (form `ada`).

Form `segment` uses the same tree walk and replaces the work of a single process (segment.py). The
schedule tree is walked once upwards (assembly, Eq. 3-7) and once downwards (disassembly,
Eq. 8-10). Every process does its steps in the order of one global walk, so that sends and receives
cannot deadlock.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from adagen.plan import steps as do
from adagen.plan.edges import on_the_way
from adagen.plan.fusions import Fusions, Run
from adagen.plan.messages import Message
from adagen.plan.robot import PlanJoint
from adagen.plan.steps import (
    Bias,
    BiasUpdate,
    Block,
    BlockUpdate,
    Coupling,
    Force,
    ForceUpdate,
    Step,
)
from adagen.plan.types import Process
from adagen.schedule import Node, Schedule, postorder
from adagen.schedule.tree import Gathered


@dataclass
class Chain:
    """A partial chain under construction: its handles, with their blocks and biases."""

    joint: int | None
    process: int
    blocks: dict[tuple[int, int], Block] = field(default_factory=dict)
    biases: dict[int, Bias] = field(default_factory=dict)
    parts: tuple[Chain, ...] = ()
    segment: object = None

    def block(self, g: int, h: int) -> Block | None:
        """Return Phi_gh's name, if the two handles are coupled."""
        return self.blocks.get((min(g, h), max(g, h)))


def bare(link: int, process: int) -> Chain:
    """Return a link by itself as a chain; the ground has no mobility."""
    if link == 0:
        return Chain(None, process)
    return Chain(None, process, {(link, link): Block(None, link, link)}, {link: Bias(None, link)})


def _united(joint: int, process: int, parts: tuple[Chain, Chain], gone: set[int]) -> Chain:
    """Two chains as one, without the joined handles, before the joint changes anything."""
    whole = Chain(joint, process, parts=parts)
    for part in parts:
        whole.blocks.update({k: block for k, block in part.blocks.items() if not gone & set(k)})
        whole.biases.update({h: bias for h, bias in part.biases.items() if h not in gone})
    return whole


def _couplings(sides: Iterable[tuple[str, Chain, int]], gone: set[int]) -> tuple[Coupling, ...]:
    """Couplings of a joint with the remaining handles, each side with its own link."""
    couplings = []
    for side, chain, at in sides:
        for h in sorted(chain.biases):
            source = chain.block(at, h)
            if source is not None and h not in gone:
                couplings.append(Coupling(h, side, source, transposed=h < at))
    return tuple(sorted(couplings, key=lambda coupling: coupling.handle))


def _updates(
    whole: Chain, couplings: Sequence[Coupling]
) -> tuple[tuple[BlockUpdate, ...], tuple[BiasUpdate, ...]]:
    """Updates of a chain's blocks and biases by its joint, with their new names."""
    i, blocks, biases = whole.joint, [], []
    for k, first in enumerate(couplings):
        for second in couplings[k:]:
            key = (first.handle, second.handle)
            target, across = Block(i, *key), first.side != second.side
            blocks.append(BlockUpdate(target, whole.blocks.get(key), across=across))
            whole.blocks[key] = target
    for coupling in couplings:
        h = coupling.handle
        biases.append(BiasUpdate(Bias(i, h), whole.biases[h], coupling.side))
        whole.biases[h] = Bias(i, h)
    return tuple(blocks), tuple(biases)


class AdaPlanner:
    """Builds the processes and messages of form `ada` from joints and a schedule."""

    def __init__(
        self, joints: tuple[PlanJoint, ...], schedule: Schedule, runs: Sequence[Run] = ()
    ) -> None:
        self.joints = joints
        self.schedule = schedule
        self.fusions = Fusions(schedule, runs)
        self.steps: list[list[Step]] = [[] for _ in range(schedule.processes)]
        self.owns: list[list[int]] = [[] for _ in range(schedule.processes)]
        self.messages: list[Message] = []
        self.asked: frozenset[int] = frozenset()  # links whose mobility is an output
        # joints at each link that are not assembled yet: the link is a handle while there are any
        self.open = [0] * (len(joints) + 1)
        for j, joint in enumerate(joints):
            self.open[joint.parent] += 1
            self.open[j + 1] += 1

    def tied_rows(self) -> tuple[int, ...]:
        """Return the constraints of loops that have right-hand sides."""
        return ()

    def gathered(self) -> Gathered | None:
        """Return the layout of gathering processes; None if they are joined, or one has all."""
        return None

    def plan(self) -> tuple[tuple[Process, ...], tuple[Message, ...]]:
        """Return every process's steps, and the messages between them."""
        top = self._assemble()
        self._disassemble(top)
        self._couple_slaved()
        processes = []
        for steps, owns in zip(self.steps, self.owns, strict=True):
            reads = on_the_way(self.joints, owns)
            kinematics = [do.Kinematics(j) for j in reads]
            processes.append(Process((*kinematics, *steps), reads, tuple(sorted(owns))))
        return tuple(processes), tuple(self.messages)

    # --- assembly ------------------------------------------------------------------------------

    def _assemble(self) -> Chain:
        chains: dict[int, Chain] = {}
        for node in postorder(self.schedule.root):
            i, p = node.joint, node.processes[0]
            self.owns[p].append(i)
            if self._inside(node) or self.fusions.inside(i):
                continue
            whole = self._segment(node)
            if whole is not None:
                chains[i] = whole
                continue
            parts = []
            run = self.fusions.run_at(i)
            for side, link in zip(self.fusions.sides(node), self._ends(run), strict=True):
                parts.append(self._bare(link, p) if side is None else chains.pop(side.joint))
            self._meet(p, (parts[0], parts[1]))
            chains[i] = self._join(run, p, parts[0], parts[1])
        return chains[self.schedule.root.joint]

    def _bare(self, link: int, process: int) -> Chain:
        """Return a bare link as a chain of a process, which finds its bias."""
        if link > 0:
            self.steps[process].append(do.LinkBias(link))
        return bare(link, process)

    def _inside(self, node: Node) -> bool:  # noqa: ARG002 (form ada has no segments)
        """Whether a node belongs to the segment of another node."""
        return False

    def _segment(self, node: Node) -> Chain | None:  # noqa: ARG002
        """Assemble a whole segment, if the node is the topmost of one."""
        return None

    def _release(self, chain: Chain, forces: dict[int, Force]) -> None:  # noqa: ARG002
        """Compute what is inside a segment, given the forces on its handles."""
        raise AssertionError("form ada has no segments")

    def _meet(self, process: int, parts: tuple[Chain, Chain]) -> None:
        """Send the parts of a join to the process that joins them."""
        for part in parts:
            if part.process != process and part.biases:
                self._message(assembled(part, part.process, process))

    def _message(self, message: Message) -> None:
        number = len(self.messages)
        self.messages.append(message)
        self.steps[message.source].append(do.Send(number))
        self.steps[message.target].append(do.Receive(number))

    def _ends(self, run: Run) -> tuple[int, int]:
        """The links that a joint, or a run of joints, connects."""
        return self.joints[run[0]].parent, run[-1] + 1

    def _join(self, run: Run, process: int, a: Chain, b: Chain) -> Chain:
        i = run[-1]
        parent, child = self._ends(run)
        self.open[parent] -= 1
        self.open[child] -= 1
        gone = {link for link in (parent, child) if self.open[link] == 0}
        couplings = _couplings((("A", a, parent), ("B", b, child)), gone)
        whole = _united(i, process, (a, b), gone)
        blocks, biases = _updates(whole, couplings)
        at_child = b.block(child, child)
        assert at_child is not None  # the child link is a handle of B until this very join
        join = do.Join(
            i,
            a.block(parent, parent),
            a.biases.get(parent),
            at_child,
            b.biases[child],
            couplings,
            blocks,
            biases,
            velocity_product=parent > 0,
        )
        self.steps[process].append(join if len(run) == 1 else do.FusedJoin(**vars(join), run=run))
        return whole

    # --- disassembly ---------------------------------------------------------------------------

    def _disassemble(self, top: Chain) -> None:
        stack: list[tuple[Chain, dict[int, Force]]] = [(top, {})]
        joins = {s.joint: s for steps in self.steps for s in steps if isinstance(s, do.Join)}
        while stack:
            chain, forces = stack.pop()
            if chain.segment is not None:
                self._release(chain, forces)
                continue
            i = chain.joint
            assert i is not None  # bare links are never pushed
            updates = []
            below = []
            join = joins[i]
            ends = self._ends(join.run if isinstance(join, do.FusedJoin) else (i,))
            for side, part, at in zip("AB", chain.parts, ends, strict=True):
                if part.joint is None:
                    continue
                inner = {h: forces[h] for h in part.biases if h in forces}
                if at > 0:
                    inner[at] = Force(part.joint, at)
                    updates.append(ForceUpdate(inner[at], forces.get(at), side))
                below.append((part, inner))
            outer = tuple(forces[coupling.handle] for coupling in join.couplings)
            for p in self._joining(chain):
                self.steps[p].append(do.Disassemble(i, outer, tuple(updates)))
            for part, inner in below:
                self._send_forces(chain, part, inner)
            stack.extend(reversed(below))

    def _joining(self, chain: Chain) -> Iterable[int]:
        """The processes that join a chain's parts."""
        return (chain.process,)

    def _send_forces(self, chain: Chain, part: Chain, forces: dict[int, Force]) -> None:
        """Send the forces on a part's handles to the process of the part."""
        if part.process == chain.process or not forces:
            return
        sent = tuple(forces[h] for h in sorted(forces))
        self._message(Message(chain.process, part.process, "disassembly", part.joint, forces=sent))

    # --- slaved joints -------------------------------------------------------------------------

    def coupled(self) -> set[int]:
        """Return the joints whose accelerations depend on each other: slaved ones and sources."""
        slaved = {j for j, joint in enumerate(self.joints) if joint.mimic is not None}
        sources = {joint.mimic[0] for joint in self.joints if joint.mimic is not None}
        return slaved | sources

    def _couple_slaved(self) -> None:
        """Process 0 solves for the coupling torques of slaved joints."""
        involved = self.coupled()
        if not involved:
            return
        owners = [p for p, owns in enumerate(self.owns) if owns]
        for p in owners:
            joints = tuple(sorted(involved.intersection(self.owns[p])))
            if p != 0 and joints:
                self._message(Message(p, 0, "slaved", None, joints=joints))
        self.steps[0].append(do.SolveCoupling())
        for p in owners:
            if p != 0:
                self._message(Message(0, p, "torques", None))
        for p in owners:
            self.steps[p].append(do.ApplyCoupling())


def assembled(chain: Chain, source: int, target: int) -> Message:
    """The message with the mobilities and biases of a chain."""
    named = (block for block in chain.blocks.values() if block.joint is not None)
    blocks = tuple(sorted(named, key=_block_key))
    biases = tuple(chain.biases[h] for h in sorted(chain.biases))
    return Message(source, target, "assembly", chain.joint, blocks=blocks, biases=biases)


def _block_key(block: Block) -> tuple[int, int, int]:
    return (-1 if block.joint is None else block.joint, block.row, block.column)
