"""Playing a plan through in time: order, waiting, messages, speeds."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from adagen.calibrate.schedules import random_schedule
from adagen.cost import operation_features, step_features, timeline
from adagen.cost.features import added, joins_of
from adagen.emit.shapes import predict, priced_program
from adagen.model.kinds import KINDS, REVOLUTE
from adagen.plan import Plan, make_plan
from adagen.plan.messages import Message
from adagen.plan.stages import stages
from adagen.plan.steps import Articulate, Receive, Send
from adagen.plan.types import Process
from adagen.program.lower import lower
from adagen.schedule import Topology, load_profile
from adagen.schedule.costs import NAMES
from adagen.search import find_schedule
from tests.cost.costs import WINDOW, step_costs, step_profile
from tests.models import human_figure, random_tree, serial_chain
from tests.plan.test_parts import hinges, in_parts
from tests.scene.held import held
from tests.slow import slow


def plan(processes: int, form: str = "segment", seed: int = 3) -> Plan:
    model = random_tree(np.random.default_rng(seed), 14, floating=seed % 2 == 0)
    schedule = find_schedule(Topology.of(model), processes, profile=load_profile("paper"))
    return make_plan(model, schedule, form=form)


@pytest.mark.parametrize("form", ["ada", "segment"])
@pytest.mark.parametrize("processes", [1, 2, 3, 4, 7])
@pytest.mark.parametrize("seed", [3, slow(4)])
def test_what_is_predicted_can_happen(form: str, processes: int, seed: int) -> None:
    made = plan(processes, form, seed)
    line = predict(made, step_profile()).by_stage()
    assert len(line.exchanges) == len(made.messages)
    ends: list[float] = []
    for p, process in enumerate(made.processes):
        mine = [i for i in line.intervals if i.process == p]
        assert [i.what for i in mine if i.what != "wait"] == [s.what for s in stages(process)]
        for before, after in pairwise(mine):
            assert before.end == pytest.approx(after.start, abs=1e-12)
        if mine:
            ends.append(mine[-1].end)
            first = 0.03 + 0.001 * NAMES.index("process.evaluation")
            assert mine[0].start == pytest.approx(first)
            assert line.busy(p) + line.waiting(p) == pytest.approx(mine[-1].end)
    assert line.makespan == max(ends)
    for exchange in line.exchanges:
        assert exchange.used >= exchange.sent + WINDOW.latency


@pytest.mark.parametrize("form", ["ada", "segment"])
def test_one_process_takes_the_sum_of_its_operations(form: str) -> None:
    made, costs = plan(1, form), step_costs()
    shape = "joints" if form == "ada" else "kernels"
    program = priced_program(made, shape, step_profile())
    own = program.processes[0].operations
    features = [operation_features(op, made.joints, joins_of(made)) for op in own]
    line = timeline(program, step_profile())
    total = sum(map(costs.total, features))
    assert line.makespan == pytest.approx(total + costs["process.evaluation"])
    assert line.waiting(0) == 0
    assert {name for each in features for name in each} <= set(NAMES)


def test_a_receiver_waits_for_latency_and_numbers() -> None:
    made = plan(2)
    message = Message(0, 1, "assembly", 0, biases=made.messages[0].biases[:1])
    idle = replace(
        made,
        processes=(Process((Send(0),), (), ()), Process((Receive(0),), (), ())),
        messages=(message,),
    )
    start = step_costs()["process.evaluation"]
    line = predict(idle, step_profile(), "kernels")
    sent = start + WINDOW.send + 3 * WINDOW.number  # half of 6 numbers
    assert line.exchanges[0].sent == pytest.approx(sent)
    assert line.makespan == pytest.approx(sent + WINDOW.latency + 3 * WINDOW.number)
    assert line.waiting(1) == pytest.approx(sent + WINDOW.latency - start)


def test_mpi_messages_and_slow_cores_take_longer() -> None:
    made = plan(2)
    base = predict(made, step_profile()).makespan
    assert predict(replace(made, channel="message"), step_profile()).makespan > base
    slow = predict(made, step_profile(cores=(0.5, 1.0)))
    assert base < slow.makespan < 2 * base + 1
    assert predict(plan(1), step_profile(cores=(0.5,))).makespan == pytest.approx(
        2 * predict(plan(1), step_profile()).makespan
    )


@pytest.mark.parametrize("name", ["join.coupling_a", "join.block", "propagate.spread"])
def test_no_coefficient_makes_anything_faster(name: str) -> None:
    made = plan(4, "ada" if name.startswith("join") else "segment")
    dearer = step_profile((), **{name.replace(".", "__"): 1.0})
    assert predict(made, dearer).makespan >= predict(made, step_profile()).makespan


def test_slaved_joints_make_every_step_dearer() -> None:
    model = random_tree(np.random.default_rng(5), 10, (REVOLUTE,), mimics=2)
    schedule = find_schedule(Topology.of(model), 2, profile=load_profile("paper"))
    made = make_plan(model, schedule)
    assert made.slaved
    ada, without = make_plan(model, schedule, form="ada"), step_profile(slaved__column=0.0)
    line, cheaper = (predict(ada, p, "joints").makespan for p in (step_profile(), without))
    assert line > cheaper
    free = replace(model, joints=tuple(replace(j, mimic=None) for j in model.joints))
    loops = predict(made, step_profile(), "kernels").makespan
    assert loops > predict(make_plan(free, schedule), step_profile(), "kernels").makespan


@pytest.mark.parametrize("form", ["ada", "segment"])
def test_joints_of_prescribed_motion_have_prices_of_their_own(form: str) -> None:
    """Whatever their kind: only their kinematics are those of joints that move freely."""
    model = random_tree(np.random.default_rng(6), 16)
    schedule = random_schedule(Topology.of(model), 2, step_profile(), 3)
    known = held(model, range(1, 16, 2))
    made = make_plan(known, schedule, form=form)
    names = {
        name
        for process in made.processes
        for step in process.steps
        if made.joints[getattr(step, "joint", 0)].prescribed
        for name in step_features(step, made.joints, joins_of(made))
    }
    kinds = {name for name in names if name.split(".")[1] in KINDS}
    assert kinds and all(name.startswith("kinematics.") for name in kinds)
    own = "join_repeated.prescribed" if form == "ada" else "articulate.prescribed"
    assert own in names
    dear = step_profile((), **{own.replace(".", "__"): 1.0})
    assert predict(made, dear).makespan > predict(made, step_profile()).makespan + 0.5


def test_nothing_is_swept_onto_the_ground_by_a_joint_of_prescribed_motion() -> None:
    known = held(serial_chain(2), [0])
    made = make_plan(known, find_schedule(Topology.of(known), 1, profile=load_profile("default")))
    swept = [step for step in made.processes[0].steps if isinstance(step, Articulate)]
    assert [step_features(step, made.joints) for step in swept] == [{"articulate.revolute": 1}, {}]


def test_the_paper_profile_has_no_steps_to_predict_with() -> None:
    with pytest.raises(ValueError, match="no costs of steps"):
        predict(plan(1), load_profile("paper"))


@pytest.mark.parametrize("processes", [1, 2, 4])
def test_every_step_belongs_to_one_stage(processes: int) -> None:
    for model in (human_figure(), serial_chain(12)):
        schedule = find_schedule(Topology.of(model), processes, profile=load_profile("paper"))
        for process in make_plan(model, schedule).processes:
            found = stages(process)
            covered = [k for stage in found for k in range(stage.first, stage.last)]
            assert covered == list(range(len(process.steps)))
            sorts = [stage.what for stage in found if stage.message is None]
            assert sorts.index("kinematics") == 0


def test_a_row_of_a_chain_in_parts_takes_as_long_where_joints_are_missing() -> None:
    """Sweeps of 193 hinges, 25 rows of eight, are priced as those of 200."""

    def sweeps(joints: int) -> dict[str, float]:
        program = lower(in_parts(hinges(joints, 1)), "kernels")
        own = [op for op in program.processes[0].operations if op.lanes == 8]
        assert [op.does for op in own] == ["kinematics", "articulate", "accelerate"]
        return added(operation_features(op, program.plan.joints) for op in own)

    few, full = sweeps(193), sweeps(200)
    assert few == pytest.approx(full, rel=3e-3)
    names = {"parts.inwards", "parts.outwards", "kinematics_strips.revolute"}
    assert names <= full.keys() and all(few[name] > 191 for name in names)
