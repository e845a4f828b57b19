"""adagen solve tells of digits that its answers lack."""

from __future__ import annotations

import json
import math
import re
import subprocess
import sys
from pathlib import Path
from subprocess import PIPE

import numpy as np
import pytest

from adagen.cli.main import main
from adagen.library import Origin
from adagen.library.robot import read_whole
from adagen.states import random_states, write_states
from tests.cli.robots import BALL
from tests.urdf.texts import Y, joint, link, robot


def solved(shape: str, folder: Path) -> tuple[int, Path]:
    """Solve five states of a robot that loses digits in loops; status and result."""
    robot, states, result = (folder / name for name in ("b.urdf", "s.json", "r.json"))
    robot.write_text(BALL)
    model = read_whole(Origin(robot, False, False, False, None, None))[0].model
    write_states(random_states(model, 5, seed=1), model, states)
    words = ["solve", str(robot), "--procs", "1", "--shape", shape, "--states", str(states)]
    return main([*words, "--result", str(result)]), result


def test_answers_without_sure_digits_are_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    status, result = solved("kernels", tmp_path)
    told = capsys.readouterr().err
    assert status == 0
    assert re.search(
        r"warning: \d\.\d digits of the accelerations are certain: state \d, joint ", told
    )
    loops = json.loads(result.read_text())["joints"]["along"]["qdd"]
    status, result = solved("unrolled", tmp_path)
    assert status == 0
    assert "digits of the accelerations" not in capsys.readouterr().err
    line = json.loads(result.read_text())["joints"]["along"]["qdd"]
    assert 1e-9 < np.abs(np.subtract(loops, line)).max() / np.abs(line).max() < 1e-1


@pytest.mark.parametrize("name", ["-", "/dev/fd/0"])
def test_states_may_come_through_a_pipe(tmp_path: Path, name: str) -> None:
    """Their text is there once, and gravity and states are in it."""
    path, earth, moon = (tmp_path / file for file in ("arm.urdf", "earth.json", "moon.json"))
    path.write_text(robot(link("a"), link("b"), joint("j", "a", "b", inside=Y)))
    model = read_whole(Origin(path, False, False, False, None, None))[0].model
    write_states(random_states(model, 3, seed=1), model, earth)
    moon.write_text(earth.read_text().replace("-9.81", "-1.62"))
    answers = []
    for given in (earth, moon):
        words = ["solve", str(path), "--procs", "1", "--states", name]
        command = [sys.executable, "-m", "adagen", *words]
        with given.open() as pipe, subprocess.Popen(["cat"], stdin=pipe, stdout=PIPE) as cat:
            done = subprocess.run(
                command, stdin=cat.stdout, capture_output=True, text=True, timeout=100
            )
        assert (done.returncode, done.stderr) == (0, "")
        from_file = tmp_path / "file.json"
        assert main([*words[:-1], str(given), "--result", str(from_file)]) == 0
        assert done.stdout == from_file.read_text()
        answers.append(done.stdout)
    assert answers[0] != answers[1]


def test_a_quiet_command_says_why_it_fails(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, states = tmp_path / "gimbal.urdf", tmp_path / "s.json"
    links = [link("a"), link("b", ""), link("c", ""), link("d")]
    axes = ("1 0 0", "0 1 0", "0 0 1")
    joints = [
        joint(f"j{k}", "abc"[k], "bcd"[k], inside=f'<axis xyz="{axis}"/>', origin="")
        for k, axis in enumerate(axes)
    ]
    path.write_text(robot(*links, *joints))
    rest = {"v": [0.0], "tau": [0.0]}
    locked = {f"j{k}": {"q": [q], **rest} for k, q in enumerate((0.0, math.pi / 2, 0.0))}
    states.write_text(json.dumps({"joints": locked}))
    said = []
    for words in ([], ["--quiet"]):
        assert main(["solve", str(path), "--procs", "1", "--states", str(states), *words]) == 1
        said.append(capsys.readouterr().err)
    assert 'state 1: joint "j0": factorization failed' in said[1]
    assert set(said[1].splitlines()) <= set(said[0].splitlines())
