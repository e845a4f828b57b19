"""Residuals of straight lines that a loop over rows of joints sweeps: the bounds are the same."""

from __future__ import annotations

import ctypes
import shutil
from dataclasses import replace
from itertools import product

import numpy as np
import pytest

from adagen.build import Toolchain
from adagen.build.toolchain import STANDARD, WARNINGS
from adagen.cost import programmed
from adagen.cost.straight import straight_stretches
from adagen.emit import emit, stem_of
from adagen.executor import Swept, chosen_grouping, simulate
from adagen.executor.swept_records import passes
from adagen.model import PRISMATIC, REVOLUTE, Model, Passive
from adagen.plan import Plan, plan_from_json, plan_to_json
from adagen.plan.certificate import looped
from adagen.plan.steps import Certify
from adagen.schedule import CostProfile
from adagen.states import random_states
from adagen.studies.random_states import hard_states
from adagen.studies.stability.loaded import loaded
from adagen.urdf import read_robot
from benchmarks.stability.adversary import FAMILIES, robots
from benchmarks.stability.bounds import Certified, bounded, certified_plan
from tests.cost.costs import step_costs, step_profile
from tests.emitted import NARROW, OPTIMISED, Builder
from tests.golden.make_models import MODELS
from tests.models import binary, random_tree, serial_chain, star
from tests.slow import slow, spread

CALL = "sweep_rows<"
ALL = 1000  # rows: more than there are
LINE, LOOP, PART = (Certified("unrolled", looped=rows) for rows in (0, ALL, 3))
IN_FLOAT = replace(LINE, scalar="float"), replace(LOOP, scalar="float")


@pytest.fixture(scope="module")
def quick(builder: Builder) -> Toolchain:
    return builder.quick


def _humanoid(*, floating: bool = True) -> Model:
    return read_robot(MODELS / "humanoid.urdf", floating=floating).model


def _tree(seed: int, joints: int, *, floating: bool = False) -> Model:
    """A tree of hinges on random axes."""
    rng = np.random.default_rng(seed)
    return random_tree(rng, joints, kinds=(REVOLUTE,), floating=floating)


def _damped(model: Model) -> Model:
    """A robot with dampers and springs at its joints."""
    joints = tuple(
        replace(joint, passive=Passive(damping=0.1, stiffness=0.4 * (j % 2)))
        if joint.kind == REVOLUTE
        else joint
        for j, joint in enumerate(model.joints)
    )
    return replace(model, joints=joints)


def _line(plan: Plan, profile: CostProfile | None = None) -> str:
    """The text of a plan's straight line."""
    return emit(plan, shape="unrolled", profile=profile)[f"{stem_of(plan)}.cpp"]


def _in_loop(model: Model) -> Plan:
    """The certified plan of a robot with a loop."""
    plan = looped(certified_plan(model), ALL)
    assert plan is not None
    return plan


ROBOTS = {
    "arms and legs in lanes, on a trunk and a base that floats": _humanoid(),
    "single joints, some of them on one link": _damped(_tree(3, 9)),
    "lanes of several widths on one link": star(5, 3, floating=True),
    "humanoid": _humanoid(floating=False),
    "chain": serial_chain(6),
    "binary": binary(4),
    "tree": _damped(_tree(7, 14, floating=True)),
}
WAYS = {"all rows": (LINE, LOOP), "some rows": (LINE, PART), "in float": IN_FLOAT}


@pytest.mark.parametrize(("name", "way"), spread(product(ROBOTS, WAYS), 3))
def test_bounds_are_those_without_a_loop(name: str, way: str, quick: Toolchain) -> None:
    """They hold, and differ by what the residuals' own last digits make of them."""
    model, (line, loop) = ROBOTS[name], WAYS[way]
    found = bounded(model, random_states(model, 12, seed=4), (line, loop), quick)
    assert set(found) == {line, loop}
    assert found[loop].refused == 0
    assert (found[loop].ratios <= 1).all()
    np.testing.assert_allclose(found[loop].bounds, found[line].bounds, rtol=0.3)
    np.testing.assert_allclose(found[loop].errors, found[line].errors, rtol=1e-9)


@pytest.mark.parametrize("k", spread(range(len(FAMILIES)), 2), ids=lambda k: FAMILIES[k].__name__)
def test_hard_robots_keep_their_bounds(k: int, quick: Toolchain) -> None:
    model = robots(k + 1, seed=31)[k]
    found = bounded(model, hard_states(model, 30, seed=3), [LOOP, *IN_FLOAT], quick)
    assert (LOOP in found) == any(joint.kind in (REVOLUTE, PRISMATIC) for joint in model.joints)
    for way, one in found.items():
        assert (one.ratios <= 3).all(), f"{way}: {one.ratios.max()}"


def test_a_state_that_is_not_finite_leaves_nothing_behind(quick: Toolchain) -> None:
    """Lanes without a joint would keep what is not a number."""
    model = _humanoid()
    plan = _in_loop(model)
    text, stem = _line(plan), stem_of(plan)
    (state,) = random_states(model, 1, seed=2).each
    bounds, qdd = [], np.zeros(model.nv)
    with loaded(text, stem, plan, quick) as call:
        for k in (None, model.nv - 1, None):
            q, v, tau = (x.copy() for x in state)
            if k is not None:
                q[k + 1] = v[k] = np.nan
            failed = call("solve", ctypes.c_int, q, v, tau, qdd)
            assert bool(failed) == (k is not None)
            bounds.append(call("error_bound", ctypes.c_double))
    assert bounds[2] == bounds[0] < 1e-12


@pytest.mark.parametrize(
    ("compiler", "flags"),
    [
        slow("g++", OPTIMISED),
        ("g++", NARROW),
        slow("clang++", OPTIMISED),
        slow("clang++", NARROW),
    ],
)
def test_bounds_of_other_compilers(compiler: str, flags: tuple[str, ...], builder: Builder) -> None:
    """Without warnings, too."""
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    model = _humanoid()
    other = builder.with_compiler(compiler).toolchain
    toolchain = replace(other, flags=(*STANDARD, *WARNINGS, "-Werror", *flags))
    found = bounded(model, random_states(model, 4, seed=2), [LINE, LOOP], toolchain)
    assert (found[LOOP].ratios <= 1).all()
    np.testing.assert_allclose(found[LOOP].bounds, found[LINE].bounds, rtol=0.3)


def _swept(plan: Plan) -> Swept:
    """What the straight line of a plan leaves for its loop."""
    (line,) = simulate(plan)
    assert line.machine.swept is not None
    return line.machine.swept


def test_a_loop_takes_the_outermost_rows() -> None:
    """In an order in which nothing is gathered once it is handed on."""
    plan = certified_plan(serial_chain(6))
    for rows in (1, 4, 6, ALL):
        plan = looped(plan, rows) or plan
        swept = _swept(plan)
        assert len(swept.rows) == min(rows, 6)
        places = [row.place for row in swept.rows]
        assert places == sorted(places)
        for row in swept.rows:
            assert all(each.near > row.place for each in row.passes)
        assert all(row.next and len(row.passes) == 1 for row in swept.rows[:-1])
        assert len(swept.rows[-1].passes) == (rows < 6)


def test_lanes_that_part_have_their_price() -> None:
    plan = _in_loop(star(4, 3, floating=True))
    (line,) = simulate(plan, chosen_grouping(plan))
    swept = line.machine.swept
    assert swept is not None and len(swept.rows) == 3
    assert [row.next for row in swept.rows] == [True, True, False]
    assert [len(row.passes) for row in swept.rows] == [1, 1, 4]
    each = replace(swept, rows=swept.rows[:2]).operations / 2
    assert swept.operations == 3 * each + 4 * 13


def test_lanes_are_handed_on_in_as_few_passes_as_can_be() -> None:
    (one,) = passes([(0, 9), (1, 8), (3, 11)], 4)
    assert (one.near, one.sources, one.straight) == (8, (1, 0, None, 3), False)
    several = passes([(0, 10), (1, 10), (2, 10), (3, 11), (2, 16)], 4)
    assert [each.near for each in several] == [8, 8, 8, 16]
    assert several[0].sources == (None, None, 2, 3) and several[0].straight
    assert {each.sources[2] for each in several[:3]} == {0, 1, 2}


def test_which_robots_loops_sweep() -> None:
    assert looped(certified_plan(_tree(1, 5)), ALL) is not None
    arm = certified_plan(serial_chain(30), parts=True)
    assert looped(arm, ALL) is None
    assert looped(certified_plan(star(4, 3), processes=2), ALL) is None


def test_lines_that_the_instruction_cache_does_not_hold_have_loops() -> None:
    """Of lines that may just exceed it some rows, of longer ones all; none of what stays longer.

    The humanoid's line has some 31.8 kB, and 28.3 with a loop for all rows.
    """
    plan, rows = certified_plan(_humanoid()), {}
    for cache in (64, 33.2, 31.8, 26.5, 25):
        profile = step_profile(unrolled__cache=1000 * cache)
        (certify,) = programmed(plan, "unrolled", profile).plan.steps_of(Certify)
        rows[cache] = certify.looped
    assert rows[64] == rows[33.2] == rows[25] == 0
    assert 0 < rows[31.8] < rows[26.5] < ALL
    assert CALL in _line(plan, step_profile(unrolled__cache=28e3)) and CALL not in _line(plan)


def test_lines_have_none_where_it_takes_longer() -> None:
    """A machine on which lines that do not fit take no longer than others, and one where they do.

    The humanoid's line has some 3,300 statements, and some 2,900 with such a loop.
    """
    plan = certified_plan(_humanoid())
    for evicted, has_loop in ((0.0, False), (0.1, True)):
        profile = step_profile(
            unrolled__cache=28e3,
            unrolled__fetched=0.0,
            unrolled__fits=3_200,
            unrolled__evicted=evicted,
        )
        assert (CALL in _line(plan, profile)) == has_loop


def test_what_a_loop_does_again_is_fetched_once() -> None:
    """A line that does not fit even with its loop: statements that are read, not repetitions."""
    plan = _in_loop(_humanoid())
    ((part,),) = straight_stretches(programmed(plan, "unrolled"), 0.0)
    done = part.features["unrolled.operation"] + part.features["unrolled.move"]
    assert part.line < done - 700  # the loop's own operations, less what is read of it once

    def time(evicted: float) -> float:
        costs = step_costs(unrolled__fits=0.0, unrolled__evicted=evicted, unrolled__cycle=0.0)
        return part.time(costs)

    assert time(5.0) == pytest.approx(time(0.0) + 5 * part.line)


def test_batches_have_none_and_plans_keep_it() -> None:
    plan = _in_loop(_humanoid())
    assert plan_from_json(plan_to_json(plan)) == plan
    text = emit(plan, shape="unrolled", batch=1)[f"{stem_of(plan, batch=1)}.cpp"]
    assert CALL not in text and CALL in _line(plan)
