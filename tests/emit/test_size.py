"""What is emitted stays small, and most of it is the robot's own."""

from __future__ import annotations

from functools import cache

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
    sources = {name: adagen.compile(_real(name)) for name in ("ur5", "z1", "solo12", "talos")}
    texts = {name: compiled.source for name, compiled in sources.items()}
    assert min(own_lines(name, texts) for name in texts) >= 0.8
    assert max(len(texts[name].splitlines()) for name in ("ur5", "z1")) < 1000  # arms


@pytest.mark.parametrize("processes", [1, 2])
@pytest.mark.parametrize(
    ("shape", "least"),
    [
        ("unrolled", dict.fromkeys(ROBOTS, 0.8)),
        (
            "kernels",
            {"ur5": 0.6, "z1": 0.6, "panda": 0.7, "solo12": 0.75, "talos": 0.8, "icub": 0.8},
        ),
        (
            "joints",
            {"ur5": 0.75, "z1": 0.75, "panda": 0.78, "solo12": 0.8, "talos": 0.8, "icub": 0.8},
        ),
    ],
)
def test_lines_of_a_shape_are_the_robots_own(
    shape: str, least: dict[str, float], processes: int
) -> None:
    """In loops the few lines of an arm stand among about forty that every robot has."""
    texts = {
        name: adagen.compile(_real(name), procs=processes, shape=shape).source for name in ROBOTS
    }
    for name, share in least.items():
        assert own_lines(name, texts) >= share, name
    assert max(len(texts[name].splitlines()) for name in ("ur5", "z1")) < 1000  # arms
    if shape == "kernels":
        assert max(len(text.splitlines()) for text in texts.values()) < 1600
        assert max(_shared(name, texts) for name in ("ur5", "z1", "panda", "solo12")) <= 45


@cache
def _real(name: str) -> adagen.Robot:
    file, floating = ROBOTS[name]
    return adagen.read(real_robot(file), floating=floating)


def _shared(name: str, texts: dict[str, str]) -> float:
    """Lines of a source that stand in all the others."""
    lines = sum(1 for line in texts[name].splitlines() if line.strip())
    return lines * (1 - own_lines(name, texts))
