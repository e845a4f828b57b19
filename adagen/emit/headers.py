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
