"""What a process takes at least for some limbs, beside what it takes."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.schedule import load_profile
from adagen.search.assignment import Assignment
from adagen.search.incumbent import Incumbent, Spent
from tests.cost.costs import step_profile
from tests.search.test_layout_search import Case
from tests.search.test_meeting_places import by_chance, to_the_hands, with_hands

PROFILES = {"default": load_profile("default"), "others": step_profile()}


@pytest.mark.parametrize("floating", [False, True], ids=["fixed", "floating"])
@pytest.mark.parametrize("profile", PROFILES)
def test_no_process_takes_less_than_its_floor(profile: str, floating: bool) -> None:
    """Random sets of fingers, of arms and of what lies towards the ground."""
    rng = np.random.default_rng(5)
    case = Case(with_hands(2, 3, 2, floating=floating), 3, PROFILES[profile])
    looked_at = close = 0
    for place in [*to_the_hands(case, rng), *(f for _ in range(6) for f in by_chance(case, rng))]:
        found = Incumbent(case.prices, case.bounds, Spent(10**6))
        hand_out = Assignment(found, place, 0.0)
        for _ in range(40):
            counts = tuple(int(rng.integers(0, len(own) + 1)) for own in hand_out.classes)
            block = hand_out._block(counts) if any(counts) else None
            if block is None:
                continue
            bound = hand_out._least(counts)
            looked_at += 1
            close += bound.total > 0.7 * block.total
            assert bound.total <= block.total + 1e-9
            assert bound.before <= block.before + 1e-9
            assert bound.after <= block.after + 1e-9
    assert looked_at > 50
    assert close > 20
