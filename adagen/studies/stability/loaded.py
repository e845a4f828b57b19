"""Emitted solvers that are loaded into this process."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np

from adagen.build import Toolchain, build_executable
from adagen.plan import Plan

_SECONDS = 60.0
"""That threads have for an evaluation."""


@contextmanager
def loaded(
    source: str, stem: str, plan: Plan, toolchain: Toolchain
) -> Iterator[Callable[..., Any]]:
    """Yield a function that calls an open solver: by a function's name, its result, and arrays.

    Args:
        source: of the solver.
        stem: of its functions' names.
        plan: what it carries out.
        toolchain: builds it.

    Raises:
        EnvironmentFault: it cannot be built.
    """
    flags = (*toolchain.flags, "-shared", "-fPIC", "-pthread")
    alone = replace(toolchain, flags=flags)
    built = build_executable(f"#define ADAGEN_NO_MAIN\n{source}", f"{stem}.so", alone)
    library, pointer = ctypes.CDLL(str(built)), ctypes.c_void_p

    def call(name: str, result: Any, *given: Any) -> Any:
        function = getattr(library, f"{stem}_{name}")
        function.restype = result
        return function(
            *(x.ctypes.data_as(pointer) if isinstance(x, np.ndarray) else x for x in given)
        )

    threads = (None, ctypes.c_double(_SECONDS)) if plan.threads else ()
    opened = pointer(call("open_threads" if plan.threads else "open", pointer, *threads))
    try:
        yield lambda name, result, *given: call(name, result, opened, *given)
    finally:
        call("close", None, opened)
