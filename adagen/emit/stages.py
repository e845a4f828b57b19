"""The stages between which a process's time is stamped, as rows and lines of C++."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from adagen.plan.stages import stages
from adagen.plan.types import Process
from adagen.program import Operation


def stage_rows(process: Process) -> list[dict[str, object]]:
    """Return what the template says of each stage; -1 stands for none."""
    return [
        {
            "what": stage.what,
            "joint": -1 if stage.joint is None else stage.joint,
            "message": -1 if stage.message is None else stage.message,
        }
        for stage in stages(process)
    ]


def stamped(
    process: Process,
    operations: Sequence[Operation],
    lines_of: Callable[[Operation], list[str]],
) -> list[str]:
    """Return the lines of all operations with a time stamp at the start and after each stage."""
    lines = ["stamp(0);"] if process.steps else []
    place = 0
    for number in range(len(stages(process))):
        while place < len(operations) and operations[place].stage == number:
            lines += lines_of(operations[place])
            place += 1
        lines.append(f"stamp({number + 1});")
    return lines
