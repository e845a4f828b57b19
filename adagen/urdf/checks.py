"""Checks whether the forward dynamics of a model has an answer."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from adagen.model import BASE, Model
from adagen.urdf.mobility import Mobility, weakest
from adagen.urdf.notes import Notes, quoted
from adagen.urdf.slaved import weakest_slaved

ROUNDING = 1e-10
"""How negative a principal moment of a moving body may be, relative to its size, by rounding."""

WEAK = 1e-10
"""Below this ratio of articulated to composite inertia the answer loses ten digits."""


@dataclass(frozen=True)
class Lines:
    """Lines of the file: of <robot>, of joints and of links (their <inertial>) by name."""

    robot: int | None
    joints: dict[str, int | None]
    links: dict[str, int | None]

    def of(self, model: Model, j: int) -> int | None:
        """Return the line of a joint of the model; of its child link for a base not in the file."""
        return self.joints.get(model.joints[j].name, self.links.get(model.links[j + 1].name))


def check_model(model: Model, lines: Lines, notes: Notes) -> None:
    """Refuse a model whose forward dynamics has no answer.

    Args:
        model: to check.
        lines: where the file tells of the model's joints and links.
        notes: takes the warnings.

    Raises:
        InputError: no degree of freedom, a moving body with an inertia that is not positive
            semi-definite, or a joint that moves no mass.
    """
    if not model.joints:
        raise notes.error(
            "nothing to solve: every joint is fixed, try --floating"
            if model.links[0].merged
            else "nothing to solve: the robot has one link and no joint, try --floating",
            lines.robot,
        )
    for j in range(len(model.joints)):
        _check_body(model, j, lines, notes)
    if model.closed:  # what moves without mass in the tree may be held by a loop
        return
    weak = weakest(model)
    if weak.singular and any(joint.mimic for joint in model.joints):
        weak = weakest_slaved(model)
    if weak.singular:
        if not any(link.inertia.mass or link.inertia.tensor.any() for link in model.links):
            raise notes.error(
                "no link has mass or inertia: the file describes kinematics alone; give the links "
                "that move an <inertial>",
                lines.robot,
            )
        raise notes.error(_why_singular(model, weak), lines.of(model, weak.joint))
    if weak.ratio < WEAK:
        notes.warn(
            f'joint "{model.joints[weak.joint].name}" moves hardly any mass of its own '
            f"(1e{math.floor(math.log10(weak.ratio))} of what hangs on it): its acceleration "
            "loses as many digits",
            lines.of(model, weak.joint),
        )


def _check_body(model: Model, j: int, lines: Lines, notes: Notes) -> None:
    """Refuse a body whose inertia about its centre of mass has a negative principal moment.

    What is negative is judged beside the largest moment and beside m l^2, l the distance to the
    centre of mass or to a joint: real robots carry noise such as -5e-20 where zero was meant.
    """
    link = model.links[j + 1]
    moments = np.linalg.eigvalsh(link.inertia.tensor)
    joints = [model.joints[c].translation for c in model.children[j + 1]]
    lengths = [float(np.dot(p, p)) for p in (link.inertia.com, *joints)]
    size = max(float(abs(moments).max()), link.inertia.mass * max(lengths))
    if moments[0] < -ROUNDING * size:
        held = f" (with {quoted(link.merged)} fixed to it)" if link.merged else ""
        raise notes.error(
            f'link "{link.name}"{held}: inertia is not positive definite, least principal moment '
            f"{moments[0]:.3g} kg m^2: correct its <inertia>",
            lines.links.get(link.name),
        )


def _why_singular(model: Model, weak: Mobility) -> str:
    joint = model.joints[weak.joint]
    who = "the floating base" if joint.name == BASE and model.floating else f'joint "{joint.name}"'
    others = [model.joints[j].name for j in weak.moving[1:]]
    if weak.ratio < -1e-14:
        return f"{who} meets a negative inertia: correct the <inertia> of the links that it moves"
    if not others:
        return (
            f"{who} moves no mass (the joint-space inertia is singular): give the links that it "
            "moves mass and inertia" + ("" if joint.name == BASE else ", or make it fixed")
        )
    way_out = (
        f'give link "{model.links[weak.joint + 1].name}" mass and inertia'
        if model.links[weak.joint + 1].inertia.mass == 0.0
        else "give the links between them mass and inertia"
    )
    end = "or leave out --floating" if joint.name == BASE else "or make one of them fixed"
    return (
        f"{who} can move together with {quoted(others)} without moving any mass (the joint-space "
        f"inertia is singular): {way_out}, {end}"
    )
