"""The Python extension behind a solver's source, built and loaded."""

from __future__ import annotations

import sysconfig
from dataclasses import replace
from functools import cache
from importlib.machinery import ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

import numpy as np

from adagen.build import Toolchain, build_executable, find_toolchain
from adagen.emit.templates import verbatim
from adagen.errors import EnvironmentFault

_PARTS = ("objects", "arrays", "states", "call", "module")
"""Parts of the extension behind a solver's source (templates/python), in order."""


def extension(source: str, stem: str, toolchain: Toolchain | None) -> ModuleType:
    """Return the extension of a solver, built now or found in the cache.

    Args:
        source: of the solver, in C++.
        stem: of the extension's file.
        toolchain: what to build with; by default what ``adagen env`` prints.

    Raises:
        EnvironmentFault: the compiler failed, or is missing.
    """
    behind = "\n\n".join(verbatim(f"python/{part}.hpp") for part in _PARTS)
    text = f"#define ADAGEN_NO_MAIN\n{source}\n{behind}\n"
    toolchain = _with_python(find_toolchain() if toolchain is None else toolchain)
    return _loaded(build_executable(text, f"{stem}.so", toolchain))


def _with_python(toolchain: Toolchain) -> Toolchain:
    """Return the toolchain with the options for extensions of this Python."""
    python = Path(sysconfig.get_path("include"))
    if not (python / "Python.h").is_file():
        raise EnvironmentFault(
            f"no Python.h in {python}: install Python's headers (Debian, Ubuntu: apt install "
            "python3-dev)"
        )
    numpy = f'-DADAGEN_BUILT_FOR="{sysconfig.get_config_var("SOABI")}-{np.__version__}"'
    folders = ("-isystem", str(python), "-isystem", np.get_include())
    return replace(
        toolchain, flags=(*toolchain.flags, "-shared", "-fPIC", "-pthread", numpy, *folders)
    )


@cache
def _loaded(path: Path) -> ModuleType:
    loader = ExtensionFileLoader("adagen_solver", str(path))
    spec = spec_from_file_location("adagen_solver", path, loader=loader)
    assert spec is not None
    module = module_from_spec(spec)
    loader.exec_module(module)
    return module
