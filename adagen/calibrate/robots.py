"""Artificial robots for calibration: chains, hubs and trees of chosen joint kinds.

Their times do not depend on masses and lengths, only on the topology and the joint kinds; bodies
are random so that nothing can be folded or cancelled.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from adagen.model import KINDS, Inertia, Joint, Link, Model, Passive

Array = NDArray[np.float64]


def robot(name: str, parents: Sequence[int], kinds: Sequence[str], seed: int = 1) -> Model:
    """Return a robot whose joint j joins link ``parents[j]`` to link j + 1.

    Args:
        name: its name.
        parents: parent link of each joint, in depth-first order.
        kinds: names of the joints' kinds, used in turn.
        seed: of its bodies.
    """
    rng = random.Random(seed)  # noqa: S311 (not for secrets)
    joints = tuple(
        Joint(
            name=f"j{j}",
            kind=KINDS[kinds[j % len(kinds)]],
            parent=parent,
            rotation=_rotation(rng),
            translation=_vector(rng, 0.1, 0.3),
            axis=np.array([0.0, 0.0, 1.0]),
        )
        for j, parent in enumerate(parents)
    )
    links = (
        Link("ground", Inertia.zero()),
        *(Link(f"l{j}", _body(rng)) for j in range(len(joints))),
    )
    return Model(name, links, joints)


def chain(joints: int) -> list[int]:
    """Return the parents of a serial chain."""
    return list(range(joints))


def star(arms: int, length: int) -> list[int]:
    """Return the parents of arms on a hub, which a joint holds to the ground."""
    return crew((arms, length))


def crew(*sets: tuple[int, int]) -> list[int]:
    """Return the parents of sets of arms on a hub: how many arms, and of how many joints."""
    parents = [0]
    for arms, length in sets:
        for _ in range(arms):
            parents += [1, *range(len(parents) + 1, len(parents) + length)]
    return parents


def claws(arms: int, length: int, fingers: int, joints: int) -> list[int]:
    """Return the parents of arms on a hub, each of which ends in fingers."""
    parents = [0]
    for _ in range(arms):
        parents += [1, *range(len(parents) + 1, len(parents) + length)]
        wrist = len(parents)
        for _ in range(fingers):
            parents += [wrist, *range(len(parents) + 1, len(parents) + joints)]
    return parents


def tree(joints: int, branching: float, seed: int) -> list[int]:
    """Return the parents of a random tree in depth-first order.

    Args:
        joints: how many.
        branching: chance that a joint does not follow the last one but an earlier one of the path.
        seed: the same one gives the same tree.
    """
    rng = random.Random(seed)  # noqa: S311 (not for secrets)
    path, parents = [0], []
    for j in range(joints):
        if len(path) > 2 and rng.random() < branching:
            del path[rng.randrange(2, len(path)) :]
        parents.append(path[-1])
        path.append(j + 1)
    return parents


def prescribed(model: Model) -> Model:
    """Return a robot with the motion of every second joint known, that on the ground left free."""
    joints = [replace(joint, prescribed=j % 2 == 1) for j, joint in enumerate(model.joints)]
    return replace(model, joints=tuple(joints))


def hollow(model: Model) -> Model:
    """Return a robot whose links have no mass but its first one and every third one after it."""
    ground, *links = model.links
    bodies = [
        link if k % 3 == 0 else replace(link, inertia=Inertia.zero())
        for k, link in enumerate(links)
    ]
    return replace(model, links=(ground, *bodies))


def rubbing(model: Model) -> Model:
    """Return a robot with friction in all its hinges and sliders."""
    joints = [
        replace(joint, passive=Passive(friction=0.1)) if joint.kind.takes("friction") else joint
        for joint in model.joints
    ]
    return replace(model, joints=tuple(joints))


def squared(model: Model) -> Model:
    """Return a robot as robots are built: in right angles, its bodies symmetric about their axes.

    Much of what is computed of it is known to be zero beforehand.
    """
    turns = (np.eye(3), np.eye(3)[[0, 2, 1]] * [1, -1, 1], np.eye(3)[[1, 2, 0]])
    joints = [
        replace(joint, rotation=turns[j % 3], translation=np.roll([joint.translation[0], 0, 0], j))
        for j, joint in enumerate(model.joints)
    ]
    ground, *links = model.links
    bodies = [
        Inertia(body.mass, np.roll([body.com[0], 0, 0], k), np.diag(np.diag(body.tensor)))
        for k, body in enumerate(link.inertia for link in links)
    ]
    squared = [replace(link, inertia=body) for link, body in zip(links, bodies, strict=True)]
    return replace(model, joints=tuple(joints), links=(ground, *squared))


def _vector(rng: random.Random, least: float, most: float) -> Array:
    return np.array([rng.choice((-1, 1)) * rng.uniform(least, most) for _ in range(3)])


def _rotation(rng: random.Random) -> Array:
    w, x, y, z = (rng.choice((-1, 1)) * rng.uniform(0.3, 1.0) for _ in range(4))
    n = w * w + x * x + y * y + z * z
    return np.eye(3) + 2 / n * np.array(
        [
            [-y * y - z * z, x * y - z * w, x * z + y * w],
            [x * y + z * w, -x * x - z * z, y * z - x * w],
            [x * z - y * w, y * z + x * w, -x * x - y * y],
        ]
    )


def _body(rng: random.Random) -> Inertia:
    mass, turn = rng.uniform(0.5, 2.0), _rotation(rng)
    spread = turn @ np.diag([rng.uniform(0.05, 0.2) ** 2 for _ in range(3)]) @ turn.T
    tensor = mass * (np.trace(spread) * np.eye(3) - spread)
    return Inertia(mass, _vector(rng, 0.02, 0.15), (tensor + tensor.T) / 2)
