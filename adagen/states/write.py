"""Writes states files."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from adagen.atomic_files import write_whole
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


def _listed(rows: Array) -> list[Any]:
    """Return a number per state for one degree of freedom, a list per state for more."""
    listed: list[Any] = rows[:, 0].tolist() if rows.shape[1] == 1 else rows.tolist()
    return listed


def _text(head: dict[str, Any], joints: dict[str, dict[str, list[Any]]]) -> str:
    """Return the JSON text, a line for each joint."""
    start = "".join(f"{json.dumps(k)}: {json.dumps(v)},\n" for k, v in head.items())
    rows = (f"{json.dumps(k)}: {json.dumps(v, allow_nan=False)}" for k, v in joints.items())
    return "{" + start + '"joints": {\n' + ",\n".join(rows) + "\n}}\n"
