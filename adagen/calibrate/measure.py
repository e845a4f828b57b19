"""Times of emitted programs, stage by stage."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

from adagen.build import Toolchain, build_executable, find_toolchain
from adagen.emit import emit, stem_of
from adagen.emit.shapes import chosen_shape
from adagen.errors import EnvironmentFault
from adagen.executor import Grouping
from adagen.plan import Plan
from adagen.run import fresh_copy, launch
from adagen.schedule import CostProfile

TIMEOUT = 120.0
"""Seconds after which a run that should take a few is given up."""


@dataclass(frozen=True)
class StageTime:
    """One stage of one process; microseconds.

    Attributes:
        process: which process.
        what: kinematics, assembly, disassembly, slaved, send or receive.
        message: number of the message of a send or receive; None for work.
        start: from when the first process began.
        length: without the look at the clock.
    """

    process: int
    what: str
    message: int | None
    start: float
    length: float


@dataclass(frozen=True)
class Measurement:
    """What was measured of one emitted program; microseconds.

    Attributes:
        time: an evaluation, state and result in place, on average over the middle half of all.
        best: the fastest evaluation seen.
        stages: in the order of ``adagen.plan.stages.stages``, process by process.
        channel: window, message or none.
        pinned: whether each process had a core of its own.
        source: of the first two: "clock", or "stretches" of computing, played through, where there
            are more processes than cores.
    """

    time: float
    best: float
    stages: tuple[StageTime, ...]
    channel: str
    pinned: bool
    source: str = "clock"

    def of(self, process: int) -> tuple[StageTime, ...]:
        """Return the stages of one process."""
        return tuple(stage for stage in self.stages if stage.process == process)


class Built:
    """A plan, emitted and built, that can be timed any number of times.

    Args:
        plan: what to emit.
        toolchain: what to build and run it with.
        shape: of the code.
        profile: chooses shape, limbs side by side and methods; the shipped one if not given.
        limbs: those that each process takes side by side; None for those of least price.
        batch: whether each lane holds a state; its stages are not timed.

    Raises:
        EnvironmentFault: the compiler failed.
        UsageError: the plan cannot be emitted in this shape.
    """

    def __init__(
        self,
        plan: Plan,
        toolchain: Toolchain,
        shape: str = "auto",
        profile: CostProfile | None = None,
        limbs: Grouping | None = None,
        *,
        batch: bool = False,
    ) -> None:
        self.plan = plan
        self.toolchain = toolchain
        self.shape = chosen_shape(plan, shape, profile=profile, batch=batch)
        self.batch = batch
        stem = stem_of(plan)
        files = emit(plan, shape=self.shape, profile=profile, limbs=limbs, batch=int(batch))
        text = files[f"{stem}.cpp"]
        self.executable = build_executable(text, stem, toolchain)

    def measure(
        self, *, repeat: int = 30, channel: str = "auto", arguments: Sequence[str] = ()
    ) -> Measurement:
        """Time it once.

        Args:
            repeat: evaluations of each of 64 random states.
            channel: how processes exchange.
            arguments: more words for the program.

        Raises:
            EnvironmentFault: it failed, or the time is up.
        """
        if self.batch:
            return timed_batch(self.executable, self.toolchain)
        count = len(self.plan.processes)
        words = ["--channel", channel, *arguments]
        return timed(self.executable, count, self.toolchain, repeat=repeat, arguments=words)


def timed(
    executable: Path,
    processes: int,
    toolchain: Toolchain,
    *,
    repeat: int,
    arguments: Sequence[str] = (),
) -> Measurement:
    """Time an emitted program once.

    Args:
        executable: the program.
        processes: how many run it.
        toolchain: what to run it with.
        repeat: evaluations of each of 64 random states.
        arguments: more words for it.

    Raises:
        EnvironmentFault: it failed, or the time is up.
    """
    with fresh_copy(executable) as copy:
        trace = copy.with_name("trace.json")
        words = ["--time", "--json", "--repeat", str(repeat), "--trace", str(trace), *arguments]
        done = launch(copy, processes, words, toolchain, TIMEOUT)
        if done.status != 0:
            raise EnvironmentFault(f"{executable.name} cannot be timed: {done.stderr}")
        report = json.loads(done.stdout)
        return _measurement(report, json.loads(trace.read_text(encoding="utf-8")))


def timed_batch(executable: Path, toolchain: Toolchain) -> Measurement:
    """Time an emitted program of batches once: each of its states, on one process.

    Raises:
        EnvironmentFault: it failed, or the time is up.
    """
    with fresh_copy(executable) as copy:
        done = launch(copy, 1, ["--time", "--json"], toolchain, TIMEOUT)
        if done.status != 0:
            raise EnvironmentFault(f"{executable.name} cannot be timed: {done.stderr}")
        times = json.loads(done.stdout)["time"]
        state, least = (float(times["in_place"][key]) / 1e3 for key in ("middle_ns", "min_ns"))
        least = min(least, state)  # told in whole nanoseconds, middle times in tenths
        return Measurement(state, least, (), "none", bool(times["pinned"]), str(times["source"]))


def _measurement(report: dict[str, Any], trace: dict[str, Any]) -> Measurement:
    clock = float(trace["clock_ns"])
    stages = tuple(
        StageTime(
            int(row["process"]),
            str(row["what"]),
            row["message"],
            float(row["start_ns"]) / 1e3,
            max(0.0, float(row["length_ns"]) - clock) / 1e3,
        )
        for row in trace["stages"]
    )
    times = report["time"]["in_place"]
    return Measurement(
        float(times["middle_ns"]) / 1e3,
        float(times["min_ns"]) / 1e3,
        stages,
        str(trace["channel"]),
        bool(report["time"]["pinned"]),
        str(report["time"]["source"]),
    )


def combined(measurements: Sequence[Measurement]) -> Measurement:
    """Return several measurements of one program as one, number by number.

    Other work on the machine only ever adds to a time, so that the least is the truest. But how
    long processes wait for each other differs from run to run, and whoever calls them gets any of
    these times: of several processes, the median of the evaluations counts.
    """
    first = measurements[0]
    several = len({stage.process for stage in first.stages}) > 1
    time = (median if several else min)(m.time for m in measurements)
    stages = tuple(
        StageTime(
            same[0].process,
            same[0].what,
            same[0].message,
            min(stage.start for stage in same),
            min(stage.length for stage in same),
        )
        for same in zip(*(m.stages for m in measurements), strict=True)
    )
    return Measurement(
        time,
        min(m.best for m in measurements),
        stages,
        first.channel,
        all(m.pinned for m in measurements),
        first.source,
    )


def least_times(plans: Sequence[Plan]) -> list[float]:
    """Build plans and return the least time of each of a few rounds, timed in turns, us.

    Raises:
        EnvironmentFault: one cannot be built and run.
    """
    toolchain = find_toolchain()
    programs = [Built(plan, toolchain) for plan in plans]
    rounds = [[program.measure(repeat=20).time for program in programs] for _ in range(5)]
    return [min(times) for times in zip(*rounds, strict=True)]
