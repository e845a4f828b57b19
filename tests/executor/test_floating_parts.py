"""Certificates of chains in parts as the executor carries them out: bounds beside true errors."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.executor import certificate
from adagen.executor.joins import Joins
from adagen.executor.run import lines_of
from adagen.model import Model
from adagen.plan.certificate import certified
from adagen.plan.steps import Disassemble, InvertRoot
from adagen.reference import exact_forward_dynamics
from adagen.states import random_states
from adagen.studies.random_states import hard_states
from benchmarks.stability.adversary import long_chains, robots
from tests.emit.test_parts import driven, graded
from tests.executor.test_certificate import _norm, _squares
from tests.long_doubles import LongDoubles
from tests.models import serial_chain
from tests.plan.test_parts import hinges, in_parts
from tests.slow import all_but

CHAINS: dict[str, Model] = {
    "random": hinges(27, seed=4),
    "driven": driven(hinges(25, seed=8)),
    "heavy outwards": graded(serial_chain(33), 1e5),
    "light outwards": graded(serial_chain(33), 1e-5),
    **{f"hard {k}": model for k, model in enumerate(robots(4, seed=3, families=[long_chains]))},
}


@pytest.mark.parametrize("name", all_but(CHAINS, "random", "hard 0", "hard 1", "hard 2"))
def test_no_bound_is_exceeded(name: str) -> None:
    """And none is much larger than that of the whole chain and the error together."""
    model = CHAINS[name]
    plan, whole = certified(in_parts(model)), certified(in_parts(model, parts=0))
    assert any(plan.steps_of(InvertRoot))
    loose = []
    for state in hard_states(model, 4, seed=4).each:
        try:
            qdd, error, answer = _squares(plan, state)
            _, of_whole, answer_of_whole = _squares(whole, state)
        except FloatingPointError:
            continue
        true = exact_forward_dynamics(model, *state, digits=25).value
        off = _norm(plan, state, qdd - true) / _norm(plan, state, true)
        bound, known = np.sqrt(error / answer), np.sqrt(of_whole / answer_of_whole)
        assert off <= bound, name
        loose.append(bound / (known + off))
    assert np.median(loose) < 100


def test_what_is_seen_is_rounding(monkeypatch: pytest.MonkeyPatch) -> None:
    """Wrenches and motions at the parts' ends are those of one chain: with more digits, no error.

    Without the allowance for rounding, that is, which is of doubles.
    """
    model = hinges(26, seed=3)
    for each in (model, driven(model)):
        state = next(iter(random_states(each, 1, seed=1).each))
        plan = certified(in_parts(each))
        qdd, _, answer = _squares(plan, state)
        assert np.sqrt(answer) == pytest.approx(_norm(plan, state, qdd), rel=1e-9)
        monkeypatch.setattr(certificate, "ROUNDING", 1e-9)
        lines_of.cache_clear()
        _, seen, _ = _squares(plan, state)
        _, in_more, _ = _squares(plan, state, LongDoubles())
        assert np.sqrt(in_more) < 0.02 * np.sqrt(seen)
        monkeypatch.undo()
        lines_of.cache_clear()


def test_a_force_between_parts_that_is_off_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """With one 1e-7 off answers are wrong by as much or more; the bound tells."""
    model = hinges(27, seed=5)
    plan = certified(in_parts(model))
    disassemble = Joins.disassemble

    def spoilt(self: Joins, step: Disassemble) -> None:
        disassemble(self, step)
        if step.joint == 4:
            name = step.updates[-1].target
            self.memory[name] = self.memory[name] * (1 + 1e-7)

    for release in (disassemble, spoilt):
        monkeypatch.setattr(Joins, "disassemble", release)
        lines_of.cache_clear()
        for state in random_states(model, 3, seed=3).each:
            qdd, error, answer = _squares(plan, state)
            true = exact_forward_dynamics(model, *state, digits=25).value
            off = _norm(plan, state, qdd - true) / _norm(plan, state, true)
            assert off <= np.sqrt(error / answer)
            if release is spoilt:
                assert off > 1e-10 and np.sqrt(error / answer) < 100 * off
    lines_of.cache_clear()
