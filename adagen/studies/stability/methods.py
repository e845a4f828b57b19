"""The methods that the suite compares, and the error of each on a robot."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.errors import AdagenError
from adagen.executor import interpret
from adagen.executor.refine import WideLinks, interpret_refined
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.clusters import fold_of
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule
from adagen.search.objective import schedule_for
from adagen.studies.stability.robots import state
from adagen.studies.stability.textbook_methods import articulated, composite, true_acceleration

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Method:
    """A method, and how it is called."""

    name: str
    solve: Callable[[Trial], Array]


@dataclass(frozen=True)
class Trial:
    """One robot in the suite's state, with the truth."""

    model: Model

    @cached_property
    def state(self) -> tuple[Array, Array, Array]:
        """Configuration (nq,), velocity (nv,) and torques (nv,)."""
        return state(self.model)

    @cached_property
    def truth(self) -> Array:
        """The true accelerations, rounded to double, shape (nv,)."""
        return true_acceleration(self.model, *self.state)

    def plan(self, form: str, fused: bool = True) -> Plan:
        """Return the plan of a form on one process; form ada joins as a balanced tree.

        Args:
            form: of the algorithm.
            fused: whether form ada takes joints over massless links as one.
        """
        profile = load_profile("paper")
        if not fused:
            topology = Topology.of(self.model)
            return make_plan(
                self.model, named_schedule("balanced", topology, 1, profile=profile), form=form
            )
        seen = fold_of(self.model, form)
        found = named_schedule("balanced", seen.topology, 1, profile=profile)
        return make_plan(self.model, seen.unfold(found, profile), form=form)

    def cut(self, processes: int) -> Plan:
        """Return the plan of form segment cut for processes, messages assumed to be cheap."""
        schedule = schedule_for(
            "both", self.model, processes, load_profile("paper"), "segment", "double", gather=False
        )
        return make_plan(self.model, schedule, form="segment")

    @cached_property
    def _links(self) -> WideLinks:
        q, v, _ = self.state
        return WideLinks(self.plan("segment"), q, v, np.longdouble)

    def error(self, found: Array) -> float:
        """Return sqrt(e^T H e / t^T H t); infinity where a number is not finite."""
        if not np.isfinite(found).all():
            return np.inf
        wrong = self._links.energy(found - self.truth)
        return float(np.sqrt(wrong / self._links.energy(self.truth)))

    def outcome(self, method: Method) -> tuple[float, str]:
        """Return a method's error, infinity where it fails, and how it fails."""
        try:
            return self.error(method.solve(self)), ""
        except (AdagenError, FloatingPointError, np.linalg.LinAlgError) as failure:
            return np.inf, str(failure).removeprefix("error: ").split(";")[0]


def _planned(form: str, fused: bool = True) -> Callable[[Trial], Array]:
    return lambda trial: interpret(trial.plan(form, fused), *trial.state, once=True)


def _refined(form: str, steps: int) -> Callable[[Trial], Array]:
    return lambda trial: interpret_refined(trial.plan(form), *trial.state, steps).qdd


def _cut(trial: Trial) -> Array:
    return interpret(trial.cut(4), *trial.state, once=True)


def _weak(method: Callable[..., Array], **options: Any) -> Callable[[Trial], Array]:
    return lambda trial: method(trial.model, *trial.state, **options)


METHODS = {
    method.name: method
    for method in (
        Method("composite bodies", _weak(composite)),
        Method("composite bodies, float", _weak(composite, scalar=np.float32)),
        Method("articulated bodies, textbook", _weak(articulated)),
        Method("articulated bodies, float", _weak(articulated, scalar=np.float32)),
        Method("articulated bodies, world frame", _weak(articulated, world=True)),
        Method("form ada, joints not fused", _planned("ada", fused=False)),
        Method("form ada", _planned("ada")),
        Method("form ada, refined once", _refined("ada", 1)),
        Method("form ada, refined twice", _refined("ada", 2)),
        Method("form segment", _planned("segment")),
        Method("form segment, refined once", _refined("segment", 1)),
        Method("form segment, cut in four", _cut),
    )
}


def digits(error: float) -> float:
    """Return the decimal digits that an error leaves, 0 to 16."""
    if not error < 1.0:
        return 0.0
    return float(min(16.0, -np.log10(max(error, 1e-16))))
