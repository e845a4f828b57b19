"""Checked states of a model, and slaved (mimic) joints projected out."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.model import Mimic, Model
from adagen.reference.numbers import Numbers, Numeric

Array = NDArray[np.float64]


def checked(model: Model, name: str, values: Any, size: int) -> Array:
    """Return values as doubles.

    Raises:
        ValueError: the shape is not (size,).
        InputError: a value is not finite.
    """
    array = np.array(values, dtype=np.float64)
    if array.shape != (size,):
        raise ValueError(f"{name} has shape {array.shape}, not ({size},)")
    if not np.isfinite(array).all():
        starts = model.q_start if size == model.nq and name == "q" else model.v_start
        at = int(np.flatnonzero(~np.isfinite(array))[0])
        joint = model.joints[max(j for j, start in enumerate(starts) if start <= at)]
        raise InputError(f"joint '{joint.name}': {name} holds {array[at]}, not a finite number")
    return array


def followers(model: Model) -> list[tuple[int, int, list[Mimic]]]:
    """Return for each slaved joint its index, its source's and the relations on the way there.

    Raises:
        InputError: the joints slave one another in a circle, or have several degrees of freedom.
    """
    result = []
    for j, joint in enumerate(model.joints):
        if joint.mimic is None:
            continue
        chain, source = [joint.mimic], joint.mimic.source
        while (mimic := model.joints[source].mimic) is not None:
            if len(chain) > len(model.joints):
                raise InputError(f"joint '{joint.name}': mimic joints follow one another in a ring")
            chain.append(mimic)
            source = mimic.source
        if joint.kind.nq != 1 or model.joints[source].kind.nq != 1:
            raise InputError(f"joint '{joint.name}': only joints of one coordinate can be slaved")
        result.append((j, source, chain[::-1]))
    return result


def coupled(
    numbers: Numbers, model: Model, q: Numeric, v: Numeric, *more: Numeric
) -> tuple[Numeric, ...]:
    """Return copies of q, v and further velocity-like arrays with slaved entries set."""
    q, rates = q.copy(), [array.copy() for array in (v, *more)]
    for j, source, chain in followers(model):
        value = q[model.q_start[source]]
        changes = [rate[model.v_start[source]] for rate in rates]
        for mimic in chain:
            times, offset = numbers.array([mimic.multiplier, mimic.offset])
            value = value * times + offset
            changes = [change * times for change in changes]
        q[model.q_start[j]] = value
        for rate, change in zip(rates, changes, strict=True):
            rate[model.v_start[j]] = change
    return (q, *rates)


def coupling(numbers: Numbers, model: Model) -> Numeric:
    """Return G, shape (nv, nr), with v = G v_r, v_r the velocities of free joints.

    The problem with slaved joints is then (G^T H G) qdd_r = G^T (tau - bias), qdd = G qdd_r; with
    prescribed accelerations the bias holds them too, and qdd = G qdd_r + what is prescribed.
    """
    matrix = numbers.array(np.eye(model.nv))
    for j, source, chain in followers(model):
        row = model.v_start[j]
        matrix[row] = numbers.zeros(model.nv)
        times = numbers.array([1.0])[0]
        for mimic in chain:
            times = times * numbers.array([mimic.multiplier])[0]
        matrix[row, model.v_start[source]] = times
    return matrix[:, free_rows(model)]


def free_rows(model: Model) -> list[int]:
    """Return the degrees of freedom neither slaved nor prescribed, ascending; the columns of G."""
    slaved = {model.v_start[j] for j, joint in enumerate(model.joints) if joint.mimic}
    known = set(prescribed_rows(model))
    return [k for k in range(model.nv) if k not in slaved and k not in known]


def prescribed_rows(model: Model) -> list[int]:
    """Return the degrees of freedom whose acceleration is given in tau, ascending."""
    return [
        model.v_start[j] + k
        for j, joint in enumerate(model.joints)
        if joint.prescribed
        for k in range(joint.kind.nv)
    ]


def prescribed(numbers: Numbers, model: Model, tau: Numeric) -> Numeric:
    """Return the accelerations, shape (nv,), that tau prescribes; zero elsewhere."""
    result = numbers.zeros(model.nv)
    rows = prescribed_rows(model)
    result[rows] = tau[rows]
    return result


def row_names(model: Model) -> list[str]:
    """Return the joint's name of each degree of freedom."""
    return [joint.name for joint in model.joints for _ in range(joint.kind.nv)]
