"""Form segment: a process's long chain of hinges in parts that it joins itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from adagen.emit.shapes import SHAPES
from adagen.errors import UsageError
from adagen.model import KINDS, Mimic, Model
from adagen.plan import Plan, make_plan, plan_from_json, plan_to_json
from adagen.plan.certificate import certified
from adagen.plan.parts import FEWEST_ROWS, pairs_of, strips_of
from adagen.plan.steps import (
    Accelerate,
    Articulate,
    Disassemble,
    InvertRoot,
    Join,
    Load,
    Traverse,
)
from adagen.program import ProgramError, check
from adagen.program.lower import lower
from adagen.program.runs import Run, parts_in
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule
from tests.models import random_tree
from tests.plan.test_gather import error
from tests.slow import slow

PROFILE = load_profile("default")


def in_parts(model: Model, processes: int = 1, parts: int = 8, meeting: str = "join") -> Plan:
    """Return the plan of a chain whose processes part what is their own."""
    schedule = named_schedule("balanced", Topology.of(model), processes, profile=PROFILE)
    return make_plan(model, replace(schedule, parts=parts), meeting=meeting)


def hinges(joints: int, seed: int) -> Model:
    kinds = [KINDS["revolute"]]
    return random_tree(np.random.default_rng(seed), joints, branching=0.0, kinds=kinds)


def hung(kind: str, joints: int, seed: int) -> Model:
    """Return a chain of hinges that hangs on a joint of another kind, its first one."""
    floats = kind == "floating"
    rng, hinge = np.random.default_rng(seed), [KINDS["revolute"]]
    model = random_tree(rng, joints - floats, branching=0.0, kinds=hinge, floating=floats)
    first = replace(model.joints[0], kind=KINDS[kind])
    return replace(model, joints=(first, *model.joints[1:]))


@given(st.integers(0, 300), st.integers(8, 400), st.sampled_from([2, 8, 16]))
def test_strips_follow_each_other_and_are_as_long(first: int, count: int, lanes: int) -> None:
    strips = strips_of(range(first, first + count), lanes)
    assert [j for strip in strips for j in strip] == list(range(first, first + count))
    lengths = [len(strip) for strip in strips]
    assert len(strips) == lanes and max(lengths) - min(lengths) <= 1
    assert lengths == sorted(lengths, reverse=True)


@pytest.mark.parametrize(
    ("joints", "processes", "parts", "meeting"),
    [
        *((24, 1, 8, "join"), (31, 1, 8, "join"), (32, 1, 8, "join"), (20, 1, 3, "join")),
        (60, 2, 8, "exchange"),
        slow(100, 3, 8, "exchange"),
    ],
)
def test_a_chain_in_parts_is_solved(joints: int, processes: int, parts: int, meeting: str) -> None:
    """Each part hangs on a joint by which it is joined, the first one on the ground, too."""
    model = hinges(joints, seed=joints)
    plan = in_parts(model, processes, parts, meeting)
    for shape in ("kernels", "unrolled"):
        check(lower(plan, shape))
    assert error(model, plan) < 1e-9
    assert plan_from_json(plan_to_json(plan)) == plan
    whole = in_parts(model, processes, 0, meeting)
    for own, others in zip(plan.processes, whole.processes, strict=True):
        more = len(list(own.steps_of(Join))) - len(list(others.steps_of(Join)))
        assert more == parts - (own is not plan.processes[0])
        assert own.owns == others.owns and own.reads == others.reads


@pytest.mark.parametrize(
    ("joints", "processes", "kind"),
    [
        *((34, 1, kind) for kind in ("floating", "prismatic", "planar")),
        (70, 2, "floating"),
        *(slow(70, 2, kind) for kind in ("prismatic", "planar")),
        *(slow(100, 3, kind) for kind in ("floating", "prismatic", "planar")),
    ],
)
def test_a_chain_that_hangs_on_another_joint_is_solved_in_parts(
    kind: str, joints: int, processes: int
) -> None:
    """That joint is joined to all parts; processes begin their passages behind it."""
    model = hung(kind, joints, seed=joints)
    plan = in_parts(model, processes, meeting="exchange" if processes > 1 else "join")
    assert error(model, plan) < 1e-9
    for shape in ("kernels", "unrolled"):
        check(lower(plan, shape))
    loops = lower(plan, "kernels").processes
    for p, (own, steps) in enumerate(zip(loops, plan.processes, strict=True)):
        swept = [each for each in own.operations if each.does == "articulate"]
        run = Run(max(1, steps.owns[0]), steps.owns[-1])
        assert ("parts", run) in [(each.method, each.block) for each in swept]
        assert steps.reads[0] == 0 and (steps.owns[0] == 0) == (p == 0)
        assert len(list(steps.steps_of(Traverse))) == (processes > 1)


@pytest.mark.parametrize(("count", "levels"), [(2, 1), (3, 2), (8, 3), (13, 4), (16, 4)])
def test_parts_are_joined_as_a_tree(count: int, levels: int) -> None:
    """Each pair is joined when both of its chains are: so many times what one join takes."""
    done = dict.fromkeys(range(count), 0)  # levels below each chain that is left
    for near, far in pairs_of(count):
        done[near] = 1 + max(done[near], done.pop(far))
    assert done == {0: levels}


def test_all_parts_are_swept_before_any_are_joined() -> None:
    """And all joints are accelerated after the last force at an end of a part is known."""
    (process,) = in_parts(hinges(40, seed=1)).processes
    places = {
        kind: [k for k, step in enumerate(process.steps) if isinstance(step, kind)]
        for kind in (Articulate, Join, Disassemble, Accelerate)
    }
    assert max(places[Articulate]) < min(places[Join])
    assert max(places[Disassemble]) < min(places[Accelerate])


@pytest.mark.parametrize("processes", [1, 2])
def test_loops_sweep_all_parts_at_once(processes: int) -> None:
    meeting = "join" if processes == 1 else "exchange"
    program = lower(in_parts(hinges(40 * processes, seed=2), processes, meeting=meeting), "kernels")
    for p, process in enumerate(program.processes):
        found = {op.does: op for op in process.operations if op.method == "parts"}
        inwards, outwards = {"articulate", "propagate", "join"}, {"disassemble", "accelerate"}
        assert inwards | outwards | {"load", "deliver", "accelerate_root"} == set(found)
        joined = [step.joint for step in found["join"].steps if isinstance(step, Join)]
        released = [s.joint for s in found["disassemble"].steps if isinstance(s, Disassemble)]
        assert len(joined) == (8 if p == 0 else 7)  # the ground holds the first part of all
        assert (0 in joined) == (p == 0) and sorted(joined) == sorted(released)
        assert len(parts_in(found["articulate"].steps)) == 8
        assert found["articulate"].first == (True,) * 8
        assert all(op.method != "columns" for op in process.operations)


@pytest.mark.parametrize(
    "why", ["short", "slides", "balls", "slaved", "branches", "joined", "no parts"]
)
def test_nothing_else_is_parted(why: str) -> None:
    model = hinges(40, seed=3)
    rng = np.random.default_rng(4)
    if why == "short":
        model = hinges(8 * FEWEST_ROWS - 1, seed=3)
    elif why == "slides":
        kinds = [KINDS["revolute"], KINDS["prismatic"]]
        model = random_tree(rng, 40, branching=0.0, kinds=kinds)
    elif why == "balls":
        model = random_tree(rng, 40, branching=0.0, kinds=[KINDS["spherical"]])
    elif why == "slaved":
        joints = list(model.joints)
        joints[20] = replace(joints[20], mimic=Mimic(3, 0.5, 0.0))
        model = replace(model, joints=tuple(joints))
    elif why == "branches":
        model = random_tree(rng, 40, branching=0.3, kinds=[KINDS["revolute"]])
    processes = 2 if why == "joined" else 1
    plan = in_parts(model, processes, parts=0 if why == "no parts" else 8)
    assert len(list(plan.steps_of(Join))) == processes - 1


def test_parts_of_one_process_are_certified() -> None:
    """Loops sweep them side by side once more; what the program reads for that has been set."""
    plan = certified(in_parts(hinges(40, seed=2)))
    assert plan_from_json(plan_to_json(plan)) == plan
    for shape in ("kernels", "unrolled"):
        check(lower(plan, shape))
    (process,) = lower(plan, "kernels").processes
    assert [(op.does, op.method) for op in process.operations][-1] == ("certify", "parts")
    whole = certified(in_parts(hinges(40, seed=2), parts=0))
    assert lower(whole, "kernels").processes[0].operations[-1].method == "step"


def test_a_certificate_in_parts_reads_what_they_show() -> None:
    """Without a mobility of a first link, or a joint's release, the program is refused."""
    plan = certified(in_parts(hinges(40, seed=2)))
    (process,) = plan.processes
    for kind in (InvertRoot, Disassemble, Load):
        spoilt = [step for step in process.steps if not isinstance(step, kind)]
        program = lower(replace(plan, processes=(replace(process, steps=tuple(spoilt)),)), "joints")
        with pytest.raises(ProgramError):
            check(program)


def test_parts_of_several_processes_are_not_certified() -> None:
    with pytest.raises(UsageError, match="no process has the factors"):
        certified(in_parts(hinges(80, seed=2), 2, meeting="exchange"))


def test_chains_without_parts_side_by_side_are_not_certified_in_loops() -> None:
    """Three parts are none of eight lanes; straight lines take them."""
    plan = certified(in_parts(hinges(20, seed=1), parts=3))
    assert "side by side" in str(SHAPES["kernels"].why_not(plan))
    assert SHAPES["kernels"].why_not(certified(in_parts(hinges(24, seed=1)))) is None
