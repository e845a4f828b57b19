"""Writes states files and result files."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from adagen.atomic_files import write_whole
from adagen.errors import EnvironmentFault, printable
from adagen.model import Model
from adagen.states.types import Array, States, columns, fields_of, wrench_columns


def write_states(states: States, model: Model, path: Path | str) -> None:
    """Write a states file that `read_states` reads back bit by bit, whole or not at all.

    Raises:
        EnvironmentFault: writing failed.
    """
    write_whole(Path(path), states_text(states, model))


def states_text(states: States, model: Model) -> str:
    """Return the text of a states file that `read_states` reads back bit by bit."""
    rows = {}
    for j, joint in enumerate(model.joints):
        q, v = columns(model, j, "q"), columns(model, j, "v")
        values = (states.q[:, q], states.v[:, v], states.tau[:, v])
        rows[joint.name] = dict(zip(fields_of(joint), map(_listed, values), strict=True))
    gravity = [float(x) for x in model.gravity]
    head: dict[str, Any] = {"floating": model.floating, "gravity": gravity}
    if model.wrenches:
        head["forces"] = {
            wrench.frame.name: states.tau[:, wrench_columns(model, k)].tolist()
            for k, wrench in enumerate(model.wrenches)
        }
    return _text(head, rows)


def write_result(path: Path | str, model: Model, qdd: Array) -> None:
    """Write a result file, whole or not at all; its numbers read back bit by bit.

    Args:
        path: the file.
        model: whose accelerations they are.
        qdd: shape (S, nv), or (nv,) for one state.

    Raises:
        EnvironmentFault: an acceleration is not finite, or writing failed.
    """
    every = np.atleast_2d(np.asarray(qdd, dtype=np.float64))
    if every.shape[1] != model.nv:
        raise ValueError(f"qdd has {every.shape[1]} columns, not {model.nv}")
    rows = {}
    for j, joint in enumerate(model.joints):
        own = every[:, columns(model, j, "v")]
        if not np.isfinite(own).all():
            raise EnvironmentFault(f"joint '{printable(joint.name)}': qdd is not finite")
        rows[joint.name] = {"qdd": _listed(own)}
    write_whole(Path(path), _text({}, rows))


def _listed(rows: Array) -> list[Any]:
    """Return a number per state for one degree of freedom, a list per state for more."""
    listed: list[Any] = rows[:, 0].tolist() if rows.shape[1] == 1 else rows.tolist()
    return listed


def _text(head: dict[str, Any], joints: dict[str, dict[str, list[Any]]]) -> str:
    """Return the JSON text, a line for each joint."""
    start = "".join(f"{json.dumps(k)}: {json.dumps(v)},\n" for k, v in head.items())
    rows = (f"{json.dumps(k)}: {json.dumps(v, allow_nan=False)}" for k, v in joints.items())
    return "{" + start + '"joints": {\n' + ",\n".join(rows) + "\n}}\n"
