"""Closures between trees that are connected by loops only, such as two robots that carry a bar.

All joints of such a closure are eliminated by the inward sweeps. Each tree carries the constraint
rows to its floating base and finds there how constraint forces accelerate the rows. No
acceleration is chosen as dependent, and the work is linear in the number of joints. Each tree may
be on a process of its own: the processes exchange a few numbers.

Links without inertia that only a loop holds cannot be eliminated so: their closure stays as it is.
"""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from adagen.model import FLOATING, Model
from adagen.plan.closures import Choice, Closure, closures_of, inertias_of, must_be_held
from adagen.plan.loop_groups import freedoms_of

Array = NDArray[np.float64]

MOST_LOST = 1e6
"""How much larger than its pivots a side's inertia may be; of an arm of 40 links it is 1e4."""


@lru_cache(maxsize=4)
def closures_between_trees(model: Model) -> tuple[Closure, ...]:
    """Return a robot's closures, those between separate trees without unknown joints.

    None where no closure is like that, or it has so few freedoms that it pays to hold them back.

    Raises:
        InputError: as ``closures_of``.
    """
    closures = closures_of(model)
    found = tuple(_carried(one) if _apart(model, one) else one for one in closures)
    return () if found == closures else found


def _carried(closure: Closure) -> Closure:
    """A closure whose rows are carried by all its joints."""
    (first, *_) = closure.choices
    return replace(closure, held=(), choices=(Choice((), first.rows, first.scales),))


def _apart(model: Model, closure: Closure) -> bool:
    """Whether a closure connects floating trees by loops only, and has many joints.

    Freedoms that are held back cost the cube of their number, rows that are carried cost as much as
    there are rows for each joint: measured by operations, both are about equal at twice the rows.
    """
    loops, path = [model.loops[k] for k in closure.loops], closure.path
    bases = [j for j in path if model.joints[j].parent == 0]
    columns = freedoms_of(model, path)
    return (
        closure.top == 0
        and len(bases) > 1
        and not closure.couplings
        and all(all(loop.links) for loop in loops)
        and all(model.joints[j].kind is FLOATING for j in bases)
        and not any(model.joints[j].prescribed for j in path)
        and not must_be_held(model, path)
        and len(columns) > 6 * len(bases) + 2 * len(closure.rows)
        and all(_lost(each) <= MOST_LOST for each in inertias_of(model, columns))
    )


def _lost(inertia: Array) -> float:
    """The ratio of an inertia's entries to its pivots, from the outermost freedom on."""
    left, worst = inertia.copy(), 1.0
    for k in reversed(range(len(left))):
        pivot = float(left[k, k])
        if pivot <= 0.0:
            return np.inf
        worst = max(worst, float(inertia[k, k]) / pivot)
        left[:k, :k] -= np.outer(left[:k, k], left[k, :k]) / pivot
    return worst
