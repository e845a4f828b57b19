"""The stages between which a process's time is stamped, as rows and lines of C++."""

from __future__ import annotations

from collections.abc import Callable

from adagen.plan.stages import stages
from adagen.plan.steps import Step
from adagen.plan.types import Process


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


def stamped_lines(process: Process, lines_of: Callable[[Step], list[str]]) -> list[str]:
    """Return the lines of all steps with a time stamp at the start and after each stage."""
    lines = ["stamp(0);"] if process.steps else []
    for k, stage in enumerate(stages(process), start=1):
        for step in process.steps[stage.first : stage.last]:
            lines += lines_of(step)
        lines.append(f"stamp({k});")
    return lines
