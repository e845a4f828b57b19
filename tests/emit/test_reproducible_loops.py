"""Reproducible solvers of closed loops answer the same to the last bit, in poor poses, too."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.errors import UsageError
from adagen.executor import groupings, simulate
from adagen.executor.solve import Run, SingularPoseError
from adagen.model import Model
from adagen.plan import Plan, plan_from_json, plan_to_json
from adagen.plan.certificate import certified
from adagen.plan.shared_line import check_reproducible
from adagen.plan.types import THREADS
from adagen.program import check
from adagen.program.lower import lower
from adagen.reference.closed import closed_forward_dynamics
from adagen.schedule import load_profile
from adagen.schedule.tree import Gathered
from adagen.search.base_gathering import reproducible_schedule
from adagen.states import States, read_result, write_states
from benchmarks.closed_robots import MECHANISMS as BENCHMARKS
from tests.emit.test_reproducible import CLANG_FLAGS, FLAGS, runs
from tests.emit.test_reproducible_constants import WIDE, Library
from tests.emitted import QUICK, Array, Builder
from tests.executor.test_closed_processes import figure
from tests.executor.test_separate_trees import carrying
from tests.gathered import reproducible_plan
from tests.mechanisms import four_bar, quadruped, states_of
from tests.slow import all_but, slow

OLD = ("-O1", "-march=x86-64")
ROBOTS: dict[str, Callable[[], Model]] = {
    "four-bar": four_bar,
    "quadruped": quadruped,
    "robots that carry a bar": lambda: carrying("point"),
    **{name: BENCHMARKS[name] for name in ("leg with a parallel ankle", "a1 on four point feet")},
}
ENOUGH = {"double": 1e-11, "float": 1e-3}


def is_poor(plan: Plan, row: tuple[Array, Array, Array]) -> bool:
    """Return whether the first way cannot stand the pose of a state."""
    try:
        Run(plan, dict(zip(("q", "v", "tau"), row, strict=True))).check()
    except SingularPoseError:
        return True
    return False


def mixed(model: Model, plan: Plan, count: int) -> States:
    """Return closed states; of robots on several feet some are poor, some not."""
    states = states_of(model, count, seed=5)
    if model.loops[2:]:
        assert 2 < sum(is_poor(plan, row) for row in states.each) < count - 2
    return states


def ways(plan: Plan, builder: Builder, *, every: bool) -> Iterator[tuple[Builder, Any, Any]]:
    """Yield compilers, their flags, and options of the emitter."""
    yield builder, OLD, {"limbs": groupings(plan)[0]}
    yield from ((builder, flags, {}) for flags in (filter(runs, FLAGS) if every else (WIDE,)))
    yield from ((builder, flags, {"batch": 1}) for flags in (FLAGS[:2] if every else (QUICK,)))
    if shutil.which("clang++"):
        other = builder.with_compiler("clang++")
        known = filter(runs, CLANG_FLAGS) if every else CLANG_FLAGS[-1:]
        yield from ((other, flags, {}) for flags in known)
        if every:
            yield other, WIDE[:2], {"batch": 1}


def same(
    plan: Plan, model: Model, states: States, builder: Builder, folder: Path, *, every: bool
) -> Path:
    """Assert that all answers are the same to the last bit, and return one of them."""
    given, result = folder / "states.json", folder / "result.json"
    write_states(states, model, given)
    expected = ""
    for compiler, flags, how in ways(plan, builder, every=every):
        solver = compiler.solver(plan, flags, **how)
        done = solver.run("--states", given, "--result", result)
        assert (done.status, done.stderr) == (0, "")
        expected = expected or result.read_text(encoding="utf-8")
        assert result.read_text(encoding="utf-8") == expected, (flags, how)
    return result


@pytest.mark.parametrize(
    ("robot", "scalar", "every"),
    [
        ("four-bar", "double", False),
        slow("quadruped", "double", False),
        slow("quadruped", "float", False),
        *(slow(robot, scalar, True) for robot in ROBOTS for scalar in ("double", "float")),
    ],
)
def test_compilers_lanes_and_batches(
    robot: str, scalar: str, every: bool, builder: Builder, tmp_path: Path
) -> None:
    model = ROBOTS[robot]()
    plan = reproducible_plan(model, scalar=scalar)
    states = mixed(model, plan, 24)
    found = read_result(same(plan, model, states, builder, tmp_path, every=every), model)
    truth = np.array([closed_forward_dynamics(model, *row) for row in states.each])
    assert np.abs(found - truth).max() < ENOUGH[scalar] * np.abs(truth).max()


def shared(model: Model, owners: list[int | None], **options: str) -> Plan:
    """Return a plan of threads around a floating base that have the joints given."""
    plan = reproducible_plan(model, Gathered((1,), tuple(owners)), **options)
    return replace(plan, channel=THREADS)


LAYOUTS = {
    "quadruped on two": (quadruped, [None, *[0] * 6, *[1] * 6]),
    "quadruped on three": (quadruped, [None, *[0] * 3, *[1] * 6, *[2] * 3]),
    "figure on three": (figure, [None, *[0] * 3, *[1] * 3, *[2] * 8]),
}


# Emitted, the first one is compared in the next test.
@pytest.mark.parametrize("name", all_but(LAYOUTS, "quadruped on two", "figure on three"))
def test_each_way_of_processes_is_that_of_one(name: str) -> None:
    """Lanes or not, and in poor poses each for itself."""
    make, owners = LAYOUTS[name]
    model = make()
    alone, plan = reproducible_plan(model), shared(model, owners)
    assert plan_from_json(plan_to_json(plan)) == plan
    assert all(any(one.machine.sent.values()) for one in simulate(plan))
    states = states_of(model, 2)
    for way, of_one in zip(plan.alternatives, alone.alternatives, strict=True):
        check(lower(way, "unrolled"))
        for row in states.each:
            given = dict(zip(("q", "v", "tau"), row, strict=True))
            expected = Run(of_one, given).accelerations()
            for grouping in groupings(way):
                found = Run(way, given, lanes=grouping).accelerations()
                np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize(
    ("name", "scalar", "flags"),
    [
        ("quadruped on two", "double", WIDE),
        slow("quadruped on two", "double", OLD),
        slow("quadruped on two", "float", WIDE),
        *(slow(name, "double", WIDE) for name in ("quadruped on three", "figure on three")),
    ],
)
def test_processes(
    name: str, scalar: str, flags: tuple[str, ...], builder: Builder, tmp_path: Path
) -> None:
    """Threads, in lanes unless the processor is an old one, in poor poses, too.

    All go the next way together.
    """
    make, owners = LAYOUTS[name]
    model = make()
    alone, plan = reproducible_plan(model, scalar=scalar), shared(model, owners, scalar=scalar)
    states = mixed(model, alone, 24)
    expected = Library(alone, builder, QUICK, tmp_path).solve(states)
    none, some = groupings(plan)
    solver = Library(plan, builder, flags, tmp_path, limbs=none if flags is OLD else some)
    np.testing.assert_array_equal(solver.solve(states), expected)


@pytest.mark.slow
@pytest.mark.parametrize("channel", ["window", "message"])
def test_processes_of_mpi(channel: str, builder: Builder, tmp_path: Path) -> None:
    """By either channel, what one process answers."""
    make, owners = LAYOUTS["quadruped on three"]
    model = make()
    alone, plan = reproducible_plan(model), replace(shared(model, owners), channel=channel)
    states = mixed(model, alone, 24)
    expected = Library(alone, builder, QUICK, tmp_path).solve(states)
    found = builder.solver(plan).solve(model, states, tmp_path)
    np.testing.assert_array_equal(found, expected)


def test_processes_that_may_go_different_ways_are_refused() -> None:
    """Each has a robot that floats apart from the other's; or nobody hears of a poor pose."""
    model = carrying("point")
    robots = Gathered((1, 10), (*[0] * 9, *[1] * 9))
    with pytest.raises(UsageError, match="processes that share a loop"):
        reproducible_plan(model, robots)
    assert not reproducible_schedule(model, 2, load_profile("default")).gathered
    make, owners = LAYOUTS["quadruped on two"]
    plan = shared(make(), owners)
    with pytest.raises(UsageError, match="do not hear of each other's poor poses"):
        check_reproducible(replace(plan, messages=plan.messages[:1]), Gathered((1,), tuple(owners)))


@pytest.mark.parametrize("robot", ["four-bar", slow("leg with a parallel ankle")])
def test_certificates(robot: str, builder: Builder, tmp_path: Path) -> None:
    model = ROBOTS[robot]()
    plan = certified(reproducible_plan(model))
    result = same(plan, model, states_of(model, 9), builder, tmp_path, every=False)
    bounds = json.loads(result.read_text())["error_bounds"]
    assert all(0 < bound < 1e-6 for bound in bounds)


@pytest.mark.parametrize("scalar", ["double", slow("float")])
def test_neighbours_in_a_batch_do_not_matter(scalar: str, builder: Builder, tmp_path: Path) -> None:
    """Poor poses, good ones and open loops side by side: each is answered as if it were alone."""
    model = quadruped()
    plan = reproducible_plan(model, scalar=scalar)
    states = mixed(model, plan, 24)
    states.q[[3, 11, 12], -1] += 0.3  # a foot is off the ground
    states.tau[17] = np.nan
    alone, many = (
        Library(plan, builder, QUICK, tmp_path, batch=batch, refused=True) for batch in (0, 1)
    )
    expected, found = alone.solve(states), many.solve(states)
    np.testing.assert_array_equal(found, expected)
    assert np.flatnonzero(np.isnan(found).any(axis=1)).tolist() == [3, 11, 12, 17]
    for k in range(0, 24, 5):  # other neighbours
        turned = States(*(np.roll(x, k, axis=0) for x in (states.q, states.v, states.tau)))
        np.testing.assert_array_equal(many.solve(turned), np.roll(expected, k, axis=0))
