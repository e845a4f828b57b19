"""Emitted solvers one of whose processes receives the passage of the joints before its own."""

from __future__ import annotations

from pathlib import Path

import pytest

from adagen.model import Model
from adagen.plan import make_plan
from adagen.states import random_states
from tests.emit.test_strips import balls_and_hinges
from tests.emitted import ROUNDING, Builder
from tests.models import serial_chain
from tests.plan.test_sent_passages import two_halves
from tests.slow import slow


@pytest.mark.parametrize(
    ("model", "root", "channel", "scalar", "refine"),
    [
        (serial_chain(72), 38, "auto", "double", 0),
        slow(serial_chain(72), 38, "message", "double", 1),
        slow(balls_and_hinges(60, seed=4), 31, "threads", "double", 0),
        slow(serial_chain(40), 20, "auto", "float", 0),
    ],
    ids=["in a window", "corrected", "balls in threads", "float"],
)
def test_the_receiver_answers_right(
    model: Model,
    root: int,
    channel: str,
    scalar: str,
    refine: int,
    builder: Builder,
    tmp_path: Path,
) -> None:
    plan = make_plan(model, two_halves(model, root), channel=channel, scalar=scalar)
    states = random_states(model, 4, seed=root)
    solver = builder.solver(plan, name="told", shape="kernels", refine=refine)
    assert solver.error(model, states, tmp_path, "--check") < 5 * ROUNDING[scalar]
