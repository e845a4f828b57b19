"""Starts P processes, waits for them up to a time limit, and reports how they ended."""

from __future__ import annotations

import ctypes
import os
import re
import selectors
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from adagen.build.toolchain import Toolchain
from adagen.errors import EnvironmentFault, printable
from adagen.run.noise import framed_notice, without_launcher_noise

_GRACE_SECONDS = 2.0
_AFTER_THE_LAST_WORD = 3.0
"""Seconds that a launcher has once a process has given up on another.

mpiexec ends all others then, but waits for ever for a host that is out of reach."""
_LAST_WORD = re.compile(rb"(?:^|\0)error: (?:process \d+: |MPI did not start)", re.MULTILINE)
_LOOK_SECONDS = 0.2  # between looks whether a launcher has ended whose pipes others hold open
_OPEN_MPI = ("--oversubscribe", "--bind-to", "none")
_PR_SET_PDEATHSIG = 1


@dataclass(frozen=True)
class Completed:
    """A run that ended by itself.

    Attributes:
        status: 0 done, 1 the input is at fault, 2 usage, 3 fault.
        stdout: what was written there ("" where it was passed through).
        stderr: the processes' own lines there, without the launcher's; where they printed nothing
            although the run failed, one line that says what is known.
    """

    status: int
    stdout: str
    stderr: str

    @property
    def printed(self) -> str:
        """What it printed.

        Raises:
            EnvironmentFault: it failed; the message is its own.
        """
        if self.status != 0:
            raise EnvironmentFault(self.stderr.strip().removeprefix("error: "))
        return self.stdout


def cores() -> int:
    """Return how many cores this process may use."""
    found = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return found or 1


def launch(
    executable: Path,
    processes: int,
    arguments: Sequence[str],
    toolchain: Toolchain,
    timeout: float | None = None,
    *,
    capture: bool = True,
) -> Completed:
    """Run an emitted executable on ``processes`` processes: of this machine, or of mpiexec's hosts.

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
    with ExitStack() as kept:
        variables = toolchain.variables(os.environ)
        if processes > 1:  # one needs no launcher
            command = [*toolchain.mpiexec, "-n", str(processes), *_options(toolchain), *command]
            variables["TMPDIR"] = kept.enter_context(_folder_of_launcher())
        return _ended(command, variables, executable, processes, toolchain, timeout, capture)


def _folder_of_launcher() -> TemporaryDirectory[str]:
    """Return a folder for what mpiexec keeps of a run; it goes with the run.

    Open MPI names that by the number of its process and leaves it behind where it is killed. An
    mpiexec that later gets the same number does not start ("The PMIx server's listener thread
    failed to start").
    """
    try:
        return TemporaryDirectory(prefix="adagen-run-", ignore_cleanup_errors=True)
    except OSError as error:
        raise EnvironmentFault(f"cannot make a temporary folder: {error}") from None


def _ended(
    command: Sequence[str],
    variables: Mapping[str, str],
    executable: Path,
    processes: int,
    toolchain: Toolchain,
    timeout: float | None,
    capture: bool,
) -> Completed:
    """Run a command and return how it ended, as ``launch`` does."""
    try:
        child = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE if capture else None,
            stderr=subprocess.PIPE,
            env=variables,
            start_new_session=True,
            preexec_fn=_die_with_parent(),
        )
    except OSError as error:
        raise EnvironmentFault(f"cannot run {command[0]}: {error.strerror}") from None
    try:
        stdout, stderr = _heard(child, timeout)
    except subprocess.TimeoutExpired as late:
        text, notice = without_launcher_noise((late.stderr or b"").decode(errors="replace"))
        last = printable((text.splitlines() or [notice])[-1])
        raise EnvironmentFault(
            f"no answer within {timeout:g} s from {executable.name} on {processes} "
            f"process{'es' if processes > 1 else ''}; it was ended"
            + (last and f" (output: {last})")
        ) from None
    finally:
        _end_session(child)
    done = _completed(child.returncode, stdout, stderr, executable)
    if capture and done.status == 0 and "--json" in command and not done.stdout:
        words = f"error: {executable.name} failed: {toolchain.mpiexec[0]} ended without an answer"
        return Completed(3, "", words)  # a host was lost: Open MPI's status is 0 then
    return done


def _heard(child: subprocess.Popen[bytes], timeout: float | None) -> tuple[str, str]:
    """Return the output of a launcher and its processes, once it has ended or timed out.

    Raises:
        subprocess.TimeoutExpired: the time is up.
    """
    out, err = bytearray(), bytearray()
    end = _Limit(timeout)
    last = _Limit(None)  # for the launcher, once a process has given up on another
    with selectors.DefaultSelector() as pipes:
        for pipe, text in ((child.stdout, out), (child.stderr, err)):
            if pipe is not None:
                pipes.register(pipe, selectors.EVENT_READ, text)
        while pipes.get_map() and not last.over():
            ended = child.poll() is not None
            found = pipes.select(_LOOK_SECONDS)
            for key, _ in found:
                read = os.read(key.fd, 1 << 16)
                key.data.extend(read)
                if not read:
                    pipes.unregister(key.fileobj)
            if last.seconds is None and _LAST_WORD.search(err):
                last = _Limit(_AFTER_THE_LAST_WORD)
            if ended and not found:  # others hold its pipes open
                break
            if end.over():
                raise subprocess.TimeoutExpired(child.args, timeout or 0, stderr=bytes(err))
    if last.seconds is None:
        child.wait(end.left())
    else:
        with suppress(subprocess.TimeoutExpired):
            child.wait(last.left())
    return out.decode(errors="replace"), err.decode(errors="replace")


class _Limit:
    """So many seconds from now; None for no limit."""

    def __init__(self, seconds: float | None) -> None:
        self.seconds = seconds
        self._began = time.monotonic()

    def left(self) -> float | None:
        if self.seconds is None:
            return None
        return max(0.0, self._began + self.seconds - time.monotonic())

    def over(self) -> bool:
        return self.left() == 0


def _completed(status: int, stdout: str, stderr: str, executable: Path) -> Completed:
    own, notice = without_launcher_noise(stderr)
    if lost := framed_notice(stdout):  # of a host that is gone, and mpiexec's status is 0
        status, stdout, notice = 3, "", notice or lost
    if status in (0, 1, 2, 3) and (own or status == 0):
        return Completed(status, stdout, own)
    if _LAST_WORD.search(own.encode()):
        return Completed(3, stdout, own)  # and mpiexec had to be ended
    number = -status if status < 0 else status - 128
    if status < 0 or status > 128:
        with suppress(ValueError):
            fault = signal.Signals(number)
            own = "\n".join(
                [*own.splitlines(), f"error: a process of {executable.name} died ({fault.name})"]
            )
    if "error:" not in own:
        failure = printable(notice)[:300] or f"no output (status {status})"
        own = "\n".join([*own.splitlines(), f"error: {executable.name} failed: {failure}"])
    return Completed(status if status in (1, 2) else 3, stdout, own)


def _options(toolchain: Toolchain) -> tuple[str, ...]:
    """Return the options for more processes than cores, not bound to any: those of Open MPI."""
    if toolchain.wheel:
        return _OPEN_MPI
    try:
        version = subprocess.run(
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
    is_open_mpi = any(word in version.stdout + version.stderr for word in ("Open MPI", "OpenRTE"))
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


def _end_session(child: subprocess.Popen[bytes]) -> None:
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


@contextmanager
def fresh_copy(executable: Path) -> Iterator[Path]:
    """Lend a copy of a program.

    Where in memory a file's pages lie decides how its code shares caches, for as long as the file
    is kept in memory: small solvers differ by a third. Copies lie elsewhere each time.
    """
    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        copy = Path(folder, executable.name)
        shutil.copy2(executable, copy)
        yield copy
