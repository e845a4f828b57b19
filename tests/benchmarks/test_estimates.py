"""Error estimates beside true errors: what counts, and what a record looks like."""

from __future__ import annotations

import json
from itertools import product
from math import inf
from pathlib import Path

import numpy as np
import pytest

from adagen.errors import AdagenError
from adagen.executor.refine import interpret_refined
from adagen.reference import exact_forward_dynamics
from adagen.states import random_states, write_states
from adagen.urdf import read_robot
from benchmarks.estimates import main, planned, subjects
from benchmarks.estimates_report import Row, judged, report, within
from tests.cli.robots import write_arm
from tests.results import write_result


def test_within_is_a_factor_three_either_way() -> None:
    assert within(1.0, 2.9) and within(2.9, 1.0) and within(0.0, 0.0)
    assert not within(1.0, 3.1) and not within(3.1, 1.0)
    assert within(0.0, 1e-16) and within(1e-16, 0.0)
    assert not within(0.0, 1e-15) and not within(1e-15, 0.0)


def row(form: str, said: list[float], true: list[float], own: list[float | None]) -> Row:
    return {"key": ["arm fixed", form, "double", 1], "said": said, "true": true, "own": own}


def test_what_rounded_constants_explain_is_told_apart() -> None:
    rows: list[Row] = [
        row(
            "ada", [1e-13, 1e-16, 1e-13, 1e9], [2e-13, 9e-16, 9e-13, inf], [None, 2e-16, 8e-13, inf]
        ),
        {"key": ["leg fixed", "ada", "double", 1], "refused": "error: no: not here; or there"},
    ]
    assert judged(rows[0]) == ["file", "own", "beyond", "rest"]
    text = report(rows)
    assert "| ada, double, 1 | 2 | 1 | 4 | 1 | 1 | 1 | 1 |" in text
    assert "| arm fixed | ada, double, 1 | 2 | 1.0e-13 | 9.0e-13 | 8.0e-13 |" in text
    assert "| ada, double, 1 | no: not here | leg fixed |" in text


@pytest.fixture
def arm(tmp_path: Path) -> Path:
    """A robot with true answers beside it."""
    model = read_robot(write_arm(tmp_path / "arm.urdf")).model
    states = random_states(model, 2, seed=1)
    truth = np.array([exact_forward_dynamics(model, *state).value for state in states.each])
    write_states(states, model, tmp_path / "states.json")
    write_result(tmp_path / "truth.json", model, truth)
    joints = json.loads((tmp_path / "states.json").read_text())["joints"]
    for name, answers in json.loads((tmp_path / "truth.json").read_text())["joints"].items():
        joints[name] |= answers
    modes = {"fixed": {"status": "ok", "joints": joints}, "floating": {"status": "singular"}}
    (tmp_path / "arm.json").write_text(json.dumps({"modes": modes}))
    return tmp_path / "arm.json"


def test_an_error_is_that_against_the_file(arm: Path) -> None:
    (subject,) = subjects(arm)
    assert subject.name == "arm fixed"
    assert subject.error(1, subject.truth[1]) == 0
    assert subject.error(1, 1.5 * subject.truth[1]) == pytest.approx(0.5)
    assert subject.own_error(1, 1.5 * subject.truth[1]) == pytest.approx(0.5)
    assert subject.own_error(1, subject.truth[1]) < 1e-15


KNOWN = Path(__file__).resolve().parents[3] / "shared/robots"


@pytest.mark.slow
@pytest.mark.parametrize(
    "path",
    [path for kind in ("real", "param") for path in sorted((KNOWN / kind).glob("*.json"))],
    ids=lambda path: str(path.stem),
)
def test_estimates_are_within_a_factor_three_on_robots_with_known_answers(path: Path) -> None:
    """In double, in both forms, on one process and two, where the robot is solved at all."""
    for subject in subjects(path):
        count = 1 if subject.model.nv > 60 else subject.states.count
        for form, processes, s in product(("segment", "ada"), (1, 2), range(count)):
            state = (subject.states.q[s], subject.states.v[s], subject.states.tau[s])
            try:
                plan = planned(subject.model, form, "double", processes)
                found = interpret_refined(plan, *state, steps=1)
                raw = interpret_refined(plan, *state, steps=0).qdd
            except (AdagenError, FloatingPointError):
                continue  # what is refused is reported elsewhere
            if not subject.truth[s].any():
                continue  # held at rest: nothing that an error could be a part of
            (said,) = found.corrections
            assert within(said, subject.error(s, raw)) or within(said, subject.own_error(s, raw))


@pytest.mark.slow
def test_a_record_is_added_to_and_told(arm: Path, capsys: pytest.CaptureFixture[str]) -> None:
    record = arm.with_suffix(".jsonl")
    words = ["measure", str(record), str(arm), "--procs", "1"]
    assert main([*words, "--forms", "ada"]) == 0
    assert main([*words, "--forms", "ada,segment"]) == 0
    assert len(record.read_text().splitlines()) == 2
    capsys.readouterr()
    assert main(["report", str(record)]) == 0
    text = capsys.readouterr().out
    assert "| ada, double, 1 | 1 | 0 | 2 |" in text
    assert "| segment, double, 1 | 1 | 0 | 2 |" in text
