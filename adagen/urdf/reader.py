"""The entry of the URDF stage: from a path to a model, or to a one-line refusal."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType

import numpy as np

from adagen.errors import UsageError
from adagen.model import BASE, Model
from adagen.urdf.bodies import build, gather
from adagen.urdf.checks import Lines, check_model
from adagen.urdf.description import Description, describe
from adagen.urdf.document import parse
from adagen.urdf.elements import Element
from adagen.urdf.expansion import Arguments, description_text
from adagen.urdf.loops import read_closing, warn_effects, with_closing
from adagen.urdf.mimics import resolve
from adagen.urdf.notes import Notes
from adagen.urdf.numbers import LARGEST
from adagen.urdf.passive import read_effects, warn_dropped, with_effects
from adagen.urdf.remarks import remark_ignored, warn_foreign, warn_held, warn_inertias, warn_limits
from adagen.urdf.source import model_stem
from adagen.urdf.tree import Tree, make_tree
from adagen.urdf.yourdfpy_check import agreed


@dataclass(frozen=True)
class Reading:
    """A robot that was read.

    Attributes:
        model: the robot.
        warnings: one line each, ``file:line: warning: ...``.
        ignored: what the file says that the model does not hold, one line each.
        file: path of the file.
        lines: where the file tells of what.
        mentions: what else the file says that the model holds, one line each.
        children: the child link of each joint of the tree, also of fixed ones, as far as known.
    """

    model: Model
    warnings: tuple[str, ...]
    ignored: tuple[str, ...]
    file: str
    lines: Lines
    mentions: tuple[str, ...] = ()
    children: Mapping[str, str] = field(default_factory=dict)


def read_robot(
    path: str | Path,
    *,
    floating: bool = False,
    mimic: bool = False,
    gravity: Sequence[float] | None = None,
    effects: Collection[str] = (),
    decided: Callable[[str, str], bool] = lambda _effect, _joint: False,
    check: bool = True,
    strict: bool = False,
    held: bool = True,
    arguments: Arguments = MappingProxyType({}),
) -> Reading:
    """Read a URDF; nothing that could change the dynamics is guessed.

    Args:
        path: of the file.
        floating: put a floating joint ``__base__`` between the world and the root link.
        mimic: slave mimic joints to their sources; otherwise they are free, with a warning each.
        gravity: in ground axes, three numbers, m/s^2; (0, 0, -9.81) by default.
        effects: parts of joints' <dynamics> that are modelled: "damping", "friction".
        decided: whether the caller decided on an effect of a joint, by their names; a warning
            says of the others in <dynamics> that they are not modelled.
        check: refuse a robot whose forward dynamics has no answer; if not, the caller checks the
            final model by ``check_reduced``.
        strict: refuse slips that other readers accept (repairs.py), instead of warning.
        held: whether a fixed base was requested; if not, a root link that looks as if it should
            float gets a warning.
        arguments: values of <xacro:arg>, for a file whose name ends in ".xacro" (expansion.py).

    Returns:
        The model, with warnings: fixed joints are lumped, axes normalised, numbers rounded once.

    Raises:
        InputError: the file is not a URDF of a robot whose forward dynamics has an answer.
        UsageError: gravity is not three finite numbers, or there is no such argument.
        EnvironmentFault: the file is written in xacro, which is not installed.
    """
    notes = Notes(os.fspath(path), strict=strict)
    root = parse(description_text(path, arguments, notes), notes)
    description = describe(root, model_stem(path), notes)
    _check_base(description, floating, notes)
    tree = make_tree(description, notes)
    model = _model(root, description, tree, floating, mimic, effects, decided, notes)
    if not (held or floating):
        warn_held(model, notes)
    if gravity is not None:
        model = model.with_gravity(checked_gravity(gravity))
    return _reading(model, description, tree, notes, check=check)


def _model(
    root: Element,
    description: Description,
    tree: Tree,
    floating: bool,
    mimic: bool,
    effects: Collection[str],
    decided: Callable[[str, str], bool],
    notes: Notes,
) -> Model:
    """The model of a description, with warnings about what is not modelled."""
    mimics = resolve(description, mimic, notes)
    closing = read_closing(root, description, tree, mimics, notes)
    warn_limits(root, notes)
    warn_inertias(description, notes)
    remark_ignored(root, notes)
    warn_foreign(root, notes)
    closers = {joint.name for joint in tree.closing}
    warn_dropped(
        root,
        lambda effect, joint: effect in effects or joint in closers or decided(effect, joint),
        notes,
    )
    warn_effects(root, tree, notes)
    passive = read_effects(root, effects, notes)
    description = agreed(root, description, notes)
    model = build(description.name, gather(description, tree, floating), mimics, floating)
    return with_closing(with_effects(model, passive), closing, notes)


def _reading(
    model: Model, description: Description, tree: Tree, notes: Notes, *, check: bool
) -> Reading:
    """A model with all notes about it; refused if ``check`` finds no forward dynamics."""
    lines = Lines(None, {}, {}) if notes.without_lines else _lines(description)
    if check:
        check_model(model, lines, notes)
    return Reading(
        model,
        tuple(notes.warnings),
        tuple(notes.ignored),
        notes.file,
        lines,
        tuple(notes.mentions),
        {joint.name: link for link, joint in tree.above.items()},
    )


def check_reduced(reading: Reading, model: Model) -> tuple[str, ...]:
    """Refuse what was made of a robot that was read, if its forward dynamics has no answer.

    Args:
        reading: the robot.
        model: what was made of it.

    Returns:
        Warnings, one line each.

    Raises:
        InputError: as ``read_robot``.
    """
    notes = Notes(reading.file)
    check_model(model, reading.lines, notes)
    return tuple(notes.warnings)


def _lines(description: Description) -> Lines:
    joints = {joint.name: joint.line for joint in description.joints}
    links = {
        link.name: link.line if link.inertial is None else link.inertial.line
        for link in description.links
    }
    return Lines(description.line, joints, links)


def _check_base(description: Description, floating: bool, notes: Notes) -> None:
    for joint in description.joints:
        if floating and joint.name == BASE:
            raise notes.error(
                f'joint "{BASE}" has the name that --floating gives to the base: rename it',
                joint.line,
            )


def checked_gravity(
    values: Sequence[float],
) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Return a gravity that a user gave as an array, shape (3,), m/s^2.

    Raises:
        UsageError: it is not three finite numbers.
    """
    numbers = [float(value) for value in values]
    if len(numbers) != 3 or not all(math.isfinite(g) and abs(g) <= LARGEST for g in numbers):
        raise UsageError("gravity needs three finite numbers, in m/s^2")
    return np.array(numbers)
