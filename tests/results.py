"""Result files as solvers write them."""

from __future__ import annotations

import json
from pathlib import Path

from adagen.model import Model
from tests.models import Array


def write_result(path: Path, model: Model, qdd: Array) -> None:
    """Write the accelerations of some states, shape (S, nv)."""
    joints = {}
    for joint, start in zip(model.joints, model.v_start, strict=True):
        own = qdd[:, start : start + joint.kind.nv]
        joints[joint.name] = {"qdd": (own[:, 0] if joint.kind.nv == 1 else own).tolist()}
    path.write_text(json.dumps({"joints": joints}))
