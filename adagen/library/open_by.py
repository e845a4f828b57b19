"""How far a loop or coupling is open in a state, as in a solver's failure message."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from adagen.model import PRISMATIC, Model
from adagen.reference.closed import constraints


def open_by(model: Model, number: int, q: ArrayLike, v: ArrayLike, *, opens: bool) -> str:
    """Return how far a loop is open, or how fast it opens; empty where it is closed.

    Args:
        model: the robot.
        number: of the loop, or of a coupling behind all loops.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
        opens: whether it is asked how fast it opens.
    """
    found = constraints(model, q)
    gaps = found.rows @ np.asarray(v, dtype=float) if opens else found.gaps
    loops = model.loops
    counts = [loop.kind.rows for loop in loops] + [1] * len(model.couplings)
    own = gaps[sum(counts[:number]) :][: counts[number]]
    if number < len(loops):
        places = len(loops[number].kind.linear)
    else:
        first, _ = model.couplings[number - len(loops)].terms[0]
        places = int(model.joints[first].kind == PRISMATIC)
    per = "/s" if opens else ""
    sizes = ((own[:places], "m"), (own[places:], "rad"))
    words = [f"{size:.3g} {unit}{per}" for part, unit in sizes if (size := np.linalg.norm(part))]
    if not words:
        return ""
    return f": it {'opens' if opens else 'is open'} by {' and '.join(words)}"
