"""Random mechanisms with closed loops, and what plans answer in their worst closed states.

Truth is the plan itself in hundreds of bits. Whether the plan is right at all is seen from dense
algebra in the null space of J, which knows nothing of it, to the digits that this has in double.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from flint import ctx
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.executor.solve import interpret
from adagen.graph import BALLS
from adagen.model import (
    KINDS,
    LOOP_KINDS,
    Inertia,
    Joint,
    Link,
    LoopEnd,
    Model,
    NamedCoupling,
    NamedLoop,
    closed,
)
from adagen.plan import Plan, make_plan
from adagen.reference.closed import (
    closed_forward_dynamics,
    closed_states,
    constraints,
    moved,
    pose_of,
)
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import States

Array = NDArray[np.float64]
WRONG = 1e-6
"""Error from which on, relative to the largest acceleration and to 1, an answer is wrong."""
BITS = 400
DRAWN = 40
"""At least so many closed states are drawn, of which the worst are used, by the least singular
value of J."""


def _turn(rng: np.random.Generator) -> Array:
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    result: Array = q if np.linalg.det(q) > 0 else q[:, [1, 0, 2]]
    return result


def _body(rng: np.random.Generator, size: float) -> Inertia:
    mass = size * float(rng.uniform(0.2, 2.0))
    turn = _turn(rng)
    spread = turn @ np.diag(rng.uniform(0.03, 0.2, 3) ** 2) @ turn.T
    tensor = mass * (np.trace(spread) * np.eye(3) - spread)
    return Inertia(mass, rng.uniform(-0.2, 0.2, 3), (tensor + tensor.T) / 2)


def _tree(
    rng: np.random.Generator,
    joints: int,
    kinds: tuple[str, ...],
    size: Callable[[], float],
    *,
    planar: bool = False,
) -> Model:
    """A random tree; a planar one has parallel axes that are no coordinate axes."""
    links, made = [Link("ground", Inertia.zero())], []
    axis, across = (_turn(rng)[:, k] for k in (0, 1))
    axis = axis / np.linalg.norm(axis)
    across = across - axis * (axis @ across)
    along = np.cross(axis, across)
    for j in range(joints):
        parent = j if rng.uniform() < 0.7 else int(rng.integers(0, j + 1))
        kind = KINDS[kinds[int(rng.integers(len(kinds)))]]
        if planar:
            a, b = rng.uniform(-0.4, 0.4, 2)
            place, turn, own = a * across + b * along, np.eye(3), axis
        else:
            place, turn, own = rng.uniform(-0.3, 0.3, 3), _turn(rng), rng.normal(size=3)
        own = own / np.linalg.norm(own) if kind.has_axis else np.array([0.0, 0.0, 1.0])
        made.append(Joint(f"j{j}", kind, parent, turn, place, own))
        links.append(Link(f"l{j}", _body(rng, size())))
    order = _depth_first(made)
    number = {0: 0, **{j + 1: k + 1 for k, j in enumerate(order)}}
    from dataclasses import replace

    return Model(
        "mechanism",
        (links[0], *(links[j + 1] for j in order)),
        tuple(replace(made[j], parent=number[made[j].parent]) for j in order),
    )


def _depth_first(joints: list[Joint]) -> list[int]:
    order: list[int] = []
    waiting = [j for j in reversed(range(len(joints))) if joints[j].parent == 0]
    while waiting:
        j = waiting.pop()
        order.append(j)
        waiting += [k for k in reversed(range(len(joints))) if joints[k].parent == j + 1]
    return order


def _looped(
    rng: np.random.Generator, model: Model, kinds: list[str], axis: Array | None = None
) -> Model:
    """A tree with loops that are closed in some configuration."""
    rest = np.zeros(model.nq)
    for j, joint in enumerate(model.joints):
        if joint.kind.quaternion is not None:
            rest[model.q_start[j] + joint.kind.nq - 1] = 1.0
    q = moved(model, rest, rng.uniform(-1.5, 1.5, model.nv))
    loops = []
    for k, kind in enumerate(kinds):
        one, two = (int(x) for x in rng.permutation(len(model.joints) + 1)[:2])
        place = rng.uniform(-0.2, 0.2, 3)
        (turn1, at1), (turn2, at2) = pose_of(model, q, one), pose_of(model, q, two)
        if axis is not None:
            place = place - axis * (axis @ place)
        there = turn2.T @ (at1 + turn1 @ place - at2)
        direction = (0.0, 0.0, 1.0) if axis is None else tuple(axis.tolist())
        ends = (
            LoopEnd(model.links[one].name, _three(place)),
            LoopEnd(model.links[two].name, _three(there), _rpy(turn2.T @ turn1)),
        )
        second = (1.0, 0.0, 0.0) if LOOP_KINDS[kind].axes == 2 else (0.0, 0.0, 1.0)
        loops.append(NamedLoop(f"loop{k}", kind, *ends, direction, second))
    return _with(model, tuple(loops), ())


def _with(
    model: Model, loops: tuple[NamedLoop, ...], couplings: tuple[NamedCoupling, ...]
) -> Model:
    links = {link.name: k for k, link in enumerate(model.links)}
    names = {joint.name: j for j, joint in enumerate(model.joints)}
    return closed(model, loops, couplings, lambda name: (links[name], None), names.__getitem__)


def _three(values: Array) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return x, y, z


def _rpy(turn: Array) -> tuple[float, float, float]:
    pitch = float(np.arcsin(np.clip(-turn[2, 0], -1.0, 1.0)))
    roll = float(np.arctan2(turn[2, 1], turn[2, 2]))
    return roll, pitch, float(np.arctan2(turn[1, 0], turn[0, 0]))


def _spatial(rng: np.random.Generator) -> Model:
    model = _tree(rng, int(rng.integers(5, 10)), ("revolute", "prismatic"), lambda: 1.0)
    return _looped(rng, model, [str(rng.choice(list(LOOP_KINDS)))])


def _balls(rng: np.random.Generator) -> Model:
    model = _tree(rng, int(rng.integers(3, 6)), ("spherical", "revolute"), lambda: 1.0)
    return _looped(rng, model, [str(rng.choice(["spherical", "revolute", "universal"]))])


def _planar(rng: np.random.Generator) -> Model:
    model = _tree(rng, int(rng.integers(3, 7)), ("revolute",), lambda: 1.0, planar=True)
    return _looped(rng, model, ["revolute"], model.joints[0].axis)


def _two(rng: np.random.Generator) -> Model:
    model = _tree(rng, int(rng.integers(8, 13)), ("revolute",), lambda: 1.0)
    return _looped(rng, model, ["spherical", str(rng.choice(["spherical", "planar"]))])


def _graded(rng: np.random.Generator) -> Model:
    model = _tree(
        rng,
        int(rng.integers(6, 10)),
        ("revolute",),
        lambda: float(10.0 ** rng.uniform(-8, 2)),
    )
    return _looped(rng, model, [str(rng.choice(["spherical", "cylindrical", "revolute"]))])


def _geared(rng: np.random.Generator) -> Model:
    model = _tree(rng, int(rng.integers(4, 9)), ("revolute", "prismatic"), lambda: 1.0)
    chosen = rng.permutation(len(model.joints))[:3]
    terms = tuple((model.joints[j].name, float(rng.uniform(-6, 6))) for j in chosen)
    return _with(model, (), (NamedCoupling("gear", terms, 0.1),))


FAMILIES: dict[str, Callable[[np.random.Generator], Model]] = {
    "spatial, one loop": _spatial,
    "ball joints": _balls,
    "planar, turned": _planar,
    "two loops": _two,
    "masses of 1e-8 to 1e2": _graded,
    "geared": _geared,
}


def mechanisms(count: int, seed: int) -> Iterator[tuple[str, Model]]:
    """Yield mechanisms with their families, by turns."""
    rng = np.random.default_rng(seed)
    for k in range(count):
        name = list(FAMILIES)[k % len(FAMILIES)]
        yield name, FAMILIES[name](rng)


@dataclass
class Outcome:
    """What became of mechanisms of a family.

    Attributes:
        mechanisms: how many were tried.
        never: how many were refused before any state was looked at.
        answered: states that were answered.
        refused: states that were refused.
        wrong: states answered with an error of ``WRONG`` or more.
        strange: states answered otherwise than dense algebra answers them.
        worst: the largest error.
    """

    mechanisms: int = 0
    never: int = 0
    answered: int = 0
    refused: int = 0
    wrong: int = 0
    strange: int = 0
    worst: float = 0.0


def audit(model: Model, states: int, outcome: Outcome, seed: int = 1) -> None:
    """Solve a mechanism in its worst closed states and some others; count the outcomes."""
    outcome.mechanisms += 1
    try:
        plan = make_plan(model, best_schedule(model, 1, load_profile("default")))
    except InputError:
        outcome.never += 1
        return
    worst = worst_states(model, states, seed)
    for q, v, tau in worst.each:
        _audit_state(model, plan, q, v, tau, outcome)


def worst_states(model: Model, count: int, seed: int = 1) -> States:
    """Return closed states of a mechanism: half of them the least regular of many, others drawn.

    Args:
        model: the mechanism.
        count: how many at most: those that are drawn may be among the others, too.
        seed: the same gives the same states.
    """
    q, v = closed_states(model, max(DRAWN, count), seed=seed)
    least = [np.linalg.svd(constraints(model, each).rows, compute_uv=False) for each in q]
    ranks = [int((sizes > 1e-9 * sizes[0]).sum()) for sizes in least]
    order = np.argsort(
        [sizes[rank - 1] / sizes[0] for sizes, rank in zip(least, ranks, strict=True)]
    )
    rng = np.random.default_rng(seed)
    kept = [
        k
        for k in dict.fromkeys((*order[: count // 2].tolist(), *range(count - count // 2)))
        if k < len(q)
    ]
    tau = rng.uniform(-1, 1, (len(kept), model.ntau))
    return States(q[kept], v[kept], tau)


def _audit_state(
    model: Model, plan: Plan, q: Array, v: Array, tau: Array, outcome: Outcome
) -> None:
    try:
        found = interpret(plan, q, v, tau, once=True)
    except FloatingPointError:
        outcome.refused += 1
        return
    outcome.answered += 1
    with ctx.workprec(BITS):
        try:
            truth = np.array([float(x) for x in interpret(plan, q, v, tau, BALLS)])
        except FloatingPointError:  # that is at the very limit of what is refused
            outcome.refused += 1
            return
    size = max(1.0, float(np.abs(truth).max()))  # of a truss it is zero
    error = float(np.abs(found - truth).max()) / size
    outcome.worst = max(outcome.worst, error)
    outcome.wrong += int(not error < WRONG)
    rows = constraints(model, q).rows
    sizes = np.linalg.svd(rows, compute_uv=False)
    rank = int((sizes > 1e-9 * sizes[0]).sum())
    dense = closed_forward_dynamics(model, q, v, tau)
    known = 1e-9 * (sizes[0] / sizes[rank - 1]) ** 2
    strange = float(np.abs(dense - truth).max()) / size
    outcome.strange += int(strange > max(1e-4, known))
