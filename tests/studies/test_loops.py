"""Studies of robots with closed loops: charts, contests, stability, motions."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from adagen.cli.main import main
from adagen.errors import EnvironmentFault
from adagen.library import read
from adagen.model import canonical
from adagen.studies.bench.peers import contestants, missing
from adagen.studies.bench.peers.pinocchio_loops import constraint_lines
from adagen.studies.chart.motion import Played, drifts
from adagen.studies.random_states import drawn_states
from adagen.studies.truth import DOUBLE, truth_of
from tests.mechanisms import four_bar, geared, looped_tree, quadruped, slider_crank

MODELS = Path(__file__).resolve().parents[2] / "generated_examples" / "models"
BARS = [str(MODELS / "fourbar.urdf"), "--scene", str(MODELS / "fourbar.toml")]


@pytest.mark.slow
def test_a_chart_has_errors_from_the_truth_of_closed_states(tmp_path: Path) -> None:
    words = ["--procs", "1", "--scalars", "double", "--algorithms", "segment,ada", "--quick"]
    assert main(["chart", *BARS, *words, "--no-picture", "--out", str(tmp_path)]) == 0
    chart = json.loads((tmp_path / "chart_fourbar.json").read_text())
    points = [point for point in chart["points"] if point["why"] is None]
    assert {point["algorithm"] for point in points} >= {"segment", "ada"}
    assert all(0 < point["error"] < 1e-11 and point["residual"] < 1e-11 for point in points)
    assert all(point["time_ns"] > 0 for point in points)


def test_a_chart_refuses_states_in_which_a_loop_is_open(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    states = tmp_path / "states.json"
    joints = read(BARS[0], scene=BARS[2]).model.joints
    still = {joint.name: {"q": [0.3], "v": [0.0], "tau": [0.0]} for joint in joints}
    states.write_text(json.dumps({"joints": still}))
    words = ["--states", str(states), "--no-picture", "--out", str(tmp_path)]
    assert main(["chart", *BARS, *words]) == 1
    assert 'state 1: loop "pin": it is open by' in capsys.readouterr().err


def test_a_contest_leaves_out_who_has_no_loops(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["--variant", "--procs 1", "--peers", "mujoco", "--rounds", "1", "--json"]
    assert main(["bench", *BARS, *words]) == 0
    (found,) = json.loads(capsys.readouterr().out)["models"]
    assert [row["team"] for row in found["rows"]] == ["adagen"]
    assert found["rows"][0]["forward_error"] < 1e-11
    if missing("mujoco") is None:
        assert found["absent"]["mujoco"] == "it has no rigid closed loops"


def test_stability_judges_a_linkage(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["--shape", "unrolled", "--procs", "1", "--scalar", "double", "--states", "6"]
    assert main(["stability", *BARS, *words, "--json"]) == 0
    (cell,) = json.loads(capsys.readouterr().out)
    assert cell["verdict"] == "right"
    assert cell["error"] < 1e-9


def test_what_pinocchio_gets() -> None:
    model = canonical(four_bar())
    lines, shift = constraint_lines(model, drawn_states(model, 1).q[0])
    assert [line.split()[0] for line in lines] == ["point"]  # it takes no more in a plane
    assert shift > 0  # and one of its rows is zero
    model = canonical(looped_tree("weld", 3, joints=9))
    assert constraint_lines(model, drawn_states(model, 1).q[0])[0][0].startswith("weld")
    model = canonical(quadruped())
    assert constraint_lines(model, drawn_states(model, 1).q[0])[1] == 0.0
    model = canonical(geared())
    with pytest.raises(EnvironmentFault, match="no couplings"):
        constraint_lines(model, drawn_states(model, 1).q[0])


@pytest.mark.slow
@pytest.mark.parametrize("make", [four_bar, slider_crank, quadruped])
def test_pinocchio_solves_the_same_loops(make: object, tmp_path: Path) -> None:
    if missing("pinocchio"):
        pytest.skip("pinocchio is not installed")
    assert callable(make)
    model = make()
    truth = truth_of(model, 4, seed=0, digits=DOUBLE)
    errors = {
        one.name: truth.errors(one.solve(truth.states)).forward
        for one in contestants("pinocchio", model, truth.states, tmp_path)
    }
    assert any("lcaba" in name for name in errors)
    assert all(error < 1e-6 for name, error in errors.items() if "Dynamics" in name)
    assert min(errors.values()) < 1e-9


def test_a_loop_to_the_ground_keeps_no_momentum() -> None:
    model = quadruped()
    states = drawn_states(model, 1)
    motion = Played(np.zeros(2), np.vstack([states.q] * 2), np.vstack([states.v] * 2), 0.0)
    assert drifts(model, motion) == (0.0, None)
