"""Runs the steps of a process over expressions.

Frames are the links' own, with every joint axis z: a joint's inertia D is an entry of a matrix, a
projected inertia has structural zeros, and link inertias are constants. Accelerations are
deviations from a reference field, the accelerations that the links would have with zero joint
accelerations: no velocity product and no gravity enters the sweeps. The reference is classical
(that of a point, not the spatial one), so no linear velocity is needed except a floating base's.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.certificate import Certificate
from adagen.executor.closed_certificate import ClosedCertificate
from adagen.executor.closures import Closures
from adagen.executor.corrections import Corrections
from adagen.executor.joins import Joins
from adagen.executor.kinematics import Motion
from adagen.executor.loop_constraints import LoopConstraints
from adagen.executor.outputs import Outputs
from adagen.executor.passages import Passages
from adagen.executor.repeatable import Repeatable
from adagen.executor.segments import Segments
from adagen.executor.state import Refining
from adagen.graph import Expression, Graph, Numbers, total
from adagen.plan import steps as do
from adagen.plan.messages import CERTIFICATE, ENERGIES, Message
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import ClosedStep, Step
from adagen.plan.types import Plan

Array = NDArray[Any]
RECEIVED = "w.from"
"""What names of inputs that messages bring begin with."""


class Machine(Repeatable):
    """One process: its state, and the execution of each step.

    Joints in one row (rows.py) are treated as one, whose values are wide.

    Attributes:
        sent: contents of the messages sent so far, without what is known beforehand.
        received: what messages have brought, by number.
    """

    def __init__(
        self,
        plan: Plan,
        mail: dict[int, list[Any]],
        refining: Refining = None,
        graph: Graph | Numbers | None = None,
        all_limbs: Sequence[Limbs] = (),
        steps: Sequence[Step] = (),
        unturned: Plan | None = None,
    ) -> None:
        super().__init__(plan, refining, graph, all_limbs, unturned)
        self.mail = mail
        self.sent: dict[int, list[Expression]] = {}
        self.motion = Motion(self)
        self.segments = Segments(self, self.motion)
        self.joins = Joins(self, self.motion)
        self.passages = Passages(self, self.motion)
        self.closures = Closures(self, self.motion, steps)
        self.corrections = Corrections(self, steps)
        self.bounds: ClosedCertificate | Certificate = (
            ClosedCertificate(self, self.corrections)
            if plan.closed
            else Certificate(self, self.motion, steps)
        )
        self.given_outputs = Outputs(self, self.motion)
        self.received: dict[int, dict[Any, Array]] = {}
        self.take_angles_of_rows()

    def again(self, steps: Sequence[Step]) -> Machine:
        """Return a machine that repeats steps in the same graph and lanes."""
        same = self.plan, self.mail, self.refining, self.graph, self.limbs
        found = Machine(*same, steps, self.unturned)
        found.angles, found.tangents = self.angles, self.tangents
        return found

    def step(self, step: Step) -> bool:
        """Execute one step; return False if it has to wait for a message."""
        match step:
            case do.Receive():
                return self._receive(step.message)
            case do.Send():
                self._send(step.message)
            case do.Kinematics():
                self.motion.kinematics(step.joint)
            case do.Traverse() | do.Append() | do.Arrive():
                self.passages.step(step)
            case do.LinkBias():
                self.joins.link_bias(step.link)
            case do.Join():
                self.joins.join(step)
            case do.Disassemble():
                self.joins.disassemble(step)
            case do.SolveCoupling():
                self._solve_coupling()
            case do.ApplyCoupling():
                self._apply_coupling()
            case do.GiveOutput():
                self.outputs[step.output] = self.given_outputs.output(step.output)
            case _ if isinstance(step, ClosedStep):
                self.closures.step(step)
                self._reach(step)
            case _:
                self._swept(step)
        return True

    def _swept(self, step: Step) -> None:
        """Execute a step inside a segment, or one that needs all of them."""
        match step:
            case do.Certify():
                self.bounds.carry_out(step)
                return
            case do.Correct():
                self.corrections.step(step)
                return
            case do.Refine():
                self.corrections.finish()
                return
        self.segments.step(step)
        self._reach(step)

    def _reach(self, step: Step) -> None:
        """Certificates use links' accelerations as they are computed, but not of corrections."""
        if not self.plan.certified or self.left is not None:
            return
        match step:
            case do.SolveRoot() | do.SolveMobility() | do.AccelerateRoot():
                self.bounds.reach(step.link - 1, root=True)
            case do.Accelerate(reversed=True):
                assert isinstance(self.bounds, Certificate)  # closed loops are one process's
                self.bounds.reach_back(step.joint)
            case do.Accelerate() | do.AccelerateHeld():
                self.bounds.reach(step.joint)

    @property
    def energies(self) -> list[Expression]:
        """Squared energy norms: of the answer, of all link accelerations, of each correction.

        Nothing where answers are not corrected.
        """
        return list(self.memory.get(("energies", 0), ()))

    def roots(self) -> list[Expression]:
        """All values that are needed: results, contents of messages, checks."""
        results = [x for values in self.results.values() for x in values]
        results += [x for values in self.forces.values() for x in values]
        contents = [x for content in self.sent.values() for x in content]
        pivots = [x for check in self.checks for x in (check.pivot, check.least)]
        given = [x for values in self.outputs.values() for x in values]
        lengths = (length for length, _ in self.lengths)
        energies = (*self.certificate, *self.energies)
        swept = [x for _, x, _ in self.swept.left] if self.swept else []
        return [*results, *given, *contents, *pivots, *lengths, *energies, *swept]

    # -- messages ---------------------------------------------------------------------------------

    def _items(self, message: Message) -> list[Any]:
        if message.sweep == "torques":
            return ["torques"]
        if message.sweep == ENERGIES:
            return [("energies", 0)]
        if message.sweep == CERTIFICATE:
            return [("share", message.source)]
        parted = [("bias", side) for side in message.sides]
        if message.repeats is not None:
            return [*message.biases, *(("pA", link) for link in message.inertias), *parted]
        accelerations = [("qdd", j) for j in message.joints]
        inertias = [(what, link) for link in message.inertias for what in ("IA", "pA")]
        passages = message.passages
        return [
            *passages,
            *(("placement", j) for j in message.placements),
            *message.blocks,
            *message.biases,
            *message.forces,
            *accelerations,
            *inertias,
            *(("square", side) for side in message.sides),
            *parted,
        ]

    def _send(self, number: int) -> None:
        message = self.plan.messages[number]
        machine = self._machine_of(message)
        memory, zero = machine.memory, self.graph.constant(0)
        for side in message.sides:
            square, bias = machine.closures.fronts[side.closure].shown(side.rows, zero)
            memory["square", side], memory["bias", side] = square, bias
        for j in message.placements:
            memory["placement", j] = self.motion.placement_of(j)
        items = [(item, memory[item]) for item in self._items(message)]
        content: dict[Expression, None] = {}
        for _, value in items:
            content.update(dict.fromkeys(x for x in value.flat if x.constant is None))
        places = {x: k for k, x in enumerate(content)}
        self.sent[number] = list(content)
        self.mail[number] = [
            (item, [[x.constant, places.get(x)] for x in value.flat], value.shape)
            for item, value in items
        ]

    def _receive(self, number: int) -> bool:
        """Read a message; inertias and bias forces are added to the process's own."""
        if number not in self.mail:
            return False
        message = self.plan.messages[number]
        machine = self._machine_of(message)
        added = {(what, link) for link in message.inertias for what in ("IA", "pA")}
        if message.sweep == ENERGIES and self.plan.messages[number].target == 0:
            added.add(("energies", 0))
        if message.repeats is not None:
            self.corrections.receive(self.received[message.repeats], added)
        for item, entries, shape in self.mail[number]:
            values = [
                self.graph.constant(known)
                if place is None
                else self.graph.input(f"{RECEIVED}[{number}][{place}]")
                for known, place in entries
            ]
            flat = np.empty(len(values), dtype=object)
            flat[:] = values
            value = flat.reshape(shape)
            memory = machine.memory
            memory[item] = memory[item] + value if item in added else value
            self.received.setdefault(number, {})[item] = value
        for j in message.placements if message.repeats is None else ():
            self.motion.take_placement(j, memory["placement", j])
        for side in message.sides:
            memory = machine.memory
            front = machine.closures.fronts[side.closure]
            front.take(memory["square", side], memory["bias", side])
        return True

    def _machine_of(self, message: Message) -> Repeatable:
        """The machine that a message belongs to: this one, or that of the current correction."""
        return self if message.repeats is None else self.corrections.current

    # -- slaved joints ----------------------------------------------------------------------------

    def _solve_coupling(self) -> None:
        """Solve A qdd = 0 for the coupling torques; a row is qdd_slaved - multiplier qdd_source.

        Rows of loops come behind these where they have right-hand sides, too.
        """
        rows = [
            self.memory["qdd", slaved][0] - self.memory["qdd", source][0] * multiplier
            for slaved, source, multiplier in self.plan.following
        ]
        if self.plan.closed and self.closures.solves_at_end:
            tied = LoopConstraints(self, self.motion, self.closures.fronts[0])
            self.memory["torques"] = tied.solve(rows, list(self.plan.slaved))
            front = self.closures.fronts[0]
            front.forces = {u: front.found[u].item() for u in self.plan.tied_rows}
            return
        a = np.array(rows, dtype=object)
        factors = self.factorize(a[:, 1:], self.plan.slaved[0])
        self.memory["torques"] = factors.solve(-a[:, :1])[:, 0]

    def _apply_coupling(self) -> None:
        torques = self.memory["torques"]
        for name, qdd in list(self.memory.items()):
            if isinstance(name, tuple) and name[0] == "qdd" and self.plan.wants(name[1]):
                self.results[name[1]] = np.array(
                    [total([row[0], *(row[1:] * torques)]) for row in qdd], dtype=object
                )
