"""Straight lines of processes that stay as they are when the limbs of others change."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np
import pytest

from adagen.executor import run
from adagen.executor.lanes import Grouping
from adagen.executor.run import Lines, Simulated, lines_of
from adagen.executor.straight import groupings
from adagen.model import Model
from adagen.plan import Plan, can_gather, make_plan
from tests.executor.plans import CASES
from tests.models import human_figure, random_tree, star
from tests.scene.effects import with_effects, with_wrenches
from tests.schedules import random_schedule
from tests.slow import all_but


def mixed_groupings(plan: Plan) -> list[Grouping]:
    """Return groupings of a plan, and some in which each process has that of another one."""
    offers = groupings(plan)
    own = [list(dict.fromkeys(offer[p] for offer in offers)) for p in range(len(plan.processes))]
    return list(dict.fromkeys([*offers, *product(*own)]))[:10]


def contents(lines: Sequence[Simulated]) -> list[object]:
    """Return all that processes' lines consist of."""
    return [
        (one.machine.graph.nodes, one.ends, one.operations, one.machine.sent.keys())
        for one in lines
    ]


@pytest.mark.parametrize("name", [name for name, case in CASES.items() if case.processes > 1])
def test_known_lines_are_those_that_would_be_made(name: str) -> None:
    plan = CASES[name].plan("double")
    lines = Lines(plan, None)
    for grouping in mixed_groupings(plan):
        fresh = Lines(plan, None).in_lanes(grouping)
        assert contents(lines.in_lanes(grouping)) == contents(fresh)


def test_a_process_keeps_its_line_while_limbs_of_others_change() -> None:
    plan = CASES["gathered by four"].plan("double")
    alone, together = groupings(plan)[:2]
    lines = Lines(plan, None)
    before, after = lines.in_lanes(alone), lines.in_lanes(together)
    kept = [p for p in range(4) if before[p] is after[p]]
    assert kept == [p for p in range(4) if alone[p] == together[p]]
    assert 0 < len(kept) < 4


def test_a_line_is_made_anew_where_its_constants_or_messages_are_others() -> None:
    plan = CASES["gathered by four"].plan("double")
    alone, together = groupings(plan)[:2]
    lines = Lines(plan, None)
    before = lines.in_lanes(alone)
    p = next(p for p in range(4) if alone[p] == together[p] and plan.processes[p].owns)
    joints = list(plan.joints)
    j = plan.processes[p].owns[0]
    joints[j] = replace(joints[j], translation=(1.0, 2.0, 3.0))
    assert lines._alike(p, (), plan) is not None
    assert lines._alike(p, (), replace(plan, joints=tuple(joints))) is None

    made = lines._made(p, ())
    known = lines._known[made]
    assert known.heard
    lines._known[made] = replace(known, heard=dict.fromkeys(known.heard))
    after = lines.in_lanes(together)
    assert after[p] is not before[p]
    assert contents(after) == contents(Lines(plan, None).in_lanes(together))


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


@pytest.mark.parametrize(
    "seed", all_but(range(9), 3, 4, 5, 6, 7, 8)
)  # robots that others have, too
def test_plans_of_a_robot_share_lines_that_would_be_the_same(seed: int) -> None:
    model, rng = some_robot(seed), np.random.default_rng(seed)
    made, every = set[int](), 0
    for _ in range(8):
        schedule = random_schedule(model, int(rng.integers(1, 5)), rng)
        meeting = "gather" if can_gather(model) and rng.random() < 0.6 else "join"
        plan = make_plan(model, schedule, meeting=meeting)
        for grouping in groupings(plan):
            found = lines_of(plan).in_lanes(grouping)
            assert contents(found) == contents(Lines(plan, None).in_lanes(grouping))
            made.update(id(line) for line in found)
            every += len(found)
    assert len(made) < every


def test_lines_are_forgotten_when_they_are_too_many(monkeypatch: pytest.MonkeyPatch) -> None:
    plan = CASES["gathered by four"].plan("double")
    lines = Lines(plan, None)
    alone, together = groupings(plan)[:2]
    lines.in_lanes(alone)
    monkeypatch.setattr(run, "_MOST", 1)
    lines.in_lanes(together)
    assert len(lines._known) == sum(a != b for a, b in zip(alone, together, strict=True))
