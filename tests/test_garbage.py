"""Python looks for cycles less often while a robot is compiled, and as before afterwards."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

import pytest

from adagen.garbage import ALLOCATIONS, seldom_collected

USUAL = (701, 11, 12)


@pytest.fixture(autouse=True)
def usual() -> Iterator[None]:
    before = gc.get_threshold()
    gc.set_threshold(*USUAL)
    yield
    gc.set_threshold(*before)


def failing() -> None:
    with seldom_collected():
        assert gc.get_threshold() == (ALLOCATIONS, *USUAL[1:])
        raise ZeroDivisionError


def test_what_was_set_comes_back() -> None:
    with pytest.raises(ZeroDivisionError):
        failing()
    assert gc.get_threshold() == USUAL


def test_the_last_thread_that_leaves_brings_it_back() -> None:
    together = Barrier(2, timeout=20)

    def work(leaves_first: bool) -> int:
        with seldom_collected():
            together.wait()  # both are inside
            if not leaves_first:
                together.wait()  # the other one has left
            return gc.get_threshold()[0]

    with ThreadPoolExecutor(2) as pool:
        first, second = pool.submit(work, True), pool.submit(work, False)
        assert first.result(20) == ALLOCATIONS
        together.wait()
        assert second.result(20) == ALLOCATIONS
    assert gc.get_threshold() == USUAL


@pytest.mark.parametrize("seldom", [2 * ALLOCATIONS, 0])
def test_who_wants_fewer_or_none_is_left_alone(seldom: int) -> None:
    gc.set_threshold(seldom)
    with seldom_collected():
        assert gc.get_threshold()[0] == seldom
    assert gc.get_threshold()[0] == seldom
