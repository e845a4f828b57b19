"""Emitted solvers at work for benchmarks: built, run for given states, their answers read."""

from __future__ import annotations

import json
import re
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.build import build_executable, find_toolchain
from adagen.emit import emit, stem_of
from adagen.model import Model
from adagen.plan import Plan
from adagen.run import launch
from adagen.states import States, read_result, write_states

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Answers:
    """What an emitted solver answered.

    Attributes:
        qdd: accelerations, shape (S, nv).
        corrections: their sizes, shape (S, steps of refinement).
    """

    qdd: Array
    corrections: Array


def answers(
    plan: Plan, model: Model, states: States, *, raw: bool = False, **emission: Any
) -> Answers:
    """Return what the emitted solver of a plan answers.

    Args:
        plan: the plan.
        model: whose plan it is.
        states: what is solved for.
        raw: whether a solver that refines is to answer as it does before its first correction.
        emission: further arguments of ``emit``.

    Raises:
        UsageError: the plan cannot be emitted so.
        RuntimeError: the solver refuses; its own words.
    """
    stem, toolchain = stem_of(plan), find_toolchain()
    text = emit(plan, **emission)[f"{stem}.cpp"]
    if raw:
        text, found_once = re.subn(r"(constexpr int kRefine) = \d;", r"\1 = 0;", text)
        assert found_once == 1
    program = build_executable(text, stem, toolchain)
    with tempfile.TemporaryDirectory() as folder:
        given, found = Path(folder, "states.json"), Path(folder, "result.json")
        write_states(states, model, given)
        words = ["--states", str(given), "--result", str(found)]
        ran = launch(program, plan.launched, words, toolchain, timeout=120)
        if ran.status != 0:
            raise RuntimeError(ran.stderr.strip().removeprefix(f"{given}: "))
        corrections = json.loads(found.read_text(encoding="utf-8")).get("corrections", [])
        return Answers(read_result(found, model), np.array(corrections, dtype=float))
