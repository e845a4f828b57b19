"""The program around a solver: one file, the same for all robots, that is linked with each."""

from __future__ import annotations

import re
from functools import cache

from adagen import __version__
from adagen.emit import headers
from adagen.emit.templates import render

PROGRAM_FILE = "adagen_program.cpp"
"""What it is called beside the solvers that it is linked with."""

_PARTS = (
    "status.hpp",
    "inverse_dynamics.hpp",
    "json.hpp",
    "slave.hpp",
    "states.hpp",
    "manifold.hpp",
    "loops.hpp",
    "implicit.hpp",
    "integrators.hpp",
    "trajectory.hpp",
    "options.hpp",
    "watch.hpp",
    "statistics.hpp",
    "trace.hpp",
    "session.hpp",
    "cores.hpp",
    "makespan.hpp",
    "stretches.hpp",
    "batch_timing.hpp",
    "timing.hpp",
    "simulate.hpp",
    "corrections.hpp",
    "certificates.hpp",
    "unreal.hpp",
    "verdict.hpp",
    "main.hpp",
)
_MPI = "#if defined(ADAGEN_MPI)\n#include <mpi.h>\n#endif\n"
_SECTION = "#ifndef ADAGEN_NO_MAIN\n"
_TOLD = f"what the program around it, {PROGRAM_FILE}, is told; main"
_LINKS = re.compile(rf"^// links     {re.escape(PROGRAM_FILE)}(.*)\n", re.MULTILINE)


@cache
def program_text() -> str:
    """Return the text of the program."""
    return render(
        "adagen_program.cpp.j2",
        version=__version__,
        headers=sorted({*headers.SOLVER, *headers.PROGRAM}),
        parts=_PARTS,
    )


def options_of(mpi: bool, number: str) -> str:
    """Return the compiler's options that fit the program to a solver, as its head names them.

    Args:
        mpi: whether the solver is for several processes.
        number: C++ type of its states and accelerations, double or float.
    """
    return " -DADAGEN_MPI" * mpi + " -DADAGEN_FLOAT" * (number == "float")


def standalone(source: str, program: str) -> str:
    """Return an emitted source with the text of the program in it, which is compiled alone."""
    options = options_in(source)
    if options is None:
        return source
    own = program.partition(_MPI)[2]  # the solver has included mpi.h
    defines = "".join(f"#define {option.removeprefix('-D')}\n" for option in options)
    source = _LINKS.sub("", source, count=1).replace(_TOLD, "the program around it; main", 1)
    return source.replace(_SECTION, f"{_SECTION}{defines}{own}\n", 1)


def options_in(source: str) -> tuple[str, ...] | None:
    """Return what an emitted source says of these options; None where it needs no program."""
    found = _LINKS.search(source)
    if found is None or "#define ADAGEN_NO_MAIN" in source:
        return None
    return tuple(found[1].split())
