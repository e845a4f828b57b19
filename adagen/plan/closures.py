"""Closures: loops and couplings that are solved together, and their independent accelerations.

Loops that share joints are one closure. Its constraints are J qdd = -Jdot v. Often some rows are
redundant (planar loops, overconstrained mechanisms). Redundant rows and dependent accelerations are
chosen at random closed states, by elimination with complete pivoting of J. Masses only decide
between choices that this offers, where the inertia of a heavy link would hide that of light ones.
The dependent accelerations are z = G y + g. In poses in which G is large, an orthogonal basis of
the null space of the rows is used instead. In a closure with many degrees of freedom, only the
joints of z stay unknowns, and all others are eliminated by the inward sweep.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.model import Model
from adagen.model.paths import path_to_ground
from adagen.plan.independent_coordinates import NO_PIVOT, Numbers, chosen
from adagen.plan.loop_checks import check_inertia, check_joints, check_prescribed, why_open
from adagen.plan.loop_groups import (
    LoopGroup,
    connected,
    freedoms_of,
    loop_paths,
    rows_of,
)
from adagen.reference.closed import closed_states, constraints_of_all
from adagen.reference.double import joint_space_inertia
from adagen.reference.loop_rows import usual_sizes

Array = NDArray[np.float64]

SAMPLES = 64
"""Consistent states at which choices are made; of many freedoms fewer."""
MOST_SAMPLED = 2000
"""Freedoms of all samples together, so that choices take seconds."""
WEIGHED = 4
"""Of them, those at which inertias are looked at."""
MOST_HELD = 30
"""Freedoms of a closure up to which all of them are held back; more where many rows tie them."""


@dataclass(frozen=True)
class Choice:
    """A choice of dependent accelerations and kept rows.

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

    @property
    def apart(self) -> bool:
        """Whether it connects separate trees, which carry its rows (separate_trees.py)."""
        return not self.held


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
    check_prescribed(model, rows)
    found = tuple(with_choices(model, one, rows) for one in connected(model, loop_paths(model)))
    check_inertia(model, q, rows)
    return found


@lru_cache(maxsize=4)
def sampled(model: Model) -> tuple[Array, Array]:
    """Return configurations in which all loops are closed, and J there, shape (S, rows, nv).

    Raises:
        InputError: loops cannot be closed, or go over joints that are slaved or prescribed.
    """
    check_joints(model)
    count = max(8, min(SAMPLES, MOST_SAMPLED // model.nv))
    q, _ = closed_states(model, count, starts=3 * count)
    if not len(q):
        raise InputError(why_open(model))
    return q, constraints_of_all(model, q).rows


@dataclass(frozen=True)
class Sampled:
    """The rows of some loops and couplings at closed states, without rows that are always zero.

    Attributes:
        columns: entries of v that they act on, beyond the top.
        rows: numbers in the robot.
        scales: of these rows, powers of two that bring them to a size.
        values: brought to a size, without entries that rounding alone makes, shape (S, rows, nv).
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
        """Return a choice in the numbers of these columns and rows."""
        return Choice(
            tuple(self.columns[c] for c in moved),
            tuple(self.rows[r] for r in kept),
            tuple(self.scales[r] for r in kept),
        )


def sampled_rows(model: Model, tied: LoopGroup, samples: Array) -> Sampled:
    """Return the rows of some loops and couplings.

    Args:
        model: the robot.
        tied: these.
        samples: J of the robot at closed states.
    """
    rows = [row for k in tied.members for row in rows_of(model)[k]]
    columns = freedoms_of(model, tied.path)
    of_all = np.abs(samples[:, rows]).max(axis=2, initial=0.0)
    sizes = of_all.max(axis=0, initial=0.0)
    there = sizes > NO_PIVOT * usual_sizes(model)[rows]
    rows = [row for row, some in zip(rows, there.tolist(), strict=True) if some]
    usual = np.median(of_all[:, there], axis=0)
    usual = np.where(usual > NO_PIVOT * sizes[there], usual, sizes[there])
    scales = [2.0 ** -round(float(np.log2(size))) for size in usual]
    return Sampled(
        columns, rows, scales, without_rounding(samples[:, rows] / sizes[there][:, None])
    )


def without_rounding(values: Array) -> Array:
    """Return rows, brought to one size, without entries that are only rounding at all states.

    A rod that turns about the line through its two balls moves neither of them. What rounding makes
    of that differs from one processor to the next, and would be taken for a motion that rows feel.

    Args:
        values: shape (S, rows, columns).
    """
    return np.where(np.abs(values).max(axis=0, initial=0.0) > NO_PIVOT, values, 0.0)


def closure_of(
    model: Model, tied: LoopGroup, rows: Sequence[int], choices: Sequence[Choice], *, whole: bool
) -> Closure:
    """Return a closure; of a whole one all joints are unknowns."""
    of_freedom = {k: j for j in tied.path for k in freedoms_of(model, [j])}
    held = {of_freedom[k] for choice in choices for k in choice.moved}
    loops = len(model.loops)
    return Closure(
        tied.top,
        tuple(k for k in tied.members if k < loops),
        tuple(k - loops for k in tied.members if k >= loops),
        tied.path,
        tied.path if whole else tuple(sorted(held | must_be_held(model, tied.path))),
        tuple(rows),
        tuple(choices),
    )


def with_choices(model: Model, tied: LoopGroup, samples: Array) -> Closure:
    """Choose dependent accelerations so that the largest G is smallest."""
    found = sampled_rows(model, tied, samples)
    whole = len(found.columns) <= max(MOST_HELD, 2 * _rank(found.own))
    inertias = inertias_of(model, found.columns) if whole else []
    (moved, kept), others = chosen(found.own, depths_of(model, tied.path), inertias, whole=whole)
    choices = [found.choice(moved, kept)]
    looped = any(k < len(model.loops) for k in tied.members)
    if whole and 0 < len(moved) < len(found.columns) and looped:
        choices += [found.choice((), each) for each in others]
    return closure_of(model, tied, found.rows, choices, whole=whole)


def _rank(samples: Array) -> int:
    """Return the number of independent rows where most are independent.

    Where these alone are held back, a system of twice as many unknowns is solved, accelerations and
    forces: if there are no more freedoms than that, it is better to hold all of them back.
    """
    sizes = np.linalg.svd(samples, compute_uv=False)
    return int((sizes > NO_PIVOT * sizes[:, :1]).sum(axis=1).max(initial=0))


def inertias_of(model: Model, columns: Sequence[int]) -> list[Array]:
    """Return the inertias of some freedoms at the first samples, with all joints beyond locked."""
    q, _ = sampled(model)
    found = [joint_space_inertia(model, each) for each in q[:WEIGHED]]
    return [each[np.ix_(columns, columns)] for each in found]


def depths_of(model: Model, path: Sequence[int]) -> list[int]:
    """Return the distance from the ground of each freedom's joint."""
    return [len(path_to_ground(model.joints, j + 1)) for j in path for _ in freedoms_of(model, [j])]


def must_be_held(model: Model, path: Sequence[int]) -> set[int]:
    """Return joints of a path that cannot be eliminated on the way: rotors act on them."""
    rotors = {j for j in path if model.joints[j].passive.rotor_inertia}
    coupled = {j for coupling in model.couplings for j, _ in coupling.terms}
    return rotors | coupled.intersection(path)
