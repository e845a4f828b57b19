"""Times on this machine: emitted programs of form ada, by turns."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from adagen.build.processor import processor_name
from adagen.model import Model
from adagen.plan import make_plan
from adagen.run import cores
from adagen.schedule import Schedule
from adagen.studies.bench.contest import Contestant, Times
from adagen.urdf import read_robot
from benchmarks.solvers import by_turns, contestant, source_of


def model_of(text: str) -> Model:
    """Return the robot that a URDF text describes."""
    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        path = Path(folder, "robot.urdf")
        path.write_text(text, encoding="utf-8")
        return read_robot(path).model


def build(name: str, model: Model, schedule: Schedule) -> Contestant:
    """Return the program of form ada for a schedule, compiled or found in the cache."""
    plan = make_plan(model, schedule, form="ada")
    return contestant(name, model, plan, source_of(plan))


def measure(programs: Sequence[Contestant], rounds: int = 5, repeat: int = 20) -> list[Times]:
    """Return the times of programs with states and results in place, ns.

    They are not the clock's but from measured stretches of computing where there are more processes
    than cores (`played`).
    """
    found: Mapping[str, Mapping[str, Times]] = by_turns(programs, rounds, repeat)
    return [found[one.name]["stretches" if played(one) else "in_place"] for one in programs]


def played(program: Contestant) -> bool:
    """Whether its times are from stretches: more processes than cores."""
    return program.processes > cores()


def machine() -> str:
    """Return in a few words what this machine is."""
    return f"{processor_name()}, {cores()} cores"
