"""Removes parts that cannot influence the requested accelerations.

Some links have a known motion: the ground, and links that only prescribed joints connect to it.
Limbs on such links are independent of each other: each limb's accelerations depend only on its own
torques and on the known motion of its root. A limb without requested accelerations can therefore be
left out, exactly. Inside a limb everything influences everything through forces, and nothing can be
left out.
"""

from __future__ import annotations

from collections.abc import Collection

from adagen.model import Model
from adagen.model.paths import paths_to_ground


def influential(model: Model, wanted: Collection[int], kept: Collection[int]) -> list[int]:
    """Return the joints that have to stay, ascending.

    Args:
        model: the robot; a limb with a slaved joint stays with the limb of its source.
        wanted: joints whose accelerations are wanted.
        kept: links whose motion is wanted.
    """
    known = {0}  # links of known motion
    limb: dict[int, int] = {}  # the first joint of each other joint's limb
    for j, joint in enumerate(model.joints):
        if joint.parent in known and joint.prescribed:
            known.add(j + 1)
        else:
            limb[j] = j if joint.parent in known else limb[joint.parent - 1]
    stay = {limb[j] for j in {*wanted, *(link - 1 for link in kept)} if j in limb}
    grown = True
    ties = [{limb[j] for j in tied if j in limb} for tied in _tied(model)]
    while grown:  # they tie limbs together
        more = {one for tie in ties if tie & stay for one in tie} - stay
        stay |= more
        grown = bool(more)
    result = {j for j, first in limb.items() if first in stay}
    needed = [*stay, *wanted, *(link - 1 for link in kept)]  # by prescribed joints on the way
    return sorted(result | paths_to_ground(model.joints, needed))


def _tied(model: Model) -> list[set[int]]:
    """Joints that do not move apart: slaved ones and their sources, ends of loops, couplings."""
    slaved = [
        {j, joint.mimic.source} for j, joint in enumerate(model.joints) if joint.mimic is not None
    ]
    loops = [{link - 1 for link, _ in loop.ends} for loop in model.loops]
    return [*slaved, *loops, *({j for j, _ in c.terms} for c in model.couplings)]
