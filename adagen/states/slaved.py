"""States of slaved joints, from those of the joints that they follow."""

from __future__ import annotations

from typing import Any

import numpy as np

from adagen.errors import InputError
from adagen.jsonfile import Refusal
from adagen.model import Model
from adagen.states.types import States, columns

_AGREE = 1e-9  # how far a slaved joint may be from what it follows


def follow_sources(states: States, model: Model, given: dict[str, Any]) -> None:
    """Set slaved joints from their sources; where the file gives them too, they must agree."""
    done = {j for j, joint in enumerate(model.joints) if joint.mimic is None}
    waiting = [j for j in range(len(model.joints)) if j not in done]
    while waiting:
        ready = [j for j in waiting if (m := model.joints[j].mimic) is None or m.source in done]
        if not ready:
            raise InputError("mimic joints follow one another in a ring")
        for j in ready:
            _set_follower(states, model, j, model.joints[j].name in given)
        done.update(ready)
        waiting = [j for j in waiting if j not in done]


def _set_follower(states: States, model: Model, j: int, given: bool) -> None:
    joint, mimic = model.joints[j], model.joints[j].mimic
    assert mimic is not None
    for field, array in (("q", states.q), ("v", states.v)):
        own, source = columns(model, j, field), columns(model, mimic.source, field)
        offset = mimic.offset if field == "q" else 0.0
        expected = array[:, source] * mimic.multiplier + offset
        wrong = np.abs(array[:, own] - expected) > _AGREE * (1.0 + np.abs(expected))
        if given and wrong.any():
            s = int(np.flatnonzero(wrong[:, 0])[0])
            raise Refusal(
                f"joint '{joint.name}': {field}, state {s}: {array[s, own][0]:.9g} is not what "
                f"its mimic of '{model.joints[mimic.source].name}' makes of it, "
                f"{expected[s, 0]:.9g}; leave the joint out, or do without --mimic"
            )
        array[:, own] = expected
