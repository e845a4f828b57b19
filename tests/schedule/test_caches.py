"""What a profile's second-level cache decides of long chains and batches."""

from __future__ import annotations

from dataclasses import replace

import pytest

from adagen.emit import emit, program_of
from adagen.emit.shapes import MOST_FREEDOMS_IN_BATCHES
from adagen.library.request import Request
from adagen.plan import make_plan
from adagen.schedule import CostProfile, load_profile
from adagen.schedule.caches import solved_in_lanes, swept_whole
from adagen.search import best_schedule
from tests.emitted import plan_of
from tests.models import serial_chain


def with_cache(size: float) -> CostProfile:
    """Return the profile of a machine like the first one, but for its second-level cache."""
    profile = load_profile("xeon")
    table = {**profile.measured.table, "process.cache": size}
    return replace(profile, steps=replace(profile.measured, table=table))


SMALL, USUAL, LARGE = (with_cache(size) for size in (1 << 18, 2 << 20, 8 << 20))


def test_limits_are_in_proportion_to_the_cache() -> None:
    assert [swept_whole(each.measured) for each in (SMALL, USUAL)] == [187, 1497]
    for profile, joints in ((SMALL, 512), (USUAL, 512), (LARGE, 1198)):
        found = [solved_in_lanes(joints + k, profile.measured) for k in range(2)]
        assert found == [True, False]
    assert solved_in_lanes(MOST_FREEDOMS_IN_BATCHES, SMALL.measured)


def test_four_states_in_lanes_are_solved_at_once_at_any_length() -> None:
    assert solved_in_lanes(5000, load_profile("avx2").measured)


def test_a_smaller_cache_has_tiles_of_shorter_chains() -> None:
    plan = plan_of(serial_chain(300), 1)
    tiles = [program_of(plan, "kernels", profile=each).slots.tile for each in (SMALL, USUAL)]
    assert tiles == [128, 0]


def test_without_a_cache_chains_of_more_than_a_tile_are_in_tiles() -> None:
    none = with_cache(0.0)
    assert program_of(plan_of(serial_chain(129), 1), "kernels", profile=none).slots.tile == 128
    assert program_of(plan_of(serial_chain(128), 1), "kernels", profile=none).slots.tile == 0


@pytest.mark.parametrize("joints", [512, 513, 1198, 1199])
def test_batches_are_solved_in_parts_where_lanes_would_not_fit(joints: int) -> None:
    request = Request(batch=True)
    assert request.may_part(joints, USUAL.measured) == (joints > 512)
    assert request.may_part(joints, LARGE.measured) == (joints > 1198)


def test_a_batch_is_told_the_cache_if_it_is_another_one() -> None:
    plan = make_plan(serial_chain(8), best_schedule(serial_chain(8), 1, USUAL))
    small, usual = (emit(plan, name="a", batch=1, profile=each) for each in (SMALL, USUAL))
    assert "static constexpr std::size_t kCache = 262144;" in small["a_p1.cpp"]
    assert "kCache" not in usual["a_p1.cpp"]
    assert "kCache" not in emit(plan, name="a", profile=SMALL)["a_p1.cpp"]
