"""Serial chains whose processes exchange pair by pair (adagen/plan/exchange.py): their cuts.

Pairs of processes meet level by level, so each waits for the slowest of those that it meets. The
parts are cut so that all processes are done with their first sweep at once. That takes a few
plays: what a process needs apart from its own joints follows from the play before. The first play
also tells how many groups are to put their passages together at once.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import accumulate

from adagen.cost import Timeline
from adagen.plan import Plan
from adagen.plan.parts import FEWEST_ROWS
from adagen.plan.sent_passages import PASSED
from adagen.plan.stages import stages
from adagen.plan.steps import Append, Arrive, Disassemble, InvertRoot, Join
from adagen.program import Program
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.chains import WHOLE, Chain, Chains
from adagen.schedule.costs import PRESCRIBED, StepCosts
from adagen.schedule.search_result import Found
from adagen.schedule.tree import Tie
from adagen.schedule.tree_draft import Draft
from adagen.search.chain_parts import MOST_JOINTS
from adagen.search.even_shares import halves
from adagen.search.segment_pareto import put_segment

_FEWEST = 2
"""Joints of a part at least, by which this family is defined."""
_PLAYS = 4
_MOST_AT_ONCE = 8
"""Groups of processes that put passages together at once, at most: each sends to all others."""
_FINE = 1e-4  # microseconds to which parts are equally long

_BESIDE = frozenset(step.does for step in (Append, Arrive, Disassemble, InvertRoot, Join))
"""What processes do beside their own joints, for a bound."""

Play = Callable[[Schedule], tuple[Program, Timeline]]
"""Makes a schedule's program and plays it."""


def numbers_of_processes(topology: Topology, processes: int, parts: int = 0) -> list[int]:
    """Return the numbers of processes to try for exchanges: all, half of them, ...

    Args:
        topology: the robot.
        processes: P.
        parts: in how many parts each process sweeps its own joints at once; 0: not in parts.
    """
    counts = halves(processes) if topology.is_chain and processes > 1 else []
    joints = len(topology)
    if parts:  # each has them, by which this family is defined
        return [n for n in counts if FEWEST_ROWS * parts * n <= joints <= MOST_JOINTS * n]
    # The joint of a cut is in neither part.
    return [n for n in counts if joints >= (_FEWEST + 1) * n - 1]


class ChainExchange:
    """Schedules of a serial chain with one part for each process.

    Args:
        topology: the robot.
        profile: a profile with the costs of steps.
        cuttable: for each joint whether processes may meet there.
        tie: the preference among equals, for schedules.
        parts: in how many parts each process sweeps its own joints at once (adagen/plan/parts.py);
            0: not in parts.
    """

    def __init__(
        self,
        topology: Topology,
        profile: CostProfile,
        cuttable: Sequence[bool],
        tie: Tie,
        parts: int = 0,
    ) -> None:
        self.topology, self.profile, self.tie, self.parts = topology, profile, tie, parts
        self.chains = Chains(topology, profile)
        # The joint of a cut is in neither part, and no part is empty.
        self.cuts = [j for j in range(1, len(topology) - 1) if cuttable[j]]
        kinds = [topology.kind(j) for j in range(len(topology))]
        self.costs = profile.measured
        self.kinds = kinds
        # Whether passages are told, which begin beyond the base: then each process has some.
        passed = [topology.priced_as(j) in PASSED for j in range(len(topology))]
        base = max((j + 1 for j, fits in enumerate(passed) if not fits), default=0)
        self.cuts = _of_full_rows(self.cuts, base, parts)
        self._told = base < (FEWEST_ROWS * parts or _FEWEST)
        rates = tangents(topology, self.costs)
        self._tangents = sum(rates)
        self.inner, self.outermost = (
            [
                0.0,
                *accumulate(
                    self._first_sweep(kind, last) + rate
                    for kind, rate in zip(kinds, rates, strict=True)
                ),
            ]
            for last in (False, True)
        )
        free = ("floating", PRESCRIBED)
        known = (j for j in range(len(topology)) if topology.priced_as(j) not in free)
        self._counted = kinds[base:] if self._told else [kinds[j] for j in known]
        self._alike = self._told and len(set(self._counted)) == 1
        self._own = {kind: self._both_sweeps(kind, False) for kind in set(self._counted)}
        shares = (self._both_sweeps(kind, True) / own for kind, own in self._own.items())
        self._share = min(shares, default=1.0)
        self._beside: dict[int, float] = {}

    def least(self, processes: int, count: int) -> float:
        """Return a lower bound on the time of such schedules, microseconds.

        The last process is done no sooner than all are on average. The outermost one counts for
        more, as it takes a share of what its joints would take elsewhere. What all take beside
        their own joints is known as soon as one schedule was played. Two that exchange wait for
        two latencies together, whoever is ready first.

        Args:
            processes: P.
            count: those that work.
        """
        costs, own = self.costs, self._own
        whole = sum(own[kind] for kind in self._counted) + self._tangents
        start = costs["link.start"]
        unswept = max((own[k] - self._placed(k) - start for k in own), default=0.0)
        whole -= unswept * (count * self.parts if self.parts else count - 1)
        if not self.parts:
            whole -= max(0.0, _sweep(costs, self.kinds[0]) - costs["articulate.ground"])
        weights = self._share * (count - 1) + 1
        work = (self._share * max(0.0, whole) + self._beside.get(count, 0.0)) / weights
        waits = costs.window.latency * self._share * _latencies(count) / weights
        once = costs["process.evaluation"] + self._runs()
        return (once + work) / max(costs.speeds(processes)) + waits

    def _runs(self) -> float:
        """What every process takes once for its joints."""
        costs = self.costs
        run = min(costs["kinematics.run"], costs["kinematics_strips.run"])
        found = run + (min(run, costs["kinematics_traversed.run"]) if self._told else 0.0)
        if self.parts and self._alike:
            return found + costs["parts.run"]
        return found + min(costs["articulate.run"], costs["articulate_columns.run"])

    def _note(self, count: int, program: Program, line: Timeline) -> None:
        """Keep the least that processes take for joins and messages, weighed as by ``least``.

        Where all joints are alike that depends on how passages are put together alone.
        """
        if not self._alike:
            return
        total, fastest = 0.0, max(self.costs.speeds(len(program.processes)))
        for i in line.intervals:
            time = (i.end - i.start) * (1.0 if i.process == count - 1 else self._share)
            if i.what in ("send", "receive"):
                total += time * fastest
            elif i.operation is not None and i.what != "wait":
                does = program.processes[i.process].operations[i.operation].does
                total += time * self.costs.speed(i.process) * (does in _BESIDE)
        self._beside[count] = min(total, self._beside.get(count, total))

    def best(self, processes: int, count: int, play: Play) -> Schedule | None:
        """Return the fastest schedule found on some of the processes; None if it is not cut.

        Args:
            processes: P.
            count: those that are to work.
            play: plans and plays a schedule.
        """
        latest = self._latest(count - 1)
        if latest is None:
            return None
        others = [0.0] * count
        found: list[tuple[float, int, Schedule]] = []
        cuts_of: list[Sequence[int]] = []  # of each of them
        fans = _fans(count)
        cuts: list[int] | None = None
        for _ in range(_PLAYS):
            before, cuts = cuts, self._even(others, latest)
            if cuts is None or cuts == before:
                break
            tried: list[tuple[float, int, Schedule, list[float]]] = []
            for fan in fans:
                schedule = replace(self._schedule(cuts, processes), fan=fan)
                program, line = play(schedule)
                self._note(count, program, line)
                ready = _ready(program.plan, line)[:count]
                tried.append((line.makespan, len(found), schedule, ready))
                found.append(tried[-1][:3])
                cuts_of.append(cuts)
            *_, schedule, ready = min(tried)
            fans = [schedule.fan]
            ends = [0, *cuts, len(self.topology)]
            others = [
                ready[p] - self._time(p == count - 1, ends[p], ends[p + 1]) for p in range(count)
            ]
        if not found:
            return None
        # The process at the ground waits for no motions and is given more joints, which it sweeps
        # outwards last of all: a tenth less may be faster.
        least, number, best = min(found)
        first, *beyond = cuts_of[number]
        place = bisect_right(self.cuts, first - first // 10) - 1
        if place >= 0 and self.cuts[place] < first:
            schedule = self._schedule([self.cuts[place], *beyond], processes)
            schedule = replace(schedule, fan=best.fan)
            if play(schedule)[1].makespan < least:
                return schedule
        return best

    def _first_sweep(self, kind: str, outermost: bool) -> float:
        """Time of a joint until its process sends its own part; microseconds."""
        if self.parts:
            own = self.costs["link.start"] + self.costs["parts.inwards"]
        else:
            own = first_sweep(self.costs, kind, outermost)
        return self._placed(kind) + own

    def _placed(self, kind: str) -> float:
        """Time of the kinematics of a joint, microseconds."""
        if self._told:
            return passed_and_placed(self.costs, kind)
        return min(self.costs[f"{group}.{kind}"] for group in ("kinematics", "kinematics_strips"))

    def _both_sweeps(self, kind: str, outermost: bool) -> float:
        """Time of a joint in both sweeps, microseconds."""
        own, costs = self._first_sweep(kind, outermost), self.costs
        if self.parts:
            return own + costs["parts.outwards"]
        forces = 0.0 if outermost else min(costs[f"deliver.{kind}"], costs["deliver.along"])
        return own + costs[f"accelerate.{kind}"] + forces

    def _time(self, outermost: bool, first: int, beyond: int) -> float:
        sums = self.outermost if outermost else self.inner
        return sums[beyond] - sums[first]

    def _latest(self, count: int) -> list[int] | None:
        """Return the last places for a number of cuts with a joint between any two."""
        found: list[int] = []
        for place in reversed(range(len(self.cuts))):
            if len(found) < count and (not found or self.cuts[place] + 1 < self.cuts[found[-1]]):
                found.append(place)
        return found[::-1] if len(found) == count else None

    def _even(self, others: Sequence[float], latest: Sequence[int]) -> list[int] | None:
        """Return cuts for equal times of all processes, with their other work."""
        low, high = 0.0, self.inner[-1] + max(others)
        found = None
        while high - low > _FINE:
            middle = (low + high) / 2
            cuts = self._within(middle, others, latest)
            if cuts is None:
                low = middle
            else:
                high, found = middle, cuts
        return found

    def _within(
        self, time: float, others: Sequence[float], latest: Sequence[int]
    ) -> list[int] | None:
        """Cuts with which no process takes longer than a time; None if there are none."""
        cuts: list[int] = []
        first = 0
        for p, other in enumerate(others[:-1]):
            beyond = bisect_right(self.inner, self.inner[first] + time - other) - 1
            place = bisect_right(self.cuts, beyond) - 1
            place = min(place, latest[p])  # those beyond have some, too
            if place < 0 or self.cuts[place] <= first + (p > 0):
                return None
            first = self.cuts[place]
            cuts.append(first)
        left = self._time(True, first, len(self.topology)) + others[-1]
        return cuts if left <= time else None

    def _schedule(self, cuts: Sequence[int], processes: int) -> Schedule:
        """Return the schedule whose processes meet in halves."""
        draft = Draft(len(self.topology))
        draft.root = self._part(draft, WHOLE, 0, cuts)
        found = Found(draft, 0, 0).schedule(self.topology, processes, self.profile, self.tie)
        return replace(found, meeting="exchange", parts=self.parts)

    def _part(self, draft: Draft, chain: Chain, first: int, cuts: Sequence[int]) -> int:
        if not cuts:
            return put_segment(draft, self.chains, chain, (first, first + 1))
        half = len(cuts) // 2
        joint = cuts[half]  # of a serial chain, a joint's number is its position
        near, far = self.chains.split(chain, joint)
        draft.ranges[joint] = (first, first + len(cuts) + 1)
        draft.root_child[joint] = self._part(draft, near, first, cuts[:half])
        draft.end_child[joint] = self._part(draft, far, first + half + 1, cuts[half + 1 :])
        return joint


def _of_full_rows(cuts: list[int], base: int, parts: int) -> list[int]:
    """Return the cuts at which every process but the last has as many joints in each of its parts.

    A row of joints, one of each part, takes as long where some are missing. All cuts are returned
    where there are no parts, or where some of these cuts are not allowed.

    Args:
        cuts: those that are allowed, in order.
        base: joints before the chain.
        parts: in how many parts each process sweeps its joints at once; 0: not in parts.
    """
    if not parts or not cuts:
        return cuts
    full = range(base + parts, cuts[-1] + 1, parts)
    return list(full) if set(full) <= set(cuts) else cuts


def _fans(count: int) -> list[int]:
    """How many groups of so many processes can put their passages together at once."""
    fans = [2]
    while fans[-1] < min(count, _MOST_AT_ONCE):
        fans.append(2 * fans[-1])
    return fans


def _sweep(costs: StepCosts, kind: str) -> float:
    return min(costs[f"articulate.{kind}"], costs[f"articulate_columns.{kind}"])


def tangents(topology: Topology, costs: StepCosts) -> list[float]:
    """Return what the tangents of each joint's friction take; microseconds."""
    one = costs["process.tangent"]
    return [one * topology.tangents_of(j) for j in range(len(topology))]


def passing(costs: StepCosts, kind: str) -> float:
    """Return the least time of a joint of which only the passage is needed; microseconds."""
    return min(costs[f"kinematics.{kind}"], costs[f"passing_strips.{kind}"])


def passed_and_placed(costs: StepCosts, kind: str) -> float:
    """Return the time of a joint whose process finds its passage first; microseconds."""
    placing = min(costs[f"{group}.{kind}"] for group in ("kinematics", "kinematics_traversed"))
    return passing(costs, kind) + placing


def first_sweep(costs: StepCosts, kind: str, outermost: bool) -> float:
    """Return the time of a placed joint until its process sends its own part; microseconds.

    Args:
        costs: what joints take.
        kind: of the joint.
        outermost: whether nothing is asked for beyond the part.
    """
    own = costs["link.start"] + _sweep(costs, kind)
    return own if outermost else own + costs.carried(kind)


def _latencies(count: int) -> int:
    """How many latencies processes wait for that exchange, all together.

    Each two that exchange one message wait for two of them. Where one side is larger, only the
    first process of the smaller one sends two messages, and is left out.
    """
    near, far = count // 2, count - count // 2
    return 2 * (near - (near < far)) + _latencies(near) + _latencies(far) if near else 0


def _ready(plan: Plan, line: Timeline) -> list[float]:
    """Time at which each process first sends its own part."""
    first: list[float] = []
    for p, process in enumerate(plan.processes):
        messages = {
            stage.message
            for stage in stages(process)
            if stage.message is not None and plan.messages[stage.message].sweep == "assembly"
        }
        begun = (i.start for i in line.intervals if i.process == p and i.message in messages)
        first.append(min(begun, default=0.0))
    return first
