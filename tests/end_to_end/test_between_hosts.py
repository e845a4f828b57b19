"""Solvers on several hosts: namespaces of this machine with a network between them."""

from __future__ import annotations

import json
import os
import signal
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.run import Completed
from adagen.states import random_states, read_result, write_states
from tests.emitted import Builder, Solver, forward_error, truth_of
from tests.golden.examples import EXAMPLES
from tests.golden.test_built import built
from tests.network import Network, network, why_no_hosts
from tests.running import running

BY_STEM = {example.stem: example for example in EXAMPLES}
WHY_NOT = why_no_hosts()
pytestmark = pytest.mark.skipif(bool(WHY_NOT), reason=WHY_NOT)


def slow(*values: object) -> object:
    """Return a case that only the slow tests have."""
    return pytest.param(*values, marks=pytest.mark.slow)


@pytest.fixture(scope="module", params=[2, 4], ids=["two hosts", "four hosts"])
def hosts(
    request: pytest.FixtureRequest, builder: Builder, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Network]:
    with network(request.param, builder.toolchain, tmp_path_factory.mktemp("hosts")) as made:
        yield made


@pytest.fixture
def pair(builder: Builder, tmp_path: Path) -> Iterator[Network]:
    with network(2, builder.toolchain, tmp_path) as made:
        yield made


def on(net: Network, stem: str, builder: Builder) -> Solver:
    """Return a built example that runs on all hosts, in equal parts."""
    solver = built(BY_STEM[stem], builder)
    slots = -(-solver.processes // net.hosts)
    return replace(solver, toolchain=net.toolchain(solver.toolchain, slots))


@pytest.mark.parametrize(
    ("stem", "delay"),
    [
        ("human40_p4", 20),
        ("arm7_batch_p2", 0),
        *(slow("human40_p4", delay) for delay in (0, 100)),
        *(slow("arm7_batch_p2", delay) for delay in (20, 100)),
        *(slow("arm7_p2", delay) for delay in (0, 20, 100)),
    ],
)
def test_answers_are_those_of_one_host(
    stem: str, delay: int, hosts: Network, builder: Builder, tmp_path: Path
) -> None:
    hosts.delay(delay)
    solver, model = on(hosts, stem, builder), BY_STEM[stem].model()
    states = random_states(model, 12, seed=delay)
    given, result = tmp_path / "given.json", tmp_path / "found.json"
    write_states(states, model, given)
    done = solver.run("--states", given, "--result", result, "--json")
    assert (done.status, done.stderr) == (0, "")
    far = "mixed" if (stem, hosts.hosts) == ("human40_p4", 2) else "message"
    assert json.loads(done.stdout)["channel"] == far
    found = read_result(result, model)
    assert np.array_equal(found, built(BY_STEM[stem], builder).solve(model, states, tmp_path))
    assert forward_error(found, truth_of(model, states)) < 5e-12


@pytest.mark.parametrize("delay", [slow(0), 100])
def test_nothing_is_faster_than_the_cable(delay: int, pair: Network, builder: Builder) -> None:
    pair.delay(delay)
    done = on(pair, "arm7_p2", builder).run("--time", "--repeat", "1", "--json")
    assert (done.status, done.stderr) == (0, "")
    there_and_back = json.loads(done.stdout)["time"]["in_place"]["min_ns"]
    assert there_and_back > 2e3 * delay
    assert there_and_back > 2e3  # through common memory a tenth of that


@pytest.mark.parametrize("stem", [slow("human40_p4"), "arm7_batch_p2"])
def test_what_a_network_loses_is_sent_again(
    stem: str, pair: Network, builder: Builder, tmp_path: Path
) -> None:
    pair.loss(0.02)
    solver, model = on(pair, stem, builder), BY_STEM[stem].model()
    states = random_states(model, 60, seed=3)
    found = solver.solve(model, states, tmp_path)
    assert np.array_equal(found, built(BY_STEM[stem], builder).solve(model, states, tmp_path))


def dies(net: Network) -> None:
    net.cut(2)  # its kernel does not say farewell
    net.signal(2, signal.SIGKILL)


def loses_its_processes(net: Network) -> None:
    net.signal(2, signal.SIGKILL)


def stalls(net: Network) -> None:
    net.signal(2, signal.SIGSTOP)


def loses_its_cable(net: Network) -> None:
    net.cut(2)


@pytest.mark.parametrize(
    ("stem", "event"),
    [
        ("arm7_p2", loses_its_cable),
        *(slow("arm7_p2", event) for event in (dies, loses_its_processes, stalls)),
        *(slow("arm7_batch_p2", event) for event in (dies, loses_its_processes, loses_its_cable)),
        slow("arm7_batch_p2", stalls),
    ],
)
def test_a_lost_host_is_an_error_within_the_time_limit(
    stem: str, event: Callable[[Network], None], pair: Network, builder: Builder
) -> None:
    solver = on(pair, stem, builder)
    words = ("--time", "--repeat", "1000000", "--json", "--timeout", "5")
    done, seconds = during(solver, words, lambda: event(pair), at_work)
    assert (done.status, done.stdout) == (3, "")
    (line,) = done.stderr.splitlines()
    assert line.startswith("error: ")
    # The limit, a second for whoever says it better, three for mpiexec, and a busy machine.
    assert seconds < 30
    assert solver_processes(pair, 1, solver) == []
    if event is not stalls:
        wait_until(lambda: solver_processes(pair, 2, solver) == [])


@pytest.mark.slow
def test_a_host_that_is_lost_while_mpi_starts_is_an_error(pair: Network, builder: Builder) -> None:
    solver = on(pair, "arm7_p2", builder)
    words = ("--time", "--repeat", "1000000", "--json", "--timeout", "1")
    done, seconds = during(solver, words, lambda: pair.cut(2), is_there)
    assert (done.status, done.stdout) == (3, "")
    assert done.stderr.startswith("error: ")
    assert seconds < 45  # eleven for MPI to start, three for mpiexec


@pytest.mark.parametrize("stem", ["arm7_p2", slow("arm7_batch_p2")])
@pytest.mark.parametrize("what", [slow("stall"), slow("cut")])
def test_a_host_that_comes_back_in_time_is_waited_for(
    what: str, stem: str, pair: Network, builder: Builder
) -> None:
    def comes_back() -> None:
        pair.signal(2, signal.SIGSTOP) if what == "stall" else pair.cut(2)
        time.sleep(1)
        pair.signal(2, signal.SIGCONT) if what == "stall" else pair.mend(2)

    repeat = {"arm7_p2": "60", "arm7_batch_p2": "2000"}[stem]
    words = ("--time", "--repeat", repeat, "--json", "--timeout", "30")
    done, _ = during(on(pair, stem, builder), words, comes_back, at_work)
    assert (done.status, done.stderr) == (0, "")


def during(
    solver: Solver,
    words: tuple[str, ...],
    event: Callable[[], None],
    when: Callable[[Solver], bool],
) -> tuple[Completed, float]:
    """Return how a run ends in the midst of which something happens, and how long after that."""
    with ThreadPoolExecutor(1) as pool:
        run = pool.submit(solver.run, *words, timeout=100)
        wait_until(lambda: run.done() or when(solver))
        assert not run.done(), run.result()
        event()
        began = time.monotonic()
        return run.result(), time.monotonic() - began


def is_there(solver: Solver) -> bool:
    """Tell whether all processes have been started."""
    return len(running(solver.executable)) == solver.processes


def at_work(solver: Solver) -> bool:
    """Tell whether all processes have computed for longer than MPI takes to start."""
    tick = os.sysconf("SC_CLK_TCK")
    seconds = []
    for pid in running(solver.executable):
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        seconds.append((int(fields[11]) + int(fields[12])) / tick)
    return len(seconds) == solver.processes and min(seconds) > 0.7


def solver_processes(net: Network, host: int, solver: Solver) -> list[int]:
    """Return the solver's processes on a host."""
    return sorted(set(net.processes(host)) & set(running(solver.executable)))


def wait_until(true: Callable[[], bool], limit: float = 60) -> None:
    end = time.monotonic() + limit
    while not true():
        assert time.monotonic() < end
        time.sleep(0.02)
