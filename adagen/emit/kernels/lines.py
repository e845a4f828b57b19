"""The C++ lines of a process in shape kernels: calls of the runtime (adagen/kernels)."""

from __future__ import annotations

from adagen.emit import guards
from adagen.emit.forces import push_calls
from adagen.emit.kernels import messages, mobility, shared_bound
from adagen.emit.kernels.limb_spread import LimbSpread
from adagen.emit.kernels.residual_sweep import ResidualSweep, blocks_of, links_looked_at, word
from adagen.emit.processes import stamped
from adagen.emit.symbols import Symbols
from adagen.model import KINDS
from adagen.plan import steps as do
from adagen.plan.edges import is_base
from adagen.plan.passive import loaded
from adagen.plan.simd_groups import Limbs, placed_links
from adagen.plan.steps import Step
from adagen.plan.types import Process
from adagen.program import Links, Operation
from adagen.program.names import PASSING, PREPARED
from adagen.program.runs import Run, ends_of_run, links_of_run, parts_in, spans
from adagen.program.slots import Slots
from adagen.program.strips import split


class KernelLines:
    """The operations of one process as C++ lines.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        p: the process that the calls name; beyond the last one for what recovers.
        process: the process.
        operations: what it runs.
        slots: where joints lie in memory.
        turned: joints that are eliminated in their own axes.
    """

    def __init__(
        self,
        symbols: Symbols,
        p: int,
        process: Process,
        operations: tuple[Operation, ...],
        slots: Slots,
        turned: frozenset[int],
    ) -> None:
        self.symbols, self.p, self.process, self.slots = symbols, p, process, slots
        self.turned = turned
        self.operations = operations
        self.responded = False  # whether responses to slaved joints' torques are found
        self.joints = symbols.plan.joints
        self.placed = placed_links(symbols.plan)
        self.gathers = set(self.placed)  # links at which paths meet inwards
        self.parts: set[int] = set()  # links at which paths part outwards
        self.oriented: set[int] = set()  # joints whose quaternions are read
        self.columns: set[int] = set()  # links that are added to columns
        self.in_strips = tuple(  # runs that are passed outwards in strips
            op.block for op in operations if op.method == "strips" and isinstance(op.block, Run)
        )
        self.traversed = {op.block for op in operations if op.method == "traversed"}
        self.parted = {op.block for op in operations if op.method == "parts"}
        self.along = {
            op.block for op in operations if (op.does, op.method) == ("propagate", "along")
        }

    def all_lines(self) -> list[str]:
        """Return the lines of the process."""
        follows = ["slave(kJoints, w.q.data(), w.v.data());"] if self.symbols.plan.slaved else []
        return [
            *follows,
            *[f"take_passive(w, kPassive_{self.p});"] * bool(self.loaded["joints"]),
            *guards.checks(self.symbols, self.process),
            *self._reaches(),
            *stamped(self.process, self.operations, self._lines_in_turn),
            *guards.results(self.symbols, self.process),
        ]

    @property
    def loaded(self) -> dict[str, object]:
        """The joints with passive forces whose torques the process reads, and their freedoms."""
        joints = loaded(self.symbols.plan, self.process)
        freedoms = sum(KINDS[self.joints[j].kind].nv for j in joints)
        return {"process": self.p, "joints": joints, "freedoms": freedoms}

    def _reaches(self) -> list[str]:
        """Lines about accelerations that are known before all others, for certificates."""
        if not self.symbols.plan.weighed:
            return []
        falls = [f"reach_fall<{j}>(w);" for j, joint in enumerate(self.joints) if is_base(joint)]
        return ["reach_ground(w);", *falls]

    def corrections(self) -> list[str]:
        """Return the lines that repeat everything except motions and link inertias.

        So do the responses to slaved joints' torques.
        """
        again = [op for op in self.operations if op.does not in PREPARED or self._couples(op)]
        lines = [line for operation in again for line in self.lines(operation)]
        return [*lines, *guards.corrections(self.symbols, self.process)]

    def responses(self) -> list[str]:
        """Return the lines for other torques and link forces alone."""
        again = [op for op in self.operations if not (op.does in PREPARED or self._couples(op))]
        return [line for operation in again for line in self.lines(operation)]

    def _couples(self, operation: Operation) -> bool:
        """Whether an operation is about coupling torques of slaved joints."""
        for step in operation.steps:
            if isinstance(step, do.SolveCoupling | do.ApplyCoupling):
                return True
            if isinstance(step, do.Send | do.Receive):
                return self.symbols.plan.messages[step.message].joint is None
        return False

    def _lines_in_turn(self, operation: Operation) -> list[str]:
        """The lines of an operation, after those that the first one on slaved joints needs."""
        lines = self.lines(operation)
        if self._couples(operation) and not self.responded:
            self.responded = True
            return [f"find_responses(w, channel, respond_{self.p});", *lines]
        return lines

    def roles(self) -> list[dict[str, bool]]:
        """Return the role of the process at each link, once its lines are written.

        See LinkRole in templates/kernels.cpp.j2.
        """
        own = {s.link for s in self.process.steps if isinstance(s, do.StartLink)} - self.placed
        return [
            {
                "gathers": k in self.gathers,
                "adds_own": k in own,
                "parts": k in self.parts,
                "oriented": k - 1 in self.oriented,
            }
            for k in range(len(self.symbols.plan.links))
        ]

    def lines(self, operation: Operation) -> list[str]:
        """Return the lines of an operation."""
        if operation.method == "parts" and operation.does in mobility.OF_PARTS:
            return mobility.lines_of_parts(self.symbols, operation)
        write = getattr(self, f"_{operation.does}", None)
        if write is not None:
            return list(write(operation))
        (step,) = operation.steps
        return mobility.lines_of(self.symbols, self.p, step)

    def _angles(self, operation: Operation) -> list[str]:
        """Sines and cosines, and orientations from quaternions, as many at once as possible."""
        assert isinstance(operation.block, Links)
        joints = list(operation.block.numbers)
        turning = [j for j in joints if self.joints[j].kind not in ("spherical", "floating")]
        oriented = [
            j
            for j in joints
            if self.symbols.kind(j).quaternion is not None and not is_base(self.joints[j])
        ]
        self.oriented.update(oriented)
        return [
            *self._take_angles(joints),
            *(f"turn<{a}, {b}>(w);" for a, b in blocks_of(self.slots, turning)),
            *(f"orient<{self.p}, {a}, {b}>(w);" for a, b in blocks_of(self.slots, oriented)),
        ]

    def _take_angles(self, joints: list[int]) -> list[str]:
        """Copy the angles of revolute joints, as many at once as are adjacent."""
        if not self.slots.plain:
            return [
                f"take_angles{'_in_strips' * in_strips}<{run.first}, {run.last}>(w);"
                for span in spans(joints)
                for run, in_strips in split(Run(*span), self.slots.in_strips)
            ]
        copies: list[tuple[int, int, int]] = []  # joint, place in q, count
        for j in joints:
            kind = self.joints[j].kind
            if kind not in ("revolute", "planar"):
                continue
            q = self.joints[j].q + (2 if kind == "planar" else 0)
            if copies and copies[-1][0] + copies[-1][2] == j and sum(copies[-1][1:]) == q:
                j, q, count = copies[-1][0], copies[-1][1], copies[-1][2] + 1
                copies.pop()
            else:
                count = 1
            copies.append((j, q, count))
        return [f"std::copy_n(w.q + {q}, {n}, w.angle.data() + {j});" for j, q, n in copies]

    def _kinematics(self, operation: Operation) -> list[str]:
        block = operation.block
        if isinstance(block, Limbs):
            return [f"outward_group<{self._number(block)}>(w);"]
        assert isinstance(block, Run)
        if operation.method == "tiles":
            ends = f"{block.first}, {block.last}"
            return [
                f"Starts<{ends}> starts;",
                f"pass_tiles<{ends}>(w, starts);" + self._names(block),
            ]
        if operation.method == "base":
            return [f"free_base_frame<{block.first}>(w);"]
        verb = "pass_outward" if operation.does == PASSING else "outward"
        ends = f"{block.first}, {block.last}{', true' * (block in self.parted)}"
        if operation.method == "traversed":
            call = f"outward_traversed<{ends}>(w, starts_{block.first});"
            return [call + self._names(block)]
        in_strips = "_in_strips" * (operation.method == "strips")
        return [f"{verb}{in_strips}<{ends}>(w);" + self._names(block)]

    _pass_kinematics = _kinematics

    def _traverse(self, operation: Operation) -> list[str]:
        (step,), run = operation.steps, operation.block
        assert isinstance(step, do.Traverse)
        assert isinstance(run, Run)
        verb = "traverse" + "_in_strips" * (operation.method == "strips")
        own = self.symbols.passage(step.passage)
        found = f"const auto starts_{run.first} = " * (run in self.traversed)
        return [f"{found}{verb}<{run.first}, {run.last}>(w, {own});" + self._names(run)]

    def _append(self, operation: Operation) -> list[str]:
        (step,) = operation.steps
        assert isinstance(step, do.Append)
        whole, near, far = map(self.symbols.passage, (step.passage, step.near, step.far))
        return [f"{whole} = appended({near}, {far});"]

    def _arrive(self, operation: Operation) -> list[str]:
        (step,) = operation.steps
        assert isinstance(step, do.Arrive)
        name = self.symbols.quoted_link(step.passage.link)
        own = self.symbols.passage(step.passage)
        return [f"arrive<{step.near}, {step.passage.link}>(w, {own});  // {name}"]

    def _number(self, limbs: Limbs) -> str:
        return f"kLimbs{self.slots.numbers[limbs]}"

    def _link_inertia(self, operation: Operation) -> list[str]:
        assert isinstance(operation.block, Links)
        links = operation.block.numbers
        if operation.method == "tiles":
            return []  # each tile's where it is swept
        in_parts = {j for run in self.parted if isinstance(run, Run) for j in run.joints()}
        blocks = blocks_of(self.slots, (link - 1 for link in links if link - 1 not in in_parts))
        return [
            *(f"set_up_links<{a}, {b}>(w);" for a, b in blocks),
            *push_calls(self.symbols, links),
        ]

    def _place_inertia(self, operation: Operation) -> list[str]:
        assert isinstance(operation.block, Links)
        (link,) = operation.block.numbers
        name = self.symbols.quoted_link(link)
        return [f"place<{link}, {word(operation.first[0])}>(w);  // {name} itself"]

    def _link_columns(self, operation: Operation) -> list[str]:
        assert isinstance(operation.block, Links)
        blocks = blocks_of(self.slots, (link - 1 for link in operation.block.numbers))
        return [f"set_up_columns<{a}, {b}>(w);" for a, b in blocks]

    def _clear_inertia(self, operation: Operation) -> list[str]:
        assert isinstance(operation.block, Links)
        self.gathers |= set(operation.block.numbers)
        return []  # what comes first takes its place

    def _send(self, operation: Operation) -> list[str]:
        if shared_bound.tells(self.symbols, operation):
            limb_spread = LimbSpread(self.symbols, self.slots, self.operations)
            return shared_bound.told(self.symbols, limb_spread, self.process, operation)
        return messages.sent(self.symbols, operation)

    def _receive(self, operation: Operation) -> list[str]:
        if shared_bound.tells(self.symbols, operation):
            return shared_bound.heard(self.symbols, operation)
        return messages.received(self.symbols, operation)

    def _solve_coupling(self, _: Operation) -> list[str]:
        return messages.solved_coupling(self.symbols)

    def _apply_coupling(self, _: Operation) -> list[str]:
        return messages.applied_coupling(self.symbols, self.process)

    def _free_base(self, operation: Operation) -> list[str]:
        assert isinstance(operation.block, Run)
        joint = operation.block.first
        self.gathers.add(joint + 1)
        return [f"free_base<{joint}, {word(operation.first[0])}>(w);"]

    def _articulate(self, operation: Operation) -> list[str]:
        run = operation.block
        if isinstance(run, Limbs):
            return self._articulate_limbs(run, operation.first)
        assert isinstance(run, Run)
        if operation.method == "step":  # a prescribed joint on the ground
            return []
        if operation.method == "parts":
            return self._articulate_parts(operation, run)
        near = ends_of_run(self.joints, run)[0]
        self.gathers.add(near)
        if operation.method == "tiles":
            self.columns |= set(links_of_run(self.joints, run)) - {near}
            call = f"sweep_tiles<{run.first}, {run.last}>(w, starts);"
            return [call + self._names(run)]
        verb = "inward"
        if operation.method == "turned":
            verb = "inward_turned"
        elif operation.method == "columns":
            verb = "inward_in_columns"
            self.columns |= set(links_of_run(self.joints, run)) - {near}
        found = ""
        if run in self.along:
            verb, found = "inward_and_carry", f"const Way {mobility.way_of(run)} = "
        return [found + self._sweep(run, verb, word(operation.first[0])) + self._names(run)]

    def _articulate_parts(self, operation: Operation, run: Run) -> list[str]:
        """Sweep the parts of a run side by side; the mobility of each gets a variable."""
        assert all(operation.first)  # bodies are left, not added
        parts = parts_in(operation.steps)
        self.gathers.update(part.first for part in parts)
        sweep = f"inward_in_parts<{run.first}, {run.last}>(w);"
        return [f"const SweptParts {mobility.swept_parts(run)} = {sweep}{self._names(run)}"]

    def _articulate_limbs(self, limbs: Limbs, first: tuple[bool, ...]) -> list[str]:
        """Sweep limbs inwards and add the results to the links before them."""
        nears = [self.joints[j].parent for j in limbs.rows[0]]
        self.gathers.update(nears)
        verb = "inward_group" + "_turned" * (not self.turned.isdisjoint(limbs.members()))
        sweep = f"{verb}<{self.p}, {self._number(limbs)}>(w);"
        in_own = self.turned.issuperset(limbs.rows[0])  # as hands_own in groups_turned.hpp tells
        in_own &= not self.turned.isdisjoint(near - 1 for near in nears)
        leave = "leave_own" if in_own else "leave"
        left = [
            f"  {leave}<{word(first[k])}>(w, {near}, lane(X, {k + limbs.idle}));"
            for k, near in enumerate(nears)
            if near > 0
        ]
        return ["{", f"  const auto X = {sweep}", *left, "}"] if left else [sweep]

    def _propagate(self, operation: Operation) -> list[str]:
        return mobility.propagation(self.symbols, operation)

    def _deliver(self, operation: Operation) -> list[str]:
        assert isinstance(operation.block, Run)
        run = operation.block
        if operation.method == "parts":
            return []  # parts carry loads when they start outwards
        if operation.method == "along":
            call = f"deliver_along<{run.first}, {run.last}>(w, {mobility.way_of(run)}.moved);"
        else:
            call = mobility.delivery(self.symbols, run, through=operation.method == "through")
        return [call + self._names(run)]

    def _load(self, operation: Operation) -> list[str]:
        if operation.method in ("through", "parts"):
            return []  # nothing but what runs deliver, which their loops carry along
        return mobility.lines_of(self.symbols, self.p, operation.steps[0])

    def _solve_root(self, operation: Operation) -> list[str]:
        link = _link(operation.steps[0])
        reaches = [f"reach_root<{link}>(w);"] if self.symbols.plan.weighed else []
        return [f"solve_root<{self.p}, {link}>(w);", *reaches]

    def _solve_mobility(self, operation: Operation) -> list[str]:
        (step,) = operation.steps
        reaches = [f"reach_root<{_link(step)}>(w);"] if self.symbols.plan.weighed else []
        return [*mobility.lines_of(self.symbols, self.p, step), *reaches]

    def _certify(self, operation: Operation) -> list[str]:
        """Sweep the residuals of the equations of motion inwards, block by block."""
        (step,) = operation.steps
        if operation.method == "parts":
            assert isinstance(operation.block, Run)
            return mobility.weighed_parts(operation.block)
        self.parts |= links_looked_at(step)
        residual_sweep = ResidualSweep(self.symbols, self.p, self.slots)
        return residual_sweep.lines(step, self.operations)

    def _refine(self, operation: Operation) -> list[str]:
        """Residuals inwards and corrections outwards, as many times as asked."""
        lines = [*self._certify(operation), "begin_own_correction(w, k);"]
        for op in self.operations:
            if op.does == "accelerate":
                lines += self._accelerate(op)
            elif op.does == "free_acceleration":
                lines += self._free_acceleration(op)
            elif op.does == "solve_root" and self.symbols.plan.corrections > 1:
                lines.append(f"reach_root<{_link(op.steps[0])}>(w);")
        lines.append("end_own_correction(w);")
        return ["for (int k = 0; k < kRefine; ++k) {", *(f"  {line}" for line in lines), "}"]

    def _load_root(self, operation: Operation) -> list[str]:
        (step,) = operation.steps
        assert isinstance(step, do.LoadRoot)
        self.parts.add(step.link)
        kept = [f"keep_held(w, {step.link});"] if self.symbols.plan.weighed else []
        return [*kept, *mobility.lines_of(self.symbols, self.p, step)]

    def _accelerate(self, operation: Operation) -> list[str]:
        run = operation.block
        if isinstance(run, Limbs):
            self.parts |= {self.joints[j].parent for j in run.rows[0]}
            return [f"accelerate_group<{self.p}, {self._number(run)}>(w);"]
        assert isinstance(run, Run)
        if operation.method == "parts":
            weighed = self.symbols.plan.weighed
            return [mobility.accelerated_parts(run, weighed=weighed) + self._names(run)]
        self.parts.add(ends_of_run(self.joints, run)[0])
        verb = "accelerate" + "_along" * (operation.method == "along")
        return [self._sweep(run, verb) + self._names(run)]

    def _free_acceleration(self, operation: Operation) -> list[str]:
        joint = getattr(operation.steps[0], "joint", 0)
        self.parts.add(joint + 1)
        return [f"free_acceleration<{joint}>(w);"]

    def _sweep(self, run: Run, verb: str, *more: str) -> str:
        """The call by which the process sweeps a run; ``more`` arguments follow the run's ends."""
        prescribed = self.joints[run.first].prescribed
        name = f"{verb}{'_prescribed' * prescribed}{'_reversed' * run.reversed}"
        ends = (run.first,) if prescribed else (run.first, run.last)
        return f"{name}<{', '.join(map(str, (self.p, *ends, *more)))}>(w);"

    def _names(self, run: Run) -> str:
        """The joints of a run, as a comment."""
        return f"  // {self.symbols.span(run.first, run.last)}"


def _link(step: Step) -> int:
    return int(getattr(step, "link", 0))
