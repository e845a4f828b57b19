"""A robot read from its description, reduced by its scene."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from adagen.errors import UsageError
from adagen.library.robot_data import robot_data
from adagen.mjcf import is_mjcf, read_mjcf, whole_bytes
from adagen.model import Model
from adagen.scene import Reduction, apply_scene, read_scene
from adagen.scene.types import Scene
from adagen.urdf import Reading, check_reduced, expanded_bytes, read_robot


@dataclass(frozen=True)
class Origin:
    """The file of a robot, and the options of its reading.

    Attributes:
        path: of the URDF, of the file in xacro that it is made of, or of the MJCF.
        floating: whether a floating joint ``__base__`` is put under the root link.
        mimic: whether mimic joints are held in step with the joints that they follow.
        strict: whether slips of the file that change nothing are refused.
        scene: path of a scene file, or None.
        gravity: in ground axes, m/s^2; None: as the scene says, else (0, 0, -9.81).
        arguments: names and values of ``<xacro:arg>``.
        loops: path of a file of frame pairs that close loops, or None.
    """

    path: Path
    floating: bool = False
    mimic: bool = False
    strict: bool = False
    scene: Path | None = None
    gravity: tuple[float, ...] | None = None
    arguments: tuple[tuple[str, str], ...] = ()
    loops: Path | None = None


@dataclass(frozen=True)
class Robot:
    """A robot read from a file.

    Attributes:
        model: joints, links, gravity.
        origin: where it comes from.
        warnings: warnings of the reader, ``file:line: warning: ...``.
        ignored: what the file contains and is not modelled, one line each.
        source_hash: SHA-256 of the description, in hexadecimal.
        reading: all that was read.
        reduction: what the scene left of the robot; None without one.
    """

    model: Model
    origin: Origin
    warnings: tuple[str, ...]
    ignored: tuple[str, ...]
    source_hash: str
    reading: Reading
    reduction: Reduction | None = None

    @property
    def name(self) -> str:
        """The robot's name."""
        return self.model.name

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints, in the order in which they lie in q and v."""
        return tuple(joint.name for joint in self.model.joints)

    @property
    def nq(self) -> int:
        """Numbers in q."""
        return self.model.nq

    @property
    def nv(self) -> int:
        """Numbers in v, and in accelerations."""
        return self.model.nv

    @property
    def data(self) -> dict[str, Any]:
        """What was read, as ``adagen info --json`` prints it: joints, places, masses (kg, m)."""
        return {**robot_data(self.model), "not_modelled": list(self.ignored)}


def read(
    path: str | os.PathLike[str],
    *,
    floating: bool = False,
    mimic: bool = False,
    strict: bool = False,
    scene: str | os.PathLike[str] | None = None,
    gravity: Sequence[float] | None = None,
    arguments: Mapping[str, str] | None = None,
    loops: str | os.PathLike[str] | None = None,
) -> Robot:
    """Read a robot from a URDF, a file in xacro (``.xacro``) or an MJCF (``.xml``, ``.mjcf``).

    Args:
        path: of the file.
        floating: put the robot on a floating base, a joint ``__base__``.
        mimic: make mimic joints follow the joints that they name.
        strict: refuse slips of the file that change nothing, instead of warning about them.
        scene: path of a scene file (docs/reference/scenes.md).
        gravity: acceleration of free fall in ground axes, three numbers, m/s^2; by default what the
            scene says, else (0, 0, -9.81).
        arguments: values of ``<xacro:arg>``.
        loops: path of a file of frame pairs (YAML, docs/how_to/loops.md) that close loops.

    Raises:
        InputError: the description, the scene or the loops are refused; names file and line.
        UsageError: the arguments contradict the scene, or the file has no such arguments.
        EnvironmentFault: the package that the file needs, xacro or mujoco, is not installed.
    """
    origin = Origin(
        Path(path),
        floating,
        mimic,
        strict,
        None if scene is None else Path(scene),
        None if gravity is None else tuple(float(x) for x in gravity),
        tuple((arguments or {}).items()),
        None if loops is None else Path(loops),
    )
    return robot_of(origin)


def robot_of(origin: Origin) -> Robot:
    """Return the robot of an origin, with the exceptions of ``read``."""
    reading, wanted = read_whole(origin)
    model, warnings, reduction = reading.model, list(reading.warnings), None
    if wanted is not None:
        reduction = apply_scene(reading.model, wanted)
        model = reduction.model
        warnings += check_reduced(reading, model)
    known = source_hash(origin)
    return Robot(model, origin, tuple(warnings), reading.ignored, known, reading, reduction)


def read_whole(origin: Origin) -> tuple[Reading, Scene | None]:
    """Return a robot as described, and its scene.

    Raises:
        InputError: the description, the scene or the loops are refused.
        UsageError: what is asked for contradicts the scene.
    """
    path = os.fspath(origin.path)
    read_description = read_mjcf if is_mjcf(path) else read_robot
    scene = None if origin.scene is None else read_scene(os.fspath(origin.scene))
    if scene is None:
        reading = read_description(
            path,
            floating=origin.floating,
            mimic=origin.mimic,
            gravity=origin.gravity,
            check=origin.loops is None,
            strict=origin.strict,
            held=False,
            arguments=dict(origin.arguments),
        )
    else:
        _check_agreement(scene, origin)
        reading = read_description(
            path,
            floating=origin.floating or scene.floating,
            mimic=origin.mimic or bool(scene.mimic),
            gravity=origin.gravity,
            effects=scene.from_urdf,
            decided=scene.decides,
            check=False,
            strict=origin.strict,
            held=scene.base is not None,
            arguments=dict(origin.arguments),
        )
    if origin.loops is not None:
        reading = _with_frame_pairs(reading, origin.loops, check=scene is None)
    return reading, scene


def _with_frame_pairs(reading: Reading, path: Path, *, check: bool) -> Reading:
    """Return the robot with loops closed by the frame pairs of a file."""
    from adagen.scene.pairs import read_pairs, with_pairs

    pairs = read_pairs(path)
    model = with_pairs(reading.model, reading.children, pairs)
    more = check_reduced(reading, model) if check else ()
    return replace(
        reading,
        model=model,
        warnings=(*reading.warnings, *more),
        mentions=(*reading.mentions, *pairs.mentions()),
    )


def _check_agreement(scene: Scene, origin: Origin) -> None:
    if scene.base is not None and origin.floating:
        raise UsageError("the scene sets the base: leave out --floating")
    if scene.mimic is False and origin.mimic:
        raise UsageError("the scene leaves mimic joints free: leave out --mimic")
    gravity = origin.gravity
    if scene.gravity is not None and gravity is not None and gravity != scene.gravity:
        given = ", ".join(f"{x:g}" for x in gravity)
        message = f"another gravity is given beside the scene, [{given}]: keep one"
        raise scene.error(message, "gravity")


def source_hash(origin: Origin) -> str:
    """Return the SHA-256 of a robot description, in hexadecimal.

    It is that of what xacro makes of a file, or of an MJCF with the files that it includes.

    Raises:
        InputError: it cannot be read.
    """
    mjcf = is_mjcf(origin.path)
    content = (
        whole_bytes(origin.path) if mjcf else expanded_bytes(origin.path, dict(origin.arguments))
    )
    return hashlib.sha256(content).hexdigest()
