"""Damping and springs in simulations: where explicit steps end, and implicit ones do not."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.model import REVOLUTE, Model, Passive
from adagen.reference import joint_space_inertia, kinetic_energy
from adagen.states import States
from tests.emitted import Builder
from tests.models import Part, assemble, rod, serial_chain, vector
from tests.motions import Stage, fitted_order, stage, still_torques


def with_passive(model: Model, passive: dict[str, Passive]) -> Model:
    joints = [replace(j, passive=passive.get(j.name, j.passive)) for j in model.joints]
    return replace(model, joints=tuple(joints))


class TestCase8:
    """Three rods in a plane, the last one of 1e-4 kg and damped: explicit steps end at 2/lambda."""

    @pytest.fixture
    def damped(self, builder: Builder, tmp_path: Path) -> Stage:
        step = vector(1.0, 0.0, 0.0)
        parts = [
            Part(
                f"j{k}", f"j{k - 1}" if k else None, REVOLUTE, rod(mass, step, 0.05), step * (k > 0)
            )
            for k, mass in enumerate((1.0, 1.0, 1e-4))
        ]
        model = with_passive(assemble("damped", parts), {"j2": Passive(damping=1.0)})
        return stage(model.with_gravity(np.zeros(3)), builder, tmp_path)

    def growth(self, damped: Stage, step: float, count: int, integrator: str) -> float:
        q, v = np.pi * np.sin(1.7 * np.arange(1, 4)), np.array([0.1, -0.1, 0.1])
        start = States(q[None], v[None], np.zeros((1, 3)))
        motion = damped.play(start, step * count, step, "--integrator", integrator)
        first, last = (kinetic_energy(damped.model, motion.q[k], motion.v[k]) for k in (0, -1))
        return last / first

    def limit(self, damped: Stage) -> float:
        inertia = joint_space_inertia(damped.model, np.pi * np.sin(1.7 * np.arange(1, 4)))
        rates = np.linalg.eigvals(np.linalg.solve(inertia, np.diag([0.0, 0.0, 1.0])))
        return 2.0 / float(rates.real.max())

    @pytest.mark.parametrize("integrator", ["euler", "semi-implicit"])
    def test_explicit_damping_ends_where_theory_says(self, damped: Stage, integrator: str) -> None:
        limit = self.limit(damped)
        assert 6e-5 < limit < 7e-5
        assert self.growth(damped, 0.9 * limit, 400, integrator) < 1.01
        assert self.growth(damped, 1.1 * limit, 100, integrator) > 1e6

    def test_implicit_damping_has_no_such_limit(self, damped: Stage) -> None:
        assert self.growth(damped, 5e-2, 40, "implicit") < 1.01


class TestImplicit:
    def test_a_stiff_spring_settles_at_large_steps(self, builder: Builder, tmp_path: Path) -> None:
        rest = {"j001": Passive(stiffness=1e6, damping=10.0, rest=0.3)}  # explicit: up to 1e-4 s
        chain = stage(with_passive(serial_chain(3), rest), builder, tmp_path)
        state = still_torques(chain.model)
        state.q[0, 1] = 0.31
        motion = chain.play(state, 2.0, 1e-2, "--integrator", "implicit")
        assert abs(motion.q[-1, 1] - 0.3) < 1e-4
        assert motion.told["evaluations"] == 3 * motion.told["steps"]

    def test_it_follows_the_true_motion_with_order_1(
        self, builder: Builder, tmp_path: Path
    ) -> None:
        passive = {"j000": Passive(damping=0.2), "j002": Passive(stiffness=2.0, damping=0.05)}
        chain = stage(with_passive(serial_chain(3), passive), builder, tmp_path)
        state = still_torques(chain.model)
        truth = chain.play(state, 0.5, 1 / 2048).q[-1]
        steps, errors = [1 / 128, 1 / 256, 1 / 512], []
        for step in steps:
            end = chain.play(state, 0.5, step, "--integrator", "implicit").q[-1]
            errors.append(float(np.abs(end - truth).max()))
        assert 0.7 < fitted_order(steps, errors) < 1.4
