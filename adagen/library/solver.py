"""A robot's generated solver: as text, and built, called from Python on numpy arrays."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any
from warnings import warn

import numpy as np
from numpy.typing import ArrayLike, NDArray

from adagen.atomic_files import write_files
from adagen.build import Toolchain
from adagen.cost import Timeline
from adagen.emit.runtime import FOLDER
from adagen.errors import InputError, UsageError, printable
from adagen.library.assessment import idle_in_words, loss
from adagen.library.command import command_of, refuse_another, with_command
from adagen.library.extension import extension
from adagen.library.inputs import Input, head_lines, with_inputs
from adagen.library.open_by import open_by
from adagen.library.request import Request
from adagen.library.robot import Origin
from adagen.library.vectors import Vectors
from adagen.model import Model
from adagen.plan import Plan
from adagen.plan.still_joints import still_in_words
from adagen.program import Program
from adagen.schedule import Schedule
from adagen.search.objective import Digits, predicted_digits


@dataclass(frozen=True, eq=False)
class Compiled:
    """The generated solver of a robot, as text, with its schedule and prediction.

    Two are equal if the same request has made the same files of the same description: all of what
    they are is in these, in the plan (robot, schedule, steps) and in the source. A pickle is equal
    to its original.

    Attributes:
        model: the robot.
        origin: where it comes from.
        request: the options, with the shape that a given schedule asks for.
        schedule: which process computes what; its makespan is by the price of its search, which for
            one process is that of its steps one by one. ``predicted`` is of what is emitted.
        plan: what each process computes.
        program: what runs, operation by operation.
        timeline: the predicted course of an evaluation, in a batch of those states that a register
            holds; None if the profile leaves it open.
        files: file name to text: source, header, plan, drawing, Makefile, CMakeLists.txt, ...
        inputs: what it was made from beside the robot, such as scene and cost profile.
        unpaid: what is to be said of processes that do not pay; empty where they do.
    """

    model: Model
    origin: Origin
    request: Request
    schedule: Schedule
    plan: Plan
    program: Program
    timeline: Timeline | None
    files: dict[str, str] = field(repr=False)
    inputs: tuple[Input, ...] = field(default=(), repr=False)
    unpaid: str = field(default="", repr=False)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Compiled):
            return NotImplemented
        return self is other or (
            (self.request, self.origin, self.inputs, self.files)
            == (other.request, other.origin, other.inputs, other.files)
        )

    def __hash__(self) -> int:
        return hash((self.request, self.source))

    @property
    def stem(self) -> str:
        """NAME_pP, the name of the files without their endings."""
        return next(name for name in self.files if name.endswith(".cpp")).removesuffix(".cpp")

    @property
    def source(self) -> str:
        """The C++ source."""
        return self.files[f"{self.stem}.cpp"]

    @property
    def header(self) -> str:
        """The C header."""
        return self.files[f"{self.stem}.h"]

    @property
    def predicted(self) -> float | None:
        """Predicted time of an evaluation, of a batch of a state of it, microseconds.

        None if there is no prediction.
        """
        return None if self.timeline is None else self.timeline.state_time

    @property
    def digits(self) -> float | None:
        """Predicted number of right decimal digits; None if a factorisation fails."""
        return None if self._digits is None else -math.log10(self._digits.error)

    @property
    def hard_digits(self) -> float | None:
        """The same in hard poses, where axes are nearly parallel, as far as they are answered.

        None also where that is not tried: with closed loops, and in form ada.
        """
        hard = None if self._digits is None else self._digits.hard
        return None if hard is None else -math.log10(hard)

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """What the command line warns of: few digits, idle processes, joints that cannot move.

        ``build`` issues them. They take some tenths of a second, when first asked for.

        Raises:
            InputError: no digit is predicted to be right: a factorization fails.
        """
        try:
            lost = loss(self.plan, self.model, self.request)
        except InputError as error:
            raise InputError(error.message, str(self.origin.path)) from None
        about = (
            self.unpaid or idle_in_words(self.plan),
            still_in_words(self.model),
            "" if lost is None else str(lost),
        )
        return tuple(text for text in about if text)

    @cached_property
    def _digits(self) -> Digits | None:
        objective, shape = self.request.objective, self.program.shape
        try:
            return predicted_digits(objective, self.model, self.plan, shape)
        except FloatingPointError:
            return None

    def in_folder(self, folder: str | os.PathLike[str]) -> dict[str, str]:
        """Return the files as they are written into a folder.

        The head of the source has the command that makes them, with paths relative to the folder,
        and the hashes of scene and profile; the plan has their texts, too.
        """
        command = command_of(self.origin, self.request, Path(folder))
        plan = f"{self.stem}.plan.json"
        return {
            **self.files,
            f"{self.stem}.cpp": with_command(self.source, command, head_lines(self.inputs)),
            plan: with_inputs(self.files[plan], command, self.inputs),
        }

    def write(self, folder: str | os.PathLike[str]) -> list[Path]:
        """Write the files, all or none, and return their paths; files that are up to date stay.

        Of the runtime's headers the path of their folder is returned.

        Raises:
            UsageError: an existing file was not written by adagen, or is of another robot.
            EnvironmentFault: writing failed.
        """
        files = self.in_folder(folder)
        source = f"{self.stem}.cpp"
        refuse_another(Path(folder, source), files[source])
        write_files(Path(folder), files)
        names = {FOLDER if name.startswith(f"{FOLDER}/") else name for name in files}
        return [Path(folder, name) for name in sorted(names)]

    def build(self, toolchain: Toolchain | None = None) -> Solver:
        """Return the solver, built now or found in the cache.

        Args:
            toolchain: what to build with; by default what ``adagen env`` prints.

        Warns:
            UserWarning: of each of ``warnings``.

        Raises:
            InputError: the solver is predicted to fail in every state.
            UsageError: the solver is for several MPI processes.
            EnvironmentFault: the compiler failed, or is missing.
        """
        if self.plan.launched > 1:
            raise UsageError(
                f"{self.stem} is for {self.request.procs} processes, a Python program is one:"
                ' compile with procs=1, or channel="threads"'
            )
        for text in self.warnings:
            warn(f"{self.stem}: {text}", stacklevel=2)
        solver = _type_of(extension(self.source, self.stem, toolchain))()
        solver.compiled = self
        solver._parameters = np.array(self.plan.parameter_values)
        return solver


class Solver(Vectors):
    """Forward dynamics of one robot: from positions, velocities and torques to accelerations.

    Called with arrays of one state, ``q`` of shape (nq,), ``v`` (nv,) and ``tau`` (ntau,), it
    returns accelerations of shape (nv,); with arrays of S states, (S, nq), (S, nv) and (S, ntau),
    those of shape (S, nv). SI units; docs/reference/files.md says how joints lie
    in q and v: quaternions x y z w, floating joints [linear; angular] in the body's frame.

    Many states are shared among the machine's cores. Other threads of Python run while many states
    are solved; threads that call one solver take turns, and copies (``copy.copy``) work in
    parallel. Solvers can be pickled. They are found in the cache, or built, where they arrive.
    Two are equal if what they were built from is, and the same is set at run time.

    Attributes:
        compiled: the ``Compiled`` from which it was built.
        keeps_lock_below: calls with fewer accelerations keep the interpreter's lock, 1000 if
            nothing else is set: they are over in microseconds, and getting the lock back from a
            thread that computes in Python takes milliseconds. With 0 each call releases it. Copies
            and pickles have what is set.
    """

    compiled: Compiled
    keeps_lock_below: int
    _parameters: NDArray[np.float64]

    if TYPE_CHECKING:  # the extension has it

        def __call__(
            self,
            q: ArrayLike,
            v: ArrayLike,
            tau: ArrayLike,
            out: NDArray[Any] | None = None,
            *,
            threads: int | None = None,
        ) -> NDArray[Any]:
            """Return the accelerations of one state or of many.

            Args:
                q: positions, shape (nq,) or (S, nq); m, rad, quaternions.
                v: velocities, shape (nv,) or (S, nv); m/s, rad/s.
                tau: forces and torques, shape (ntau,) or (S, ntau); N, N m.
                out: where accelerations go, an array of ``dtype`` in the shape of v, written row
                    behind row; a new one if not given. It is none of the others.
                threads: that share the states, 1 to 1024; None: as many as pay, at most one for
                    each core, and one alone for fewer than some 100,000 accelerations. Answers are
                    the same to the last bit.

            Returns:
                Accelerations, shape (nv,) or (S, nv); m/s^2, rad/s^2. With the outputs of a scene
                and forces of loops behind them, shape (nqdd,) or (S, nqdd); NaN of joints that it
                does not ask for.

            Raises:
                SolveError: a state cannot be solved; it names the joint. Of one state nothing is
                    written, of many those that fail become NaN.
                ValueError: a shape or a number of threads is wrong.
                TypeError: what is given holds no real numbers.
            """

        def _bounds(self) -> NDArray[np.float64] | None:
            """Return the bounds of the last call, shape () or (S,); None where there are none."""

        def _set(self, first: int, numbers: ArrayLike) -> None:
            """Set run-time numbers, from the one numbered first on."""

    def _how_far(self, place: int, opens: int, q: NDArray[Any], v: NDArray[Any]) -> str:
        """Return how far a loop is open, to add to a failure's message.

        Args:
            place: of the loop or coupling, numbered behind all joints.
            opens: whether it is its velocity that opens it.
            q: configuration, shape (nq,).
            v: velocity, shape (nv,).
        """
        model = self.compiled.model
        return open_by(model, place - len(model.joints), q, v, opens=bool(opens))

    @property
    def error_bound(self) -> Any:
        """Bound of the error of the last call's accelerations, a float; of many states (S,).

        Of their energy norm relative to theirs, sqrt(e^T H e / qdd^T H qdd) with the joint-space
        inertia H (docs/explanation/certificates.md). Infinite beyond 1/64, where hardly a digit is
        sure; NaN for states that cannot be solved.

        Raises:
            UsageError: the robot was not compiled with ``certify=True``, or nothing was solved yet.
        """
        found = self._bounds()
        if found is None:
            raise UsageError("there is no bound: compile with certify=True, and solve something")
        return float(found) if found.ndim == 0 else found

    @property
    def gravity(self) -> NDArray[Any]:
        """Acceleration of free fall in ground axes, shape (3,), m/s^2.

        It can be set if the robot was compiled with ``runtime="gravity"``. It then holds for all
        later calls, and for copies and pickles made later.

        Raises:
            UsageError: it is set and is a constant of the code.
            ValueError: it is set to something else than three finite numbers.
        """
        plan = self.compiled.plan
        first = plan.entry_of_parameter("gravity")
        return np.array(plan.gravity if first is None else self._parameters[first : first + 3])

    @gravity.setter
    def gravity(self, value: ArrayLike) -> None:
        given = np.asarray(value, np.float64)
        if given.shape != (3,):
            raise ValueError(f"gravity has shape (3,), not {given.shape}")
        self._put("gravity", given)

    def set_mass(self, link: str, mass: float) -> None:
        """Set the mass of a link with everything fixed to it, for all later calls.

        The robot was compiled with ``runtime="mass:LINK"``. Copies and pickles have what is set.

        Args:
            link: its name in the description.
            mass: kg, more than 0.

        Raises:
            UsageError: it is a constant of the code.
            ValueError: it is no mass.
        """
        if not mass > 0:
            raise ValueError(f"a mass is more than 0 kg, not {mass}")
        self._put("mass", np.array([mass], np.float64), link)

    def set_center(self, link: str, center: ArrayLike) -> None:
        """Set the centre of mass of a link; the rotational inertia about it stays.

        The robot was compiled with ``runtime="center:LINK"``. Copies and pickles have what is set.

        Args:
            link: its name in the description.
            center: of the link with everything fixed to it, in the link's frame, shape (3,), m.

        Raises:
            UsageError: it is a constant of the code.
            ValueError: it is not three finite numbers.
        """
        given = np.asarray(center, np.float64)
        if given.shape != (3,):
            raise ValueError(f"a centre of mass has shape (3,), not {given.shape}")
        self._put("center", given, link)

    def _put(self, what: str, numbers: NDArray[Any], link: str = "") -> None:
        """Set the run-time parameters."""
        plan = self.compiled.plan
        for parameter in plan.parameters:
            if (parameter.what, parameter.name) == (what, link):
                break
        else:
            word = printable(f"{what}:{link}" if link else what)
            raise UsageError(f'{word} is compiled in: compile with runtime="{word}" to set it')
        first = plan.entry_of_parameter(what, parameter.link) or 0
        own = _turned(parameter.rotation, numbers, plan.scalar) if parameter.rotation else numbers
        self._set(first, own)
        self._parameters[first : first + len(own)] = own

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Solver):
            return NotImplemented
        return self.compiled == other.compiled and np.array_equal(
            self._parameters, other._parameters
        )

    def __hash__(self) -> int:
        return hash(self.compiled)  # what is set at run time may change

    def __copy__(self) -> Solver:
        other = type(self)()
        other.compiled = self.compiled
        return _set_as(other, self._parameters, self.keeps_lock_below)

    def __deepcopy__(self, _: object) -> Solver:
        return copy(self)

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self.compiled, self._parameters, self.keeps_lock_below)

    def __repr__(self) -> str:
        return f"<adagen.Solver {self.compiled.stem}: {self.nq} in q, {self.nv} in v>"


def _turned(
    rotation: Sequence[Sequence[float]], numbers: NDArray[Any], scalar: str
) -> NDArray[np.float64]:
    """Return numbers times a rotation, shape (3,), with the roundings of NAME_set_center."""
    number = np.float32 if scalar == "float" else np.float64
    axes, given = np.array(rotation, number), numbers.astype(number)
    found = np.zeros(3, number)
    for k in range(3):  # one operation after the other: no library's order of sums
        found = found + axes[:, k] * given[k]
    return found.astype(np.float64)


def _again(compiled: Compiled, parameters: NDArray[np.float64], keeps_lock_below: int) -> Solver:
    """Return another solver with the same run-time parameters."""
    return _set_as(compiled.build(), parameters, keeps_lock_below)


def _set_as(solver: Solver, parameters: NDArray[np.float64], keeps_lock_below: int) -> Solver:
    """Return a new solver with run-time parameters of another."""
    solver.keeps_lock_below = keeps_lock_below
    if len(parameters):
        solver._set(0, parameters)
    solver._parameters = parameters.copy()
    return solver


@cache
def _type_of(module: ModuleType) -> type[Solver]:
    """Return the type that an extension and ``Solver`` make together."""
    return type("Solver", (module.Core, Solver), {"__doc__": Solver.__doc__})
