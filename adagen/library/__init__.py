"""adagen from Python: read a robot, compile it, solve. The command line uses it."""

from adagen.errors import (
    AdagenError,
    EnvironmentFault,
    InputError,
    JointError,
    SolveError,
    UsageError,
)
from adagen.library.compiled import compile  # noqa: A004 (what it does)
from adagen.library.request import Request
from adagen.library.robot import Origin, Robot, read
from adagen.library.solver import Compiled, Solver

__all__ = [
    "AdagenError",
    "Compiled",
    "EnvironmentFault",
    "InputError",
    "JointError",
    "Origin",
    "Request",
    "Robot",
    "SolveError",
    "Solver",
    "UsageError",
    "compile",
    "read",
]
