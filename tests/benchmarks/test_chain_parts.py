"""Parts of a chain's time: told by stages, and what sharing it could save at most."""

from __future__ import annotations

import pytest

from benchmarks.chain_parts import (
    CUT,
    EXCHANGE,
    INWARDS,
    KINDS,
    KINEMATICS,
    OUTWARDS,
    PASSAGE,
    Parts,
    tables,
    times_of,
)


def rows(*stages: tuple[str, float]) -> list[dict[str, object]]:
    return [{"what": what, "length_ns": length} for what, length in stages]


def test_stages_are_told_apart_by_what_came_before() -> None:
    shared = rows(
        ("kinematics", 520.0),
        ("send", 40.0),
        ("kinematics", 520.0),
        ("assembly", 1520.0),
        ("send", 40.0),
        ("receive", 120.0),
        ("assembly", 120.0),
        ("disassembly", 10.0),  # less than a look at the clock
    )
    found = times_of(shared, 20.0)
    wanted = {KINEMATICS: 1.0, PASSAGE: 0.02, INWARDS: 1.5, EXCHANGE: 0.12, CUT: 0.1, OUTWARDS: 0.0}
    assert found == pytest.approx(wanted) and tuple(found) == KINDS


def test_limits_add_one_cost_after_the_other() -> None:
    alone = {KINEMATICS: 1.5, INWARDS: 2.0, OUTWARDS: 0.5}
    ground = {KINEMATICS: 1.0, PASSAGE: 0.1, INWARDS: 1.4, EXCHANGE: 0.3, CUT: 0.1, OUTWARDS: 0.3}
    beyond = ground | {PASSAGE: 0.3, INWARDS: 1.3, EXCHANGE: 0.1}
    parts = Parts(200, alone, (ground, beyond), once=1.0)
    assert list(parts.limits.values()) == pytest.approx([2.0, 2.5, 2.6, 2.8, 3.2])
    text = tables([parts])
    assert "| 200 | all | 4.00 | 3.20 | 3.10 |" in text
    assert "| 200 | as they are | 3.20 | 20% |" in text
