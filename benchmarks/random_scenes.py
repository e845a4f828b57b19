"""Scenes at random: a few keys of a scene file each, with names of a robot's joints and links.

They may contradict themselves, which generation has to say in words.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from adagen.model import Model
from adagen.reference.closed import pose_of
from adagen.states.sampling import random_states

_LOOPS = ("spherical", "point", "weld", "revolute", "cylindrical", "universal")
_AXES = ("[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]")


def scene(draw: random.Random, model: Model, *, floating: bool) -> str:
    """Return the text of a scene.

    Args:
        draw: where randomness comes from.
        model: the robot on its own base.
        floating: whether the command line says that its base floats.
    """
    top: list[tuple[float, Make]] = [] if floating else [(0.15, _base)]
    top += [(0.2, _gravity), (0.15, _rest), (0.5, _effects), (0.2, _forces), (0.15, _wanted)]
    tables: list[tuple[float, Make]] = [
        (0.2, _outputs),
        (0.3, _locked),
        (0.6, _joints),
        (0.2, _masses),
        (0.1, _couplings),
    ]
    tables.append((0.1, _loops))
    chosen = [make for share, make in (*top, *tables) if draw.random() < share]
    return "".join(f"{line}\n" for make in chosen or [_effects] for line in make(draw, model))


Make = Callable[[random.Random, Model], Iterator[str]]


def _names(draw: random.Random, names: Sequence[str], most: int) -> list[str]:
    return draw.sample(names, min(len(names), draw.randint(1, most)))


def _joints_of(model: Model) -> list[str]:
    return [joint.name for joint in model.joints]


def _scalars_of(model: Model) -> list[str]:
    """Return the names of joints of one degree of freedom; all if there are none."""
    return [joint.name for joint in model.joints if joint.kind.nv == 1] or _joints_of(model)


def _links_of(model: Model) -> list[str]:
    return [link.name for link in model.links[1:]]


def _listed(names: Sequence[str]) -> str:
    return "[" + ", ".join(f'"{name}"' for name in names) + "]"


def _base(draw: random.Random, _model: Model) -> Iterator[str]:
    kind = draw.choice(("floating", "planar", "revolute", "prismatic", "spherical"))
    if kind == "floating":
        yield f'base = "{kind}"'
    else:
        axis = "" if kind == "spherical" else f", axis = {draw.choice(_AXES)}"
        yield f'base = {{ kind = "{kind}"{axis} }}'


def _gravity(draw: random.Random, _model: Model) -> Iterator[str]:
    yield f"gravity = {draw.choice(('[0, 0, 0]', '[0, 0, -1.62]', '[1.0, -2.0, -9.0]'))}"


def _rest(_draw: random.Random, _model: Model) -> Iterator[str]:
    yield "at_rest = true"


def _effects(draw: random.Random, _model: Model) -> Iterator[str]:
    for key in ("damping", "friction"):
        if draw.random() < 0.6:
            value = draw.choice(('"urdf"', "0.05", "1.5"))
            yield f"{key} = {value}"
    if draw.random() < 0.3:
        yield "friction_speed = 0.3"


def _forces(draw: random.Random, model: Model) -> Iterator[str]:
    yield f"forces = {_listed(_names(draw, _links_of(model), 3))}"


def _wanted(draw: random.Random, model: Model) -> Iterator[str]:
    yield f"accelerations = {_listed(_names(draw, _joints_of(model), 3))}"
    if draw.random() < 0.3:
        yield f"keep = {_listed(_names(draw, _links_of(model), 1))}"


def _outputs(draw: random.Random, model: Model) -> Iterator[str]:
    yield "[outputs]"
    links, joints = _links_of(model), _joints_of(model)
    lists = {"link_accelerations": links, "reaction_forces": joints, "inverse_inertia": links}
    for key, names in lists.items():
        if draw.random() < 0.6:
            yield f"{key} = {_listed(_names(draw, names, 2))}"


def _locked(draw: random.Random, model: Model) -> Iterator[str]:
    yield "[lock]"
    for name in _names(draw, _scalars_of(model), 1 + len(model.joints) // 3):
        yield f'"{name}" = {draw.uniform(-0.5, 0.5):.2f}'


def _joints(draw: random.Random, model: Model) -> Iterator[str]:
    values = {"damping": 0.3, "friction": 0.2, "stiffness": 20.0, "rest": 0.4}
    rotors = (0.002, 0.05, 3.0)
    for name in _names(draw, _scalars_of(model), 4):
        yield f'[joints."{name}"]'
        if draw.random() < 0.25:
            yield "prescribed = true"
            continue
        for key, value in (values | {"rotor_inertia": draw.choice(rotors)}).items():
            if draw.random() < 0.5:
                yield f"{key} = {value}"


def _masses(draw: random.Random, model: Model) -> Iterator[str]:
    for name in _names(draw, _links_of(model), 2):
        yield f'[[point_masses]]\nlink = "{name}"\nmass = {draw.choice((0.01, 1.0, 50.0))}'
        yield f"position = [0, {draw.uniform(-0.2, 0.2):.2f}, 0.1]"


def _couplings(draw: random.Random, model: Model) -> Iterator[str]:
    names = _names(draw, _scalars_of(model), 2)
    if len(names) == 2:
        yield f'[[couplings]]\njoint = "{names[0]}"\nother = "{names[1]}"'
        yield f"ratio = {draw.uniform(-2, 2):.2f}"


def _loops(draw: random.Random, model: Model) -> Iterator[str]:
    """Hold a link where it is in some configuration, by the ground or by another link."""
    q = random_states(model, 1, draw.randrange(1000)).q[0]
    numbers = {name: k for k, name in enumerate(_links_of(model), start=1)}
    one, *others = draw.sample(sorted(numbers), min(2, len(numbers)))
    other = others[0] if others and draw.random() < 0.5 else None
    axes, place = pose_of(model, q, numbers[one])
    if other is not None:
        turn, origin = pose_of(model, q, numbers[other])
        axes, place = turn.T @ axes, turn.T @ (place - origin)
    roll = np.arctan2(axes[2, 1], axes[2, 2])
    pitch = np.arctan2(-axes[2, 0], np.hypot(axes[2, 1], axes[2, 2]))
    yaw = np.arctan2(axes[1, 0], axes[0, 0])
    xyz, rpy = ([float(value) for value in each] for each in (place, (roll, pitch, yaw)))
    yield f'[[loops]]\nname = "loop"\nkind = "{draw.choice(_LOOPS)}"\nlink1 = "{one}"'
    yield f'link2 = "{other or "__world__"}"\norigin2 = {{ xyz = {xyz}, rpy = {rpy} }}'
