"""What a report holds: plain data that is read off what was compiled, and a page around it."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import groupby
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.cli import main
from adagen.library import compile, read  # noqa: A004
from adagen.reference.closed import constraints
from adagen.report import Measured, Scene, accuracy_of, document, page
from adagen.report.robot import robot
from adagen.studies.chart import mechanism_of
from adagen.studies.records import write_record
from tests.report.robots import chart, compiled, every_kind
from tests.urdf.texts import chain

MODELS = Path(__file__).resolve().parents[2] / "generated_examples" / "models"


def data_of(html: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', html)
    assert found is not None
    data = json.loads(found[1])
    assert isinstance(data, dict)
    return data


def numbers(data: Any) -> Iterator[float]:
    if isinstance(data, float):
        yield data
    for each in data.values() if isinstance(data, dict) else data if isinstance(data, list) else ():
        yield from numbers(each)


def test_the_document_is_what_was_compiled(tmp_path: Path) -> None:
    made = compiled(tmp_path, (MODELS / "humanoid.urdf").read_text(), procs=2, shape="kernels")
    told = document(made, {"page": "adagen report x"}, remarks=["odd"])
    assert json.loads(json.dumps(told, allow_nan=False)) == json.loads(json.dumps(told))
    robot, program = told["robot"], told["program"]
    assert [joint["name"] for joint in robot["joints"]] == [j.name for j in made.model.joints]
    assert len(robot["links"]) == len(robot["joints"]) + 1
    (line,) = program["timelines"]
    assert made.timeline is not None
    assert line["source"] == "predicted" and line["makespan"] == made.predicted
    calls, steps = made.timeline.calls, made.timeline.intervals
    assert [each["what"] for each in line["intervals"]][:3] == ["call", "call", steps[0].what]
    assert len(line["intervals"]) == len(calls) + len(steps)
    assert len(program["colours"]) == 2 and len(line["busy"]) == 2
    side_by_side = [each["lanes"] for each in line["intervals"] if each["lanes"]]
    assert any("left_shoulder" in lane for lanes in side_by_side for lane in lanes)
    (time, digits) = told["figures"]
    assert (time["what"], time["measured"]) == ("time of an evaluation", None)
    assert digits["predicted"] == round(made.digits or 0.0, 1)
    assert told["scene"] is None and told["chart"] is None and told["remarks"] == ["odd"]
    assert all(map(math.isfinite, numbers(told)))


@pytest.mark.parametrize("procs", [1, 2])
def test_measured_phases_show_the_limbs_of_their_lanes(procs: int, tmp_path: Path) -> None:
    text = (MODELS / "humanoid.urdf").read_text()
    made = compiled(tmp_path, text, procs=procs, shape="kernels")
    assert made.timeline is not None
    phases = [
        max(group, key=lambda each: each.end)
        for _, group in groupby(made.timeline.intervals, lambda each: (each.process, each.what))
    ]
    seen = tuple(replace(each, operation=None) for each in phases)  # as a trace has them
    run = Measured(0.5, 0.4, "clock", 1e-15, 14.5, True, replace(made.timeline, intervals=seen))
    predicted, measured = document(made, {}, measured=run)["program"]["timelines"]
    assert len(measured["intervals"]) == procs + len(seen) < len(predicted["intervals"])
    for sort in ("kinematics", "assembly", "disassembly"):
        limbs = [
            {limb for each in line["intervals"] if each["what"] == sort for limb in each["lanes"]}
            for line in (predicted, measured)
        ]
        assert limbs[0] == {limb for lane in limbs[1] for limb in lane.split(", ")} != set()


def test_what_was_measured_stands_beside(tmp_path: Path) -> None:
    made = compiled(tmp_path, (MODELS / "arm7.urdf").read_text())
    run = Measured(0.5, 0.4, "stretches", 1e-15, 14.5, True, made.timeline)
    told = document(made, {}, measured=run, scene=Scene("s.toml", ("less",)), chart=chart("arm7"))
    rows = {row["what"]: (row["predicted"], row["measured"]) for row in told["figures"]}
    assert rows["time of an evaluation"] == (made.predicted, 0.5)
    assert rows["least time"] == (None, 0.4) and rows["largest error"] == (None, 1e-15)
    assert "stretches" in rows["answers"][1]
    assert len(told["program"]["timelines"]) == 2
    assert told["scene"] == {"file": "s.toml", "lines": ["less"]}
    assert len(told["chart"]["points"]) == 6  # the one that failed has no place
    assert told["chart"]["points"][0]["time"] == pytest.approx(0.2)


def test_why_there_is_no_timeline_is_told(tmp_path: Path) -> None:
    text = (MODELS / "arm7.urdf").read_text()
    for words, why in (({"batch": True}, "of a batch"), ({"profile": "paper"}, "prices joins")):
        program = document(compiled(tmp_path, text, **words), {})["program"]
        assert program["timelines"] == [] and why in program["untimed"]
    assert document(compiled(tmp_path, text), {})["program"]["untimed"] is None


def test_hostile_names_are_data(tmp_path: Path) -> None:
    html = page(document(compiled(tmp_path, every_kind()), {}))
    assert "<img" not in html
    assert html.count("</script>") == 2
    assert data_of(html)["robot"]["joints"][0]["name"].startswith("</script>")


def test_the_page_needs_nothing_else(tmp_path: Path) -> None:
    html = page(document(compiled(tmp_path, (MODELS / "arm7.urdf").read_text()), {}))
    assert not re.search(r'(src|href)="(?!#)', html)
    assert "default-src 'none'" in html
    addresses = set(re.findall(r"https?://[^\s\"']+", html))
    assert addresses == {"http://www.w3.org/2000/svg"}  # a name, which nobody fetches
    assert html == page(document(compiled(tmp_path, (MODELS / "arm7.urdf").read_text()), {}))


def test_the_command_writes_one_page(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    record, out, scene = tmp_path / "chart_arm7.json", tmp_path / "out", tmp_path / "s.toml"
    write_record(chart("arm7"), record)
    scene.write_text("gravity = [0, 0, 0]\n")
    words = [str(MODELS / "arm7.urdf"), "--procs", "1", "--record", str(record)]
    words += ["--scene", str(scene), "--out", str(out)]
    assert main(["report", *words]) == 0
    assert [path.name for path in out.iterdir()] == ["arm7_p1_report.html"]
    data = data_of((out / "arm7_p1_report.html").read_text())
    assert data["commands"]["page"].startswith("adagen report ")
    assert "no gravity" in data["scene"]["lines"]
    assert data["chart"]["model"] == "arm7"
    assert any("mimics" in line for line in data["remarks"])
    assert "measured" not in data["commands"]
    assert "arm7_p1_report.html" in capsys.readouterr().err
    assert main(["report", *words]) == 0  # its own page is written anew
    (out / "arm7_p1_report.html").write_text("mine")
    assert main(["report", *words]) == 2


def test_a_scene_that_only_closes_loops_saves_nothing(tmp_path: Path) -> None:
    words = [str(MODELS / "fourbar.urdf"), "--scene", str(MODELS / "fourbar.toml")]
    assert main(["report", *words, "--out", str(tmp_path)]) == 0
    data = data_of((tmp_path / "fourbar_p1_report.html").read_text())
    assert data["scene"]["lines"] == ["it leaves out nothing of the robot"]


def test_a_record_of_another_robot_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    record = tmp_path / "other.json"
    write_record(chart("talos"), record)
    words = [str(MODELS / "arm7.urdf"), "--record", str(record), "--out", str(tmp_path / "out")]
    assert main(["report", *words]) == 1
    assert "a chart of talos, not of arm7" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_a_record_made_without_the_scene_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    record, scene = tmp_path / "chart_arm7.json", tmp_path / "s.toml"
    model = read(MODELS / "arm7.urdf").model
    words = [str(MODELS / "arm7.urdf"), "--procs", "1", "--record", str(record)]
    words += ["--scene", str(scene), "--out", str(tmp_path / "out")]
    scene.write_text("gravity = [0, 0, 0]\n")
    for mechanism, warned in ((mechanism_of(model), 0), ("", 1)):
        write_record(chart("arm7", mechanism=mechanism), record)
        assert main(["report", *words]) == 0
        assert capsys.readouterr().err.count("does not say whether") == warned
    scene.write_text(f'[joints."{model.joints[0].name}"]\nstiffness = 1\n')
    write_record(chart("arm7", mechanism=mechanism_of(model)), record)
    assert main(["report", *words]) == 1
    assert "with another scene or base" in capsys.readouterr().err


def test_a_run_is_measured(tmp_path: Path) -> None:
    words = [str(MODELS / "arm7.urdf"), "--procs", "1", "--run", "--out", str(tmp_path / "out")]
    assert main(["report", *words]) == 0
    data = data_of((tmp_path / "out" / "arm7_p1_report.html").read_text())
    rows = {row["what"]: row["measured"] for row in data["figures"]}
    assert rows["time of an evaluation"] > 0.0 and rows["answers"].startswith("right")
    assert data["program"]["timelines"][1]["source"] == "measured"
    accuracy = data["accuracy"]
    assert accuracy["bounds"] == [] and len(accuracy["errors"]) == 12
    assert max(accuracy["errors"]) < 10 * accuracy["predicted"] < 1e-12
    assert "--check" in data["commands"]["measured"]
    assert main(["report", str(MODELS / "arm7.urdf"), "--run", "--batch"]) == 2


def test_no_error_exceeds_its_certified_bound(tmp_path: Path) -> None:
    words = ["--certify", "--scalar", "float", "--run", "--out", str(tmp_path / "out")]
    assert main(["report", str(MODELS / "chain16.urdf"), *words]) == 0
    data = data_of((tmp_path / "out" / "chain16_p1_report.html").read_text())
    errors, bounds = data["accuracy"]["errors"], data["accuracy"]["bounds"]
    assert len(errors) == len(bounds) == 12
    assert all(0 < error <= bound for error, bound in zip(errors, bounds, strict=True))


def test_why_no_error_is_known_is_told(tmp_path: Path) -> None:
    def run(_: list[str]) -> None:
        raise AssertionError("nothing is to be run")

    scene = tmp_path / "s.toml"
    scene.write_text('accelerations = ["base_yaw"]\n')
    made = compile(read(MODELS / "arm7.urdf", scene=scene))
    assert accuracy_of(made, run, print).missing == "The scene leaves out accelerations."
    made = compiled(tmp_path, chain(151))
    assert "more than 150 degrees" in accuracy_of(made, run, print).missing


def test_a_closed_robot_begins_with_its_loops_closed() -> None:
    model = read(MODELS / "fourbar.urdf", scene=MODELS / "fourbar.toml").model
    told = robot(model, dict.fromkeys((joint.name for joint in model.joints), 0))
    q = np.array([angle for (angle,) in told["rest"]])
    assert np.abs(constraints(model, q).gaps).max() < 1e-9
    assert [end["link"] for end in told["loops"][0]["ends"]] == [
        link for link, _ in model.loops[0].ends
    ]
