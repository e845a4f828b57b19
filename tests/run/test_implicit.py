"""Damping and springs in simulations: where explicit steps end, and implicit ones do not."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.model import REVOLUTE, Model, Passive
from adagen.reference import joint_space_inertia, kinetic_energy
from adagen.states import States
from tests.emitted import Builder, plan_of
from tests.models import Part, assemble, rod, serial_chain, vector
from tests.motions import Motion, Stage, fitted_order, stage, still_torques


def with_passive(model: Model, passive: dict[str, Passive]) -> Model:
    joints = [replace(j, passive=passive.get(j.name, j.passive)) for j in model.joints]
    return replace(model, joints=tuple(joints))


TURNED = np.pi * np.sin(1.7 * np.arange(1, 4))


def light_tip(name: str, passive: Passive) -> Model:
    """Three rods of 1 m in a plane, without gravity, the last one of 1e-4 kg and with effects."""
    step = vector(1.0, 0.0, 0.0)
    parts = [
        Part(f"j{k}", f"j{k - 1}" if k else None, REVOLUTE, rod(mass, step, 0.05), step * (k > 0))
        for k, mass in enumerate((1.0, 1.0, 1e-4))
    ]
    return with_passive(assemble(name, parts), {"j2": passive}).with_gravity(np.zeros(3))


class TestCase8:
    """A light tip that is damped: explicit steps end at 2/lambda."""

    @pytest.fixture
    def damped(self, builder: Builder, tmp_path: Path) -> Stage:
        return stage(light_tip("damped", Passive(damping=1.0)), builder, tmp_path)

    def growth(self, damped: Stage, step: float, count: int, integrator: str) -> float:
        start = States(TURNED[None], np.array([[0.1, -0.1, 0.1]]), np.zeros((1, 3)))
        motion = damped.play(start, step * count, step, "--integrator", integrator)
        first, last = (kinetic_energy(damped.model, motion.q[k], motion.v[k]) for k in (0, -1))
        return last / first

    def limit(self, damped: Stage) -> float:
        inertia = joint_space_inertia(damped.model, TURNED)
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


class TestFriction:
    """A light tip under friction of 1 N m: explicit steps of 50 ms throw it back and forth."""

    @pytest.fixture
    def rubbed(self, builder: Builder, tmp_path: Path) -> Stage:
        passive = Passive(friction=1.0, friction_speed=1e-3)
        return stage(light_tip("rubbed", passive), builder, tmp_path)

    def play(self, rubbed: Stage, *words: str) -> Motion:
        start = States(TURNED[None], np.array([[0.1, -0.1, 20.0]]), np.zeros((1, 3)))
        return rubbed.play(start, 2.0, 5e-2, "--integrator", *words)

    def test_the_tip_stops_at_large_steps(self, rubbed: Stage) -> None:
        motion = self.play(rubbed, "implicit")
        assert np.abs(motion.v[1:, 2]).max() < 1e-4  # at once, where a kick is 1e3
        assert np.abs(motion.v[5:, 2]).max() < 1e-8
        energy = [
            kinetic_energy(rubbed.model, q, v) for q, v in zip(motion.q, motion.v, strict=True)
        ]
        assert max(energy) < 1.01 * energy[0]
        assert motion.told["evaluations"] == 3 * motion.told["steps"]

    def test_explicit_friction_does_not_stop_it(self, rubbed: Stage) -> None:
        assert np.abs(self.play(rubbed, "semi-implicit").v[1:, 2]).min() > 1.0

    def test_several_processes_and_float_agree(self, rubbed: Stage, builder: Builder) -> None:
        truth = self.play(rubbed, "implicit")
        plan = plan_of(rubbed.model, 2, scalar="float")
        other = self.play(replace(rubbed, solver=builder.solver(plan)), "implicit")
        np.testing.assert_allclose(other.q, truth.q, atol=1e-3)

    def test_it_follows_the_true_motion_with_order_1(
        self, builder: Builder, tmp_path: Path
    ) -> None:
        passive = {
            "j000": Passive(damping=0.2, friction=0.3, friction_speed=0.5),
            "j001": Passive(friction=0.1, friction_speed=1.0),
            "j002": Passive(stiffness=2.0, damping=0.05, friction=0.02, friction_speed=0.1),
        }
        chain = stage(with_passive(serial_chain(3), passive), builder, tmp_path)
        assert 0.7 < order_of(chain) < 1.4


def order_of(chain: Stage) -> float:
    """The fitted order of "implicit" against a fine reference of order 4."""
    state = still_torques(chain.model)
    truth = chain.play(state, 0.5, 1 / 2048).q[-1]
    steps, errors = [1 / 128, 1 / 256, 1 / 512], []
    for step in steps:
        end = chain.play(state, 0.5, step, "--integrator", "implicit").q[-1]
        errors.append(float(np.abs(end - truth).max()))
    return fitted_order(steps, errors)


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
        assert 0.7 < order_of(chain) < 1.4
