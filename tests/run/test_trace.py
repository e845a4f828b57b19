"""--trace of an emitted program, and its timeline."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path
from statistics import median
from typing import Any
from xml.etree import ElementTree as ET

import pytest

from adagen.calibrate.measure import Built, combined
from adagen.drawing.trace import machine_svg
from adagen.emit.shapes import predict
from adagen.errors import InputError
from adagen.plan import Plan, make_plan
from adagen.plan.stages import stages
from adagen.run.trace import read_trace
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule
from tests.emitted import Builder, Solver
from tests.models import human_figure

MODEL = human_figure()
NAMES = [joint.name for joint in MODEL.joints]


def human_plan() -> Plan:
    profile = load_profile("default")
    return make_plan(MODEL, named_schedule("balanced", Topology.of(MODEL), 2, profile=profile))


@pytest.fixture(scope="module")
def solver(builder: Builder) -> Solver:
    return builder.solver(human_plan())


@pytest.fixture
def trace(solver: Solver, tmp_path: Path) -> Path:
    done = solver.run("--trace", tmp_path / "t.json", "--repeat", "3")
    assert (done.status, done.stderr) == (0, "")
    return tmp_path / "t.json"


def test_every_stage_is_told_in_order(trace: Path) -> None:
    data = json.loads(trace.read_text())
    plan = human_plan()
    assert (data["processes"], data["channel"], data["evaluations"]) == (2, "window", 3 * 64)
    for p, process in enumerate(plan.processes):
        mine = [row for row in data["stages"] if row["process"] == p]
        expected = stages(process)
        assert [row["what"] for row in mine] == [stage.what for stage in expected]
        assert [row["message"] for row in mine] == [stage.message for stage in expected]
        names = [None if s.joint is None else NAMES[s.joint] for s in expected]
        assert [row["joint"] for row in mine] == names
        starts = [row["start_ns"] for row in mine]
        assert starts == sorted(starts) and all(row["length_ns"] > 0 for row in mine)


def test_a_trace_becomes_a_timeline_and_a_picture(trace: Path) -> None:
    line = read_trace(str(trace), NAMES, 2)
    predicted = predict(human_plan(), load_profile("default"))
    assert (line.source, predicted.source) == ("measured", "predicted")
    assert len(line.exchanges) == len(predicted.exchanges) == 2
    for p in (0, 1):
        mine = [i for i in line.intervals if i.process == p]
        assert all(a.end <= b.start + 0.5 for a, b in pairwise(mine))
        assert 0 < line.busy(p) <= line.makespan
    svg = machine_svg([predicted, line], NAMES, "a <robot>")
    assert svg == machine_svg([predicted, line], NAMES, "a <robot>")
    texts = [e.text or "" for e in ET.fromstring(svg).iter() if e.tag.endswith("text")]
    assert any(t.startswith("Predicted: ") for t in texts)
    assert any(t.startswith("Measured: ") for t in texts)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"processes": 3}, "of 3 processes"),
        ({"stages": []}, "empty"),
        ({"stages": 3}, "no list of stages"),
        ({"what": "sleep"}, "unknown stage"),
        ({"process": 2}, "no process"),
        ({"joint": "nose"}, "no joint 'nose'"),
        ({"start_ns": "x"}, "not a trace of this robot"),
        ({"length_ns": -1}, "finite"),
        ({"length_ns": float("inf")}, "finite"),
    ],
)
def test_a_spoilt_trace_is_refused(change: dict[str, Any], message: str, tmp_path: Path) -> None:
    row = {"process": 0, "what": "assembly", "joint": NAMES[0], "message": None}
    row |= {"start_ns": 0.0, "length_ns": 5.0}
    data = {"processes": 2, "stages": [row]}
    (row if next(iter(change)) in row else data).update(change)
    file = tmp_path / "t.json"
    file.write_text(json.dumps(data))
    with pytest.raises(InputError, match=message):
        read_trace(str(file), NAMES, 2)


def test_what_is_no_trace_is_refused(tmp_path: Path) -> None:
    (tmp_path / "no.json").write_text("{")
    (tmp_path / "list.json").write_text("[]")
    for name in ("none.json", "no.json", "list.json"):
        with pytest.raises(InputError):
            read_trace(str(tmp_path / name), NAMES, 2)


def test_a_trace_that_cannot_be_written_is_a_fault(solver: Solver, tmp_path: Path) -> None:
    done = solver.run("--trace", tmp_path / "none" / "t.json", "--repeat", "1")
    assert done.status == 3 and "cannot write the trace" in done.stderr


def test_answers_are_the_same_while_traced(solver: Solver, tmp_path: Path) -> None:
    words = ("--check", "--json", "--repeat", "2")
    plain = json.loads(solver.run(*words).stdout)
    traced = json.loads(solver.run(*words, "--trace", tmp_path / "t.json").stdout)
    assert plain["check"] == traced["check"] and plain["check"]["ok"]


def test_a_program_is_measured_stage_by_stage(solver: Solver) -> None:
    program = Built.__new__(Built)  # built for tests, without the long optimisation
    program.batch = False
    program.plan, program.toolchain = human_plan(), solver.toolchain
    program.executable = solver.executable
    runs = [program.measure(repeat=2, channel=channel) for channel in ("window", "message")]
    assert [run.channel for run in runs] == ["window", "message"]
    best = combined(runs)
    assert best.time == median(run.time for run in runs)  # of two processes
    assert best.best == min(run.best for run in runs) <= best.time
    assert len(best.stages) == sum(len(stages(p)) for p in program.plan.processes)
    assert [stage.process for stage in best.of(1)] == [1] * len(best.of(1))
