"""Reads states files and result files."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from adagen.errors import InputError
from adagen.jsonfile import Refusal, as_number, as_object, load_object, nearest
from adagen.model import BASE, OUTPUT_SIZES, Joint, Model
from adagen.states.slaved import follow_sources
from adagen.states.types import FIELDS, Array, States, columns, fields_of, wrench_columns

MEMBERS = ("floating", "gravity", "forces", "joints")
TOLERATED = ("type", "qdd")  # a file of true answers has these beside the fields
WhyMissing = Callable[[str], str | None]
_NORM = 1e-3  # how far a quaternion may be from unit length


@dataclass(frozen=True)
class StatesFile:
    """A states file, read once: it may be a pipe, whose text is there only once.

    Attributes:
        path: the file.
        document: its one JSON object.
    """

    path: str
    document: dict[str, Any]

    @classmethod
    def read(cls, path: Path | str) -> StatesFile:
        """Read a file; - is standard input.

        Raises:
            InputError: the file cannot be read or is not JSON.
        """
        path = str(path)
        with _refused_in(path):
            return cls(path, load_object("/dev/stdin" if path == "-" else path, MEMBERS))

    @property
    def gravity(self) -> Array | None:
        """Its gravity, shape (3,), m/s^2, or None where it says nothing.

        Raises:
            InputError: it is not three numbers.
        """
        with _refused_in(self.path):
            return _gravity(self.document)

    def states(self, model: Model, why_missing: WhyMissing | None = None) -> States:
        """Return its states of a model, as :func:`read_states` does."""
        with _refused_in(self.path):
            _gravity(self.document)
            joints = as_object(self.document.get("joints"), "'joints'")
            _check_floating(self.document.get("floating"), model)
            _check_names(joints, model, why_missing=why_missing)
            count = _count(joints)
            size = {"q": model.nq, "v": model.nv, "tau": model.ntau}
            states = States(*(np.zeros((count, size[name])) for name in FIELDS))
            for j, joint in enumerate(model.joints):
                if joint.name in joints:
                    _read_joint(joints[joint.name], model, j, states)
            _read_forces(self.document.get("forces"), model, states)
            follow_sources(states, model, joints)
        return states


def read_states(path: Path | str, model: Model, why_missing: WhyMissing | None = None) -> States:
    """Read a states file.

    Args:
        path: the file; - is standard input.
        model: whose joints it must give, all of them; slaved ones may be left out.
        why_missing: says why the model lacks a joint of the robot, if it knows.

    Raises:
        InputError: the file cannot be read, is not JSON, or says anything that is not a state of
            this model; the message names the joint and says what to do.
    """
    return StatesFile.read(path).states(model, why_missing)


@contextmanager
def _refused_in(path: str) -> Iterator[None]:
    """Name the file in what is refused of it."""
    try:
        yield
    except Refusal as refusal:
        raise InputError(str(refusal), path, refusal.line) from None


def read_result(path: Path | str, model: Model) -> Array:
    """Return the accelerations and outputs of a result file, shape (S, nqdd).

    NaN stands for accelerations that the model's scene does not want.

    Raises:
        InputError: the file cannot be read, is not JSON, or is not a result for this model.
    """
    try:
        known = ("joints", "outputs", "corrections", "error_bounds", "loops", "couplings")
        document = load_object(path, known)
        joints = as_object(document.get("joints"), "'joints'")
        unasked = {j.name for k, j in enumerate(model.joints) if k not in model.wanted}
        _check_names(joints, model, every=True, unasked=unasked if model.wanted else ())
        count = _count(joints, ("qdd",))
        result = np.full((count, model.nqdd), np.nan)
        for j, joint in enumerate(model.joints):
            if model.wanted and j not in model.wanted:
                continue
            values = as_object(joints[joint.name], f"joint '{joint.name}'")
            rows = _numbers(values, joint, "qdd", joint.kind.nv, count)
            result[:, columns(model, j, "v")] = rows
        if model.outputs:
            result[:, model.nv :] = _outputs(document.get("outputs"), model, count)
    except Refusal as refusal:
        raise InputError(str(refusal), str(path), refusal.line) from None
    return result


def _outputs(content: Any, model: Model, count: int) -> Array:
    """The numbers of a model's outputs, shape (S, all of them)."""
    if not isinstance(content, list) or len(content) != len(model.outputs):
        raise Refusal("'outputs' are not those of the scene")
    parts = []
    for output, given in zip(model.outputs, content, strict=True):
        values = as_object(given, "an output")
        if (values.get("what"), values.get("of")) != (output.what, output.name):
            raise Refusal(f"the {output.what} at '{output.name}' is missing")
        rows = np.array(values.get("values"), dtype=np.float64)
        if rows.shape != (count, OUTPUT_SIZES[output.what]):
            raise Refusal(f"the {output.what} at '{output.name}' has other sizes")
        parts.append(rows)
    return np.hstack(parts)


def _gravity(document: dict[str, Any]) -> Array | None:
    value = document.get("gravity")
    if value is None:
        return None
    if not isinstance(value, list) or len(value) != 3:
        raise Refusal("'gravity' is not three numbers; give e.g. [0, 0, -9.81]")
    return np.array([as_number(x, "'gravity'") for x in value])


def _check_floating(content: Any, model: Model) -> None:
    if content is not None and not isinstance(content, bool):
        raise Refusal("'floating' is neither true nor false")
    if content is True and not model.floating:
        raise Refusal("the states are of a floating base, the robot's is fixed: add --floating")
    if content is False and model.floating:
        raise Refusal("the states are of a fixed base: leave --floating out, or set 'floating'")


def _check_names(
    joints: dict[str, Any],
    model: Model,
    *,
    every: bool = False,
    unasked: Collection[str] = (),
    why_missing: Callable[[str], str | None] | None = None,
) -> None:
    """Refuse joints that the model lacks, and the lack of joints that it has."""
    names = {joint.name for joint in model.joints}
    for name in joints:
        if name not in names:
            reason = None if why_missing is None else why_missing(name)
            if reason is not None:
                raise Refusal(f"joint '{name}' has no state: {reason}; leave it out")
            hint = nearest(name, (joint.name for joint in model.joints))
            if name == BASE:
                hint = ": the robot's base is fixed; add --floating, or leave it out"
            raise Refusal(f"'{name}' is not a moving joint of the robot{hint}")
    for joint in model.joints:
        if joint.name in unasked:
            continue
        if joint.name not in joints and (every or joint.mimic is None):
            hint = "; the base is floating: give its state under that name, or leave --floating out"
            raise Refusal(f"joint '{joint.name}' is missing{hint if joint.name == BASE else ''}")


def _count(joints: dict[str, Any], fields: Sequence[str] = FIELDS) -> int:
    """Return how many states there are: what the first list that is one says."""
    for values in joints.values():
        if isinstance(values, dict) and isinstance(values.get(fields[0]), list):
            if not values[fields[0]]:
                raise Refusal("there are no states: the lists are empty")
            return len(values[fields[0]])
    raise Refusal("there are no states: no joint has a list")


def _read_joint(content: Any, model: Model, j: int, states: States) -> None:
    joint = model.joints[j]
    values = as_object(content, f"joint '{joint.name}'")
    fields = fields_of(joint)
    for name in values:
        if name not in fields + TOLERATED:
            hint = nearest(name, fields)
            if name == "tau":
                hint = "; the scene prescribes its acceleration: give qdd"
            raise Refusal(f"joint '{joint.name}': unknown member '{name}'{hint}")
    for field, array in zip(fields, states.parts, strict=True):
        own = columns(model, j, field)
        width = own.stop - own.start
        array[:, own] = _numbers(values, joint, field, width, states.count)
        if field == "v" and model.at_rest and array[:, own].any():
            raise Refusal(f"joint '{joint.name}' moves, and the scene says at_rest: give v as zero")
    if joint.kind.quaternion is not None:
        own = columns(model, j, "q")
        _check_quaternions(joint, states.q[:, own.stop - 4 : own.stop])


def _read_forces(content: Any, model: Model, states: States) -> None:
    """Read the outer forces of every link that has them as an input."""
    names = {wrench.frame.name: k for k, wrench in enumerate(model.wrenches)}
    if content is None and not names:
        return
    forces = as_object({} if content is None else content, "'forces'")
    for name in forces:
        if name not in names:
            hint = nearest(name, names) or "; a scene says which links have some (--scene)"
            raise Refusal(f"forces: '{name}' is no link with outer forces{hint}")
    for name, k in names.items():
        if name not in forces:
            raise Refusal(f"forces: link '{name}' is missing")
        rows, where = forces[name], f"forces: link '{name}'"
        if not isinstance(rows, list) or len(rows) != states.count:
            raise Refusal(f"{where} needs a list of {states.count} states, as the joints have")
        for s, row in enumerate(rows):
            if not isinstance(row, list) or len(row) != 6:
                raise Refusal(f"{where}, state {s}: not 6 numbers, [fx, fy, fz, nx, ny, nz]")
            numbers = [as_number(x, f"{where}, state {s}") for x in row]
            states.tau[s, wrench_columns(model, k)] = numbers


def _numbers(
    values: dict[str, Any], joint: Joint, field: str, width: int, count: int
) -> list[list[float]]:
    """Return one joint's field as count rows of width numbers."""
    where = f"joint '{joint.name}': {field}"
    rows = values.get(field)
    if not isinstance(rows, list):
        raise Refusal(f"{where} is {'missing' if rows is None else 'not a list'}")
    if len(rows) != count:
        raise Refusal(f"{where} has {len(rows)} states, the first joint has {count}")
    result = []
    for s, row in enumerate(rows):
        entry = row if isinstance(row, list) else [row]
        if len(entry) != width:
            need = "a number" if width == 1 else f"a list of {width} numbers"
            raise Refusal(
                f"{where}, state {s}: {len(entry)} numbers; a {joint.kind.name} joint needs {need}"
            )
        result.append([as_number(x, f"{where}, state {s}") for x in entry])
    return result


def _check_quaternions(joint: Joint, rows: Array) -> None:
    for s, row in enumerate(rows):
        norm = math.hypot(*row)
        if norm == 0.0:
            raise Refusal(
                f"joint '{joint.name}': q, state {s}: the quaternion is zero; "
                "no rotation is [0, 0, 0, 1] (the order is x, y, z, w)"
            )
        if abs(norm - 1.0) > _NORM:
            raise Refusal(
                f"joint '{joint.name}': q, state {s}: the quaternion has length {norm:.6g}, not 1; "
                "normalise it (the order is x, y, z, w)"
            )
