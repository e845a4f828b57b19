"""Reproducible solvers whose constants are set at run time answer the same to the last bit, too."""

from __future__ import annotations

import ctypes
import shutil
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import adagen
from adagen.emit import stem_of
from adagen.executor import groupings
from adagen.model import REVOLUTE, Model
from adagen.plan import Plan
from adagen.plan.types import THREADS
from adagen.states import States, random_states
from tests.emit.test_reproducible import CLANG_FLAGS, FLAGS, runs
from tests.emitted import ROUNDING, Array, Builder, forward_error, text_of, truth_of
from tests.end_to_end.test_parameters import MOON, loaded
from tests.executor.test_lane_bits import affected, limbs
from tests.gathered import distributed, reproducible_plan
from tests.slow import slow

HEAVY, CENTER = 2.7, (0.013, -0.021, 0.034)
NUMBERS = {"double": (np.float64, ctypes.c_double), "float": (np.float32, ctypes.c_float)}


class Library:
    """A solver in a shared library, called as C programs call it.

    Args:
        plan: its plan.
        builder: compiles it.
        flags: how.
        folder: where.
        refused: whether states may be refused, whose accelerations are then no numbers.
        options: of the emitter.
    """

    def __init__(
        self,
        plan: Plan,
        builder: Builder,
        flags: tuple[str, ...],
        folder: Path,
        *,
        refused: bool = False,
        **options: Any,
    ) -> None:
        self.plan, self.batch, self.refused = plan, options.get("batch", 0), refused
        self.stem = stem_of(plan, None, self.batch)
        library = folder / f"{len(list(folder.iterdir()))}.so"  # each has numbers of its own
        shutil.copy(builder.library(text_of(plan, **options), flags), library)
        self.library = ctypes.CDLL(str(library))
        self.array, self.number = NUMBERS[plan.scalar]
        if plan.threads:
            self.solver = self._call("open_threads", None, ctypes.c_double(20.0), found=True)
        else:
            self.solver = self._call("open", found=True)

    def _call(self, name: str, *words: Any, found: bool = False) -> Any:
        function = self.library[f"{self.stem}_{name}"]
        function.restype = ctypes.c_void_p if found else ctypes.c_int
        status = function(*words)
        assert status if found else status == 0 or self.refused, name
        return ctypes.c_void_p(status) if found else status

    def _numbers(self, values: Any) -> Any:
        given = np.ascontiguousarray(values, self.array).ravel()
        return (self.number * given.size)(*given.tolist())

    def set(self, link: int, center: Any = CENTER) -> None:
        """Set gravity, and mass and centre of the settable link of a number."""
        self._call("set_gravity", self.solver, self._numbers(MOON))
        self._call("set_mass", self.solver, link, self.number(HEAVY))
        self._call("set_center", self.solver, link, self._numbers(center))

    def solve(self, states: States) -> Array:
        """Return the accelerations, shape (S, nv)."""
        count, nv = len(states.q), self.plan.nv
        if self.batch:
            given = [self._numbers(x) for x in (states.q, states.v, states.tau)]
            qdd = (self.number * (count * nv))()
            self._call("solve_batch", self.solver, count, *given, qdd)
            return np.array(qdd, self.array).reshape(count, nv)
        rows = []
        for row in states.each:
            qdd = (self.number * nv)(*[np.nan] * nv)
            self._call("solve", self.solver, *map(self._numbers, row), qdd)
            rows.append(np.array(qdd, self.array))
        return np.array(rows)


def constants_of(model: Model) -> tuple[str, str]:
    """Return what can be set, and the link whose mass and centre are."""
    link = next(x.name for x in reversed(model.links) if x.inertia.mass > 0)
    return f"mass:{link},gravity,center:{link}", link


WIDE = ("-O1", "-march=native", "-ffp-contract=fast")


def ways(
    plan: Plan, model: Model, runtime: str, builder: Builder, *, every: bool
) -> Iterator[tuple[Plan, Builder, tuple[str, ...], dict[str, Any]]]:
    """Yield plans, compilers and options whose answers are to be the same."""
    yield plan, builder, ("-O1", "-march=x86-64"), {"limbs": groupings(plan)[0]}
    yield from ((plan, builder, flags, {}) for flags in filter(runs, FLAGS if every else (WIDE,)))
    yield plan, builder, WIDE, {"batch": 1}
    gathered = distributed(model, 2, np.random.default_rng(2), core=0.0)
    shares = reproducible_plan(model, gathered, scalar=plan.scalar, runtime=runtime)
    shares = replace(shares, channel=THREADS)
    assert shares.several
    for grouping in groupings(shares)[0 if every else -1 :]:
        yield shares, builder, WIDE, {"limbs": grouping}
    if shutil.which("clang++"):
        other, known = builder.with_compiler("clang++"), CLANG_FLAGS if every else CLANG_FLAGS[-1:]
        yield from ((plan, other, flags, {}) for flags in filter(runs, known))


@pytest.mark.parametrize(
    ("scalar", "every"), [("float", False), slow("double", True), slow("float", True)]
)
def test_compilers_processes_and_lanes(
    scalar: str, every: bool, builder: Builder, tmp_path: Path
) -> None:
    model = affected(limbs(4, REVOLUTE, REVOLUTE, trunk=1, beside=0))
    runtime, link = constants_of(model)
    plan = reproducible_plan(model, scalar=scalar, runtime=runtime)
    states = random_states(model, 5, seed=4)
    own = model.links[[x.name for x in model.links].index(link)].inertia
    other = loaded(model, link, HEAVY, np.array(CENTER)).with_gravity(MOON)
    assert not np.array_equal(own.com, CENTER)
    answers: list[Array] = []
    count = 0
    for each, compiler, flags, how in ways(plan, model, runtime, builder, every=every):
        solver = Library(each, compiler, flags, tmp_path, **how)
        found = [solver.solve(states)]
        solver.set(0)
        found.append(solver.solve(states))
        answers = answers or found
        count += 1
        np.testing.assert_array_equal(found, answers, err_msg=f"{flags} {how}")
    assert count > (7 if every else 3)
    for answer, robot in zip(answers, (model, other), strict=True):
        assert forward_error(answer, truth_of(robot, states)) < 4 * ROUNDING[scalar]


OBLIQUE = """<robot name="oblique">
  <link name="ground"/>
  <joint name="hinge" type="continuous">
    <origin xyz="0 0 .2"/> <parent link="ground"/> <child link="upper"/> <axis xyz="1 2 3"/>
  </joint>
  <link name="upper"><inertial> <origin xyz=".1 0 0"/> <mass value="2"/>
    <inertia ixx=".1" ixy="0" ixz="0" iyy=".2" iyz="0" izz=".2"/> </inertial></link>
</robot>"""
"""Its hinge's axis is turned to z, and so is what is set of its link."""


@pytest.mark.parametrize("scalar", ["double", "float"])
def test_a_centre_is_the_same_from_python(scalar: str, builder: Builder, tmp_path: Path) -> None:
    """It is turned into the axes of the joint, by the same roundings."""
    file = tmp_path / "oblique.urdf"
    file.write_text(OBLIQUE)
    robot = adagen.read(file)
    runtime, link = constants_of(robot.model)
    asked = {"scalar": scalar, "runtime": runtime, "reproducible": True, "procs": 1}
    compiled = adagen.compile(robot, **asked)  # type: ignore[arg-type]
    (rotation,) = (p.rotation for p in compiled.plan.parameters if p.what == "center")
    assert all(0 < abs(x) < 1 for x in rotation[0])
    solver = compiled.build()
    solver.gravity = MOON
    solver.set_mass(link, HEAVY)
    library = Library(compiled.plan, builder, ("-O1", "-march=x86-64"), tmp_path)
    states = random_states(robot.model, 1, seed=4)
    for center in np.random.default_rng(3).uniform(-1.0, 1.0, (20, 3)):
        solver.set_center(link, center)
        library.set(0, center)
        expected = library.solve(states)
        found = solver(states.q, states.v, states.tau)
        np.testing.assert_array_equal(found.astype(expected.dtype), expected)
