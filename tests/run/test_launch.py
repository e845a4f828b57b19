"""Runs under mpiexec: how they end and what is said."""

from __future__ import annotations

import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import pytest

from adagen.build import Toolchain, build_executable, find_toolchain
from adagen.errors import EnvironmentFault
from adagen.run import launch, without_launcher_noise
from tests.running import running

SOURCE = r"""
#include <mpi.h>
#include <signal.h>
#include <unistd.h>
#include <cstdio>
#include <cstdlib>
#include <string>
int main(int count, char** words) {
  MPI_Init(&count, &words);
  int rank, size;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  void* place;
  MPI_Win window;
  MPI_Win_allocate_shared(4096, 1, MPI_INFO_NULL, MPI_COMM_WORLD, &place, &window);
  const std::string mode = count > 1 ? words[1] : "fine";
  if (mode == "status") {
    if (rank == 0 && count > 3) std::fprintf(stderr, "%s\n", words[3]);
    MPI_Finalize();
    return std::atoi(words[2]);
  }
  if (mode == "abort") {
    if (rank == 0) {
      std::fprintf(stderr, "error: elbow: factorization failed\n");
      MPI_Abort(MPI_COMM_WORLD, 3);
    }
    sleep(100);
  }
  if (mode == "die") {
    if (rank == size - 1) raise(std::atoi(words[2]));
    sleep(100);
  }
  if (mode == "hang") {
    if (rank == 0) std::fprintf(stderr, "pid %d\n", getpid());
    signal(SIGTERM, SIG_IGN);
    for (;;) sleep(100);
  }
  if (rank == 0) std::printf("%d processes, %s\n", size, count > 2 ? words[2] : "");
  MPI_Win_free(&window);
  MPI_Finalize();
}
"""


@pytest.fixture(scope="session")
def toolchain() -> Toolchain:
    return find_toolchain()


@pytest.fixture(scope="session")
def program(toolchain: Toolchain, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build_executable(SOURCE, "program", toolchain, tmp_path_factory.mktemp("cache"))


@pytest.mark.parametrize("processes", [1, 2, 5])
def test_a_run_that_works_is_silent(program: Path, toolchain: Toolchain, processes: int) -> None:
    done = launch(program, processes, ["fine", "a b"], toolchain, 60)
    assert (done.status, done.stdout) == (0, f"{processes} processes, a b\n")
    assert done.stderr == ""


@pytest.mark.parametrize("status", [1, 2, 3])
def test_a_status_and_its_line_arrive_alone(
    program: Path, toolchain: Toolchain, status: int
) -> None:
    line = "states.json: error: joint elbow: q is not finite"
    done = launch(program, 2, ["status", str(status), line], toolchain, 60)
    assert (done.status, done.stderr) == (status, line)


@pytest.mark.parametrize(("status", "told"), [(3, 3), (1, 1), (77, 3)])
def test_a_failure_without_a_word_gets_one(
    program: Path, toolchain: Toolchain, status: int, told: int
) -> None:
    done = launch(program, 2, ["status", str(status)], toolchain, 60)
    assert done.status == told
    assert done.stderr.startswith("error: program failed: ")
    assert "\n" not in done.stderr


def test_an_abort_ends_all_and_its_line_arrives_alone(program: Path, toolchain: Toolchain) -> None:
    start = time.monotonic()
    done = launch(program, 2, ["abort"], toolchain, 60)
    assert (done.status, done.stderr) == (3, "error: elbow: factorization failed")
    assert time.monotonic() - start < 30


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGSEGV, signal.SIGFPE])
def test_a_process_that_dies_ends_the_run(
    program: Path, toolchain: Toolchain, number: signal.Signals
) -> None:
    done = launch(program, 2, ["die", str(int(number))], toolchain, 60)
    assert done.status == 3
    assert done.stderr == f"error: a process of program died ({number.name})"


def test_a_run_that_never_ends_is_ended_with_all_its_processes(
    program: Path, toolchain: Toolchain
) -> None:
    start = time.monotonic()
    with pytest.raises(EnvironmentFault, match=r"no answer within 3 s from program on 2 processes"):
        launch(program, 2, ["hang"], toolchain, 3)
    assert time.monotonic() - start < 15
    assert not running(program)


def test_no_run_finds_what_another_one_left(
    program: Path, toolchain: Toolchain, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An mpiexec does not start where files of a killed one with its own number are left."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    tells = made_up_launcher(tmp_path, toolchain, 'echo "$TMPDIR"; kill -9 $$')
    own = [launch(Path("program"), 2, [], tells, 60).stdout.strip() for _ in range(2)]
    assert own[0] != own[1] and {Path(folder).parent for folder in own} == {tmp_path}
    (tmp_path / "mpiexec").unlink()
    assert launch(program, 2, [], toolchain, 60).status == 0
    with pytest.raises(EnvironmentFault, match="no answer within 2 s"):
        launch(program, 2, ["hang"], toolchain, 2)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="prctl is Linux's")
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL])
def test_nothing_outlives_a_caller_that_is_ended(
    program: Path, number: signal.Signals, tmp_path: Path
) -> None:
    copy = tmp_path / "copy"
    copy.write_bytes(program.read_bytes())
    copy.chmod(0o755)
    code = (
        "import sys; from pathlib import Path; from adagen.build import find_toolchain;"
        "from adagen.cli.main import _end_by_exception; from adagen.run import launch;"
        "_end_by_exception(); launch(Path(sys.argv[1]), 2, ['hang'], find_toolchain(), 100)"
    )
    caller = subprocess.Popen([sys.executable, "-c", code, copy], stderr=subprocess.DEVNULL)
    wait_until(lambda: len(running(copy)) >= 2)
    caller.send_signal(number)
    assert caller.wait(20) == (128 + number if number == signal.SIGTERM else -number)
    wait_until(lambda: not running(copy))


def test_a_launcher_that_is_not_there_is_told(program: Path, toolchain: Toolchain) -> None:
    for wheel in (True, False):
        with pytest.raises(EnvironmentFault, match="cannot run nowhere/mpiexec"):
            launch(program, 2, [], replace(toolchain, mpiexec=("nowhere/mpiexec",), wheel=wheel))


def test_one_process_needs_no_launcher(toolchain: Toolchain, tmp_path: Path) -> None:
    script = tmp_path / "script"
    script.write_text("#!/bin/sh\necho alone $@\n")
    script.chmod(0o755)
    nowhere = replace(toolchain, mpiexec=("nowhere/mpiexec",))
    assert launch(script, 1, ["x"], nowhere, 10).stdout == "alone x\n"


def test_an_mpi_that_is_not_open_mpi_gets_only_what_all_know(
    toolchain: Toolchain, tmp_path: Path
) -> None:
    script = tmp_path / "mpiexec"
    script.write_text('#!/bin/sh\n[ "$1" = --version ] && echo HYDRA || printf "%s\\n" "$*"\n')
    script.chmod(0o755)
    other = replace(toolchain, mpiexec=(str(script),), wheel=False)
    assert launch(script, 3, ["x"], other, 10).stdout == f"-n 3 {script} x\n"
    script.write_text(script.read_text().replace("HYDRA", "'mpiexec (OpenRTE) 4.1.4'"))
    assert "--oversubscribe --bind-to none" in launch(script, 3, ["x"], other, 10).stdout


def made_up_launcher(folder: Path, toolchain: Toolchain, script: str) -> Toolchain:
    """Return a toolchain whose mpiexec is a shell script."""
    launcher = folder / "mpiexec"
    launcher.write_text(f"#!/bin/sh\n{script}\n")
    launcher.chmod(0o755)
    return replace(toolchain, mpiexec=(str(launcher),), wheel=True)


@pytest.mark.parametrize(
    "last", ["error: process 1: joint x", "\\0error: MPI did not start within 5 s"]
)
def test_a_launcher_that_waits_for_a_lost_host_is_ended(
    last: str, toolchain: Toolchain, tmp_path: Path
) -> None:
    script = f"printf 'warning: w\\n{last}\\n' >&2; sleep 100"
    waits = made_up_launcher(tmp_path, toolchain, script)
    began = time.monotonic()
    done = launch(Path("program"), 2, [], waits, 90)
    assert time.monotonic() - began < 30
    said = last.replace("\\0", "")
    assert (done.status, done.stdout, done.stderr) == (3, "", f"warning: w\n{said}")


def test_a_launcher_that_ends_is_not_waited_for_because_others_hold_its_pipes(
    toolchain: Toolchain, tmp_path: Path
) -> None:
    ends = made_up_launcher(tmp_path, toolchain, "sleep 100 & echo all; exit 1")
    began = time.monotonic()
    done = launch(Path("program"), 2, [], ends, 90)
    assert (done.status, done.stdout) == (1, "all\n")
    assert time.monotonic() - began < 30


def test_a_launcher_that_has_lost_a_host_is_not_taken_at_its_word(
    toolchain: Toolchain, tmp_path: Path
) -> None:
    rule = "-" * 60
    says = f"echo {rule}; echo A daemon failed; echo to report; echo {rule}"
    told = launch(Path("program"), 2, [], made_up_launcher(tmp_path, toolchain, says), 20)
    words = "error: program failed: A daemon failed to report"
    assert (told.status, told.stdout, told.stderr) == (3, "", words)
    silent = made_up_launcher(tmp_path, toolchain, "exit 0")
    assert launch(Path("program"), 2, [], silent, 20).status == 0  # nothing was to be said
    asked = launch(Path("program"), 2, ["--json"], silent, 20)
    assert (asked.status, asked.stdout) == (3, "")
    assert asked.stderr.endswith("mpiexec ended without an answer")


def test_what_was_said_in_time_is_told(toolchain: Toolchain, tmp_path: Path) -> None:
    slow = made_up_launcher(tmp_path, toolchain, "echo 'so far' >&2; sleep 100")
    with pytest.raises(EnvironmentFault, match=r"within 1 s .* \(output: so far\)"):
        launch(Path("program"), 2, [], slow, 1)


def test_noise_is_told_from_the_program_s_words() -> None:
    rule = "-" * 74
    text = (
        f"warning: kept\n{rule}\nprterun detected a failure:\n\n  Exit code: 1\n{rule}\n"
        "[host:123] *** Process received signal ***\nerror: also kept\n"
        "[warn] Epoll MOD(4) on fd 20 failed. Old events were 6: Bad file descriptor\n"
        "[host:00123] 3 more processes have sent help message\n---- a short rule\n"
    )
    own, notice = without_launcher_noise(text)
    assert own.splitlines() == ["warning: kept", "error: also kept", "---- a short rule"]
    assert notice == "prterun detected a failure: Exit code: 1"


def test_a_frame_that_is_not_closed_is_a_notice() -> None:
    assert without_launcher_noise("-" * 74 + "\nno slots\n") == ("", "no slots")
    assert without_launcher_noise("") == ("", "")


def wait_until(condition: object, limit: float = 20) -> None:
    assert callable(condition)
    deadline = time.monotonic() + limit
    while not condition():
        assert time.monotonic() < deadline, "it did not happen in time"
        time.sleep(0.05)
