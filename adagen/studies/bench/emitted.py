"""Emitted solvers as contestants: built once, timed by their own ``--time``."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.build import Toolchain, build_executable
from adagen.errors import AdagenError
from adagen.model import Model
from adagen.run import cores, fresh_copy, launch
from adagen.states import States, read_result, write_states
from adagen.studies.bench.contest import Contestant, Progress, Turn, from_stretches

Array = NDArray[np.float64]
TIMEOUT = 300.0


@dataclass(frozen=True)
class Emitted:
    """An emitted solver's source and what is known of it.

    Attributes:
        name: what tables call it.
        model: the robot.
        file: name of the source file.
        text: of the source file.
        build: its code shape and form.
        processes: how many it is for.
        scalar: number type.
        predicted: nanoseconds that are predicted of an evaluation, None where no profile fits.
    """

    name: str
    model: Model
    file: str
    text: str
    build: str
    processes: int
    scalar: str
    predicted: float | None

    def contestant(self, toolchain: Toolchain, *, stretches: bool = False) -> Contestant:
        """Return it as a contestant, compiled now or found in the cache.

        Args:
            toolchain: what to build and run it with.
            stretches: whether several processes are also timed by their stretches of computing
                where there are cores enough for the clock.

        Raises:
            EnvironmentFault: the compiler failed.
        """
        program = build_executable(self.text, self.file.removesuffix(".cpp"), toolchain)

        def run(words: list[str], program: Path = program) -> str:
            return launch(program, self.processes, words, toolchain, TIMEOUT).printed

        def solve(states: States) -> Array:
            with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
                given, found = Path(folder, "states.json"), Path(folder, "result.json")
                write_states(states, self.model, given)
                run(["--states", str(given), "--result", str(found)])
                return read_result(found, self.model)

        def turn(repeat: int) -> dict[str, Turn]:
            words = ["--time", "--json", "--repeat", str(repeat)]
            with fresh_copy(program) as copy:
                found = _turn(json.loads(run(words, copy))["time"], self.processes)
                if stretches and 1 < self.processes <= cores():
                    output = run([*words, "--stretches"], copy)
                    found |= _turn(json.loads(output)["time"], self.processes)
            return found

        return Contestant(
            name=self.name,
            team="adagen",
            build=f"{self.build}; {' '.join(toolchain.flags)}",
            processes=self.processes,
            scalar=self.scalar,
            solve=solve,
            turn=turn,
            predicted=self.predicted,
        )


def all_built(
    sources: Mapping[str, Emitted],
    toolchain: Toolchain,
    on_progress: Progress,
    *,
    stretches: bool = False,
) -> tuple[dict[str, Contestant], dict[str, str]]:
    """Return solvers as contestants, by name, and why others could not be compiled."""
    done = 0

    def build(emitted: Emitted) -> Contestant | str:
        nonlocal done
        try:
            return emitted.contestant(toolchain, stretches=stretches)
        except AdagenError as error:
            return error.reason
        finally:
            done += 1
            on_progress(f"compiling {done} of {len(sources)}")

    with ThreadPoolExecutor(cores()) as pool:
        found = dict(zip(sources, pool.map(build, sources.values()), strict=True))
    gone = {name: why for name, why in found.items() if isinstance(why, str)}
    return {name: one for name, one in found.items() if isinstance(one, Contestant)}, gone


def _turn(output: Mapping[str, Any], processes: int) -> dict[str, Turn]:
    """Return the times in a program's report; on one process, all is in place at process 0."""
    ways = ("in_place", "through_root") if processes > 1 else ("in_place",)
    played = output["source"] == "stretches"
    return {
        from_stretches(what) if played else what: Turn(
            float(output[what]["median_ns"]), float(output[what]["min_ns"])
        )
        for what in ways
    }
