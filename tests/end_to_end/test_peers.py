"""What an emitted program does when its peers are gone, or its machine is small."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from adagen.run import without_launcher_noise
from tests.emitted import cores
from tests.end_to_end.subjects import Subject
from tests.running import running
from tests.slow import slow


class TestPeers:
    """A process that dies or stops ends the run; nothing outlives it."""

    @pytest.fixture
    def started(self) -> Iterator[Callable[..., subprocess.Popen[str]]]:
        children: list[tuple[subprocess.Popen[str], Path]] = []

        def start(who: Subject, *words: str) -> subprocess.Popen[str]:
            toolchain, copy = who.solver.toolchain, copy_of(who)
            shutil.copy(who.solver.executable, copy)
            ranks = str(who.solver.processes)
            command = [*toolchain.mpiexec, "-n", ranks, "--oversubscribe", "--bind-to", "none"]
            child = subprocess.Popen(
                [*command, str(copy), *words],
                env=toolchain.variables(os.environ),
                stdout=subprocess.DEVNULL,
                stderr=subprocess.PIPE,
                text=True,
                errors="replace",
            )
            children.append((child, copy))
            return child

        yield start
        for child, copy in children:
            for pid in running(copy):
                os.kill(pid, signal.SIGKILL)
            if child.poll() is None:
                child.kill()
            child.wait()
            assert child.stderr is not None
            child.stderr.close()

    @pytest.mark.parametrize(
        ("rank", "number", "channel"),
        [
            slow(0, signal.SIGKILL, "window"),
            (2, signal.SIGKILL, "message"),
            slow(0, signal.SIGSTOP, "message"),
            (2, signal.SIGSTOP, "window"),
            slow(2, signal.SIGKILL, "window"),
            slow(0, signal.SIGKILL, "message"),
            slow(2, signal.SIGSTOP, "message"),
            slow(0, signal.SIGSTOP, "window"),
        ],
    )
    def test_a_peer_that_is_gone_ends_the_run(
        self,
        channel: str,
        number: signal.Signals,
        rank: int,
        human: Subject,
        started: Callable[..., subprocess.Popen[str]],
    ) -> None:
        words = ("--simulate", "1000", "--step", "1e-6", "--timeout", "5", "--channel", channel)
        child = started(human, *words)  # takes hours
        victim = wait_for(lambda: running_ranks(human).get(rank))
        ranks = running_ranks(human).values()
        wait_for(lambda: all(spent(pid) > _PAST_THE_START for pid in ranks), limit=120)
        assert child.poll() is None
        os.kill(victim, number)
        start = time.monotonic()
        said = child.communicate(timeout=60)[1]
        assert time.monotonic() - start < 30
        assert child.returncode != 0
        if number == signal.SIGSTOP:
            assert child.returncode == 3
            lines = without_launcher_noise(said)[0].splitlines()
            own = [line for line in lines if not line.startswith("simulating")]
            assert own and all("did not answer within the time limit" in line for line in own)
        wait_for(lambda: not running(copy_of(human)))

    def test_a_computer_that_sleeps_does_not_end_the_run(
        self, arm: Subject, started: Callable[..., subprocess.Popen[str]]
    ) -> None:
        """All processes stand still for longer than any may wait for another."""
        child = started(arm, "--simulate", "1000", "--step", "1e-6", "--timeout", "4")
        ranks = list(wait_for(lambda: running_ranks(arm)).values())
        wait_for(lambda: all(spent(pid) > _PAST_THE_START for pid in ranks), limit=120)
        for pid in ranks:
            os.kill(pid, signal.SIGSTOP)
        time.sleep(5)
        before = [spent(pid) for pid in ranks]
        for pid in ranks:
            os.kill(pid, signal.SIGCONT)
        wait_for(
            lambda: all(spent(pid) > past + 0.3 for pid, past in zip(ranks, before, strict=True)),
            limit=120,
        )
        assert child.poll() is None
        child.kill()


class TestMachine:
    def test_more_processes_than_cores_finish(self, human: Subject) -> None:
        done = human.solver.run("--check", "--time", "--repeat", "2", "--timeout", "20")
        assert (done.status, done.stderr) == (0, "")

    @pytest.mark.skipif(shutil.which("taskset") is None, reason="taskset is not installed")
    @pytest.mark.parametrize("channel", ["window", "message"])
    def test_all_processes_on_one_core_finish(self, channel: str, human: Subject) -> None:
        allowed = os.sched_getaffinity(0)
        try:
            os.sched_setaffinity(0, {min(allowed)})  # what is started here inherits it
            done = human.solver.run("--json", "--repeat", "1", "--channel", channel)
        finally:
            os.sched_setaffinity(0, allowed)
        assert (done.status, done.stderr) == (0, "")
        assert json.loads(done.stdout)["time"]["pinned"] is False

    def test_pinning_can_be_left_out(self, arm: Subject) -> None:
        words = ("--time", "--repeat", "1", "--json")
        assert json.loads(arm.solver.run(*words, "--no-pin").stdout)["time"]["pinned"] is False
        if cores() >= 2:
            assert json.loads(arm.solver.run(*words).stdout)["time"]["pinned"] is True


def copy_of(who: Subject) -> Path:
    """Return where a subject's program is copied to, so that its processes differ from others'."""
    return who.folder / f"{who.solver.executable.name}_copy"


_PAST_THE_START = 0.7
"""Seconds of the processor: MPI starts with fewer, and who waits for another spins."""


def spent(process: int) -> float:
    """Return the processor's seconds that a process has taken."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def running_ranks(who: Subject) -> dict[int, int]:
    """Return rank to process of a run, once all have their rank."""
    ranks = {}
    for pid in running(copy_of(who)):
        try:
            variables = Path(f"/proc/{pid}/environ").read_bytes().split(b"\0")
        except OSError:
            continue
        for variable in variables:
            name, _, value = variable.partition(b"=")
            if name == b"OMPI_COMM_WORLD_RANK":
                ranks[int(value)] = pid
    return ranks if len(ranks) == who.solver.processes else {}


def wait_for(condition: Callable[[], Any], limit: float = 30.0) -> Any:
    deadline = time.monotonic() + limit
    while not (value := condition()):
        assert time.monotonic() < deadline, "it did not happen in time"
        time.sleep(0.05)
    return value
