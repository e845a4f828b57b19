"""Lower bounds on the predicted time of layouts.

Whoever takes part in an exchange has passed the way to the core and the core itself, and its limbs;
it waits for the slowest of the others, whose message is under way for the latency; and then sweeps
the core, solves for the root, and goes outwards. The slowest takes no less than the average, and no
less than the longest limb.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import inf

from adagen.schedule.costs import ChannelCosts, StepCosts
from adagen.search.joint_bounds import JointBounds
from adagen.search.limbs import Core, Limb, Robot
from adagen.search.whole_limb_bounds import NOTHING, SweepBound, longest_of

_NUMBERS = 27
"""Numbers that a process tells another at least: a link's inertia and bias force."""


@dataclass(frozen=True)
class Around:
    """What a process takes for a core besides its limbs, on a core of speed 1; microseconds.

    Attributes:
        way: the kinematics between the ground and the root.
        before: the kinematics of the core.
        after: the sweeps through the core, and the root.
    """

    way: float
    before: float
    after: float


class Bounds:
    """Lower bounds on the time of layouts.

    Args:
        robot: the robot.
        joint_bounds: what its joints take at least.
        processes: P.
        costs: the machine's coefficients.
        channel: those of messages.
    """

    def __init__(
        self,
        robot: Robot,
        joint_bounds: JointBounds,
        processes: int,
        costs: StepCosts,
        channel: ChannelCosts,
    ) -> None:
        self.robot, self.joint_bounds, self.processes = robot, joint_bounds, processes
        self.fastest = max(costs.speeds(processes))
        self.start = costs["process.evaluation"] / self.fastest
        self.latency = channel.latency
        self.receiving_one = _NUMBERS * channel.number / 2
        self.sending_one = channel.send + self.receiving_one
        self.costs = costs
        self.outwards = min(bound.outwards for bound in joint_bounds.row)
        self._shared: dict[int, float] = {}

    def around(self, core: Core) -> Around:
        """Return what a core takes besides limbs."""
        whole = self.joint_bounds.core(core.joints)
        pose = sum(self.joint_bounds.pose[j] for j in core.joints)
        tree = self.robot.trees[core.tree]
        shown = tree.base is None and not self.robot.held[core.root]  # the ground, as a mobility
        solve = self.costs["root.mobility" if shown else "root.solve"]
        return Around(self.joint_bounds.way(core.root), pose, whole.both - pose + solve)

    def place(self, cores: Sequence[Core], limbs: Sequence[Limb]) -> float:
        """Return the least that a layout takes whose cores hold these at least.

        More trees may be shared, and cores may grow, as `adagen.search.meeting_places` lets them.

        Args:
            cores: the cores.
            limbs: what is left.
        """
        arounds = {core.tree: self.around(core) for core in cores}
        grown = any(core.joints for core in cores)
        whole = len(self.robot.trees) if grown else cores[-1].tree if cores else 0
        least = self.start + self._limbs(limbs, arounds, whole) / self.fastest
        if len(self.robot.trees) == 1 and cores:
            most = min(self.processes, sum(self._ends(limb) for limb in limbs))
            return max(least, self.shared(arounds[0], limbs, max(most, 2), 2))
        work = sum(self.joint_bounds.work(limb).both for limb in limbs)
        beside = self._beside(arounds, limbs)
        return max(least, self.start + (work + beside) / self.processes / self.fastest)

    def _beside(self, arounds: dict[int, Around], limbs: Sequence[Limb]) -> float:
        """What all processes take besides limbs: two of them at least share each core."""
        total = 2 * len(arounds) * (self.sending_one + self.receiving_one) * self.fastest
        up = {limb.tree for limb in limbs if limb.up}
        for tree, around in arounds.items():
            total += 2 * (around.before + around.after) + (2 - (tree in up)) * around.way
        return total

    def _ends(self, limb: Limb) -> int:
        """How many processes can share a limb at most, once the core has grown into it."""
        return 1 if limb.up else self.joint_bounds.ends[limb.first]

    def _limbs(self, limbs: Iterable[Limb], arounds: dict[int, Around], whole: int) -> float:
        """The longest limb, with what its process and those that wait for it take besides.

        Args:
            limbs: the limbs.
            arounds: what cores take besides, by their trees.
            whole: trees of lower numbers that have no core will have none.
        """
        most, messages = 0.0, self.sending_one + self.receiving_one
        for limb in limbs:
            long, around = self.joint_bounds.entered(limb), arounds.get(limb.tree)
            if around is None:
                alone = self.joint_bounds.longest(limb).both
                most = max(most, alone if limb.tree < whole else min(alone, self._opened(limb)))
                continue
            rest = around.before + around.after + (0.0 if limb.up else around.way)
            alone = long.both + messages * self.fastest
            waited = long.inwards + (messages + self.latency) * self.fastest + self.outwards
            most = max(most, rest + max(alone, waited))
        return most

    def _opened(self, tree: Limb) -> float:
        """The least that processes take which share a tree, wherever they meet."""
        if tree.tree not in self._shared:
            least = inf
            for link in self.robot.trees[tree.tree].links:
                core = Core(tree.tree, link)
                own = [limb for limb in self.robot.limbs([core]) if limb.tree == tree.tree]
                least = min(least, self._limbs(own, {tree.tree: self.around(core)}, 0))
            self._shared[tree.tree] = least
        return self._shared[tree.tree]

    def shared(
        self,
        around: Around,
        limbs: Sequence[Limb],
        most: int,
        fewest: int,
        *,
        whole: bool = False,
    ) -> float:
        """Return the least that limbs of a shared tree take, by the average of its processes.

        Args:
            around: what its core takes.
            limbs: the limbs.
            most: processes that share them, at most.
            fewest: at least.
            whole: whether limbs are not parted, so that one of the processes has the longest.
        """
        work, long = NOTHING, NOTHING
        for limb in limbs:
            work = work.plus(self.joint_bounds.work(limb))
        for limb in limbs if whole else ():
            way = SweepBound(around.way, 0.0, around.way) if not limb.up else NOTHING
            long = longest_of((long, self.joint_bounds.longest(limb).plus(way)))
        up = any(limb.up for limb in limbs)
        least, core = inf, around.before + around.after
        for count in range(fewest, most + 1):
            ways = around.way * (count - up) / count
            sending = (count - 1) * self.sending_one
            both = max(work.both / count + ways, long.both) + core
            alone = both / self.fastest + sending + (count - 1) * self.receiving_one
            inwards = max(work.inwards / count + ways, long.inwards) + core + self.outwards
            waited = inwards / self.fastest + sending + self.latency + self.receiving_one
            least = min(least, max(alone, waited))
        return self.start + least
