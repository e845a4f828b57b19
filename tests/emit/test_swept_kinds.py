"""Loops that sweep residuals of slides, with rotors, outer forces, and masses that are set."""

from __future__ import annotations

import ctypes
import re
from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from numpy.typing import NDArray

from adagen.build import Toolchain
from adagen.emit import emit, stem_of
from adagen.executor import Swept, chosen_grouping, simulate
from adagen.executor.refine import WideLinks
from adagen.model import PRISMATIC, REVOLUTE, SPHERICAL, Inertia, Model
from adagen.plan import Plan
from adagen.plan.certificate import certified, looped
from adagen.states import States, random_states
from adagen.studies.stability.loaded import loaded
from benchmarks.stability.bounds import Certified, bounded, certified_plan
from benchmarks.stability.mechanisms import worst_states
from tests.emitted import Builder, plan_of, truth_of
from tests.mechanisms import looped_tree
from tests.models import random_tree, star
from tests.scene.effects import with_effects, with_wrenches
from tests.slow import spread

Array = NDArray[np.float64]
ALL = 1000  # rows: more than there are
LINE, LOOP, PART = (Certified("unrolled", looped=rows) for rows in (0, ALL, 3))
WAYS = {"all rows": LOOP, "some rows": PART, "in float": replace(LOOP, scalar="float")}
SLIDES = (REVOLUTE, PRISMATIC)


@pytest.fixture(scope="module")
def quick(builder: Builder) -> Toolchain:
    return builder.quick


def _arms(sliding: str, *, floating: bool) -> Model:
    """Five arms side by side, of which some joints slide."""
    model = star(5, 3, floating=floating)
    joints = (
        replace(joint, kind=PRISMATIC) if joint.name.endswith(sliding) else joint
        for joint in model.joints
    )
    return replace(model, joints=tuple(joints))


def _tree(seed: int, *kinds: object, floating: bool) -> Model:
    rng = np.random.default_rng(seed)
    return random_tree(rng, 9, kinds=kinds, floating=floating)  # type: ignore[arg-type]


def _driven(model: Model, seed: int = 1) -> Model:
    """The robot with dampers, springs and rotors, and forces on three of its links."""
    rng = np.random.default_rng(seed)
    return with_wrenches(with_effects(model, rng, "dr"), rng, 3)


TREES = {
    "slides in lanes, driven": _driven(_arms("_1", floating=True)),
    "slides": _tree(3, *SLIDES, floating=False),
    "slides, floating": _tree(4, *SLIDES, floating=True),
    "rotors": with_effects(_tree(5, REVOLUTE, floating=True), np.random.default_rng(2), "r"),
    "outer forces": with_wrenches(_tree(6, REVOLUTE, floating=True), np.random.default_rng(3), 4),
    "slides, driven": _driven(_tree(7, *SLIDES, floating=True)),
    "slides and balls, driven": _driven(_tree(12, *SLIDES, SPHERICAL, floating=False)),
    "last joints slide": _driven(_arms("_2", floating=False)),
}
CLOSED = {
    f"{kind}, {seed}": _driven(looped_tree(kind, seed, joints=9, floating=seed != 3, kinds=SLIDES))
    for seed, kind in enumerate(("revolute", "spherical", "revolute", "universal", "weld"), 1)
}


def _swept(plan: Plan | None) -> Swept:
    """What the straight line of a plan leaves for its loop."""
    assert plan is not None
    (line,) = simulate(plan, chosen_grouping(plan))
    assert line.machine.swept is not None
    return line.machine.swept


def _holds(swept: Swept) -> int:
    return sum(x.constant == 1 for row in swept.rows for x in row.constants[31])


def _same_bounds(model: Model, states: States, way: Certified, quick: Toolchain) -> None:
    """Bounds hold, and differ by what the residuals' own last digits make of them."""
    line = replace(way, looped=0)
    found = bounded(model, states, (line, way), quick)
    assert set(found) == {line, way} and found[line].errors.size
    assert (found[line].ratios <= 1).all()
    assert (found[way].ratios <= 1).all()
    assert found[way].refused == found[line].refused
    np.testing.assert_allclose(found[way].bounds, found[line].bounds, rtol=0.3)
    np.testing.assert_allclose(found[way].errors, found[line].errors, rtol=1e-6)


@pytest.mark.parametrize(("name", "way"), spread(product(TREES, WAYS), 2))
def test_bounds_of_trees_are_those_without_a_loop(name: str, way: str, quick: Toolchain) -> None:
    model = TREES[name]
    _swept(looped(certified_plan(model), ALL))
    _same_bounds(model, random_states(model, 12, seed=4), WAYS[way], quick)


@pytest.mark.parametrize(("name", "way"), spread(product(CLOSED, ("all rows", "some rows")), 1))
def test_bounds_of_closed_loops_are_those_without_a_loop(
    name: str, way: str, quick: Toolchain
) -> None:
    """Some of the joints that hold slide."""
    model = CLOSED[name]
    swept = _swept(looped(certified_plan(model), ALL))
    assert swept.slides and swept.rotors and _holds(swept)
    _same_bounds(model, worst_states(model, 12, seed=4), WAYS[way], quick)


def test_a_slide_that_is_not_finite_leaves_nothing_behind(quick: Toolchain) -> None:
    """Nor does a force: lanes without a joint would keep what is not a number."""
    model = TREES["slides in lanes, driven"]
    plan = looped(certified_plan(model), ALL)
    assert plan is not None
    text, stem = emit(plan, shape="unrolled")[f"{stem_of(plan)}.cpp"], stem_of(plan)
    assert "sweep_rows<" in text
    (state,) = random_states(model, 1, seed=2).each
    slide = next(joint.q for joint in plan.joints if joint.kind == "prismatic")
    bounds, qdd = [], np.zeros(model.nv)
    with loaded(text, stem, plan, quick) as call:
        for row, k in ((0, None), (0, slide), (0, None), (2, model.ntau - 1), (0, None)):
            given = [x.copy() for x in state]
            if k is not None:
                given[row][k] = np.nan
            failed = call("solve", ctypes.c_int, *given, qdd)
            assert bool(failed) == (k is not None)
            bounds.append(call("error_bound", ctypes.c_double))
    assert bounds[0] == bounds[2] == bounds[4] < 1e-12


def test_what_a_loop_takes() -> None:
    """All rows of hinges and slides that nothing else hangs on."""
    for name, model in TREES.items():
        plan = certified_plan(model)
        swept = _swept(looped(plan, ALL))
        found = {j for row in swept.rows for j in row.joints if j is not None}
        kinds = {plan.joints[j].kind for j in found}
        assert swept.slides == ("prismatic" in kinds)
        assert swept.rotors == any(plan.joints[j].rotor_inertia for j in found)
        for j, joint in enumerate(plan.joints):
            beyond = {j, *(k for k in range(len(plan.joints)) if _hangs_on(plan, k, j + 1))}
            able = {plan.joints[k].kind for k in beyond} <= {"revolute", "prismatic"}
            assert (j in found) == able, (name, joint.name)


def _hangs_on(plan: Plan, j: int, link: int) -> bool:
    """Whether a joint is somewhere beyond a link."""
    while j >= 0 and plan.joints[j].parent != link:
        j = plan.joints[j].parent - 1
    return j >= 0


def test_a_robot_without_hinges_and_slides_has_none() -> None:
    assert looped(certified_plan(_tree(1, SPHERICAL, floating=True)), ALL) is None


# -- masses that are set ---------------------------------------------------------------------------


def _reloaded(model: Model, link: str, mass: float, center: Array) -> Model:
    """The robot of which a link has another mass and centre of mass."""
    links = [
        replace(each, inertia=Inertia(mass, center, each.inertia.tensor))
        if each.name == link
        else each
        for each in model.links
    ]
    return replace(model, links=tuple(links))


def _settable(name: str) -> tuple[Model, list[str]]:
    """A robot, and links whose masses are set: beyond the outermost joints and further in."""
    if name == "arms":
        model = _arms("_1", floating=True)
        joints = ["a00_2", "a03_1"]
    elif name == "tree":
        model, joints = _driven(_tree(3, *SLIDES, floating=False)), ["j8", "j2"]
    else:
        model, joints = _driven(looped_tree("revolute", 1, floating=True)), ["j7", "j3"]
    numbers = {joint.name: j + 1 for j, joint in enumerate(model.joints)}
    return model, [model.links[numbers[joint]].name for joint in joints]


@pytest.mark.parametrize("name", spread(["arms", "tree", "loops"], 1))
def test_masses_that_are_set_have_their_bounds(name: str, quick: Toolchain) -> None:
    """Three times as heavy as what the loop would know of them, and off their places."""
    model, links = _settable(name)
    words = ",".join(f"mass:{link},center:{link}" for link in links)
    heavy, center = model, np.array([0.05, -0.02, 0.1])
    masses = {link.name: 3 * float(link.inertia.mass) + 0.5 for link in model.links}
    for link in links:
        heavy = _reloaded(heavy, link, masses[link], center)
    states = (worst_states if model.closed else random_states)(heavy, 8, seed=5)
    truth = None if model.closed else truth_of(heavy, states)
    expected = bounded(heavy, states, [LINE], quick, None if truth is None else list(truth))[LINE]
    assert (expected.ratios <= 1).all() and expected.refused == 0
    plan = certified(plan_of(model, 1, runtime=words))
    found = {}
    for rows in (0, 2, ALL):
        each = looped(plan, rows) if rows else plan
        assert each is not None and (not rows or _swept(each).count)
        found[rows] = _set_and_solved(each, links, masses, center, states, quick)
    answers, bounds = found[0]
    np.testing.assert_allclose(bounds, expected.bounds, rtol=0.3)
    for rows in (2, ALL):
        np.testing.assert_allclose(found[rows][0], answers, rtol=1e-9)
        np.testing.assert_allclose(found[rows][1], bounds, rtol=0.3)
    if truth is not None:
        chains = (WideLinks(plan_of(heavy, 1), q, v, np.longdouble) for q, v, _ in states.each)
        for chain, answer, true, bound in zip(chains, answers, truth, bounds, strict=True):
            error = chain.energy(answer.astype(np.longdouble) - true) / chain.energy(true)
            assert float(np.sqrt(error)) <= bound


def _set_and_solved(
    plan: Plan,
    links: list[str],
    masses: dict[str, float],
    center: Array,
    states: States,
    quick: Toolchain,
) -> tuple[Array, Array]:
    """Accelerations and bounds of an emitted solver of which masses and centres are set."""
    stem = stem_of(plan)
    files = emit(plan, shape="unrolled")
    answers, bounds = np.zeros((states.count, plan.nv)), np.zeros(states.count)
    numbers = dict(re.findall(r"_LINK_(\w+) = (\d+)", files[f"{stem}.h"]))
    with loaded(files[f"{stem}.cpp"], stem, plan, quick) as call:
        for link in links:
            mass = ctypes.c_double(masses[link])
            assert call("set_mass", ctypes.c_int, int(numbers[link]), mass) == 0
            assert call("set_center", ctypes.c_int, int(numbers[link]), center) == 0
        for k, state in enumerate(states.each):
            given = (x.copy() for x in state)
            assert call("solve", ctypes.c_int, *given, answers[k]) == 0
            bounds[k] = call("error_bound", ctypes.c_double)
    return answers, bounds
