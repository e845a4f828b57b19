"""Linkages that are hard for solvers of closed loops, built directly, and states of theirs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from adagen.model import (
    REVOLUTE,
    Inertia,
    Joint,
    Link,
    LoopEnd,
    Model,
    NamedLoop,
    closed,
)
from adagen.reference.closed import closed_states, constraints
from adagen.states import States
from adagen.studies.stability import robots

Array = NDArray[np.float64]
SPEED = 10.0
"""Joint speed, rad/s, at which change points are passed."""
_PIN = (0.0, 1.0, 0.0)
_QUARTER = np.pi / 2


def bars(*lengths: float, across: float, massless: int | None = None) -> Model:
    """Return bars end to end about y whose end is pinned to the ground.

    Args:
        lengths: of the bars, m; they have 1 kg each.
        across: from the first pin to the last one, along x, m.
        massless: the bar, from 1, that has no inertia.
    """
    made = [robots.rod(1.0, length) for length in lengths]
    if massless is not None:
        made[massless - 1] = Inertia.zero()
    tree = robots.chain("bars", made, axes="y", lengths=lengths)
    end = LoopEnd(f"link{len(lengths)}", (0.0, 0.0, lengths[-1]))
    return _closed(tree, (end, LoopEnd("ground", (across, 0.0, 0.0))))


def parallelogram(rockers: int) -> Model:
    """Return equal rockers of 1 m under one beam, 2 m apart; two are enough to hold it."""
    first = robots.chain("rockers", [robots.rod(), robots.rod(1.0, 2.0 * rockers)], axes="y")
    links, joints = list(first.links), list(first.joints)
    ends = []
    for k in range(1, rockers):
        place = np.array([0.0, 0.0, 2.0 * k])
        joints.append(Joint(f"j{k + 2}", REVOLUTE, 2, np.eye(3), place, np.array(_PIN), None))
        links.append(Link(f"link{k + 2}", robots.rod()))
        ends.append(
            (LoopEnd(f"link{k + 2}", (0.0, 0.0, 1.0)), LoopEnd("ground", (2.0 * k, 0.0, 0.0)))
        )
    return _closed(replace(first, links=tuple(links), joints=tuple(joints)), *ends)


def ring(count: int) -> Model:
    """Return a ring of links with ball joints, one of which is the ground."""
    tree = robots.spherical_rods(count - 1)
    end = LoopEnd(f"link{count - 1}", (0.0, 0.0, 1.0))
    return _closed(tree, (end, LoopEnd("ground", (1.0, 0.0, 0.0))), kind="spherical")


def _closed(tree: Model, *ends: tuple[LoopEnd, LoopEnd], kind: str = "revolute") -> Model:
    numbers = {link.name: k for k, link in enumerate(tree.links)}
    joints: dict[str, int] = {}
    loops = tuple(NamedLoop(f"pin {k}", kind, *pair, _PIN) for k, pair in enumerate(ends, start=1))
    return closed(tree, loops, (), lambda name: (numbers[name], None), joints.__getitem__)


def passing(model: Model, rockers: int) -> States:
    """Return states of a parallelogram on its way to lying flat, 0.3 to 3e-9 rad off that."""
    off = 10.0 ** -np.arange(0.5, 9.5)
    states = turned(model, rockers, _QUARTER + off)
    return replace(states, v=SPEED * states.v)


def turned(model: Model, rockers: int, angles: Sequence[float] | Array) -> States:
    """Return states of a parallelogram by the angle of its rockers, turning by 1 rad/s."""
    own = np.asarray(angles, dtype=np.float64)
    q = np.stack([own, _QUARTER - own, *[own + _QUARTER] * (rockers - 1)], axis=1)
    v = np.tile([1.0, -1.0, *[1.0] * (rockers - 1)], (len(own), 1))
    return _pushed(model, q, v)


def slack(shorter: float) -> tuple[Model, States]:
    """Return three bars of 1 m between pins that are 3 m less 3 ``shorter`` apart, and a state."""
    model = bars(1.0, 1.0, 1.0, across=3.0 * (1.0 - shorter))
    tilt = 2.0 * np.arcsin(np.sqrt(0.75 * shorter))
    q = np.array([_QUARTER - tilt, tilt, tilt])
    return model, moving(model, q)


def moving(model: Model, *q: Array) -> States:
    """Return closed configurations, each with a velocity of 1 rad/s that the loops allow."""
    speeds = []
    for each in q:
        rows = constraints(model, each).rows
        _, sizes, right = np.linalg.svd(rows)
        rank = int((sizes > 1e-12 * sizes[0]).sum())
        speeds.append(right[rank:].sum(axis=0) / np.linalg.norm(right[rank:].sum(axis=0)))
    return _pushed(model, np.array(q), np.array(speeds))


def anywhere(model: Model, count: int) -> States:
    """Return random closed states."""
    q, v = closed_states(model, count, seed=1, starts=20 * count)
    return _pushed(model, q, v)


def _pushed(model: Model, q: Array, v: Array) -> States:
    tau = np.sin(3.1 * np.arange(1, model.ntau + 1))
    return States(q, v, np.tile(tau, (len(q), 1)))
