"""``--reproducible`` on the command line: what is emitted, said, solved and refused."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from adagen.cli import main
from adagen.library.command import command_in
from tests.golden.make_models import MODELS

ARM, FIGURE, MOBILE = (str(MODELS / f"{name}.urdf") for name in ("arm7", "humanoid", "mobile"))


def test_the_head_makes_it_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = [MOBILE, "--reproducible", "--scalar", "float", "--procs", "1", "--out", str(tmp_path)]
    assert main(words) == 0
    source = (tmp_path / "mobile_p1.cpp").read_text()
    assert ", shape unrolled (" in source
    assert ", scalar float, reproducible, " in source
    command = command_in(source)
    assert command is not None
    assert "--reproducible" in command
    plan = json.loads((tmp_path / "mobile_p1.plan.json").read_text())
    assert plan["reproducible"] is True
    assert main(["verify", str(tmp_path)]) == 0
    assert capsys.readouterr().err.endswith("1 solver: up to date\n")


def test_a_chain_is_done_by_one_process_and_that_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([ARM, "--reproducible", "--procs", "2", "--out", str(tmp_path)]) == 0
    assert "2 processes do not pay" in capsys.readouterr().err
    assert "process 1: nothing" in (tmp_path / "arm7_p2.cpp").read_text()


def test_a_schedule_says_so_and_is_taken_back(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["schedule", FIGURE, "--reproducible", "--procs", "2", "--json"]
    assert main(words) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["reproducible"], told["shape"]) == (True, "unrolled")
    given = tmp_path / "schedule.json"
    given.write_text(json.dumps(told))
    assert main([FIGURE, "--reproducible", "--schedule", str(given), "--out", str(tmp_path)]) == 0


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--form", "ada"), "form ada joins in an order that depends on the number of processes"),
        (("--refine", "1"), "answers are refined in loops"),
        (("--shape", "kernels"), "only straight lines are reproducible"),
        (("--schedule", "balanced"), "joined at a cut round differently from one process"),
    ],
)
def test_what_is_not_reproducible_is_refused(
    words: tuple[str, ...], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    given = [FIGURE, "--reproducible", "--procs", "2", *words, "--out", str(tmp_path)]
    assert main(given) == 2
    assert said in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
def test_answers_are_those_of_two_processes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("CXXFLAGS", "-O1 -march=native -ffp-contract=fast")
    assert main(["info", ARM, "--states", "2"]) == 0
    states = json.loads(capsys.readouterr().out)
    for k, joint in enumerate(states["joints"].values()):
        joint.update(q=[0.3 * k, 1e9], v=[1.0, -2.0], tau=[0.1 * k, 3.0])
    given = tmp_path / "states.json"
    given.write_text(json.dumps(states))
    found = []
    for words in (("--procs", "1"), ("--procs", "2"), ("--procs", "1", "--batch")):
        result = tmp_path / "result.json"
        common = ["--reproducible", "--states", str(given), "--result", str(result)]
        assert main(["solve", ARM, *words, *common]) == 0
        found.append(result.read_text())
    assert found[1:] == found[:1] * 2


@pytest.mark.slow
def test_certified_answers_are_those_of_two_processes_and_so_are_their_bounds(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["info", FIGURE, "--states", "2"]) == 0
    given = tmp_path / "states.json"
    given.write_text(capsys.readouterr().out)
    found = []
    for count in ("1", "2"):
        result = tmp_path / "result.json"
        words = ["--reproducible", "--certify", "--procs", count, "--states", str(given)]
        assert main(["solve", FIGURE, *words, "--result", str(result)]) == 0
        found.append(json.loads(result.read_text()))
    assert found[0]["joints"] == found[1]["joints"]
    assert found[0]["error_bounds"] == found[1]["error_bounds"]
    assert all(0 < bound < 1e-6 for bound in found[0]["error_bounds"])
