"""Lower bounds on the costs of joints in any grouping.

A joint is passed by itself, by columns, in strips, or in a row with one to three others. Rows
hold joints of limbs that do not hang on each other, so that two joints on one way outwards are
never in the same row: a process that has both pays two rows in full. A row's price shared by as
many joints as there can be in it is the least that a joint adds to the work of all processes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import accumulate
from math import inf

from adagen.plan.robot import PlanJoint
from adagen.plan.simd_groups import KINDS
from adagen.plan.tip_mobility import can_carry_wrenches
from adagen.program.runs import OF_ONE_FREEDOM, Run
from adagen.schedule.costs import StepCosts
from adagen.search.limbs import Limb, Robot
from adagen.search.whole_limb_bounds import NOTHING, SweepBound, WholeLimbBounds, longest_of

ROWS = {2: ("two", 2), 3: ("four", 3), 4: ("four", 4)}
"""By joints in a row: the coefficients that price it, and how many share it."""


def _least(ways: Sequence[tuple[float, float]]) -> SweepBound:
    return SweepBound(
        min(way[0] for way in ways), min(way[1] for way in ways), min(sum(way) for way in ways)
    )


class JointBounds:
    """Lower bounds for the joints of a robot.

    Args:
        robot: the robot.
        costs: the machine's coefficients.
        whole: whether processes have limbs as a whole, as where they gather: then no chain of
            limbs side by side is longer than the longest way from the ground to an end through its
            joints, or than the ways beyond as many joints as go together, and kinematics are passed
            in runs that are no longer either. Else chains may be as long as the robot has joints,
            and kinematics may be passed joint by joint.
        whole_limbs: bounds of joints that hang together, if they are at hand.

    Attributes:
        single: of each joint of a core: passed by itself or with its run, no link beside it, since
            one of the processes has that.
        passed: the same of each joint of a limb, with the link beyond it.
        row: of each joint, with the whole row that it is in.
        share: of each joint, with its share of the row that it is in.
        by_itself: about what each joint takes beside no other, without its run: not a bound.
        pose: the kinematics alone of a joint by itself or with its run.
        passing: the same for a process that only passes the joint on the way to others.
        ends: how many joints with nothing beyond them there are from each joint on.
        most: how many joints of a kind can lie side by side.
    """

    def __init__(
        self,
        robot: Robot,
        costs: StepCosts,
        *,
        whole: bool = False,
        whole_limbs: WholeLimbBounds | None = None,
    ) -> None:
        self.robot, self.costs, self.whole = robot, costs, whole
        self.most = {kind: self._most_in_row(kind) for kind in sorted(KINDS)}
        self._price_rows()
        self._bound_ways(whole_limbs or WholeLimbBounds(robot, costs))
        self._climb_all()

    def _price_rows(self) -> None:
        """Set what each joint takes, by itself, in its run and in rows."""
        robot, costs, joints = self.robot, self.costs, self.robot.joints
        in_run = {j for run in robot.runs for j in _within(run)}
        in_columns = {
            j
            for run in robot.runs
            if any(joints[k].kind in OF_ONE_FREEDOM for k in _within(run))
            for j in _within(run)
        }
        long = {j for run in robot.long for j in _within(run)}
        ways = self._lengths_of_ways()
        lengths = [ways[j] if j in in_run else 0 for j in range(len(joints))]
        self.pose = [
            self._pose(joint, lengths[j], j in long, "kinematics_strips")
            for j, joint in enumerate(joints)
        ]
        self.passing = [
            min(self.pose[j], self._pose(joint, lengths[j], j in long, "passing_strips"))
            for j, joint in enumerate(joints)
        ]
        self._tangents = [costs["process.tangent"] * joint.tangents for joint in joints]
        self.by_itself = [
            costs.joint(joint.kind) + own for joint, own in zip(joints, self._tangents, strict=True)
        ]
        self._chains = self._lengths_of_chains(ways)
        self._alone = [
            self._ways(
                joint,
                self.pose[j] + self._tangents[j],
                ways[j] if j in in_run else 1,
                j in in_columns,
            )
            for j, joint in enumerate(joints)
        ]
        # Swept from the ground a limb's first joint has no link beyond it.
        self._start = [costs["link.start"] if joint.parent > 0 else 0.0 for joint in joints]
        self.single = [_least(ways) for ways in self._alone]
        self.passed = [self.in_row(j, 1) for j in range(len(joints))]
        most = [self.most.get(joint.kind, 1) for joint in joints]
        self.row = [self.in_row(j, count) for j, count in enumerate(most)]
        self.share = [self.of_row(j, count) for j, count in enumerate(most)]
        self._sums = [
            [0.0, *accumulate(getattr(each, name) for each in self.share)]
            for name in ("inwards", "outwards", "both")
        ]

    def _bound_ways(self, whole_limbs: WholeLimbBounds) -> None:
        """Set the least from each joint to the ends of the robot, along the longest way."""
        robot, joints = self.robot, self.robot.joints
        self._deepest: list[SweepBound] = [NOTHING] * len(joints)
        self.ends = [1] * len(joints)
        for j in reversed(range(len(joints))):
            self.ends[j] = sum(self.ends[k] for k in robot.at[j + 1]) or 1
            self._deepest[j] = self.row[j].plus(
                longest_of(self._deepest[k] for k in robot.at[j + 1])
            )
        self.whole_limbs = whole_limbs
        if self.whole:
            beyond = self.whole_limbs.beyond(range(len(joints)))
            for j, joint in enumerate(joints):
                own = self.row[j] if joint.parent == 0 else NOTHING
                self._deepest[j] = longest_of((self._deepest[j], own.plus(beyond[j])))

    def _climb_all(self) -> None:
        """Set what is passed between the ground and each link."""
        joints = self.robot.joints
        self._upwards: dict[int, SweepBound] = {}
        self._work: dict[Limb, SweepBound] = {}
        self._longest: dict[Limb, SweepBound] = {}
        self._way = [0.0] * (len(joints) + 1)
        self._depth = [0] * (len(joints) + 1)
        self._turned = [NOTHING] * (len(joints) + 1)
        self._passed = [(0, NOTHING)] * (len(joints) + 1)
        self._beside = [NOTHING] * (len(joints) + 1)
        self._above = [NOTHING] * (len(joints) + 1)
        for j, joint in enumerate(joints):
            self._climb(j, joint)
        self._entered = self._all_entered()

    def in_row(self, joint: int, count: int) -> SweepBound:
        """Return what a joint takes with its whole row, where so many at most can be in one."""
        start, own = self._start[joint], self._tangents[joint]
        ways = [(inwards + start, outwards) for inwards, outwards in self._alone[joint]]
        for n in range(2, count + 1):
            inwards, outwards = self._in_row(joint, n)
            ways.append((inwards + n * start + own, outwards))
        return _least(ways)

    def of_row(self, joint: int, count: int) -> SweepBound:
        """Return what a joint takes with its share of a row likewise."""
        start, own = self._start[joint], self._tangents[joint]
        ways = [(inwards + start, outwards) for inwards, outwards in self._alone[joint]]
        for n in range(2, count + 1):
            inwards, outwards = self._in_row(joint, n)
            ways.append((inwards / n + start + own, outwards / n))
        return _least(ways)

    def work(self, limb: Limb) -> SweepBound:
        """Return the least that a limb adds to the work of all processes together."""
        if limb not in self._work:
            self._work[limb] = self._work_of(limb)
        return self._work[limb]

    def _work_of(self, limb: Limb) -> SweepBound:
        found = [
            sum(sums[span.stop] - sums[span.start] for span in limb.spans) for sums in self._sums
        ]
        whole = SweepBound(*found)
        if not limb.up:
            return whole
        return whole.plus(self._turned[limb.link]).plus(self.upwards(limb))

    def longest(self, limb: Limb) -> SweepBound:
        """Return the least that the process takes which has a limb: all of it, and row by row."""
        if limb not in self._longest:
            if limb.up:
                way = self._above[limb.link].plus(self.upwards(limb))
            else:
                way = self._deepest[limb.first]
            self._longest[limb] = longest_of((way, self.work(limb)))
        return self._longest[limb]

    def entered(self, limb: Limb) -> SweepBound:
        """Return the least that some process takes for a limb, however far a core grows into it."""
        return self.longest(limb) if limb.up else self._entered[limb.first]

    def way(self, link: int) -> float:
        """Return the kinematics between the ground and a link, microseconds."""
        return self._way[link]

    def core(self, joints: Sequence[int]) -> SweepBound:
        """Return the least that every process takes for joints of a core."""
        total = NOTHING
        for j in joints:
            total = total.plus(self.single[j])
        return total

    def _most_in_row(self, kind: str) -> int:
        """How many joints of a kind there are none of which hangs on another, up to four."""
        joints, widest = self.robot.joints, [0] * (len(self.robot.joints) + 1)
        for j in reversed(range(len(joints))):
            here = max(widest[j + 1], joints[j].kind == kind)
            widest[joints[j].parent] += here
        return min(widest[0], max(ROWS))

    def _pose(self, joint: PlanJoint, length: int, in_long: bool, in_strip: str) -> float:
        """The kinematics of a joint by itself, with its share of the run that it is in.

        Args:
            joint: the joint.
            length: of the longest run that it may be in, at most; 0 for what floats on the ground.
            in_long: whether that may be passed in strips.
            in_strip: the coefficients of those.
        """
        costs = self.costs
        # By itself on the ground it is no run, and costs nothing besides.
        shared = bool(length) and self.whole and joint.parent > 0
        alone = costs[f"kinematics.{joint.kind}"]
        alone += costs["kinematics.run"] / length if shared else 0.0
        if not in_long:
            return alone
        strip = costs[f"{in_strip}.{joint.kind}"]
        strip += costs["kinematics_strips.run"] / length if shared else 0.0
        return min(alone, strip)

    def _lengths_of_ways(self) -> list[int]:
        """How many joints there are at most from the ground to an end, through each joint.

        No run or chain of a process is longer. It may be longer than all of the robot's: a process
        without a hand's other fingers goes from the arm on to its finger.
        """
        joints = self.robot.joints
        before, beyond = [0] * (len(joints) + 1), [0] * (len(joints) + 1)
        for j, joint in enumerate(joints):
            before[j + 1] = before[joint.parent] + 1
        for j in reversed(range(len(joints))):
            beyond[joints[j].parent] = max(beyond[joints[j].parent], beyond[j + 1] + 1)
        return [before[j + 1] + beyond[j + 1] for j in range(len(joints))]

    def _lengths_of_chains(self, ways: Sequence[int]) -> dict[int, list[int]]:
        """How many joints chains have at most that go side by side, by their number and each joint.

        Of n such chains none hangs on another, and the joints at their near ends all bear as many
        others, one after another, as the shortest of the chains has. So there are n joints at least
        that bear exactly as many.
        """
        joints = self.robot.joints
        if not self.whole:
            return dict.fromkeys(ROWS, [len(joints)] * len(joints))
        heights = [1] * (len(joints) + 1)
        for j in reversed(range(len(joints))):
            heights[joints[j].parent] = max(heights[joints[j].parent], heights[j + 1] + 1)
        many = Counter(heights[1:])
        found = {}
        for count in ROWS:
            most = max((height for height, there in many.items() if there >= count), default=1)
            found[count] = [min(way, most) for way in ways]
        return found

    def _ways(
        self, joint: PlanJoint, pose: float, length: int, in_columns: bool
    ) -> list[tuple[float, float]]:
        """Prices of a joint by itself, in and outwards.

        Args:
            joint: the joint.
            pose: its kinematics, with the tangents of its friction.
            length: of the longest run that it may be in, at most.
            in_columns: whether that may be computed by columns.
        """
        costs, kind = self.costs, joint.kind
        if joint.parent == 0 and kind == "floating" and not joint.prescribed:
            return [(pose + costs["free.base"], costs["free.acceleration"])]
        run = costs["articulate.run"] / length
        sweeps = [costs[f"articulate.{joint.priced_as}"] + run]
        if joint.parent == 0:
            sweeps.append(0.0 if joint.prescribed else costs["articulate.ground"])
        if in_columns:
            run = costs["articulate_columns.run"] / length
            sweeps.append(costs[f"articulate_columns.{kind}"] + run)
        return [(pose + min(sweeps), costs[f"accelerate.{joint.priced_as}"])]

    def _in_row(self, joint: int, count: int) -> tuple[float, float]:
        """The price of a row that a joint is in, with its share of what limbs cost besides."""
        (name, _), costs, kind = ROWS[count], self.costs, self.robot.joints[joint].kind
        length = self._chains[count][joint]
        sweep = costs[f"articulate_{name}.{kind}"] + costs[f"limbs.{name}"] / length
        if self.robot.joints[joint].parent == 0:
            sweep = min(sweep, costs["articulate.ground"])
        return costs[f"kinematics_{name}.{kind}"] + sweep, costs[f"accelerate_{name}.{kind}"]

    def _climb(self, j: int, joint: PlanJoint) -> None:
        """What is on the ground's side of a joint's child link, its joint passed the other way."""
        link, parent = j + 1, joint.parent
        self._way[link] = self._way[parent] + self.passing[j]
        self._depth[link] = self._depth[parent] + 1
        more, passed = self.share[j], self.passed[j]
        spared = SweepBound(
            *(getattr(passed, n) - getattr(more, n) for n in ("inwards", "outwards", "both"))
        )
        self._turned[link] = self._turned[parent].plus(spared)
        beside = (self._deepest[k] for k in self.robot.at[parent] if k != j and parent > 0)
        self._beside[link] = longest_of([self._beside[parent], *beside])
        # Joints that are passed the other way are in rows of their own, and in a run at least.
        known, others = self._passed[parent]
        if self.whole and self.whole_limbs.plain[j]:
            own = self._tangents[j]
            self._passed[link] = known + 1, others.plus(SweepBound(own, passed.outwards, own))
        else:
            self._passed[link] = known, others.plus(passed)
        known, others = self._passed[link]
        self._above[link] = others.plus(self._beside[link])
        if known:
            self._above[link] = self._above[link].plus(self.whole_limbs.run(known))

    def _all_entered(self) -> list[SweepBound]:
        """The least for the limb that begins with each joint, however far a core grows into it.

        Either one process has all of it, or all processes pass its joints up to where limbs part,
        once they have exchanged what hangs there, and some process has the longest of those limbs.
        """
        count, at = len(self.robot.joints), self.robot.at
        found = [NOTHING] * count
        core = [NOTHING] * count  # the joints up to where limbs part, and the longest beyond them
        for j in reversed(range(count)):
            below = at[j + 1]
            span = range(j, self.robot.last[j] + 1)
            work = (sums[span.stop] - sums[span.start] for sums in self._sums)
            found[j] = whole = longest_of((self._deepest[j], SweepBound(*work)))
            if not below:
                core[j] = SweepBound(inf, inf, inf)  # limbs never part here
                continue
            beyond = core[below[0]] if len(below) == 1 else longest_of(found[k] for k in below)
            joint = self.single[j].both  # all of it comes after the exchange, or beside it
            core[j] = SweepBound(beyond.inwards + joint, beyond.outwards, beyond.both + joint)
            found[j] = SweepBound(*map(min, whole, core[j]))
        return found

    def upwards(self, limb: Limb) -> SweepBound:
        """Return what a limb takes besides that is swept towards a link beyond it."""
        if limb.link not in self._upwards:
            self._upwards[limb.link] = self._swept_upwards(limb)
        return self._upwards[limb.link]

    def _swept_upwards(self, limb: Limb) -> SweepBound:
        tree = self.robot.trees[limb.tree]
        first = tree.base + 1 if tree.base is not None else self.robot.held[limb.link] or limb.link
        count = self._depth[limb.link] - self._depth[first]
        inwards = count * self.costs["articulate.reversed"]
        outwards = count * self.costs["accelerate.reversed"]
        return self._grounded(limb).plus(SweepBound(inwards, outwards, inwards + outwards))

    def _grounded(self, limb: Limb) -> SweepBound:
        """What the ground at the far end of a limb takes besides."""
        if self.robot.trees[limb.tree].base is not None:
            return NOTHING
        costs, joints = self.costs, self.robot.joints
        held = self.robot.held[limb.link]
        inwards = costs["root.invert"] if held else 0.0
        beyond, link, spared = 0, held or limb.link, 0.0
        while link > 0:
            joint = joints[link - 1]
            above = "ground" if joint.parent == 0 else joint.priced_as
            price = costs[f"propagate.{above}"]
            if can_carry_wrenches(joints, link - 1) or (
                beyond and can_carry_wrenches(joints, beyond - 1)
            ):
                carried = min(price, costs.carried(joint.kind))
                spared, price = spared + price - carried, carried
            inwards += price
            beyond, link = link, joint.parent
        inwards += min(spared, costs["propagate_run.run"])  # joints are carried in a run at least
        return SweepBound(inwards, 0.0, inwards)


def _within(run: Run) -> range:
    """The joints of a run."""
    return range(run.first, run.last + 1)
