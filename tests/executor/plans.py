"""Plans of every family, and plans at random, which emitted programs and the executor carry out."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from adagen.executor import Grouping, interpret
from adagen.graph import BALLS
from adagen.model import PRISMATIC, REVOLUTE, Model
from adagen.plan import Plan, can_gather, make_plan
from adagen.plan.steps import Articulate, FusedJoin, HoldMobility, Join, SolveMobility, SolveRoot
from adagen.states import States
from tests.emitted import plan_of
from tests.models import human_figure, random_tree, serial_chain, three_axis_chain
from tests.plan.test_fused import any_schedule, balanced, with_massless_links
from tests.scene.effects import with_effects, with_wrenches
from tests.schedules import random_schedule


def kinds_of(plan: Plan) -> set[type]:
    """Return the kinds of steps of a plan."""
    return {type(step) for process in plan.processes for step in process.steps}


@dataclass(frozen=True)
class Case:
    """A plan of a family, and a step that only plans of this family have."""

    model: Model
    processes: int
    options: dict[str, str]
    has: type
    slow: bool = True
    magnified: float = 1.0

    def plan(self, scalar: str) -> Plan:
        if any(link.inertia.mass == 0.0 for link in self.model.links[1:]):
            schedule = balanced(self.model, self.processes, self.options["form"])
            return make_plan(self.model, schedule, scalar=scalar, form=self.options["form"])
        return plan_of(self.model, self.processes, scalar=scalar, **self.options)


def affected(joints: int, what: str, *, floating: bool = False, mimics: int = 0) -> Model:
    """Return a tree with effects at its joints and forces upon its links."""
    rng = np.random.default_rng(11)
    model = random_tree(rng, joints, branching=0.4, floating=floating, mimics=mimics)
    return with_wrenches(with_effects(model, rng, what), rng)


GATHER, JOIN = {"meeting": "gather"}, {"meeting": "join"}
ADA = {"form": "ada"}
CASES = {
    "alone": Case(human_figure(), 1, JOIN, SolveRoot),
    "alone with effects": Case(affected(6, "drp"), 1, JOIN, Articulate, slow=False),
    "joined by two": Case(affected(7, "dr", mimics=1), 2, JOIN, Join),
    "joined by three": Case(serial_chain(9, axes="xyz"), 3, JOIN, Join),
    "joined by four": Case(human_figure(), 4, JOIN, Join),
    "gathered by two": Case(serial_chain(9, floating=True), 2, GATHER, SolveRoot, slow=False),
    "gathered by three": Case(affected(10, "drp", floating=True), 3, GATHER, SolveRoot),
    "gathered by four": Case(human_figure(), 4, GATHER, SolveRoot),
    "gathered on the ground": Case(serial_chain(9, axes="xyz"), 2, GATHER, SolveMobility),
    "gathered on a ground that is held": Case(
        serial_chain(24, axes="xyz"), 2, GATHER, HoldMobility, magnified=50.0
    ),
    "ada alone": Case(affected(6, "dr", mimics=1), 1, ADA, Join),
    "ada by two, fused": Case(three_axis_chain(3), 2, ADA, FusedJoin, slow=False),
    "ada by three": Case(affected(7, "drp"), 3, ADA, Join),
    "ada by four, fused": Case(three_axis_chain(4), 4, ADA, FusedJoin),
    "segments joined in fused joints": Case(three_axis_chain(4), 2, {"form": "segment"}, FusedJoin),
}


def anything(seed: int, family: str) -> tuple[Model, Plan]:
    """Return a robot and a plan of a family, both at random."""
    rng = np.random.default_rng(seed)
    joints, processes = int(rng.integers(3, 9)), int(rng.integers(1, 5))
    scalar = str(rng.choice(["double", "float"]))
    if family == "fused":
        tree = random_tree(rng, joints, (REVOLUTE, REVOLUTE, PRISMATIC), branching=0.2)
        model = with_massless_links(tree, rng)
        form = str(rng.choice(["ada", "segment"]))
        schedule = any_schedule(model, processes, form, rng)
        return model, make_plan(model, schedule, form=form, scalar=scalar)
    floating, mimics = bool(rng.integers(2)), int(rng.integers(2)) * (family != "gather")
    tree = random_tree(rng, joints, branching=0.4, floating=floating, mimics=mimics)
    model = with_wrenches(with_effects(tree, rng, str(rng.choice(["", "dr", "drp"]))), rng)
    schedule = random_schedule(model, processes, rng)
    if family == "gather" and not can_gather(model):
        family = "join"
    if family == "ada":
        return model, make_plan(model, schedule, form="ada", scalar=scalar)
    return model, make_plan(model, schedule, meeting=family, scalar=scalar)


def in_lanes_off(plan: Plan, states: States, grouping: Grouping) -> float:
    """Return how far limbs in lanes are from balls, beside the largest number of a state."""
    errors = []
    for state in states.each:
        exact = np.array([float(x) for x in interpret(plan, *state, BALLS)])
        found = interpret(plan, *state, lanes=grouping)
        errors.append(np.abs(found - exact).max() / np.abs(exact).max())
    return float(np.max(errors))
