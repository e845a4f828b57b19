"""Pictures of programs: well formed, complete, and of the program that is priced."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import pytest

from adagen.cost import timeline
from adagen.drawing import draw
from adagen.drawing.program import swept_rows
from adagen.emit.shapes import priced_program
from adagen.model import Model
from adagen.plan import make_plan
from adagen.program import Program
from adagen.schedule import Schedule, Topology, load_profile
from adagen.search import best_schedule
from tests.models import human_figure, serial_chain
from tests.slow import slow

PROFILE = load_profile("default")
SVG = "{http://www.w3.org/2000/svg}"


def made(model: Model, processes: int, form: str = "segment") -> tuple[Schedule, Program]:
    schedule = best_schedule(model, processes, PROFILE, form)
    return schedule, priced_program(make_plan(model, schedule, form=form))


@pytest.mark.parametrize("processes", [1, 2, slow(4)])
@pytest.mark.parametrize("form", ["segment", "ada"])
@pytest.mark.parametrize("model", [human_figure(), serial_chain(20)], ids=["figure", "chain"])
def test_the_picture_is_of_the_program(model: Model, form: str, processes: int) -> None:
    schedule, program = made(model, processes, form)
    picture = draw(schedule, Topology.of(model), program, PROFILE, "<robot> & \x07")
    assert picture == draw(schedule, Topology.of(model), program, PROFILE, "<robot> & \x07")
    root = ElementTree.fromstring(picture)
    texts = ["".join(e.itertext()) for e in root.iter(f"{SVG}text")]
    for joint in model.joints:
        assert texts.count(joint.name) >= 2
    line = timeline(program, PROFILE)
    (said,) = [text for text in texts if "predicted (default profile)" in text]
    assert f"{line.makespan:.3g} µs" in said
    notes = [e.text or "" for e in root.iter(f"{SVG}title")]
    ends = [float(found[1]) for note in notes if (found := re.search(r"to ([0-9.]+) µs", note))]
    assert max(ends) == pytest.approx(line.makespan, abs=5e-4)
    for p in range(processes):
        busy = f"{100 * line.busy(p) / line.makespan:.0f} % busy"
        assert busy in texts or not program.processes[p].operations
    width, height = float(root.attrib["width"]), float(root.attrib["height"])
    for element in root.iter(f"{SVG}text"):
        assert 0 <= float(element.attrib["x"]) <= width
        assert 0 <= float(element.attrib["y"]) <= height


@pytest.mark.parametrize("processes", [1, 2])
def test_every_joint_is_swept_once(processes: int) -> None:
    for model in (human_figure(), serial_chain(30)):
        _, program = made(model, processes)
        assert sorted(row.joint for row in swept_rows(program)) == list(range(len(model.joints)))
