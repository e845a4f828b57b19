"""What is emitted stays small, and most of it is the robot's own."""

from __future__ import annotations

import pytest

import adagen
from adagen.emit import emit
from adagen.plan import FORMS, plan_from_json
from benchmarks.compile_cost import ROBOTS, own_lines
from tests.emitted import plan_of
from tests.large import human161
from tests.real import real_robot


@pytest.mark.parametrize("form", FORMS)
def test_a_robot_of_161_degrees_of_freedom_is_emitted_within_bounds(form: str) -> None:
    model = human161()
    assert model.nv == 161
    plan = plan_of(model, 4, form=form)
    files = emit(plan, name="human161")
    assert len(files["human161_p4.cpp"].encode()) < 2 * 2**20
    assert max(len(line) for line in files["human161_p4.cpp"].splitlines()) < 2000
    assert plan_from_json(files["human161_p4.plan.json"]) == plan


def test_most_lines_of_what_is_chosen_for_a_robot_are_its_own() -> None:
    sources = {
        name: adagen.compile(adagen.read(real_robot(ROBOTS[name][0]), floating=ROBOTS[name][1]))
        for name in ("ur5", "z1", "solo12", "talos")
    }
    texts = {name: compiled.source for name, compiled in sources.items()}
    assert min(own_lines(name, texts) for name in texts) >= 0.8
    assert max(len(texts[name].splitlines()) for name in ("ur5", "z1")) < 1000  # arms


def test_loops_of_a_humanoid_are_short_and_four_fifths_its_own() -> None:
    texts = {
        name: adagen.compile(
            adagen.read(real_robot(file), floating=floating), shape="kernels"
        ).source
        for name, (file, floating) in ROBOTS.items()
    }
    assert min(own_lines(name, texts) for name in ("talos", "icub")) >= 0.8
    assert max(len(text.splitlines()) for text in texts.values()) < 1600
