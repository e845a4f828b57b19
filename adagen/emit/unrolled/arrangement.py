"""Order of a process's values, their division into functions, and their places in memory.

Between two messages a process's values form one stretch: a straight line, divided into functions of
limited length. The contents of a message are computed before it is sent; everything else waits.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from adagen.emit.unrolled.computed_again import compute_again
from adagen.emit.unrolled.order import Pace, in_functions, limit_of_functions
from adagen.executor import KEPT, RECEIVED, SINGULAR, Check, Machine, Simulated
from adagen.graph import Node, live_nodes
from adagen.plan.stages import Stage, stages
from adagen.plan.types import Process
from adagen.schedule.costs import StepCosts


@dataclass
class Chunk:
    """One function.

    Attributes:
        values: indices of the values that it computes, in order.
        loads: values from earlier chunks, by their place in the workspace.
        stores: values that later chunks need, likewise.
    """

    values: list[int]
    loads: dict[int, int] = field(default_factory=dict)
    stores: dict[int, int] = field(default_factory=dict)


@dataclass(frozen=True)
class Stretch:
    """The computations between two messages.

    Attributes:
        stage: place of the last stage of work in it; None where there is none.
        chunks: its functions.
    """

    stage: int | None
    chunks: tuple[Chunk, ...]


@dataclass(frozen=True)
class Arrangement:
    """A process's work: before each stage that is a message, and at the end, a stretch.

    Attributes:
        stretches: by the place of the stage that they precede; the last by the number of stages.
        after: what waits for a loop that sweeps residuals, behind all others.
        places: values that the workspace holds at once.
        turns: when a value is computed, by its index.
    """

    stretches: dict[int, Stretch]
    places: int
    turns: dict[int, int]
    after: Stretch = field(default_factory=lambda: Stretch(None, ()))


def arranged(
    process: Process,
    simulated: Simulated,
    longest: int,
    costs: StepCosts | None,
    *,
    kept: int = 0,
) -> Arrangement:
    """Return the arrangement of a process.

    Args:
        process: the process.
        simulated: it, after all steps.
        longest: values of one function; 0 for the default.
        costs: by which a single state is put in order; None where many are solved at once.
        kept: places that are left alone: those of a loop that does not run in this line.
    """
    machine, ends = simulated.machine, simulated.ends
    pending: list[int] = []
    done = 0
    last_work: int | None = None
    stretches: dict[int, Stretch] = {}
    alive = values_of(simulated)
    pace = None if costs is None else Pace.of(simulated.operations, len(alive), costs)
    short = machine.swept is not None
    longest = longest or limit_of_functions(len(alive), pace, short=short)
    found = stages(process)
    waiting = _waiting(machine, alive)
    alive = [k for k in alive if k not in waiting]
    for place, stage in enumerate([*found, None]):
        if stage is not None and stage.message is None:
            last_work = place
            continue
        end = ends[found[place - 1].last - 1] if place > 0 else 0
        while done < len(alive) and alive[done] < end:
            pending.append(alive[done])
            done += 1
        now = _needed(machine, pending, stage)
        pending = [k for k in pending if k not in now]
        functions = in_functions(machine.graph, process, now, longest, pace)
        stretches[place] = Stretch(last_work, tuple(map(Chunk, functions)))
        last_work = None
    functions = in_functions(machine.graph, process, waiting, longest, pace) if waiting else []
    after = Stretch(None, tuple(map(Chunk, functions)))
    chunks = [chunk for each in (*stretches.values(), after) for chunk in each.chunks]
    computed = (index for chunk in chunks for index in chunk.values)
    turns = {index: turn for turn, index in enumerate(computed)}
    if costs is None:
        compute_again(machine.graph, chunks, {root.index for root in machine.roots()})
    return Arrangement(stretches, _assign_places(machine, chunks, turns, kept), turns, after)


def values_of(simulated: Simulated) -> list[int]:
    """Return the indices of what a process computes, or gets in messages."""
    nodes = simulated.machine.graph.nodes
    return [k for k in simulated.alive if nodes[k].op != "constant" and not is_given(nodes[k])]


def _waiting(machine: Machine, alive: Sequence[int]) -> set[int]:
    """The values that depend on what a loop gives that sweeps residuals."""
    nodes, waiting = machine.graph.nodes, set[int]()
    if machine.swept is None:
        return waiting
    for k in alive:
        if any(a in waiting or is_swept(nodes[a]) for a in nodes[k].args):
            waiting.add(k)
    return waiting


def is_given(node: Node) -> bool:
    """Whether a value is an input that is there from the start, not from a message."""
    return node.op == "input" and not str(node.value).startswith(RECEIVED)


def is_swept(node: Node) -> bool:
    """Whether a value is an input that a loop gives which sweeps residuals."""
    return node.op == "input" and str(node.value).startswith(KEPT)


def _needed(machine: Machine, pending: Iterable[int], stage: Stage | None) -> set[int]:
    """The pending values that a message needs; all of them unless it is sent."""
    pending = set(pending)
    if stage is None or stage.what != "send" or stage.message is None:
        return pending
    wanted = set(live_nodes(machine.graph, machine.sent[stage.message]))
    # Whether to do it all again is known to others by the message: that is looked at before.
    singular = [
        x
        for c in machine.checks
        if c.failure == SINGULAR and c.pivot.index in pending
        for x in (c.pivot, c.least)
    ]
    wanted.update(live_nodes(machine.graph, singular))
    # A message's slot may be written anew once it is answered: it is read before that.
    wanted.update(k for k in pending if machine.graph.nodes[k].op == "input")
    return pending & wanted


def looked_at(check: Check, turns: Mapping[int, int]) -> list[int]:
    """The computed values of a check, in order: the check is possible after the last."""
    indices = {check.pivot.index, check.least.index} & turns.keys()
    return sorted(indices, key=turns.__getitem__)


def _assign_places(
    machine: Machine, chunks: Sequence[Chunk], turns: Mapping[int, int], kept: int
) -> int:
    """Give each value that is used beyond its chunk a place, a wide one several.

    Places are used again, but for the first ones that are ``kept``.
    """
    users = _users_beyond(machine, chunks, turns)
    nodes = machine.graph.nodes
    free: dict[int, list[int]] = defaultdict(list)  # by width; wide values are aligned
    swept = machine.swept
    left = {} if swept is None else swept.first_places()
    count = kept if swept is None else swept.places
    place: dict[int, int] = {}
    for k, chunk in enumerate(chunks):
        for index in chunk.values:
            if index in left:
                place[index] = chunk.stores[index] = left[index]
            elif index in users and index not in place:  # where it is computed first
                width = nodes[index].width
                if not free[width]:
                    first = -(-count // width) * width
                    free[width], count = [first], first + width
                place[index] = chunk.stores[index] = free[width].pop()
        for index, wanting in users.items():
            if k in wanting:
                chunk.loads[index] = place[index]
                if wanting[-1] == k and index not in left:
                    free[nodes[index].width].append(place[index])
    return count


def _users_beyond(
    machine: Machine, chunks: Sequence[Chunk], turns: Mapping[int, int]
) -> dict[int, list[int]]:
    """For each value, the later chunks that use it, in order."""
    home: dict[int, int] = {}
    for k, chunk in enumerate(chunks):
        for index in chunk.values:
            home.setdefault(index, k)
    partners: dict[int, list[int]] = defaultdict(list)  # what is looked at together
    for check in machine.checks:
        *others, last = looked_at(check, turns) or [-1]
        partners[last] += others
    users: dict[int, list[int]] = defaultdict(list)
    for k, chunk in enumerate(chunks):
        wanted = {arg for index in chunk.values for arg in machine.graph.nodes[index].args}
        wanted.update(partner for index in chunk.values for partner in partners[index])
        for arg in sorted(wanted.difference(chunk.values)):
            if home.get(arg, k) != k:
                users[arg].append(k)
    return users
