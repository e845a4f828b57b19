"""One robot on processes that share memory with some others, or with none."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.states import random_states
from tests.emitted import Builder, forward_error, truth_of
from tests.end_to_end.hosts import APART
from tests.golden.examples import EXAMPLES
from tests.golden.test_built import built
from tests.slow import slow

BY_STEM = {example.stem: example for example in EXAMPLES}


@pytest.mark.parametrize(
    ("stem", "hosts", "channel"),
    [
        slow("arm7_p2", 1, "window"),
        ("arm7_p2", 2, "message"),
        ("arm7_unrolled_p2", 2, "message"),
        ("human40_p4", 1, "window"),
        ("human40_p4", 2, "mixed"),
        ("human40_p4", 4, "message"),
        slow("chain16_p3", 2, "mixed"),
        ("mobile_p3", 2, "window"),  # process 2, alone on its host, has nothing to do
    ],
)
def test_processes_of_one_host_meet_in_a_window_others_by_messages(
    stem: str, hosts: int, channel: str, builder: Builder, tmp_path: Path
) -> None:
    solver, model = built(BY_STEM[stem], builder), BY_STEM[stem].model()
    words = ("--hosts", str(hosts), "--channel", "auto")
    states = random_states(model, 3, seed=8)
    found = solver.solve(model, states, tmp_path, *words)
    assert np.array_equal(found, solver.solve(model, states, tmp_path, "--channel", "message"))
    assert forward_error(found, truth_of(model, states)) < 5e-12
    done = solver.run("--check", "--time", "--repeat", "2", "--json", *words)
    assert (done.status, done.stderr) == (0, "")
    assert json.loads(done.stdout)["channel"] == channel


@pytest.mark.parametrize("apart", APART)
@pytest.mark.parametrize("stem", ["arm7_p2", "arm7_batch_p2", slow("humanoid_p3"), "human40_p4"])
def test_the_answer_does_not_depend_on_what_processes_share(
    apart: str, stem: str, builder: Builder
) -> None:
    solver = built(BY_STEM[stem], builder)
    environment = (*solver.toolchain.environment, *APART[apart])
    far = replace(solver, toolchain=replace(solver.toolchain, environment=environment))
    words = ("--check", "--time", "--repeat", "1", "--json")
    near_told, far_told = (json.loads(one.run(*words).stdout) for one in (solver, far))
    assert near_told["check"] == far_told["check"]
    assert far_told["check"]["ok"]


def test_a_window_is_refused_where_memory_is_not_shared(builder: Builder) -> None:
    solver = built(BY_STEM["human40_p4"], builder)
    done = solver.run("--channel", "window", "--hosts", "2", "--check")
    assert (done.status, done.stderr) == (
        3,
        "error: channel window: not all processes are on one node",
    )


@pytest.mark.parametrize("hosts", ["0", "5", "1.5"])
def test_hosts_are_at_most_as_many_as_processes(hosts: str, builder: Builder) -> None:
    done = built(BY_STEM["human40_p4"], builder).run("--hosts", hosts)
    assert done.status == 2
    assert "--hosts takes a whole number from 1 to 4, that of processes" in done.stderr
