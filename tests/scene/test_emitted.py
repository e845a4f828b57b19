"""Emitted solvers with effects, prescribed motions and outer forces, built and run."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from adagen.model import PRISMATIC, REVOLUTE, Model
from adagen.plan import make_plan
from adagen.states import random_states, write_states
from tests.emitted import Builder, Solver, forward_error, text_of, truth_of
from tests.models import ALL_KINDS, random_tree, serial_chain
from tests.scene.effects import with_effects, with_wrenches
from tests.schedules import random_schedule
from tests.slow import slow


def built(
    model: Model, processes: int, form: str, rng: np.random.Generator, builder: Builder
) -> Solver:
    plan = make_plan(model, random_schedule(model, processes, rng), form=form)
    return builder.solver(plan)


@pytest.mark.parametrize(
    ("form", "processes", "joints", "mimics"),
    [("segment", 1, 7, 1), slow("segment", 3, 9, 0), ("ada", 2, 6, 0)],
)
def test_every_effect_is_emitted(
    form: str, processes: int, joints: int, mimics: int, builder: Builder, tmp_path: Path
) -> None:
    rng = np.random.default_rng(joints)
    kinds = (REVOLUTE, PRISMATIC) if mimics else ALL_KINDS
    model = random_tree(rng, joints, kinds, mimics=mimics)
    model = with_wrenches(with_effects(model, rng), rng)
    solver = built(model, processes, form, rng, builder)
    states = random_states(model, 4, seed=2)
    answer = solver.solve(model, states, tmp_path)
    assert forward_error(answer, truth_of(model, states)) < 1e-12
    done = solver.run("--check", "--time", "--repeat", "1", "--json")
    assert json.loads(done.stdout)["check"]["residual_max"] < 1e-11


def test_states_without_what_is_an_input_are_refused(builder: Builder, tmp_path: Path) -> None:
    rng = np.random.default_rng(5)
    chain = serial_chain(3)
    model = with_wrenches(with_effects(chain, rng, "p"), rng, 1)
    known = next(joint.name for joint in model.joints if joint.prescribed)
    solver = built(model, 1, "segment", rng, builder)
    states, good = random_states(model, 2, seed=1), tmp_path / "good.json"
    write_states(states, model, good)
    assert solver.run("--states", good).status == 0
    bad = tmp_path / "bad.json"

    def refusal(text: str) -> str:
        bad.write_text(text)
        done = solver.run("--states", bad)
        assert (done.status, done.stdout) == (1, "")
        (line,) = done.stderr.splitlines()
        return str(line)

    text = good.read_text()
    document = json.loads(text)
    document["joints"][known]["tau"] = document["joints"][known].pop("qdd")
    assert f'joint "{known}": unknown member "tau"' in refusal(json.dumps(document))
    document = json.loads(text)
    document["forces"]["tool9"] = document["forces"].pop("tool0")
    assert 'no outer force acts on link "tool9"' in refusal(json.dumps(document))
    document = json.loads(text)
    document["forces"]["tool0"].pop()
    assert "1 states, but the joints have 2" in refusal(json.dumps(document))
    document["forces"]["tool0"] = [[1, 2], [3, 4]]
    assert "needs six numbers for each state" in refusal(json.dumps(document))
    document.pop("forces")
    assert "0 states, but the joints have 2" in refusal(json.dumps(document))


def test_robots_without_effects_have_none_in_their_code() -> None:
    rng = np.random.default_rng(0)
    model = serial_chain(4)
    plan = make_plan(model, random_schedule(model, 1, rng))
    text, _, _ = text_of(plan).partition("// ---- program")  # which simulates any robot
    for word in ("Geared", "Held", "outer_force", "tanh((", "take_passive"):
        assert word not in text
