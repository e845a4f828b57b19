"""Emitted solvers at work for benchmarks: timed by turns, run for given states, answers read."""

from __future__ import annotations

import json
import re
import sys
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.build import Toolchain, build_executable, find_toolchain
from adagen.emit import emit, stem_of
from adagen.model import Model
from adagen.plan import Plan
from adagen.run import launch
from adagen.states import States, read_result, write_states
from adagen.studies.bench.contest import Contestant, Rules, Times, hold
from adagen.studies.bench.emitted import Emitted

Array = NDArray[np.float64]


def source_of(plan: Plan, **emission: Any) -> str:
    """Return the source of a plan's solver, with further arguments of ``emit``.

    Raises:
        UsageError: the plan cannot be emitted so.
    """
    text: str = emit(plan, **emission)[f"{stem_of(plan)}.cpp"]
    return text


def contestant(
    name: str, model: Model, plan: Plan, text: str, toolchain: Toolchain | None = None
) -> Contestant:
    """Return a plan's emitted solver as a contestant, compiled.

    Args:
        name: of the contestant.
        model: whose plan it is.
        plan: the plan.
        text: its source.
        toolchain: what to build with; the usual one if not given.
    """
    own = Emitted(name, model, f"{stem_of(plan)}.cpp", text, "", plan.launched, plan.scalar, None)
    return own.contestant(find_toolchain() if toolchain is None else toolchain)


def by_turns(
    contestants: Sequence[Contestant], rounds: int, repeat: int = Rules().repeat
) -> dict[str, Mapping[str, Times]]:
    """Return the times of contestants by name; who is given up, and why, is told.

    Args:
        contestants: who is timed.
        rounds: how often the turn of each comes.
        repeat: evaluations of each state in a turn.
    """
    times, gone = hold(contestants, Rules(rounds, repeat), tell)
    for name, reason in gone.items():
        tell(f"{name}: {reason}")
    return dict(times)


def tell(text: str) -> None:
    """Say how far a benchmark is."""
    print(text, file=sys.stderr, flush=True)


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
    text, toolchain = source_of(plan, **emission), find_toolchain()
    if raw:
        text, found_once = re.subn(r"(constexpr int kRefine) = \d;", r"\1 = 0;", text)
        assert found_once == 1
    program = build_executable(text, stem_of(plan), toolchain)
    with tempfile.TemporaryDirectory() as folder:
        given, found = Path(folder, "states.json"), Path(folder, "result.json")
        write_states(states, model, given)
        words = ["--states", str(given), "--result", str(found)]
        ran = launch(program, plan.launched, words, toolchain, timeout=120)
        if ran.status != 0:
            raise RuntimeError(ran.stderr.strip().removeprefix(f"{given}: "))
        corrections = json.loads(found.read_text(encoding="utf-8")).get("corrections", [])
        return Answers(read_result(found, model), np.array(corrections, dtype=float))
