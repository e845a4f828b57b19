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


def of_solver(mpi: bool, threads: bool) -> list[str]:
    """Return what a solver includes, one that exchanges messages or shares out to threads."""
    return sorted({*SOLVER, *(MPI if mpi else ()), *(THREADS if threads else ())})
