"""Robots with joints held as a scene holds them, and where joints have their numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from adagen.model import Model


def held(model: Model, locked: Sequence[int]) -> Model:
    """Return the robot with joints kept at rest by prescribed accelerations."""
    joints = list(model.joints)
    for j in locked:
        joints[j] = replace(joints[j], prescribed=True)
    return replace(model, joints=tuple(joints))


def rows(model: Model, joints: Sequence[int], what: str = "v") -> list[int]:
    """Return the entries of some joints in v (or q)."""
    start = model.q_start if what == "q" else model.v_start
    size = {j: getattr(model.joints[j].kind, f"n{what}") for j in joints}
    return [start[j] + k for j in joints for k in range(size[j])]
