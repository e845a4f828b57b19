"""A built solver, called from Python on numpy arrays."""

from __future__ import annotations

import difflib
import sysconfig
from collections.abc import Mapping
from copy import copy
from dataclasses import replace
from functools import cache
from importlib.machinery import ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from adagen.build import Toolchain, build_executable, find_toolchain
from adagen.emit.templates import verbatim
from adagen.errors import EnvironmentFault, JointError, UsageError, printable
from adagen.library.compiled import Compiled
from adagen.library.open_by import open_by

Part = Literal["q", "v", "tau"]

_EXTENSION = ("objects", "arrays", "states", "call", "module")
"""Parts of the extension behind a solver's source (templates/python), in order."""


class Solver:
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
        own = np.array(parameter.rotation) @ numbers if parameter.rotation else numbers
        self._set(first, own)
        self._parameters[first : first + len(own)] = own

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints, in the order in which they lie in q and v."""
        return tuple(joint.name for joint in self.compiled.model.joints)

    @property
    def nq(self) -> int:
        """Numbers in q."""
        return self.compiled.model.nq

    @property
    def nv(self) -> int:
        """Numbers in v, and in accelerations."""
        return self.compiled.model.nv

    @property
    def nqdd(self) -> int:
        """Numbers in an answer: accelerations, outputs of a scene, then forces of loops."""
        return self.compiled.plan.nqdd

    @property
    def ntau(self) -> int:
        """Numbers in tau: behind those of the joints, six of each outer force of a scene."""
        return self.compiled.model.ntau

    def force(self, name: str) -> int | slice:
        """Return the index of a loop's or coupling's force in the answer.

        The robot was compiled with ``loop_forces=True``. A loop's is [force; moment] on its link 2
        at frame 2, in the axes of frame 2, N and N m; a coupling's the effort along a coordinate of
        factor 1. Where constraints follow from each other, the one of least squares.

        Args:
            name: of the loop or coupling.

        Raises:
            UsageError: there is no such force.
        """
        plan = self.compiled.plan
        if plan.loop_forces:
            for k, loop in enumerate(plan.loops):
                if loop.name == name:
                    return slice(plan.entry_of_loop(k), plan.entry_of_loop(k) + 6)
            for k, coupling in enumerate(plan.couplings):
                if coupling.name == name:
                    return plan.entry_of_coupling(k)
        raise UsageError(
            f'there is no force of "{printable(name)}": compile with loop_forces=True, and name a '
            "loop or coupling"
        )

    @property
    def dtype(self) -> np.dtype[Any]:
        """The number type; arrays of others are converted."""
        return np.dtype(np.float32 if self.compiled.request.scalar == "float" else np.float64)

    def index(self, joint: str, of: Part = "q") -> int | slice:
        """Return the index or slice of a joint in q or another vector.

        Args:
            joint: its name.
            of: "q", "v" or "tau"; "v" also holds for accelerations.

        Raises:
            JointError: there is no such joint.
        """
        start, count = self._place(joint, of)
        return start if count == 1 else slice(start, start + count)

    def pack(self, values: Mapping[str, ArrayLike], of: Part = "q") -> NDArray[Any]:
        """Return a vector with the values of some joints; the others are at rest.

        Args:
            values: name of a joint to its number, or numbers.
            of: "q", "v" or "tau".

        Returns:
            Shape (nq,), (nv,) or (ntau,); zeros, and unit quaternions, for the other joints.

        Raises:
            JointError: there is no such joint.
            ValueError: a joint, which is named, has another number of values.
        """
        model = self.compiled.model
        size = {"q": self.nq, "v": self.nv, "tau": self.ntau}[_part(of)]
        packed = np.zeros(size, self.dtype)
        if of == "q":
            for joint, start in zip(model.joints, model.q_start, strict=True):
                if joint.kind.nq >= 4:  # a quaternion comes last
                    packed[start + joint.kind.nq - 1] = 1
        for name, value in values.items():
            start, count = self._place(name, of)
            given = np.atleast_1d(np.asarray(value, self.dtype))
            if given.shape != (count,):
                raise ValueError(
                    f'joint "{printable(name)}" has {count} number{"s" * (count > 1)} in {of}, '
                    f"not shape {np.shape(value)}"
                )
            packed[start : start + count] = given
        return packed

    def _place(self, name: str, of: Part) -> tuple[int, int]:
        """The first index and the size of a joint in a vector."""
        model = self.compiled.model
        names = self.joints
        if name not in names:
            near = difflib.get_close_matches(name, names, n=1)
            hint = f' (did you mean "{printable(near[0])}"?)' if near else ""
            raise JointError(f'there is no joint "{printable(name)}"{hint}')
        j = names.index(name)
        if _part(of) == "q":
            return model.q_start[j], model.joints[j].kind.nq
        return model.v_start[j], model.joints[j].kind.nv

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Solver):
            return NotImplemented
        return self.compiled == other.compiled and np.array_equal(
            self._parameters, other._parameters
        )

    def __hash__(self) -> int:
        return hash(self.compiled)  # what is set at run time may change

    def __copy__(self) -> Solver:
        return _again(self.compiled, self._parameters, self.keeps_lock_below)

    def __deepcopy__(self, _: object) -> Solver:
        return copy(self)

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self.compiled, self._parameters, self.keeps_lock_below)

    def __repr__(self) -> str:
        return f"<adagen.Solver {self.compiled.stem}: {self.nq} in q, {self.nv} in v>"


def _part(of: str) -> str:
    if of not in ("q", "v", "tau"):
        raise UsageError(f"of is q, v or tau, not {of!r}")
    return of


def built(compiled: Compiled, toolchain: Toolchain | None = None) -> Solver:
    """Return the compiled solver, built now or found in the cache.

    Raises:
        UsageError: it is for several processes.
        EnvironmentFault: the compiler failed, or is missing.
    """
    if compiled.plan.launched > 1:
        raise UsageError(
            f"{compiled.stem} is for {compiled.request.procs} processes, a Python program is one:"
            ' compile with procs=1, or channel="threads"'
        )
    behind = "\n\n".join(verbatim(f"python/{part}.hpp") for part in _EXTENSION)
    source = f"#define ADAGEN_NO_MAIN\n{compiled.source}\n{behind}\n"
    toolchain = _with_python(find_toolchain() if toolchain is None else toolchain)
    name = f"{compiled.stem}.so"
    solver = _type_of(build_executable(source, name, toolchain))()
    solver.compiled = compiled
    solver._parameters = np.array(compiled.plan.parameter_values)
    return solver


def _again(compiled: Compiled, parameters: NDArray[np.float64], keeps_lock_below: int) -> Solver:
    """Return another solver with the same run-time parameters."""
    solver = built(compiled)
    solver.keeps_lock_below = keeps_lock_below
    if len(parameters):
        solver._set(0, parameters)
    solver._parameters = parameters.copy()
    return solver


def _with_python(toolchain: Toolchain) -> Toolchain:
    """Return the toolchain with the options for extensions of this Python."""
    python = Path(sysconfig.get_path("include"))
    if not (python / "Python.h").is_file():
        raise EnvironmentFault(
            f"no Python.h in {python}: install Python's headers (Debian, Ubuntu: apt install "
            "python3-dev)"
        )
    numpy = f'-DADAGEN_BUILT_FOR="{sysconfig.get_config_var("SOABI")}-{np.__version__}"'
    folders = ("-isystem", str(python), "-isystem", np.get_include())
    return replace(
        toolchain, flags=(*toolchain.flags, "-shared", "-fPIC", "-pthread", numpy, *folders)
    )


@cache
def _type_of(path: Path) -> type[Solver]:
    """Return the type that an extension and ``Solver`` make together."""
    loader = ExtensionFileLoader("adagen_solver", str(path))
    spec = spec_from_file_location("adagen_solver", path, loader=loader)
    assert spec is not None
    module = module_from_spec(spec)
    loader.exec_module(module)
    return type("Solver", (module.Core, Solver), {"__doc__": Solver.__doc__})
