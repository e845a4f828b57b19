"""Checks of robots with closed loops, before anything is planned: what is refused, by name."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.model import Model
from adagen.plan.independent_coordinates import NO_PIVOT
from adagen.plan.loop_groups import connected, freedoms_of, loop_paths, rows_of
from adagen.reference.closed import nearly_closed
from adagen.reference.double import joint_space_inertia

Array = NDArray[np.float64]

STILL = 1e-12
"""Inertia of a motion that the loops allow, relative to the joints' own, that counts as none."""


def check_joints(model: Model) -> None:
    """Refuse joints on the path of a loop that are not modelled there."""
    on_paths = set().union(*(path for _, path in loop_paths(model)))
    sources = {joint.mimic.source for joint in model.joints if joint.mimic is not None}
    for j in sorted(on_paths):
        joint = model.joints[j]
        if joint.mimic is not None or j in sources:
            raise InputError(
                f'joint "{joint.name}" is part of a closed loop and of a mimic: write the mimic '
                "as a coupling of the scene instead of --mimic"
            )


def check_prescribed(model: Model, rows: Array) -> None:
    """Refuse prescribed accelerations of more joints than the loops have degrees of freedom.

    Args:
        model: the robot.
        rows: J at closed states, shape (S, rows, nv).
    """
    if not any(joint.prescribed for joint in model.joints):
        return
    for tied in connected(model, loop_paths(model)):
        own = rows[:, [row for k in tied.members for row in rows_of(model)[k]]]
        columns = freedoms_of(model, tied.path)
        if all(rank(each[:, columns]) < rank(each) for each in own):
            given = [f'"{model.joints[j].name}"' for j in tied.path if model.joints[j].prescribed]
            raise InputError(
                f"accelerations of joints {', '.join(given)} cannot all be prescribed: closed "
                "loops do not leave them free; prescribe fewer"
            )


def rank(matrix: Array) -> int:
    """Number of independent rows."""
    sizes = np.linalg.svd(matrix, compute_uv=False)
    return int((sizes > NO_PIVOT * sizes[:1].sum()).sum())


def why_open(model: Model) -> str:
    """Return why no state of a robot is closed: open loops of the nearest one, and their gaps."""
    kinds = ["loop"] * bool(model.loops) + ["coupling"] * bool(model.couplings)
    names = [loop.name for loop in model.loops] + [c.name for c in model.couplings]
    gaps = nearly_closed(model)
    open_ones = sorted(names, key=lambda name: -gaps[name])[:3]
    left = ", ".join(f'"{name}" open by {gaps[name]:.2g}' for name in open_ones)
    quoted = ", ".join(f'"{name}"' for name in names[:5])
    more = f" and {len(names) - 5} more" if len(names) > 5 else ""
    what = (
        f"{' and '.join(f'{kind}s' for kind in kinds)} {quoted}{more} cannot all be closed"
        if len(names) > 1
        else f"{kinds[0]} {quoted} cannot be closed"
    )
    limits = {loop.name: loop.tolerance for loop in model.loops}
    limits |= {coupling.name: coupling.tolerance for coupling in model.couplings}
    way = f"correct their {'frames' if model.loops else 'factors and offsets'}"
    if model.loops and all(gaps[name] <= limits[name] for name in names):
        way = (
            "axes are not quite parallel, or frames not exact: give more digits (as in rpy), or "
            "take a kind that holds less (point)"
        )
    return (
        f"{what}: no configuration was found that does; the nearest one leaves {left} (m or rad); "
        f"{way}"
    )


def check_inertia(model: Model, q: Array, rows: Array) -> None:
    """Refuse a motion that the loops allow and no inertia resists in any configuration."""
    worst = []
    rotors = [joint.passive.rotor_inertia for joint in model.joints for _ in joint.kind.free]
    columns = freedoms_of(model, range(len(model.joints)))
    for each, matrix in zip(q, rows[:, :, columns], strict=True):
        right = np.linalg.svd(matrix)[2]
        free = np.zeros((model.nv, len(columns) - rank(matrix)))
        free[columns] = right[rank(matrix) :].T
        inertia = joint_space_inertia(model, each)
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
