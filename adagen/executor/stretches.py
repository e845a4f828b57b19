"""Costs of straight lines, counted in the coefficients of a cost profile.

The statements are an expression graph, so the effect of a robot's structure is known exactly.
Between two messages a process's statements are one stretch. Its time is the larger of the time of
its operations and the time of its longest dependency chain, plus its sines and cosines, where they
are more than two registers of 256 bits hold: fewer are computed beside other work. Where both
are about equal, neither hides the other completely: the time is the fourth root of the sum of their
fourth powers. Where the process's line does not fit the first instruction cache, each statement
costs more, as all of them are fetched in each evaluation.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isinf, sqrt

from adagen.executor.run import Simulated
from adagen.executor.swept import STATEMENTS
from adagen.graph import Operations
from adagen.plan.steps import Receive, Send, Step
from adagen.schedule.costs import StepCosts

AT_ONCE = {"double": 8, "float": 16}
"""Angles that two registers of 256 bits hold, whose sines and cosines cost nothing that could be
told (measured in double). More are taken by registers of 512 bits, which cost something from the
first one on (templates/include/adagen/unrolled_sines.hpp)."""

_COMPUTED = ("add", "sub", "mul", "multiply_add", "reciprocal")


@dataclass(frozen=True)
class Stretch:
    """Statements of one process between two messages.

    Attributes:
        features: how often each coefficient counts.
        statements: how many each step has, by the step's place.
        line: how many statements the process has that are fetched for each evaluation; what its
            loop of residuals does again and again is fetched once.
        fetched: this stretch's part of these.
    """

    features: dict[str, float]
    statements: dict[int, int]
    line: float = 0.0
    fetched: float = 0.0

    def time(self, costs: StepCosts) -> float:
        """Return its time on a machine, microseconds."""
        parts = {name: costs[name] * count for name, count in self.features.items()}
        waits, sines = parts.pop(WAITS), parts.pop(SINES)
        work = sum(parts.values())
        if self.line > costs["unrolled.fits"]:
            work += costs["unrolled.evicted"] * self.fetched
        return at_once(work, waits) + sines


WAITS, SINES = "unrolled.cycle", "unrolled.sine"


def at_once(work: float, waits: float) -> float:
    """Return the time of operations and a dependency chain together."""
    return sqrt(sqrt(work**4 + waits**4))


def work_of(operations: Operations, held: float) -> dict[str, float]:
    """Return the count of each coefficient for all statements of a process.

    Args:
        operations: its operations.
        held: statements whose decoded instructions are held.
    """
    # A sum takes up a product; what is done in SIMD lanes is done once, and moved into them.
    statements = operations.arithmetic - operations.fused
    return {
        "unrolled.operation": statements,
        "unrolled.move": operations.moves,
        "unrolled.fetched": max(0.0, statements + operations.moves - held),
    }


def _statements(features: Mapping[str, float]) -> float:
    """How many statements there are, by how often each coefficient counts."""
    return features["unrolled.operation"] + features["unrolled.move"]


def stretches(simulated: Simulated, steps: Sequence[Step], held: float) -> list[Stretch]:
    """Return the stretches of a process.

    Args:
        simulated: the process after all its steps.
        steps: these.
        held: statements whose decoded instructions are held; more of them are fetched anew in
            each evaluation. Infinity where many states share an evaluation.
    """
    if held not in simulated.known:
        simulated.known[held] = _stretches(simulated, steps, held)
    return simulated.known[held]


def _stretches(simulated: Simulated, steps: Sequence[Step], held: float) -> list[Stretch]:
    stretch = _stretch_of(steps)
    counts: list[dict[int, int]] = [{} for _ in range(stretch[-1] + 1 if stretch else 1)]
    done = [0] * len(counts)  # cycles until a stretch's last value is there
    nodes = simulated.machine.graph.nodes
    ready = [0] * len(nodes)
    for index in simulated.alive:
        op, args, _, there, mark, _ = nodes[index]
        here = stretch[mark] if stretch else 0
        before = waits = 0
        for k in args:  # comparisons instead of max: this loop runs for every statement
            _, _, _, earlier, source, _ = nodes[k]
            if earlier > before:
                before = earlier
            if ready[k] > waits and stretch[source] == here:
                waits = ready[k]
        if there > before:
            waits += there - before
        ready[index] = waits
        if waits > done[here]:
            done[here] = waits
        if op in _COMPUTED:
            counts[here][mark] = counts[here].get(mark, 0) + 1
    work = work_of(simulated.operations, held)
    line = 0.0 if isinf(held) else _statements(work)
    swept = simulated.machine.swept
    if swept is not None:
        line += STATEMENTS
        work["unrolled.operation"] += swept.operations
    angles = len(simulated.machine.angles)
    if not isinf(held) and angles <= AT_ONCE[simulated.machine.plan.scalar]:
        angles = 0
    computed = sum(sum(count.values()) for count in counts) or 1
    parts = []
    for k, (count, cycles) in enumerate(zip(counts, done, strict=True)):
        share = sum(count.values()) / computed
        features: dict[str, float] = {
            **{name: count * share for name, count in work.items()},
            "unrolled.sine": angles if k == 0 else 0,
            "unrolled.cycle": cycles,
        }
        parts.append(Stretch(features, count, line, line * share))
    return parts


def _stretch_of(steps: Sequence[Step]) -> list[int]:
    """For each step, the number of messages before it."""
    found, messages = [], 0
    for step in steps:
        messages += isinstance(step, Send | Receive)
        found.append(messages)
    return found
