"""Time stamps between the stages of a process, as tables and lines of C++."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from adagen.plan.stages import stages
from adagen.plan.types import Process
from adagen.program import Operation

_WIDTH = 100  # of lines of stages


def stage_lines(process: Process) -> list[str]:
    """Return the stages for the template, a few on a line; -1 stands for none."""
    lines = [""]
    for stage in stages(process):
        numbers = (-1 if number is None else number for number in (stage.joint, stage.message))
        entry = f'{{"{stage.what}", {", ".join(map(str, numbers))}}}, '
        if len(lines[-1]) + len(entry) > _WIDTH:
            lines.append("")
        lines[-1] += entry
    lines[-1] = lines[-1].removesuffix(", ")
    return [line.rstrip() for line in lines if line]


def stamped(
    process: Process,
    operations: Sequence[Operation],
    lines_of: Callable[[Operation], list[str]],
) -> list[str]:
    """Return the lines of all operations with a time stamp after each stage."""
    lines: list[str] = []
    place = 0
    for number in range(len(stages(process))):
        while place < len(operations) and operations[place].stage == number:
            lines += lines_of(operations[place])
            place += 1
        lines.append(f"stamp({number + 1});")
    return lines
