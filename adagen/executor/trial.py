"""Predicted digits of a sweep on a robot, from a trial in random states.

Articulated bodies are swept in numpy as in emitted code (trial_sweep.py): for straight lines in
link axes, where a joint's projection is exact, with the same few operations for rotations
(frames.py); for loops in base axes, except joints in their own axes (adagen/plan/own_axes.py). The
same sweep in higher precision gives the rounding error. Joins are not included. Plans with closed
loops are carried out by the executor in a few states.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np
from flint import ctx
from numpy.typing import NDArray

from adagen.executor.program_states import COUNT, program_states
from adagen.executor.solve import interpret
from adagen.executor.trial_sweep import Sweep
from adagen.graph import BALLS, DOUBLE, FLOAT
from adagen.model import Model
from adagen.plan.closure_steps import nothing_moves
from adagen.plan.own_axes import OwnAxes
from adagen.plan.types import Plan
from adagen.reference.closed import closed_states
from adagen.states import hardened

Array = NDArray[Any]
States = tuple[Array, Array, Array]
STATES = {"few joints": COUNT, "many joints": 4}
HARDEST, TIMES = 8, {"few joints": 32, "many joints": 8}
"""How many of the states that lose most are tried again, and how often: what is lost there differs
from one rounding to the next by more than a decade."""
ONE_IN = 24
"""What is predicted of a state is what one in so many of its roundings reaches: a little above
the largest of eight, which by itself may be a quarter of what a solver's one rounding loses."""
HARD_TIMES = 8
"""How often hard states are tried again."""
MANY = 200
"""Joints beyond which fewer states are tried: what many joints lose varies less."""
HARD, HARD_JOINTS = 1600, 11200
"""How many hard states are tried, and most joints in all of them together. Few of them lose most:
in 64 states of a wrist of three axes a decade or two less is lost than in 400."""
AS_MANY, OFTEN = 400, 0.5
"""What is predicted is the largest loss of so many states: what as many as this of them reach. A
single state may lose ten times as much as all others, so that the largest of others says little."""
BEYOND_LINES, BEYOND_LOOPS = 1.25, 2.0
"""By how much more than is found is predicted in hard states: for half of all robots the largest
loss is beyond what as many reach, and loops round more often than the trial does."""
_MORE: dict[str, tuple[Any, Any]] = {
    "double": (np.float64, np.longdouble),
    "float": (np.float32, np.float64),
}


@dataclass(frozen=True)
class Trial:
    """The predicted loss of a sweep.

    Attributes:
        error: relative forward error in the energy norm, the largest of the states; infinite where
            a factorization fails.
        joint: the joint that has the largest share of it.
    """

    error: float
    joint: int


def tried(plan: Plan, own_axes: OwnAxes | None) -> Trial:
    """Return the loss of the sweeps on a robot in the states of ``--check``.

    Args:
        plan: its joints, links and scalar are used.
        own_axes: joints that are computed in their own axes, always or where digits are lost, all
            others in base axes; None: every body is in its link's axes.
    """
    states, times = _states(plan), TIMES[_how_many(plan)]
    count = len(states[0])
    shares, errors, _, hardest = _lost_again(
        plan, own_axes, states, HARDEST, lambda which: _rounded_anew(states, which, times)
    )
    anew = np.arange(count, len(errors)).reshape(len(hardest), times)
    roundings = np.hstack([hardest[:, None], anew])
    candidates = np.hstack(
        [
            np.delete(np.arange(count), hardest),
            [_reached(errors, one) for one in roundings],
        ]
    )
    return _found(shares, errors, int(candidates[np.argmax(errors[candidates])]))


@lru_cache(maxsize=4)  # first for a warning, then for the digits
def tried_hard(plan: Plan, own_axes: OwnAxes | None) -> Trial:
    """Return the loss of the sweeps in hard states (``hardened``), where they are not refused.

    What emitted code would refuse is left out: near gimbal lock of wrists through light links every
    digit is lost, and the solver says so.

    Args:
        plan: as of ``tried``.
        own_axes: as of ``tried``.
    """
    count = max(1, min(HARD, HARD_JOINTS // len(plan.joints)))
    hinges = [joint.q for joint in plan.joints if joint.kind == "revolute"]
    drawn = program_states(plan, count, seed=2)
    own, _ = _MORE[plan.scalar]
    hard = hardened(*drawn, hinges, np.random.default_rng(2))
    q, v, tau = (x.astype(own).astype(np.float64) for x in hard)  # as the solver reads them

    def beside(which: Array) -> States:
        repeated = np.repeat(which, HARD_TIMES)
        near = _beside(q[repeated], hinges).astype(own).astype(np.float64)
        return near, v[repeated], tau[repeated]

    most = max(1, min(HARDEST, count // HARDEST))
    found = _lost_again(plan, own_axes, (q, v, tau), most, beside, answered=True)
    shares, errors, refused, hardest = found
    errors = np.where(refused, 0, errors)
    weights = np.ones(len(errors))
    weights[hardest] = weights[count:] = 1 / (1 + HARD_TIMES)
    place = _place(errors, weights, OFTEN * count / AS_MANY)
    trial = _found(shares, errors, place)
    beyond = BEYOND_LINES if own_axes is None else BEYOND_LOOPS
    return replace(trial, error=trial.error * beyond)


def _reached(errors: Array, roundings: Array) -> int:
    """Return which of some roundings loses what one in ``ONE_IN`` of them does; one that fails."""
    order = roundings[np.argsort(errors[roundings])[::-1]]
    fails = not np.isfinite(errors[order[0]])
    return int(order[0 if fails else len(order) // ONE_IN])


def _place(errors: Array, weights: Array, often: float) -> int:
    """Return the index of the error that a share ``often`` of all reaches; the largest of few."""
    order = np.argsort(errors)[::-1]
    before = int(np.searchsorted(np.cumsum(weights[order]), often, side="right"))
    return int(order[max(0, before - 1)])


def _beside(q: Array, hinges: list[int]) -> Array:
    """Configurations equally near to quarter turns, with different rounding."""
    found, quarter = q.copy(), np.pi / 2
    near = quarter * np.round(q[:, hinges] / quarter)
    by = np.random.default_rng(3).uniform(-1e-3, 1e-3, near.shape)
    found[:, hinges] = near + (q[:, hinges] - near) * (1 + by)
    return found


def _found(shares: Array, errors: Array, place: int) -> Trial:
    """A trial from one squared error and the joints' parts in it."""
    return Trial(float(np.sqrt(errors[place])), int(np.argmax(np.nan_to_num(shares[place]))))


def carried_out(plan: Plan) -> Trial:
    """Return the loss of a whole plan, as the executor carries it out.

    Passive torques and outer forces are left out: factors are the same without them.

    Args:
        plan: of a robot without closed loops or slaved joints, all accelerations wanted.

    Raises:
        FloatingPointError: a factorization fails; the message names the joint.
    """
    algebra = FLOAT if plan.scalar == "float" else DOUBLE
    states = q, v, tau = _states(plan)
    tau[:, plan.nv :] = 0
    found = interpret(plan.without_passive_torques(), q.T, v.T, tau.T, algebra)[: plan.nv].T
    return loss_of(plan, states, found)


def loss_of(plan: Plan, states: States, found: Array) -> Trial:
    """Return the loss of a plan's answers without passive torques and outer forces.

    Args:
        plan: of a robot without closed loops or slaved joints.
        states: q, v and tau, one state in each row.
        found: accelerations, shape (S, nv).
    """
    more = _MORE[plan.scalar][1]
    truth = accelerations(plan, *states)
    shares, errors = _off(plan, states, np.asarray(found, more), truth)
    return _found(shares, errors, int(np.argmax(errors)))


def _off(plan: Plan, states: States, found: Array, truth: Array) -> tuple[Array, Array]:
    """Squared relative errors in the energy norm, and the joints' parts in them."""
    size = Sweep(plan, np.float64, None, states)
    with np.errstate(all="ignore"):
        shares = size.energy((found - truth).astype(np.float64))
        errors = shares.sum(axis=1) / size.energy(truth.astype(np.float64)).sum(axis=1)
    errors[~np.isfinite(errors)] = np.inf
    return shares, errors


def _lost(
    plan: Plan, own_axes: OwnAxes | None, states: States
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """The joints' parts in squared errors, the squared errors, and the refused states.

    The shares, shape (states, joints), come first.
    """
    own, more = _MORE[plan.scalar]
    with np.errstate(all="ignore"):
        truth = Sweep(plan, more, None, states).solved()
        found, refused = _swept(plan, own, own_axes, states)
        refused |= ~np.isfinite(found).all(axis=1)
        return *_off(plan, states, found.astype(more), truth), refused


def _lost_again(
    plan: Plan,
    own_axes: OwnAxes | None,
    states: States,
    most: int,
    anew: Callable[[Array], States],
    answered: bool = False,
) -> tuple[Array, Array, NDArray[np.bool_], Array]:
    """What is lost in states, and after that in others like those that lose most.

    Args:
        plan: as of ``tried``.
        own_axes: as of ``tried``.
        states: the first ones.
        most: how many of them lose most.
        anew: returns others like those with some indices.
        answered: whether refused states are none of these.

    Returns:
        As of ``_lost``, and the indices of the states that lose most. One pass is enough where
        these are all.
    """
    count = len(states[0])
    if most >= count:
        every = np.arange(count)
        both = [np.concatenate(pair) for pair in zip(states, anew(every), strict=True)]
        return *_lost(plan, own_axes, (both[0], both[1], both[2])), every
    first = shares, errors, refused = _lost(plan, own_axes, states)
    hardest = np.argsort(np.where(refused & answered, 0, errors))[-most:]
    again = _lost(plan, own_axes, anew(hardest))
    shares, errors, refused = (np.concatenate(pair) for pair in zip(first, again, strict=True))
    return shares, errors, refused, hardest


def _rounded_anew(states: States, which: Array, times: int) -> States:
    """States with tiny changes of angles that change only the rounding, several for each."""
    rng = np.random.default_rng(3)
    q, v, tau = (np.repeat(x[which], times, axis=0) for x in states)
    return q * (1 + rng.uniform(-1e-8, 1e-8, q.shape)), v, tau


def _swept(
    plan: Plan, number: Any, own_axes: OwnAxes | None, states: States
) -> tuple[Array, NDArray[np.bool_]]:
    """The answers of emitted code in states, and the states that it would refuse.

    Sweeps that lose digits are repeated in own axes.
    """
    if own_axes is None:
        line = Sweep(plan, number, None, states, rounded=True)
        return line.solved(), line.refused
    first = Sweep(plan, number, own_axes.always, states, rounded=True, watched=own_axes.if_lost)
    found, refused = first.solved(), first.refused
    if first.lost.any():
        everywhere = own_axes.always | own_axes.if_lost
        again = Sweep(plan, number, everywhere, states, rounded=True)
        found[first.lost] = again.solved()[first.lost]
        refused |= again.refused & first.lost
    return found, refused


def accelerations(plan: Plan, q: Array, v: Array, tau: Array) -> Array:
    """Return the accelerations of states in higher precision than the plan's scalar.

    Slaved joints are treated as independent ones.

    Args:
        plan: of the robot.
        q: configurations, shape (S, nq).
        v: velocities, shape (S, nv).
        tau: torques, shape (S, nv).
    """
    more = _MORE[plan.scalar][1]
    return Sweep(plan, more, None, (q, v, tau)).solved()


def _states(plan: Plan) -> States:
    """States that the emitted program draws, one in each row; fewer for many joints."""
    return program_states(plan, STATES[_how_many(plan)])


def _how_many(plan: Plan) -> str:
    """Return the key of numbers that depend on how many joints there are."""
    return "many joints" if len(plan.joints) > MANY else "few joints"


CLOSED_STATES = 4
BITS = (256, 1024, 4096)
"""In which plans with closed loops are carried out for the truth, the first that suffices."""


def tried_closed(model: Model, plan: Plan) -> Trial:
    """Return the digits that a plan loses in states in which the robot's loops are closed.

    It is carried out in the plan's scalar and in many bits. Singular poses are left out. Where no
    joint can move, nothing is lost.

    Args:
        model: the robot.
        plan: its plan.

    Raises:
        FloatingPointError: no state can be solved; the message names what fails.
    """
    if nothing_moves(plan):
        return Trial(0.0, 0)
    rng = np.random.default_rng(1)
    algebra = FLOAT if plan.scalar == "float" else DOUBLE
    worst, failed = None, None
    for q, v in zip(*closed_states(model, CLOSED_STATES, seed=1), strict=True):
        tau = rng.uniform(-1.0, 1.0, model.ntau)
        try:
            found = np.asarray(interpret(plan, q, v, tau, algebra), dtype=float)
            truth = _truth(plan, q, v, tau)
        except FloatingPointError as error:
            failed = error
            continue
        off = np.abs(found - truth) / max(float(np.abs(truth).max()), 1e-300)
        place = int(np.argmax(off))
        joint = max(j for j, start in enumerate(model.v_start) if start <= place)
        if worst is None or off[place] > worst.error:
            worst = Trial(float(off[place]), joint)
    if worst is None:
        raise failed or FloatingPointError("no state in which its loops are closed")
    return worst


def _truth(plan: Plan, q: Any, v: Any, tau: Any) -> Any:
    """The accelerations in the precision that long chains need."""
    for bits in BITS:
        with ctx.workprec(bits):
            try:
                return np.array([float(x) for x in interpret(plan, q, v, tau, BALLS)])
            except FloatingPointError as error:
                failed = error
    raise failed
