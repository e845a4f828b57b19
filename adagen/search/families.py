"""Candidates of all families, compared by predicted time in the emitted shape.

* ``alone``: one process does everything.
* ``parts``: likewise, a long chain of hinges in parts, one in each SIMD lane (chain_parts.py).
* ``gathered``: processes gather at a core (layouts.py), searched by branch and bound; two of a
  long serial chain at the link that follows from what joints take (chain_halves.py).
* ``joined``: processes are joined at cuts: what the search by steps finds at its own prices, and at
  those that are played (joined.py).
* ``exchanged``: of long serial chains, with both sides of each cut joining it (chain_exchange.py);
  each process has its own joints in parts, or not.
* ``balanced``, ``sequential``, ``middle-out``: schedules that have a name (named.py), of robots of
  some tens of joints, where they cut no joint that loses digits.

Each is a candidate in loops. Those of one process, those that joins and names give, and the layouts
that come nearest to the best are candidates as straight lines of statements, too. So the fastest of
all is known before bounds are asked for: these are on all loops, and rule out what is slower.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import get_args

from adagen.cost import Timeline, timeline
from adagen.emit.shapes import offered, priced_program
from adagen.model import Model
from adagen.paper.restricted import joined_between_processes
from adagen.plan import Plan, can_gather, make_plan
from adagen.plan.certificate import certified
from adagen.plan.types import Process
from adagen.program import Program
from adagen.program.lower import LOOPS
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.fold import Fold
from adagen.schedule.tree import Named
from adagen.search.chain_exchange import ChainExchange, numbers_of_processes
from adagen.search.chain_halves import ChainHalves
from adagen.search.chain_parts import keeps_digits, parted
from adagen.search.even_shares import halves
from adagen.search.incumbent import Spent
from adagen.search.joined import LONG, JoinedBound
from adagen.search.joint_bounds import JointBounds
from adagen.search.layout_bounds import Bounds
from adagen.search.layout_search import GatheredSearch
from adagen.search.layouts import Layout, LayoutPrices
from adagen.search.limbs import Robot
from adagen.search.named import named_schedule
from adagen.search.price import Pricing, played
from adagen.search.whole_limb_bounds import WholeLimbBounds

_FULL = 128
"""Joints up to which a robot gets all expansions, and schedules by name are looked at."""
_FEWEST = 64  # expansions that any robot gets
_JOINTS = 8
"""Joints that may be priced in shares of processes for each expansion."""

_EVEN = 2
"""Layouts that share straight lines out evenly which are looked at."""
_NEAR, _NEARLY = 8, 1.2
"""Share of the budget that is spent on layouts that are nearly as fast in loops, and how fast.

Straight lines that are not as near to the fastest loops have not been the fastest of any robot.
"""

_ROUNDED = 1e-5  # microseconds that sums of rounded times may be off


def scaled(expansions: int, joints: int) -> int:
    """Return how many expansions a robot gets, each of which costs as much as it has joints."""
    return min(expansions, max(_FEWEST, expansions * _FULL // joints))


class Families:
    """The best candidate so far, of all families that were looked at.

    Args:
        model: the robot.
        seen: the robot as cuts see it.
        processes: P.
        profile: a profile with the costs of steps.
        expansions: what each search may spend, for a robot of some tens of joints.
        scalar: "double" or "float".
        shape: of the code that is emitted, "auto" for that of least price.
        parts: in how many parts a process may sweep a long chain of its own; 0: not in parts.
        certify: whether plans are priced with the bound of their errors.
    """

    def __init__(
        self,
        model: Model,
        seen: Fold,
        processes: int,
        profile: CostProfile,
        expansions: int,
        scalar: str = "double",
        shape: str = "auto",
        parts: int = 0,
        *,
        certify: bool = False,
    ) -> None:
        self.model, self.seen, self.processes = model, seen, processes
        self.profile, self.costs, self.shape = profile, profile.measured, shape
        self.scalar, self.parts, self.certify = scalar, parts, certify
        self.most, self.expansions = expansions, scaled(expansions, len(model.joints))
        self.topology = Topology.of(model)
        self.best: Schedule | None = None
        self.least = self._loops = float("inf")
        self.names: list[str] = []
        self.candidates = self.expanded = self.straight_lines = 0
        self.bounds: list[float] = []
        self._priced: Pricing | None = None
        self._whole_limbs: WholeLimbBounds | None = None  # as soon as layouts are looked at
        self._tried: set[tuple[Process, ...]] = set()
        self._straight: list[float] | None = None  # what each joint takes of one process

    @property
    def loops(self) -> bool:
        """Whether what is emitted may be loops, which is what layouts are priced as."""
        return self.shape in ("auto", "kernels")

    def consider(self, schedule: Schedule, family: str) -> None:
        """Play a schedule of a family in each shape, and keep it if none was as fast."""
        self._name(family)
        self.candidates += 1
        self.expanded += schedule.expanded
        self._try(schedule)

    def part(self, cuttable: Sequence[bool]) -> None:
        """Look at the chain of one process in parts, which it sweeps at once.

        Args:
            cuttable: for each joint whether mobilities may meet there.
        """
        assert self.best is not None  # one process comes first
        found = parted(self.best, self.model, self.parts if self.loops else 0)
        if found is not None and keeps_digits(found, self.model, cuttable):
            self.consider(found, "parts")

    def _try(self, schedule: Schedule) -> None:
        plan = self._planned(schedule)
        plan = certified(plan) if self.certify else plan
        if plan.processes in self._tried:
            return
        self._tried.add(plan.processes)
        for shape in offered(plan, self.profile) if self.shape == "auto" else (self.shape,):
            program = priced_program(plan, shape, self.profile)
            line = timeline(program, self.profile)
            if program.shape == "unrolled":
                self.straight_lines += 1
                self._straight = self._straight or self._by_joint(program, line)
            if line.makespan < self.least:
                loads = tuple(line.busy(p) for p in range(self.processes))
                self.best = replace(schedule, makespan=line.makespan, loads=loads)
                self.least = line.makespan
            if program.shape == LOOPS:
                self._loops = min(self._loops, line.makespan)
                if line.makespan > _NEARLY * self._loops:
                    break  # its straight line would hardly be the fastest

    def _planned(self, schedule: Schedule) -> Plan:
        return make_plan(self.model, schedule, scalar=self.scalar)

    def _by_joint(self, program: Program, line: Timeline) -> list[float]:
        """What each joint takes of a straight line of one process."""
        found = [0.0] * len(self.topology)
        for interval in line.intervals:
            if interval.operation is not None:
                (step,) = program.processes[interval.process].operations[interval.operation].steps
                joint = getattr(step, "joint", getattr(step, "link", 0) - 1)
                found[max(joint, 0)] += interval.end - interval.start
        return found

    def _name(self, family: str) -> None:
        if family not in self.names:
            self.names.append(family)

    def exchange(self, cuttable: Sequence[bool]) -> None:
        """Look at schedules of serial chains whose processes exchange pair by pair.

        Args:
            cuttable: for each joint whether processes may meet there.
        """
        if not (can_gather(self.model) and self.loops and self.seen.trivial):
            return
        assert self.best is not None  # one process comes first
        for parts in (0, self.parts) if self.parts else (0,):
            counts = numbers_of_processes(self.topology, self.processes, parts)
            asked = self.topology, self.profile, cuttable, self.best.tie, parts
            if counts:
                self._exchange_in(ChainExchange(*asked), counts, cuttable)

    def _exchange_in(
        self, chains: ChainExchange, counts: Sequence[int], cuttable: Sequence[bool]
    ) -> None:
        """Look at such schedules, on some numbers of processes, the largest first."""
        for count in counts:
            if chains.least(self.processes, count) >= self.least:
                continue  # messages take longer than they save
            found = chains.best(self.processes, count, self._played)
            # Parts are cut where they end.
            if found is not None and keeps_digits(found, self.model, cuttable):
                self.consider(found, "exchanged")
        self.bounds.append(min(chains.least(self.processes, count) for count in counts))

    def halve(self, cuttable: Sequence[bool]) -> None:
        """Look at schedules of long serial chains whose two processes gather.

        Args:
            cuttable: for each joint whether mobilities may meet there.
        """
        assert self.best is not None  # one process comes first
        chains = ChainHalves(self.topology, self.profile, cuttable, self.best)
        if not (self.loops and self.seen.trivial and chains.fits):
            return
        bound = chains.least(self.processes)
        self.bounds.append(bound)
        for told in (True, False) if bound < self.least else (False,):
            found = chains.best(told, self._played)
            if found is not None:
                self.consider(found, "gathered")

    def _played(self, schedule: Schedule) -> tuple[Program, Timeline]:
        program = priced_program(self._planned(schedule), "kernels", self.profile)
        return program, timeline(program, self.profile)

    def name(self, cuttable: Sequence[bool]) -> None:
        """Look at the schedules that have a name, where they are soon priced.

        Args:
            cuttable: for each joint of the folded robot whether processes may meet there.
        """
        if len(self.topology) > _FULL:
            return
        named: list[tuple[float, int, Schedule]] = []
        for k, name in enumerate(get_args(Named)):
            found = named_schedule(name, self.seen.topology, self.processes, profile=self.profile)
            if all(cuttable[j] for j in joined_between_processes(found.root)):
                found = self.seen.unfold(found, self.profile)
                time = played(self.model, found, self.profile, self.scalar)
                named.append((time, k, found))
        self.candidates += len(named)
        self.names += [str(found.strategy) for _, _, found in named]
        if named:
            self._try(min(named)[2])

    def gather(self, cuttable: Sequence[bool]) -> None:
        """Search the layouts whose processes gather.

        Args:
            cuttable: for each joint whether mobilities may meet there without losing digits. Only a
                root with the ground beyond it shows a mobility; elsewhere inertias are added.
        """
        assert self.best is not None  # one process comes first
        pricing = self._pricing(self.best)
        robot = Robot(pricing.joints)
        joint_bounds = JointBounds(robot, self.costs, whole=True)
        self._whole_limbs = joint_bounds.whole_limbs
        bounds = Bounds(robot, joint_bounds, self.processes, self.costs, pricing.channel)
        floating = [robot.trees[robot.tree_of[j]].base is not None for j in range(len(cuttable))]
        roots = [False, *(f or c for f, c in zip(floating, cuttable, strict=True))]
        prices, spent = LayoutPrices(robot, pricing), Spent(_JOINTS * self.most)
        search = GatheredSearch(prices, bounds, roots, spent)
        self._name("gathered")
        search.start()
        layouts = [layout for _, _, layout in search.found.nearest]
        if self._straight is not None:
            layouts += search.even(self._straight, _EVEN)
        self._try_layouts(layouts, robot)
        best, left_over = search.found.best, False
        if self.loops:
            search.run(self.least)
            self.bounds.append(search.lower)
            best, left_over = search.found.best, search.left_over
        if self._straight is not None and not left_over:
            self._look_near(search)
        fewer = self._on_fewer(prices, bounds, roots, best, left_over)
        self._try_layouts(fewer + [layout for _, _, layout in search.found.nearest], robot)
        self.candidates += search.found.candidates
        self.expanded += spent.expanded

    def _look_near(self, search: GatheredSearch) -> None:
        """Search layouts that are nearly as fast in loops: their straight lines may be faster."""
        spent = search.spent
        spent.limit = spent.spent + _JOINTS * self.most // _NEAR
        search.run(_NEARLY * self.least)

    def _on_fewer(
        self,
        prices: LayoutPrices,
        known: Bounds,
        roots: Sequence[bool],
        best: float,
        left_over: bool,
    ) -> list[Layout]:
        """Return layouts of half as many processes, a quarter, and so on, to be played.

        Those that are faster in loops are among the layouts of a search that ended. Where its
        budget struck, those of fewer processes are searched by themselves: more processes are not
        to be slower. For the same reason those that are nearly as fast are looked at, as they are
        where there are no more processes.

        Args:
            prices: prices of layouts.
            known: bounds on layouts of all processes.
            roots: for each link whether processes may meet around it; length N + 1.
            best: the least time in loops so far.
            left_over: whether the search on all processes did not end.
        """
        found: list[Layout] = []
        for working in halves(self.processes)[1:]:
            spent = Spent(_JOINTS * self.most)
            channel = prices.pricing.channel
            bounds = Bounds(prices.robot, known.joint_bounds, working, self.costs, channel)
            fewer = GatheredSearch(prices, bounds, roots, spent)
            near = []
            if self._straight is not None:
                fewer.start()
                near += fewer.found.nearest
            if left_over:
                fewer.run(best)
                best, left_over = min(best, fewer.found.best), fewer.left_over
            if self._straight is not None and not left_over:
                self._look_near(fewer)
            near += fewer.found.nearest
            found += [layout for time, _, layout in near if time < _NEARLY * self.least]
            self.candidates += fewer.found.candidates
            self.expanded += spent.expanded
        return found

    def _try_layouts(self, layouts: Iterable[Layout], robot: Robot) -> None:
        """Play layouts in each shape."""
        assert self.best is not None  # one process comes first
        for layout in layouts:
            gathered = layout.gathered(robot)
            self._try(replace(self.best, meeting="gather", gathered=gathered))

    def bound_joined(self, cuttable: Sequence[bool]) -> None:
        """Bound what processes can do that are joined, and look at what may be faster.

        Args:
            cuttable: for each joint of the folded robot whether processes may meet there.
        """
        assert self.best is not None  # one process comes first
        if not self.loops:
            return
        tie = self.best.tie
        bound = JoinedBound(
            self.model,
            self.seen,
            self.processes,
            self.profile,
            self._pricing(self.best),
            cuttable,
            self._whole_limbs,
        )
        enough = min([self.least, *self.bounds])
        lower, spent, made = bound.lower(self.least, enough, self.expansions, tie)
        self.expanded += spent
        self.bounds.append(lower)
        if lower < self.least:
            if made is not None and len(self.topology) <= LONG:  # else less than what is found
                self.consider(made, "joined")
            for working in halves(self.processes):
                self.consider(bound.found(tie, self.expansions, working), "joined")

    def _pricing(self, schedule: Schedule) -> Pricing:
        if self._priced is None:
            self._priced = Pricing(self._planned(schedule), self.profile)
        return self._priced

    @property
    def settled(self) -> bool:
        """Whether the best so far is done before processes could exchange anything."""
        return self.least <= self._exchange()

    def _exchange(self) -> float:
        """The least that processes take which exchange anything, in any shape; microseconds."""
        fastest = max(self.costs.speeds(self.processes))
        begin = min(self.costs["process.evaluation"], self.costs["unrolled.evaluation"]) / fastest
        return begin + self.costs.channel("auto").latency

    def taken(self) -> Schedule:
        """Return the candidate that is emitted the fastest, with what is known of it.

        Loops are bounded by the searches of all families; of straight lines, and of shapes that are
        asked for, it is known that whoever exchanges anything waits for a message.
        """
        assert self.best is not None  # one process can do everything
        lower = min([self.least, *(self.bounds if self.loops else [self._exchange()])])
        if lower > self.least - _ROUNDED:
            lower = self.least
        return replace(
            self.best,
            lower_bound=lower,
            expanded=self.expanded,
            families=tuple(self.names),
            candidates=self.candidates,
            straight_lines=self.straight_lines,
        )
