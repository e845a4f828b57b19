"""The commands solve the same robot, whichever notation closes its loops."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import adagen
from adagen.cli.main import main
from adagen.errors import InputError
from adagen.library import read
from adagen.reference.closed import closed_forward_dynamics, closed_states
from adagen.states import States, read_result, write_states
from tests.urdf.texts import joint, link, robot


def bar(length: float) -> str:
    return f'<origin xyz="{length} 0 0"/>'


TREE = (
    *(link(name) for name in ("ground", "crank", "coupler", "rocker")),
    joint("drive", "ground", "crank", origin=bar(0.0)),
    joint("elbow", "crank", "coupler", origin=bar(0.2)),
    joint("foot", "ground", "rocker", origin=bar(0.45)),
    link("eye"),
    joint("wrist", "coupler", "eye", origin=bar(0.55)),
    link("pin"),
    joint("tip", "rocker", "pin", "fixed", "", bar(0.4)),
)
"""A crank, a coupler with an eye that turns on it, and a rocker with a pin."""

WELDED = '<loop name="l" type="fixed"><predecessor link="eye"/><successor link="pin"/></loop>'


@pytest.fixture
def files(tmp_path: Path) -> dict[str, list[str]]:
    """The words that name the robot, in each notation."""
    texts = {
        "tree.urdf": robot(*TREE),
        "plus.urdf": robot(*TREE, WELDED),
        "twice.urdf": robot(*TREE, joint("close", "eye", "pin", "fixed", "", bar(0.0))),
        "loops.yaml": "closed_loop: [[wrist, tip]]\n",
        "scene.toml": '[[loops]]\nkind = "weld"\nlink1 = "eye"\nlink2 = "pin"\n',
    }
    for name, text in texts.items():
        (tmp_path / name).write_text(text)
    tree = str(tmp_path / "tree.urdf")
    return {
        "scene": [tree, "--scene", str(tmp_path / "scene.toml")],
        "loop": [str(tmp_path / "plus.urdf")],
        "second parent": [str(tmp_path / "twice.urdf")],
        "frame pairs": [tree, "--loops", str(tmp_path / "loops.yaml")],
    }


def test_all_notations_are_solved_alike(
    files: dict[str, list[str]], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    model = read(tmp_path / "tree.urdf", scene=tmp_path / "scene.toml").model
    q, v = closed_states(model, 2, seed=3)
    tau = np.random.default_rng(4).uniform(-1.0, 1.0, (2, model.nv))
    write_states(States(q, v, tau), model, tmp_path / "states.json")
    words = ["--procs", "1", "--states", str(tmp_path / "states.json")]
    told: dict[str, str] = {}
    answers: dict[str, NDArray[np.float64]] = {}
    for name, model_words in files.items():
        result = tmp_path / "result.json"
        assert main(["solve", *model_words, *words, "--result", str(result), "-v"]) == 0
        told[name] = capsys.readouterr().err
        answers[name] = read_result(result, model)
    wanted = np.array([closed_forward_dynamics(model, *s) for s in zip(q, v, tau, strict=True)])
    for found in answers.values():
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-9 * abs(wanted).max())
        np.testing.assert_array_equal(found, answers["scene"])
    assert '"close" closes a loop (weld)' in told["second parent"]
    assert 'note: <loop> elements: 1, read: "l"' in told["loop"]
    assert 'loops: 1, read: "wrist-tip" (weld)' in told["frame pairs"]


def test_a_second_parent_is_warned_of_without_being_asked(
    files: dict[str, list[str]], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["info", "--json", *files["second parent"]]) == 0
    out, err = capsys.readouterr()
    assert err.count('link "pin" has two parent joints, "tip" and "close"') == 1
    assert [each["name"] for each in json.loads(out)["joints"]] == [
        "drive", "elbow", "wrist", "foot",
    ]  # fmt: skip


TRIANGLE = (
    *(link(name) for name in ("ground", "strut", "tie", "arm")),
    joint("foot", "ground", "strut", origin=bar(0.0)),
    joint("apex", "strut", "tie", origin=bar(0.5)),
    *('<loop name="pin" type="revolute"><predecessor link="tie">', bar(0.4), "</predecessor>"),
    *('<successor link="ground">', bar(0.6), '</successor><axis xyz="0 1 0"/></loop>'),
)
"""Two bars between two points of the ground: nothing moves. An arm may hang on it."""


@pytest.mark.parametrize("free", [False, True])
def test_what_closed_loops_let_not_move_is_told(
    free: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    kind, axis = ("revolute", '<axis xyz="0 1 0"/>') if free else ("fixed", "")
    path = tmp_path / "triangle.urdf"
    path.write_text(robot(*TRIANGLE, joint("elbow", "tie", "arm", kind, axis, bar(0.2))))
    words = [str(path), "--procs", "1", "--out", str(tmp_path / "out"), "-q"]
    assert main(words) == int(not free)
    told = capsys.readouterr().err
    if free:
        assert 'warning: closed loops leave joints "foot", "apex" no motion' in told
        return
    assert (
        f'{path}: error: nothing to solve: closed loops ("pin") leave no joint any motion' in told
    )
    assert "--floating" in told
    with pytest.raises(InputError, match="leave no joint any motion"):
        adagen.compile(read(path))
    assert main([*words, "--loop-forces"]) == 0
    assert capsys.readouterr().err == ""


def test_axes_that_are_not_quite_parallel_are_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """As of angles that were written with five digits."""
    tilted = WELDED.replace('link="pin"/>', 'link="pin"><origin rpy="3.7e-6 0 0"/></successor>')
    path = tmp_path / "tilted.urdf"
    path.write_text(robot(*TREE, tilted))
    assert main([str(path), "--procs", "1", "--out", str(tmp_path / "out")]) == 1
    told = capsys.readouterr().err
    assert "axes are not quite parallel, or frames not exact" in told
    assert "take a kind that holds less" in told
