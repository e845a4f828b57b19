"""The robot model: links, joints and inertias, independent of code."""

from adagen.model.closing import (
    WORLD,
    LoopEnd,
    NamedCoupling,
    NamedLoop,
    closed,
    places,
    with_loops_checked,
)
from adagen.model.frames import canonical
from adagen.model.kinds import FLOATING, KINDS, PLANAR, PRISMATIC, REVOLUTE, SPHERICAL, JointKind
from adagen.model.links import Frame, Inertia, Link
from adagen.model.loops import LOOP_KINDS, LOOP_WORDS, Coupling, Loop, LoopKind
from adagen.model.model import (
    BASE,
    INVERSE_INERTIA,
    LINK_ACCELERATION,
    OUTPUT_SIZES,
    REACTION_FORCE,
    Joint,
    Mimic,
    Model,
    Output,
    Passive,
    Wrench,
)
from adagen.model.rigid import Part, Pose, lump

__all__ = [
    "BASE",
    "FLOATING",
    "INVERSE_INERTIA",
    "KINDS",
    "LINK_ACCELERATION",
    "LOOP_KINDS",
    "LOOP_WORDS",
    "OUTPUT_SIZES",
    "PLANAR",
    "PRISMATIC",
    "REACTION_FORCE",
    "REVOLUTE",
    "SPHERICAL",
    "WORLD",
    "Coupling",
    "Frame",
    "Inertia",
    "Joint",
    "JointKind",
    "Link",
    "Loop",
    "LoopEnd",
    "LoopKind",
    "Mimic",
    "Model",
    "NamedCoupling",
    "NamedLoop",
    "Output",
    "Part",
    "Passive",
    "Pose",
    "Wrench",
    "canonical",
    "closed",
    "lump",
    "places",
    "with_loops_checked",
]
