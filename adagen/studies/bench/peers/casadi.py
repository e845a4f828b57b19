"""Code that casadi generates of the articulated-body algorithm: a straight line per robot."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from adagen.errors import EnvironmentFault
from adagen.model import Model
from adagen.states import States
from adagen.studies.bench.contest import Contestant
from adagen.studies.bench.peers.symbolic_aba import forward_dynamics
from adagen.studies.bench.program import NATIVE, Coordinates, Peer, build, compilers, source

FORMS = {"textbook": False, "exact": True}
"""What a projection through a joint makes zero is computed, as others do it, or left out."""
MOST_OPERATIONS = 60_000
"""A longer straight line takes minutes to compile."""


def contestants(model: Model, states: States, folder: Path) -> Sequence[Contestant]:
    """Return casadi's contestants for a robot, one for each compiler and form of the algorithm.

    Raises:
        EnvironmentFault: the robot is too large for straight-line code, or nothing compiles it.
    """
    kinds = _kinds(model)
    texts = {form: _program(model, exact=FORMS[form]) for form in {form for _, form in kinds}}
    given = folder / "casadi.states"
    _coordinates(states).write(given)

    def built(kind: tuple[str, str]) -> Path:
        return build(texts[kind[1]], "bench_casadi", kind[0], NATIVE)

    with ThreadPoolExecutor(2) as pool:
        executables = list(pool.map(built, kinds))
    return [
        Peer(executable).contestant(
            f"casadi {form}, {compiler}", f"{compiler} {' '.join(NATIVE)}", given, _coordinates
        )
        for (compiler, form), executable in zip(kinds, executables, strict=True)
    ]


def _coordinates(states: States) -> Coordinates:
    return Coordinates(states.q, states.v, states.tau)


def _kinds(model: Model) -> list[tuple[str, str]]:
    """Return compilers and forms; with single axes alone, casadi finds the zeros by itself."""
    found = compilers()
    inner = any(joint.kind.nv > 1 and joint.parent > 0 for joint in model.joints)
    return [(c, "exact") for c in found] + [(found[0], "textbook")] * inner


def _program(model: Model, *, exact: bool) -> str:
    """Return the generated code between what measures it and what calls it."""
    function = forward_dynamics(model, exact=exact)
    count = function.n_instructions()
    if count > MOST_OPERATIONS:
        raise EnvironmentFault(
            f"casadi's straight-line code would have {count} operations, more than the "
            f"{MOST_OPERATIONS} that compile in reasonable time"
        )
    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        before = Path.cwd()
        os.chdir(folder)  # it takes no path
        try:
            function.generate("generated.c")
        finally:
            os.chdir(before)
        code = Path(folder, "generated.c").read_text(encoding="utf-8")
    head, main = source("casadi_main.cpp").split("// PROGRAM", 1)
    return f"{head}{code}\n// PROGRAM{main}"
