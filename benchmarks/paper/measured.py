"""Times on this machine: emitted programs of form ada, one run of each by turns."""

from __future__ import annotations

import json
import os
import platform
import statistics
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from adagen.build import Toolchain, build_executable, find_toolchain
from adagen.emit import emit, stem_of
from adagen.model import Model
from adagen.plan import make_plan
from adagen.run import launch
from adagen.schedule import Schedule
from adagen.urdf import read_robot

TIMEOUT = 300.0


@dataclass(frozen=True)
class Program:
    """A built solver."""

    executable: Path
    processes: int
    toolchain: Toolchain


@dataclass(frozen=True)
class Times:
    """Microseconds of one evaluation over all runs: median of their medians, least of all.

    Attributes:
        median: median of the runs' medians.
        least: the fastest evaluation.
        played: whether they are not the clock's but from measured stretches of computing, as with
            more processes than cores.
    """

    median: float
    least: float
    played: bool


def model_of(text: str) -> Model:
    """Return the robot that a URDF text describes."""
    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        path = Path(folder, "robot.urdf")
        path.write_text(text, encoding="utf-8")
        return read_robot(path).model


def build(model: Model, schedule: Schedule) -> Program:
    """Return the program of form ada for a schedule, compiled or found in the cache."""
    plan = make_plan(model, schedule, form="ada")
    name = stem_of(plan, None)
    toolchain = find_toolchain()
    source = emit(plan)[f"{name}.cpp"]
    return Program(build_executable(source, name, toolchain), schedule.processes, toolchain)


def measure(programs: Sequence[Program], rounds: int = 5, repeat: int = 20) -> list[Times]:
    """Return the times of programs, run by turns so that a noisy minute hits all alike."""
    found: list[list[Times]] = [[] for _ in programs]
    for _ in range(rounds):
        for times, program in zip(found, programs, strict=True):
            times.append(_run(program, repeat))
    return [
        Times(
            statistics.median(t.median for t in times), min(t.least for t in times), times[0].played
        )
        for times in found
    ]


def _run(program: Program, repeat: int) -> Times:
    words = ["--time", "--json", "--repeat", str(repeat)]
    done = launch(program.executable, program.processes, words, program.toolchain, TIMEOUT)
    if done.status != 0:
        raise SystemExit(f"error: {program.executable.name}: {done.stderr}")
    record = json.loads(done.stdout)["time"]
    times = record["in_place"]
    played = record["source"] == "stretches"
    return Times(float(times["median_ns"]) / 1e3, float(times["min_ns"]) / 1e3, played)


def machine() -> str:
    """Return in a few words what this machine is."""
    name = platform.processor() or platform.machine()
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                name = line.split(":", 1)[1].strip()
                break
    except OSError:
        pass
    return f"{name}, {len(os.sched_getaffinity(0))} cores"
