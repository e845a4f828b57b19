"""A peer's program: compiled from C++ once, run on a file of states any number of times."""

from __future__ import annotations

import json
import re
import subprocess
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.build import Toolchain, build_executable
from adagen.build.toolchain import STANDARD
from adagen.errors import EnvironmentFault, printable
from adagen.run import fresh_copy
from adagen.states import States
from adagen.studies.bench.contest import Contestant, Turn
from adagen.studies.bench.machine import COMPILERS, compiler_version

Array = NDArray[np.float64]
SOURCES = Path(__file__).parent / "programs"
NATIVE = ("-O3", "-march=native", "-DNDEBUG", "-fno-math-errno")
PORTABLE = ("-O3", "-DNDEBUG", "-fno-math-errno")
TIMEOUT = 120.0


def compilers() -> list[str]:
    """Return the compilers that are installed.

    Raises:
        EnvironmentFault: there is none.
    """
    found = list(filter(compiler_version, COMPILERS))
    if not found:
        raise EnvironmentFault(f"no compiler: none of {', '.join(COMPILERS)} is installed")
    return found


@cache
def source(name: str) -> str:
    """Return the text of one of this package's programs, with what each has in common before it."""
    texts = ("measure.hpp", name)
    whole = "".join((SOURCES / text).read_text(encoding="utf-8") for text in texts)
    for header in re.findall(r'^#include "(\w+\.hpp)"\n', whole, re.MULTILINE):
        text = (SOURCES / header).read_text(encoding="utf-8")
        whole = whole.replace(f'#include "{header}"\n', text)
    return whole


def build(
    text: str,
    name: str,
    compiler: str,
    flags: Sequence[str],
    includes: Sequence[Path] = (),
    libraries: Sequence[str] = (),
) -> Path:
    """Return the executable of a program, compiled now or found in the cache.

    Args:
        text: all of its source.
        name: file name of the executable.
        compiler: g++ or clang++.
        flags: options of the compiler.
        includes: folders of headers; the last one is where Eigen's version is looked for.
        libraries: shared libraries with their paths, and options of the linker.

    Raises:
        EnvironmentFault: the compiler failed, or is missing.
    """
    folders = [word for folder in includes for word in ("-isystem", str(folder))]
    linked = ["-Wl,--no-as-needed", *libraries] if libraries else []
    toolchain = Toolchain(
        mpicxx=(compiler,),
        cxx=(compiler,),
        mpiexec=(),
        eigen=includes[-1] if includes else SOURCES,
        flags=(*STANDARD, *flags, *folders, *linked),
        wheel=False,
    )
    return build_executable(text, name, toolchain)


@dataclass(frozen=True)
class Coordinates:
    """States as a peer wants them, each of shape (S, ...)."""

    q: Array
    v: Array
    tau: Array

    def write(self, path: Path) -> None:
        """Write them as the programs read them: sizes, then rows of q, v and tau."""
        sizes = np.array([len(self.q), self.q.shape[1], self.v.shape[1]], dtype=np.float64)
        parts = (sizes, self.q, self.v, self.tau)
        path.write_bytes(
            b"".join(np.ascontiguousarray(x, dtype=np.float64).tobytes() for x in parts)
        )


@dataclass(frozen=True)
class Peer:
    """A built program and the words it is called with, around STATES RESULT REPEAT."""

    executable: Path
    before: tuple[str, ...] = ()
    after: tuple[str, ...] = ()

    def contestant(
        self,
        name: str,
        build: str,
        given: Path,
        theirs: Callable[[States], Coordinates],
        ours: Callable[[States, Array], Array] = lambda _, qdd: qdd,
    ) -> Contestant:
        """Return it as a contestant.

        Args:
            name: of the contestant, whose first word is the peer's.
            build: compiler and options.
            given: the file of states that it is timed on.
            theirs: turns states into the peer's coordinates.
            ours: turns its accelerations back, those of given states.
        """
        return Contestant(
            name=name,
            team=name.split()[0],
            build=build,
            processes=1,
            scalar="double",
            solve=lambda some: ours(some, self.answers(theirs(some))),
            turn=partial(self.turn, given),
        )

    def answers(self, states: Coordinates) -> Array:
        """Return the accelerations that it gives, in its own coordinates, shape (S, nv)."""
        with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
            given = Path(folder, "states")
            states.write(given)
            return self._run(given, Path(folder, "result"), 1)[1].reshape(states.v.shape)

    def turn(self, states: Path, repeat: int) -> dict[str, Turn]:
        """Time each of the states in a file ``repeat`` times."""
        with fresh_copy(self.executable) as copy:
            output, _ = replace(self, executable=copy)._run(
                states, copy.with_name("result"), repeat
            )
        return {"in_place": Turn(float(output["median_ns"]), float(output["min_ns"]))}

    def _run(self, states: Path, result: Path, repeat: int) -> tuple[dict[str, Any], Array]:
        words = [*self.before, str(states), str(result), str(repeat), *self.after]
        name = self.executable.name
        try:
            done = subprocess.run(
                [str(self.executable), *words],
                capture_output=True,
                text=True,
                errors="replace",
                check=False,
                timeout=TIMEOUT,
            )
        except subprocess.TimeoutExpired:
            raise EnvironmentFault(f"{name}: no answer within {TIMEOUT:g} s") from None
        if done.returncode != 0:
            output = printable(" ".join(done.stderr.split()))[:300]
            raise EnvironmentFault(f"{name} failed: {output or f'status {done.returncode}'}")
        report: dict[str, Any] = json.loads(done.stdout)
        return report, np.fromfile(result, dtype=np.float64)
