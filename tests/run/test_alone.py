"""Programs for several processes that leave everything to one: the others take no part."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from adagen.drawing import draw
from adagen.emit.shapes import priced_program
from adagen.plan import Plan, make_plan
from adagen.schedule import Topology, load_profile
from adagen.search import best_schedule
from adagen.states import random_states, write_states
from tests.emitted import ROUNDING, Builder, Solver, plan_of, text_of
from tests.models import serial_chain

MODEL = serial_chain(4)
PROFILE = load_profile("default")


def plan(processes: int) -> Plan:
    return make_plan(MODEL, best_schedule(MODEL, processes, PROFILE))


@pytest.fixture(scope="module")
def solver(builder: Builder) -> Solver:
    return builder.solver(plan(2))


def evaluation(text: str) -> str:
    """Return the functions of process 0 in a straight line's source, without comments."""
    code = text[text.index("void part_0_0") :]
    for table in ("kRun{", "kRead_1{", "kStages_"):
        code = code.partition(table)[0]
    return "\n".join(line for line in code.splitlines()[:-1] if line.strip() and line[:2] != "//")


def test_process_0_runs_the_text_of_one_process() -> None:
    one, two = text_of(plan(1)), text_of(plan(2))
    assert plan(2).messages == () and not plan(2).processes[1].owns
    assert evaluation(one) == evaluation(two)
    assert "void run_0" in evaluation(one) and "void run_1" not in evaluation(one)
    assert not any("kAlone =" in text for text in (one, two))  # as in PlainSettings
    assert "kAlone = false" in text_of(plan_of(MODEL, 2))


def test_its_head_and_its_drawing_say_who_idles() -> None:
    assert "// program   2 processes, one of them used" in text_of(plan(2))
    assert "process 1: nothing" in text_of(plan(2))
    schedule, program = best_schedule(MODEL, 2, PROFILE), priced_program(plan(2))
    picture = draw(schedule, Topology.of(MODEL), program, PROFILE, "arm")
    assert "one of them used" in picture


def test_answers_do_not_differ_from_one_process(
    solver: Solver, builder: Builder, tmp_path: Path
) -> None:
    states = random_states(MODEL, 3, 7)
    found = solver.solve(MODEL, states, tmp_path)
    alone = builder.solver(plan(1)).solve(MODEL, states, tmp_path)
    np.testing.assert_array_equal(found, alone)
    assert solver.error(MODEL, states, tmp_path) < ROUNDING["double"]


@pytest.mark.parametrize("words", [(), ("--stretches",), ("--channel", "message")])
def test_it_is_checked_and_timed(solver: Solver, words: tuple[str, ...]) -> None:
    done = solver.run("--check", "--time", "--repeat", "2", "--json", *words)
    assert (done.status, done.stderr) == (0, "")
    said = json.loads(done.stdout)
    assert (said["channel"], said["check"]["ok"]) == ("none", True)
    assert 0 < said["time"]["in_place"]["min_ns"] <= said["time"]["in_place"]["median_ns"]
    assert said["time"]["through_root"]["min_ns"] > 0


def test_its_trace_begins_with_the_one_that_works(solver: Solver, tmp_path: Path) -> None:
    done = solver.run("--trace", tmp_path / "t.json", "--repeat", "1")
    assert (done.status, done.stderr) == (0, "")
    stages = json.loads((tmp_path / "t.json").read_text())["stages"]
    assert {stage["process"] for stage in stages} == {0}
    assert stages[0]["start_ns"] == 0


def test_it_simulates(solver: Solver, tmp_path: Path) -> None:
    path = tmp_path / "motion.csv"
    done = solver.run("--simulate", "0.01", "--trajectory", path)
    assert done.status == 0
    assert len(path.read_text().splitlines()) == 12


def test_all_processes_end_with_a_failure(solver: Solver, tmp_path: Path) -> None:
    states = random_states(MODEL, 2, 3)
    states.tau[1, 0] = 1e308
    write_states(states, MODEL, tmp_path / "states.json")
    done = solver.run("--states", tmp_path / "states.json")
    assert done.status == 1
    assert "state 2: " in done.stderr and "not a finite number" in done.stderr
