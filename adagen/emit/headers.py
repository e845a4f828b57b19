"""The headers of the standard library that parts of an emitted file include."""

SOLVER = (
    "algorithm",
    "array",
    "chrono",
    "cmath",
    "cstddef",
    "cstdint",
    "cstdio",
    "cstring",
    "limits",
    "new",
    "type_traits",
    "utility",
)
"""Of every solver."""

MPI = ("atomic", "exception", "memory", "string", "thread", "vector")
"""Of solvers that exchange messages, besides."""

THREADS = (
    "atomic",
    "condition_variable",
    "exception",
    "memory",
    "mutex",
    "new",
    "thread",
)
"""Of solvers whose processes are threads."""

PROGRAM = (
    "atomic",
    "charconv",
    "cstdlib",
    "fstream",
    "initializer_list",
    "iterator",
    "memory",
    "sstream",
    "stdexcept",
    "string",
    "thread",
    "vector",
)
"""Of the program around them, besides."""


HOSTED = ("chrono", "cstdio")
"""Of these, what an embedded solver does without."""


def of_solver(mpi: bool, threads: bool, *, embedded: bool = False) -> list[str]:
    """Return what a solver includes, one that exchanges messages or shares out to threads."""
    if embedded:
        return sorted({*SOLVER} - {*HOSTED})
    return sorted({*SOLVER, *(MPI if mpi else ()), *(THREADS if threads else ())})
