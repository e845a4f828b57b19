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


REPRODUCIBLE = ("cfloat",)
"""Of solvers whose answers are the same everywhere."""

HOSTED = ("chrono", "cstdio")
"""Of a solver's, what an embedded one does without."""


def of_solver(
    mpi: bool,
    threads: bool,
    reproducible: bool,
    *,
    embedded: bool = False,
    tells_bounds: bool = False,
) -> list[str]:
    """Return what a solver includes.

    Args:
        mpi: whether it exchanges messages.
        threads: whether its processes are threads.
        reproducible: whether its answers are the same everywhere.
        embedded: whether it needs no operating system.
        tells_bounds: whether it tells the program around it how far many answers may be off.
    """
    if embedded:
        return sorted({*SOLVER} - {*HOSTED})
    lists = (MPI, THREADS, REPRODUCIBLE, ("vector",))
    more = zip(lists, (mpi, threads, reproducible, tells_bounds), strict=True)
    return sorted({*SOLVER, *(name for names, wanted in more if wanted for name in names)})
