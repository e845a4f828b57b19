"""Copies the part of the straight line that a process needs into a graph of its own."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from functools import partial, reduce
from itertools import groupby

import numpy as np

from adagen.executor.checks import Check
from adagen.executor.lanes import in_lanes
from adagen.executor.line import Line, Looked, Pair
from adagen.executor.machine import RECEIVED, Machine
from adagen.executor.needed_values import NeededValues
from adagen.executor.run import Simulated
from adagen.graph import Expression, Node, RoundedGraph
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Receive, Send, StartEmpty, StartLink, Step
from adagen.union_find import UnionFind


class WaitingLanesError(Exception):
    """Lanes wait for a message together, and one of them is to be sent before it."""


def copied(want: NeededValues, limbs: tuple[Limbs, ...]) -> Simulated:
    """Return a process after all its steps.

    Args:
        want: what it needs of the line.
        limbs: those of its limbs that share code, one in each lane.

    Raises:
        WaitingLanesError: they cannot.
    """
    return _Copy(want, limbs).simulated()


class _Copy:
    def __init__(self, want: NeededValues, limbs: tuple[Limbs, ...]) -> None:
        self.want, self.line = want, want.line
        self.graph = RoundedGraph(want.plan.scalar)
        self.machine = Machine(self.line.machine.plan, {}, None, self.graph, limbs)
        self.pairs, self.looked = want.all_of_it()
        self.lanes: dict[int, list[int]] = {}
        if limbs:
            self.pairs, self.lanes = shared_lanes(self.line, self.pairs, want.missing)
        self._wide: dict[int, Expression] = {}
        self._single: dict[Pair, Expression] = {}
        self._places = {_key(step): k for k, step in reversed(list(enumerate(want.own.steps)))}

    def simulated(self) -> Simulated:
        """Copy everything: what waits for no message first, what waits for one last."""
        late = self._late()
        self._copy(self.pairs - late, 0)
        self._send()
        ends = [len(self.graph.nodes)] * len(self.want.own.steps)
        received = self._receive(ends)
        self._copy(late - self.want.missing.keys(), received)
        self._results()
        self._looked_at()
        ends[received:] = [len(self.graph.nodes)] * len(ends[received:])
        return Simulated(self.machine, tuple(ends))

    def _late(self) -> set[Pair]:
        """Values that wait for a message; lanes side by side wait together."""
        late: set[Pair] = set(self.want.missing)
        for index, pairs in groupby(sorted(self.pairs), key=lambda pair: pair[0]):
            own = [pair for pair in pairs if pair not in self.want.missing]
            waits = {pair for pair in own if not late.isdisjoint(self.line.operands(pair))}
            late |= set(own) if waits and index in self.lanes else waits
        return late

    # -- values -----------------------------------------------------------------------------------

    def _copy(self, pairs: Iterable[Pair], earliest: int) -> None:
        """Copy numbers, in their order; their steps are this one or later."""
        for pair in sorted(pairs):
            index, lane = pair
            self.graph.mark = max(self._place(index, lane), earliest)
            if index not in self.lanes:
                self._single[pair] = self._one(pair)
            elif index not in self._wide:
                self._wide[index] = self._several(index)

    def _place(self, index: int, lane: int) -> int:
        """The step in which a number is computed: that of its own joint, if it is single."""
        node = self.line.nodes[index]
        step = self.line.plan.processes[0].steps[node.mark]
        what, joint = _key(step)
        row = self.line.machine.rows.lanes(joint)
        own = row[lane : lane + 1] if index not in self.lanes else ()
        known = (self._places.get((what, j)) for j in (*own, *row))
        return next((place for place in known if place is not None), 0)

    def _one(self, pair: Pair) -> Expression:
        node = self.line.nodes[pair[0]]
        operands = [self.number(operand) for operand in self.line.operands(pair)]
        if node.op == "input":
            return self._given(str(node.value), operands, pair[1:])
        if node.op in ("pack", "lane"):
            return operands[0]
        if node.op == "across":  # one by one, whatever lanes there are
            return reduce(self.graph.add, operands)
        return self._operation(node)(*operands)

    def _several(self, index: int) -> Expression:
        node, lanes = self.line.nodes[index], in_lanes(self.lanes[index])
        if node.op in ("pack", "input"):
            each = [self.number(self.line.operands((index, lane))[0]) for lane in lanes]
            packed = self.graph.pack(each)
            return packed if node.op == "pack" else self._given(str(node.value), [packed], lanes)
        return self._operation(node)(*(self._value(k, lanes) for k in node.args))

    def _given(self, name: str, argument: Sequence[Expression], lanes: Sequence[int]) -> Expression:
        """An input by its name in the line; of a sine, cosine or tangent, its angle or rate."""
        if not argument:
            return self.graph.input(name)
        if name.startswith("tangent"):
            first = int(name.removeprefix("tangent[").removesuffix("]"))
            factors = [self.line.machine.tangents[first + k][1].constant for k in lanes]
            own = self.graph.pack([self.graph.constant(factor) for factor in factors])
            return self.machine.tangent(argument[0], own)
        cosine, sine = self.machine.circular(argument[0])
        return cosine if name.startswith("cosine") else sine

    def _operation(self, node: Node) -> Callable[..., Expression]:
        if node.op == "multiply_add":
            return partial(self._multiply_add, *node.value)
        found: Callable[..., Expression] = getattr(
            self.graph, "larger" if node.op == "max" else node.op
        )
        return found

    def _multiply_add(
        self, product: int, addend: int, a: Expression, b: Expression, c: Expression
    ) -> Expression:
        """A product and a sum rounded once, with their signs."""
        return self.graph.multiply_add(a if product > 0 else -a, b, c if addend > 0 else -c)

    def _value(self, index: int, lanes: Sequence[int]) -> Expression:
        """A value of the line in some lanes."""
        node = self.line.nodes[index]
        if node.width == 1:
            return self.number((index, 0))
        if node.op == "constant":
            return self.graph.constant(tuple(node.value[lane] for lane in lanes))
        return self._wide[index]

    def number(self, pair: Pair) -> Expression:
        """Return a number of the line."""
        index, lane = pair
        node = self.line.nodes[index]
        if node.op == "constant":
            return self.graph.constant(node.value if node.width == 1 else node.value[lane])
        if pair in self._single:
            return self._single[pair]
        return self.graph.lane(self._wide[index], self.lanes[index].index(lane))

    # -- messages ---------------------------------------------------------------------------------

    def _send(self) -> None:
        told = {step.message for step in self.want.own.steps_of(Send)}
        for number, message in enumerate(self.want.plan.messages):
            if number in told:
                wanted = self.want.sends.get(message.target, {})
                self.machine.sent[number] = [
                    self._told(pair)
                    for pair, sender in wanted.items()
                    if sender.link in message.inertias
                ]

    def _told(self, pair: Pair) -> Expression:
        """A number that is sent: before anything is received."""
        index = pair[0]
        if index in self.lanes and pair not in self._single and index not in self._wide:
            raise WaitingLanesError
        return self.number(pair)

    def _receive(self, ends: list[int]) -> int:
        """Read all messages; return the index of the last one that is needed."""
        missing, last = self.want.missing, 0
        for place, step in enumerate(self.want.own.steps):
            if not isinstance(step, Receive):
                continue
            self.graph.mark = last = place
            message = self.want.plan.messages[step.message]
            pairs = (
                pair
                for pair, sender in missing.items()
                if sender.process == message.source and sender.link in message.inertias
            )
            for k, pair in enumerate(pairs):
                self._single[pair] = self.graph.input(f"{RECEIVED}[{step.message}][{k}]")
            ends[place:] = [len(self.graph.nodes)] * len(ends[place:])
        assert missing.keys() <= self._single.keys()  # everything is received
        return last

    # -- what is wanted ---------------------------------------------------------------------------

    def _results(self) -> None:
        line, machine = self.line.machine, self.machine
        machine.certificate = tuple(self.number(pair) for pair in self.want.certificate)
        asked = ((self.want.outputs, machine.outputs), (self.want.forces, machine.forces))
        for wanted, given in asked:
            for k, pairs in wanted.items():
                given[k] = np.array([self.number(pair) for pair in pairs], dtype=object)
        for lead, values in line.results.items():
            own = line.lanes_of_result(lead)[: len(line.rows.own(lead))]
            mine = [(k, j) for k, j in enumerate(own) if j in self.want.own.owns]
            lanes = [k for k, _ in mine]
            if len(mine) > 1 and mine[0][1] in machine.rows:
                wide = [self._result(x, lanes) for x in values]
                machine.results[mine[0][1]] = np.array(wide, dtype=object)
                continue
            for k, j in mine:
                numbers = [self.number(self.line.pair(x, k)) for x in values]
                machine.results[j] = np.array(numbers, dtype=object)

    def _result(self, x: Expression, lanes: list[int]) -> Expression:
        """An acceleration of a row; an idle lane, on which limbs may hang, has none of its own."""
        if self.lanes.get(x.index, lanes) == lanes:
            return self._value(x.index, lanes)
        return self.graph.pack([self.number((x.index, k)) for k in in_lanes(lanes)])

    def _looked_at(self) -> None:
        checks = self.line.machine.checks
        for place, own in _by_place(self.looked):
            check, index = checks[place], own[0].pivot[0]
            joints = [each.joint for each in own]
            if index in self.lanes and len(own) > 1:
                lanes = in_lanes(self.lanes[index])
                pivot, least = (self._value(x.index, lanes) for x in (check.pivot, check.least))
                if joints[0] >= len(self.want.plan.joints):  # loops or couplings
                    self.machine.rows.beyond_joints[joints[0]] = tuple(joints)
                assert self.machine.rows.own(joints[0]) == tuple(joints)
                found = [Check(pivot, least, joints[0], check.failure, check.near)]
            else:
                found = [
                    Check(
                        self.number(each.pivot),
                        self.number(each.least),
                        each.joint,
                        check.failure,
                        check.near,
                    )
                    for each in own
                ]
            self.machine.checks += found
        for length, joint in self.line.machine.lengths:
            self._length(length, joint)

    def _length(self, length: Expression, joint: int) -> None:
        """The squared length of a quaternion, where it is computed."""
        own = self.line.machine.rows.own(joint)
        joints = [(k, j) for k, j in enumerate(own) if self.line.pair(length, k) in self.pairs]
        if length.index in self.lanes and joints:
            self.machine.lengths.append((self._wide[length.index], joints[0][1]))
            return
        for k, j in joints:
            self.machine.lengths.append((self.number(self.line.pair(length, k)), j))


def _by_place(looked: Iterable[Looked]) -> Iterator[tuple[int, list[Looked]]]:
    """Checked numbers, check by check."""
    found: dict[int, list[Looked]] = {}
    for each in looked:
        found.setdefault(each.place, []).append(each)
    yield from found.items()


def _key(step: Step) -> tuple[type, int]:
    """The kind of a step, and its joint or link."""
    what = StartLink if isinstance(step, StartEmpty) else type(step)
    return what, getattr(step, "joint", getattr(step, "link", 0) - 1)


def shared_lanes(
    line: Line, pairs: set[Pair], missing: Collection[Pair]
) -> tuple[set[Pair], dict[int, list[int]]]:
    """Return the values that are computed with lanes side by side, and their lanes.

    Values that are computed of each other lane by lane have the same lanes: all that any of them
    is needed in. Values that are needed in one lane only are left out.

    Args:
        line: the straight line of one process.
        pairs: what is needed of it.
        missing: what of this comes by message.
    """
    known = set(missing)
    while True:
        together = _together(line, pairs - known)
        wanted: dict[int, set[int]] = {}
        for index, lane in pairs - known:
            if index in together:
                wanted.setdefault(together[index], set()).add(lane)
        spread = [(index, lane) for index, lead in together.items() for lane in wanted[lead]]
        more = line.needs(spread, known) - pairs
        if not more:
            break
        pairs = pairs | more
    lanes = {index: sorted(wanted[lead]) for index, lead in together.items()}
    return pairs, {index: own for index, own in lanes.items() if len(own) > 1}


def _together(line: Line, pairs: set[Pair]) -> dict[int, int]:
    """For each wide value, a representative of all that depend on each other lane by lane."""
    nodes = line.nodes
    wide = {index for index, _ in pairs if nodes[index].width > 1}
    leaders = UnionFind[int]()
    for index in wide:
        for k in nodes[index].args:
            if k in wide:
                leaders.join(k, index)
    return {index: leaders.of(index) for index in wide}
