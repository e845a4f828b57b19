"""The entry of the MJCF stage: from a path to a Reading, as for a URDF."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from adagen.errors import InputError, UsageError
from adagen.mjcf.bodies import model_of
from adagen.mjcf.compiled import FREE, Compiled, compiled
from adagen.mjcf.passive import passives
from adagen.mjcf.remarks import couplings, refuse_closed, remark
from adagen.model import BASE
from adagen.urdf.checks import check_model
from adagen.urdf.document import check_prolog
from adagen.urdf.notes import Notes, quoted
from adagen.urdf.reader import Reading, checked_gravity
from adagen.urdf.source import model_stem, read_text

_INCLUDED = re.compile(r"<include\s[^>]*?\bfile\s*=\s*[\"']([^\"']+)[\"']")
_ROOT = re.compile(r"<mujoco[\s>/]")


def is_mjcf(path: str | Path) -> bool:
    """Tell whether a file is to be read as MJCF: by its ending, and its root element."""
    if not os.fspath(path).endswith((".xml", ".mjcf")):
        return False
    notes = Notes(os.fspath(path))
    try:
        text = read_text(path, notes)
        return _ROOT.match(text, check_prolog(text, notes)) is not None
    except InputError:  # the reader of URDF says it better
        return False


def whole_bytes(path: Path) -> bytes:
    """Return the bytes of an MJCF and of all that it includes, each file once.

    Raises:
        InputError: the file cannot be read.
    """
    found: dict[Path, bytes] = {}
    waiting = [path]
    while waiting:
        each = waiting.pop()
        if each in found or (each != path and not each.is_file()):
            continue
        try:
            found[each] = each.read_bytes()
        except OSError as error:
            raise InputError(f"cannot read it: {error.strerror}", str(each)) from None
        names = _INCLUDED.findall(found[each].decode("utf-8", errors="replace"))
        waiting += [path.parent / name for name in reversed(names)]  # as MuJoCo looks for them
    return b"".join(found.values())


def read_mjcf(
    path: str | Path,
    *,
    strict: bool = False,  # noqa: ARG001 (MuJoCo's own compiler is strict)
    arguments: Mapping[str, str] = MappingProxyType({}),
    **options: Any,
) -> Reading:
    """Read an MJCF; arguments and options as ``adagen.urdf.read_robot``.

    Bodies without joints are lumped, joints of one body hang on links without mass, and a free
    joint without a name is the base ``__base__``. Gravity is the file's, unless it is given.

    Raises:
        InputError: MuJoCo refuses the file, or it is no open chain whose forward dynamics has an
            answer.
        UsageError: gravity is not three finite numbers, or arguments are given.
        EnvironmentFault: MuJoCo is not installed.
    """
    if arguments:
        raise UsageError("--xacro-arg is for files whose names end in .xacro")
    notes = Notes(os.fspath(path))
    if "<include" in read_text(path, notes):
        notes.without_lines = True  # they may be another file's
    robot = compiled(Path(path), model_stem(path), notes)
    return reading_of(robot, notes, **options)


def reading_of(
    robot: Compiled,
    notes: Notes,
    *,
    floating: bool = False,
    mimic: bool = False,
    gravity: Sequence[float] | None = None,
    effects: Collection[str] = (),
    decided: Callable[[str, str], bool] = lambda _effect, _joint: False,
    check: bool = True,
    held: bool = False,
) -> Reading:
    """Return what is made of a compiled MJCF; arguments as ``read_mjcf``.

    Raises:
        InputError: as ``read_mjcf``.
        UsageError: as ``read_mjcf``.
    """
    if floating:
        robot = _with_base(robot)
    refuse_closed(robot, notes)
    followed = couplings(robot, mimic, notes)
    remark(robot, notes)
    held_passives = passives(robot, effects, decided, notes)
    floated = _floated(robot, notes) if floating and BASE not in robot.joints else None
    model = model_of(robot, floated, followed, held_passives)
    if held and model.floating and not floating:
        raise notes.error("the file leaves the base free, and the scene holds it: lock __base__")
    if gravity is not None:
        model = model.with_gravity(checked_gravity(gravity))
    elif robot.disabled("GRAVITY"):
        model = model.with_gravity(np.zeros(3))
    if check:
        check_model(model, robot.lines, notes)
    lines = replace(robot.lines, joints={}, links={}) if notes.without_lines else robot.lines
    return Reading(model, tuple(notes.warnings), tuple(notes.ignored), notes.file, lines)


def _with_base(robot: Compiled) -> Compiled:
    """Call the one free joint of a file the base, whatever its name."""
    free = [j for j in range(len(robot.joints)) if robot.model.jnt_type[j] == FREE]
    if len(free) != 1 or BASE in robot.joints:
        return robot
    own = robot.joints[free[0]]
    names = tuple(BASE if name == own else name for name in robot.joints)
    lines = {BASE if name == own else name: at for name, at in robot.lines.joints.items()}
    return replace(robot, joints=names, lines=replace(robot.lines, joints=lines))


def _floated(robot: Compiled, notes: Notes) -> int:
    """Return the body that --floating sets free: the one on the world that has joints beyond it.

    Raises:
        InputError: the file says itself how it is held, or there are several.
    """
    children = robot.children()
    roots = [body for body in children[0] if _moves(robot, children, body)] or children[0]
    if len(roots) != 1:
        names = quoted([robot.bodies[body] for body in roots])
        raise notes.error(
            f"--floating sets one body free, and on the world are {names}: "
            "write a <freejoint/> in one"
        )
    joints = robot.joints_of(roots[0])
    if joints:
        raise notes.error(
            f'--floating sets a body free, and "{robot.bodies[roots[0]]}" has joint '
            f'"{robot.joints[joints[0]]}" to the world: leave out --floating'
        )
    return roots[0]


def _moves(robot: Compiled, children: list[list[int]], body: int) -> bool:
    """Whether a body or one that hangs on it has a joint."""
    waiting: list[int] = [body]
    while waiting:
        each = waiting.pop()
        if robot.joints_of(each):
            return True
        waiting += children[each]
    return False
