"""Mechanisms with closed loops for tests, and states in which they are closed."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from adagen.model import (
    BASE,
    FLOATING,
    LOOP_WORDS,
    PRISMATIC,
    REVOLUTE,
    Inertia,
    JointKind,
    LoopEnd,
    Model,
    NamedCoupling,
    NamedLoop,
    closed,
)
from adagen.reference.closed import closed_states, moved, pose_of
from adagen.states import States, resting_states
from tests.models import Part, assemble, random_tree, rod, vector


def with_loops(
    model: Model, loops: tuple[NamedLoop, ...] = (), couplings: tuple[NamedCoupling, ...] = ()
) -> Model:
    """Return a model closed by loops between its links, by their names."""
    links = {link.name: k for k, link in enumerate(model.links)}
    joints = {joint.name: j for j, joint in enumerate(model.joints)}
    return closed(
        model, loops, couplings, lambda name: (links[name], None), lambda name: joints[name]
    )


def planar_chain(
    *lengths: float,
    floating: bool = False,
    massless: int | None = None,
    beside: Sequence[Part] = (),
) -> Model:
    """Return bars end to end along x, pinned about y; of one the link may have no inertia."""
    bars = [Part(BASE, None, FLOATING, rod(1.0, vector(0.3, 0, 0)))] if floating else []
    last = BASE if floating else None
    along = 0.0
    for k, length in enumerate(lengths):
        body = Inertia.zero() if k == massless else rod(1.0, vector(length, 0.0, 0.0))
        bars.append(
            Part(f"p{k}", last, REVOLUTE, body, vector(along, 0, 0), axis=vector(0.0, 1.0, 0.0))
        )
        last, along = f"p{k}", length
    return assemble("bars", [*bars, *beside], floating)


def four_bar(
    kind: str = "revolute",
    *,
    floating: bool = False,
    massless: bool = False,
    beside: Sequence[Part] = (),
) -> Model:
    """Return a crank, a coupler and a rocker, whose end is pinned to the root link."""
    lengths, none = (0.2, 0.5, 0.4), 1 if massless else None
    model = planar_chain(*lengths, floating=floating, massless=none, beside=beside)
    root = model.links[1].name if floating else model.links[0].name
    end, pin = LoopEnd("p2_link", (0.4, 0.0, 0.0)), LoopEnd(root, (0.45, 0.0, 0.0))
    return with_loops(model, (NamedLoop("pin", kind, end, pin, (0.0, 1.0, 0.0)),))


def truss() -> Model:
    """Return two bars pinned to each other and to the ground: nothing moves."""
    model = planar_chain(0.5, 0.4)
    end, pin = LoopEnd("p1_link", (0.4, 0.0, 0.0)), LoopEnd(model.links[0].name, (0.6, 0.0, 0.0))
    return with_loops(model, (NamedLoop("pin", "revolute", end, pin, (0.0, 1.0, 0.0)),))


def gripping(*, floating: bool = False) -> Model:
    """Return a four-bar linkage beside two fingers, one of which mimics the other."""
    finger, axis = rod(0.1, vector(0.1, 0, 0)), vector(1.0, 0.0, 2.0)
    root = BASE if floating else None
    fingers = [
        Part("finger", root, REVOLUTE, finger, vector(0, 0.1, 0), axis=axis),
        Part("thumb", "finger", REVOLUTE, finger, vector(0, 0.1, 0), mimic=("finger", -0.7, 0.2)),
    ]
    return four_bar(floating=floating, beside=fingers)


def slider_crank() -> Model:
    """Return a crank, a rod, and a slider on the ground that the rod is pinned to."""
    pin = vector(0.0, 1.0, 0.0)
    parts = [
        Part("crank", None, REVOLUTE, rod(0.5, vector(0.1, 0, 0)), axis=pin),
        Part("rod", "crank", REVOLUTE, rod(1.0, vector(0.4, 0, 0)), vector(0.1, 0, 0), axis=pin),
        Part("slide", None, PRISMATIC, rod(2.0, vector(0.1, 0, 0)), axis=vector(1.0, 0.0, 0.0)),
    ]
    ends = LoopEnd("rod_link", (0.4, 0.0, 0.0)), LoopEnd("slide_link")
    return with_loops(assemble("slider", parts), (NamedLoop("pin", "revolute", *ends, (0, 1, 0)),))


def geared() -> Model:
    """Return a tree of which two joints are geared."""
    model = random_tree(np.random.default_rng(5), 5, branching=0.5, kinds=(REVOLUTE,))
    names = model.joints[1].name, model.joints[4].name
    return with_loops(model, (), (NamedCoupling("gear", ((names[0], 1.0), (names[1], 2.5)), 0.1),))


def looped_tree(
    kind: str,
    seed: int,
    *,
    joints: int = 8,
    floating: bool = False,
    kinds: tuple[JointKind, ...] = (REVOLUTE,),
    whole: bool = False,
) -> Model:
    """Return a random tree with a loop of a kind between two of its links, or link and ground.

    The frames of the loop are such that it is closed in some configuration. A ``whole`` one is a
    chain whose last link is held by the ground.
    """
    rng = np.random.default_rng(seed)
    branching = 0.0 if whole else 0.3
    model = random_tree(rng, joints, branching=branching, floating=floating, kinds=kinds)
    numbers = rng.permutation(len(model.joints) + 1)
    one, two = (0, len(model.joints)) if whole else (int(numbers[0]), int(numbers[1]))
    return _closed_somewhere(model, kind, one, two, rng)


def between(model: Model, *ties: tuple[str, str, str], seed: int = 1) -> Model:
    """Return a robot with loops of kinds between two links each, closed in some configuration."""
    rng = np.random.default_rng(seed)
    numbers, q = {link.name: k for k, link in enumerate(model.links)}, _somewhere(model, rng)
    return with_loops(
        model,
        tuple(
            _closed_at(model, q, f"loop{k}", kind, numbers[one], numbers[two], rng)
            for k, (kind, one, two) in enumerate(ties)
        ),
    )


def _closed_somewhere(
    model: Model, kind: str, one: int, two: int, rng: np.random.Generator
) -> Model:
    """Put frame 2 where frame 1 is at a random configuration."""
    loop = _closed_at(model, _somewhere(model, rng), "loop", kind, one, two, rng)
    return with_loops(model, (loop,))


def _somewhere(model: Model, rng: np.random.Generator) -> NDArray[np.float64]:
    """A random configuration."""
    (start,) = resting_states(model, 1).q
    return moved(model, start, rng.uniform(-1.5, 1.5, model.nv))


def _closed_at(
    model: Model,
    q: NDArray[np.float64],
    name: str,
    kind: str,
    one: int,
    two: int,
    rng: np.random.Generator,
) -> NamedLoop:
    """A loop that is closed at a configuration: frame 2 is where frame 1 is."""
    place1 = rng.uniform(-0.2, 0.2, 3)
    turn1, at1 = pose_of(model, q, one)
    turn2, at2 = pose_of(model, q, two)
    turned = turn2.T @ turn1
    place2 = turn2.T @ (at1 + turn1 @ place1 - at2)
    ends = (
        LoopEnd(model.links[one].name, tuple(place1.tolist())),
        LoopEnd(model.links[two].name, tuple(place2.tolist()), _rpy(turned)),
    )
    axis2 = (1.0, 0.0, 0.0) if LOOP_WORDS[kind].axes == 2 else (0.0, 0.0, 1.0)
    return NamedLoop(name, kind, *ends, axis2=axis2)


def standing(
    model: Model,
    kind: str,
    *links: str,
    seed: int = 1,
    at: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> Model:
    """Return a robot some of whose links are held by the ground where they are in some pose.

    They are held at a place ``at`` in their own frames.
    """
    (start,) = resting_states(model, 1).q
    q = moved(model, start, np.random.default_rng(seed).uniform(-0.7, 0.7, model.nv))
    numbers = {link.name: k for k, link in enumerate(model.links)}
    held = []
    for name in links:
        turn, place = pose_of(model, q, numbers[name])
        place = place + turn @ np.array(at)
        ends = LoopEnd(name, at), LoopEnd(model.links[0].name, tuple(place.tolist()), _rpy(turn))
        held.append(NamedLoop(name, kind, *ends))
    return with_loops(model, tuple(held))


def quadruped() -> Model:
    """Return a body on four legs of three joints each, whose feet are pinned to the ground."""
    parts = [Part(BASE, None, FLOATING, rod(8.0, vector(0.3, 0.0, 0.0)))]
    across, down = vector(0.0, 1.0, 0.0), vector(0.0, 0.0, -0.2)
    for name, x, y in (("fl", 0.2, 0.1), ("fr", 0.2, -0.1), ("rl", -0.2, 0.1), ("rr", -0.2, -0.1)):
        hip, place = vector(0.0, 0.8 * y, 0.0), vector(x, y, 0.0)
        along = vector(1.0, 0.0, 0.0)
        parts += [
            Part(f"{name}_hip", BASE, REVOLUTE, rod(0.7, hip), place, axis=along),
            Part(f"{name}_thigh", f"{name}_hip", REVOLUTE, rod(1.0, down), hip, axis=across),
            Part(f"{name}_calf", f"{name}_thigh", REVOLUTE, rod(0.2, down), down, axis=across),
        ]
    model = assemble("quadruped", parts, floating=True)
    feet = [f"{name}_calf_link" for name in ("fl", "fr", "rl", "rr")]
    return standing(model, "point", *feet, at=(0.0, 0.0, -0.2))


def _rpy(turn: NDArray[np.float64]) -> tuple[float, float, float]:
    pitch = float(np.arcsin(-turn[2, 0]))
    roll = float(np.arctan2(turn[2, 1], turn[2, 2]))
    return roll, pitch, float(np.arctan2(turn[1, 0], turn[0, 0]))


def states_of(model: Model, count: int, seed: int = 1) -> States:
    """Return states in which loops are closed, with random torques."""
    q, v = closed_states(model, count, seed=seed, starts=20 * count)
    assert len(q) == count
    tau = np.random.default_rng(seed).uniform(-1.0, 1.0, (count, model.ntau))
    return States(q, v, tau)


MECHANISMS: dict[str, Callable[[], Model]] = {
    "four-bar": four_bar,
    "four-bar closed by a point": lambda: four_bar("point"),
    "four-bar on a floating base": lambda: four_bar(floating=True),
    "four-bar with a massless coupler": lambda: four_bar(massless=True),
    "slider-crank": slider_crank,
    "gear": geared,
}
