"""Headers that a source includes, and whether they need Eigen."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from pathlib import PurePosixPath
from posixpath import normpath

from adagen.emit.runtime import FOLDER, runtime_files
from adagen.program.lower import LOOPS

_KEPT = (
    "weighed",
    "own_residual",
    "fused",
    "parameters",
    "cut_joints",
    "cuts",
    "passages",
    "wide_residual",
    "slaved_count",
)
"""What a solver in loops keeps memory of its own for."""
_INCLUDED = re.compile(r'^\s*#include (?:"([^"]+)"|<(Eigen/)[^>]*>)', re.M)


def umbrellas(values: Mapping[str, object]) -> dict[str, bool]:
    """Return the headers that replace several others in the templates.

    Args:
        values: those of the templates, with the shape's.

    Returns:
        keeps: loops have memory of their own, which the source declares; plain_loops: they take
        plain_sweeps.hpp; loops_alone: loops_alone.hpp.
    """
    loops = values["shape"] == LOOPS
    keeps = loops and any(values[name] for name in _KEPT)
    plain = loops and not (keeps or values["copied"] or values["outer_forces"])
    alone = not (values["mpi"] or values["threads"])
    return {
        "keeps": keeps,
        "plain_loops": plain,
        "loops_alone": plain and alone,
    }


def needs_eigen(of_shape: Mapping[str, object]) -> bool:
    """Whether a source needs Eigen's headers, from the values of its shape's template."""
    parts = of_shape["runtime"]
    assert isinstance(parts, list)
    return any(_takes_eigen(part) for part in parts)


@cache
def _takes_eigen(header: str) -> bool:
    """Whether a header includes Eigen's headers, or one that does."""
    seen, left = set(), [f"{FOLDER}/{header}"]
    while left:
        path = left.pop()
        seen.add(path)
        for own, eigen in _INCLUDED.findall(runtime_files()[path]):
            if eigen:
                return True
            found = normpath(f"{PurePosixPath(path).parent}/{own}")
            left += [found] if found in runtime_files() and found not in seen else []
    return False
