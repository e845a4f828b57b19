"""Starting P processes, waiting for them for a bounded time, and saying what became of them."""

from __future__ import annotations

import ctypes
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from adagen.build.toolchain import Toolchain
from adagen.errors import EnvironmentFault, printable
from adagen.run.noise import without_launcher_noise

_GRACE_SECONDS = 2.0
_OPEN_MPI = ("--oversubscribe", "--bind-to", "none")
_PR_SET_PDEATHSIG = 1


@dataclass(frozen=True)
class Completed:
    """A run that ended by itself.

    Attributes:
        status: 0 done, 1 the input is at fault, 2 usage, 3 fault.
        stdout: what was written there ("" where it was passed through).
        stderr: the processes' own lines there, without the launcher's; where they said nothing
            although the run failed, one line that says what is known.
    """

    status: int
    stdout: str
    stderr: str


def launch(
    executable: Path,
    processes: int,
    arguments: Sequence[str],
    toolchain: Toolchain,
    timeout: float | None = None,
    *,
    capture: bool = True,
) -> Completed:
    """Run an emitted executable on ``processes`` processes of this machine.

    Args:
        executable: what to run.
        processes: how many, at least 1; more than there are cores is fine.
        arguments: its command line.
        toolchain: whose mpiexec to use.
        timeout: seconds until the run is ended by force; None for no limit.
        capture: whether stdout is returned; otherwise it goes to this process's own.

    Returns:
        How it ended.

    Raises:
        EnvironmentFault: mpiexec or the program cannot be started, or the time is up.
    """
    command = [str(executable.resolve()), *arguments]
    if processes > 1:  # one needs no launcher
        command = [*toolchain.mpiexec, "-n", str(processes), *_options(toolchain), *command]
    try:
        child = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE if capture else None,
            stderr=subprocess.PIPE,
            text=True,
            errors="replace",
            env=toolchain.variables(os.environ),
            start_new_session=True,
            preexec_fn=_die_with_parent(),
        )
    except OSError as error:
        raise EnvironmentFault(f"cannot run {command[0]}: {error.strerror}") from None
    try:
        stdout, stderr = child.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        raise EnvironmentFault(
            f"no answer within {timeout:g} s from {executable.name} on {processes} "
            f"process{'es' if processes > 1 else ''}; it was ended"
        ) from None
    finally:
        _end_session(child)
    return _completed(child.returncode, stdout or "", stderr or "", executable)


def _completed(status: int, stdout: str, stderr: str, executable: Path) -> Completed:
    own, notice = without_launcher_noise(stderr)
    if status in (0, 1, 2, 3) and (own or status == 0):
        return Completed(status, stdout, own)
    number = -status if status < 0 else status - 128
    if status < 0 or status > 128:
        with suppress(ValueError):
            fault = signal.Signals(number)
            own = "\n".join(
                [*own.splitlines(), f"error: a process of {executable.name} died ({fault.name})"]
            )
    if "error:" not in own:
        said = printable(notice)[:300] or f"it said nothing (status {status})"
        own = "\n".join([*own.splitlines(), f"error: {executable.name} failed: {said}"])
    return Completed(status if status in (1, 2) else 3, stdout, own)


def _options(toolchain: Toolchain) -> tuple[str, ...]:
    """Return the options for more processes than cores, not bound to any: those of Open MPI."""
    if toolchain.wheel:
        return _OPEN_MPI
    try:
        said = subprocess.run(
            [*toolchain.mpiexec, "--version"],
            capture_output=True,
            text=True,
            errors="replace",
            check=False,
            stdin=subprocess.DEVNULL,
            env=toolchain.variables(os.environ),
        )
    except OSError as error:
        raise EnvironmentFault(f"cannot run {toolchain.mpiexec[0]}: {error.strerror}") from None
    is_open_mpi = any(word in said.stdout + said.stderr for word in ("Open MPI", "OpenRTE"))
    return _OPEN_MPI if is_open_mpi else ()


def _die_with_parent() -> Callable[[], None] | None:
    """Return what makes the launcher end when this process is killed (Linux only)."""
    if not sys.platform.startswith("linux"):
        return None
    try:
        prctl = ctypes.CDLL(None).prctl
    except (OSError, AttributeError):
        return None

    def ask() -> None:
        prctl(_PR_SET_PDEATHSIG, int(signal.SIGTERM), 0, 0, 0)

    return ask


def _end_session(child: subprocess.Popen[str]) -> None:
    """End the launcher and all it started, if anything is left: kindly, then by force."""
    if child.poll() is None:
        with suppress(OSError):
            child.terminate()  # mpiexec ends its processes and cleans up
        with suppress(subprocess.TimeoutExpired):
            child.wait(_GRACE_SECONDS)
    deadline = time.monotonic() + _GRACE_SECONDS
    while (left := _session_members(child.pid)) and time.monotonic() < deadline:
        for pid in left:
            with suppress(OSError):
                os.kill(pid, signal.SIGKILL)
        time.sleep(0.01)
    if child.poll() is None:
        with suppress(OSError):
            os.killpg(child.pid, signal.SIGKILL)
        child.wait()
    for stream in (child.stdout, child.stderr):
        if stream is not None:
            stream.close()


def _session_members(session: int) -> list[int]:
    """Return the live processes of a session made here (mpiexec makes new groups within it)."""
    members = []
    for folder in Path("/proc").glob("[0-9]*"):
        with suppress(OSError, ValueError, IndexError):
            # After the name, which may hold anything: state, parent, group, session.
            fields = (folder / "stat").read_text(errors="replace").rpartition(")")[2].split()
            if int(fields[3]) == session and fields[0] != "Z":
                members.append(int(folder.name))
    return sorted(members)
