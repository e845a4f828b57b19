"""Straight lines of processes that stay as they are when the limbs of others change."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import pytest

from adagen.executor.lanes import Grouping
from adagen.executor.run import Lines, Simulated
from adagen.executor.straight import groupings
from adagen.plan import Plan
from tests.executor.plans import CASES


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

    known = lines._known[p, ()]
    assert known.heard
    lines._known[p, ()] = replace(known, heard=dict.fromkeys(known.heard))
    after = lines.in_lanes(together)
    assert after[p] is not before[p]
    assert contents(after) == contents(Lines(plan, None).in_lanes(together))
