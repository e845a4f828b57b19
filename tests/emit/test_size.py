"""What is emitted stays small, and most of it is the robot's own."""

from __future__ import annotations

from functools import cache

import pytest

import adagen
from adagen.emit import emit
from adagen.plan import FORMS, plan_from_json
from benchmarks.compile_cost import ROBOTS, own_lines
from benchmarks.real_robots import FIXED, FLOATING
from tests.emitted import plan_of
from tests.large import human161
from tests.real import real_robot
from tests.slow import slow


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
        name: adagen.compile(_real(name)) for name in ("ur5", "z1", "solo12", "talos_reduced")
    }
    texts = {name: compiled.source for name, compiled in sources.items()}
    assert min(own_lines(name, texts) for name in texts) >= 0.8
    assert max(len(texts[name].splitlines()) for name in ("ur5", "z1")) < 1000  # arms


@pytest.mark.parametrize(
    ("shape", "processes", "least"),
    [
        ("unrolled", 1, 0.8),
        slow("unrolled", 2, 0.8),
        ("kernels", 1, 0.8),
        ("kernels", 2, 0.75),
        ("joints", 1, 0.7),
        slow("joints", 2, 0.7),
    ],
)
def test_lines_of_a_shape_are_the_robots_own(shape: str, processes: int, least: float) -> None:
    """As written to a folder. In loops on two processes, an arm's few lines stand among thirty.

    In form ada, functions of joints of one kind differ by names alone: some of these are alike.
    """
    form = "ada" if shape == "joints" else "segment"
    made = {
        name: adagen.compile(_real(name), procs=processes, shape=shape, form=form)
        for name in ROBOTS
    }
    texts = {name: each.in_folder(".")[f"{each.stem}.cpp"] for name, each in made.items()}
    for name in ROBOTS:
        assert own_lines(name, texts) >= least, name
    assert max(len(texts[name].splitlines()) for name in ("ur5", "z1")) < 1000  # arms
    if shape == "kernels":
        assert max(len(text.splitlines()) for text in texts.values()) < 1600
        assert max(_shared(name, texts) for name in ("ur5", "z1", "panda", "solo12")) <= 30


@cache
def _real(name: str) -> adagen.Robot:
    return adagen.read(real_robot((FIXED | FLOATING)[name]), floating=name in FLOATING)


def _shared(name: str, texts: dict[str, str]) -> float:
    """Lines of a source that stand in all the others."""
    lines = sum(1 for line in texts[name].splitlines() if line.strip())
    return lines * (1 - own_lines(name, texts))
