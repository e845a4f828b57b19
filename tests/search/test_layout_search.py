"""Branch and bound over layouts, beside a look at all of them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import combinations, product

import numpy as np
import pytest

from adagen.emit.shapes import SHAPES, predict
from adagen.model import Model
from adagen.plan import can_gather, make_plan
from adagen.plan.constants import joints_of
from adagen.schedule import CostProfile, Schedule, Topology, load_profile
from adagen.search import best_schedule, find_schedule
from adagen.search.incumbent import Spent
from adagen.search.joint_bounds import JointBounds
from adagen.search.layout_bounds import Bounds
from adagen.search.layout_search import GatheredSearch
from adagen.search.layouts import Layout, LayoutPrices, MeetingPlace
from adagen.search.limbs import Core, Robot
from adagen.search.meeting_places import in_place
from adagen.search.price import Pricing
from tests.cost.costs import step_profile
from tests.models import human_figure, random_tree, some_rubbing
from tests.slow import spread

DEFAULT = load_profile("default")
OTHERS = step_profile()


@dataclass
class Case:
    """A robot's layouts, priced."""

    model: Model
    processes: int
    profile: CostProfile

    def __post_init__(self) -> None:
        assert self.profile.steps is not None
        self.topology = Topology.of(self.model)
        self.robot = Robot(joints_of(self.model))
        self.pattern = find_schedule(
            self.topology, self.processes, profile=self.profile, expansions=0
        )
        plan = make_plan(self.model, self.pattern)
        self.prices = LayoutPrices(self.robot, Pricing(plan, self.profile))
        steps = self.profile.steps
        joint_bounds = JointBounds(self.robot, steps, whole=True)
        self.bounds = Bounds(self.robot, joint_bounds, self.processes, steps, steps.window)

    def schedule(self, layout: Layout) -> Schedule:
        gathered = layout.gathered(self.robot)
        return replace(self.pattern, meeting="gather", gathered=gathered)

    def searched(self, limit: int = 10**6) -> GatheredSearch:
        roots = [False] + [True] * len(self.robot.joints)
        search = GatheredSearch(self.prices, self.bounds, roots, Spent(limit))
        search.start()
        search.run()
        return search

    def everything(self) -> Iterator[Layout]:
        """Yield all layouts: every root, core and way to hand out limbs; not one process alone."""
        for cores in self.all_cores():
            if not cores and len(self.robot.trees) == 1:
                continue
            limbs = self.robot.limbs(cores)
            for of in product(range(self.processes), repeat=len(limbs)):
                shares = tuple(
                    tuple(k for k, owner in enumerate(of) if owner == p)
                    for p in range(self.processes)
                )
                layout = Layout(MeetingPlace(cores, limbs), shares)
                if all(len(layout.taking_part(core.tree)) > 1 for core in cores):
                    yield layout

    def all_cores(self) -> Iterator[tuple[Core, ...]]:
        per_tree: list[list[Core | None]] = []
        for number, tree in enumerate(self.robot.trees):
            own: list[Core | None] = [None]
            for root in tree.links:
                below = range(root, self.robot.last[root - 1] + 1)
                for count in range(min(3, len(below)) + 1):
                    for joints in combinations(below, count):
                        links = {root, *(j + 1 for j in joints)}
                        if all(self.robot.joints[j].parent in links for j in joints):
                            own.append(Core(number, root, joints))
            per_tree.append(own)
        for choice in product(*per_tree):
            yield tuple(core for core in choice if core is not None)


def robots(count: int, profile: CostProfile) -> Iterator[Case]:
    """Yield small random robots, of few kinds of joints so that limbs are alike.

    Every other one of those with a base that floats, and of those without, has friction.
    """
    seed = 0
    while count:
        seed += 1
        rng = np.random.default_rng(seed)
        joints, processes = 3 + seed % 6, 2 + (seed % 3 == 0)
        model = random_tree(rng, joints, branching=0.6, floating=seed % 2 == 0)
        model = some_rubbing(model, seed) if seed % 4 > 1 else model
        if can_gather(model):
            count -= 1
            yield Case(model, processes, profile)


@pytest.mark.parametrize("profile", spread([DEFAULT, OTHERS], 1), ids=["default", "others"])
def test_nothing_is_faster_than_what_is_found(profile: CostProfile) -> None:
    """Twenty robots under each of two profiles: all layouts whose cores are in place, as played."""
    meeting = 0
    for case in robots(20, profile):
        search = case.searched()
        assert search.lower == search.found.best
        least = float("inf")
        for layout in case.everything():
            time = case.prices.time(layout)
            if time is not None and time < least and in_place(layout, case.robot):
                plan = make_plan(case.model, case.schedule(layout))
                least = predict(plan, profile, "kernels").makespan
        assert search.found.best == pytest.approx(least, abs=1e-12)
        meeting += search.found.layout is not None and bool(search.found.layout.place.cores)
    assert meeting > 5


def test_the_bound_of_a_frame_is_below_all_its_layouts() -> None:
    for case in robots(12, OTHERS):
        for layout in case.everything():
            time = case.prices.time(layout)
            place = layout.place
            if time is not None:
                assert case.bounds.place(place.cores, place.limbs) <= time + 1e-12


def test_what_is_not_looked_at_counts_in_the_bound() -> None:
    case = Case(human_figure(), 4, DEFAULT)
    whole = case.searched()
    assert whole.lower == whole.found.best
    for limit in (0, 5, 40):
        some = case.searched(limit)
        assert some.spent.expanded <= limit
        assert some.lower <= whole.found.best <= some.found.best
    assert case.searched(0).lower < whole.found.best


def test_a_figure_is_proven_to_be_done_best_and_not_slower_by_more_processes() -> None:
    model = human_figure()
    schedules = [best_schedule(model, processes, DEFAULT) for processes in (2, 4)]
    for found in schedules:
        assert found.verdict == "optimal"
        assert found.makespan == predict(make_plan(model, found), DEFAULT).makespan
        assert {"alone", "gathered", "joined"} <= set(found.families)
        assert found.candidates > 1
    times = [found.makespan for found in schedules]
    assert times == sorted(times, reverse=True)


def test_what_gathers_can_be_emitted() -> None:
    case = Case(human_figure(), 4, DEFAULT)
    layout = case.searched().found.layout
    assert layout is not None
    plan = make_plan(case.model, case.schedule(layout))
    assert SHAPES["kernels"].why_not(plan) is None
    assert sum(bool(process.owns) for process in plan.processes) > 1
