"""Cache of executables: the same source, compiler, options and Eigen are compiled once."""

from __future__ import annotations

import hashlib
import os
import platform
import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext, suppress
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from adagen.build.processor import told
from adagen.build.toolchain import Toolchain
from adagen.errors import EnvironmentFault, printable

Progress = Callable[[str, int], AbstractContextManager[object]]

KEEP = 256
"""Executables that the cache holds before it drops those unused for longest."""

_UNUSED_SECONDS = 24 * 3600.0
_SAFE_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.+-]{0,150}")


def cache_folder(environ: Mapping[str, str] | None = None) -> Path:
    """Return the folder for executables: ``adagen`` in XDG_CACHE_HOME, by default in ~/.cache."""
    environ = os.environ if environ is None else environ
    base = environ.get("XDG_CACHE_HOME", "")
    # The XDG specification has relative paths ignored.
    folder = Path(base) if base and Path(base).is_absolute() else Path("~/.cache").expanduser()
    return folder / "adagen"


def build_executable(
    source_text: str,
    name: str,
    toolchain: Toolchain,
    cache_dir: Path | None = None,
    progress: Progress | None = None,
) -> Path:
    """Return an executable of ``source_text``, compiled now or found in the cache.

    The runtime's headers are put into it, so that they are part of its content. An emitted solver
    is linked with the program around it, whose object is in the cache, too.

    Safe under concurrent calls: a build happens in a folder of its own that is renamed into place
    whole; of two builds of the same thing one is kept.

    Args:
        source_text: one C++ file.
        name: file name of the executable, letters, digits and ``_.+-`` only.
        toolchain: what to compile with.
        cache_dir: where executables are kept, :func:`cache_folder` by default.
        progress: makes the context in which a compilation runs, from a line that says what it is,
            and the length of the source.

    Raises:
        EnvironmentFault: the compiler failed, is missing, or the cache cannot be written.
    """
    if not _SAFE_NAME.fullmatch(name):
        raise ValueError(f"not a file name for an executable: {name!r}")
    cache = cache_folder() if cache_dir is None else cache_dir
    from adagen.emit.runtime import joined  # takes its time; few need it

    size, source_text = len(source_text), joined(source_text)
    mpi = uses_mpi(source_text)
    around = _around(source_text)
    texts = [source_text, name]
    if around is not None:
        texts += [around.text, *around.options]
    telling = progress or (lambda *_: nullcontext())

    def compile_and_link(work: Path) -> None:
        objects = []
        if around is not None:
            objects = [_program_object(around, mpi, toolchain, cache, telling)]
        source = _written(source_text, work / f"{name}.cpp")
        with telling(f"compiling {name}", size):
            _compile(toolchain.compile_command(source, work / name, mpi, objects), toolchain, work)

    return _entry(cache, _key(texts, toolchain, mpi), name, compile_and_link, os.X_OK)


def kept_text(
    texts: Sequence[str],
    name: str,
    toolchain: Toolchain,
    make: Callable[[], str],
) -> str:
    """Return what was found of some texts on this machine, now or at an earlier time.

    Args:
        texts: all that decides on it, beside compiler, options and processor.
        name: what it is, a file name.
        toolchain: what is compiled with.
        make: finds it.

    Raises:
        EnvironmentFault: the cache cannot be written.
    """

    def write(work: Path) -> None:
        (work / name).write_text(make(), encoding="utf-8")

    key = _key([*texts, name], toolchain, mpi=False)
    return _entry(cache_folder(), key, name, write).read_text(encoding="utf-8")


@dataclass(frozen=True)
class _Around:
    """The program around a solver: its text, and the options that fit it to this one."""

    text: str
    options: tuple[str, ...]


def _around(source_text: str) -> _Around | None:
    """Return the program that a source is to be linked with, or None."""
    from adagen.emit.runtime import joined
    from adagen.emit.solver_program import options_in, program_text

    options = options_in(source_text)
    return None if options is None else _Around(joined(program_text()), options)


def _program_object(
    program: _Around, mpi: bool, toolchain: Toolchain, cache: Path, progress: Progress
) -> Path:
    """Return the program's object, compiled once for all solvers that need it so."""
    name = "adagen_program.o"
    flags = toolchain.program_flags or toolchain.flags
    toolchain = replace(toolchain, flags=flags, program_flags=())  # one object, whatever is around

    def compile_it(work: Path) -> None:
        source = _written(program.text, work / "adagen_program.cpp")
        command = toolchain.object_command(source, work / name, mpi, program.options)
        with progress("compiling adagen_program", len(program.text)):
            _compile(command, toolchain, work)

    key = _key([program.text, name, *program.options], toolchain, mpi)
    return _entry(cache, key, name, compile_it)


def _entry(
    cache: Path, key: str, name: str, make: Callable[[Path], None], access: int = os.R_OK
) -> Path:
    """Return a file of the cache, made now in a folder of its own where none can be accessed so."""
    final = cache / key
    file = final / name
    if os.access(file, access):
        with suppress(OSError):
            os.utime(final)  # what was used last is kept longest
        return file
    try:
        cache.mkdir(parents=True, exist_ok=True)
        work = Path(tempfile.mkdtemp(prefix="building-", dir=cache))
    except OSError as error:
        raise EnvironmentFault(
            f"cannot write to the cache {cache} ({error.strerror}); set XDG_CACHE_HOME to a folder "
            "that can be written"
        ) from None
    try:
        make(work)
        _move_into_place(work, final, file, access)
    finally:
        shutil.rmtree(work, ignore_errors=True)
    _drop_unused(cache)
    return file


def _written(text: str, source: Path) -> Path:
    try:
        source.write_text(text, encoding="utf-8")
    except OSError as error:
        raise EnvironmentFault(f"cannot write {source}: {error.strerror}") from None
    return source


def _compile(command: list[str], toolchain: Toolchain, work: Path) -> None:
    done = run_compiler(command, toolchain)
    if done.returncode != 0:
        raise EnvironmentFault(_why(done, work))


def _move_into_place(work: Path, final: Path, file: Path, access: int) -> None:
    work.chmod(0o755)  # mkdtemp makes it private
    try:
        work.rename(final)
    except OSError as error:
        if os.access(file, access):
            return  # somebody else built the same thing meanwhile
        shutil.rmtree(final, ignore_errors=True)  # a damaged entry
        try:
            work.rename(final)
        except OSError:
            raise EnvironmentFault(f"cannot keep {file}: {error.strerror}") from None


def _key(texts: Sequence[str], toolchain: Toolchain, mpi: bool) -> str:
    """Return the SHA-256, in hexadecimal, of everything that decides on what is made of texts."""
    compiler = toolchain.compiler(mpi)
    parts = (
        *texts,
        "\0".join(compiler),
        "\0".join(toolchain.flags),
        "\0".join(toolchain.program_flags),
        _compiler_identity(compiler, toolchain),
        _eigen_version(toolchain.eigen),
        _processor(),
    )
    digest = hashlib.sha256()
    for part in parts:
        data = part.encode()
        digest.update(len(data).to_bytes(8, "little") + data)
    return digest.hexdigest()


def uses_mpi(source_text: str) -> bool:
    """Tell whether a C++ source is to be compiled and linked with MPI."""
    return "\n#define ADAGEN_MPI\n" in source_text or "#include <mpi.h>" in source_text


def _compiler_identity(compiler: tuple[str, ...], toolchain: Toolchain) -> str:
    """Return the version of the compiler and the options of the MPI wrapper.

    It is asked once, unless its file changes, or the variables that choose another.
    """
    program = shutil.which(compiler[0])
    written = None
    with suppress(OSError):
        written = Path(program).stat().st_mtime_ns if program else None
    chosen = tuple(os.environ.get(name) for name in ("PATH", "OMPI_CXX", "MPICH_CXX"))
    return _asked(compiler, replace(toolchain, flags=(), program_flags=()), (written, *chosen))


@lru_cache(maxsize=16)
def _asked(compiler: tuple[str, ...], toolchain: Toolchain, _as_of: tuple[object, ...]) -> str:
    version = run_compiler([*compiler, "--version"], toolchain)
    if version.returncode != 0:
        output = printable(" ".join((version.stderr or version.stdout).split()))[:300]
        raise EnvironmentFault(
            f"{compiler[0]} does not work: {output or 'no message'} (is g++ installed?)"
        )
    for option in ("--showme", "-show"):  # Open MPI's word, MPICH's word
        shown = run_compiler([*compiler, option], toolchain)
        if shown.returncode == 0:
            return version.stdout + shown.stdout
    return version.stdout


def _eigen_version(eigen: Path) -> str:
    """Return Eigen's place and the lines that tell its version (in Macros.h up to 3.4)."""
    found = [str(eigen)]
    for file in (eigen / "Eigen" / "Version", eigen / "Eigen/src/Core/util/Macros.h"):
        with suppress(OSError):
            text = file.read_text(encoding="utf-8", errors="replace")
            found += re.findall(r"#define EIGEN_\w*VERSION[^\n]*", text)
    return "\n".join(found)


def _processor() -> str:
    """Return what -march=native depends on: a home folder may be shared between machines."""
    keys = ("model name", "flags", "Features", "CPU part")
    if found := {f"{key}: {each}" for key in keys for each in told(key)}:
        return "\n".join(sorted(found))
    return f"{platform.machine()} {platform.processor()}"


def _why(done: subprocess.CompletedProcess[str], work: Path) -> str:
    """Return in one line why a compilation failed."""
    output = done.stderr.replace(f"{work}{os.sep}", "")
    if "Killed signal" in output or "out of memory" in output.lower() or done.returncode < 0:
        return "the compiler was ended by the system, most likely because memory ran out"
    errors = [line.strip() for line in output.splitlines() if "error" in line.lower()]
    if not errors:
        errors = [line.strip() for line in output.splitlines() if line.strip()] or ["no message"]
    return f"the compiler failed: {printable(' | '.join(errors[:3]))[:600]}"


def run_compiler(command: list[str], toolchain: Toolchain) -> subprocess.CompletedProcess[str]:
    """Return what a command of the compiler printed.

    Raises:
        EnvironmentFault: it cannot be run.
    """
    try:
        return subprocess.run(
            command,
            capture_output=True,
            text=True,
            errors="replace",
            check=False,
            stdin=subprocess.DEVNULL,
            env={**toolchain.variables(os.environ), "LC_ALL": "C"},
        )
    except OSError as error:
        raise EnvironmentFault(f"cannot run {command[0]}: {error.strerror}") from None


def _drop_unused(cache: Path) -> None:
    """Remove the entries beyond KEEP, oldest first, that nobody used for a day."""
    entries = []
    with suppress(OSError):
        for entry in cache.iterdir():
            with suppress(OSError):
                entries.append((entry.stat().st_mtime, entry))
    entries.sort(key=lambda pair: pair[0], reverse=True)
    for used, entry in entries[KEEP:]:
        if time.time() - used > _UNUSED_SECONDS:
            shutil.rmtree(entry, ignore_errors=True)
