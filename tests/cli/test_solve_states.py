"""Solving for states through the command line."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from adagen.cli import main
from adagen.reference import forward_dynamics
from adagen.states import random_states, read_result, write_states
from adagen.urdf import read_robot
from tests.cli.robots import Said


class TestSolve:
    @pytest.mark.parametrize("processes", ["2", "3", "auto"])
    def test_states_of_a_batch_are_shared_by_the_processes(
        self, processes: str, arm: Path, tmp_path: Path
    ) -> None:
        model = read_robot(arm).model
        states = random_states(model, 40)
        write_states(states, model, tmp_path / "states.json")
        words = ["solve", str(arm), "--procs", processes, "--batch"]
        words += ["--states", str(tmp_path / "states.json")]
        assert main([*words, "--result", str(tmp_path / "r.json")]) == 0
        found = read_result(tmp_path / "r.json", model)
        for (q, v, tau), qdd in zip(states.each, found, strict=True):
            np.testing.assert_allclose(qdd, forward_dynamics(model, q, v, tau), rtol=1e-10)

    @pytest.mark.parametrize("processes", [1, 2])
    def test_right_accelerations_and_a_second_call_without_a_compiler(
        self, processes: int, arm: Path, tmp_path: Path, said: Said, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        model = read_robot(arm, gravity=[0.0, 1.0, -3.0]).model
        states = random_states(model, 4)
        write_states(states, model, tmp_path / "states.json")
        words = ["solve", str(arm), "--procs", str(processes)]
        words += ["--states", str(tmp_path / "states.json"), "-v"]
        assert main([*words, "--result", str(tmp_path / "r.json")]) == 0
        assert "build " in said()[1]
        found = read_result(tmp_path / "r.json", model)
        for (q, v, tau), qdd in zip(states.each, found, strict=True):
            np.testing.assert_allclose(qdd, forward_dynamics(model, q, v, tau), rtol=1e-10)

        def no_compiler(*_: object) -> None:
            raise AssertionError("it was compiled again")

        monkeypatch.setattr("adagen.build.cache._compile", no_compiler)
        assert main(words) == 0
        assert said()[0] == (tmp_path / "r.json").read_text()

    def test_states_of_another_robot_are_refused_before_anything_is_built(
        self, arm: Path, tmp_path: Path, said: Said, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
        states = tmp_path / "states.json"
        states.write_text('{"joints": {"j9": {"q": [0], "v": [0], "tau": [0]}}}')
        assert main(["solve", str(arm), "--procs", "1", "--states", str(states)]) == 1
        stdout, stderr = said()
        assert stdout == ""
        assert stderr.startswith(f"{states}") and "j9" in stderr
        assert not (tmp_path / "cache").exists()

    def test_a_compiler_that_fails_is_status_3(
        self, arm: Path, tmp_path: Path, said: Said, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setenv("CXXFLAGS", "-no-such-option")
        model = read_robot(arm).model
        write_states(random_states(model, 1), model, tmp_path / "states.json")
        words = ["solve", str(arm), "--procs", "1", "--states", str(tmp_path / "states.json")]
        assert main(words) == 3
        assert "no-such-option" in said()[1]

    def test_a_run_over_its_time_is_status_3(self, arm: Path, tmp_path: Path, said: Said) -> None:
        model = read_robot(arm).model
        write_states(random_states(model, 1), model, tmp_path / "states.json")
        words = ["solve", str(arm), "--procs", "2", "--states", str(tmp_path / "states.json")]
        assert main([*words, "--timeout", "0.001"]) == 3
        assert "no answer within 0.001 s" in said()[1]
