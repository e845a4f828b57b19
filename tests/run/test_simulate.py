"""--simulate of emitted programs: what the integrators keep, their orders, what is written."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from adagen.model import BASE, FLOATING, PLANAR, REVOLUTE, SPHERICAL, Inertia, Model
from adagen.reference import kinetic_energy, momentum, potential_energy
from adagen.states import States, random_states, write_states
from tests.emitted import Builder
from tests.models import Part, assemble, human_figure, random_inertia, serial_chain, vector
from tests.motions import Stage, fitted_order, stage, still_torques
from tests.slow import slow

Array = NDArray[np.float64]
FOURTH = ("rk4", "rkmk4")
FIRST = ("euler", "semi-implicit", "implicit")


def tumbling_body() -> Model:
    body = Inertia(1.0, np.zeros(3), np.diag([1.0, 2.0, 3.0]))
    model = assemble("tumbler", [Part(BASE, None, FLOATING, body)], floating=True)
    return model.with_gravity(np.zeros(3))


def mixed_kinds() -> Model:
    rng = np.random.default_rng(3)
    kinds = {"floor": PLANAR, "ball": SPHERICAL, "hinge": REVOLUTE}
    parts, above = [], None
    for name, kind in kinds.items():
        parts.append(Part(name, above, kind, random_inertia(rng), vector(0.1, 0.2, 0.3)))
        above = name
    return assemble("mixed", parts)


@pytest.fixture
def tumbler(builder: Builder, tmp_path: Path) -> Stage:
    return stage(tumbling_body(), builder, tmp_path)


@pytest.fixture
def mixed(builder: Builder, tmp_path: Path) -> Stage:
    return stage(mixed_kinds(), builder, tmp_path)


class TestCase9:
    """A tumbling body: I = diag(1, 2, 3), w = (.01, 3, .01), 20 s."""

    def drift(self, tumbler: Stage, step: float, integrator: str) -> float:
        q = np.array([[0.0, 0, 0, 0, 0, 0, 1]])
        v = np.array([[0.0, 0, 0, 0.01, 3.0, 0.01]])
        start = States(q, v, np.zeros((1, 6)))
        motion = tumbler.play(start, 20.0, step, "--integrator", integrator)
        rows = zip(motion.q, motion.v, strict=True)
        spins = np.array([momentum(tumbler.model, *row)[1] for row in rows])
        assert np.linalg.norm(motion.q[-1, 3:]) == pytest.approx(1.0, abs=1e-14)
        return float(np.abs(spins - spins[0]).max() / np.linalg.norm(spins[0]))

    @pytest.mark.parametrize("integrator", FOURTH)
    def test_momentum_drifts_less_than_1e_7_and_with_order_4(
        self, tumbler: Stage, integrator: str
    ) -> None:
        steps = [0.04, 0.02, 0.01]
        drifts = [self.drift(tumbler, step, integrator) for step in steps]
        assert drifts[-1] < 1e-7
        assert fitted_order(steps, drifts) >= 3.7

    @pytest.mark.parametrize("integrator", FIRST)
    def test_methods_of_first_order_drift_much_more(self, tumbler: Stage, integrator: str) -> None:
        assert self.drift(tumbler, 0.01, integrator) > 1e-4


class TestOrders:
    def final(self, mixed: Stage, step: float, integrator: str) -> Array:
        state = still_torques(mixed.model)
        motion = mixed.play(state, 0.5, step, "--integrator", integrator, "--every", "1000000")
        return np.concatenate([motion.q[-1], motion.v[-1]])

    @pytest.mark.parametrize(("integrator", "order"), [*((i, 4) for i in FOURTH),
                                                       *((i, 1) for i in FIRST)])  # fmt: skip
    def test_every_kind_of_joint_is_integrated_with_the_order_of_the_method(
        self, mixed: Stage, integrator: str, order: int
    ) -> None:
        truth = self.final(mixed, 1 / 2048, "rk4")
        steps = [1 / 64, 1 / 128, 1 / 256]
        errors = [float(np.abs(self.final(mixed, s, integrator) - truth).max()) for s in steps]
        assert order - 0.3 < fitted_order(steps, errors) < order + 0.7

    @pytest.mark.parametrize("integrator", FOURTH)
    def test_energy_is_kept(self, mixed: Stage, integrator: str) -> None:
        motion = mixed.play(still_torques(mixed.model), 1.0, 1e-3, "--integrator", integrator)
        energies = [
            kinetic_energy(mixed.model, q, v) + potential_energy(mixed.model, q)
            for q, v in zip(motion.q, motion.v, strict=True)
        ]
        assert np.ptp(energies) < 1e-8 * max(map(abs, energies))


class TestProcesses:
    def test_one_and_two_processes_agree(self, builder: Builder, tmp_path: Path) -> None:
        model = human_figure()
        state = random_states(model, 1, seed=4)
        ends = [
            stage(model, builder, tmp_path, p).play(state, 0.2, 1e-3, "--integrator", "rkmk4")
            for p in (1, 2)
        ]
        np.testing.assert_allclose(ends[0].q, ends[1].q, atol=1e-10)
        np.testing.assert_allclose(ends[0].v, ends[1].v, atol=1e-8)
        assert np.abs(ends[0].v[-1] - ends[0].v[0]).max() > 1e-2

    def test_slaved_joints_stay_in_step(self, builder: Builder, tmp_path: Path) -> None:
        chain = serial_chain(3, axes="xy")
        mimic = ("j001", -2.0, 0.5)
        body = chain.links[3].inertia
        parts = [Part(f"j{k:03d}", f"j{k - 1:03d}" if k else None, REVOLUTE, body,
                      vector(0.2, 0, 0), axis=vector(0, 1, 0), mimic=mimic if k == 2 else None)
                 for k in range(3)]  # fmt: skip
        model = assemble("slaved", parts)
        motion = stage(model, builder, tmp_path).play(random_states(model, 1), 1.0, 1e-2)
        np.testing.assert_allclose(motion.q[:, 2], -2 * motion.q[:, 1] + 0.5, atol=1e-14)
        assert np.ptp(motion.q[:, 2]) > 0.1


class TestTrajectory:
    def test_csv_and_npz_hold_the_same_numbers(self, mixed: Stage) -> None:
        motion = mixed.play(still_torques(mixed.model), 0.05, 1e-3)
        path = mixed.folder / "t.csv"
        words = ("--simulate", "0.05", "--trajectory", path)
        assert mixed.solver.run("--states", mixed.folder / "s.json", *words).status == 0
        with path.open(newline="") as file:
            names, *rows = csv.reader(file)
        assert names[:4] == ["time", "floor.q0", "floor.q1", "floor.q2"]
        assert names[-1] == "hinge.v"
        values = np.array(rows, dtype=float)
        expected = np.column_stack([motion.time, motion.q, motion.v])
        np.testing.assert_array_equal(values, expected)

    def test_every_nth_row_and_the_last_are_kept(self, mixed: Stage) -> None:
        state = still_torques(mixed.model)
        whole = mixed.play(state, 0.0105, 1e-3)
        some = mixed.play(state, 0.0105, 1e-3, "--every", "4")
        assert whole.told["steps"] == 11
        assert whole.told["evaluations"] == 44
        np.testing.assert_allclose(whole.time, [*(k * 1e-3 for k in range(11)), 0.0105])
        np.testing.assert_array_equal(some.q, whole.q[[0, 4, 8, 11]])

    def test_a_name_with_quotes_stays_one_field(self, builder: Builder, tmp_path: Path) -> None:
        body = Inertia(1.0, np.zeros(3), np.eye(3))
        model = assemble("odd", [Part('a "b", ü', None, REVOLUTE, body)])
        odd = stage(model, builder, tmp_path)
        odd.play(random_states(model, 1), 0.01, 1e-3)  # compares the names in the archive
        odd.solver.run("--simulate", "0.01", "--trajectory", tmp_path / "t.csv")
        with (tmp_path / "t.csv").open(newline="", encoding="utf-8") as file:
            assert next(csv.reader(file)) == ["time", 'a "b", ü.q', 'a "b", ü.v']


class TestRefusals:
    @pytest.mark.parametrize(
        ("words", "says"),
        [
            (["--simulate", "0"], "--simulate takes a number of seconds above 0"),
            (["--simulate", "nan"], "--simulate takes a number of seconds above 0"),
            (["--simulate", "1", "--step", "-1"], "--step takes a number of seconds above 0"),
            (["--simulate", "1", "--every", "0.5"], "--every takes a whole number"),
            (["--simulate", "1", "--integrator", "rk5"], "--integrator takes one of euler, semi"),
            (["--simulate", "1", "--trajectory", "t.txt"], "FILE.csv or FILE.npz"),
            (["--simulate", "1", "--check"], "--simulate goes alone"),
            (["--simulate", "1", "--result", "r.json"], "--simulate goes alone"),
            (["--step", "1"], "need --simulate"),
            (["--simulate", "1", "--step", "1e-13"], "more than 1e12 steps"),
            (["--simulate", "1e6", "--trajectory", "/tmp/t.npz"], "too many rows for .npz"),
        ],
    )
    def test_a_wrong_command_line_is_status_2(
        self, words: list[str], says: str, mixed: Stage
    ) -> None:
        done = mixed.solver.run(*words)
        assert (done.status, done.stdout) == (2, "")
        assert says in done.stderr and len(done.stderr.splitlines()) == 1

    def test_a_simulation_starts_at_one_state(self, mixed: Stage) -> None:
        write_states(random_states(mixed.model, 3), mixed.model, mixed.folder / "s.json")
        done = mixed.solver.run("--states", mixed.folder / "s.json", "--simulate", "1")
        assert done.status == 1
        assert done.stderr.endswith("s.json: error: 3 states; a simulation starts at one")

    def test_a_trajectory_that_cannot_be_written_is_status_3(self, mixed: Stage) -> None:
        done = mixed.solver.run("--simulate", "1", "--trajectory", mixed.folder / "no" / "t.csv")
        assert done.status == 3
        assert "cannot write the trajectory" in done.stderr

    @pytest.mark.parametrize("processes", [1, slow(2)])
    def test_a_motion_that_blows_up_names_joint_and_time(
        self, processes: int, builder: Builder, tmp_path: Path
    ) -> None:
        one = stage(serial_chain(6), builder, tmp_path, processes)
        words = ("--simulate", "1e4", "--step", "0.5", "--integrator", "euler")
        done = one.solver.run(*words, "--trajectory", tmp_path / "t.csv")
        assert (done.status, done.stdout) == (1, "")
        assert done.stderr.startswith('error: joint "j00')
        assert "at t = " in done.stderr and done.stderr.endswith("take a smaller --step")
        last = (tmp_path / "t.csv").read_text().splitlines()[-1]
        assert all(np.isfinite(float(x)) for x in last.split(","))
