"""The steps of a plan, and the names of the buffers that they read and set.

A module that names many of them imports them as ``do``: ``do.Articulate``, ``do.Send``.
"""

from __future__ import annotations

from adagen.plan.steps.articulated import (
    Accelerate,
    AccelerateRoot,
    Articulate,
    Deliver,
    FreeAcceleration,
    FreeBase,
    HoldMobility,
    InvertRoot,
    Load,
    LoadRoot,
    Propagate,
    SolveMobility,
    SolveRoot,
    Spread,
    StartEmpty,
    StartLink,
)
from adagen.plan.steps.closed import (
    AccelerateHeld,
    CarryRows,
    CloseCoupling,
    ClosedStep,
    CloseLoop,
    Eliminate,
    HoldBack,
    Release,
)
from adagen.plan.steps.joins import (
    BiasUpdate,
    BlockUpdate,
    Coupling,
    Disassemble,
    ForceUpdate,
    FusedJoin,
    Join,
    LinkBias,
)
from adagen.plan.steps.names import Bias, Block, Force, Passage, SideOfLoops
from adagen.plan.steps.process import (
    Append,
    ApplyCoupling,
    Arrive,
    Certify,
    Correct,
    GiveOutput,
    Kinematics,
    Receive,
    Refine,
    Send,
    Share,
    SolveCoupling,
    Traverse,
)

__all__ = [
    "Accelerate",
    "AccelerateHeld",
    "AccelerateRoot",
    "Append",
    "ApplyCoupling",
    "Arrive",
    "Articulate",
    "Bias",
    "BiasUpdate",
    "Block",
    "BlockUpdate",
    "CarryRows",
    "Certify",
    "CloseCoupling",
    "CloseLoop",
    "ClosedStep",
    "Correct",
    "Coupling",
    "Deliver",
    "Disassemble",
    "Eliminate",
    "Force",
    "ForceUpdate",
    "FreeAcceleration",
    "FreeBase",
    "FusedJoin",
    "GiveOutput",
    "HoldBack",
    "HoldMobility",
    "InvertRoot",
    "Join",
    "Kinematics",
    "LinkBias",
    "Load",
    "LoadRoot",
    "Passage",
    "Propagate",
    "Receive",
    "Refine",
    "Release",
    "Send",
    "Share",
    "SideOfLoops",
    "SolveCoupling",
    "SolveMobility",
    "SolveRoot",
    "Spread",
    "StartEmpty",
    "StartLink",
    "Step",
    "Traverse",
    "biases_set_by",
    "blocks_set_by",
]

Step = (
    Kinematics
    | Traverse
    | Append
    | Arrive
    | LinkBias
    | Join
    | FusedJoin
    | Disassemble
    | StartLink
    | StartEmpty
    | FreeBase
    | Articulate
    | InvertRoot
    | SolveRoot
    | SolveMobility
    | HoldMobility
    | Propagate
    | Load
    | LoadRoot
    | Deliver
    | AccelerateRoot
    | FreeAcceleration
    | Accelerate
    | Send
    | Receive
    | SolveCoupling
    | ApplyCoupling
    | GiveOutput
    | ClosedStep
    | Certify
    | Correct
    | Refine
)


def blocks_set_by(step: Step) -> tuple[Block, ...]:
    """Return the blocks that a step computes."""
    match step:
        case Join():
            return tuple(update.target for update in step.blocks)
        case InvertRoot():
            return (step.block,)
        case Propagate():
            return (step.block, *(spread.target for spread in step.spreads))
        case _:
            return ()


def biases_set_by(step: Step) -> tuple[Bias, ...]:
    """Return the biases that a step computes, those of bare links left out."""
    match step:
        case Join():
            return tuple(update.target for update in step.biases)
        case InvertRoot() | Propagate():
            return (step.bias,)
        case _:
            return ()
