"""Form ada where links cannot be inverted: clusters, articulated bodies in shape joints."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.emit import emit, stem_of
from adagen.emit.shapes import chosen_shape
from adagen.errors import UsageError
from adagen.model import Inertia, Model
from adagen.model.kinds import REVOLUTE, SPHERICAL
from adagen.plan import Plan, make_plan
from adagen.plan.clusters import fold_of
from adagen.plan.steps import Deliver, Join, Propagate, StartLink
from adagen.schedule import load_profile
from adagen.search import named_schedule
from adagen.states import random_states
from tests.emitted import ROUNDING, Builder, energy_errors
from tests.models import random_tree
from tests.scene.held import held
from tests.slow import slow

PROFILE = load_profile("default")
POINT = Inertia(0.5, np.array([0.2, 0.05, 0.03]), np.zeros((3, 3)))


def clustered(seed: int, mimics: int = 0) -> Model:
    """Return a floating tree of twelve joints, three of whose links are point masses."""
    rng = np.random.default_rng(seed)
    model = random_tree(rng, 12, (REVOLUTE, SPHERICAL), floating=True, mimics=mimics)
    links = tuple(
        replace(link, inertia=POINT) if k in (1, 2, 7) else link
        for k, link in enumerate(model.links)
    )
    return replace(model, links=links)


def geared(model: Model) -> Model:
    """Return the robot with rotors at its joints of one freedom."""
    joints = (
        replace(j, passive=replace(j.passive, rotor_inertia=0.1)) if j.kind.nv == 1 else j
        for j in model.joints
    )
    return replace(model, joints=tuple(joints))


def plan_of(model: Model, processes: int, runtime: str = "") -> Plan:
    seen = fold_of(model, "ada")
    found = named_schedule("balanced", seen.topology, processes, profile=PROFILE)
    return make_plan(model, seen.unfold(found, PROFILE), form="ada", runtime=runtime)


CASES = {
    "plain": clustered(5),
    "rotors": geared(clustered(9)),
    "prescribed": held(clustered(12), [1, 4, 8]),
    "slaved": clustered(9, mimics=2),
}


def solver_error(case: str, builder: Builder, folder: Path) -> float:
    """Build a case in shape joints on two processes and return its error."""
    model = CASES[case]
    solver = builder.solver(plan_of(model, 2), name="clusters", shape="joints")
    return solver.error(model, random_states(model, 4, seed=9), folder, "--check")


@pytest.mark.parametrize("case", ["plain", slow("rotors"), slow("prescribed"), slow("slaved")])
def test_clusters_are_articulated_bodies(case: str, builder: Builder, tmp_path: Path) -> None:
    """Seen from a root in their middle, with handles at several of their links."""
    steps = list(plan_of(CASES[case], 2).steps)
    assert any(isinstance(step, StartLink) for step in steps)
    assert any(isinstance(step, Join) for step in steps)
    assert any(isinstance(step, Deliver) for step in steps)
    passed = [step for step in steps if isinstance(step, Propagate)]
    assert any(step.reversed for step in passed) and any(step.spreads for step in passed)
    assert solver_error(case, builder, tmp_path) < 10 * ROUNDING["double"]


@pytest.mark.slow
def test_clusters_are_refined(builder: Builder, tmp_path: Path) -> None:
    model = CASES["plain"]
    solver = builder.solver(plan_of(model, 2), name="clusters", shape="joints", refine=2)
    states = random_states(model, 3, seed=3)
    assert energy_errors(model, states, solver.solve(model, states, tmp_path)).max() < 1e-14


def test_masses_of_clusters_are_set_in_straight_lines() -> None:
    """Shape joints has them as constants, and must not take a plan in which they are set."""
    model = CASES["plain"]
    plan = plan_of(model, 2, runtime=f"mass:{model.links[1].name}")
    assert plan.sets_inertias and chosen_shape(plan, "auto") == "unrolled"
    assert "parameter[0]" in emit(plan)[f"{stem_of(plan)}.cpp"]
    with pytest.raises(UsageError, match="masses are constants"):
        emit(plan, shape="joints")
