"""The runtime's headers that a source includes, and its settings that differ from the defaults."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import PurePosixPath
from posixpath import normpath

from adagen.emit.runtime import FOLDER, runtime_files
from adagen.program.lower import LOOPS
from adagen.schedule.costs import ASSUMED

Setting = tuple[str, str, object, object]
"""C++ type, name, value, and the value that the runtime has for it."""
_CACHE = int(ASSUMED["process.cache"])
_DESCRIBED = {"kRobot", "kFloating", "kChannel", "kHops", "kMeetsSubnormals"}
"""What only some processors, or the description for the program around a solver, read; clang would
call it unused."""


def overridden(settings: Iterable[Setting]) -> list[str]:
    """Return the members of a struct that differ from those of a default one."""
    return [
        "[[maybe_unused]] " * (name in _DESCRIBED)
        + f"static constexpr {kind} {name} = {_text(value)};"
        for kind, name, value, plain in settings
        if value != plain
    ]


def settings(values: Mapping[str, object], messages: int) -> list[str]:
    """Return a solver's Settings, as far as they differ from the defaults."""
    nqdd, nv, refine = values["nqdd"], values["nv"], values["refine"]
    assert isinstance(nqdd, int)
    assert isinstance(nv, int)
    return [
        *([f"using Number = {values['number']};"] if values["number"] != "double" else []),
        *overridden(
            [
                ("const char*", "kRobot", values["robot"], ""),
                ("bool", "kFloating", values["floating"], False),
                ("bool", "kAtRest", bool(values["at_rest"]), False),
                ("const char*", "kChannel", f'"{values["channel"]}"', '"auto"'),
                ("int", "kProcesses", values["process_count"], 1),
                ("bool", "kAlone", values["alone"], True),
                (
                    "std::array<double, 3>",
                    "kGravity",
                    f"{{{values['gravity']}}}",
                    "{0.0, 0.0, -9.81}",
                ),
                ("int", "kParameterCount", _count(values["parameters"]), 0),
                ("int", "kOuterCount", _count(values["outer_forces"]), 0),
                ("int", "kOutputCount", nqdd - nv, 0),
                ("int", "kColumns", values["columns"], 1),
                ("std::size_t", "kSlavedCount", values["slaved_count"], 0),
                ("bool", "kGivesAll", not values["wanted"], True),
                ("bool", "kBatch", values["batch"], False),
                ("std::size_t", "kCache", values["cache"] if values["batch"] else _CACHE, _CACHE),
                ("int", "kRefine", refine, 0),
                ("bool", "kWide", bool(refine) and not values["own_residual"], False),
                ("bool", "kCertified", values["certified"], False),
                ("int", "kPlanMessages", messages, 0),
                ("Hops", "kHops", values["hops"], ""),
                ("bool", "kMeetsSubnormals", values["meets_subnormals"], False),
                ("double", "kTolerance", values["tolerance"], 1e-9),
            ]
        ),
    ]


def description(values: Mapping[str, object]) -> list[str]:
    """Return the lines of a solver's description that differ from the default."""
    loops, couplings, outputs = values["loops"], values["couplings"], values["outputs"]
    lines = {
        "about.outer_forces = table<kOuterForces>();": values["outer_forces"],
        "about.loops = {kLoops.data(), kLoopCount};": loops,
        f"about.couplings = {{kCouplings.data(), {_count(couplings)}}};": couplings,
        f"about.outputs = {{kOutputs.data(), {_count(outputs)}}};": outputs,
    }
    return [line for line, own in lines.items() if own]


def _count(items: object) -> int:
    assert isinstance(items, list)
    return len(items)


def _text(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


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
