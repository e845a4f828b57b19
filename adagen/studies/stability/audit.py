"""The ways in which the suite solves robots by emitted solvers, and what these answer."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from adagen.build import Toolchain
from adagen.emit import emit, stem_of
from adagen.errors import AdagenError
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.clusters import fold_of
from adagen.plan.types import THREADS
from adagen.reference import exact_forward_dynamics
from adagen.schedule import load_profile
from adagen.search import best_schedule, named_schedule
from adagen.states import States
from adagen.studies.stability.loaded import loaded

Array = NDArray[np.float64]
SHAPE_WORDS = {
    "kernels": "loops",
    "unrolled": "straight line",
    "joints": "joins (form ada)",
    "crba": "CRBA",
    "aba": "textbook ABA",
    "aba_exact": "ABA, exact projection",
}
"""Shapes, in the words of pictures and tables."""
WRONG = {"double": 1e-6, "float": 1e-1}
"""From which error on, relative to the largest acceleration of a state, an answer is wrong."""


@dataclass(frozen=True)
class Way:
    """How a robot is solved.

    Attributes:
        shape: of the code, one of ``adagen.emit.shapes.KNOWN``.
        threads: 1, or more.
        scalar: "double" or "float".
        meeting: how threads meet: "joined" at cuts, or "gathered" at a core, as schedule `balanced`
            shares the robot out, or "searched", as adagen does it by default.
        form: of the algorithm.
    """

    shape: str
    threads: int = 1
    scalar: str = "double"
    meeting: str = "joined"
    form: str = "segment"

    def __str__(self) -> str:
        words = [self.shape] + [f"P={self.threads}"] * (self.threads > 1)
        words += [self.meeting] * (self.threads > 1 and self.meeting != "joined")
        return " ".join(words + [self.scalar] * (self.scalar != "double"))

    @property
    def words(self) -> str:
        """In the words that pictures and tables have."""
        words = [SHAPE_WORDS[self.shape]]
        if self.threads > 1:
            words += [f"P = {self.threads}"] + [self.meeting] * (self.form == "segment")
        return ", ".join(words + [self.scalar] * (self.scalar != "double"))


def planned(model: Model, way: Way) -> Plan | None:
    """Return a plan of a robot by one thread or several; None where it is not shared out so."""
    profile = load_profile("default")
    meeting = "gather" if way.meeting == "gathered" else "auto"
    try:
        if way.meeting == "searched":
            schedule = best_schedule(model, way.threads, profile, way.form, way.scalar)
        else:
            seen = fold_of(model, way.form)
            found = named_schedule("balanced", seen.topology, way.threads, profile=profile)
            schedule = seen.unfold(found, profile)
        plan = make_plan(
            model, schedule, form=way.form, scalar=way.scalar, channel=THREADS, meeting=meeting
        )
    except AdagenError:
        return None
    shared = sum(bool(process.owns) for process in plan.processes)
    return plan if shared == way.threads else None


def truths(model: Model, states: States) -> list[Array | None]:
    """Return the true accelerations of states, None for one whose inertia matrix is singular."""
    found: list[Array | None] = []
    for state in states.each:
        try:
            found.append(exact_forward_dynamics(model, *state, digits=25).value)
        except AdagenError:
            found.append(None)
    return found


def source_of(plan: Plan, way: Way) -> str:
    """Return what is emitted of a plan.

    Raises:
        UsageError: it cannot be emitted so.
    """
    return emit(plan, name=_NAME, shape=way.shape)[f"{stem_of(plan, _NAME)}.cpp"]


_NAME = "audited"


def solved(source: str, plan: Plan, states: States, toolchain: Toolchain) -> Iterator[Array | None]:
    """Yield what an emitted source answers for each state, None where it refuses.

    Raises:
        EnvironmentFault: it cannot be built.
    """
    with loaded(source, stem_of(plan, _NAME), plan, toolchain) as call:
        for state in zip(*states.stored(plan.scalar), strict=True):
            qdd = np.empty_like(state[1])
            status = call("solve", ctypes.c_int, *state, qdd)
            yield qdd.astype(np.float64) if status == 0 else None
