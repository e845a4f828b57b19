"""What two notations of the same loops have to agree in."""

from __future__ import annotations

import numpy as np

from adagen.model import Coupling, Loop, Model


def alike(one: Model, other: Model) -> None:
    """Assert that two models have the same loops, couplings, joints and links."""
    assert [joint.name for joint in one.joints] == [joint.name for joint in other.joints]
    assert [joint.kind for joint in one.joints] == [joint.kind for joint in other.joints]
    assert len(one.loops) == len(other.loops) and len(one.couplings) == len(other.couplings)
    for mine, theirs in zip(one.loops, other.loops, strict=True):
        _same_loop(mine, theirs)
    for tie, same in zip(one.couplings, other.couplings, strict=True):
        assert _scaled(tie) == _scaled(same)


def _same_loop(one: Loop, other: Loop) -> None:
    assert (one.name, one.kind, one.tolerance) == (other.name, other.kind, other.tolerance)
    for (link, frame), (same, beside) in zip(one.ends, other.ends, strict=True):
        assert link == same
        assert np.array_equal(frame.rotation, beside.rotation)
        assert np.array_equal(frame.translation, beside.translation)


def _scaled(tie: Coupling) -> tuple[dict[int, float], float]:
    """What a coupling says, whichever side it is written on."""
    first = dict(tie.terms)[min(dict(tie.terms))]
    return {joint: factor / first for joint, factor in tie.terms}, tie.offset / first
