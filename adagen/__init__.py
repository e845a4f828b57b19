"""adagen: a compiler from a robot description to parallel forward-dynamics code.

From Python::

    robot = adagen.read("arm.urdf")
    solver = adagen.compile(robot).build()
    qdd = solver(q, v, tau)

docs/how_to/python.md goes on from there.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from adagen.version import __version__ as __version__

if TYPE_CHECKING:
    from adagen.library import (
        AdagenError,
        Compiled,
        EnvironmentFault,
        InputError,
        JointError,
        Origin,
        Request,
        Robot,
        SolveError,
        Solver,
        UsageError,
        compile,  # noqa: A004 (what it does)
        read,
    )

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


def __getattr__(name: str) -> Any:
    """Load the library when it is asked for: the command line starts without it."""
    if name not in __all__:
        raise AttributeError(f"module 'adagen' has no attribute {name!r}")
    return getattr(import_module("adagen.library"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
