"""The fit finds the coefficients that made the times, and says how far off it is."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.calibrate.batches import fit_batches
from adagen.calibrate.channel import (
    SIZES,
    MessageTime,
    channel_errors,
    fit_channel,
    least_times,
)
from adagen.calibrate.fit import (
    Sample,
    evaluation_cost,
    fit_steps,
    relative_errors,
    with_tangents,
)
from adagen.calibrate.measure import Built, Measurement, StageTime
from adagen.calibrate.nnls import nnls
from adagen.calibrate.samples import (
    ORDERS,
    Wanted,
    batch_programs,
    in_order,
    stepwise_programs,
    straight_programs,
)
from adagen.calibrate.straight import (
    faster_orders,
    fit_straight,
    longest_line,
    timed_stretches,
)
from adagen.calibrate.surrogate import fit_equation11, join_time
from adagen.calibrate.write import profile_text
from adagen.cost import operation_features, state_time, timeline
from adagen.cost.features import joins_of
from adagen.emit import emit
from adagen.program import Program
from adagen.schedule import load_profile, parse_profile
from adagen.schedule.costs import ASSUMED, NAMES, OTHERS, ChannelCosts, StepCosts
from adagen.schedule.profile import CostProfile
from tests.cost.costs import MESSAGE, WINDOW, step_costs, step_profile
from tests.emitted import Builder


def played(program: Program, costs: StepCosts, noise: float, rng: np.random.Generator) -> Sample:
    """Return what would be measured on a machine with these costs."""
    line = timeline(program, CostProfile("x", 0.1, 0.1, 0.0, 1.0, steps=costs)).by_stage()
    rows, waiting = [], {}
    for i in line.intervals:
        if i.what == "wait":
            waiting[i.process, i.message] = i.start
            continue
        start = waiting.get((i.process, i.message), i.start) if i.what == "receive" else i.start
        length = (i.end - start) * (1 + noise * rng.normal())
        rows.append(StageTime(i.process, i.what, i.message, start, length))
    return Sample(program, Measurement(line.makespan, line.makespan, tuple(rows), "window", True))


@pytest.fixture(scope="module")
def wanted() -> list[Wanted]:
    return stepwise_programs(load_profile("paper"), quick=False)


@pytest.fixture(scope="module")
def programs(wanted: list[Wanted]) -> list[Program]:
    return [each.lowered for each in wanted if not each.plan.slaved]


def test_every_coefficient_that_prices_something_is_measured(
    programs: list[Program],
) -> None:
    """Of hinges, runs and all that has no kind; coefficients of rare kinds resemble these."""
    seen = {
        name
        for program in programs
        for process in program.processes
        for operation in process.operations
        for name in operation_features(operation, program.plan.joints, joins_of(program.plan))
    }
    fitted = {"process.evaluation", "process.margin", "unrolled.held"}
    fitted |= {"process.tangent", "process.cache", "process.register"}
    fitted |= {name for name in NAMES if name.startswith(("slaved.", "unrolled.", "batch."))}
    unseen = {name for name in NAMES if name not in seen | fitted}
    told = {f"{group}.{key}" for group, keys in OTHERS.items() for key in keys}
    assert not {n for n in unseen if n in told or n.endswith((".revolute", ".run"))}


def test_what_is_measured_does_not_depend_on_a_profile(wanted: list[Wanted]) -> None:
    """Prices choose nothing there: only schedules' nodes are priced."""
    others = stepwise_programs(load_profile("default"), quick=False)
    for one, other in zip(wanted, others, strict=True):
        assert one.limbs == other.limbs
        assert one.lowered.processes == other.lowered.processes


def test_nnls_obeys_its_optimality_conditions() -> None:
    rng = np.random.default_rng(1)
    for _ in range(200):
        m, n = int(rng.integers(4, 20)), int(rng.integers(1, 5))
        A, b = rng.normal(size=(m, n)), rng.normal(size=m)
        x = nnls(A, b)
        slope = A.T @ (b - A @ x)
        assert (x >= 0).all()
        assert (slope <= 1e-8).all()
        assert np.abs(slope[x > 0]).max(initial=0.0) < 1e-8


def test_known_costs_are_found_again(programs: list[Program]) -> None:
    rng = np.random.default_rng(2)
    truth = step_costs()
    samples = [played(each, truth, 0.0, rng) for each in programs]
    table = fit_steps(samples)
    assert set(table) == set(NAMES) and min(table.values()) >= 0
    found = StepCosts(table, WINDOW, WINDOW)
    # Not every coefficient can be distinguished, but the times of stages must come out.
    errors = [abs(e) for row in relative_errors(samples, found).values() for e in row]
    assert np.median(errors) < 0.01 and max(errors) < 0.06
    for name in ("kinematics.revolute", "kinematics.spherical"):
        assert found[name] == pytest.approx(truth[name], rel=0.03)


def test_noise_and_an_outlier_do_little(programs: list[Program]) -> None:
    rng = np.random.default_rng(3)
    truth = step_costs()
    samples = [played(each, truth, 0.03, rng) for each in programs]
    bad = samples[0].measured.stages[0]
    stages = (StageTime(0, bad.what, None, 0.0, 20 * bad.length), *samples[0].measured.stages[1:])
    m = samples[0].measured
    samples[0] = Sample(samples[0].program, Measurement(m.time, m.best, stages, "window", True))
    found = StepCosts(fit_steps(samples), WINDOW, WINDOW)
    clean = [played(each, truth, 0.0, rng) for each in programs]
    errors = [abs(e) for row in relative_errors(clean, found).values() for e in row]
    assert np.median(errors) < 0.03


def messages_over(channel: ChannelCosts, noise: float = 0.0) -> tuple[MessageTime, ...]:
    """Return what would be measured of a channel with these costs."""
    rng = np.random.default_rng(6)
    return tuple(
        MessageTime(
            n,
            (channel.send + channel.latency + n * channel.number) * (1 + noise * rng.normal()),
            channel.send + n * channel.number / 2,
        )
        for n in SIZES
    )


@pytest.mark.parametrize("truth", [WINDOW, MESSAGE, ChannelCosts(0.0, 0.05, 0.0)])
def test_channels_are_found_again(truth: ChannelCosts) -> None:
    found = fit_channel(messages_over(truth))
    for key in ("send", "latency", "number"):
        assert getattr(found, key) == pytest.approx(getattr(truth, key), rel=1e-6, abs=1e-9)
    assert channel_errors(messages_over(truth), found) == pytest.approx([0.0] * len(SIZES))
    rough = fit_channel(messages_over(truth, 0.03))
    assert rough.send + rough.latency == pytest.approx(truth.send + truth.latency, rel=0.05)


def test_a_disturbed_run_of_messages_does_nothing() -> None:
    calm = {"window": messages_over(WINDOW), "message": messages_over(MESSAGE)}
    slow = [MessageTime(m.numbers, 5 * m.way, 5 * m.send) for m in calm["window"]]
    assert least_times([{**calm, "window": tuple(slow)}, calm]) == calm


def test_a_sender_never_takes_longer_than_the_way() -> None:
    found = fit_channel([MessageTime(n, 0.1, 0.5) for n in SIZES])
    assert found.send == pytest.approx(0.1) and found.latency == 0


def test_costs_of_straight_lines_are_found_again() -> None:
    truth = step_costs(unrolled__held=2500.0, unrolled__cycle=0.5, unrolled__fits=6000.0)
    lines = [each.lowered for each in straight_programs(load_profile("paper"))]
    assert any(any(line.slots.limbs) for line in lines)
    assert any(len(line.processes) > 1 for line in lines)
    rng = np.random.default_rng(7)
    found = fit_straight(timed_stretches([played(line, truth, 0.0, rng) for line in lines]))
    fitted = {name for name in NAMES if name.startswith("unrolled.")}
    # The machine tells the size of its cache, and the order is chosen before.
    assert set(found) == fitted - {"unrolled.cache", "unrolled.ahead", "unrolled.urgent"}
    assert found == pytest.approx({name: truth[name] for name in found}, rel=1e-5)


@pytest.mark.parametrize("up_to", [0, 2, 5])
def test_the_faster_order_of_lines_is_found(up_to: int) -> None:
    """By what waits up to some length, by step beyond, whatever single lines say."""
    offered = (each.lowered for each in straight_programs(load_profile("paper"))[:5])
    lines = sorted(offered, key=longest_line)
    assert len(set(map(longest_line, lines))) == 5
    waiting = [Sample(line, _taking(0.8 if k < up_to else 1.3)) for k, line in enumerate(lines)]
    by_step = [Sample(line, _taking(1.0)) for line in lines]
    if up_to == 0:
        waiting[2] = Sample(lines[2], _taking(0.9))
    urgent, found = faster_orders([*waiting, *by_step])
    assert found == [*waiting[:up_to], *by_step[up_to:]]
    assert [longest_line(line) <= urgent for line in lines] == [k < up_to for k in range(5)]
    assert (urgent in ORDERS) == (up_to != 2)


def _taking(time: float) -> Measurement:
    return Measurement(time, time, (), "none", True)


def test_both_orders_of_lines_are_emitted() -> None:
    """By what waits, as shipped profiles have it, and by step."""
    profile = load_profile("default")
    waiting, by_step = (_emitted(in_order(profile, a, ASSUMED["unrolled.cache"])) for a in ORDERS)
    assert waiting == _emitted(profile) != by_step


def _emitted(profile: CostProfile) -> dict[str, str]:
    line = straight_programs(profile)[2]
    return emit(line.plan, shape=line.shape, profile=line.profile, limbs=line.limbs)


def test_an_evaluation_is_found_again(programs: list[Program]) -> None:
    rng = np.random.default_rng(4)
    truth = step_costs()
    samples = [played(each, truth, 0.0, rng) for each in programs]
    assert evaluation_cost(samples) == pytest.approx(truth["process.evaluation"], rel=1e-6)


def test_equation_11_stands_in_for_the_joins() -> None:
    costs = step_costs()
    profile = fit_equation11("x", costs)
    for k in range(5):
        guess = profile.join(k, 1) / 1e6
        assert guess == pytest.approx(join_time(costs, "revolute", k), rel=0.25)


def test_a_written_profile_is_read_back() -> None:
    costs = step_costs(cores=(1.0, 0.5))
    profile = CostProfile("mine", 0.1, 0.2, -0.01, 0.3, steps=costs)
    text = profile_text(profile, "two lines\nof remark", digits=9)
    read = parse_profile(text, "mine.toml")
    assert read.steps is not None
    assert dict(read.steps.table) == pytest.approx(dict(costs.table))
    assert (read.steps.window, read.steps.message) == (costs.window, costs.message)
    assert read.steps.cores == (1.0, 0.5)
    assert profile_text(read, "two lines\nof remark", digits=9) == text


def test_costs_of_batches_are_found_again() -> None:
    truth = step_costs(batch__number=0.003, batch__sine=0.02, process__register=32.0)
    profile = step_profile((), batch__number=0.003, batch__sine=0.02, process__register=32.0)
    programs = [each.lowered for each in batch_programs(load_profile("paper"))]
    assert {program.shape for program in programs} == {"kernels", "unrolled"}
    samples = [Sample(each, _taking(state_time(each, profile))) for each in programs]
    found = fit_batches(samples, 32)
    fitted = {name for name in NAMES if name.startswith("batch.")}
    assert found == pytest.approx({name: truth[name] for name in fitted}, rel=1e-5)


def test_the_cost_of_a_tangent_is_found_again() -> None:
    profile = step_profile((), process__tangent=0.007)
    programs = stepwise_programs(load_profile("paper"), quick=True)
    alone = [each.lowered for each in programs if len(each.plan.processes) == 1]
    samples = [Sample(each, _taking(state_time(each, profile))) for each in alone]
    found = with_tangents(step_costs(process__tangent=0.0), samples)
    assert found["process.tangent"] == pytest.approx(0.007)
    assert found.joint("revolute") == profile.measured.joint("revolute")


def test_batches_are_built_and_timed(builder: Builder) -> None:
    first, *_ = batch_programs(load_profile("default"))
    built = Built(first.plan, builder.toolchain, first.shape, profile=first.profile, batch=True)
    found = built.measure()
    assert 0 < found.best <= found.time < 100
    assert found.stages == ()
