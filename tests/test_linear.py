"""Work grows no faster than the number of joints: lines of code are counted, no clock is read.

How often a line runs tells of loops and of comprehensions; what a single built-in call walks
through (``in`` a list, a slice) does not show.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

import pytest

import adagen
from adagen.cli import main
from tests.cli.robots import write_arm
from tests.slow import slow

ROOT = Path(adagen.__file__).resolve().parents[1]
OURS = (str(ROOT / "adagen"), str(ROOT / "templates"), __file__)
FEW, MANY = 40, 80
"""Joints of the chains."""
MOST_GROWTH = 2.6
"""Twice the joints: twice the runs of a line, and somewhat more where something is sorted."""
OFTEN = 10 * MANY
"""Runs of a line that count: those of a line that is run for each pair of joints are 6,400."""
OTHERS = {("adagen/plan/segment.py", "SegmentPlanner.__init__.<locals>.<genexpr>")}
"""Code that still does more: each node of a schedule lists all joints below it."""

Place = tuple[str, str, int]
"""File, function and line."""


def lines_run(do: Callable[[], object]) -> Counter[Place]:
    """Return how often each line of the project runs while something is done."""
    found: Counter[Place] = Counter()

    def line(frame: FrameType, event: str, _: object) -> Any:
        if event == "line":
            code = frame.f_code
            found[code.co_filename, code.co_qualname, frame.f_lineno] += 1
        return line

    def call(frame: FrameType, _event: str, _: object) -> Any:
        return line if frame.f_code.co_filename.startswith(OURS) else None

    before = sys.gettrace()
    sys.settrace(call)
    try:
        do()
    finally:
        sys.settrace(before)
    return found


def grown(few: Counter[Place], many: Counter[Place]) -> dict[Place, float]:
    """Return by how much lines that run often ran more often than they should."""
    return {
        (str(Path(file).relative_to(ROOT)), function, number): count / max(few[place], 1)
        for place, count in many.items()
        for file, function, number in [place]
        if count > OFTEN and count > MOST_GROWTH * few[place]
    }


@pytest.mark.parametrize(
    "words",
    [
        "ARM --out OUT --procs 1 --shape kernels --parts none",
        slow("ARM --out OUT --procs 2 --shape kernels --schedule middle-out"),
    ],
    ids=["one process", "two processes"],
)
def test_twice_the_joints_are_twice_the_work(tmp_path: Path, words: str) -> None:
    def carried_out(joints: int) -> Counter[Place]:
        arm = write_arm(tmp_path / f"arm{joints}.urdf", joints)
        line = words.replace("ARM", str(arm)).replace("OUT", str(tmp_path / f"out{joints}"))
        status: list[int] = []
        counts = lines_run(lambda: status.append(main(line.split())))
        assert status == [0]
        return counts

    few = carried_out(FEW)
    found = grown(few, carried_out(MANY))
    assert not {place: ratio for place, ratio in found.items() if place[:2] not in OTHERS}


def test_lines_that_run_for_each_pair_of_joints_are_seen() -> None:
    def pairs(joints: int) -> list[int]:
        return [j * k for j in range(joints) for k in range(joints)]

    found = grown(lines_run(lambda: pairs(FEW)), lines_run(lambda: pairs(MANY)))
    assert list(found.values()) == [pytest.approx(4.0, rel=0.05)]
