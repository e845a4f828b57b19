"""Turns, their medians, and contestants that fail."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import pytest

from adagen.errors import EnvironmentFault
from adagen.reference import (
    energy_norm_error,
    exact_forward_dynamics,
    forward_dynamics,
    joint_space_inertia,
)
from adagen.states import random_states
from adagen.studies.bench import Contestant, Rules, hold
from adagen.studies.bench.contest import Turn
from adagen.studies.truth import DOUBLE, refined, truth_of
from tests.models import serial_chain


def contestant(name: str, turn: Callable[[int], dict[str, Turn]]) -> Contestant:
    return Contestant(name, name, "none", 1, "double", lambda states: states.tau, turn)


def test_turns_go_round_and_every_other_round_backwards() -> None:
    order: list[str] = []

    def timed(name: str) -> Contestant:
        def turn(repeat: int) -> dict[str, Turn]:
            assert repeat == 7
            order.append(name)
            return {"in_place": Turn(1.0, 1.0)}

        return contestant(name, turn)

    hold([timed(name) for name in "abc"], Rules(rounds=3, repeat=7), lambda _: None)
    assert "".join(order) == "abccbaabc"


def test_medians_of_turns_and_the_least_of_all() -> None:
    turns: Iterator[tuple[float, float]] = iter([(5.0, 4.0), (9.0, 1.0), (6.0, 5.0)])
    one = contestant("one", lambda _: {"in_place": Turn(*next(turns))})
    times, gone = hold([one], Rules(rounds=3), lambda _: None)
    found = times["one"]["in_place"]
    assert (found.median, found.least, found.turns) == (6.0, 1.0, (5.0, 9.0, 6.0))
    assert gone == {}


def failing(after: int) -> Callable[[int], dict[str, Turn]]:
    left = after

    def turn(_: int) -> dict[str, Turn]:
        nonlocal left
        left -= 1
        if left < 0:
            raise EnvironmentFault("it died")
        return {"in_place": Turn(1.0, 1.0)}

    return turn


def test_who_fails_once_is_out_and_the_others_go_on() -> None:
    field = [contestant("bad", failing(1)), contestant("good", failing(9))]
    times, gone = hold(field, Rules(rounds=4), lambda _: None)
    assert list(times) == ["good"] and len(times["good"]["in_place"].turns) == 4
    assert gone == {"bad": "it died"}


def test_nobody_left_is_an_error() -> None:
    with pytest.raises(EnvironmentFault, match="nothing could be timed: it died"):
        hold([contestant("bad", failing(0))], Rules(rounds=2), lambda _: None)


def test_right_and_wrong_answers_are_told_apart() -> None:
    model = serial_chain(5)
    states = random_states(model, 3, seed=4)
    truth = truth_of(model, states, digits=DOUBLE)
    right = np.array([forward_dynamics(model, *state) for state in states.each])
    assert truth.errors(right).forward < 1e-11 and truth.errors(right).residual < 1e-11
    wrong = truth.errors(right * (1 + 1e-4))
    assert wrong.forward == pytest.approx(1e-4, rel=1e-3) and wrong.residual > 1e-7
    assert truth.errors(np.full_like(right, np.nan)).forward == np.inf


@pytest.mark.parametrize("joints", [1, 12, 60])
def test_refinement_finds_what_ball_arithmetic_proves(joints: int) -> None:
    model = serial_chain(joints, floating=joints == 12)
    states = random_states(model, 1, seed=joints)
    state = (states.q[0], states.v[0], states.tau[0])
    truth = exact_forward_dynamics(model, *state).value
    inertia = joint_space_inertia(model, state[0])
    assert energy_norm_error(inertia, refined(model, *state) - truth, truth) < 1e-14
    if joints == 60:  # it has something to do there
        plain = forward_dynamics(model, *state)
        assert energy_norm_error(inertia, plain - truth, truth) > 1e-14


def test_states_of_a_truth_are_those_given() -> None:
    model = serial_chain(3)
    states = random_states(model, 2)
    truth = truth_of(model, states)
    assert truth.states is states and truth.exact.shape == (2, model.nv)
