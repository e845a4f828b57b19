"""States of studies: closed, away from singular poses, and refused where they are open."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.errors import InputError
from adagen.reference.closed import constraints
from adagen.states import random_states
from adagen.studies.random_states import check_closed, drawn_states
from tests.mechanisms import MECHANISMS, four_bar
from tests.models import serial_chain


@pytest.mark.parametrize("name", MECHANISMS)
def test_states_are_closed(name: str) -> None:
    model = MECHANISMS[name]()
    states = drawn_states(model, 5, seed=2)
    assert states.count == 5
    check_closed(model, states)
    for q, v in zip(states.q, states.v, strict=True):
        found = constraints(model, q)
        assert np.abs(found.gaps).max() < 1e-10
        assert np.abs(found.rows @ v).max() < 1e-10


def test_states_of_trees_are_random_ones() -> None:
    model = serial_chain(3)
    assert np.array_equal(drawn_states(model, 4, 3).q, random_states(model, 4, 3).q)


def test_an_open_loop_is_refused_by_name() -> None:
    model = four_bar()
    states = drawn_states(model, 2)
    states.q[1, 0] += 0.01
    with pytest.raises(InputError, match=r'state 2: loop "pin": it is open by 0\.00'):
        check_closed(model, states)


def test_a_loop_that_cannot_close_has_no_states() -> None:
    model = four_bar()
    model.loops[0].frame2.translation[0] = 5.0
    with pytest.raises(InputError, match='"pin" cannot be closed'):
        drawn_states(model, 2)
