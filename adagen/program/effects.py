"""Effects of each step: the buffers of its process that it reads and sets.

A buffer is named by a ``Block``, ``Bias`` or ``Force`` of the plan, or by a pair of a word and a
number:

* ``("velocity", link)``, ``("transform", joint)``: its motion, from kinematics, and a ``Passage``
  of the plan;
* ``("inertia", link)``: I^A and p^A of a link;
* ``("projected", joint)``: U, D and u of a joint that was swept inwards;
* ``("load", link)``, ``("acceleration", link)``, ``("joined", joint)``, ``("qdd", joint)``;
* ``("torques", 0)``: of slaved joints;
* ``("certificate", 0)``: the bound of the error; ``("share", p)``: the contribution of a process;
* ``("correction", k)``: a correction of the answer;
* ``("loop", k)``, ``("coupling", k)``, ``("held", joint)``, ``("carried", joint)``: contributions
  to their closure; ``("closure", k)``: after elimination; ``("released", k)``: solved for.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from adagen.model import LINK_ACCELERATION, REACTION_FORCE
from adagen.plan import steps as do
from adagen.plan.edges import is_base
from adagen.plan.messages import CERTIFICATE, ENERGIES, Message
from adagen.plan.order import ends_of
from adagen.plan.steps import Bias, Block, ClosedStep, Force, Passage, Step
from adagen.plan.types import Plan

Place = Block | Bias | Force | Passage | tuple[str, int]


@dataclass(frozen=True)
class Effects:
    """The buffers that a step reads, sets or adds to.

    Attributes:
        reads: must have been set.
        sets: get a new value; what they held must have been read.
        adds: are added to: must have been set, and not been read since.
        alters: are read and set again.
    """

    reads: tuple[Place, ...] = ()
    sets: tuple[Place, ...] = ()
    adds: tuple[Place, ...] = ()
    alters: tuple[Place, ...] = ()


_OfJoint = do.Kinematics | do.FreeBase | do.FreeAcceleration | do.SolveCoupling | do.ApplyCoupling
_OfLink = (
    do.LinkBias
    | do.StartLink
    | do.StartEmpty
    | do.InvertRoot
    | do.SolveRoot
    | do.SolveMobility
    | do.HoldMobility
    | do.Load
    | do.LoadRoot
    | do.AccelerateRoot
)


def joined_runs(plan: Plan) -> dict[int, tuple[int, ...]]:
    """Return the joints of each join, by the joint that names it."""
    joins = plan.steps_of(do.Join)
    return {j.joint: j.run if isinstance(j, do.FusedJoin) else (j.joint,) for j in joins}


def effects(plan: Plan, process: int, step: Step, runs: Mapping[int, tuple[int, ...]]) -> Effects:
    """Return the effects of a step that is no message.

    Args:
        plan: the plan.
        process: the number of a process.
        step: one of its steps.
        runs: what joins put together (``joined_runs``).
    """
    match step:
        case do.Join():
            return _join(step)
        case do.Disassemble():
            return _disassemble(step, runs[step.joint])
        case do.Articulate() | do.Propagate() | do.Deliver() | do.Accelerate():
            return _across(plan, step)
        case _ if isinstance(step, _OfJoint):
            return _of_joint(plan, step)
        case _ if isinstance(step, ClosedStep):
            return _closed(plan, process, step)
        case do.Traverse() | do.Append() | do.Arrive():
            return _passed(step)
        case do.Correct():
            return _correct(plan, step)
        case do.Refine() if plan.closed:
            reads = tuple(("correction", k) for k in range(step.count))
            return Effects(reads, (("energies", 0),))
        case do.Certify() | do.Refine():
            return _certify(plan, step)
        case do.GiveOutput():
            return _output(plan, step)
        case do.Send() | do.Receive():
            raise AssertionError("what a message does depends on what has been sent")
    return _of_link(step)


def _output(plan: Plan, step: do.GiveOutput) -> Effects:
    output = plan.outputs[step.output]
    if output.what == LINK_ACCELERATION:
        tied: tuple[Place, ...] = (("torques", 0),) if plan.slaved else ()
        return Effects((("velocity", output.link), ("acceleration", output.link), *tied))
    if output.what == REACTION_FORCE:
        return Effects((("qdd", output.link - 1),))
    return Effects((plan.mobility_of(output.link),))


def _of_joint(plan: Plan, step: _OfJoint) -> Effects:
    match step:
        case do.Kinematics(j):
            moving = _moving(("velocity", plan.joints[j].parent))
            return Effects(moving, (("transform", j), ("velocity", j + 1)))
        case do.FreeBase(j):
            return Effects(adds=(("inertia", j + 1),))
        case do.FreeAcceleration(j):
            return Effects((("acceleration", j + 1),), (("qdd", j),))
        case do.SolveCoupling():
            return Effects(_coupled(plan), (("torques", 0),))
        case do.ApplyCoupling():
            return Effects((("torques", 0),))


def _passed(step: do.Traverse | do.Append | do.Arrive) -> Effects:
    """Effects of a step about passages."""
    match step:
        case do.Traverse():
            return Effects(sets=(step.passage,))
        case do.Append():
            return Effects((step.near, step.far), (step.passage,))
        case do.Arrive():
            reads = (step.passage, *_moving(("velocity", step.near)))
            return Effects(reads, (("velocity", step.passage.link),))


def _of_link(step: _OfLink) -> Effects:
    link = step.link
    reads: tuple[Place, ...]
    match step:
        case do.LinkBias():
            return Effects((("velocity", link),), (Bias(None, link),))
        case do.StartLink():
            return Effects((("velocity", link),), (("inertia", link),))
        case do.StartEmpty():
            return Effects(sets=(("inertia", link),))
        case do.InvertRoot():
            return Effects((("inertia", link),), (step.block, step.bias))
        case do.SolveRoot():
            return Effects((("inertia", link),), (("acceleration", link),))
        case do.SolveMobility():
            reads = (("inertia", link), step.block, step.bias)
            return Effects(reads, (("acceleration", link),))
        case do.HoldMobility():
            return Effects((step.block, step.bias), (("inertia", link),))
        case do.Load():
            return Effects(() if step.force is None else (step.force,), (("load", link),))
        case do.LoadRoot():
            reads = (("inertia", link), ("acceleration", link))
            return Effects(reads, (("load", link),))
        case do.AccelerateRoot():
            reads = (step.block, step.bias, ("load", link))
            return Effects(reads, (("acceleration", link),))


def _closed(plan: Plan, process: int, step: ClosedStep) -> Effects:
    """Effects of a step of closed loops."""
    reads: tuple[Place, ...]
    match step:
        case do.CloseLoop():
            loop = plan.loops[step.loop]
            ends = _moving(*(("velocity", link) for link in loop.links))
            return Effects(ends, (("loop", step.loop),))
        case do.CloseCoupling():
            return Effects((), (("coupling", step.coupling),))
        case do.HoldBack(j):
            reads = (("transform", j), ("inertia", j + 1))
            near = _moving(("inertia", plan.joints[j].parent))
            return Effects(reads, (("held", j),), near)
        case do.CarryRows(j):
            return Effects((("projected", j),), (("carried", j),))
        case do.Eliminate():
            top = _moving(("inertia", step.link))
            every = range(len(plan.processes))
            return Effects(_parts(plan, every, step.closure), (("closure", step.closure),), top)
        case do.Release():
            reads = (("closure", step.closure), *_moving(("acceleration", step.link)))
            carried = tuple(
                ("projected", k)
                for what, k in _parts(plan, (process,), step.closure)
                if what == "carried"
            )
            return Effects(reads, (("released", step.closure),), (), carried)
        case do.AccelerateHeld(j):
            above = _moving(("acceleration", plan.joints[j].parent))
            reads = (("transform", j), ("released", step.closure), *above)
            return Effects(reads, (("qdd", j), ("acceleration", j + 1)))


def _parts(plan: Plan, processes: Iterable[int], closure: int) -> tuple[tuple[str, int], ...]:
    """Contributions of processes to a closure before it is eliminated."""
    found: dict[tuple[str, int], None] = {}
    for p in processes:
        for step in plan.processes[p].steps:
            match step:
                case do.CloseLoop(k) if step.closure == closure:
                    found["loop", k] = None
                case do.CloseCoupling(k) if step.closure == closure:
                    found["coupling", k] = None
                case do.HoldBack(k) if step.closure == closure:
                    found["held", k] = None
                case do.CarryRows(k) if step.closure == closure:
                    found["carried", k] = None
    return tuple(found)


def _certify(plan: Plan, step: do.Certify | do.Refine) -> Effects:
    """Effects of a certificate: it reads motions, and the factors of all joints but floating bases.

    Of closed loops the answer's correction, which was found with these.
    """
    if plan.closed:
        return Effects((("correction", 0),), (("certificate", 0),))
    reads: list[Place] = []
    tells, own = None, tuple(range(len(plan.joints)))
    if isinstance(step, do.Certify):
        tells, own = step.tells, step.joints or own
        reads += [("share", share.process) for share in step.hears]
        reads += [("load", link) for link in _held(plan, step)]
    if tells is not None:
        reads += [("acceleration", link) for link in tells.links]
    cut = set[int]()
    if not plan.several:  # a chain in parts is weighed by what these show at their first links
        cut = {joined.joint for joined in plan.steps_of(do.Join)}
        reads += [root.block for root in plan.steps_of(do.InvertRoot)]
        reads += [load.force for load in plan.steps_of(do.Load) if load.force is not None]
    for j in own:
        joint = plan.joints[j]
        reads += [("qdd", j), ("transform", j), ("velocity", j + 1), ("acceleration", j + 1)]
        if j in cut:
            continue
        reads.append(("inertia" if is_base(joint) else "projected", j + is_base(joint)))
    found = ("certificate", 0) if tells is None else ("share", tells.process)
    return Effects(tuple(reads), (found,))


def _held(plan: Plan, step: do.Certify) -> list[int]:
    """Links on the ground's side that the process finishing a certificate needs."""
    held = plan.processes[0].steps_of(do.HoldMobility, do.LoadRoot)
    return sorted({each.link for each in held}) if step.hears else []


def _correct(plan: Plan, step: do.Correct) -> Effects:
    """Effects of a correction; messages divide a correction into pieces."""
    place = (("correction", step.round),)
    if step.first > 0:
        return Effects(alters=place)
    if step.round > 0:
        return Effects((("correction", step.round - 1),), place)
    every = () if plan.several else range(len(plan.joints))
    return Effects(tuple(("qdd", j) for j in every), place)


def contents(message: Message) -> tuple[Place, ...]:
    """Return the buffers in a message, without inertias, which its target adds."""
    if message.sweep == "torques":
        return (("torques", 0),)
    if message.sweep == ENERGIES:
        return (("energies", 0),)
    if message.sweep == CERTIFICATE:
        return (("share", message.source),)
    if message.repeats is not None:  # the steps before and behind it tell of a correction
        return ()
    accelerations: tuple[Place, ...] = tuple(("qdd", joint) for joint in message.joints)
    sides: Iterator[Place] = (("carried", joint) for side in message.sides for joint in side.joints)
    named: tuple[Place, ...] = (
        *message.passages,
        *message.blocks,
        *message.biases,
        *message.forces,
    )
    placed: tuple[Place, ...] = tuple(("transform", joint) for joint in message.placements)
    return (*named, *placed, *accelerations, *sides)


def added_by(message: Message) -> tuple[int, ...]:
    """Return the links whose inertias a message adds to: none where it repeats another."""
    return () if message.repeats is not None else message.inertias


def _moving(*places: tuple[str, int]) -> tuple[Place, ...]:
    """The buffers that do not belong to the ground."""
    return tuple(place for place in places if place[1] > 0)


def _across(plan: Plan, step: do.Articulate | do.Propagate | do.Deliver | do.Accelerate) -> Effects:
    """Effects of a step across a joint."""
    j = step.joint
    ends = ends_of(plan.joints, j, step.reversed)
    reads: tuple[Place, ...]
    sets: tuple[Place, ...]
    match step:
        case do.Articulate():
            reads = (("transform", j), ("inertia", ends.far))
            return Effects(reads, (("projected", j),), _moving(("inertia", ends.near)))
        case do.Propagate():
            near = (place for place in (step.near, step.near_bias) if place is not None)
            sources = (spread.source for spread in step.spreads)
            targets = (spread.target for spread in step.spreads)
            return Effects((("projected", j), *near, *sources), (step.block, step.bias, *targets))
        case do.Deliver():
            added = _moving(("load", ends.near))
            return Effects((("load", ends.far),), (), added, (("projected", j),))
        case do.Accelerate():
            reads = (("projected", j), *_moving(("acceleration", ends.near)))
            sets = (("qdd", j), *_moving(("acceleration", ends.far)))
            return Effects(reads, sets)


def _join(step: do.Join) -> Effects:
    joints = step.run if isinstance(step, do.FusedJoin) else (step.joint,)
    read: list[Place] = [("transform", j) for j in joints]
    read += [place for place in (step.a_bias, step.b_bias) if place is not None]
    blocks = [step.a, step.b, *(coupling.source for coupling in step.couplings)]
    blocks += [update.source for update in step.blocks]
    read += [block for block in blocks if block is not None and block.joint is not None]
    read += [update.source for update in step.biases]
    blocks_set = (update.target for update in step.blocks)
    biases_set = (update.target for update in step.biases)
    return Effects(tuple(read), (("joined", step.joint), *blocks_set, *biases_set))


def _disassemble(step: do.Disassemble, run: Sequence[int]) -> Effects:
    held = (update.source for update in step.updates if update.source is not None)
    accelerations: tuple[Place, ...] = tuple(("qdd", j) for j in run)
    targets = (update.target for update in step.updates)
    return Effects((("joined", step.joint), *step.forces, *held), (*targets, *accelerations))


def _coupled(plan: Plan) -> tuple[Place, ...]:
    """Accelerations of slaved joints and their sources."""
    found: dict[Place, None] = {}
    for slaved, source, _ in plan.following:
        found["qdd", slaved] = found["qdd", source] = None
    if plan.tied_rows:
        found.update(dict.fromkeys(_between_ends(plan)))
        found.update((("qdd", j), None) for j, _ in plan.lent)
    return tuple(found)


def _between_ends(plan: Plan) -> Iterator[Place]:
    """Accelerations of joints between ends of loops, and their rows."""
    for k, loop in enumerate(plan.loops):
        yield "loop", k
        ways = [plan.paths([link - 1]) for link in loop.links]
        yield from (("qdd", j) for j in sorted(ways[0] ^ ways[1]))
    for k, coupling in enumerate(plan.couplings):
        yield "coupling", k
        yield from (("qdd", j) for j, _ in coupling.terms)
