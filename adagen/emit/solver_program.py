"""The program around a solver: one source file for all robots, linked with each solver."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache

from adagen.emit.runtime import INTERFACE, joined, runtime_files
from adagen.emit.templates import render
from adagen.version import __version__

PROGRAM_FILE = "adagen_program.cpp"
"""What it is called beside the solvers that it is linked with."""

_MPI = "#if defined(ADAGEN_MPI)\n#include <mpi.h>\n#endif\n"
_COMMENTS = re.compile(r"^//.*\n", re.MULTILINE)
_SECTION = "#ifndef ADAGEN_NO_MAIN\n"
_JOINED = "// The program around this solver, the same for all robots.\n\n"
_LINKS = re.compile(rf"^// links     {re.escape(PROGRAM_FILE)}((?: -D\w+)*).*\n", re.MULTILINE)


@cache
def program_text() -> str:
    """Return the text of the program."""
    return render("adagen_program.cpp.j2", version=__version__)


def options_of(mpi: bool, number: str) -> str:
    """Return the compiler's options of the program for a solver, as its head names them.

    Args:
        mpi: whether the solver is for several processes.
        number: C++ type of its states and accelerations, double or float.
    """
    return " -DADAGEN_MPI" * mpi + " -DADAGEN_FLOAT" * (number == "float")


def standalone(
    source: str,
    program: str | None = None,
    files: Mapping[str, str] | None = None,
    header: str = "",
) -> str:
    """Return an emitted source with runtime and program in it, which compiles alone.

    Args:
        source: of a solver.
        program: the text of the program around it; that of this version by default.
        files: the runtime's headers, path to text; those of this version by default.
        header: the solver's own, if it is to hold that, too.
    """
    if header:
        source = INTERFACE.sub(lambda _: header, source, count=1)
    options = options_in(source)
    if options is None:
        return joined(source, files)
    defines = "".join(f"#define {option.removeprefix('-D')}\n" for option in options)
    own = _COMMENTS.sub("", program_text() if program is None else program)
    source = _LINKS.sub("", source, count=1)
    section = f"{_JOINED}{_SECTION}{defines}{own}\n"
    files = {
        name: text.replace(_SECTION, section, 1)
        for name, text in (runtime_files() if files is None else files).items()
    }
    whole = joined(source.replace(_SECTION, section, 1), files)
    return whole.replace(_MPI, "", 1)  # the solver has included mpi.h, if it needs that


def options_in(source: str) -> tuple[str, ...] | None:
    """Return these options as an emitted source has them; None if it needs no program."""
    found = _LINKS.search(source)
    if found is None or "#define ADAGEN_NO_MAIN" in source:
        return None
    return tuple(found[1].split())
