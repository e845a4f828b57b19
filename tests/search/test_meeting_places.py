"""Meeting places of the branch and bound over layouts: a bound holds for all that come from it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from adagen.model import BASE, FLOATING, REVOLUTE, Model
from adagen.schedule import load_profile
from adagen.search.layouts import Layout, MeetingPlace
from adagen.search.meeting_places import in_place
from tests.cost.costs import step_profile
from tests.models import AXES, Part, assemble, random_tree, rod, vector
from tests.search.test_layout_search import Case
from tests.slow import all_but

Walk = Callable[[Case, np.random.Generator], list[MeetingPlace]]
PROFILES = {"default": load_profile("default"), "others": step_profile()}


def with_hands(hands: int, fingers: int, length: int, *, floating: bool) -> Model:
    """Return a robot with arms of one joint, on each a hand of fingers of unequal length.

    Arms hang on a floating base, or each by itself on the ground.
    """
    body = rod(0.5, vector(0.0, 0.0, 0.2))
    parts = [Part(BASE, None, FLOATING, body)] if floating else []
    for h in range(hands):
        place = vector(0.0, 0.1 * h, 0.2)
        y = vector(*AXES["y"])
        parts.append(Part(f"h{h}", BASE if floating else None, REVOLUTE, body, place, axis=y))
        for f in range(fingers):
            above, place = f"h{h}", vector(0.0, 0.05 * f, 0.2)
            for k in range(length + f % 3):
                name, axis = f"h{h}f{f}j{k}", vector(*AXES["xyz"[k % 3]])
                parts.append(Part(name, above, REVOLUTE, body, place, axis=axis))
                above = name
    return assemble("hands", parts, floating)


def by_chance(case: Case, rng: np.random.Generator) -> list[MeetingPlace]:
    """Return some meeting places each of which comes from the one before."""
    search = case.searched(limit=0)
    more, found = search.places.first(), []
    while more:
        found.append(more[int(rng.integers(len(more)))])
        more = search.places.after(found[-1]) if rng.random() < 0.9 else []
    return found


def to_the_hands(case: Case, _: np.random.Generator) -> list[MeetingPlace]:
    """Return places each of which comes from the one before, the last with all arms in cores."""
    places = case.searched(limit=0).places
    more, found = places.first(), []
    while more:
        found.append(more[0])
        more = places.after(found[-1])
    return found


def handed_out(case: Case, place: MeetingPlace, rng: np.random.Generator) -> float | None:
    """Return the time of a layout of a place whose limbs are distributed by chance, if it has one.

    Limbs are distributed in turn, which loads processes about evenly.
    """
    order = rng.permutation(len(place.limbs))
    processes = int(rng.integers(2, case.processes + 1))
    shares = [sorted(int(k) for k in order[p::processes]) for p in range(case.processes)]
    shares[processes:] = [[]] * (case.processes - processes)
    layout = Layout(place, tuple(map(tuple, shares)))
    if any(len(layout.taking_part(core.tree)) < 2 for core in place.cores):
        return None
    return case.prices.time(layout) if in_place(layout, case.robot) else None


def hold(case: Case, rng: np.random.Generator, walks: int, walk: Walk = by_chance) -> int:
    """Compare layouts with the bounds of all places that theirs comes from; return how many."""
    seen = 0
    for _ in range(walks):
        places = walk(case, rng)
        time = handed_out(case, places[-1], rng)
        if time is not None:
            bounds = [case.bounds.place(place.cores, place.limbs) for place in places]
            assert max(bounds) <= time + 1e-9, (places[-1].cores, bounds, time)
            seen += 1
    return seen


@pytest.mark.parametrize("profile", all_but(PROFILES, "others"))
@pytest.mark.parametrize("floating", [True, False], ids=["floating", "grounded"])
def test_bounds_hold_for_robots_with_hands(profile: str, floating: bool) -> None:
    """Processes that share out fingers are done before one could pass a hand by itself."""
    case = Case(with_hands(2, 8, 12, floating=floating), 8, PROFILES[profile])
    assert hold(case, np.random.default_rng(0), 3, to_the_hands) == 3
    assert hold(case, np.random.default_rng(1), 10)


@pytest.mark.parametrize("profile", all_but(PROFILES, "others"))
def test_bounds_hold_for_random_robots(profile: str) -> None:
    """Fifteen trees of many limbs, up to eight processes."""
    seen = 0
    for seed in range(15):
        rng = np.random.default_rng(seed)
        robot = random_tree(rng, 10 + 2 * seed, branching=0.5, floating=seed % 2 == 0)
        seen += hold(Case(robot, 2 + seed % 7, PROFILES[profile]), rng, 20)
    assert seen > 50
