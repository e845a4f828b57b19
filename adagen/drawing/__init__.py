"""Pictures of programs, schedules and robots as SVG; the same bytes for the same arguments."""

from __future__ import annotations

from adagen.cost import state_time, timeline
from adagen.drawing.program import program_svg
from adagen.drawing.tree import schedule_svg
from adagen.program import Program
from adagen.program.summary import a_state
from adagen.schedule import CostProfile, Schedule, Topology

__all__ = ["draw", "program_svg", "schedule_svg"]


def draw(
    schedule: Schedule, topology: Topology, program: Program, profile: CostProfile, name: str
) -> str:
    """Return the picture of a program; the paper's own where the profile prices joins alone.

    Args:
        schedule: of the robot's joints.
        topology: the robot.
        program: what is emitted of the schedule.
        profile: what it is priced by.
        name: the robot's name.
    """
    if profile.steps is None:
        return schedule_svg(schedule, topology, name)
    line = None if program.batch else timeline(program, profile)
    return program_svg(program, line, schedule, topology, name, _said(program, profile))


def _said(program: Program, profile: CostProfile) -> str:
    time = f"{state_time(program, profile):.3g} µs{a_state(program)} predicted"
    if program.batch:
        how = "each SIMD lane holds a state of a batch; processes share the states"
    else:
        how = f"form {program.plan.form}, shape {program.shape}"
    return f"{time} ({profile.name} profile), {how}"
