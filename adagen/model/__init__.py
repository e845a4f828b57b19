"""The robot as adagen sees it: links, joints and inertias, and nothing of code."""

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
from adagen.model.loops import LOOP_KINDS, LOOP_WORDS, Coupling, Loop, LoopKind
from adagen.model.model import BASE, Frame, Inertia, Joint, Link, Mimic, Model, Passive, Wrench
from adagen.model.rigid import Part, Pose, lump

__all__ = [
    "BASE",
    "FLOATING",
    "KINDS",
    "LOOP_KINDS",
    "LOOP_WORDS",
    "PLANAR",
    "PRISMATIC",
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
