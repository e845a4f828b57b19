"""The plan: the steps of each process, frozen and serialisable.

A plan is the whole input of the emitter and of the executor. Its steps and the buffers that they
name are in adagen/plan/steps/.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import chain
from typing import Any, TypeVar, overload

from adagen.model.kinds import KINDS
from adagen.model.paths import joints_on_links, paths_to_ground
from adagen.plan import steps as do
from adagen.plan.messages import Message
from adagen.plan.robot import (
    OPTIONAL,
    PlanCoupling,
    PlanJoint,
    PlanLink,
    PlanLoop,
    PlanOutput,
    PlanParameter,
    PlanWrench,
)
from adagen.plan.steps import Block, Step, blocks_set_by

A = TypeVar("A")
B = TypeVar("B")

THREADS = "threads"
"""The channel between processes that are threads of one program."""
SCALARS = ("double", "float")
"""Types of all numbers of a solver."""


@dataclass(frozen=True)
class Process:
    """The steps of one process, and its joints.

    Attributes:
        steps: in order.
        reads: joints whose q and v it reads, ascending.
        owns: joints whose torque it reads and whose acceleration it gives, ascending.
        shares: further joints whose torque it reads and whose acceleration it computes for itself.
        recovery: steps that replace ``steps`` in poses in which these fail: a mobility cannot be
            inverted, or a closure's choice is poor; empty if there is no replacement.
        others: further replacements, in the order in which they are tried.
        spares: further joints whose torque it reads, and whose acceleration it computes, only in
            replacements.
    """

    steps: tuple[Step, ...]
    reads: tuple[int, ...]
    owns: tuple[int, ...]
    shares: tuple[int, ...] = ()
    recovery: tuple[Step, ...] = field(default=(), metadata=OPTIONAL)
    others: tuple[tuple[Step, ...], ...] = field(default=(), metadata=OPTIONAL)
    spares: tuple[int, ...] = field(default=(), metadata=OPTIONAL)

    @property
    def treated(self) -> list[int]:
        """Joints whose acceleration it computes, ascending."""
        return sorted((*self.owns, *self.shares))

    @overload
    def steps_of(self, first: type[A], /) -> Iterator[A]: ...
    @overload
    def steps_of(self, first: type[A], second: type[B], /) -> Iterator[A | B]: ...
    def steps_of(self, *kinds: type) -> Iterator[Any]:
        """Yield its steps of one kind, or of two, in order."""
        if not any(issubclass(sort, kinds) for sort in self._sorts):
            return iter(())  # as for most kinds in most processes
        return (step for step in self.steps if isinstance(step, kinds))

    def changed(self, change: Callable[[tuple[Step, ...]], tuple[Step, ...]]) -> Process:
        """Return it with its steps, and those that replace them if any, changed alike."""
        return replace(
            self,
            steps=change(self.steps),
            recovery=change(self.recovery) if self.recovery else (),
            others=tuple(change(steps) for steps in self.others),
        )

    @cached_property
    def _sorts(self) -> frozenset[type]:
        return frozenset(map(type, self.steps))


@dataclass(frozen=True)
class Plan:
    """A frozen plan: who computes what, when, from what.

    Attributes:
        name: the robot's name (data, not fit for code).
        source_hash: of the robot description, hexadecimal.
        form: "ada" or "segment".
        scalar: one of ``SCALARS``.
        channel: "auto", "window" or "message": what the emitted program prefers; or "threads":
            processes are threads of one program.
        schedule: the schedule in one line.
        floating: whether joint 0 is the floating base ``__base__``.
        gravity: 3 numbers, m/s^2.
        links: the ground first.
        joints: in depth-first order.
        slaved: slaved joints; each adds a right-hand side.
        processes: one entry per process.
        messages: numbered by their place.
        wrenches: outer forces.
        profile: name of the cost profile by which its program was chosen.
        loops: joints that close loops.
        couplings: joints whose coordinates are tied.
        reproducible: whether its processes share out the straight line of one, so that answers are
            the same to the last bit on any number of them (adagen/plan/shared_line.py).
        line: the steps of one process, whose straight line several processes share; empty where
            they follow from the joints, or each process takes its own.
        parameters: constants that can be set at run time.
        loop_forces: whether forces of loops and couplings are given behind the accelerations.
        tied_rows: constraints of loops and couplings that have a right-hand side each, as slaved
            joints have: numbers of their forces in the plan's one closure (form ada).
        wanted: joints whose accelerations are given, ascending; none stands for all.
        outputs: what is given beside accelerations, behind them in qdd.
        at_rest: whether all velocities are zero.
    """

    name: str
    source_hash: str
    form: str
    scalar: str
    channel: str
    schedule: str
    floating: bool
    gravity: tuple[float, ...]
    links: tuple[PlanLink, ...]
    joints: tuple[PlanJoint, ...]
    slaved: tuple[int, ...]
    processes: tuple[Process, ...]
    messages: tuple[Message, ...]
    wrenches: tuple[PlanWrench, ...] = field(default=(), metadata=OPTIONAL)
    profile: str = field(default="default", metadata=OPTIONAL)
    loops: tuple[PlanLoop, ...] = field(default=(), metadata=OPTIONAL)
    couplings: tuple[PlanCoupling, ...] = field(default=(), metadata=OPTIONAL)
    reproducible: bool = field(default=False, metadata=OPTIONAL)
    line: tuple[Step, ...] = field(default=(), metadata=OPTIONAL)
    parameters: tuple[PlanParameter, ...] = field(default=(), metadata=OPTIONAL)
    loop_forces: bool = field(default=False, metadata=OPTIONAL)
    tied_rows: tuple[int, ...] = field(default=(), metadata=OPTIONAL)
    wanted: tuple[int, ...] = field(default=(), metadata=OPTIONAL)
    outputs: tuple[PlanOutput, ...] = field(default=(), metadata=OPTIONAL)
    at_rest: bool = field(default=False, metadata=OPTIONAL)

    def __hash__(self) -> int:
        """Return a hash that is computed once: what is found for a plan is kept by it."""
        return self._hash

    @cached_property
    def _hash(self) -> int:
        return hash((self.name, self.schedule, self.processes, self.messages))

    def wants(self, joint: int) -> bool:
        """Return whether a joint's acceleration is given."""
        return not self.wanted or joint in self.wanted

    def place(self, number: int) -> str:
        """Return a number of a failure in words: joints, then loops, then couplings."""
        kinds = (("joint", self.joints), ("loop", self.loops), ("coupling", self.couplings))
        for what, things in kinds:
            if number < len(things):
                return f'{what} "{things[number].name}"'
            number -= len(things)
        raise IndexError(number)

    @property
    def certified(self) -> bool:
        """Whether the error of each answer is bounded."""
        return any(isinstance(p.steps[-1], do.Certify) for p in self.processes if p.steps)

    @overload
    def steps_of(self, first: type[A], /) -> Iterator[A]: ...
    @overload
    def steps_of(self, first: type[A], second: type[B], /) -> Iterator[A | B]: ...
    def steps_of(self, *kinds: type) -> Iterator[Any]:
        """Yield the steps of one kind, or of two, process by process."""
        return chain.from_iterable(process.steps_of(*kinds) for process in self.processes)

    @property
    def steps(self) -> Iterator[Step]:
        """The steps of all processes, one process after the other."""
        return chain.from_iterable(process.steps for process in self.processes)

    @property
    def all_steps(self) -> Iterator[Step]:
        """The same, with those of each process's recovery behind its others."""
        return chain.from_iterable((*p.steps, *p.recovery) for p in self.processes)

    @property
    def several(self) -> bool:
        """Whether several processes have something to do."""
        return sum(bool(process.steps) for process in self.processes) > 1

    def mobility_of(self, link: int) -> Block:
        """Return the block that holds a link's mobility, which some step sets."""
        blocks = (block for step in self.steps for block in blocks_set_by(step))
        return next(block for block in blocks if (block.row, block.column) == (link, link))

    @cached_property
    def corrections(self) -> int:
        """How many times each answer is corrected by a residual in the solver's own numbers."""
        return max((step.count for step in self.steps_of(do.Refine)), default=0)

    @property
    def weighed(self) -> bool:
        """Whether the residual of an answer is swept inwards."""
        return self.certified or self.corrections > 0

    @property
    def closed(self) -> bool:
        """Whether it has loops or couplings."""
        return bool(self.loops or self.couplings)

    @property
    def right_hand_sides(self) -> int:
        """Columns of every bias, force and acceleration.

        One is the motion; then there is one for each slaved joint, for each tied row, and for each
        freedom that is lent inertia.
        """
        return 1 + len(self.slaved) + len(self.tied_rows) + len(self.lent)

    @cached_property
    def lent(self) -> tuple[tuple[int, int], ...]:
        """Freedoms with artificial inertia: joint, and number among its freedoms."""
        joints = (j for j, joint in enumerate(self.joints) if joint.lent)
        return tuple((j, k) for j in joints for k in range(KINDS[self.joints[j].kind].nv))

    @cached_property
    def children(self) -> tuple[tuple[int, ...], ...]:
        """For each link the joints that it is the parent of, ascending."""
        return joints_on_links(self.joints)

    @property
    def threads(self) -> bool:
        """Whether its processes are threads of one program, which needs no MPI."""
        return self.channel == THREADS and len(self.processes) > 1

    @property
    def launched(self) -> int:
        """How many processes a launcher starts."""
        return 1 if self.threads else len(self.processes)

    def recovering(self) -> Plan:
        """Return the plan of the recovery steps."""
        processes = (
            replace(p, steps=p.recovery, recovery=next(iter(p.others), ()), others=p.others[1:])
            for p in self.processes
        )
        return replace(self, processes=tuple(processes), line=())

    def without_passive_torques(self) -> Plan:
        """Return the plan without damping, friction and springs: factors are the same."""
        free = (replace(j, damping=0.0, friction=0.0, stiffness=0.0) for j in self.joints)
        return replace(self, joints=tuple(free))

    def held_back(self) -> Plan:
        """Return the plan in which closures carry no rows, where there is one; else this one."""
        carries = any(self.steps_of(do.CarryRows))
        return self.recovering() if carries and self.recovers else self

    @property
    def recovers(self) -> bool:
        """Whether there are recovery steps for some poses."""
        return any(process.recovery for process in self.processes)

    @property
    def alternatives(self) -> tuple[Plan, ...]:
        """This plan and its replacements, in the order in which they are tried."""
        plans = [self]
        while plans[-1].recovers:
            plans.append(plans[-1].recovering())
        return tuple(plans)

    @property
    def for_batches(self) -> Plan:
        """The plan for many states at once.

        Lanes of a batch go the same way: the first one, or the last one, which suits all closed
        poses, where a pose in a group is poor. Reproducible ones have all ways, of which each lane
        goes its own, so that neighbours do not matter. Their code is fetched once for all lanes: no
        loop sweeps residuals.
        """
        if any(step.looped for step in self.steps_of(do.Certify)):
            return self.with_looped(0)
        if not self.closed or self.reproducible:
            return self
        ways = [(process, (process.recovery, *process.others)) for process in self.processes]
        processes = (replace(p, recovery=again[-1], others=()) for p, again in ways)
        return replace(self, processes=tuple(processes))

    @property
    def nv(self) -> int:
        """Degrees of freedom."""
        return sum(KINDS[joint.kind].nv for joint in self.joints)

    @property
    def nqdd(self) -> int:
        """Numbers in qdd: accelerations, then outputs, then forces of loops if asked for."""
        if self.loop_forces:
            return self.entry_of_coupling(len(self.couplings))
        return self.entry_of_output(len(self.outputs))

    def entry_of_wrench(self, k: int) -> int:
        """Return where the six numbers of outer force ``k`` start in tau."""
        return self.nv + 6 * k

    def entry_of_loop(self, k: int) -> int:
        """Return where the six numbers of the force of loop ``k`` start, behind outputs."""
        return self.entry_of_output(len(self.outputs)) + 6 * k

    def entry_of_coupling(self, k: int) -> int:
        """Return where the force of coupling ``k`` is, behind those of the loops."""
        return self.entry_of_loop(len(self.loops)) + k

    def force_entries(self, process: Process) -> list[int]:
        """Return the entries of forces that a process gives, ascending: those at its own joints."""
        if not self.loop_forces:
            return []
        if self.tied_rows:  # they are found where all is solved for
            solves = any(process.steps_of(do.SolveCoupling))
            return list(range(self.entry_of_loop(0), self.nqdd)) if solves else []
        found: list[int] = []
        for k, loop in enumerate(self.loops):
            if max(loop.links) - 1 in process.owns:
                found += range(self.entry_of_loop(k), self.entry_of_loop(k) + 6)
        for k, coupling in enumerate(self.couplings):
            if coupling.terms[0][0] in process.owns:
                found.append(self.entry_of_coupling(k))
        return found

    def entry_of_output(self, k: int) -> int:
        """Return where the numbers of output ``k`` start in qdd."""
        return self.nv + sum(output.size for output in self.outputs[:k])

    @property
    def parameter_values(self) -> tuple[float, ...]:
        """The numbers of all parameters, one parameter after the other."""
        return tuple(x for parameter in self.parameters for x in parameter.values)

    def entry_of_parameter(self, what: str, link: int = 0) -> int | None:
        """Return where a parameter starts among the numbers of all; None where it is constant."""
        first = 0
        for parameter in self.parameters:
            if (parameter.what, parameter.link) == (what, link):
                return first
            first += len(parameter.values)
        return None

    @property
    def sets_inertias(self) -> bool:
        """Whether masses or centres of mass of links can be set at run time."""
        return any(parameter.link for parameter in self.parameters)

    @cached_property
    def following(self) -> tuple[tuple[int, int, float], ...]:
        """Each slaved joint, its source, and the multiplier between their accelerations."""
        mimics = ((j, self.joints[j].mimic) for j in self.slaved)
        return tuple((j, mimic[0], mimic[1]) for j, mimic in mimics if mimic is not None)

    def source_of(self, j: int) -> int:
        """Return the joint that joint j follows if it is slaved, else itself."""
        mimic = self.joints[j].mimic
        return j if mimic is None else mimic[0]

    def paths(self, joints: Iterable[int]) -> set[int]:
        """Return the joints from the ground down to some joints, these included."""
        return paths_to_ground(self.joints, joints)

    def with_looped(self, rows: int) -> Plan:
        """Return it with a loop that sweeps residuals of so many rows, see ``Certify.looped``."""

        def changed(steps: tuple[Step, ...]) -> tuple[Step, ...]:
            return tuple(replace(s, looped=rows) if isinstance(s, do.Certify) else s for s in steps)

        # What is done again in rare poses is long: it is never at hand.
        processes = tuple(replace(p, steps=changed(p.steps)) for p in self.processes)
        return replace(self, processes=processes)
