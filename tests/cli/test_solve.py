"""adagen solve tells of digits that its answers lack."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from adagen.cli.main import main
from adagen.library import Origin
from adagen.library.robot import read_whole
from adagen.states import random_states, write_states
from tests.cli.test_generate import BALL


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
        r"warning: \d\.\d digits of the accelerations are sure: state \d, joint ", told
    )
    loops = json.loads(result.read_text())["joints"]["along"]["qdd"]
    status, result = solved("unrolled", tmp_path)
    assert status == 0
    assert "digits of the accelerations" not in capsys.readouterr().err
    line = json.loads(result.read_text())["joints"]["along"]["qdd"]
    assert 1e-9 < np.abs(np.subtract(loops, line)).max() / np.abs(line).max() < 1e-1
