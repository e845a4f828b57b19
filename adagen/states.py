"""The states file: what to solve for, by joint name; and the result file.

States are ``{"floating": bool, "gravity": [x, y, z], "joints": {NAME: {"q": [...], "v": [...],
"tau": [...]}}}`` with one entry per state in each list: a number for one degree of freedom, a list
for more. Where a scene prescribes a joint's acceleration, its "qdd" stands in place of its "tau";
where it names links on which outer forces act, "forces": {LINK: [[fx, fy, fz, nx, ny, nz], ...]}
gives force (N) and moment (N m) at the link's origin in its axes, for each state. Results are
``{"joints": {NAME: {"qdd": [...]}}}`` likewise.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.errors import EnvironmentFault, InputError, printable
from adagen.jsonfile import Refusal, as_number, as_object, load_object, nearest, write_whole
from adagen.model import Joint, Model

Array = NDArray[np.float64]

BASE = "__base__"
FIELDS = ("q", "v", "tau")
PRESCRIBED = ("q", "v", "qdd")
MEMBERS = ("floating", "gravity", "forces", "joints")
TOLERATED = ("type", "qdd")  # a file of true answers has these beside the fields
_NORM = 1e-3  # how far a quaternion may be from unit length
_AGREE = 1e-9  # how far a slaved joint may be from what it follows


@dataclass(frozen=True, eq=False)
class States:
    """Some states of a model, in the model's order of joints.

    Attributes:
        q: configurations, shape (S, nq); quaternions (x, y, z, w) nearly of unit length.
        v: velocities, shape (S, nv).
        tau: torques and forces (of prescribed joints: accelerations), then outer forces, shape
            (S, ntau).
    """

    q: Array
    v: Array
    tau: Array

    @property
    def count(self) -> int:
        """How many states there are, S."""
        return len(self.q)


def read_states(
    path: Path | str, model: Model, why_missing: Callable[[str], str | None] | None = None
) -> States:
    """Read a states file.

    Args:
        path: the file.
        model: whose joints it must give, all of them; slaved ones may be left out.
        why_missing: says why the model lacks a joint of the robot, if it knows.

    Raises:
        InputError: the file cannot be read, is not JSON, or says anything that is not a state of
            this model; the message names the joint and says what to do.
    """
    try:
        document = load_object(path, MEMBERS)
        _gravity(document)
        joints = as_object(document.get("joints"), "'joints'")
        _check_floating(document.get("floating"), model)
        _check_names(joints, model, why_missing=why_missing)
        count = _count(joints)
        size = {"q": model.nq, "v": model.nv, "tau": model.ntau}
        states = States(*(np.zeros((count, size[name])) for name in FIELDS))
        for j, joint in enumerate(model.joints):
            if joint.name in joints:
                _read_joint(joints[joint.name], model, j, states)
        _read_forces(document.get("forces"), model, states)
        _follow(states, model, joints)
    except Refusal as refusal:
        raise InputError(str(refusal), str(path), refusal.line) from None
    return states


def states_gravity(path: Path | str) -> Array | None:
    """Return the states file's gravity, shape (3,), m/s^2, or None where it says nothing.

    Raises:
        InputError: the file cannot be read, is not JSON, or its gravity is not three numbers.
    """
    try:
        return _gravity(load_object(path, MEMBERS))
    except Refusal as refusal:
        raise InputError(str(refusal), str(path), refusal.line) from None


def write_states(states: States, model: Model, path: Path | str) -> None:
    """Write a states file that `read_states` reads back bit by bit, whole or not at all.

    Raises:
        EnvironmentFault: writing failed.
    """
    rows = {}
    for j, joint in enumerate(model.joints):
        q, v = _columns(model, j, "q"), _columns(model, j, "v")
        values = (states.q[:, q], states.v[:, v], states.tau[:, v])
        rows[joint.name] = dict(zip(_fields(joint), map(_listed, values), strict=True))
    gravity = [float(x) for x in model.gravity]
    head: dict[str, Any] = {"floating": model.floating, "gravity": gravity}
    if model.wrenches:
        head["forces"] = {
            wrench.frame.name: states.tau[:, _wrench_columns(model, k)].tolist()
            for k, wrench in enumerate(model.wrenches)
        }
    write_whole(Path(path), _text(head, rows))


def write_result(path: Path | str, model: Model, qdd: Array) -> None:
    """Write a result file, whole or not at all; its numbers read back bit by bit.

    Args:
        path: the file.
        model: whose accelerations they are.
        qdd: shape (S, nv), or (nv,) for one state.

    Raises:
        EnvironmentFault: an acceleration is not finite, or writing failed.
    """
    every = np.atleast_2d(np.asarray(qdd, dtype=np.float64))
    if every.shape[1] != model.nv:
        raise ValueError(f"qdd has {every.shape[1]} columns, not {model.nv}")
    rows = {}
    for j, joint in enumerate(model.joints):
        own = every[:, _columns(model, j, "v")]
        if not np.isfinite(own).all():
            raise EnvironmentFault(f"joint '{printable(joint.name)}': qdd is not finite")
        rows[joint.name] = {"qdd": _listed(own)}
    write_whole(Path(path), _text({}, rows))


def read_result(path: Path | str, model: Model) -> Array:
    """Return the accelerations of a result file, shape (S, nv).

    Raises:
        InputError: the file cannot be read, is not JSON, or is not a result for this model.
    """
    try:
        joints = as_object(load_object(path, ("joints", "corrections")).get("joints"), "'joints'")
        _check_names(joints, model, every=True)
        count = _count(joints, ("qdd",))
        result = np.zeros((count, model.nv))
        for j, joint in enumerate(model.joints):
            values = as_object(joints[joint.name], f"joint '{joint.name}'")
            rows = _numbers(values, joint, "qdd", joint.kind.nv, count)
            result[:, _columns(model, j, "v")] = rows
    except Refusal as refusal:
        raise InputError(str(refusal), str(path), refusal.line) from None
    return result


def random_states(model: Model, count: int, seed: int = 0) -> States:
    """Return states drawn at random: angles within pi, lengths and all rates within 1, SI units.

    Quaternions are uniformly distributed; slaved joints follow. The same arguments give the same
    states on every machine up to rounding.

    Args:
        model: the robot.
        count: how many, at least 1.
        seed: at least 0.
    """
    rng = np.random.default_rng(seed)
    v, torques = rng.uniform(-1.0, 1.0, size=(2, count, model.nv))
    q = rng.uniform(-1.0, 1.0, size=(count, model.nq))
    for j, joint in enumerate(model.joints):
        at = _columns(model, j, "q")
        if joint.kind.quaternion is not None:
            four = rng.normal(size=(count, 4))
            q[:, at.stop - 4 : at.stop] = four / np.linalg.norm(four, axis=1, keepdims=True)
        elif 2 in joint.kind.free:  # it turns about its axis: an angle, the last of its q
            q[:, at.stop - 1] *= np.pi
    forces = rng.uniform(-1.0, 1.0, size=(count, model.ntau - model.nv))
    states = States(q, v, np.hstack([torques, forces]))
    _follow(states, model, {})
    return states


def _gravity(document: dict[str, Any]) -> Array | None:
    value = document.get("gravity")
    if value is None:
        return None
    if not isinstance(value, list) or len(value) != 3:
        raise Refusal("'gravity' is not three numbers; give e.g. [0, 0, -9.81]")
    return np.array([as_number(x, "'gravity'") for x in value])


def _check_floating(said: Any, model: Model) -> None:
    if said is not None and not isinstance(said, bool):
        raise Refusal("'floating' is neither true nor false")
    if said is True and not model.floating:
        raise Refusal("the states are of a floating base, the robot's is fixed: add --floating")
    if said is False and model.floating:
        raise Refusal("the states are of a fixed base: leave --floating out, or set 'floating'")


def _check_names(
    joints: dict[str, Any],
    model: Model,
    *,
    every: bool = False,
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


def _fields(joint: Joint) -> tuple[str, str, str]:
    """The members that a joint's state has."""
    return PRESCRIBED if joint.prescribed else FIELDS


def _wrench_columns(model: Model, k: int) -> slice:
    return slice(model.nv + 6 * k, model.nv + 6 * k + 6)


def _columns(model: Model, j: int, field: str) -> slice:
    kind = model.joints[j].kind
    if field == "q":
        return slice(model.q_start[j], model.q_start[j] + kind.nq)
    return slice(model.v_start[j], model.v_start[j] + kind.nv)


def _read_joint(said: Any, model: Model, j: int, states: States) -> None:
    joint = model.joints[j]
    values = as_object(said, f"joint '{joint.name}'")
    fields = _fields(joint)
    for name in values:
        if name not in fields + TOLERATED:
            hint = nearest(name, fields)
            if name == "tau":
                hint = "; the scene prescribes its acceleration: give qdd"
            raise Refusal(f"joint '{joint.name}': unknown member '{name}'{hint}")
    for field, array in zip(fields, (states.q, states.v, states.tau), strict=True):
        own = _columns(model, j, field)
        width = own.stop - own.start
        array[:, own] = _numbers(values, joint, field, width, states.count)
    if joint.kind.quaternion is not None:
        own = _columns(model, j, "q")
        _check_quaternions(joint, states.q[:, own.stop - 4 : own.stop])


def _read_forces(said: Any, model: Model, states: States) -> None:
    """Read the outer forces of every link that has them as an input."""
    names = {wrench.frame.name: k for k, wrench in enumerate(model.wrenches)}
    if said is None and not names:
        return
    forces = as_object({} if said is None else said, "'forces'")
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
            states.tau[s, _wrench_columns(model, k)] = numbers


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


def _follow(states: States, model: Model, given: dict[str, Any]) -> None:
    """Set slaved joints from their sources; where the file gives them too, they must agree."""
    done = {j for j, joint in enumerate(model.joints) if joint.mimic is None}
    waiting = [j for j in range(len(model.joints)) if j not in done]
    while waiting:
        ready = [j for j in waiting if (m := model.joints[j].mimic) is None or m.source in done]
        if not ready:
            raise InputError("mimic joints follow one another in a ring")
        for j in ready:
            _set_follower(states, model, j, model.joints[j].name in given)
        done.update(ready)
        waiting = [j for j in waiting if j not in done]


def _set_follower(states: States, model: Model, j: int, given: bool) -> None:
    joint, mimic = model.joints[j], model.joints[j].mimic
    assert mimic is not None
    for field, array in (("q", states.q), ("v", states.v)):
        own, source = _columns(model, j, field), _columns(model, mimic.source, field)
        offset = mimic.offset if field == "q" else 0.0
        expected = array[:, source] * mimic.multiplier + offset
        wrong = np.abs(array[:, own] - expected) > _AGREE * (1.0 + np.abs(expected))
        if given and wrong.any():
            s = int(np.flatnonzero(wrong[:, 0])[0])
            raise Refusal(
                f"joint '{joint.name}': {field}, state {s}: {array[s, own][0]:.9g} is not what "
                f"its mimic of '{model.joints[mimic.source].name}' makes of it, "
                f"{expected[s, 0]:.9g}; leave the joint out, or do without --mimic"
            )
        array[:, own] = expected


def _listed(rows: Array) -> list[Any]:
    """Return a number per state for one degree of freedom, a list per state for more."""
    listed: list[Any] = rows[:, 0].tolist() if rows.shape[1] == 1 else rows.tolist()
    return listed


def _text(head: dict[str, Any], joints: dict[str, dict[str, list[Any]]]) -> str:
    """Return the JSON text, a line for each joint."""
    start = "".join(f"{json.dumps(k)}: {json.dumps(v)},\n" for k, v in head.items())
    rows = (f"{json.dumps(k)}: {json.dumps(v, allow_nan=False)}" for k, v in joints.items())
    return "{" + start + '"joints": {\n' + ",\n".join(rows) + "\n}}\n"
