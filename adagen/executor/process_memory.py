"""What a process knows: the plan, the graph, values by name, and constants."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.graph import Graph, Numbers, matrix_times
from adagen.plan.types import Plan

Array = NDArray[Any]


class ProcessMemory:
    """The graph and the memory of one process.

    Attributes:
        plan: whose process it is.
        graph: all that the process computes, or what computes it at once; inputs are named as the
            emitted code names them.
        memory: values by the names that steps give them.
        columns: right-hand sides: the motion, and one for each slaved joint.
        passed: what joints hand inwards, "IA" or "pA", by name and joint.
        eliminated: what closures hand to their tops, by name and their numbers, one for each lane.
    """

    def __init__(self, plan: Plan, graph: Graph | Numbers | None = None) -> None:
        self.plan = plan
        self.graph: Any = Graph() if graph is None else graph
        self.memory: dict[Any, Any] = {}
        self.columns = plan.right_hand_sides
        self.passed: dict[tuple[str, int], Array] = {}
        self.eliminated: dict[tuple[str, tuple[int, ...]], Array] = {}
        self._constants: dict[float, Any] = {}

    def constants(self, values: Any) -> Array:
        """Return numbers as constants, in the shape they have."""
        array = np.asarray(values, dtype=float)
        result, known = np.empty(array.size, dtype=object), self._constants
        for k, value in enumerate(array.ravel().tolist()):
            if value not in known:
                known[value] = self.graph.constant(value)
            result[k] = known[value]
        return result.reshape(array.shape)

    def zeros(self, *shape: int) -> Array:
        """Return zeros."""
        return np.full(shape, self.graph.constant(0), dtype=object)

    def mass(self, link: int) -> Array:
        """Return a link's mass, shape ()."""
        entry = self.plan.entry_of_parameter("mass", link)
        if entry is None:
            return self.constants(self.plan.links[link].mass)
        return np.array(self.graph.input(f"parameter[{entry}]"), object)

    def com(self, link: int) -> Array:
        """Return a link's centre of mass, shape (3,)."""
        entry = self.plan.entry_of_parameter("center", link)
        if entry is None:
            return self.constants(self.plan.links[link].com)
        given = np.array([self.graph.input(f"parameter[{entry + k}]") for k in range(3)], object)
        (turn,) = (p.turn for p in self.plan.parameters if (p.what, p.link) == ("center", link))
        return matrix_times(self.constants(turn), given) if turn else given
