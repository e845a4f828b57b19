"""Integrators charted: what a simulated second costs, how wrong its end is, what drifts."""

from __future__ import annotations

import json
import math
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from adagen.build import Toolchain
from adagen.errors import EnvironmentFault
from adagen.model import Model
from adagen.reference import kinetic_energy, momentum, potential_energy
from adagen.run import launch
from adagen.states import States, write_states
from adagen.studies.random_states import drawn_states

Array = NDArray[np.float64]
INTEGRATORS = ("euler", "semi-implicit", "implicit", "rk4", "rkmk4")
"""Of emitted programs; `implicit` is `semi-implicit` where nothing is damped or sprung."""

FINER = 16  # the reference's step is this part of the least one
_ROWS = 50  # of a trajectory that drifts are the largest of
_TIMEOUT = 600.0


@dataclass(frozen=True)
class MotionPoint:
    """One integrator with one step.

    Attributes:
        integrator: one of ``INTEGRATORS``.
        step: its length, s.
        wall_s: wall time per simulated second; None where it failed.
        error: relative error of the state at the end, see ``state_error``.
        energy: largest drift of the energy, relative to the largest kinetic energy; None where
            joints damp, spring, carry rotors or are moved, so that it is not kept.
        momentum: largest drift of the angular momentum about the centre of mass, likewise; None
            where the ground holds the robot, so that it is not kept.
        why: the reason where it failed.
    """

    integrator: str
    step: float
    wall_s: float | None = None
    error: float | None = None
    energy: float | None = None
    momentum: float | None = None
    why: str | None = None


@dataclass(frozen=True)
class MotionChart:
    """A robot's integrators as data.

    Attributes:
        model: the robot's name.
        seconds: simulated, without torques.
        reference_step: of the reference by RK4, s.
        reference_error: how far that is from RK4 at half its step.
        points: integrator by integrator, steps falling.
    """

    model: str
    seconds: float
    reference_step: float
    reference_error: float
    points: tuple[MotionPoint, ...]

    def order(self, integrator: str, what: str) -> float | None:
        """Return the fitted order of an error or drift in the step; None where there is none.

        Points at the reference's own error, or below rounding, are left out.
        """
        floor = max(10 * self.reference_error, 1e-13)
        known = [(p.step, getattr(p, what)) for p in self.points if p.integrator == integrator]
        known = [(h, x) for h, x in known if x is not None and math.isfinite(x) and floor < x < 0.1]
        if len(known) < 2:
            return None
        steps, values = np.log(np.array(known)).T
        return float(np.polyfit(steps, values, 1)[0])


@dataclass(frozen=True)
class Played:
    """A trajectory's times (T), q (T, nq) and v (T, nv), and what a simulated second took, s."""

    time: Array
    q: Array
    v: Array
    wall_s: float


@dataclass(frozen=True)
class Player:
    """Simulates a robot by its emitted program.

    Attributes:
        model: the robot.
        executable: its program.
        processes: how many that is for.
        toolchain: whose mpiexec to use.
    """

    model: Model
    executable: Path
    processes: int
    toolchain: Toolchain

    def play(self, start: States, seconds: float, step: float, integrator: str) -> Played:
        """Return a motion.

        Raises:
            EnvironmentFault: the program failed; the message is its own.
        """
        with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
            given, path = Path(folder, "state.json"), Path(folder, "motion.npz")
            write_states(start, self.model, given)
            every = max(1, round(seconds / step) // _ROWS)
            words = ["--states", str(given), "--simulate", repr(seconds), "--step", repr(step)]
            words += ["--integrator", integrator, "--trajectory", str(path), "--json"]
            words += ["--every", str(every)]
            done = launch(self.executable, self.processes, words, self.toolchain, _TIMEOUT)
            if done.status != 0:
                raise EnvironmentFault(done.stderr.rpartition("error: ")[2])
            wall = float(json.loads(done.stdout)["simulation"]["wall_s"]) / seconds
            with np.load(path) as found:
                return Played(found["time"], found["q"], found["v"], wall)


def state_error(model: Model, one: Played, other: Played) -> float:
    """Return how far the ends of two motions are apart, relative to the second.

    The norm of the differences of all coordinates and velocities over the norm of the second's;
    of quaternions, which are known but for their sign, the nearer one counts.
    """
    q, reference = one.q[-1].copy(), other.q[-1]
    for joint, start in zip(model.joints, model.q_start, strict=True):
        if joint.kind.quaternion is None:
            continue
        own = slice(start + joint.kind.quaternion, start + joint.kind.nq)
        if q[own] @ reference[own] < 0:
            q[own] *= -1
    difference = np.concatenate([q - reference, one.v[-1] - other.v[-1]])
    size = np.linalg.norm(np.concatenate([reference, other.v[-1]]))
    return float(np.linalg.norm(difference) / size)


def drifts(model: Model, motion: Played) -> tuple[float | None, float | None]:
    """Return the largest relative drift of energy and of angular momentum along a motion.

    None for what is not kept: energy by damping, friction and prescribed motion, momentum by a base
    or a loop that the ground holds.
    """
    rows = list(zip(motion.q, motion.v, strict=True))
    energy = None
    if not any(j.passive.damping or j.passive.friction or j.prescribed for j in model.joints):
        kinetic = np.array([kinetic_energy(model, q, v) for q, v in rows])
        total = kinetic + np.array([potential_energy(model, q) for q, _ in rows])
        energy = float(np.abs(total - total[0]).max() / kinetic.max())
    held = any(link == 0 for loop in model.loops for link, _ in loop.ends)
    if held or not model.floating:
        return energy, None
    spin = np.array([momentum(model, q, v)[1] for q, v in rows])
    return energy, float(np.abs(spin - spin[0]).max() / np.linalg.norm(spin[0]))


def motion_chart(
    player: Player,
    seconds: float,
    steps: Sequence[float],
    on_progress: Callable[[str], None] = lambda _: None,
) -> MotionChart:
    """Return the chart of all integrators over all steps, from a random state without torques.

    Raises:
        EnvironmentFault: not even the reference could be simulated.
    """
    model = player.model
    state = drawn_states(model, 1, seed=1)
    start = States(state.q, state.v, np.zeros_like(state.tau))
    finest = min(steps) / FINER
    on_progress("reference: rk4 at a sixteenth of the least step, and at a thirty-second")
    truth = player.play(start, seconds, finest, "rk4")
    doubt = state_error(model, truth, player.play(start, seconds, finest / 2, "rk4"))
    points: list[MotionPoint] = []
    stiff = any(j.passive.damping or j.passive.stiffness for j in model.joints)
    integrators = [name for name in INTEGRATORS if name != "implicit" or stiff]
    for integrator in integrators:
        for step in sorted(steps, reverse=True):
            part, parts = len(points) + 1, len(integrators) * len(steps)
            on_progress(f"simulating {part} of {parts}: {integrator}, step {step:g} s")
            try:
                motion = player.play(start, seconds, step, integrator)
            except EnvironmentFault as failure:
                points.append(MotionPoint(integrator, step, why=str(failure)))
                continue
            error = state_error(model, motion, truth)
            points.append(
                MotionPoint(integrator, step, motion.wall_s, error, *drifts(model, motion))
            )
    return MotionChart(model.name, seconds, finest, doubt, tuple(points))
