"""Random robots and options: robots can be read, and what fails is told apart."""

from __future__ import annotations

import random
from itertools import islice
from pathlib import Path

import pytest

from adagen.library import read
from benchmarks.random_programs import cases, humanoid, outcome, readable


def test_humanoids_have_alike_limbs_that_can_be_read(tmp_path: Path) -> None:
    sizes = set()
    for seed in range(12):
        file = tmp_path / f"{seed}.urdf"
        file.write_text(humanoid(random.Random(seed)))
        sizes.add(len(read(file).model.joints))
    assert len(sizes) > 8
    assert max(sizes) > 30


def test_the_same_seed_gives_the_same_commands(tmp_path: Path) -> None:
    first, again = (list(islice(cases(3, tmp_path), 6)) for _ in range(2))
    assert first == again


def test_robots_may_be_given_and_those_that_are_refused_are_left_out(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    robot, spoilt = tmp_path / "robot.urdf", tmp_path / "spoilt.urdf"
    robot.write_text(humanoid(random.Random(1)))
    spoilt.write_text("<robot/>")
    assert readable([spoilt, robot]) == [robot]
    assert "left out: " in capsys.readouterr().out
    assert {case[0] for case in islice(cases(3, tmp_path, [robot]), 6)} == {str(robot)}


def test_refusals_and_faults_are_told_apart(tmp_path: Path) -> None:
    robot = tmp_path / "robot.urdf"
    robot.write_text(humanoid(random.Random(1)))
    assert outcome([str(robot), "--shape", "nothing"], tmp_path / "a") == ("refused", "")
    assert outcome([str(tmp_path / "none.urdf")], tmp_path / "b") == ("refused", "")
    (tmp_path / "c").write_text("a file where the folder should be")
    found, said = outcome([str(robot)], tmp_path / "c")
    assert found == "not generated"
    assert "cannot write" in said
