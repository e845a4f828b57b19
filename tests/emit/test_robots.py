"""Emitted programs of unusual robots, schedules and scalars are right, whatever the channel."""

from __future__ import annotations

from pathlib import Path

import pytest

from adagen.states import random_states, write_states
from tests.emit.unusual import CASES, anything, chain_with_thin_link, require_solved
from tests.emitted import Builder, plan_of
from tests.slow import spread


@pytest.mark.parametrize("name", spread(CASES, 3))
def test_an_unusual_robot_is_solved(name: str, builder: Builder, tmp_path: Path) -> None:
    require_solved(name, builder, tmp_path)


def test_a_processes_share_can_be_nothing() -> None:
    plan = CASES["more processes than joints"].plan(anything(5, 2))
    assert [bool(process.owns) for process in plan.processes].count(False) >= 2


def test_a_failed_factorization_names_the_joint(builder: Builder, tmp_path: Path) -> None:
    model = chain_with_thin_link()
    solver = builder.solver(plan_of(model, 2, scalar="float", form="ada"), name="thin")
    write_states(random_states(model, 2), model, tmp_path / "s.json")
    done = solver.run("--states", tmp_path / "s.json", "--result", tmp_path / "r.json")
    assert (done.status, done.stdout) == (1, "")
    (line,) = done.stderr.splitlines()
    assert line.startswith(f'{tmp_path}/s.json: error: state 1: joint "j00')
    assert "factorization failed" in line
    assert not (tmp_path / "r.json").exists()
