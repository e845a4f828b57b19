"""Shape kernels where a bare link is joined, and where mobilities pass joints of all kinds."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from adagen.calibrate.robots import robot
from adagen.emit.shapes import SHAPES
from adagen.executor.grouping import spared
from adagen.plan import make_plan
from adagen.plan.simd_groups import simd_groups
from adagen.plan.steps import LinkBias, Propagate
from adagen.states import random_states
from tests.emitted import ROUNDING, Builder
from tests.models import random_tree
from tests.schedules import random_schedule
from tests.slow import slow, spread


@pytest.mark.parametrize(
    ("seed", "joints", "floating", "mimics", "processes"),
    spread(
        [
            (4, 9, True, 0, 2),
            (5, 12, False, 0, 4),
            (4, 9, True, 2, 4),
        ],
        1,
    ),
)
def test_trees_with_bare_links_are_solved(
    seed: int,
    joints: int,
    floating: bool,
    mimics: int,
    processes: int,
    builder: Builder,
    tmp_path: Path,
) -> None:
    model = random_tree(np.random.default_rng(seed), joints, floating=floating, mimics=mimics)
    schedule = random_schedule(model, processes, np.random.default_rng(processes - 2))
    plan = make_plan(model, schedule)
    steps = [step for process in plan.processes for step in process.steps]
    passed = {plan.joints[step.joint].kind for step in steps if isinstance(step, Propagate)}
    assert any(isinstance(step, LinkBias) for step in steps)
    assert processes == 2 or passed & {"floating", "planar"}
    solver = builder.solver(plan, name="bare", shape="kernels")
    states = random_states(model, 4, seed=9)
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]


# A loop between each two branches, or one for all.
@pytest.mark.parametrize(
    ("branches", "in_lanes"), [(3, True), slow(9, False), slow(3, False), slow(9, True)]
)
def test_branches_are_added_along_runs_and_limbs_in_lanes(
    branches: int, in_lanes: bool, builder: Builder, tmp_path: Path
) -> None:
    parents = [0]
    for _ in range(2):
        near = 1
        for _ in range(branches):
            parents += [near, len(parents) + 1]
            near = len(parents) - 1
        parents.append(near)
    kinds = ((branches + 1) * ["spherical", "revolute", "revolute"])[: 2 * branches + 1]
    model = robot("combs", parents, ["revolute", *kinds, *kinds], 1)
    plan = make_plan(model, random_schedule(model, 1, np.random.default_rng(1)))
    (process,) = plan.processes
    limbs = simd_groups(plan, process, spared, (2,) if in_lanes else ())
    assert any(len(each.rows) > branches for each in limbs) == in_lanes
    solver = builder.solver(plan, name="combs", shape="kernels", limbs=(tuple(limbs),))
    states = random_states(model, 4, seed=9)
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]


@pytest.mark.parametrize("seed", range(30))
def test_loops_take_every_plan_of_form_segment(seed: int) -> None:
    """Whatever robot it is, and whoever joins what."""
    rng = np.random.default_rng(seed)
    model = random_tree(rng, 10, floating=seed % 2 == 0, mimics=seed % 3)
    for processes in (1, 2, 3, 5):
        plan = make_plan(model, random_schedule(model, processes, rng))
        assert SHAPES["kernels"].why_not(plan) is None
