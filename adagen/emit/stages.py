"""The stages between which a process's time is stamped, as rows and lines of C++."""

from __future__ import annotations

from collections.abc import Callable, Sequence

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


def stamped_groups(process: Process, lines_of: Callable[[Sequence[Step]], list[str]]) -> list[str]:
    """Return the lines of all stages, given a stage's steps at once, with time stamps around."""
    lines = ["stamp(0);"] if process.steps else []
    for k, stage in enumerate(stages(process), start=1):
        lines += lines_of(process.steps[stage.first : stage.last])
        lines.append(f"stamp({k});")
    return lines


def stamped_lines(process: Process, lines_of: Callable[[Step], list[str]]) -> list[str]:
    """Return the lines of all steps with a time stamp at the start and after each stage."""
    return stamped_groups(process, lambda steps: [line for s in steps for line in lines_of(s)])
