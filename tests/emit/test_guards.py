"""Entries of a state that are not finite are refused by the joint's name, each of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from adagen.emit.shapes import SHAPES
from adagen.model import Model
from adagen.model.kinds import PRISMATIC, SPHERICAL
from adagen.plan import make_plan
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import random_states
from tests.emitted import Builder, Solver, text_of
from tests.models import human_figure, random_tree, serial_chain, star
from tests.slow import spread

PROGRAM = Path(__file__).with_name("spoilt_entries.cpp")
ROBOTS = {
    "all kinds": random_tree(np.random.default_rng(3), 9, branching=0.5, floating=True),
    "limbs side by side": human_figure(),
    "in strips": serial_chain(20),
    "one lane idle": star(3, 2, kind=SPHERICAL, floating=True),
    "without rotation": serial_chain(5, kind=PRISMATIC),
}


def spoiler(model: Model, builder: Builder, shape: str, scalar: str) -> Solver:
    """A program that spoils one entry after the other and says what the solver says."""
    schedule = best_schedule(model, 1, load_profile("default"), scalar=scalar)
    form = "ada" if shape == "joints" else "segment"
    plan = make_plan(model, schedule, scalar=scalar, form=form)
    head = f"#include <fstream>\n#define ADAGEN_NO_MAIN\nusing Number = {scalar};\n"
    text = f"{head}{text_of(plan, 'guarded', shape=shape)}\n{PROGRAM.read_text()}"
    return Solver(builder.compile(text, "guarded"), 1, builder.toolchain)


@pytest.mark.parametrize(
    ("robot", "shape", "scalar"),
    spread(
        [
            *((robot, "kernels", "double") for robot in ROBOTS),
            *(("all kinds", shape, "float") for shape in SHAPES),
            ("in strips", "kernels", "float"),
            ("without rotation", "unrolled", "double"),
        ],
        3,
    ),
)
def test_each_entry_that_is_not_finite_is_refused_by_name(
    robot: str, shape: str, scalar: str, builder: Builder, tmp_path: Path
) -> None:
    model = ROBOTS[robot]
    states = random_states(model, 1, seed=4)
    given = (states.q[0], states.v[0], states.tau[0])
    np.savetxt(tmp_path / "state", np.concatenate(given), fmt="%.17g")
    done = spoiler(model, builder, shape, scalar).run(tmp_path / "state")
    assert (done.status, done.stderr) == (0, "")
    expected = []
    for field, starts in enumerate((model.q_start, model.v_start, model.v_start)):
        for k in range(len(given[field])):
            joint = model.joints[int(np.searchsorted(starts, k, side="right")) - 1]
            why = f'joint "{joint.name}": its q, v or tau is not a finite number'
            expected += [f"{field} {k} {why}"] * 3
    assert done.stdout.splitlines() == expected
