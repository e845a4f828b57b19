"""Straight lines that are counted among others are those that processes have by themselves."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from adagen.executor import counted as among_others
from adagen.executor.counted import counted, may_share
from adagen.executor.grouping import stretches_of
from adagen.executor.lanes import Grouping
from adagen.executor.run import Lines, Simulated
from adagen.executor.segments import Segments
from adagen.executor.straight import groupings
from adagen.executor.stretches import Stretch, stretches
from adagen.graph import Operations
from adagen.model import Model
from adagen.plan import Plan, can_gather, make_plan
from adagen.plan.steps import Articulate
from tests.executor.plans import CASES
from tests.executor.test_lines import mixed_groupings
from tests.models import human_figure, random_tree, star
from tests.scene.effects import with_effects, with_wrenches
from tests.schedules import random_schedule
from tests.slow import all_but

PLAIN = [name for name, case in CASES.items() if may_share(case.plan("double"))]


@pytest.fixture(autouse=True)
def _nothing_is_known(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(among_others, "_last", among_others._Last())


def counts(plan: Plan, lines: tuple[Simulated, ...]) -> list[tuple[Operations, list[Stretch]]]:
    """Return all that prices depend on."""
    steps = [process.steps for process in plan.processes]
    pairs = zip(lines, steps, strict=True)
    return [(one.operations, stretches(one, own, 2500.0)) for one, own in pairs]


def alike(plan: Plan, grouping: Grouping) -> bool:
    """Compare what is counted with graphs of processes' own; return whether anything is."""
    found = counted(plan, grouping)
    alone = counts(plan, Lines(plan, None).in_lanes(grouping))
    assert found is None or counts(plan, found) == alone
    priced = stretches_of(plan, grouping, 2500.0)
    assert [list(own) for own in priced] == [own for _, own in alone]
    return found is not None


@pytest.mark.parametrize("name", PLAIN)
def test_counts_are_those_of_graphs_of_its_own(name: str) -> None:
    plan = CASES[name].plan("double")
    found = [alike(plan, grouping) for grouping in mixed_groupings(plan)]
    assert any(found)


def some_robot(seed: int) -> Model:
    """Return a robot with branches, and effects at its joints for some."""
    rng = np.random.default_rng(seed)
    match seed % 3:
        case 0:
            return human_figure()
        case 1:
            return star(4, 3, floating=True)
    tree = random_tree(rng, 12, branching=0.4, floating=bool(seed % 2), mimics=seed % 4 == 0)
    return with_wrenches(with_effects(tree, rng, "drp"), rng)


@pytest.mark.parametrize("seed", all_but(range(9), 3, 4, 6, 7))  # robots that others have, too
def test_plans_of_a_robot_do_not_change_the_counts_of_others(seed: int) -> None:
    model, rng = some_robot(seed), np.random.default_rng(seed)
    found = []
    for _ in range(8):
        schedule = random_schedule(model, int(rng.integers(1, 5)), rng)
        meeting = "gather" if can_gather(model) and rng.random() < 0.6 else "join"
        plan = make_plan(model, schedule, meeting=meeting)
        found += [alike(plan, grouping) for grouping in groupings(plan)]
    assert np.mean(found) > 0.5


def test_a_step_is_done_once_for_all_plans(monkeypatch: pytest.MonkeyPatch) -> None:
    model, rng = human_figure(), np.random.default_rng(1)
    plans = [make_plan(model, random_schedule(model, p, rng), meeting="gather") for p in (1, 2, 4)]
    articulate, done = Segments._articulate, list[Any]()

    def noted(self: Segments, step: Articulate) -> None:
        done.append(step)
        articulate(self, step)

    monkeypatch.setattr(Segments, "_articulate", noted)
    for plan in plans:
        counted(plan, groupings(plan)[0])
    once = len(done)
    every = sum(1 for plan in plans for _ in plan.steps_of(Articulate))
    assert 0 < once < 0.8 * every
    counted(plans[0], groupings(plans[0])[0])
    assert len(done) == once


def test_a_large_graph_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    one, other = CASES["alone"].plan("double"), CASES["gathered by four"].plan("double")
    alike(one, groupings(one)[0])
    before = among_others._last.common
    alike(other, groupings(other)[0])
    assert among_others._last.common is before
    monkeypatch.setattr(among_others, "_MOST", 1)
    alike(one, groupings(one)[0])
    assert among_others._last.common is not before
