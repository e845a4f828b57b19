"""`adagen info`: what was read, and a states file that every command takes."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from adagen.cli.main import main
from adagen.library import read
from adagen.reference.closed import constraints
from adagen.states import read_states
from adagen.urdf import read_robot

MODELS = Path(__file__).resolve().parents[2] / "generated_examples" / "models"
ARM = MODELS / "arm7.urdf"
HUMAN = MODELS / "human40.urdf"


def test_the_table_names_every_joint_whole(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["info", str(ARM)]) == 0
    said = capsys.readouterr().out
    assert "arm7: 9 joints, 9 degrees of freedom, fixed base, 15.45 kg" in said
    assert "9, not modelled" in said
    assert "…" not in said


def test_json_has_places_and_masses(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["info", str(ARM), "--mimic", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    model = read_robot(ARM, mimic=True).model
    assert (data["nq"], data["nv"]) == (model.nq, model.nv)
    assert [each["name"] for each in data["joints"]] == [joint.name for joint in model.joints]
    assert [each["v"][0] for each in data["joints"]] == list(model.v_start)
    assert data["mass"] == pytest.approx(sum(link.inertia.mass for link in model.links[1:]))
    slaved = data["joints"][-1]
    assert slaved["mimic"]["joint"] == "left_finger_slide"
    assert data["not_modelled"]
    assert read(ARM, mimic=True).data == data


@pytest.mark.parametrize(("path", "base"), [(ARM, ["--floating"]), (HUMAN, [])])
def test_the_states_file_is_read_back(
    path: Path, base: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["info", str(path), *base, "--states", "3"]) == 0
    (tmp_path / "states.json").write_text(capsys.readouterr().out)
    model = read_robot(path, floating=bool(base)).model
    states = read_states(tmp_path / "states.json", model)
    assert states.count == 3
    assert not states.v.any()
    assert not states.tau.any()
    for j, joint in enumerate(model.joints):
        if joint.kind.quaternion is not None:
            at = model.q_start[j] + joint.kind.quaternion
            assert np.array_equal(states.q[:, at : at + 4], [[0.0, 0.0, 0.0, 1.0]] * 3)


def test_a_scene_shows_what_it_leaves(capsys: pytest.CaptureFixture[str]) -> None:
    scene = MODELS / "arm7_payload.toml"
    assert main(["info", str(ARM), "--scene", str(scene), "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert len(data["joints"]) <= 9


def test_wrong_words_are_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["info", str(ARM), "--states", "0"]) == 2
    assert main(["info", str(ARM), "--json", "--states", "1"]) == 2
    assert "error:" in capsys.readouterr().err


ANKLE = [str(MODELS / "ankle.urdf"), "--scene", str(MODELS / "ankle.toml")]


def test_loops_are_shown_and_states_to_fill_in_are_closed(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert main(["info", *ANKLE]) == 0
    assert "loop left_heel: spherical, left_rod to foot" in capsys.readouterr().out
    assert main(["info", *ANKLE, "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert [loop["name"] for loop in data["loops"]] == ["left_heel", "right_heel"]
    assert main(["info", *ANKLE, "--states", "3"]) == 0
    path = tmp_path / "states.json"
    path.write_text(capsys.readouterr().out)
    model = read(ANKLE[0], scene=ANKLE[2]).model
    states = read_states(path, model)
    assert states.q.shape == (3, model.nq)
    for q in states.q:
        assert np.abs(constraints(model, q).gaps).max() < 1e-11
