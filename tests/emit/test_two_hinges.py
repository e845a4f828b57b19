"""Shape kernels: accelerations of long runs of hinges are found for two of them at a time."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from adagen.emit import stem_of
from adagen.model import Model
from adagen.model.kinds import PRISMATIC, REVOLUTE
from adagen.states import random_states
from tests.emitted import ROUNDING, Builder, Solver, plan_of, text_of
from tests.models import random_tree
from tests.slow import slow

SWEEP = re.compile(r"\baccelerate(|_reversed|_along)<(\d+), (\d+), (\d+)>\(w\)")


def hinges(joints: int, seed: int, *, floating: bool = False) -> Model:
    rng = np.random.default_rng(seed)
    return random_tree(rng, joints, [REVOLUTE], branching=0.0, floating=floating)


@pytest.mark.parametrize(
    ("joints", "floating", "processes", "meeting", "ways"),
    [
        (8, False, 1, None, {""}),
        (9, False, 1, None, {""}),
        slow(19, True, 2, "gather", {"", "_reversed"}),
        (20, True, 2, "gather", {"", "_reversed"}),
        slow(20, False, 2, "exchange", {"_along", ""}),
        slow(21, False, 2, "exchange", {"_along", ""}),
    ],
)
def test_hinges_that_follow_each_other_are_solved_by_twos(
    joints: int,
    floating: bool,
    processes: int,
    meeting: str | None,
    ways: set[str],
    builder: Builder,
    tmp_path: Path,
) -> None:
    model = hinges(joints, seed=joints, floating=floating)
    plan = plan_of(model, processes, **({} if meeting is None else {"meeting": meeting}))
    text = text_of(plan, shape="kernels")
    sweeps = SWEEP.findall(text)
    assert {way for way, *_ in sweeps} == ways
    assert any(int(last) - int(first) + 1 >= 8 for _, _, first, last in sweeps)
    for _, p, first, last in sweeps:
        long = "" if int(last) - int(first) + 1 >= 8 else "!"
        text += f"static_assert({long}by_twos<{p}, {first}, {last}>());\n"
    solver = Solver(builder.compile(text, stem_of(plan)), plan.launched, builder.toolchain)
    states = random_states(model, 6, seed=1)
    assert solver.error(model, states, tmp_path, "--check") < 5 * ROUNDING["double"]


def test_a_slide_among_hinges_has_them_solved_one_by_one(builder: Builder, tmp_path: Path) -> None:
    rng = np.random.default_rng(5)
    model = random_tree(rng, 12, [REVOLUTE, REVOLUTE, PRISMATIC], branching=0.0)
    assert {joint.kind for joint in model.joints} == {REVOLUTE, PRISMATIC}
    plan = plan_of(model, 1)
    text = text_of(plan, shape="kernels") + "static_assert(!by_twos<0, 0, 11>());\n"
    solver = Solver(builder.compile(text, stem_of(plan)), plan.launched, builder.toolchain)
    states = random_states(model, 4, seed=1)
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]
