"""A whole calibration: build, time in turn, fit."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import contextmanager
from dataclasses import dataclass, replace
from statistics import median

from adagen.build import Toolchain
from adagen.calibrate.fit import (
    Sample,
    evaluation_cost,
    fit_channel,
    fit_steps,
    relative_errors,
)
from adagen.calibrate.measure import Measurement, Program, least
from adagen.calibrate.samples import calibration_plans
from adagen.calibrate.surrogate import fit_equation11
from adagen.plan import Plan
from adagen.predict import predict
from adagen.schedule import CostProfile, load_profile
from adagen.schedule.costs import ChannelCosts, StepCosts

Progress = Callable[[str, int, int], None]
"""Called with what is being done, how many parts of the work are done, and of how many."""

_ROUNDS = 6
_REPEAT = 25
_MOST_CORES = 8  # whose speed is compared
_ALIKE = 0.9  # cores that differ by less are taken to be equally fast: the rest is noise


@dataclass(frozen=True)
class Calibration:
    """What was measured and how well the profile tells it.

    Attributes:
        profile: the fitted profile.
        errors: relative errors of the stages of work, by sort of work.
        totals: label, measured and predicted time of each program in microseconds.
        pinned: whether every process had a core of its own.
        messages_measured: whether there were two cores to exchange messages between; else the
            costs of messages are the default profile's.
    """

    profile: CostProfile
    errors: dict[str, list[float]]
    totals: list[tuple[str, float, float]]
    pinned: bool
    messages_measured: bool


def calibrate(
    name: str, toolchain: Toolchain, *, quick: bool = False, progress: Progress | None = None
) -> Calibration:
    """Measure this machine.

    Args:
        name: of the profile.
        toolchain: what to build and run with.
        quick: half the programs and rounds.
        progress: see there.

    Raises:
        EnvironmentFault: a program cannot be built or run.
    """
    default = load_profile("default")
    plans = calibration_plans(default, quick)
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 1
    if cores < 2:
        plans = [(label, plan) for label, plan in plans if len(plan.processes) == 1]
    rounds = 2 if quick else _ROUNDS
    steps = _Steps(len(plans) + rounds + 2, progress)
    programs = _built([plan for _, plan in plans], toolchain, min(cores, 4), steps)
    samples = _measured(programs, rounds, steps)
    message = _over_messages(programs, 1 if quick else 2) if cores > 1 else []
    steps.done("timing messages")
    speeds = _speeds(programs, cores) if cores <= _MOST_CORES else ()
    steps.done("comparing cores")
    free = [sample for sample in samples if not sample.plan.slaved]
    costs = _costs(free, message, default, speeds)
    costs = _with_slaved(costs, [sample for sample in samples if sample.plan.slaved])
    profile = replace(fit_equation11(name, costs), steps=costs)
    totals = [
        (label, sample.measured.time, predict(sample.plan, profile).makespan)
        for (label, _), sample in zip(plans, samples, strict=True)
    ]
    return Calibration(
        profile,
        relative_errors(free, costs),
        totals,
        all(sample.measured.pinned for sample in samples),
        bool(message),
    )


class _Steps:
    def __init__(self, total: int, progress: Progress | None) -> None:
        self._total, self._done, self._progress = total, 0, progress

    def done(self, what: str) -> None:
        self._done += 1
        if self._progress is not None:
            self._progress(what, self._done, self._total)


def _built(
    plans: Sequence[Plan], toolchain: Toolchain, workers: int, steps: _Steps
) -> list[Program]:
    with ThreadPoolExecutor(workers) as pool:
        futures = [pool.submit(Program, plan, toolchain) for plan in plans]
        try:
            for future in as_completed(futures):
                future.result()
                steps.done("compiling")
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
        return [future.result() for future in futures]


def _measured(programs: Sequence[Program], rounds: int, steps: _Steps) -> list[Sample]:
    """Time all programs in turn, several times over."""
    found: list[list[Measurement]] = [[] for _ in programs]
    for _ in range(rounds):
        for program, times in zip(programs, found, strict=True):
            times.append(program.measure(repeat=_REPEAT))
        steps.done("timing")
    return [Sample(p.plan, least(times)) for p, times in zip(programs, found, strict=True)]


def _over_messages(programs: Sequence[Program], rounds: int) -> list[Sample]:
    """Time what programs on two processes take over MPI messages."""
    pairs = [p for p in programs if len(p.plan.processes) == 2][:4]
    return [
        Sample(p.plan, least([p.measure(repeat=_REPEAT, channel="message") for _ in range(rounds)]))
        for p in pairs
    ]


def _costs(
    samples: Sequence[Sample],
    message: Sequence[Sample],
    default: CostProfile,
    speeds: tuple[float, ...],
) -> StepCosts:
    table = fit_steps(samples)
    table["process.evaluation"] = evaluation_cost(samples)
    window = [s for s in samples if s.measured.channel == "window"]
    channels: list[ChannelCosts] = []
    for channel, known in (("window", window), ("message", message)):
        if known:
            channels.append(fit_channel(known))
        else:
            assert default.steps is not None  # the shipped profile has been measured
            channels.append(default.steps.channel(channel))
    return StepCosts(table, channels[0], channels[1], speeds)


def _with_slaved(costs: StepCosts, samples: Sequence[Sample]) -> StepCosts:
    """Return the costs with those of slaved joints, from what is left of a slaved robot's times."""
    shares, solve = [], []
    for sample in samples:
        equations = sample.equations()
        expected = sum(equation.predicted(costs) for equation in equations)
        extra = sum(equation.time for equation in equations) / expected - 1
        shares.append(max(0.0, extra / len(sample.plan.slaved)))
        solve += [stage.length for stage in sample.measured.stages if stage.what == "slaved"]
    share = median(shares) if shares else 0.0
    # Solving and applying are one stage on one process: halves of it.
    each = median(solve) / 2 / (1 + 2 * share) if solve else 0.0
    table = {**costs.table, "slaved.column": share, "slaved.solve": each, "slaved.apply": each}
    return replace(costs, table=table)


def _speeds(programs: Sequence[Program], cores: int) -> tuple[float, ...]:
    """Return the speed of each core relative to the fastest; () if they are alike."""
    alone = [p for p in programs if len(p.plan.processes) == 1]
    if cores < 2 or not alone or not hasattr(os, "sched_setaffinity"):
        return ()
    cpus = sorted(os.sched_getaffinity(0))
    best = [float("inf")] * len(cpus)
    for _ in range(3):
        for k, cpu in enumerate(cpus):
            with _confined_to(cpu):
                best[k] = min(best[k], alone[0].measure(repeat=_REPEAT).best)
    speeds = tuple(round(min(best) / time, 2) for time in best)
    return () if min(speeds) >= _ALIKE else speeds


@contextmanager
def _confined_to(cpu: int) -> Iterator[None]:
    """Let what is started run on one core alone."""
    before = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {cpu})
    try:
        yield
    finally:
        os.sched_setaffinity(0, before)
