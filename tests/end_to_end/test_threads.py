"""Solvers whose processes are threads of one program."""

from __future__ import annotations

import os
import re
import subprocess
import time
from dataclasses import replace
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen import Request, read
from adagen import compile as compiled
from adagen.emit import emit, stem_of
from adagen.errors import UsageError
from adagen.model import Model
from adagen.plan import Plan
from adagen.plan.types import THREADS
from adagen.states import States, random_states
from tests.emitted import QUICK, ROUNDING, Builder, cores, forward_error, plan_of, truth_of
from tests.end_to_end.test_library import BY_STEM, filled, run
from tests.golden.examples import FOLDER
from tests.models import human_figure, serial_chain
from tests.slow import all_but, slow

ARM = BY_STEM["arm7_p1"].model()
CHAIN = serial_chain(70)
SLAVED = BY_STEM["arm7_slaved_p2"].model()
CASES: dict[str, tuple[Model, Plan, dict[str, Any]]] = {
    "joined": (ARM, plan_of(ARM, 2), {}),
    "straight lines": (ARM, plan_of(ARM, 2), {"shape": "unrolled"}),
    "gathered": (human_figure(), plan_of(human_figure(), 3, meeting="gather"), {}),
    "exchanged": (CHAIN, plan_of(CHAIN, 4, meeting="exchange"), {"shape": "kernels"}),
    "the paper's form": (ARM, plan_of(ARM, 4, form="ada"), {"shape": "joints"}),
    "float": (ARM, plan_of(ARM, 2, scalar="float"), {}),
    "refined": (ARM, plan_of(ARM, 2), {"refine": 2}),
    "slaved": (SLAVED, plan_of(SLAVED, 2), {}),
}


@pytest.mark.parametrize(
    "case",
    all_but(
        CASES,
        "refined",
        "exchanged",
        "the paper's form",
        "slaved",
        "float",
        "joined",
        "straight lines",
    ),
)
def test_threads_answer_as_processes_do(case: str, builder: Builder, tmp_path: Path) -> None:
    model, plan, options = CASES[case]
    states = random_states(model, 20, seed=3)
    threads = replace(plan, channel=THREADS)
    of_threads = builder.solver(threads, QUICK, **options)
    of_processes = builder.solver(plan, QUICK, **options)
    assert (of_threads.processes, of_processes.processes) == (1, len(plan.processes))
    found = of_threads.solve(model, states, tmp_path, "--check")
    assert np.array_equal(found, of_processes.solve(model, states, tmp_path, "--check"))


@pytest.mark.parametrize("option", [("--trace", "trace.json"), ("--stretches",)])
def test_what_threads_have_not_is_refused(option: tuple[str, ...], builder: Builder) -> None:
    _, plan, _ = CASES["joined"]
    done = builder.solver(replace(plan, channel=THREADS), QUICK).run(*option)
    assert done.status == 2
    assert "a solver of threads has neither --trace nor --stretches" in done.stderr


@pytest.mark.parametrize("words", [(), ("--no-pin",)])
def test_threads_stay_on_cores_of_their_own_unless_told(
    words: tuple[str, ...], builder: Builder
) -> None:
    _, plan, _ = CASES["joined"]
    solver = builder.solver(replace(plan, channel=THREADS), QUICK)
    command = [str(solver.executable), "--time", "--repeat", "1000000", *words]
    program = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        threads: list[set[int]] = []
        for _ in range(100):
            tasks = [int(task.name) for task in Path(f"/proc/{program.pid}/task").iterdir()]
            threads = [os.sched_getaffinity(task) for task in tasks if task != program.pid]
            if any(len(own) == 1 for own in threads):
                break
            time.sleep(0.01)
        # One of them watches the time limit, and may run anywhere. The other one may not run on
        # the caller's core.
        fewest = min(map(len, threads))
        assert fewest == (max(cores() - 1, 1) if words or cores() < 2 else 1)
    finally:
        program.kill()
        program.wait()


FLAGS = ("-O1", "-march=native")


def solver_and(program: str, case: str, **words: str) -> str:
    """Return the source of a solver of threads with a program of its own behind it."""
    _, plan, options = CASES[case]
    plan = replace(plan, channel=THREADS)
    stem = stem_of(plan, "team")
    files = emit(plan, name="team", **options)
    source = f"{files[f'{stem}.h']}{files[f'{stem}.cpp']}"
    assert "mpi.h" not in source
    return f"#define ADAGEN_NO_MAIN\n{source}{filled(program, stem, **words)}"


@pytest.mark.parametrize(
    ("case", "flags"),
    [
        ("joined", FLAGS),
        ("gathered", FLAGS),
        ("gathered", (*FLAGS, "-fsanitize=thread")),
        slow("gathered", (*FLAGS, "-fsanitize=address,undefined")),
    ],
    ids=["joined", "gathered", "no data race", "no bad address"],
)
def test_a_program_calls_threads(case: str, flags: tuple[str, ...], builder: Builder) -> None:
    program = builder.compile(solver_and("threads.cpp", case), "team", (*flags, "-pthread"))
    model, plan, _ = CASES[case]
    lines = run(program).splitlines()
    last = len(model.joints) - 1
    names = [joint.name for joint in model.joints]
    assert lines[:-1] == [
        "1 the time limit must be more than 0 s",
        "1 this process has no core 100000",
        "other answers: 0",
        "on the caller's core: 0",
        f'1 0 1 joint "{names[0]}": its q, v or tau is not a finite number',
        f'1 {last} 1 joint "{names[last]}": its q, v or tau is not a finite number',
        "asleep: 1",
        "other answers: 0",
    ]
    found = np.array([lines[-1].split()], dtype=float)
    sizes = (model.nq, model.nv, model.ntau)
    state = States(*(np.full((1, n), x) for n, x in zip(sizes, (0.3, 0.2, 0.1), strict=True)))
    assert forward_error(found, truth_of(model, state)) < ROUNDING["double"]
    assert len(plan.processes) > 1


def test_a_late_thread_leaves_the_callers_memory_alone(builder: Builder) -> None:
    source = solver_and("late.cpp", "gathered")
    first = "constexpr std::array<LinkConstants"
    assert source.count(first) == 1
    source = source.replace(first, f"#define private public\n{first}")
    fine, late, *rest = run(builder.compile(source, "late", (*FLAGS, "-pthread"))).splitlines()
    assert fine == "fine 1"
    assert re.fullmatch("late 1, no answer 1: process [12] did not answer within the .*", late)
    assert rest == ["later 1", "closed"]


def test_a_process_that_is_forked_has_threads_of_its_own(builder: Builder) -> None:
    """A copy has none of the threads: it waited for answers, and then for their ends, for ever."""
    program = builder.compile(solver_and("fork.cpp", "gathered"), "forked", (*FLAGS, "-pthread"))
    assert run(program) == "0 0 0 0 0\n" * 2 + "0\n"


def test_threads_take_nothing_from_the_heap_once_they_are_open(builder: Builder) -> None:
    text = solver_and("memory.cpp", "gathered", OPEN="SOLVER_open_threads(nullptr, 20)")
    flags = (*FLAGS, "-fno-builtin-malloc", "-pthread")
    heap, _ = run(builder.compile(text, "heap", flags)).splitlines()
    assert heap == "opened 1, failed 1, said 1, later 0"


def test_python_calls_threads() -> None:
    robot = read(FOLDER / "models" / "arm7.urdf")
    solver = compiled(robot, procs=2, channel=THREADS, form="ada", shape="joints").build()
    chain = random_states(robot.model, 5, seed=2)
    found = solver(chain.q, chain.v, chain.tau)
    assert forward_error(found, truth_of(robot.model, chain)) < ROUNDING["double"]

    def solved_again() -> None:
        raise SystemExit(int(not np.array_equal(solver(chain.q, chain.v, chain.tau), found)))

    # The copy has none of the solver's threads; as a daemon it ends with this process if it hangs.
    copy = get_context("fork").Process(target=solved_again, daemon=True)
    copy.start()
    copy.join(20)
    assert copy.exitcode == 0
    with pytest.raises(UsageError, match=r'compile with procs=1, or channel="threads"'):
        compiled(robot, procs=2, form="ada", shape="joints").build()


def test_batches_are_not_shared_out_to_threads() -> None:
    plan = plan_of(serial_chain(4), 1)
    with pytest.raises(UsageError, match="batches are not shared out to threads"):
        emit(replace(plan, channel=THREADS), batch=2)
    with pytest.raises(UsageError, match="batches are not shared out to threads"):
        Request(procs=2, channel="threads", batch=True)
