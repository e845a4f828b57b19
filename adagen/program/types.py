"""The program: operations in order, as they are emitted, priced, drawn and checked.

A plan (adagen/plan) says what each process computes, joint by joint. A program says how: the steps
that are carried out together, over which block of joints, by which method, and the place of joints
in memory. All reports about a solver are made from its program.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Step
from adagen.plan.types import Plan
from adagen.program.runs import Run
from adagen.program.slots import Slots

Method = Literal[
    "step",
    "each",
    "columns",
    "turned",
    "strips",
    "traversed",
    "lanes",
    "base",
    "carried",
    "along",
    "through",
    "parts",
    "tiles",
    "straight",
]
"""How an operation passes its block.

* ``step``: one joint or link, by a call of its own;
* ``each``: a loop over a run, number by number;
* ``columns``: a loop over a run, the six columns of the articulated inertia in SIMD lanes;
* ``turned``: a loop over a run, number by number, or over limbs side by side, joints that lose
  digits in axes of the base in their own (see adagen/plan/own_axes.py);
* ``strips``: a run in as many strips as there are SIMD lanes, one in each;
* ``traversed``: the same, from what a traversal of the run has found of the strips;
* ``lanes``: limbs side by side, one in each SIMD lane;
* ``base``: a floating base, whose frame is its own;
* ``carried``: the mobility of a run's last link, by unit wrenches there that are carried through
  the run, one in each SIMD lane;
* ``along``: the same along with the run's sweep inwards, by columns; a load of the last link is
  then brought to all joints at once, by what the unit wrenches did to each;
* ``parts``: a run that is parted (adagen/plan/parts.py), one part in each SIMD lane; of one part,
  what was found of it when all were swept;
* ``tiles``: a long run outwards and inwards tile by tile, so that what it works on stays in the
  cache;
* ``through``: a loop over a run on whose links between its ends nothing but the run itself acts;
* ``straight``: statements without loops or calls.
"""


@dataclass(frozen=True)
class Links:
    """Links, or the joints above them, that one operation computes in any order."""

    numbers: tuple[int, ...]


Block = Run | Limbs | Links


@dataclass(frozen=True)
class Operation:
    """Steps of a plan that are carried out together.

    Attributes:
        does: what it does, its steps' ``does``, or a key of ``PREPARES``.
        block: joints or links that it is done for; None where a message or nothing but the step
            says that.
        method: how the block is passed.
        steps: the steps of the plan, in the order in which they are done; none for what only
            prepares others.
        stage: place of its stage among the process's stages (adagen/plan/stages.py).
        first: for each link at which it leaves an inertia (in the order of the steps, limbs by
            lane): whether that is the first one there, and so is stored instead of added.
        nested: whether one of limbs side by side hangs on a link of others that are: what it takes
            from there, or leaves there, is in one lane of these.
        lanes: of a sweep of a chain in parts, in how many SIMD lanes its joints are: a row of them,
            one of each part, takes as long where some are missing; otherwise 1.
    """

    does: str
    block: Block | None
    method: Method
    steps: tuple[Step, ...]
    stage: int
    first: tuple[bool, ...] = ()
    nested: bool = False
    lanes: int = 1


@dataclass(frozen=True)
class ProcessProgram:
    """The operations of one process.

    Attributes:
        operations: in order.
        recovery: what it runs instead in a pose in which that cannot be done.
        others: what it runs where that cannot be done either, in order.
    """

    operations: tuple[Operation, ...]
    recovery: tuple[Operation, ...] = ()
    others: tuple[tuple[Operation, ...], ...] = ()


@dataclass(frozen=True)
class Program:
    """The operations of all processes, and where joints lie in memory.

    Attributes:
        plan: the constants, messages, owners and steps that it carries out.
        shape: "kernels" (loops), "unrolled" (straight lines) or "joints" (a call for each step).
        batch: whether SIMD lanes are for states.
        slots: where joints lie in memory, and what lies side by side.
        processes: one for each process of the plan.
        recovering: limbs that share straight lines in what is done instead (``recovery``).
    """

    plan: Plan
    shape: str
    batch: bool
    slots: Slots
    processes: tuple[ProcessProgram, ...]
    recovering: tuple[tuple[Limbs, ...], ...] = ()
