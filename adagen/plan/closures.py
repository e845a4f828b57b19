"""Closures: which loops and couplings are solved together, where, and what follows from what.

Loops that share joints are one closure. Its constraints are J qdd = -Jdot v; often some rows follow
from others (planar loops, mechanisms that move though they are overconstrained). Which do, and
which freedoms follow from the rest, is found at consistent states that are drawn at random, by
elimination with complete pivoting of J alone: no mass, however light, decides it. Solved is then
z = G y + g for the freedoms that follow. In poses in which G is large, they follow from an
orthogonal basis of what the rows leave free instead. Where a closure has many freedoms, those of z
alone are held back, and all others are articulated on the way inwards.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.model import Model
from adagen.reference.closed import closed_states, constraints_of_all
from adagen.reference.double import joint_space_inertia

Array = NDArray[np.float64]
Numbers = tuple[int, ...]

SAMPLES = 64
"""Consistent states at which choices are made; of many freedoms fewer."""
MOST_SAMPLED = 2000
"""Freedoms of all samples together, so that choices take seconds."""
MOST_HELD = 30
"""Freedoms of a closure up to which all of them are held back."""
FOLLOWS = 1e-9
"""A pivot below this, relative to the largest entry, is none: the row follows from others."""
VANISHING = 1e-6
"""A singular value of rows that are brought to a size of one which counts as none."""
NEAR = 0.3
"""A pivot may be so much smaller than the largest one where it is better placed."""
FAR = 0.02
"""It may be even so much smaller in further choices that are compared with these."""
MOST_OFFERS = 24
"""Choices that are compared: those that suit most samples best."""
_OF_BASIS = 4
"""Products of an orthogonal basis beside rows^2 (freedoms left + 1)."""
MOST_SETS = 2
APART = 1e-2
"""Rows that are so far from following from each other, brought to a size of one, are good."""
LARGE = 200.0
"""Size of G up to which a choice loses hardly any digits, and nothing else is tried."""
STILL = 1e-12
"""Inertia of a motion that the loops allow, relative to the joints' own, that counts as none."""


@dataclass(frozen=True)
class Choice:
    """What follows from what.

    Attributes:
        moved: freedoms whose accelerations follow, as entries of v, ascending; none: by an
            orthogonal basis.
        rows: the rows that they follow by, numbered in the robot, ascending.
        scales: of these rows, powers of two that bring them to a size.
    """

    moved: tuple[int, ...]
    rows: tuple[int, ...]
    scales: tuple[float, ...]


@dataclass(frozen=True)
class Closure:
    """Loops and couplings that are solved together.

    Attributes:
        top: the last link that all its joints have in common; 0 is the ground.
        loops: numbers of its loops, ascending.
        couplings: numbers of its couplings.
        path: joints between the top and the links and joints that are tied, ascending.
        held: those of them whose accelerations are held back, ascending.
        rows: constraints of its loops and couplings that are any, numbered in the robot.
        choices: the usual one, and others for poses in which it is poor.
    """

    top: int
    loops: tuple[int, ...]
    couplings: tuple[int, ...]
    path: tuple[int, ...]
    held: tuple[int, ...]
    rows: tuple[int, ...]
    choices: tuple[Choice, ...]


@lru_cache(maxsize=4)  # asked for by every plan that is tried
def closures_of(model: Model) -> tuple[Closure, ...]:
    """Return the closures of a robot; none for a tree.

    Raises:
        InputError: its loops cannot be closed, leave a motion without inertia, or go over joints
            that are slaved or prescribed.
    """
    if not model.closed:
        return ()
    q, rows = sampled(model)
    found = tuple(with_choices(model, one, rows) for one in connected(model, tied_by(model)))
    _check_inertia(model, q, rows)
    return found


@lru_cache(maxsize=4)
def sampled(model: Model) -> tuple[Array, Array]:
    """Return configurations in which all loops are closed, and J there, shape (S, rows, nv).

    Raises:
        InputError: loops cannot be closed, or go over joints that are slaved or prescribed.
    """
    _check_joints(model)
    count = max(8, min(SAMPLES, MOST_SAMPLED // model.nv))
    q, _ = closed_states(model, count, starts=3 * count)
    if not len(q):
        raise InputError(why_open(model))
    return q, constraints_of_all(model, q).rows


def joints_from(model: Model, link: int) -> list[int]:
    """Return the joints from a link inwards to the ground."""
    found = []
    while link > 0:
        found.append(link - 1)
        link = model.joints[link - 1].parent
    return found


def _parted(model: Model, links: Sequence[int]) -> tuple[int, set[int]]:
    """The last link that some links hang on together, and the joints beyond it."""
    ways = [joints_from(model, link) for link in links]
    shared = set(ways[0]).intersection(*ways[1:])
    return max((j + 1 for j in shared), default=0), set().union(*ways) - shared


def tied_by(model: Model) -> list[tuple[int, set[int]]]:
    """Return for each loop, then each coupling, the link where it closes, and the joints beyond."""
    found = [_parted(model, (loop.link1, loop.link2)) for loop in model.loops]
    for coupling in model.couplings:
        joints = [j for j, _ in coupling.terms]
        top, path = _parted(model, [model.joints[j].parent for j in joints])
        found.append((top, path.union(joints)))
    return found


@dataclass(frozen=True)
class Tied:
    """Loops and couplings that are solved together: a closure but for what follows from what.

    Attributes:
        top: the link at which they are eliminated.
        members: numbers of its loops, then of its couplings behind all loops.
        path: joints beyond the top that they tie.
    """

    top: int
    members: tuple[int, ...]
    path: tuple[int, ...]


def connected(
    model: Model, tied: Sequence[tuple[int, set[int]]], wanted: Sequence[int] | None = None
) -> list[Tied]:
    """Put loops and couplings together where they share joints; the innermost tops come first.

    Args:
        model: the robot.
        tied: of each of them, the link where it closes, and the joints beyond.
        wanted: which of them count; all if not given.
    """
    groups: list[tuple[set[int], set[int]]] = []
    tops = [top for top, _ in tied]
    for number in range(len(tied)) if wanted is None else wanted:
        members, joints = {number}, set(tied[number][1])
        for other in [group for group in groups if group[1] & joints]:
            groups.remove(other)
            members, joints = members | other[0], joints | other[1]
        groups.append((members, joints))
    found = []
    for members, joints in groups:
        top, between = _parted(model, [tops[k] for k in sorted(members)])
        found.append(Tied(top, tuple(sorted(members)), tuple(sorted(joints | between))))
    return sorted(found, key=lambda one: (-one.top, one.members))


def _rows_of(model: Model) -> list[range]:
    """The rows of each loop, then of each coupling."""
    counts = [loop.kind.rows for loop in model.loops] + [1] * len(model.couplings)
    ends = np.cumsum([0, *counts])
    return [range(a, b) for a, b in zip(ends[:-1].tolist(), ends[1:].tolist(), strict=True)]


def _freedoms(model: Model, joints: Sequence[int]) -> list[int]:
    return [model.v_start[j] + k for j in joints for k in range(model.joints[j].kind.nv)]


@dataclass(frozen=True)
class Sampled:
    """The rows of some loops and couplings at closed states, those that are no rows left out.

    Attributes:
        columns: entries of v that they act on, beyond the top.
        rows: numbers in the robot.
        scales: of these rows, powers of two that bring them to a size.
        values: brought to a size, shape (S, rows, nv).
    """

    columns: list[int]
    rows: list[int]
    scales: list[float]
    values: Array

    @property
    def own(self) -> Array:
        """The rows for their own columns, shape (S, rows, columns)."""
        return self.values[:, :, self.columns]

    def choice(self, moved: Numbers, kept: Numbers) -> Choice:
        """Return a choice of columns and rows, numbered among these."""
        return Choice(
            tuple(self.columns[c] for c in moved),
            tuple(self.rows[r] for r in kept),
            tuple(self.scales[r] for r in kept),
        )


def sampled_rows(model: Model, tied: Tied, samples: Array) -> Sampled:
    """Return the rows of some loops and couplings.

    Args:
        model: the robot.
        tied: these.
        samples: J of the robot at closed states.
    """
    rows = [row for k in tied.members for row in _rows_of(model)[k]]
    columns = _freedoms(model, tied.path)
    of_all = np.abs(samples[:, rows]).max(axis=2, initial=0.0)
    sizes = of_all.max(axis=0, initial=0.0)
    there = sizes > FOLLOWS * float(sizes.max(initial=0.0))
    rows = [row for row, some in zip(rows, there.tolist(), strict=True) if some]
    usual = np.median(of_all[:, there], axis=0)
    usual = np.where(usual > FOLLOWS * sizes[there], usual, sizes[there])
    scales = [2.0 ** -round(float(np.log2(size))) for size in usual]
    return Sampled(columns, rows, scales, samples[:, rows] / sizes[there][:, None])


def closure_of(
    model: Model, tied: Tied, rows: Sequence[int], choices: Sequence[Choice], *, whole: bool
) -> Closure:
    """Return a closure; of a whole one all joints are held back."""
    of_freedom = {k: j for j in tied.path for k in _freedoms(model, [j])}
    held = {of_freedom[k] for choice in choices for k in choice.moved}
    loops = len(model.loops)
    return Closure(
        tied.top,
        tuple(k for k in tied.members if k < loops),
        tuple(k - loops for k in tied.members if k >= loops),
        tied.path,
        tied.path if whole else tuple(sorted(held | _must_be_held(model, tied.path))),
        tuple(rows),
        tuple(choices),
    )


def with_choices(model: Model, tied: Tied, samples: Array) -> Closure:
    """Choose what follows from what: so that G is least where it is largest."""
    found = sampled_rows(model, tied, samples)
    whole = len(found.columns) <= MOST_HELD
    (moved, kept), others = _choices(found.own, depths_of(model, tied.path), whole=whole)
    choices = [found.choice(moved, kept)]
    looped = any(k < len(model.loops) for k in tied.members)
    if whole and 0 < len(moved) < len(found.columns) and looped:
        choices += [found.choice((), each) for each in others]
    return closure_of(model, tied, found.rows, choices, whole=whole)


def _choices(
    samples: Array, depths: Sequence[int], *, whole: bool
) -> tuple[tuple[Numbers, Numbers], list[Numbers]]:
    """Return columns that follow with rows that they follow by, and rows for other poses.

    Chosen is what takes least arithmetic, that in poses in which it is poor included. Rows for
    those are the ones that are farthest from following from each other; where loops can be put
    together in several ways, there may be several sets, of several ranks.
    """
    pattern = np.abs(samples).max(axis=0) > 0.0
    offers = offers_of(samples, depths, whole=whole)
    losses = [np.array([largest(offer, each) for each in samples]) for offer in offers]
    best = min(range(len(offers)), key=lambda k: expected(offers[k], pattern, losses[k]))
    kept = list(dict.fromkeys(rows for _, rows in offers))
    apart = np.array([[_apart(rows, each) for each in samples] for rows in kept])
    taken: list[Numbers] = []
    so_far = np.zeros(len(samples))
    while len(taken) < MOST_SETS and (so_far < APART).any():
        reached = np.minimum(np.maximum(apart, so_far), APART).sum(axis=1)
        k = int(np.argmax(reached))
        if taken and float(reached[k]) < float(np.minimum(so_far, APART).sum()) + APART / 2:
            break
        taken.append(kept[k])
        so_far = np.maximum(so_far, apart[k])
    return offers[best], taken


def offers_of(
    samples: Array, depths: Sequence[int], *, whole: bool
) -> list[tuple[Numbers, Numbers]]:
    """Return columns that may follow with rows that they follow by, those of most samples first.

    Args:
        samples: J of the closure, shape (S, rows, columns).
        depths: of columns: how far from the ground their joints are.
        whole: whether all joints are held back, so that it matters what else rows act on.
    """
    if whole:  # what few rows feel, and of that what is farthest from the top, moves alone
        counts = (np.abs(samples).max(axis=0) > 0.0).sum(axis=0).tolist()
        most = max(depths, default=0) + 1
        weights = [count * most - depth for count, depth in zip(counts, depths, strict=True)]
    else:
        weights = list(depths)
    sizes = np.abs(samples).max(axis=(0, 1), initial=0.0)
    alike_columns = samples / np.where(sizes > 0.0, sizes, 1.0)  # metres beside radians
    offers = [
        offer
        for each, scaled in zip(samples, alike_columns, strict=True)
        for offer in (
            _pivots(scaled, weights, FAR),
            _pivots(scaled, weights),
            _pivots(each, weights),
            _pivots(each, ()),
        )
    ]
    return [offer for offer, _ in Counter(offers).most_common(MOST_OFFERS)]


def _apart(rows: Numbers, matrix: Array) -> float:
    """How far kept rows are from following from each other; 0 where others do not from them."""
    _, sizes, right = np.linalg.svd(matrix[list(rows)], full_matrices=False)
    if not len(sizes) or sizes[-1] < VANISHING:
        return 0.0 if len(rows) else float(not np.abs(matrix).max(initial=0.0) > VANISHING)
    rest = matrix - (matrix @ right.T) @ right
    return 0.0 if float(np.abs(rest).max(initial=0.0)) > 1e-6 else float(sizes[-1])


def expected(offer: tuple[Numbers, Numbers], pattern: Array, sizes: Array) -> tuple[float, float]:
    """Return what a choice takes on the average, in products, about; then the digits that it costs.

    Where G is large, it is computed in vain, and an orthogonal basis after it.
    """
    count = len(offer[0])
    again = float((sizes > LARGE).mean()) * _OF_BASIS * count**2 * (pattern.shape[1] - count + 1)
    digits = np.log10(np.clip(sizes, 1.0, 1e12)).mean()
    return _work(offer, pattern) + again, round(float(digits), 6)


def _work(offer: tuple[Numbers, Numbers], pattern: Array) -> int:
    """Products to solve by a choice: by the sizes of its independent parts."""
    columns, rows = map(list, offer)
    parts: list[tuple[set[int], int]] = []
    for row in pattern[np.ix_(rows, columns)]:
        touched, count = set(np.flatnonzero(row).tolist()), 1
        for part in [part for part in parts if part[0] & touched]:
            parts.remove(part)
            touched, count = touched | part[0], count + part[1]
        parts.append((touched, count))
    free = pattern.shape[1] - len(columns) + 1
    return sum(count**3 + count**2 * free for _, count in parts)


def largest(
    offer: tuple[Numbers, Numbers], matrix: Array, counted: Sequence[int] | None = None
) -> float:
    """Return the largest entry of G by a choice; infinity where rows do not follow from those kept.

    Args:
        offer: columns and rows.
        matrix: J of one state.
        counted: columns of G that count; all if not given.
    """
    columns, rows = map(list, offer)
    others = [c for c in range(matrix.shape[1]) if c not in columns]
    left = [r for r in range(len(matrix)) if r not in rows]
    square = matrix[np.ix_(rows, columns)]
    if len(square) and np.linalg.svd(square, compute_uv=False)[-1] < VANISHING:
        return np.inf
    follows = np.linalg.solve(square, matrix[np.ix_(rows, others)])
    rest = matrix[np.ix_(left, others)] - matrix[np.ix_(left, columns)] @ follows
    if float(np.abs(rest).max(initial=0.0)) > 1e-6:
        return np.inf
    if counted is not None:
        follows = follows[:, [k for k, c in enumerate(others) if c in counted]]
    return float(np.abs(follows).max(initial=0.0))


def depths_of(model: Model, path: Sequence[int]) -> list[int]:
    """Return how far from the ground the joint of each freedom is."""
    return [len(joints_from(model, j + 1)) for j in path for _ in range(model.joints[j].kind.nv)]


def _must_be_held(model: Model, path: Sequence[int]) -> set[int]:
    """Joints of a path that cannot be articulated as they are passed: rotors act on them."""
    rotors = {j for j in path if model.joints[j].passive.rotor_inertia}
    coupled = {j for coupling in model.couplings for j, _ in coupling.terms}
    return rotors | coupled.intersection(path)


def _pivots(matrix: Array, weights: Sequence[int], near: float = NEAR) -> tuple[Numbers, Numbers]:
    """Columns and rows of the pivots by which a matrix is eliminated, the largest ones first.

    Args:
        matrix: J of one state.
        weights: of columns: of pivots that are about as large, that of least weight is taken; none.
        near: a pivot may be so much smaller than the largest one.
    """
    left = matrix.copy()
    columns: list[int] = []
    rows: list[int] = []
    first = float(np.abs(left).max(initial=0.0))
    while True:
        sizes = np.abs(left)
        largest = float(sizes.max(initial=0.0))
        if largest <= FOLLOWS * first or largest == 0.0:
            return tuple(sorted(columns)), tuple(sorted(rows))
        good = np.argwhere(sizes >= largest * (near if weights else 1.0)).tolist()
        r, c = min(
            good, key=lambda rc: (weights[rc[1]] if weights else 0, -sizes[rc[0], rc[1]], rc)
        )
        columns.append(c)
        rows.append(r)
        left = left - np.outer(left[:, c], left[r]) / left[r, c]
        left[r], left[:, c] = 0.0, 0.0


def _check_joints(model: Model) -> None:
    """Refuse what is not modelled on the way of a loop."""
    on_paths = set().union(*(path for _, path in tied_by(model)))
    sources = {joint.mimic.source for joint in model.joints if joint.mimic is not None}
    for j in sorted(on_paths):
        joint = model.joints[j]
        if joint.mimic is not None or j in sources:
            raise InputError(
                f'joint "{joint.name}" is part of a closed loop and of a mimic: say the mimic as a '
                "coupling of the scene instead of --mimic"
            )
        if joint.prescribed:
            raise InputError(
                f'joint "{joint.name}" is part of a closed loop: its acceleration cannot be'
                " prescribed"
            )


def why_open(model: Model) -> str:
    """Return why no state of a robot is closed."""
    names = [loop.name for loop in model.loops] + [c.name for c in model.couplings]
    quoted = ", ".join(f'"{name}"' for name in names[:5])
    more = f" and {len(names) - 5} more" if len(names) > 5 else ""
    which = (
        f"loops {quoted}{more} cannot all be closed"
        if len(names) > 1
        else (f"loop {quoted} cannot be closed")
    )
    return f"{which}: no configuration was found that does; correct the frames of their ends"


def _check_inertia(model: Model, q: Array, rows: Array) -> None:
    """Refuse a motion that the loops allow and nothing resists, whatever the configuration."""
    worst = []
    rotors = [joint.passive.rotor_inertia for joint in model.joints for _ in joint.kind.free]
    for each, matrix in zip(q, rows, strict=True):
        _, sizes, right = np.linalg.svd(matrix)
        rank = int((sizes > FOLLOWS * sizes[:1].sum()).sum())
        free, inertia = right[rank:].T, joint_space_inertia(model, each)
        reduced = free.T @ (inertia + np.diag(rotors)) @ free
        if not len(reduced):
            return
        values, vectors = np.linalg.eigh(reduced)
        if values[0] > STILL * abs(values[-1]):
            return
        worst.append((float(values[0]), free @ vectors[:, 0]))
    _, motion = max(worst, key=lambda pair: pair[0])
    k = int(np.argmax(np.abs(motion)))
    j = max(j for j, start in enumerate(model.v_start) if start <= k)
    raise InputError(
        f'joint "{model.joints[j].name}" can move with no inertia to resist it, though loops are '
        "closed: give the links that it moves mass and inertia, or make it fixed"
    )
