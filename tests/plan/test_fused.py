"""Runs of joints that are joined as one, and clusters around links of singular inertia."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from adagen.errors import InputError
from adagen.exact import exact, rounded
from adagen.executor import Run, interpret
from adagen.executor.join_digits import predicted_growth
from adagen.model import PRISMATIC, REVOLUTE, Inertia, Mimic, Model
from adagen.model.fuse import runs_of
from adagen.model.placement import rotation_about
from adagen.plan import FORMS, make_plan, plan_from_json, plan_to_json
from adagen.plan.clusters import clusters_of, fold_of
from adagen.plan.cuts import cuttable_joints
from adagen.plan.fused_frame import joint_coordinates
from adagen.plan.steps import FusedJoin, Join, LinkBias
from adagen.plan.types import Plan
from adagen.reference import exact_forward_dynamics, forward_dynamics
from adagen.schedule import Schedule, Topology, load_profile, validate
from adagen.search import best_schedule, named_schedule
from adagen.states import random_states
from tests.links import with_inertia
from tests.models import random_tree, serial_chain, three_axis_chain
from tests.schedules import random_schedule

PROFILE = load_profile("default")


def fused(plan: Plan) -> list[FusedJoin]:
    """Return the steps of a plan that join several joints as one."""
    return [s for process in plan.processes for s in process.steps if isinstance(s, FusedJoin)]


def with_massless_links(model: Model, rng: np.random.Generator) -> Model:
    """Return the model without the mass of some links, at most two in a row and no leaf."""
    row = [0] * len(model.links)
    for number in range(1, len(row)):
        above = row[model.joints[number - 1].parent]
        if len(model.children[number]) == 1 and above < 2 and rng.random() < 0.7:
            model = with_inertia(model, number, Inertia.zero())
            row[number] = above + 1
    return model


def balanced(model: Model, processes: int, form: str) -> Schedule:
    """Return a schedule that is cut wherever processes are there."""
    seen = fold_of(model, form)
    found = named_schedule("balanced", seen.topology, processes, profile=PROFILE)
    return seen.unfold(found, PROFILE)


def any_schedule(model: Model, processes: int, form: str, rng: np.random.Generator) -> Schedule:
    """Return a schedule at random among those that join runs as one."""
    seen = fold_of(model, form)
    names = ["balanced", "sequential", "middle-out"]
    name = names[int(rng.integers(3))]
    found = named_schedule(name, seen.topology, processes, profile=PROFILE)  # type: ignore[arg-type]
    schedule = seen.unfold(found, PROFILE)
    validate(schedule, Topology.of(model))
    return schedule


@settings(max_examples=30)
@given(
    st.integers(3, 10), st.integers(1, 4), st.sampled_from(sorted(FORMS)), st.integers(0, 2**32 - 1)
)
def test_any_run_of_any_tree_is_right(joints: int, processes: int, form: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    tree = random_tree(rng, joints, (REVOLUTE, REVOLUTE, PRISMATIC), branching=0.2)
    model = with_massless_links(tree, rng)
    plan = make_plan(model, any_schedule(model, processes, form, rng), form=form)
    if form == "ada":
        assert sorted(s.run for s in fused(plan)) == sorted(runs_of(model))
    sample = random_states(model, 1, seed=seed % 1000)
    q, v, tau = sample.q[0], sample.v[0], sample.tau[0]
    run = Run(plan, {"q": q, "v": v, "tau": tau})
    for p, process in enumerate(plan.processes):
        for step in process.steps:
            if isinstance(step, FusedJoin):
                frame = run.machines[p].memory["join", step.joint].frame
                assume(np.linalg.cond(run.of(p, frame.turn)) < 1e4)  # not near gimbal lock
    truth = forward_dynamics(model, q, v, tau)
    assert np.abs(interpret(plan, q, v, tau) - truth).max() < 1e-7 * max(1.0, np.abs(truth).max())


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("processes", [1, 2, 4])
def test_three_axes_four_times(form: str, processes: int) -> None:
    """Case 6 of the stability suite: fused, the error is that of rounding."""
    model = three_axis_chain(4)
    plan = make_plan(model, balanced(model, processes, form), form=form)
    assert len(fused(plan)) == 4 if form == "ada" else bool(fused(plan)) == (processes > 1)
    i = np.arange(1.0, 13.0)
    q, v, tau = np.pi * np.sin(1.7 * i), np.cos(2.3 * i), np.sin(3.1 * i)
    truth = exact_forward_dynamics(model, q, v, tau).value
    assert np.abs(interpret(plan, q, v, tau) - truth).max() < 1e-11 * np.abs(truth).max()
    assert predicted_growth(plan).error < 1e-11
    assert plan_from_json(plan_to_json(plan)) == plan


def test_a_schedule_that_parts_a_run_is_refused() -> None:
    model = three_axis_chain(3)
    schedule = named_schedule("balanced", Topology.of(model), 1, profile=PROFILE)
    with pytest.raises(InputError, match=r'link ".*" has no mass; .*form segment'):
        make_plan(model, schedule, form="ada")


def test_slaved_joints_inside_of_runs() -> None:
    model = three_axis_chain(3)
    joints = list(model.joints)
    joints[4] = replace(joints[4], mimic=Mimic(1, -0.5, 0.3))
    joints[8] = replace(joints[8], mimic=Mimic(6, 1.5, 0.1))
    model = replace(model, joints=tuple(joints))
    sample = random_states(model, 2, seed=2)
    for form, processes in (("ada", 1), ("ada", 2), ("segment", 2)):
        plan = make_plan(model, balanced(model, processes, form), form=form)
        assert fused(plan)
        for q, v, tau in sample.each:
            truth = forward_dynamics(model, q, v, tau)
            assert np.abs(interpret(plan, q, v, tau) - truth).max() < 1e-8 * np.abs(truth).max()


def test_gimbal_lock_names_the_joints() -> None:
    model = three_axis_chain(2)
    plan = make_plan(model, best_schedule(model, 1, PROFILE, "ada"), form="ada")
    q, zero = np.full(6, 0.3), np.zeros(6)
    q[4] = np.pi / 2  # of x, y, z the first and the last one meet
    with pytest.raises(FloatingPointError, match='"b01x", "b01y", "b01z": gimbal lock'):
        interpret(plan, q, zero, zero)
    q[4] += 1e-5
    assert np.isfinite(interpret(plan, q, zero, zero)).all()


@settings(max_examples=50)
@given(st.integers(2, 6), st.floats(-3, 3), st.integers(0, 2**32 - 1))
def test_coordinates_of_a_run(n: int, decades: float, seed: int) -> None:
    """B S = [1; 0], and how near gimbal lock is does not depend on the unit of length."""
    s = np.random.default_rng(seed).normal(size=(6, n))
    b, lock = joint_coordinates(s, 1.0)
    assume(lock > 1e-3)
    assert np.abs(b @ s - np.eye(6)[:, :n]).max() < 1e-10
    s[3:] *= 10.0**decades
    assert joint_coordinates(s, 10.0**decades)[1] == pytest.approx(lock, rel=1e-6)


def points(joints: int) -> Model:
    """Return a chain with a point mass at the end of every link but the last three."""
    model = serial_chain(joints)
    point = Inertia(0.5, np.array([0.2, 0.05, 0.03]), np.zeros((3, 3)))
    links = [replace(link, inertia=point) for link in model.links[1 : joints - 2]]
    return replace(model, links=(model.links[0], *links, *model.links[joints - 2 :]))


def test_links_of_singular_inertia_are_joined_with_their_neighbours() -> None:
    model = points(8)
    clusters = clusters_of(model, runs_of(model))
    assert set(clusters) == {0, 1, 2, 3, 4}
    sample = random_states(model, 2, seed=4)
    for processes in (1, 2, 4):
        plan = make_plan(model, best_schedule(model, processes, PROFILE, "ada"), form="ada")
        steps = [step for process in plan.processes for step in process.steps]
        assert {s.joint for s in steps if isinstance(s, Join)} == {5, 6, 7}
        assert {s.link for s in steps if isinstance(s, LinkBias)} == {6, 7, 8}
        assert predicted_growth(plan).error < 1e-9
        for q, v, tau in sample.each:
            truth = exact_forward_dynamics(model, q, v, tau).value
            assert np.abs(interpret(plan, q, v, tau) - truth).max() < 1e-10 * np.abs(truth).max()


def test_a_robot_of_one_cluster_is_left_to_one_process() -> None:
    point = points(5).links[1]
    model = serial_chain(3)
    model = replace(model, links=(model.links[0], point, point, point))
    plan = make_plan(model, best_schedule(model, 2, PROFILE, "ada"), form="ada")
    assert [len(process.owns) for process in plan.processes] == [3, 0]


def test_branches_without_mass_are_clusters_in_form_ada() -> None:
    rng = np.random.default_rng(3)
    model = random_tree(rng, 7, (REVOLUTE,), branching=0.6)
    number = next(k for k in range(1, 8) if len(model.children[k]) > 1)
    model = with_inertia(model, number, Inertia.zero())
    inside = clusters_of(model, runs_of(model))
    assert {number - 1, *model.children[number]} <= set(inside)
    plan = make_plan(model, best_schedule(model, 2, PROFILE, "ada"), form="ada")
    sample = random_states(model, 1, seed=1)
    truth = forward_dynamics(model, sample.q[0], sample.v[0], sample.tau[0])
    answer = interpret(plan, sample.q[0], sample.v[0], sample.tau[0])
    assert np.abs(answer - truth).max() < 1e-8 * np.abs(truth).max()


def test_runs_may_be_cut_where_their_joints_may_not() -> None:
    model = three_axis_chain(4)
    assert not any(cuttable_joints(model))
    assert all(cuttable_joints(model, "double", fold_of(model, "segment").joints))


def test_robots_without_such_links_are_seen_as_they_are() -> None:
    for seed in range(5):
        model = random_tree(np.random.default_rng(seed), 8)
        assert runs_of(model) == ()
        for form in FORMS:
            seen = fold_of(model, form)
            assert seen.trivial
            assert seen.topology == Topology.of(model)
        schedule = random_schedule(model, 2, np.random.default_rng(seed))
        assert seen.unfold(schedule, PROFILE) is schedule


def test_a_slide_along_a_hinge_keeps_all_digits() -> None:
    """The hinge passes the last link's origin at a distance that is rounding."""
    chain = serial_chain(5)
    axis = np.array([-0.6, 0.1, -1.9])
    axis /= np.linalg.norm(axis)
    joints = list(chain.joints)
    joints[2] = replace(joints[2], kind=REVOLUTE, axis=axis)
    turned = rotation_about(exact(axis), exact(0.7).item())
    joints[3] = replace(
        joints[3], kind=PRISMATIC, axis=axis, rotation=rounded(turned), translation=23.7 * axis
    )
    model = with_inertia(replace(chain, joints=tuple(joints)), 3, Inertia.zero())
    (run,) = runs_of(model)
    assert run == (2, 3)
    assert len(cuttable_joints(model)) == 5
    sample = random_states(model, 2, seed=4)
    for processes in (1, 2):
        plan = make_plan(model, balanced(model, processes, "ada"), form="ada")
        for q, v, tau in sample.each:
            truth = forward_dynamics(model, q, v, tau)
            found = interpret(plan, q, v, tau)
            assert np.abs(found - truth).max() < 1e-10 * np.abs(truth).max()
