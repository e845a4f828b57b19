"""Constants of a robot that can be set at run time."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from adagen.errors import UsageError, printable
from adagen.exact import identity, rotation_taking_z_to, rounded
from adagen.jsonfile import nearest
from adagen.model import Model, canonical
from adagen.plan.robot import PlanParameter

KNOWN = "gravity, mass:LINK and center:LINK"


def parameters_of(model: Model, runtime: str) -> tuple[PlanParameter, ...]:
    """Return the constants of a robot that can be set at run time.

    Args:
        model: the robot.
        runtime: words with commas between them: "gravity", "mass:LINK", "center:LINK".

    Raises:
        UsageError: an unknown word or link, a link without mass, or a word that is given twice.
    """
    found: dict[str, PlanParameter] = {}
    for word in filter(None, runtime.split(",")):
        if word in found:
            raise UsageError(f"{printable(word)} is given twice: name it once")
        found[word] = _parameter(model, word)
    return tuple(found.values())


def _parameter(model: Model, word: str) -> PlanParameter:
    what, _, name = word.partition(":")
    if word == "gravity":
        return PlanParameter("gravity", tuple(float(g) + 0.0 for g in model.gravity))
    if what not in ("mass", "center"):
        raise UsageError(f"what can be set at run time are {KNOWN}, not {printable(word)}")
    k = _link(model, word, name)
    inertia = canonical(model).links[k].inertia
    if not inertia.mass > 0:
        raise UsageError(
            f"{printable(word)} cannot be set: the link has no mass, and is treated as such"
        )
    if what == "mass":
        return PlanParameter("mass", (float(inertia.mass),), k, name)
    joint = model.joints[k - 1]
    axes = rotation_taking_z_to(joint.axis) if joint.kind.has_axis else identity()
    rotation = tuple(map(tuple, rounded(axes.T).tolist()))
    center = tuple(float(x) for x in inertia.com)
    return PlanParameter("center", center, k, name, rotation)


def _link(model: Model, word: str, name: str) -> int:
    """The number of the moving link of a name."""
    moving = {link.name: k for k, link in enumerate(model.links) if k}
    if name in moving:
        return moving[name]
    for k, link in enumerate(model.links):
        if name in link.merged:
            hint = f"say {word.partition(':')[0]}:{printable(link.name)}" if k else "it never moves"
            raise UsageError(f"{printable(name)} is fixed to {printable(link.name)}: {hint}")
    raise UsageError(f"{printable(word)}: no moving link of this name{nearest(name, moving)}")


def refuse_inverted(parameters: Iterable[PlanParameter], links: Collection[int]) -> None:
    """Refuse parameters of links whose inertias are inverted.

    Raises:
        UsageError: one of the parameters is such a link's.
    """
    for parameter in parameters:
        if parameter.link in links:
            raise UsageError(
                f"{parameter.what}:{printable(parameter.name)} cannot be set where that link is "
                "joined by the inverse of its inertia: use --form segment or --procs 1"
            )
