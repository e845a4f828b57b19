"""What a chart is made of, and one made of real programs."""

from __future__ import annotations

import json
import os
from argparse import Namespace
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.cli import chart as chart_command
from adagen.cli import main
from adagen.emit import stem_of
from adagen.model import Passive
from adagen.states import random_states
from adagen.studies.bench.contest import Contestant
from adagen.studies.chart import Point, Study, Variant, chart_of, every_variant
from adagen.studies.chart.motion import Played, Player, drifts, motion_chart
from adagen.studies.chart.study import _judged
from adagen.studies.chart.variants import REFERENCE, SCHEDULES
from adagen.studies.truth import truth_of
from adagen.urdf import read_robot
from tests.emitted import Builder, Solver, plan_of
from tests.golden.make_models import MODELS
from tests.models import random_tree, serial_chain, star


class TestVariants:
    def test_every_variant_is_there_once_with_a_name_of_its_own(self) -> None:
        found = every_variant()
        labels = [variant.label for variant in found]
        assert found[0] == REFERENCE
        assert len(set(labels)) == len(labels)
        assert {(v.algorithm, v.processes) for v in found} >= {
            ("crba", 1), ("aba", 1), ("aba_exact", 1), ("ada", 4), ("segment", 2)
        }  # fmt: skip
        assert {v.schedule for v in found} == {"auto"}
        assert {v.schedule for v in every_variant(schedules=SCHEDULES)} == set(SCHEDULES)
        assert set(found) < set(every_variant(whole=True))
        assert {v.shape for v in found if v.algorithm == "segment"} == {
            "auto",
            "kernels",
            "unrolled",
        }
        assert {v.refine for v in found if v.scalar == "float"} == {0, 1}
        assert {v.scalar for v in found if v.batch} == {"double", "float"}
        assert any(v.reproducible for v in found) and any(not v.lanes for v in found)
        assert {v.shape for v in found if v.certify} == {"kernels", "unrolled"}
        aimed = every_variant(objective="accuracy")
        assert {v.objective for v in aimed[1:] if not v.baseline} == {"accuracy"}

    def test_steps_of_refinement_are_those_asked_for(self) -> None:
        assert {v.refine for v in every_variant(refinements=(1, 3))} == {0, 1, 3}

    @pytest.mark.parametrize("schedule", ["auto", "balanced", "sequential", "random"])
    @pytest.mark.parametrize("algorithm", ["ada", "segment"])
    def test_schedules_become_plans(self, algorithm: str, schedule: str) -> None:
        _, plan = Variant(algorithm, schedule, processes=2).plan(star(3))
        assert (plan.form, len(plan.processes)) == (algorithm, 2)


@pytest.mark.parametrize(("factor", "why"), [(1.0, None), (1.05, None), (0.5, "not one digit")])
def test_an_answer_without_a_right_digit_is_a_failure(factor: float, why: str | None) -> None:
    truth = truth_of(serial_chain(3), 2)
    right = np.array([[float(x) for x in row] for row in truth.exact])
    solver = Contestant("x", "adagen", "", 1, "double", lambda _: factor * right, lambda _: {})
    point = _judged(Point("x", "adagen", **vars(REFERENCE)), solver, truth)
    assert point.failed == (why is not None)
    if why is not None:
        assert why in (point.why or "")


def test_errors_are_seen_below_the_rounding_of_the_truth() -> None:
    model = serial_chain(3)
    truth = truth_of(model, 2)
    assert truth.digits == 100
    right = np.array([[float(x) for x in row] for row in truth.exact])
    forward, residual = truth.errors(right)
    assert 0 < forward < 2.0**-53 and residual < 1e-14
    assert truth.errors(right * (1 + 1e-9))[0] == pytest.approx(1e-9, rel=1e-3)
    assert truth.errors(right * np.nan) == (np.inf, np.inf)


def test_a_study_measures_and_tells_why_it_cannot(builder: Builder) -> None:
    model = serial_chain(4)
    toolchain = builder.quick
    bad = Variant("ada", "no such one")
    shared = Variant("segment", "balanced", processes=2)
    study = Study([shared, bad], rounds=1, repeat=1)
    allowed = os.sched_getaffinity(0)
    try:
        os.sched_setaffinity(0, {min(allowed)})  # what is started here inherits it
        chart = chart_of(model, truth_of(model, 3, digits=30), study, toolchain)
    finally:
        os.sched_setaffinity(0, allowed)
    reference, two, failed = chart.points
    assert reference.label == REFERENCE.label and reference.front
    assert reference.time_ns and reference.ratio == 1.0
    assert reference.error is not None and reference.error < 1e-14
    assert (reference.source, two.source) == ("clock", "stretches")
    assert two.time_ns and two.ratio and not two.front
    assert two.error is not None and two.error < 1e-13
    assert failed.failed and "unknown schedule" in (failed.why or "")


def test_identical_programs_and_idle_processes_are_left_out(builder: Builder) -> None:
    """A straight line that is the default already, and two processes of which one idles."""
    model = serial_chain(3)
    toolchain = builder.quick
    same, idle = Variant("segment", shape="unrolled"), Variant("segment", processes=2)
    other, many = (
        Variant("segment", shape="kernels"),
        Variant("segment", shape="unrolled", batch=True),
    )
    study = Study([same, idle, other, many, Variant("segment", reproducible=True)], 1, 1)
    chart = chart_of(model, truth_of(model, 3, digits=30), study, toolchain)
    assert [(p.label, p.method) for p in chart.points] == [
        ("default", "straight"),
        ("loops", "loops"),
        ("batch of states, straight line", "batches"),
        ("reproducible line", "reproducible"),
    ]
    assert all(p.error is not None and p.error < 1e-14 and p.time_ns for p in chart.points)


def test_errors_are_those_of_given_states() -> None:
    model = serial_chain(3)
    states = random_states(model, 4, seed=9)
    truth = truth_of(model, states, digits=30)
    assert truth.states is states
    assert truth.exact.shape == (4, 3)


def test_integrators_are_charted_with_their_orders(builder: Builder) -> None:
    model = random_tree(np.random.default_rng(4), 2, floating=True)
    player = Player(model, builder.solver(plan_of(model, 1)).executable, 1, builder.toolchain)
    chart = motion_chart(player, 0.25, [1 / 32, 1 / 64, 1 / 128])
    assert chart.reference_error < 1e-10
    for name, least, most in (("euler", 0.7, 1.5), ("semi-implicit", 0.7, 1.5), ("rk4", 3.5, 4.7),
                              ("rkmk4", 3.5, 4.7)):  # fmt: skip
        order = chart.order(name, "error")
        assert order is not None and least < order < most
    assert all(p.momentum is not None for p in chart.points)
    assert random_states(model, 1).q.shape == (1, model.nq)


def test_what_is_not_kept_has_no_drift() -> None:
    model = serial_chain(2)
    still = np.zeros((2, model.nq)), np.ones((2, model.nv))
    motion = Played(np.array([0.0, 1.0]), *still, 1.0)
    assert drifts(model, motion) == (0.0, None)
    damped = [replace(joint, passive=Passive(damping=0.1)) for joint in model.joints]
    assert drifts(replace(model, joints=tuple(damped)), motion) == (None, None)


@pytest.mark.parametrize(
    "variant",
    [
        Variant("segment", "random", processes=2),
        Variant("segment", processes=2, refine=1),
        Variant("segment", scalar="float", shape="unrolled"),
        Variant("segment", shape="kernels", batch=True),
        Variant("segment", reproducible=True),
        Variant("segment", shape="kernels", lanes=False),
        Variant("segment", objective="accuracy"),
        Variant("ada", "balanced", processes=3, refine=2),
    ],
)
def test_what_keeps_a_budget_is_emitted_as_it_was_measured(
    variant: Variant, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    model, path = read_robot(MODELS / "arm7.urdf").model, MODELS / "arm7.urdf"
    point = Point(variant.label, "adagen", **vars(variant), time_ns=1234.0, error=1e-12)
    read = dict.fromkeys(("scene", "loops", "xacro_arg"))
    options = Namespace(model=str(path), floating=False, mimic=False, strict=False, **read)
    options.out = tmp_path
    chart_command._answer(point, model, options)
    assert capsys.readouterr().out == f"{variant.label}: 1.23 us, error 1.0e-12\n"
    _, plan = variant.plan(model)
    measured = variant.files(plan)[f"{stem_of(plan)}.cpp"]
    emitted = (tmp_path / f"arm7_p{variant.processes}.cpp").read_text()
    assert _code(emitted) == _code(measured)


def _code(text: str) -> str:
    """A program but for what its header and usage say of where the robot was read."""
    return text[text.index("#include") :]


@pytest.mark.slow
@pytest.mark.parametrize("budget", ["error<1e-10", "time<1s"])
def test_the_command_line_draws_and_emits_what_keeps_a_budget(
    budget: str, builder: Builder, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """To the emitted program's own check of its answers."""
    words = [str(MODELS / "chain16.urdf"), "--quick", "--procs", "1", "--scalars", "double"]
    words += ["--algorithms", "segment,crba", "--budget", budget, "--out", str(tmp_path)]
    assert main(["chart", *words]) == 0
    assert " us, error " in capsys.readouterr().out
    names = {path.name for path in tmp_path.iterdir()}
    assert names >= {"chart_chain16.svg", "chart_chain16.png", "chart_chain16.json",
                     "chain16_p1.cpp", "chain16_p1.plan.json", "Makefile"}  # fmt: skip
    data = json.loads((tmp_path / "chart_chain16.json").read_text())
    assert {p["algorithm"] for p in data["points"]} == {"segment", "crba"}
    assert all(p["time_ns"] > 0 for p in data["points"])
    source = (tmp_path / "chain16_p1.cpp").read_text()
    solver = Solver(builder.compile(source, "chain16_p1"), 1, builder.toolchain)
    done = solver.run("--check")
    assert (done.status, done.stdout.count("right")) == (0, 1)
