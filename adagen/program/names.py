"""What operations are called: one word for each kind of step, and for what prepares steps."""

from __future__ import annotations

from adagen.plan.steps import (
    Accelerate,
    AccelerateRoot,
    ApplyCoupling,
    Articulate,
    Deliver,
    Disassemble,
    FreeAcceleration,
    FreeBase,
    FusedJoin,
    HoldMobility,
    InvertRoot,
    Join,
    Kinematics,
    LinkBias,
    Load,
    LoadRoot,
    Propagate,
    Receive,
    Send,
    SolveCoupling,
    SolveMobility,
    SolveRoot,
    StartEmpty,
    StartLink,
    Step,
)

DOES: dict[type, str] = {
    Kinematics: "kinematics",
    LinkBias: "link_bias",
    StartLink: "link_inertia",
    StartEmpty: "clear_inertia",
    FreeBase: "free_base",
    Articulate: "articulate",
    InvertRoot: "invert_root",
    SolveRoot: "solve_root",
    SolveMobility: "solve_mobility",
    HoldMobility: "hold_mobility",
    Propagate: "propagate",
    Join: "join",
    FusedJoin: "fused_join",
    Disassemble: "disassemble",
    Load: "load",
    LoadRoot: "load_root",
    Deliver: "deliver",
    AccelerateRoot: "accelerate_root",
    Accelerate: "accelerate",
    FreeAcceleration: "free_acceleration",
    Send: "send",
    Receive: "receive",
    SolveCoupling: "solve_coupling",
    ApplyCoupling: "apply_coupling",
}
"""What the operation that carries out steps of a kind is called."""

PREPARES: dict[str, str] = {
    "angles": "sines, cosines and orientations of joints, several in one register",
    "place_inertia": "a link's own inertia put where others are added",
    "link_columns": "link inertias by columns, for runs that are swept by columns",
}
"""Operations that prepare steps and carry out none, or only a part of one."""

PASSING = "pass_kinematics"
"""Kinematics of joints that are only passed on the way to others."""

PREPARED = ("angles", "kinematics", PASSING, "link_inertia", "solve_coupling", "apply_coupling")
"""What operations of loops do once, however many right-hand sides there are."""


def does(step: Step) -> str:
    """Return what the operation that carries out a step is called."""
    return DOES[type(step)]
