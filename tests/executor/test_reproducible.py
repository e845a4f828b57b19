"""Processes of a reproducible plan compute the same to the last bit, however many they are."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import adagen
from adagen.errors import UsageError
from adagen.executor import Simulated, groupings, interpret, simulate, straight_line
from adagen.executor.line_copies import WaitingLanesError, copied
from adagen.executor.needed_values import NeededValues
from adagen.executor.reproducible import own_limbs
from adagen.executor.solve import Run
from adagen.graph import DOUBLE, FLOAT, RoundedGraph
from adagen.model import PRISMATIC, REVOLUTE, SPHERICAL, Model
from adagen.plan import Plan, make_plan, plan_from_json, plan_to_json
from adagen.plan.simd_groups import Limbs
from adagen.schedule import Topology, load_profile
from adagen.schedule.tree import Gathered
from adagen.search import named_schedule
from adagen.states import random_states
from tests.emit.limbs import alike
from tests.emitted import ROUNDING, forward_error, truth_of
from tests.executor.test_lane_bits import affected, limbs, slaved
from tests.gathered import distributed, reproducible_plan
from tests.models import Array, human_figure, random_tree, serial_chain
from tests.scene.effects import with_effects, with_wrenches
from tests.slow import spread

EXAMPLES = Path(__file__).resolve().parents[2] / "generated_examples" / "models"
ALGEBRAS = {"double": DOUBLE, "float": FLOAT}


def answers(plan: Plan, model: Model, **lanes: object) -> Array:
    """Return the accelerations of two states."""
    states = random_states(model, 2, seed=4)
    algebra = ALGEBRAS[plan.scalar]
    return np.array([interpret(plan, *row, algebra, **lanes) for row in states.each])  # type: ignore[arg-type]


def any_robot(seed: int) -> Model:
    """Return a tree, or a trunk with limbs that are alike, with effects and outer forces or not."""
    rng = np.random.default_rng(seed)
    if seed % 2:
        model = random_tree(rng, 12, branching=0.5, floating=bool(seed % 4 < 2))
    else:
        kinds = [(REVOLUTE, PRISMATIC, SPHERICAL)[k] for k in rng.integers(0, 3, size=2)]
        model = alike(rng, 5, kinds, floating=bool(seed % 4), beside=2, oblique=seed < 6).model
    if seed % 3:
        model = with_wrenches(with_effects(model, rng, "drp"[: seed % 3 + 1]), rng)
    return model


@pytest.mark.parametrize(
    ("seed", "scalar"),
    [
        *spread([(seed, "double") for seed in range(8)], 4),
        *spread([(seed, "float") for seed in range(8)], 2),
    ],
)
def test_any_number_of_processes_in_lanes_or_not(seed: int, scalar: str) -> None:
    model = any_robot(seed)
    alone = reproducible_plan(model, scalar=scalar)
    expected = answers(alone, model)
    rng = np.random.default_rng(seed)
    plans = [
        alone,
        *(reproducible_plan(model, distributed(model, p, rng), scalar=scalar) for p in (2, 3)),
    ]
    for plan in plans:
        for grouping in groupings(plan):
            np.testing.assert_array_equal(answers(plan, model, lanes=grouping), expected)


@pytest.mark.parametrize("seed", [2, 3])
def test_what_is_the_same_is_true(seed: int) -> None:
    model = any_robot(seed)
    truth = truth_of(model, random_states(model, 2, seed=4))
    assert forward_error(answers(reproducible_plan(model), model), truth) < ROUNDING["double"]


@pytest.mark.parametrize("seed", spread(range(8), 3))
def test_constants_that_are_set_are_the_same(seed: int) -> None:
    """Gravity, a mass and a centre of mass are inputs like those of the state."""
    model = any_robot(seed)
    names = [link.name for k, link in enumerate(model.links) if k and link.inertia.mass > 0]
    runtime = f"mass:{names[-1]},gravity,center:{names[-1]},mass:{names[len(names) // 2]}"
    rng = np.random.default_rng(seed)
    plans = [
        reproducible_plan(model, runtime=runtime),
        *(reproducible_plan(model, distributed(model, p, rng), runtime=runtime) for p in (2, 3)),
    ]
    changed = np.array(plans[0].parameter_values) * rng.uniform(0.5, 1.5, 8)
    q, v, tau = next(random_states(model, 1, seed=4).each)
    given = {"q": q, "v": v, "tau": tau, "parameter": changed.tolist()}
    found = [
        Run(plan, given, lanes=grouping).accelerations()
        for plan in plans
        for grouping in groupings(plan)
    ]
    for other in found[1:]:
        np.testing.assert_array_equal(other, found[0])
    assert not np.array_equal(found[0], interpret(plans[0], q, v, tau))


def turned_star(folder: Path) -> Model:
    """Return a hub that floats, with 16 arms of two hinges that differ by how they are turned."""
    hub = '<mass value="5"/><inertia ixx=".1" ixy="0" ixz="0" iyy=".1" iyz="0" izz=".1"/>'
    arm = '<mass value=".3"/><inertia ixx="2e-4" ixy="0" ixz="0" iyy="6e-4" iyz="0" izz="6e-4"/>'
    own = f'<inertial><origin xyz=".05 0 0"/>{arm}</inertial>'
    parts = [f'<link name="hub"><inertial>{hub}</inertial></link>']
    for a in range(16):
        turn = a * np.pi / 8
        x, y = f"{0.2 * np.cos(turn):.10f}", f"{0.2 * np.sin(turn):.10f}"
        near, axis, place = "hub", "0 0 1", f'xyz="{x} {y} 0" rpy="0 0 {turn:.10f}"'
        for name in (f"{a}_0", f"{a}_1"):
            joint = f'<origin {place}/><parent link="{near}"/><child link="a{name}"/>'
            parts += [
                f'<link name="a{name}">{own}</link>',
                f'<joint name="j{name}" type="continuous">{joint}<axis xyz="{axis}"/></joint>',
            ]
            near, axis, place = f"a{name}", "0 1 0", 'xyz=".1 0 0"'
    file = folder / "star.urdf"
    file.write_text(f'<robot name="star">{"".join(parts)}</robot>', encoding="utf-8")
    return adagen.read(file, floating=True).model


def test_lanes_that_would_wait_for_each_other_are_computed_one_by_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One lane is to be sent before a message that another waits for."""
    waited = []

    def watched(want: NeededValues, limbs: tuple[Limbs, ...]) -> Simulated:
        try:
            return copied(want, limbs)
        except WaitingLanesError:
            waited.append(want.process)
            raise

    monkeypatch.setattr("adagen.executor.reproducible.copied", watched)
    model = turned_star(tmp_path)
    owners = [None, *(p for p in map(int, "1212012012010120") for _ in range(2))]
    plan = reproducible_plan(model, Gathered((1,), tuple(owners)))
    assert own_limbs(plan) == ((), (), ())
    assert waited
    expected = answers(reproducible_plan(model), model)
    np.testing.assert_array_equal(answers(plan, model, lanes=own_limbs(plan)), expected)


def test_lanes_and_messages_are_looked_at_above() -> None:
    """Some plan has lanes on several processes that send each other something."""
    model = limbs(8, REVOLUTE, REVOLUTE, REVOLUTE, trunk=1, beside=0)
    plan = reproducible_plan(model, distributed(model, 2, np.random.default_rng(0), core=0.0))
    line = simulate(plan, groupings(plan)[-1])
    assert all(one.machine.rows.rows for one in line)
    assert all(any(one.machine.sent.values()) for one in line)
    assert len(groupings(plan)) == 2
    expected = answers(reproducible_plan(model), model)
    np.testing.assert_array_equal(answers(plan, model, lanes=True), expected)


def test_others_are_not_the_same() -> None:
    """What is promised does not come by itself."""
    model = limbs(8, REVOLUTE, REVOLUTE, REVOLUTE, trunk=1, beside=0)
    gathered = distributed(model, 2, np.random.default_rng(0), core=0.0)
    alone, shared = reproducible_plan(model), reproducible_plan(model, gathered)
    of_one, of_two = (answers(replace(p, reproducible=False), model) for p in (alone, shared))
    assert not np.array_equal(of_one, of_two)


def test_slaved_joints_are_solved_by_one_process_in_lanes_or_not() -> None:
    model = slaved(limbs(4, REVOLUTE, REVOLUTE, REVOLUTE, trunk=4, beside=0))
    plan = reproducible_plan(model)
    none, some = groupings(plan)
    np.testing.assert_array_equal(
        answers(plan, model, lanes=some), answers(plan, model, lanes=none)
    )


def test_effects_of_limbs_are_the_same() -> None:
    model = affected(limbs(3, REVOLUTE, PRISMATIC, REVOLUTE))
    rng = np.random.default_rng(1)
    expected = answers(reproducible_plan(model), model)
    plan = reproducible_plan(model, distributed(model, 3, rng))
    np.testing.assert_array_equal(answers(plan, model, lanes=True), expected)


def test_lanes_that_wait_for_messages_wait_together(tmp_path: Path) -> None:
    """One arm has a joint less than the other: both lanes wait for what one of them needs."""
    scene = tmp_path / "locked.toml"
    scene.write_text("[lock]\nright_wrist_pitch = 0.1\n")
    robot = adagen.read(EXAMPLES / "humanoid.urdf", scene=scene)
    plan = adagen.compile(robot, procs=2, reproducible=True).plan
    assert any(
        each.rows for one in simulate(plan, groupings(plan)[-1]) for each in one.machine.limbs
    )
    expected = answers(reproducible_plan(robot.model), robot.model)
    for grouping in groupings(plan):
        np.testing.assert_array_equal(answers(plan, robot.model, lanes=grouping), expected)


def test_a_plan_is_read_as_it_was_written() -> None:
    plan = reproducible_plan(human_figure())
    assert '"reproducible": true' in plan_to_json(plan)
    assert plan_from_json(plan_to_json(plan)) == plan


def test_what_depends_on_the_processes_is_refused() -> None:
    model = serial_chain(8, axes="xyz")
    profile, topology = load_profile("default"), Topology.of(model)
    schedule = named_schedule("balanced", topology, 2, profile=profile)
    with pytest.raises(UsageError, match="joined at a cut round differently"):
        make_plan(model, schedule, meeting="join", reproducible=True)
    with pytest.raises(UsageError, match="reproducible ones gather at the ground"):
        make_plan(model, schedule, meeting="gather", reproducible=True)
    with pytest.raises(UsageError, match="only form segment is reproducible"):
        make_plan(model, schedule, form="ada", reproducible=True)


def test_constants_are_rounded_as_a_processor_rounds_them() -> None:
    for scalar, number in (("double", np.float64), ("float", np.float32)):
        graph = RoundedGraph(scalar)
        tenth, third = graph.constant(0.1), graph.reciprocal(graph.constant(3))
        expected = number(0.1) * number(0.1) + number(1) / number(3)
        assert float((tenth * tenth + third).constant) == float(expected)


def test_without_lanes_is_without_lanes() -> None:
    plan = reproducible_plan(limbs(4, REVOLUTE, REVOLUTE, REVOLUTE))
    (one,) = straight_line(plan, lanes=False)
    assert all(node.width == 1 for node in one.machine.graph.nodes)
