"""Who takes which limbs where processes gather at a small core.

For a root link and a core around it, what hangs on the core are limbs, each the work of one
process (adagen/plan/gather.py). The core grows by the limb that weighs most on the busiest process,
as long as it is small; limbs go to the process that is least busy, the heaviest first, and are then
exchanged while that helps.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from adagen.model import Model
from adagen.plan.constants import joints_of
from adagen.plan.edges import is_free_base, joints_at
from adagen.plan.gather import SMALL_CORE
from adagen.plan.gather_trees import HELD_FREEDOMS
from adagen.plan.steps import Accelerate, Articulate, Kinematics, StartLink, Step
from adagen.predict.features import SIDE_BY_SIDE, in_runs, step_time, work_time
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.costs import StepCosts
from adagen.schedule.draft import Draft
from adagen.schedule.sweeps import loads_of


@dataclass(frozen=True)
class Limb:
    """A subtree that hangs on the core, seen from the root: its joints, the innermost first."""

    joints: tuple[int, ...]
    link: int
    weight: float


@dataclass(frozen=True)
class Layout:
    """A core and who takes which limb.

    Attributes:
        core: its joints, outwards from the root.
        shares: limbs of each process.
        time: of the busiest process, and of the core; microseconds, messages left out.
    """

    core: tuple[int, ...]
    shares: tuple[tuple[Limb, ...], ...]
    time: float


def _steps(joint: int) -> tuple[Step, ...]:
    """What a joint takes on one process."""
    return (
        Kinematics(joint),
        StartLink(joint + 1),
        Articulate(joint, False),
        Accelerate(joint, False),
    )


class Layouts:
    """A robot's limbs and what they weigh on processes.

    Args:
        model: a robot on one joint on the ground, floating or not, or on several.
        processes: that limbs are given to.
        profile: a profile with costs of steps.
    """

    def __init__(self, model: Model, processes: int, profile: CostProfile) -> None:
        assert profile.steps is not None  # as the caller has made sure
        self.joints = joints_of(model)
        self.in_runs = in_runs(self.joints)
        self.found: dict[tuple[int, int], list[Limb]] = {}
        self.topology, self.profile, self.processes = Topology.of(model), profile, processes
        costs = profile.steps
        self.weight = [self._alone(costs, *_steps(j)) for j in range(len(self.joints))]
        self.rate = sum(costs.speed(p) for p in range(processes))
        self.bases = [j for j, joint in enumerate(self.joints) if joint.parent == 0]
        self.floats = len(self.bases) == 1 and is_free_base(self.joints[self.bases[0]])
        self.at = joints_at(
            self.joints,
            (j for j in range(len(self.joints)) if not (self.floats and j in self.bases)),
        )

    def _alone(self, costs: StepCosts, *steps: Step) -> float:
        """What steps take where nothing lies side by side, microseconds."""
        return work_time(steps, self.joints, costs, together=self.in_runs)

    def evenly(self) -> float:
        """Time in which all processes together could do the work of all joints, microseconds."""
        assert self.profile.steps is not None
        least = (self._least(j, self.profile.steps) for j in range(len(self.joints)))
        return sum(least) / self.rate

    def _least(self, joint: int, costs: StepCosts) -> float:
        """What a joint takes at best, by itself or beside others, microseconds."""
        kind, time = self.joints[joint].kind, 0.0
        for step in _steps(joint):
            ways = [step_time(step, self.joints, costs)]
            if group := SIDE_BY_SIDE.get(type(step)):
                ways += [costs[f"{group}_two.{kind}"] / 2, costs[f"{group}_four.{kind}"] / 4]
            if isinstance(step, Articulate):
                ways.append(costs[f"articulate_columns.{kind}"])
            if isinstance(step, Kinematics):
                ways.append(costs[f"kinematics_segments.{kind}"])
            time += min(ways)
        return time

    def layouts(self, roots: Sequence[int]) -> Iterator[Layout]:
        """Yield layouts around links that may be roots, each with a core that grows."""
        most = len(self.joints) // SMALL_CORE
        alone = len(self.bases) == 1
        for root in roots:
            if (root == 0 and self.floats) or (root > 0 and not alone):
                continue
            core: list[int] = []
            limbs = [self._as_base(limb, root) for limb in self._limbs(root, -1)]
            while True:
                layout = self._shared_out(core, limbs)
                yield layout
                heaviest = max(
                    max(layout.shares, key=lambda share: sum(limb.weight for limb in share)),
                    key=lambda limb: limb.weight,
                    default=None,
                )
                if heaviest is None or len(heaviest.joints) == 1 or len(core) >= most:
                    break
                joint = heaviest.joints[0]
                core.append(joint)
                limbs.remove(heaviest)
                limbs += self._limbs(self._far(joint, heaviest.link), joint)

    def _as_base(self, limb: Limb, root: int) -> Limb:
        """Weigh the limb on the way to the base by what it spares its process, and by the ground.

        Whoever has it does the kinematics of that way anyhow; others do it besides. It is swept
        from the base on, and where it holds the ground, the mobility of the first links is
        inverted.
        """
        if root == 0 or limb.joints[0] != root - 1:
            return limb
        assert self.profile.steps is not None
        costs, weight, link = self.profile.steps, limb.weight, root
        while link > 0:
            weight -= self._alone(costs, Kinematics(link - 1))
            weight += costs["articulate.reversed"] + costs["accelerate.reversed"]
            link = self.joints[link - 1].parent
        if not self.floats:
            weight += HELD_FREEDOMS * costs["propagate_run.revolute"] + costs["root.invert"]
        return replace(limb, weight=max(0.0, weight))

    def _far(self, joint: int, near: int) -> int:
        parent = self.joints[joint].parent
        return joint + 1 if near == parent else parent

    def _limbs(self, link: int, came: int) -> list[Limb]:
        """The limbs on a link but for the one beyond joint ``came``."""
        if (link, came) not in self.found:
            self.found[link, came] = self._find_limbs(link, came)
        return self.found[link, came]

    def _find_limbs(self, link: int, came: int) -> list[Limb]:
        found = []
        for first in self.at.get(link, []):
            if first == came:
                continue
            joints, waiting = [], [(first, link)]
            while waiting:
                joint, near = waiting.pop()
                joints.append(joint)
                far = self._far(joint, near)
                waiting += [(j, far) for j in self.at.get(far, []) if j != joint]
            found.append(Limb(tuple(joints), link, sum(self.weight[j] for j in joints)))
        return found

    def _shared_out(self, core: Sequence[int], limbs: Sequence[Limb]) -> Layout:
        shares: list[list[Limb]] = [[] for _ in range(self.processes)]
        loads = [0.0] * self.processes
        for limb in sorted(limbs, key=lambda limb: (-limb.weight, limb.joints)):
            p = loads.index(min(loads))
            shares[p].append(limb)
            loads[p] += limb.weight
        self._exchange(shares, loads)
        time = max(loads) + sum(self.weight[j] for j in core)
        return Layout(tuple(core), tuple(tuple(share) for share in shares), time)

    @staticmethod
    def _exchange(shares: list[list[Limb]], loads: list[float]) -> None:
        """Swap limbs between the busiest process and others while that makes it less busy."""
        moved = True
        while moved:
            moved = False
            busiest = loads.index(max(loads))
            for p in range(len(loads)):
                swap = _best_swap(shares[busiest], shares[p], loads[busiest] - loads[p])
                if p == busiest or swap is None:
                    continue
                give, take = swap
                shares[busiest].remove(give)
                shares[p].append(give)
                by = give.weight
                if take is not None:
                    shares[p].remove(take)
                    shares[busiest].append(take)
                    by -= take.weight
                loads[busiest] -= by
                loads[p] += by
                moved = True
                break

    def owners(self, layout: Layout) -> tuple[int | None, ...]:
        """Return the process that has each joint by itself; None for joints of the core.

        A limb's first joint is its process's where the link that it hangs on is: that goes with a
        limb of one joint, or else with the first one.
        """
        owners: list[int | None] = [None] * len(self.topology)
        limbs = [(p, limb) for p, share in enumerate(layout.shares) for limb in share]
        claimed: dict[int, int] = {}  # the process that a link of the core goes with
        for p, limb in sorted(limbs, key=lambda each: len(each[1].joints) > 1):
            own = claimed.setdefault(limb.link, p) == p
            for joint in limb.joints if own else limb.joints[1:]:
                owners[joint] = p
        return tuple(owners)

    def schedule(self, layout: Layout, pattern: Schedule) -> Schedule:
        """Return the schedule tree of a layout: limbs first, then what joins them."""
        draft = Draft(len(self.topology))
        owners = self.owners(layout)
        draft.ranges = [(0, self.processes) if p is None else (p, p + 1) for p in owners]
        in_limbs = [j for share in layout.shares for limb in share for j in limb.joints]
        inside = [j for j in in_limbs if owners[j] is not None]
        joining = [j for j in in_limbs if owners[j] is None]
        order = [*inside, *joining, *layout.core, *(self.bases if self.floats else ())]
        draft.root = draft.contract(self.topology, order)
        root = draft.finish(self.topology, self.profile)
        return replace(pattern, root=root, loads=loads_of(root, pattern.processes))


def _best_swap(
    mine: Sequence[Limb], theirs: Sequence[Limb], difference: float
) -> tuple[Limb, Limb | None] | None:
    """The limb to give, and that to take, which leave two processes most alike."""
    best, least = None, abs(difference) * (1 - 1e-9)
    for give in mine:
        for take in (None, *theirs):
            left = abs(difference - 2 * (give.weight - (take.weight if take else 0.0)))
            if left < least:
                best, least = (give, take), left
    return best
