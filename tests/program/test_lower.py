"""Plans lowered to programs: every step is carried out once, over blocks that fit it."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import replace

import pytest

from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Articulate, Kinematics, SolveMobility, SolveRoot
from adagen.plan.types import Process
from adagen.program import Program, program_to_json
from adagen.program.runs import Run
from adagen.program.summary import groups, meeting, owners, title
from tests.program.test_check import example, programs

SEEDS = [pytest.param(k, marks=[pytest.mark.slow] * (k >= 3)) for k in range(12)]


@pytest.mark.parametrize("seed", SEEDS)
def test_every_step_is_carried_out_once(seed: int) -> None:
    for program in programs(seed):
        for process, own in zip(program.plan.processes, program.processes, strict=True):
            for steps, operations in (
                (process.steps, own.operations),
                (process.recovery, own.recovery),
            ):
                done = Counter(step for operation in operations for step in operation.steps)
                assert done == Counter(steps)
            stages = [operation.stage for operation in own.operations]
            assert stages == sorted(stages)


@pytest.mark.parametrize("seed", SEEDS)
def test_blocks_hold_the_joints_of_their_steps(seed: int) -> None:
    seen: set[str] = set()
    for program in programs(seed):
        for own in program.processes:
            for operation in own.operations:
                seen.add(operation.method)
                joints = {getattr(step, "joint", None) for step in operation.steps}
                match operation.block:
                    case Limbs() as limbs:
                        assert joints == set(limbs.members())
                    case Run() as run:
                        assert joints == set(range(run.first, run.last + 1))
    assert {"step", "straight"} <= seen and (seed % 4 == 1 or "each" in seen)


def test_runs_are_swept_from_their_far_end() -> None:
    for operation in example().processes[1].operations:
        swept = [step.joint for step in operation.steps if isinstance(step, Articulate)]
        run = operation.block
        if swept and isinstance(run, Run):
            assert swept == sorted(swept, reverse=not run.reversed)
        passed = [step.joint for step in operation.steps if isinstance(step, Kinematics)]
        if isinstance(run, Run):
            assert passed == sorted(passed)


@pytest.mark.parametrize("seed", SEEDS[:6])
def test_a_program_is_printed_as_json_with_every_operation(seed: int) -> None:
    for program in programs(seed):
        text = program_to_json(program)
        assert text == program_to_json(program)
        said = json.loads(text)
        assert said["shape"] == program.shape and said["meeting"] == meeting(program)
        for row, own in zip(said["processes"], program.processes, strict=True):
            assert [each["does"] for each in row["operations"]] == [
                operation.does for operation in own.operations
            ]
        names = [name for row in said["processes"] for name in row["owns"]]
        assert sorted(names) == sorted(joint.name for joint in program.plan.joints)
        numbers = [message["numbers"] for message in said["messages"]]
        plan = program.plan
        assert numbers == [m.numbers(plan.right_hand_sides, plan.joints) for m in plan.messages]


def test_what_is_said_of_a_program_is_read_off_it() -> None:
    gathered, joined = example("gather"), example("join")
    assert (meeting(gathered), meeting(joined)) == ("gathered", "joined")
    assert "gathered at " in title(gathered) and title(joined) == "2 processes, joined at cuts"
    apart = replace(gathered.plan, processes=tuple(map(_without_roots, gathered.plan.processes)))
    assert title(replace(gathered, plan=apart)) == "2 processes, each with limbs of its own"
    for program in (gathered, joined):
        _owners_agree(program)
    (limbs, *_) = gathered.slots.limbs[1] or gathered.slots.limbs[0]
    words = [word for p in (0, 1) for word in groups(gathered, p)]
    assert any(f"in {limbs.lanes} lanes" in word for word in words)


def _without_roots(process: Process) -> Process:
    kept = [step for step in process.steps if not isinstance(step, SolveRoot | SolveMobility)]
    return replace(process, steps=tuple(kept), shares=())


def _owners_agree(program: Program) -> None:
    by_name = owners(program)
    for p, process in enumerate(program.plan.processes):
        assert all(by_name[program.plan.joints[j].name] == p for j in process.owns)
