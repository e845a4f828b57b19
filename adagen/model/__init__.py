"""The robot as adagen sees it: links, joints and inertias, and nothing of code."""

from adagen.model.frames import canonical
from adagen.model.kinds import FLOATING, KINDS, PLANAR, PRISMATIC, REVOLUTE, SPHERICAL, JointKind
from adagen.model.model import Inertia, Joint, Link, Mimic, Model

__all__ = [
    "FLOATING",
    "KINDS",
    "PLANAR",
    "PRISMATIC",
    "REVOLUTE",
    "SPHERICAL",
    "Inertia",
    "Joint",
    "JointKind",
    "Link",
    "Mimic",
    "Model",
    "canonical",
]
