"""States of emitted programs, drawn without them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from adagen.executor.program_states import program_states
from adagen.model import Model
from tests.emitted import Builder, plan_of
from tests.models import human_figure, random_tree, serial_chain

ROBOTS = {
    "chain": serial_chain(3),
    "floating": human_figure(),
    "all kinds": random_tree(np.random.default_rng(5), 12),
}


@pytest.mark.parametrize("name", ROBOTS)
def test_a_program_starts_from_the_same_states(name: str, builder: Builder, tmp_path: Path) -> None:
    model: Model = ROBOTS[name]
    plan = plan_of(model, 1)
    solver = builder.solver(plan)
    for seed in (1, 7):
        words = ("--simulate", "1e-6", "--step", "1e-6", "--seed", str(seed))
        done = solver.run(*words, "--trajectory", str(tmp_path / "way.npz"))
        assert done.status == 0, done.stderr
        way = np.load(tmp_path / "way.npz")
        q, v, _ = program_states(plan, 1, seed)
        assert np.array_equal(way["v"][0], v[0])
        assert np.abs(way["q"][0] - q[0]).max() < 3e-16  # quaternions are set to length 1 anew


def test_states_follow_each_other_and_fill_their_ranges() -> None:
    plan = plan_of(ROBOTS["all kinds"], 1)
    q, v, tau = program_states(plan)
    for x, first in zip((q, v, tau), program_states(plan, 5), strict=True):
        assert np.array_equal(x[:5], first)
    assert len(np.unique(np.hstack([v, tau]))) == v.size + tau.size
    for x in (v, tau):
        assert x.min() < -0.98 and x.max() > 0.98 and np.abs(x).max() <= 1
    for joint in plan.joints:
        own = q[:, joint.q]
        if joint.kind == "revolute":
            assert np.abs(own).max() <= np.pi and np.ptp(own) > 5
