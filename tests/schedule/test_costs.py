"""Profiles with costs of steps: what is said of a wrong file, and what a right one means."""

from __future__ import annotations

from pathlib import Path

import pytest

from adagen.calibrate import profile_text
from adagen.errors import InputError
from adagen.schedule import load_profile, parse_profile
from adagen.schedule.costs import NAMES, PER_KIND, StepCosts
from tests.cost.costs import MESSAGE, WINDOW, step_costs, step_profile

GOOD = profile_text(step_profile((1.0, 0.5)), "for tests")


def test_the_shipped_profile_prices_every_step() -> None:
    steps = load_profile("default").steps
    assert steps is not None and set(steps.table) == set(NAMES)
    assert steps["join.revolute"] > steps["disassemble.revolute"] > 0
    assert 0.01 < steps.window.latency < steps.message.latency < 2
    assert load_profile("paper").steps is None
    assert load_profile("default").joins_only().steps is None


def line_of(text: str, start: str) -> int:
    """Return the first line that begins so."""
    return next(n for n, line in enumerate(text.splitlines(), 1) if line.startswith(start))


@pytest.mark.parametrize(
    ("table", "old", "new", "message"),
    [
        ("[steps.join]", "block", "block = -1", "steps.join.block must be a number from 0"),
        ("[steps.join]", "block", "block = nan", "steps.join.block must be a number from 0"),
        ("[steps.join]", "block", "block = 1e9", "steps.join.block must be a number from 0"),
        ("[steps.join]", "block", "block = true", "steps.join.block must be a number of micro"),
        ("[steps.join]", "block", 'block = "1"', "steps.join.block must be a number of micro"),
        ("[steps.join]", "block", "blocks = 1", "unknown key 'steps.join.blocks'"),
        ("[steps.deliver]", "revolute", "", "steps.deliver.revolute is missing"),
        ("[steps.accelerate]", "[", "[steps.accelerated]", "unknown key 'steps.accelerated'"),
        ("[channel.window]", "latency", "latency = -2", "channel.window.latency must be"),
        ("[channel.message]", "[", "[channel.pigeon]", "unknown key 'channel.pigeon'"),
        ("name", "cores", "cores = 3", "cores must be a list"),
        ("name", "cores", "cores = [0]", "cores must be a list of speeds from 0.01"),
        ("name", "cores", 'cores = ["a"]', "cores must be a list of speeds from 0.01"),
    ],
)
def test_a_wrong_table_is_refused_with_its_line(
    table: str, old: str, new: str, message: str, tmp_path: Path
) -> None:
    lines = GOOD.splitlines()
    first = line_of(GOOD, table) - 1
    at = next(n for n in range(first, len(lines)) if lines[n].startswith(old))
    lines[at] = new
    file = tmp_path / "x.toml"
    file.write_text("\n".join(lines) + "\n")
    with pytest.raises(InputError) as caught:
        load_profile(str(file))
    assert message in caught.value.message
    assert caught.value.line == (at + 1 if new else None)


def test_channels_need_steps() -> None:
    start = GOOD[: GOOD.index("# What the steps")]
    assert parse_profile(start.replace("cores", "# cores"), "x").steps is None
    with pytest.raises(InputError, match="cores without the tables"):
        parse_profile(start, "x")
    with pytest.raises(InputError, match=r"\[channel\] is missing|table \[channel\]"):
        parse_profile(GOOD[: GOOD.index("[channel.window]")], "x")


def test_costs_made_in_python_are_checked_too() -> None:
    good = step_costs()
    table = dict(good.table)
    for name, value in (("join.block", -1.0), ("join.block", float("inf")), ("nose", 1.0)):
        with pytest.raises(ValueError, match=name):
            StepCosts({**table, name: value}, WINDOW, MESSAGE)
    del table["join.block"]
    with pytest.raises(ValueError, match=r"join\.block is missing"):
        StepCosts(table, WINDOW, MESSAGE)
    with pytest.raises(ValueError, match="speeds"):
        StepCosts(good.table, WINDOW, MESSAGE, (0.0,))


def test_cores_beyond_those_listed_have_speed_1() -> None:
    costs = step_costs((0.5,))
    assert [costs.speed(p) for p in range(3)] == [0.5, 1.0, 1.0]
    assert costs.channel("auto") == costs.channel("window") == WINDOW
    assert costs.channel("message") == MESSAGE


def test_a_profile_may_leave_out_how_joins_that_follow_each_other_are_priced() -> None:
    """They take what others do then."""
    first = GOOD.index("[steps.join_repeated]")
    short = GOOD[:first] + GOOD[GOOD.index("[steps.disassemble]") :]
    costs, whole = parse_profile(short, "x").measured, parse_profile(GOOD, "x").measured
    for key in PER_KIND["join"]:
        assert costs[f"join_repeated.{key}"] == costs[f"join.{key}"] == whole[f"join.{key}"]
        assert whole[f"join_repeated.{key}"] != whole[f"join.{key}"]
    with pytest.raises(InputError, match=r"steps\.join_repeated\.block is missing"):
        parse_profile(GOOD[:first] + GOOD[first:].replace("block", "# block", 1), "x")
