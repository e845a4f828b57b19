"""The robot as adagen sees it: links, joints and inertias, and nothing of code."""

from adagen.model.frames import canonical
from adagen.model.kinds import FLOATING, KINDS, PLANAR, PRISMATIC, REVOLUTE, SPHERICAL, JointKind
from adagen.model.model import BASE, Frame, Inertia, Joint, Link, Mimic, Model, Passive, Wrench
from adagen.model.rigid import Part, Pose, lump

__all__ = [
    "BASE",
    "FLOATING",
    "KINDS",
    "PLANAR",
    "PRISMATIC",
    "REVOLUTE",
    "SPHERICAL",
    "Frame",
    "Inertia",
    "Joint",
    "JointKind",
    "Link",
    "Mimic",
    "Model",
    "Part",
    "Passive",
    "Pose",
    "Wrench",
    "canonical",
    "lump",
]
