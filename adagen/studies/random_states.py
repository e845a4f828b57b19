"""Random states for studies, with closed loops where the robot has loops."""

from __future__ import annotations

import numpy as np

from adagen.errors import InputError
from adagen.model import REVOLUTE, Model
from adagen.plan.loop_checks import why_open
from adagen.reference.closed import closed_states, constraints, constraints_of_all
from adagen.states import States, hardened, random_states

NEAR = 1e-4
"""Least singular value of J, beside the largest, of a pose that is no singular one."""
_MORE = 3  # configurations drawn for each that is wanted: some are singular


def drawn_states(model: Model, count: int, seed: int = 0) -> States:
    """Return random states; of a robot with loops closed ones, away from singular poses.

    Args:
        model: the robot.
        count: how many, at least 1; where fewer are found they repeat.
        seed: at least 0.

    Raises:
        InputError: the loops cannot be closed.
    """
    states = random_states(model, count, seed)
    if not model.closed:
        return states
    q, v = closed_states(model, _MORE * count, seed, starts=20 * count)
    if not len(q):
        raise InputError(why_open(model))
    sizes = np.linalg.svd(constraints_of_all(model, q).rows, compute_uv=False)
    apart = sizes > 1e-9 * sizes[:, :1]
    rank = apart.sum(axis=1)
    least = np.where(apart, sizes, np.inf).min(axis=1, initial=np.inf)
    good = (rank == rank.max()) & (least > NEAR * sizes[:, 0])
    kept = np.resize(np.flatnonzero(good) if good.any() else np.arange(len(q)), count)
    return States(q[kept], v[kept], states.tau)


def hard_states(model: Model, count: int, seed: int = 0) -> States:
    """Return random states of a robot, half of their angles near multiples of a quarter turn.

    Velocities are up to 100, torques up to 1000, by orders of magnitude. A robot with loops is in
    closed configurations, as `drawn_states` finds them.
    """
    rng = np.random.default_rng((seed, 1))
    states = drawn_states(model, count, seed)
    hinges = [
        model.q_start[j]
        for j, joint in enumerate(model.joints)
        if joint.kind is REVOLUTE and not model.closed
    ]
    return States(*hardened(*states.parts, hinges, rng))


def check_closed(model: Model, states: States) -> None:
    """Refuse states in which a loop is open.

    Raises:
        InputError: a loop is open by more than its tolerance; the message names it.
    """
    limits = {loop.name: loop.tolerance for loop in model.loops}
    limits |= {coupling.name: coupling.tolerance for coupling in model.couplings}
    for s, q in enumerate(states.q if model.closed else (), start=1):
        found = constraints(model, q)
        for name, gap in zip(found.names, found.gaps, strict=True):
            if not abs(gap) <= limits[name]:
                raise InputError(
                    f'state {s}: loop "{name}": it is open by {abs(gap):.2g} (m or rad); adagen '
                    "info MODEL --states N prints states that are closed"
                )
