"""What straight lines of statements take: shape `unrolled`.

The statements are an expression graph, so that what a robot's structure saves is known exactly.
Between two messages a process's statements are one stretch. Its time is that of its operations, of
its sines and cosines, and of its longest chain of operations that wait for each other.
"""

from __future__ import annotations

from collections.abc import Sequence

from adagen.cost.features import Features, added
from adagen.executor import Simulated, straight_line
from adagen.graph import live_nodes
from adagen.plan import Plan
from adagen.plan.steps import Receive, Send, Step
from adagen.program import Program
from adagen.schedule.costs import StepCosts

HELD = 2500
"""Statements whose instructions a first-level instruction cache of 32 kB holds, about: straight
lines that are longer are fetched anew in each evaluation."""

_COMPUTED = ("add", "sub", "mul", "reciprocal")


def straight_features(plan: Plan) -> Features:
    """Return what the straight line of a plan on one process is made of."""
    (process,) = straight_line(plan)
    steps = plan.processes[0].steps
    parts = _stretches(process, steps)
    return added([{"unrolled.evaluation": 1}, *(features for features, _ in parts)])


def straight_times(program: Program, costs: StepCosts) -> list[list[float]]:
    """Return the time of every operation of every process, microseconds on a core of speed 1.

    The operations of a stretch share its time by their statements.
    """
    found = []
    processes = zip(straight_line(program.plan), program.plan.processes, strict=True)
    for simulated, process in processes:
        times = [0.0] * len(process.steps)
        for features, statements in _stretches(simulated, process.steps):
            total, all_of_them = costs.total(features), max(1, sum(statements.values()))
            for step, count in statements.items():
                times[step] = total * count / all_of_them
        found.append(times)
    return found


def _stretches(
    simulated: Simulated, steps: Sequence[Step]
) -> list[tuple[Features, dict[int, int]]]:
    """What each stretch between messages is made of, and the statements of each of its steps."""
    graph, stretch = simulated.machine.graph, _stretch_of(steps)
    counts: list[dict[int, int]] = [{} for _ in range(stretch[-1] + 1 if stretch else 1)]
    done = [0] * len(counts)  # cycles until a stretch's last value is there
    ready: dict[int, int] = {}
    for index in live_nodes(graph, simulated.machine.roots()):
        node = graph.nodes[index]
        here = stretch[node.mark] if stretch else 0
        before = max((graph.nodes[k].ready for k in node.args), default=0)
        own = node.ready - before if node.args else max(0, node.ready)
        waits = (ready[k] for k in node.args if stretch[graph.nodes[k].mark] == here)
        ready[index] = own + max(waits, default=0)
        done[here] = max(done[here], ready[index])
        if node.op in _COMPUTED:
            counts[here][node.mark] = counts[here].get(node.mark, 0) + 1
    operations = simulated.operations
    computed = sum(sum(count.values()) for count in counts) or 1
    # A sum takes up a product; what is done in SIMD lanes is done once, and moved into them.
    statements = operations.arithmetic - operations.fused + operations.moves
    parts = []
    for k, (count, cycles) in enumerate(zip(counts, done, strict=True)):
        share = sum(count.values()) / computed
        features: Features = {
            "unrolled.operation": statements * share,
            "unrolled.fetched": max(0.0, statements - HELD) * share,
            "unrolled.sine": len(simulated.machine.angles) if k == 0 else 0,
            "unrolled.cycle": cycles,
        }
        parts.append((features, count))
    return parts


def _stretch_of(steps: Sequence[Step]) -> list[int]:
    """By step: how many messages were exchanged before it."""
    found, messages = [], 0
    for step in steps:
        messages += isinstance(step, Send | Receive)
        found.append(messages)
    return found
