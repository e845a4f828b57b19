"""The straight line of one process, number by number, with the operands of each number.

A number is a *pair*: a value of the graph and a lane of it, 0 where it is a single number.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Any

from adagen.executor.grouping import least_of, offered_groupings
from adagen.executor.lane_frames import aligned
from adagen.executor.machine import Machine
from adagen.executor.run import Simulated, after_all_steps
from adagen.graph import Expression, Node, with_fused
from adagen.plan.types import Plan

Pair = tuple[int, int]


@dataclass(frozen=True)
class Looked:
    """One number that is checked.

    Attributes:
        place: of its check in the machine.
        joint: what fails.
        pivot: the number.
        least: what it must exceed.
    """

    place: int
    joint: int
    pivot: Pair
    least: Pair


class Line:
    """The straight line of one process.

    Args:
        plan: of one process.
        simulated: the process after all its steps.

    Attributes:
        plan: as given.
        machine: the process's.
        nodes: the values of its graph, sums that take up products among them.
    """

    def __init__(self, plan: Plan, simulated: Simulated) -> None:
        self.plan, self.machine = plan, simulated.machine
        self.nodes: list[Node] = simulated.machine.graph.nodes
        self.nodes = self._with_fused(simulated.alive)

    def _with_fused(self, alive: Collection[int]) -> list[Node]:
        """Its values with sums that take up products, which are then rounded once.

        Which do is decided here, once: what is copied for processes and lanes, and batches, is this
        line. What processes send each other is computed by itself.
        """
        kept = {x.index for x in self.machine.roots()}
        handed = (*self.passed.values(), *self.eliminated.values())
        kept |= {index for own in handed for index, _ in own}
        fused = with_fused(self.nodes, alive, kept)
        return [fused.get(index, node) for index, node in enumerate(self.nodes)]

    @cached_property
    def results(self) -> dict[int, list[Pair]]:
        """The accelerations of each joint."""
        return {
            each: [self.pair(x, k) for x in values]
            for j, values in self.machine.results.items()
            for k, each in self._members(j, self.machine.lanes_of_result(j))
        }

    def _members(self, j: int, lanes: Sequence[int]) -> list[tuple[int, int]]:
        """The joints of a row by lane, without those that idle lanes repeat."""
        return list(enumerate(lanes))[: len(self.machine.rows.own(j))]

    @cached_property
    def forces(self) -> dict[int, list[Pair]]:
        """Forces of loops and couplings, by their first entries in an answer."""
        return {k: [self.pair(x, 0) for x in own] for k, own in self.machine.forces.items()}

    @cached_property
    def certificate(self) -> list[Pair]:
        """The squares of the energy norms of error and answer, where that is certified."""
        return [self.pair(x, 0) for x in self.machine.certificate]

    @cached_property
    def outputs(self) -> dict[int, list[Pair]]:
        """The numbers of each output of the scene, by its place in the plan."""
        return {k: [self.pair(x, 0) for x in own] for k, own in self.machine.outputs.items()}

    @cached_property
    def checks(self) -> list[Looked]:
        """The checked numbers, in order."""
        return [
            Looked(place, joint, self.pair(check.pivot, k), self.pair(check.least, k))
            for place, check in enumerate(self.machine.checks)
            for k, joint in enumerate(self.machine.rows.own(check.joint))
        ]

    @cached_property
    def passed(self) -> dict[int, list[Pair]]:
        """The contribution of each joint to its near link, without constants."""
        rows = self.machine.rows
        return self._handed(
            (rows.own(lead), value) for (_, lead), value in self.machine.passed.items()
        )

    @cached_property
    def eliminated(self) -> dict[int, list[Pair]]:
        """The contribution of each closure to its top, likewise."""
        return self._handed(
            (numbers, value) for (_, numbers), value in self.machine.eliminated.items()
        )

    def _handed(self, values: Iterable[tuple[Sequence[int], Any]]) -> dict[int, list[Pair]]:
        """The numbers of values by who hands them, one in each lane."""
        found: dict[int, list[Pair]] = {}
        for lanes, value in values:
            for k, who in enumerate(lanes):
                own = found.setdefault(who, [])
                own += [self.pair_of(x, k) for x in value.flat if x.constant is None]
        return found

    def pair(self, x: Expression, k: int) -> Pair:
        """Return the number that a value has in a lane; a single one has it in all."""
        return (x.index, k if x.node.width > 1 else 0)

    def pair_of(self, x: Expression, k: int) -> Pair:
        """Return the number that is sent for another: itself, or its negative."""
        pair = self.unpacked(self.pair(x, k))
        while self.nodes[pair[0]].op == "neg":
            pair = self.unpacked(self.operands(pair)[0])
        return pair

    def unpacked(self, pair: Pair) -> Pair:
        """Return the number itself where it is moved into a lane or out of it."""
        while self.nodes[pair[0]].op in ("lane", "pack"):
            (pair,) = self.operands(pair)
        return pair

    def operands(self, pair: Pair) -> list[Pair]:
        """Return the operands of a number."""
        index, lane = pair
        node = self.nodes[index]
        if node.op == "pack":
            return [(node.args[lane], 0)]
        if node.op == "lane":
            return [(node.args[0], int(node.value))]
        if node.op == "across":
            return [(node.args[0], k) for k in range(node.value)]
        if node.op == "input":
            return self._argument(pair)
        return [(k, lane if self.nodes[k].width > 1 else 0) for k in node.args]

    def _argument(self, pair: Pair) -> list[Pair]:
        """The angle of a sine or cosine, the rate of a tangent."""
        word, place = str(self.nodes[pair[0]].value).removesuffix("]").split("[")
        k = int(place) + pair[1]
        if word in ("sine", "cosine"):
            return [(self.machine.angles[k].index, 0)]
        return [(self.machine.tangents[k][0].index, 0)] if word == "tangent" else []

    def sums(self) -> Iterator[Pair]:
        """Yield the sums of single numbers, in the order in which they are computed."""
        for index, node in enumerate(self.nodes):
            if node.op == "add" and node.width == 1:
                yield index, 0

    def torques(self) -> Iterator[tuple[Pair, int]]:
        """Yield the inputs in tau, and their places there."""
        for index, node in enumerate(self.nodes):
            if node.op == "input" and str(node.value).startswith("tau["):
                yield (index, 0), int(str(node.value)[4:-1])

    def needs(self, roots: Iterable[Pair], known: Collection[Pair]) -> set[Pair]:
        """Return the numbers from which some numbers are computed, themselves included.

        Args:
            roots: these numbers.
            known: numbers behind which nothing is looked for.
        """
        found: set[Pair] = set()
        waiting = list(roots)
        while waiting:
            pair = waiting.pop()
            if pair in found or self.nodes[pair[0]].op == "constant":
                continue
            found.add(pair)
            if pair not in known:
                waiting += self.operands(pair)
        return found


@lru_cache(maxsize=4)
def line_of(plan: Plan) -> Line:
    """Return the straight line of a reproducible plan for one process, which must not be changed.

    Which limbs share it is chosen by the shipped costs, whatever the machine's are: frames are
    turned, and numbers added up, as suits these limbs.
    """
    free = replace(plan, reproducible=False)
    limbs = least_of(free, offered_groupings(free))
    robot = aligned(plan, limbs[0]) if limbs[0] else plan
    steps = plan.processes[0].steps
    machine = Machine(robot, {}, all_limbs=limbs[0], steps=steps, unturned=plan)
    (simulated,) = after_all_steps(plan, [machine])
    return Line(plan, simulated)
