"""Calls of solvers from several threads of Python, and solvers that share states among some."""

from __future__ import annotations

import copy
import pickle
import sys
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import adagen
from tests.emitted import cores
from tests.library.solvers import ARM, build, states


class TestThreads:
    def test_others_run_while_many_states_are_solved(self, arm: adagen.Solver) -> None:
        q, v, tau, _ = states(arm, 1)
        many = [np.repeat(part, 400_000, axis=0) for part in (q, v, tau)]
        done = threading.Event()

        def solve() -> None:
            arm(*many)
            done.set()

        thread = threading.Thread(target=solve)
        thread.start()
        turns = 0
        while not done.is_set():
            turns += 1
            done.wait(0.001)
        thread.join()
        assert turns > 10  # the interpreter was free meanwhile

    @pytest.mark.parametrize("below", [1000, 0])
    def test_short_calls_release_the_lock_where_they_are_told_to(
        self, below: int, arm: adagen.Solver
    ) -> None:
        solver = pickle.loads(pickle.dumps(self._keeping(arm, below)))
        assert solver.keeps_lock_below == copy.copy(solver).keeps_lock_below == below
        q, v, tau, _ = states(arm, 1)
        ran, gate, before = [], threading.Lock(), sys.getswitchinterval()
        other = threading.Thread(target=lambda: ran.append(gate.acquire()))
        gate.acquire()
        other.start()
        sys.setswitchinterval(100)  # s: nobody else runs unless the lock is released
        try:
            gate.release()
            for _ in range(500_000 if below == 0 else 2000):
                solver(q[0], v[0], tau[0])
                if ran:
                    break
            assert bool(ran) == (below == 0)
        finally:
            sys.setswitchinterval(before)
            other.join()

    @staticmethod
    def _keeping(arm: adagen.Solver, below: int) -> adagen.Solver:
        solver = copy.deepcopy(arm)
        assert solver.keeps_lock_below == 1000
        solver.keeps_lock_below = below
        return solver

    def test_threads_take_turns_with_one_solver(self, arm: adagen.Solver) -> None:
        q, v, tau, _ = states(arm, 300)
        expected = arm(q, v, tau)
        found = [np.empty_like(expected) for _ in range(4)]

        def solve(out: Any) -> None:
            for _ in range(20):
                arm(q, v, tau, out)
                for s in range(50):
                    arm(q[s], v[s], tau[s], out[s])

        threads = [threading.Thread(target=solve, args=(out,)) for out in found]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert all(np.array_equal(out, expected) for out in found)

    @pytest.mark.parametrize("asked", [{}, {"batch": True}, {"scalar": "float"}])
    def test_any_number_of_threads_gives_the_same_bits(self, asked: dict[str, Any]) -> None:
        solver = build(ARM, runtime="gravity", **asked)
        solver.gravity = (0, 0, -1.62)
        q, v, tau = (np.tile(part, (450, 1)) for part in states(solver, 7)[:3])
        alone = solver(q, v, tau, threads=1)
        assert np.array_equal(alone[:7], solver(q[:7], v[:7], tau[:7]))
        for threads in (2, 3, 7, None):
            out = np.zeros_like(alone)
            assert solver(q, v, tau, out, threads=threads) is out
            assert np.array_equal(out, alone)
        solver.gravity = (0, 0, 9.81)
        upwards = solver(q, v, tau, threads=3)
        assert not np.array_equal(upwards, alone)
        assert np.array_equal(upwards, solver(q, v, tau, threads=1))
        for spoilt in (3000, 70, 2999):
            tau[spoilt, 1] = np.nan
        found = []
        for threads in (1, 3):
            with pytest.raises(adagen.SolveError, match=r"^state 70: joint") as failed:
                solver(q, v, tau, threads=threads)
            found.append(failed.value)
        assert [error.count for error in found] == [3, 3]
        assert np.array_equal(found[0].out, found[1].out, equal_nan=True)
        assert np.isnan(found[1].out[[70, 2999, 3000]]).all()

    def test_threads_are_taken_for_many_states_alone(self, arm: adagen.Solver) -> None:
        def running() -> int:
            return len(list(Path("/proc/self/task").iterdir()))

        def most(count: int, **threads: Any) -> int:
            many = [np.repeat(part, count, axis=0) for part in states(arm, 1)[:3]]
            done = threading.Event()

            def solve() -> None:
                arm(*many, **threads)
                done.set()

            before, seen = running(), 0
            caller = threading.Thread(target=solve)
            caller.start()
            while not done.is_set():
                seen = max(seen, running() - before)
            caller.join()
            return seen

        assert most(400_000, threads=1) == 1  # the caller's own
        assert most(400_000, threads=4) == 4
        assert most(400_000) == min(cores(), 400_000 * arm.nv // 50_000)
        assert most(10_000) <= 1

    def test_a_number_of_threads_that_cannot_be_had_is_told(self, arm: adagen.Solver) -> None:
        q, v, tau, _ = states(arm, 1)
        for threads in (0, -3, 1025):
            with pytest.raises(ValueError, match=f"threads is from 1 to 1024, not {threads}"):
                arm(q, v, tau, threads=threads)
        with pytest.raises(TypeError):
            arm(q, v, tau, threads="two")  # type: ignore[arg-type]
        assert np.array_equal(arm(q[0], v[0], tau[0], threads=5), arm(q, v, tau)[0])
        team = build(ARM, procs=2, channel="threads", form="ada", shape="joints")
        with pytest.raises(ValueError, match="threads of this solver share each state"):
            team(q, v, tau, threads=2)
        assert team(q, v, tau, threads=1).shape == (1, arm.nv)
