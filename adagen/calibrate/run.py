"""A complete calibration: build, time by turns, fit."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import contextmanager
from dataclasses import dataclass, replace
from statistics import median

from adagen.build import Toolchain
from adagen.build.registers import widest_register
from adagen.calibrate.batches import fit_batches
from adagen.calibrate.caches import instruction_cache, second_cache
from adagen.calibrate.channel import (
    Channels,
    MessageTime,
    channel_errors,
    channel_program,
    fit_channel,
    least_times,
    message_times,
    times_between_hosts,
)
from adagen.calibrate.fit import (
    Sample,
    evaluation_cost,
    fit_steps,
    relative_errors,
    rubs,
    with_tangents,
)
from adagen.calibrate.measure import Built, Measurement, combined
from adagen.calibrate.samples import (
    ORDERS,
    Wanted,
    batch_programs,
    in_order,
    stepwise_programs,
    straight_programs,
)
from adagen.calibrate.straight import faster_orders, fit_straight, timed_stretches
from adagen.calibrate.surrogate import fit_equation11
from adagen.cost import state_time, timeline
from adagen.cost.features import operation_features
from adagen.errors import UsageError
from adagen.program.lower import LOOPS
from adagen.program.names import PREPARED
from adagen.schedule import CostProfile, load_profile
from adagen.schedule.costs import ASSUMED, CHANNELS, StepCosts

Progress = Callable[[str, int, int], None]
"""Called with what is being done, how many parts of the work are done, and of how many."""

_ROUNDS = 6
_REPEAT = 25
_MOST_CORES = 8  # whose speed is compared
_COMPARED = 5  # programs, of which the one in the middle counts: any may happen to lie badly
_ALIKE = 0.9  # cores that differ by less count as equally fast: the rest is noise


@dataclass(frozen=True)
class Calibration:
    """The measurements, and how well the profile predicts them.

    Attributes:
        profile: the fitted profile.
        errors: relative errors of the stages of work, by sort of work, and of the messages, by
            channel.
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


@dataclass(frozen=True)
class _Measured:
    """What was measured.

    Attributes:
        labels: of the samples, in order.
        stepwise: of programs that go step by step.
        straight: of straight lines of statements, each in the faster order.
        batches: of batches; times are of one state.
        urgent: values up to which that is by what waits.
        channels: times of messages; None with one core.
        speeds: of the cores; () if they are alike.
        sizes: coefficients that are sizes of caches and registers.
    """

    labels: list[str]
    stepwise: list[Sample]
    straight: list[Sample]
    batches: list[Sample]
    urgent: float
    channels: Channels | None
    speeds: tuple[float, ...]
    sizes: dict[str, float]


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
    found = _measure(default, toolchain, quick, progress)
    usual = [sample for sample in found.stepwise if not sample.plan.slaved]
    free = [sample for sample in usual if not rubs(sample.plan)]
    costs = with_tangents(_costs(free, found, default), usual)
    costs = _with_slaved(costs, [sample for sample in found.stepwise if sample.plan.slaved])
    sent = costs  # as messages by themselves have it
    if found.channels is not None:
        costs = _with_latency_at_work(costs, [*free, *found.straight])
    profile = replace(fit_equation11(name, costs), steps=costs)
    samples = [*found.stepwise, *found.straight, *found.batches]
    totals = [
        (label, sample.measured.time, state_time(sample.program, profile))
        for label, sample in zip(found.labels, samples, strict=True)
    ]
    single = totals[: len(totals) - len(found.batches)]
    profile = replace(profile, steps=_with_margin(costs, single))
    errors = relative_errors(free, costs)
    for channel, times in (found.channels or {}).items():
        errors[f"messages, {channel}"] = channel_errors(times, sent.channel(channel))
    return Calibration(
        profile,
        errors,
        totals,
        all(sample.measured.pinned for sample in found.stepwise),
        found.channels is not None,
    )


def calibrate_network(
    base: CostProfile, toolchain: Toolchain, hosts: tuple[str, str]
) -> tuple[CostProfile, tuple[MessageTime, ...]]:
    """Return a profile with the costs of messages between hosts, and the measurements.

    Args:
        base: the profile that they are added to.
        toolchain: what to build and run with.
        hosts: two, by the names that mpiexec reaches them by.

    Raises:
        EnvironmentFault: they cannot be reached, or share memory.
        UsageError: the profile prices joins alone.
    """
    if base.steps is None:
        raise UsageError(f"the profile {base.name} has no costs of steps to add a network's to")
    times = times_between_hosts(toolchain, hosts)
    return replace(base, steps=replace(base.steps, network=fit_channel(times))), times


def _measure(
    profile: CostProfile, toolchain: Toolchain, quick: bool, progress: Progress | None
) -> _Measured:
    """Build all programs and time them in turn, several times over."""
    sizes = _sizes(toolchain)
    chosen, cache = stepwise_programs(profile, quick), sizes["unrolled.cache"]
    straight = [
        each for urgent in ORDERS for each in straight_programs(in_order(profile, urgent, cache))
    ]
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 1
    if cores < 2:
        chosen, straight = (
            [each for each in programs if len(each.plan.processes) == 1]
            for programs in (chosen, straight)
        )
    batches = batch_programs(profile)
    wanted = [*chosen, *straight, *batches]
    rounds = 2 if quick else _ROUNDS
    steps = _Steps(len(wanted) + rounds + 1, progress)
    programs = _built(wanted, toolchain, min(cores, 4), steps)
    channel = channel_program(toolchain) if cores > 1 else None
    found: list[list[Measurement]] = [[] for _ in programs]
    messages: list[Channels] = []
    for _ in range(rounds):
        for program, times in zip(programs, found, strict=True):
            times.append(program.measure(repeat=_REPEAT))
        if channel is not None:
            messages.append(message_times(channel, toolchain))
        steps.done("timing")
    speeds = _speeds(programs, cores) if cores <= _MOST_CORES else ()
    steps.done("comparing cores")
    samples = [
        Sample(each.lowered, combined(times)) for each, times in zip(wanted, found, strict=True)
    ]
    first, end = len(chosen), len(chosen) + len(straight)  # of straight lines
    urgent, lines = faster_orders(samples[first:end])
    return _Measured(
        [each.label for each in (*wanted[: first + len(lines)], *batches)],
        samples[:first],
        lines,
        samples[end:],
        urgent,
        least_times(messages) if messages else None,
        speeds,
        sizes,
    )


def _sizes(toolchain: Toolchain) -> dict[str, float]:
    """The coefficients that are sizes of caches and of the registers that compilers take."""
    told = {"unrolled.cache": instruction_cache(), "process.cache": second_cache()}
    sizes = {name: float(size or ASSUMED[name]) for name, size in told.items()}
    return sizes | {"process.register": float(widest_register(toolchain))}


class _Steps:
    def __init__(self, total: int, progress: Progress | None) -> None:
        self._total, self._done, self._progress = total, 0, progress

    def done(self, what: str) -> None:
        self._done += 1
        if self._progress is not None:
            self._progress(what, self._done, self._total)


def _built(
    wanted: Sequence[Wanted], toolchain: Toolchain, workers: int, steps: _Steps
) -> list[Built]:
    def build(each: Wanted) -> Built:
        return Built(
            each.plan,
            toolchain,
            each.shape,
            profile=each.profile,
            limbs=each.limbs,
            batch=each.batch,
        )

    with ThreadPoolExecutor(workers) as pool:
        futures = [pool.submit(build, each) for each in wanted]
        try:
            for future in as_completed(futures):
                future.result()
                steps.done("compiling")
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
        return [future.result() for future in futures]


def _costs(free: Sequence[Sample], found: _Measured, default: CostProfile) -> StepCosts:
    """Return the costs, but for those of slaved joints."""
    table = fit_steps(free)
    table["process.evaluation"] = evaluation_cost(free)
    table |= fit_straight(timed_stretches(found.straight)) | found.sizes
    table |= fit_batches(found.batches, int(found.sizes["process.register"]))
    table |= {"unrolled.ahead": ASSUMED["unrolled.ahead"], "unrolled.urgent": found.urgent}
    if found.channels is not None:
        window, message = (fit_channel(found.channels[channel]) for channel in CHANNELS)
    else:
        assert default.steps is not None  # the shipped profile has been measured
        window, message = default.steps.window, default.steps.message
    return StepCosts(table, window, message, found.speeds)


def _with_latency_at_work(costs: StepCosts, samples: Sequence[Sample]) -> StepCosts:
    """Return the costs with latencies as programs at work feel them.

    Messages sent to and fro find a receiver that does nothing else; at work, memory is in use for
    other things, and either process may be late. Latencies are raised by what lets the predicted
    times of programs of several processes, which meet in the window, fit best.
    """
    together = [s for s in samples if len(s.plan.processes) > 1 and s.plan.messages]

    def raised(more: float) -> StepCosts:
        window, message = (
            replace(c, latency=c.latency + more) for c in (costs.window, costs.message)
        )
        return replace(costs, window=window, message=message)

    def off(more: float) -> float:
        profile = CostProfile("", 0.0, 0.0, 0.0, 1.0, steps=raised(more))
        times = [(s.measured.time, timeline(s.program, profile).makespan) for s in together]
        return sum(abs(measured - predicted) / measured for measured, predicted in times)

    return raised(min((step / 200 for step in range(61)), key=off))  # by up to 0.3 us


def _with_margin(costs: StepCosts, totals: Sequence[tuple[str, float, float]]) -> StepCosts:
    """Return the costs with the share by which predicted times are off, in the median.

    What is predicted to save less is not known to save anything.
    """
    off = median(abs(predicted / measured - 1) for _, measured, predicted in totals)
    return replace(costs, table={**costs.table, "process.margin": min(off, 1.0)})


def _with_slaved(costs: StepCosts, samples: Sequence[Sample]) -> StepCosts:
    """Return the costs with those of slaved joints, from what is left of slaved robots' times.

    Shape `joints` carries a column more through every step for each of them, loops repeat sweeps.
    """
    shares, solve = [], []
    for sample in samples:
        slaved = len(sample.plan.slaved)
        taken = sum(stage.length for stage in sample.measured.stages if stage.what == "slaved")
        if sample.program.shape == LOOPS:
            repeated = sum(
                costs.total(operation_features(operation, sample.plan.joints))
                for own in sample.program.processes
                for operation in own.operations
                if operation.does not in PREPARED
            )
            solve.append(max(0.0, taken - slaved * repeated))
        else:
            equations = sample.equations()
            expected = sum(equation.predicted(costs) for equation in equations)
            extra = sum(equation.time for equation in equations) / expected - 1
            shares.append(max(0.0, extra / slaved))
    share = median(shares) if shares else 0.0
    each = median(solve) / 2 if solve else 0.0  # solving and applying are one stage on one process
    table = {**costs.table, "slaved.column": share, "slaved.solve": each, "slaved.apply": each}
    return replace(costs, table=table)


def _speeds(programs: Sequence[Built], cores: int) -> tuple[float, ...]:
    """Return the speed of each core relative to the fastest; () if they are alike."""
    alone = [p for p in programs if len(p.plan.processes) == 1]
    if cores < 2 or not alone or not hasattr(os, "sched_setaffinity"):
        return ()
    cpus = sorted(os.sched_getaffinity(0))
    compared = alone[:_COMPARED]
    best = [[float("inf")] * len(cpus) for _ in compared]
    for _ in range(3):
        for k, cpu in enumerate(cpus):
            with _confined_to(cpu):
                for times, program in zip(best, compared, strict=True):
                    times[k] = min(times[k], program.measure(repeat=_REPEAT).best)
    own = [median(min(times) / times[k] for times in best) for k in range(len(cpus))]
    speeds = tuple(round(speed / max(own), 2) for speed in own)
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
