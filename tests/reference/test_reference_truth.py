"""Against the true answers of the shared robots: 60 digits, another reader, another recursion."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from adagen.errors import AdagenError
from adagen.model import Model
from adagen.reference import exact_forward_dynamics, forward_dynamics, inverse_dynamics, residual
from adagen.states import States, read_states
from adagen.urdf import read_robot
from tests.slow import spread

Array = NDArray[np.float64]
SHARED = Path(__file__).resolve().parents[2].parent / "shared" / "robots"
SLOW = 150  # degrees of freedom beyond which one state, not five, is solved exactly


def modes() -> list[Any]:
    """Return the files and modes; nothing where the shared robots are absent."""
    cases = []
    for path in sorted([*SHARED.glob("param/*.json"), *SHARED.glob("real/*.json")]):
        for mode in json.loads(path.read_text())["modes"]:
            cases.append(pytest.param(path, mode, id=f"{path.stem}-{mode}"))
    return cases or [pytest.param(None, "", marks=pytest.mark.skip("no shared robots here"))]


def loaded(path: Path, mode: str, folder: Path) -> tuple[Model, States, Array, dict[str, Any]]:
    """Return the model, its states through the states file, the true answers and the mode."""
    truth = json.loads(path.read_text())["modes"][mode]
    model = read_robot(path.with_suffix(".urdf"), floating=mode == "floating").model
    states = folder / "states.json"
    states.write_text(json.dumps({"floating": mode == "floating", "joints": truth["joints"]}))
    columns = [np.atleast_2d(np.array(truth["joints"][j.name]["qdd"]).T).T for j in model.joints]
    return model, read_states(states, model), np.hstack(columns), truth


def plain(model: Model) -> bool:
    """Return whether the model holds the file's own numbers: nothing is turned or lumped."""
    turned = [joint.rotation for joint in model.joints] + [joint.axis for joint in model.joints]
    return all(np.isin(x, (-1, 0, 1)).all() for x in turned) and not any(
        link.merged for link in model.links
    )


@pytest.mark.parametrize(("path", "mode"), spread(modes(), 16))
def test_true_answers(path: Path, mode: str, tmp_path: Path) -> None:
    status = json.loads(path.read_text())["modes"][mode]["status"]
    if status != "ok":
        with pytest.raises(AdagenError):
            read_robot(path.with_suffix(".urdf"), floating=mode == "floating")
        return
    model, states, qdd, truth = loaded(path, mode, tmp_path)
    reached = truth["check"].get("rel_pin_crba_solve")
    tolerance = max(1e-9, 1000 * min(1e-6, reached if isinstance(reached, float) else 0.0))
    # The truth knows no doubles but the file's; a model's turned frames are rounded to double, and
    # the condition of the joint-space inertia is what the answer can make of that.
    rounding = 1e-15
    if not plain(model):
        rounding = max(1e-14, 2 * np.finfo(float).eps * truth["check"]["cond_M_scaled"])
    few = states.count if model.nv < SLOW else 1
    for s in range(states.count):
        state, scale = (states.q[s], states.v[s]), max(1.0, np.abs(qdd[s]).max())
        fast = forward_dynamics(model, *state, states.tau[s])
        assert np.abs(fast - qdd[s]).max() <= tolerance * scale
        # Far below what is asked: within ten times of what CRBA in double was seen to reach.
        assert np.abs(fast - qdd[s]).max() <= 10 * max(1e-14, reached) * scale
        assert residual(model, *state, states.tau[s], qdd[s]) <= max(1e-11, reached)
        if s < few:
            answer = exact_forward_dynamics(model, *state, states.tau[s])
            assert answer.error < 1e-60
            assert np.abs(answer.value - qdd[s]).max() <= rounding * scale


def test_inverse_dynamics_gives_the_torques_back(shared: Path, tmp_path: Path) -> None:
    model, states, qdd, _ = loaded(shared / "real" / "erd_a1.json", "floating", tmp_path)
    for s in range(states.count):
        tau = inverse_dynamics(model, states.q[s], states.v[s], qdd[s])
        scale = max(1.0, np.abs(qdd[s]).max())
        np.testing.assert_allclose(tau, states.tau[s], atol=1e-12 * scale)
