"""Unusual robots, schedules and scalars, and what is asked of the programs emitted for them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from adagen.model import Inertia, Model
from adagen.plan import Plan, make_plan
from adagen.states import random_states
from tests.emitted import ROUNDING, Builder, forward_error, plan_of, truth_of
from tests.links import with_inertia
from tests.models import Part, assemble, human_figure, random_tree, serial_chain, vector
from tests.schedules import random_schedule


def forest() -> Model:
    """Return three robots on one ground, with a slaved joint in one of them."""
    rng = np.random.default_rng(11)
    parts = []
    for k in range(3):
        tree = random_tree(rng, 4, mimics=1 if k == 1 else 0)
        for j, joint in enumerate(tree.joints):
            above = None if joint.parent == 0 else f"r{k}_{tree.joints[joint.parent - 1].name}"
            mimic = None
            if joint.mimic is not None:
                followed = f"r{k}_{tree.joints[joint.mimic.source].name}"
                mimic = (followed, joint.mimic.multiplier, joint.mimic.offset)
            parts.append(
                Part(
                    f"r{k}_{joint.name}",
                    above,
                    joint.kind,
                    tree.links[j + 1].inertia,
                    joint.translation,
                    joint.rotation,
                    joint.axis,
                    mimic,
                )
            )
    return assemble("forest", parts)


def anything(seed: int, joints: int, mimics: int = 0) -> Model:
    return random_tree(np.random.default_rng(seed), joints, mimics=mimics)


def by_chance(model: Model, processes: int, seed: int, form: str) -> Plan:
    """Return the plan of a random schedule, in which processes may be idle."""
    schedule = random_schedule(model, processes, np.random.default_rng(seed))
    return make_plan(model, schedule, form=form)


@dataclass(frozen=True)
class Case:
    model: Callable[[], Model]
    plan: Callable[[Model], Plan]
    magnified: float = 1.0


CASES = {
    "all kinds, two slaved": Case(lambda: anything(21, 10, 2), lambda m: by_chance(m, 3, 5, "ada")),
    "the same in strips": Case(
        lambda: anything(21, 10, 2), lambda m: by_chance(m, 3, 5, "segment")
    ),
    "meeting only in the ground": Case(forest, lambda m: by_chance(m, 4, 1, "ada"), magnified=10.0),
    "the same forest in segments": Case(forest, lambda m: by_chance(m, 4, 1, "segment")),
    "more processes than joints": Case(
        lambda: anything(5, 2), lambda m: plan_of(m, 4, form="segment")
    ),
    "one joint, one process": Case(lambda: anything(6, 1), lambda m: plan_of(m, 1, form="ada")),
    "float": Case(human_figure, lambda m: plan_of(m, 2, scalar="float")),
}


def require_solved(name: str, builder: Builder, folder: Path, shape: str = "auto") -> None:
    """Build the program of a case and compare what it says through either channel."""
    case = CASES[name]
    model = case.model()
    plan = case.plan(model)
    solver = builder.solver(plan, name=f"{shape} {name}", shape=shape)
    states = random_states(model, 4, seed=9)
    truth = truth_of(model, states)
    for channel in ("window", "message"):
        found = solver.solve(model, states, folder, "--check", "--channel", channel)
        assert forward_error(found, truth) < case.magnified * ROUNDING[plan.scalar]
    done = solver.run("--time", "--repeat", "1")
    assert (done.status, done.stderr) == (0, "")


def chain_with_thin_link() -> Model:
    """Return a chain that in float cannot be factorized: V^-1 is what 1 kg m^2 leaves of 1e-10."""
    model = serial_chain(3)
    # It can be turned about one axis ten orders more easily than about others.
    moments = np.diag([1e-10, 1.0, 1.0])
    thin = Inertia(model.links[2].inertia.mass, vector(0.1, 0.2, 0.3), moments)
    return with_inertia(model, 2, thin)
