"""The checker of programs: it passes what is emitted, and nothing that was spoilt."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

import numpy as np
import pytest

from adagen.calibrate.schedules import random_schedule
from adagen.cost import programmed
from adagen.emit.shapes import SHAPES
from adagen.errors import UsageError
from adagen.model import REVOLUTE
from adagen.plan import Plan, make_plan
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Accelerate, Receive, Send
from adagen.program import Operation, Program, ProgramError, check, lower
from adagen.program.names import PASSING
from adagen.program.runs import Run, outward_units
from adagen.schedule import Topology, load_profile
from adagen.search import best_schedule, named_schedule
from adagen.studies.stability.robots import rods
from tests.models import Part, assemble, human_figure, random_tree, rod, serial_chain
from tests.slow import spread

PROFILE = load_profile("default")


@lru_cache(maxsize=8)  # several tests look at them
def programs(seed: int) -> list[Program]:
    """Programs of a random robot in every form, shape and way of meeting that takes it."""
    rng = np.random.default_rng(seed)
    mimics = 2 if seed % 4 == 1 else 0
    model = random_tree(rng, int(rng.integers(3, 24)), floating=seed % 3 == 0, mimics=mimics)
    found = []
    for processes in (1, 2, 3, 4):
        schedule = random_schedule(Topology.of(model), processes, PROFILE, seed)
        for form, meeting in (("segment", "join"), ("segment", "gather"), ("ada", "auto")):
            try:
                plan = make_plan(model, schedule, form=form, meeting=meeting)
            except UsageError:
                continue
            found += [
                programmed(plan, name, batch=batch)
                for name, shape in SHAPES.items()
                for batch in (False, True)
                if shape.why_not(plan) is None and not (batch and processes > 1)
            ]
    return found


@pytest.mark.parametrize("seed", spread(range(24), 3))
def test_what_is_emitted_is_well_formed(seed: int) -> None:
    found = programs(seed)
    assert len(found) >= 8
    for program in found:
        check(program)


def example(meeting: str = "gather", shape: str = "kernels") -> Program:
    model = human_figure()
    schedule = random_schedule(Topology.of(model), 2, PROFILE, 5)
    if shape == "joints":
        return programmed(make_plan(model, schedule, form="ada"), shape)
    return programmed(make_plan(model, schedule, meeting=meeting), shape)


def spoilt(program: Program, change: Callable[[list[Operation]], list[Operation]]) -> Program:
    """The program with the operations of process 1 changed."""
    first, second, *more = program.processes
    changed = replace(second, operations=tuple(change(list(second.operations))))
    return replace(program, processes=(first, changed, *more))


@pytest.mark.parametrize(
    ("meeting", "shape"),
    [("gather", "kernels"), ("join", "kernels"), ("join", "joints"), ("join", "unrolled")],
)
def test_no_operation_can_be_left_out(meeting: str, shape: str) -> None:
    program = example(meeting, shape)
    check(program)
    for place, operation in enumerate(program.processes[1].operations):
        if operation.does == "clear_inertia":
            continue  # where nothing was left yet, there is nothing to clear
        without = spoilt(program, lambda own, place=place: own[:place] + own[place + 1 :])  # type: ignore[misc]
        with pytest.raises(ProgramError):
            check(without)


def test_no_operation_can_be_done_twice() -> None:
    program = example("join", "unrolled")
    for place, operation in enumerate(program.processes[1].operations):
        if operation.does in ("kinematics", "link_bias", "apply_coupling"):
            continue  # done again it finds the same, and what was found has been read meanwhile
        twice = spoilt(program, lambda own, place=place: own[: place + 1] + own[place:])  # type: ignore[misc]
        with pytest.raises(ProgramError):
            check(twice)


def test_sweeps_cannot_go_the_wrong_way() -> None:
    program = example()
    for does in ("articulate", "accelerate"):

        def turned(own: list[Operation], does: str = does) -> list[Operation]:
            places = [k for k, operation in enumerate(own) if operation.does == does]
            result = list(own)
            for k, other in zip(places, reversed(places), strict=True):
                steps = tuple(reversed(own[other].steps))
                result[k] = replace(own[other], steps=steps)
            return result

        with pytest.raises(ProgramError, match=r"read before it is set|added to after it was read"):
            check(spoilt(program, turned))


def test_the_first_inertia_at_a_link_is_stored_and_others_are_added() -> None:
    program = example()
    places = [
        (place, k)
        for place, operation in enumerate(program.processes[1].operations)
        for k in range(len(operation.first))
        if not _at_ground(program.plan, operation, k)
    ]
    assert places

    for place, k in places:

        def other(own: list[Operation], place: int = place, k: int = k) -> list[Operation]:
            first = list(own[place].first)
            first[k] = not first[k]
            return [*own[:place], replace(own[place], first=tuple(first)), *own[place + 1 :]]

        with pytest.raises(ProgramError, match=r"is lost|nothing was left"):
            check(spoilt(program, other))


def _at_ground(plan: Plan, operation: Operation, k: int) -> bool:
    match operation.block:
        case Limbs() as limbs:
            return plan.joints[limbs.rows[0][k]].parent == 0
        case Run() as run if operation.does == "articulate" and not run.reversed:
            return plan.joints[run.first].parent == 0
    return False


def test_messages_are_sent_once_by_their_source_and_received_by_their_target() -> None:
    program = example()
    send = next(
        operation
        for operation in program.processes[0].operations
        if isinstance(operation.steps[0] if operation.steps else None, Send)
    )
    with pytest.raises(ProgramError, match="not this process's to send"):
        check(spoilt(program, lambda own: [*own, send]))

    def waits_first(own: list[Operation]) -> list[Operation]:
        receives = [o for o in own if o.steps and isinstance(o.steps[0], Receive)]
        return [*receives, *(o for o in own if o not in receives)]

    first, second = program.processes
    stuck = replace(
        spoilt(program, waits_first),
        processes=(
            replace(first, operations=tuple(waits_first(list(first.operations)))),
            replace(second, operations=tuple(waits_first(list(second.operations)))),
        ),
    )
    with pytest.raises(ProgramError, match="waits for ever"):
        check(stuck)


def test_every_acceleration_has_one_owner() -> None:
    program = example()
    first, second = program.plan.processes
    both = replace(first, owns=tuple(sorted((*first.owns, second.owns[0]))))
    twice = replace(program, plan=replace(program.plan, processes=(both, second)))
    with pytest.raises(ProgramError, match="is owned by processes 0 and 1"):
        check(twice)
    fewer = replace(second, owns=second.owns[1:])
    lost = replace(program, plan=replace(program.plan, processes=(first, fewer)))
    with pytest.raises(ProgramError, match="no process owns"):
        check(lost)
    more = replace(second, owns=second.owns, steps=())
    idle = replace(program, plan=replace(program.plan, processes=(first, more)))
    check(idle)  # steps are the plan's: what runs is the program's operations

    def without(own: list[Operation]) -> list[Operation]:
        return [o for o in own if not any(isinstance(s, Accelerate) for s in o.steps)]

    with pytest.raises(ProgramError, match="is not computed"):
        check(spoilt(program, without))


def test_what_recovers_is_checked_too() -> None:
    model = serial_chain(60)
    program = programmed(make_plan(model, best_schedule(model, 2, PROFILE)), "kernels")
    p = next(p for p, process in enumerate(program.processes) if process.recovery)
    check(program)
    processes = list(program.processes)
    processes[p] = replace(processes[p], recovery=processes[p].recovery[1:])
    with pytest.raises(ProgramError):
        check(replace(program, processes=tuple(processes)))


def test_what_is_done_instead_keeps_inertias_where_the_program_does() -> None:
    """Loops of gathering processes, whose second way knows the places of the first."""
    model = rods(20)
    schedule = named_schedule("balanced", Topology.of(model), 2, profile=load_profile("default"))
    plan = make_plan(model, schedule, meeting="gather")
    assert plan.recovers
    check(lower(plan, "kernels"))


def test_links_of_joints_that_are_passed_are_not_kept() -> None:
    model = serial_chain(12)
    schedule = random_schedule(Topology.of(model), 2, PROFILE, 5)
    program = programmed(make_plan(model, schedule, meeting="join"), "kernels")

    def passed(operations: list[Operation]) -> list[Operation]:
        return [
            replace(each, does=PASSING) if each.does == "kinematics" else each
            for each in operations
        ]

    check(program)
    with pytest.raises(ProgramError, match="is read before it is set"):
        check(spoilt(program, passed))


def test_links_that_others_leave_are_kept_whatever_is_computed_between() -> None:
    """Fingers side by side lie between the passage to them and an arm on a link inside it."""
    body = rod(1.0, np.array([0.0, 0.0, 0.1]))
    chains = {"t": (6, None), "u": (2, "t5"), "v": (2, "t5"), "w": (3, "t2")}
    parts = [
        Part(f"{name}{k}", f"{name}{k - 1}" if k else on, REVOLUTE, body)
        for name, (length, on) in chains.items()
        for k in range(length)
    ]
    model = assemble("hand", parts)
    joints = make_plan(model, best_schedule(model, 1, PROFILE)).joints
    assert [joint.name for joint in joints] == [part.name for part in parts]
    limbs = Limbs(((6, 8), (7, 9)))
    units = list(outward_units(joints, range(13), [limbs], range(6, 13)))
    kept = [unit.run.last for unit in units if not isinstance(unit, Limbs)]
    assert units.index(limbs) < len(units) - 1
    assert {2, 5} <= set(kept)
