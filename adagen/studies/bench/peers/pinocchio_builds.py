"""Programs that call Pinocchio, built by every compiler, and what they read of a robot."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from importlib import metadata
from itertools import product
from pathlib import Path

import numpy as np

from adagen.errors import EnvironmentFault
from adagen.model import Model
from adagen.states import States
from adagen.studies.bench.contest import Contestant
from adagen.studies.bench.machine import package
from adagen.studies.bench.program import (
    NATIVE,
    PORTABLE,
    Coordinates,
    Peer,
    build,
    compilers,
    source,
)

FLAGS = {"native": NATIVE, "portable": PORTABLE}


def in_every_build(
    name: str,
    model: Model,
    states: States,
    files: tuple[Path, Path],
    ways: Mapping[str, tuple[str, ...]],
) -> list[Contestant]:
    """Return a program as contestants, one for each of its builds and ways to call it.

    Args:
        name: of the program.
        model: the robot.
        states: what it is timed on.
        files: what it reads of the robot, and where these states are to be written.
        ways: the last words of its command line, by what the contestant is called.
    """
    file, given = files
    coordinates(model, states).write(given)
    return [
        Peer(executable, (str(file),), words).contestant(
            f"pinocchio {way}, {compiler}, {flags}",
            f"{compiler} {' '.join(FLAGS[flags])}",
            given,
            partial(coordinates, model),
        )
        for (compiler, flags), executable in builds(name).items()
        for way, words in ways.items()
    ]


def builds(name: str) -> dict[tuple[str, str], Path]:
    """Return a program's executables by compiler and flags; each takes a minute, once."""
    folder = headers()
    text = f"// pinocchio {package('pin')}\n{source(f'{name}.cpp')}"
    kinds = list(product(compilers(), FLAGS))

    def made(kind: tuple[str, str]) -> Path:
        compiler, flags = kind
        folders = (folder, folder / "eigen3")
        return build(text, f"bench_{name}", compiler, FLAGS[flags], folders)

    with ThreadPoolExecutor(2) as pool:
        return dict(zip(kinds, pool.map(made, kinds), strict=True))


def headers() -> Path:
    """Return the folder that holds pinocchio's, Eigen's and Boost's headers."""
    for name in ("libpinocchio", "pin"):
        try:
            wheel = metadata.distribution(name)
        except metadata.PackageNotFoundError:
            continue
        folder = Path(str(wheel.locate_file("cmeel.prefix/include")))
        if (folder / "pinocchio" / "algorithm" / "aba.hpp").is_file():
            return folder
    raise EnvironmentFault("pinocchio is installed without its headers: pip install 'pin>=3'")


def coordinates(model: Model, states: States) -> Coordinates:
    """Return states as pinocchio has them: like adagen's, but for a planar joint's angle."""
    columns = []
    for j, joint in enumerate(model.joints):
        own = states.q[:, model.q_start[j] : model.q_start[j] + joint.kind.nq]
        if joint.kind.name == "planar":
            own = np.column_stack((own[:, :2], np.cos(own[:, 2]), np.sin(own[:, 2])))
        columns.append(own)
    return Coordinates(np.hstack(columns), states.v, states.tau)


def described(model: Model) -> str:
    """Return the robot as programs read it, every number to the last bit."""
    lines = [_numbers(model.gravity)]
    for joint, link in zip(model.joints, model.links[1:], strict=True):
        inertia = link.inertia
        numbers = (joint.rotation, joint.translation, [inertia.mass], inertia.com, inertia.tensor)
        words = " ".join(_numbers(x) for x in numbers)
        lines.append(f"{joint.kind.name} {joint.parent} {words}")
    return "\n".join([*lines, ""])


def _numbers(values: object) -> str:
    return " ".join(repr(float(x)) for x in np.asarray(values, dtype=np.float64).ravel())
