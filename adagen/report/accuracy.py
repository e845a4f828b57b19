"""Errors of a solver's answers beside their bounds, for a report."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from adagen.errors import InputError
from adagen.library import Compiled
from adagen.states import read_result, write_states

STATES = 12
DIGITS = 25
LARGEST = 150
"""Degrees of freedom of the largest robot whose true accelerations are computed."""


@dataclass(frozen=True)
class Accuracy:
    """Errors of answers to random states, and what bounds them.

    Attributes:
        errors: relative errors in the energy norm, one for each state.
        bounds: what the solver certifies of each; empty where it certifies nothing.
        predicted: the error that is predicted, or None.
        digits: to which the accelerations are known that answers are compared with.
        missing: why there are no errors; empty where there are.
    """

    errors: tuple[float, ...] = ()
    bounds: tuple[float | None, ...] = ()
    predicted: float | None = None
    digits: int = 0
    missing: str = ""


def accuracy_of(
    made: Compiled, run: Callable[[list[str]], None], on_progress: Callable[[str], None]
) -> Accuracy:
    """Let a solver answer random states and compare its answers with certified ones.

    Args:
        made: what was compiled.
        run: runs the program that was built with the given arguments.
        on_progress: called with messages about progress.

    Raises:
        AdagenError: the run fails.
    """
    from adagen.studies.random_states import drawn_states
    from adagen.studies.truth import truth_of

    model = made.model
    if model.nv > LARGEST:
        return Accuracy(missing=f"The robot has more than {LARGEST} degrees of freedom.")
    if model.wanted:
        return Accuracy(missing="The scene leaves out accelerations.")
    try:
        states = drawn_states(model, STATES, 1).read_in(made.request.scalar)
        truth = truth_of(model, states, digits=DIGITS, on_progress=on_progress)
    except InputError as error:
        return Accuracy(missing=f"There is no answer to compare with: {error.message}.")
    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        given, result = Path(folder, "states.json"), Path(folder, "result.json")
        write_states(states, model, given)
        run(["--states", str(given), "--result", str(result)])
        found = read_result(result, model)[:, : model.nv]
        bounds = json.loads(result.read_text(encoding="utf-8")).get("error_bounds", [])
    if not np.isfinite(found).all():
        return Accuracy(missing="The solver did not answer every state.")
    errors = tuple(truth.error(s, row) for s, row in enumerate(found))
    predicted = None if made.digits is None else 10.0**-made.digits
    return Accuracy(errors, tuple(bounds), predicted, DIGITS)
