"""Operations of a process in shape kernels: steps combined to loops over runs and limbs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from itertools import groupby, takewhile
from typing import Any

from adagen.plan import steps as do
from adagen.plan.edges import is_base
from adagen.plan.order import inward_order, outward_order
from adagen.plan.requested_outputs import needed_outwards
from adagen.plan.simd_groups import Limbs, placed_links
from adagen.plan.stages import stages
from adagen.plan.steps import Step
from adagen.plan.tip_mobility import Mentions, holds, mentions, tip_mobility_runs
from adagen.plan.types import Plan, Process
from adagen.program.names import PASSING
from adagen.program.parted_runs import PartedRuns, parts_joined
from adagen.program.runs import (
    OF_ONE_FREEDOM,
    Run,
    ends_of_run,
    links_of_run,
    outward_units,
    own_axes_in_loops,
    pays_columns,
    swept,
    units_of_sweep,
)
from adagen.program.slots import Slots
from adagen.program.strips import LANES, split
from adagen.program.types import Block, Links, Method, Operation
from adagen.schedule.costs import StepCosts

_BY_ROWS = frozenset({"traverse", "kinematics", "articulate", "accelerate"})
"""What is done row by row with a chain in parts, one joint of each part in a row."""


class Loops:
    """Combines the steps of one process to operations over runs, limbs and links.

    Args:
        plan: the plan.
        process: one of its processes.
        slots: where joints lie in memory.
        limbs: those that the process passes side by side.
        batch: whether SIMD lanes are for states.
        costs: what the methods take that a run can be passed by.
        again: whether sweeps are done again, for what is left over (refinement).
        named: the process's ``mentions``, if they are at hand.
    """

    def __init__(
        self,
        plan: Plan,
        process: Process,
        slots: Slots,
        limbs: Sequence[Limbs],
        batch: bool,
        costs: StepCosts,
        *,
        again: bool = False,
        named: Mentions | None = None,
    ) -> None:
        self.plan, self.process, self.slots, self.limbs = plan, process, slots, limbs
        self.batch, self.costs = batch, costs
        self.in_lanes = {j for each in limbs for j in each.members()}
        self.joints = plan.joints
        self.placed = placed_links(plan)
        starts = {step.link for step in process.steps_of(do.StartLink)}
        turned = own_axes_in_loops(plan, slots.limbs, batch)
        self.turned = turned.always
        self.told_apart = frozenset[int]() if holds(process) else turned.always | turned.if_lost
        self.own = starts - self.placed  # links whose own inertia the sweep adds as it passes them
        self.named = mentions(plan, process) if named is None else named
        self.through = self._passed_through()  # links that no load but a run's own reaches
        self.needed = needed_outwards(plan, process.steps, limbs)
        self.turning: set[int] = set()  # joints whose sines and cosines are known
        self.holding: set[int] = set()  # links at which an inertia has been left
        self.bare: set[int] = set()  # links whose own inertia is set up
        self.by_columns: set[int] = set()  # those of them that are set up by columns, too
        self.traversed: set[Run] = set()  # runs whose passages were found in strips
        self.swept: set[Run] = set()  # runs that are swept inwards by columns
        self.along: set[Run] = set()  # those that unit wrenches are carried through meanwhile
        self.loaded: set[Run] = set()  # of these, those whose joints take a load when they move
        self.parts = PartedRuns()
        # A sweep that is repeated with other forces leaves mobilities as they are.
        self.once = not (again or plan.slaved)
        self.found: list[Operation] = []
        self.stage = 0

    def operations(self) -> tuple[Operation, ...]:
        """Return the operations of the process in order."""
        together: dict[type, Callable[[list[Any]], None]] = {
            do.Kinematics: self._kinematics,
            do.Traverse: self._traverse,
            do.Append: self._put_together,
            do.Arrive: self._put_together,
            do.StartLink: self._link_inertias,
            do.StartEmpty: self._clear,
            do.FreeBase: self._free_bases,
            do.Articulate: self._articulate,
            do.InvertRoot: self._invert_roots,
            do.Propagate: self._propagate,
            do.Join: self._join,
            do.Disassemble: self._join,
            do.Load: self._load,
            do.Deliver: self._deliver,
            do.AccelerateRoot: self._accelerate_roots,
            do.Accelerate: self._accelerate,
            do.Certify: self._certify,
            do.FreeAcceleration: self._free_accelerations,
            do.Receive: self._receive,
        }
        for number, stage in enumerate(stages(self.process)):
            self.stage = number
            steps = self.process.steps[stage.first : stage.last]
            for kind, group in groupby(steps, type):
                if kind in together:
                    together[kind](list(group))
                else:
                    for step in group:
                        self._add(step.does, None, "step", (step,))
        return tuple(map(self._by_rows, self.found))

    def _by_rows(self, operation: Operation) -> Operation:
        """Tell of a sweep of a run that is in parts how many of its joints are side by side."""
        block = operation.block
        if operation.does in _BY_ROWS and isinstance(block, Run) and block in self.parts.runs:
            return replace(operation, lanes=LANES[self.plan.scalar])
        return operation

    def _add(
        self,
        what: str,
        block: Block | None,
        method: Method,
        steps: Iterable[Step] = (),
        first: Iterable[bool] = (),
    ) -> None:
        nested = isinstance(block, Limbs) and any(
            self.joints[j].parent - 1 in self.in_lanes for j in block.rows[0]
        )
        self.found.append(
            Operation(what, block, method, tuple(steps), self.stage, tuple(first), nested)
        )

    def _first(self, link: int) -> bool:
        """Whether an inertia is the first one at its link."""
        first = link not in self.holding
        self.holding.add(link)
        return first

    def _kinematics(self, steps: list[do.Kinematics]) -> None:
        joints = [step.joint for step in steps]
        if self.slots.tile:
            self._add("kinematics", Run(joints[0], joints[-1]), "tiles", steps)
            return
        self._prepare_angles(joints)
        for j in joints:
            if is_base(self.joints[j]):
                self._add("kinematics", Run(j, j), "base", [do.Kinematics(j)])
        for unit in outward_units(self.joints, joints, self.limbs, self.process.treated):
            if isinstance(unit, Limbs):
                self._add("kinematics", unit, "lanes", map(do.Kinematics, unit.members()))
                continue
            what = "kinematics" if unit.treated else PASSING
            for run, in_strips in split(unit.run, self.slots.in_strips):
                method: Method = "strips" if in_strips else "each"
                if run in self.traversed and unit.treated:
                    method = "traversed"
                self._add(what, run, method, map(do.Kinematics, range(run.first, run.last + 1)))

    def _prepare_angles(self, joints: Iterable[int]) -> None:
        wanted = tuple(j for j in joints if j not in self.turning)
        if wanted:
            self.turning.update(wanted)
            self._add("angles", Links(wanted), "each")

    def _traverse(self, steps: list[do.Traverse]) -> None:
        for step in steps:
            run = Run(step.passage.first, step.passage.last)
            self._prepare_angles(run.joints())
            method: Method = "strips" if run in self.slots.in_strips else "each"
            if method == "strips":
                self.traversed.add(run)
            self._add("traverse", run, method, [step])

    def _put_together(self, steps: list[do.Append | do.Arrive]) -> None:
        for step in steps:
            run = Run(step.passage.first, step.passage.last)
            self._add(step.does, run, "step", [step])

    def _link_inertias(self, steps: list[do.StartLink]) -> None:
        """Set up links when the first one of their blocks is needed: a block is set up at once.

        Set up again later, they would lose the outer forces that act on them.
        """
        if self.slots.tile:
            self._add("link_inertia", Links(tuple(step.link for step in steps)), "tiles", steps)
            return
        if not self.bare:
            starts = list(self.process.steps_of(do.StartLink))
            self.bare.update(step.link for step in starts)
            self._add("link_inertia", Links(tuple(s.link for s in starts)), "each", starts)
        for step in steps:
            if step.link in self.placed:
                first = self._first(step.link)
                self._add("place_inertia", Links((step.link,)), "step", (), [first])

    def _clear(self, steps: list[do.StartEmpty]) -> None:
        links = tuple(step.link for step in steps)
        self.holding -= set(links)  # what comes first takes its place
        self._add("clear_inertia", Links(links), "step", steps)

    def _free_bases(self, steps: list[do.FreeBase]) -> None:
        for step in steps:
            first = self._first(step.joint + 1)
            self._add("free_base", Run(step.joint, step.joint), "step", [step], [first])

    def _articulate(self, steps: list[do.Articulate]) -> None:
        if self.slots.tile:
            run = Run(steps[-1].joint, steps[0].joint)
            self._add("articulate", run, "tiles", steps, [self._first(self._near(run))])
            return
        by_joint = {step.joint: step for step in steps}
        swept_inwards = list(units_of_sweep(self.joints, steps, self.limbs, inward_order))
        self._find_parts(swept_inwards)
        columns: set[int] = set()
        for unit in swept_inwards:
            if isinstance(unit, Run) and unit not in self.parts and self._in_columns(unit):
                columns |= set(links_of_run(self.joints, unit)) - {self._near(unit)}
        self._set_up_columns(columns & self.own)
        for run, own in self.parts.of_joints(by_joint, Run.inwards):
            first = [self._first(self._near(part)) for part in self.parts.runs[run]]
            self._add("articulate", run, "parts", own, first)
        for unit in swept_inwards:
            if unit in self.parts:
                continue
            if isinstance(unit, Limbs):
                nears = [self.joints[j].parent for j in unit.rows[0]]
                first = [near > 0 and self._first(near) for near in nears]
                members = (by_joint[j] for row in reversed(unit.rows) for j in row)
                turned = not self.turned.isdisjoint(unit.members())
                method: Method = "turned" if turned else "lanes"
                self._add("articulate", unit, method, members, first)
                continue
            own = [by_joint[j] for j in unit.inwards()]
            if self._near(unit) == 0 and self.joints[unit.first].prescribed:
                # The ground moves as it does, and so does what it carries: nothing is computed.
                self._add("articulate", unit, "step", own)
                continue
            self._add("articulate", unit, self._method(unit), own, [self._first(self._near(unit))])

    def _find_parts(self, swept_inwards: Sequence[Limbs | Run]) -> None:
        """Find the runs that are parts of one run in all SIMD lanes."""
        if self.batch or not self.once or self.plan.corrections or not self.slots.in_strips:
            return
        units = {unit for unit in swept_inwards if not isinstance(unit, Limbs)}
        whole, carried = self._accelerated(), self._carried()
        for run in self.slots.in_strips:
            parts = parts_joined(run, LANES[self.plan.scalar], self.process.steps)
            # The last one may end the chain, and shows nothing at its end then.
            shown = carried.union(parts[-1:])
            if not parts or not units & whole & shown >= set(parts):
                continue
            links = range(run.first + 1, run.last + 2)
            alone = self.own.issuperset(links) and self.holding.isdisjoint(links)
            if alone and (self.told_apart | self.turned).isdisjoint(run.joints()):
                self.parts.runs[run] = parts

    def _carried(self) -> set[Run]:
        """Runs whose mobility is needed at the far link only."""
        found: set[Run] = set()
        for kind, steps in groupby(self.process.steps, type):
            if kind is do.Propagate:
                own = [step for step in steps if isinstance(step, do.Propagate)]
                for run in tip_mobility_runs(self.plan, own, self.named, self.told_apart):
                    first, last = sorted((run[0].joint, run[-1].joint))
                    found.add(Run(first, last, run[0].reversed))
        return found

    def _method(self, run: Run) -> Method:
        if self._in_columns(run):
            self.swept.add(run)
            return "columns"
        return "turned" if self._is_turned(run) else "each"

    def _is_turned(self, run: Run) -> bool:
        """Whether a run reads bodies in the links' own axes."""
        if self.joints[run.first].prescribed:
            return False
        far = {link - 1 for link in links_of_run(self.joints, run) if run.reversed}
        return not self.turned.isdisjoint({*range(run.first, run.last + 1), *far})

    def _near(self, run: Run) -> int:
        return ends_of_run(self.joints, run)[0]

    def _in_columns(self, run: Run) -> bool:
        if self.batch or self._is_turned(run):
            return False
        return pays_columns(self.joints, run, self.costs)

    def _set_up_columns(self, links: set[int]) -> None:
        """Set up the links of a run by columns that are not yet, and those among them."""
        wanted = links - self.by_columns
        if not wanted:
            return
        ranges = self.slots.ranges(link - 1 for link in wanted)
        among = {
            link
            for link in self.bare
            if any(a <= self.slots.slots[link - 1] <= b for a, b in ranges)
        }
        self.by_columns |= among
        self._add("link_columns", Links(tuple(sorted(among))), "columns")

    def _invert_roots(self, steps: list[do.InvertRoot]) -> None:
        for step in self.parts.keep_roots(steps):
            self._add(step.does, None, "step", (step,))

    def _propagate(self, steps: list[do.Propagate]) -> None:
        in_parts, steps = self.parts.propagated(steps)
        for run, own in in_parts:
            self._add("propagate", run, "parts", own)
        for chain in tip_mobility_runs(self.plan, steps, self.named, self.told_apart):
            if len(chain) > 1:
                first, last = sorted((chain[0].joint, chain[-1].joint))
                block = Run(first, last, chain[0].reversed)
                if block in self.swept and self.once and not block.reversed:
                    self.along.add(block)
                self._add("propagate", block, "along" if block in self.along else "carried", chain)
            else:
                self._add("propagate", None, "step", chain)

    def _join(self, steps: list[do.Join | do.Disassemble]) -> None:
        for run, own in self.parts.joined(steps, self.joints):
            if run is not None:
                self._add(own[0].does, run, "parts", own)
                continue
            for step in own:
                self._add(step.does, None, "step", (step,))

    def _accelerate_roots(self, steps: list[do.AccelerateRoot]) -> None:
        in_parts, steps = self.parts.at_links(steps, lambda part: {part.first})
        for run, own in in_parts:
            self._add("accelerate_root", run, "parts", own)
        for step in steps:
            self._add(step.does, None, "step", (step,))

    def _passed_through(self) -> frozenset[int]:
        """Links inside runs through which handle forces pass, without forces of their own."""
        delivered = list(self.process.steps_of(do.Deliver))
        inside: set[int] = set()
        ends: set[int] = set()
        for run in swept(self.joints, delivered):
            links = links_of_run(self.joints, run)
            inside.update(links)
            ends.update(ends_of_run(self.joints, run))
        forced = {step.link for step in self.process.steps_of(do.Load) if step.force is not None}
        return frozenset(inside - ends - forced)

    def _load(self, steps: list[do.Load]) -> None:
        through = [step for step in steps if step.link in self.through]
        if through:
            self._add("load", Links(tuple(step.link for step in through)), "through", through)
        forced = [step for step in steps if step.link not in self.through]
        in_parts, forced = self.parts.at_links(forced, lambda part: {part.first, part.last + 1})
        for run, own in in_parts:
            self._add("load", run, "parts", own)
        for step in forced:
            self._add("load", None, "step", [step])

    def _deliver(self, steps: list[do.Deliver]) -> None:
        by_joint = {step.joint: step for step in steps}
        whole = self._accelerated() if self.along else set()
        for run in swept(self.joints, steps):
            inside = set(links_of_run(self.joints, run)) - set(ends_of_run(self.joints, run))
            method: Method = "through" if inside and inside <= self.through else "each"
            plain = all(self.joints[j].kind in OF_ONE_FREEDOM for j in run.joints())
            if method == "through" and run in self.along & whole and plain:
                method = "along"
                self.loaded.add(run)
            if run in self.parts:
                method = "parts"
            self._add("deliver", run, method, (by_joint[j] for j in run.inwards()))

    def _accelerated(self) -> set[Run]:
        """Runs whose accelerations are all computed in one pass."""
        steps = list(self.process.steps_of(do.Accelerate))
        units = units_of_sweep(self.joints, steps, self.limbs, outward_order)
        return {u for u in units if isinstance(u, Run) and self.needed.issuperset(u.joints())}

    def _accelerate(self, steps: list[do.Accelerate]) -> None:
        by_joint = {step.joint: step for step in steps}
        for run, own in self.parts.of_joints(by_joint, Run.joints):
            self._add("accelerate", run, "parts", own)
        for unit in units_of_sweep(self.joints, steps, self.limbs, outward_order):
            if unit in self.parts:
                continue
            if isinstance(unit, Limbs):
                if not self.needed.isdisjoint(unit.members()):
                    members = (by_joint[j] for j in unit.members())
                    self._add("accelerate", unit, "lanes", members)
                continue
            outwards = reversed(unit.inwards())
            joints = list(takewhile(self.needed.__contains__, outwards))
            if joints:
                run = Run(min(joints), max(joints), unit.reversed)
                method: Method = "along" if run in self.loaded else "each"
                self._add("accelerate", run, method, (by_joint[j] for j in joints))

    def _free_accelerations(self, steps: list[do.FreeAcceleration]) -> None:
        for step in steps:
            if step.joint in self.needed:
                self._add(step.does, None, "step", (step,))

    def _certify(self, steps: list[do.Certify]) -> None:
        """A chain in parts is certified part by part, beside each other."""
        for step in steps:
            run = next(iter(self.parts.runs), None)
            self._add(step.does, run, "step" if run is None else "parts", [step])

    def _receive(self, steps: list[do.Receive]) -> None:
        for step in steps:
            links = self.plan.messages[step.message].inertias
            self._add("receive", None, "step", [step], [self._first(link) for link in links])
