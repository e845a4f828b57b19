"""An MJCF as MuJoCo compiles it: defaults, angles, inertias and names resolved.

The package ``mujoco`` is imported nowhere else, and only where there is an MJCF to read.
"""

from __future__ import annotations

import math
import os
import re
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from adagen.errors import EnvironmentFault, printable
from adagen.model import BASE
from adagen.urdf.checks import Lines
from adagen.urdf.notes import Notes
from adagen.urdf.numbers import LARGEST

FREE, BALL, SLIDE, HINGE = range(4)
"""Types of joints, as MuJoCo numbers them."""

_ON_JOINTS, _ON_TENDONS = (0, 1), (3,)
"""Transmissions of actuators (``mjtTrn``) that give armature and damping."""

_UNNAMED = "MuJoCo Model"
_LINE = re.compile(r"\bline (?:number=)?(\d+)", re.IGNORECASE)
_MISSING = re.compile("opening file|not found|resource", re.IGNORECASE)


@dataclass(frozen=True)
class Compiled:
    """A compiled MJCF.

    Attributes:
        model: MuJoCo's ``MjModel``.
        name: of the robot.
        bodies: name of each body, the world first; each name once.
        joints: name of each joint; each name once.
        lines: where the file tells of joints and bodies.
        tensors: the six moments (xx yy zz xy xz yz, kg m^2) that the file itself gives of bodies,
            in their axes.
    """

    model: Any
    name: str
    bodies: tuple[str, ...]
    joints: tuple[str, ...]
    lines: Lines
    tensors: Mapping[int, tuple[float, ...]]

    def joints_of(self, body: int) -> range:
        """Return the joints of a body, in the order in which they move it."""
        first = int(self.model.body_jntadr[body])
        return range(first, first + int(self.model.body_jntnum[body]))

    def children(self) -> list[list[int]]:
        """Return the bodies on each body, those first whose first joint's name comes first."""
        below: list[list[int]] = [[] for _ in self.bodies]
        for body in range(1, len(self.bodies)):
            below[int(self.model.body_parentid[body])].append(body)
        return [sorted(bodies, key=self._place) for bodies in below]

    def _place(self, body: int) -> str:
        joints = self.joints_of(body)
        return self.joints[joints[0]] if joints else self.bodies[body]

    def disabled(self, what: str) -> bool:
        """Tell whether the file switches something off: "GRAVITY", ..., as in ``mjtDisableBit``."""
        import mujoco

        bit = getattr(mujoco.mjtDisableBit, f"mjDSBL_{what}").value
        return bool(int(self.model.opt.disableflags) & bit)

    def of_drives(self, which: int, what: str, *, tendon: bool = False) -> float:
        """Return what a joint or tendon has of all its actuators, from MuJoCo 4 on; SI units.

        Args:
            which: the joint's or tendon's number.
            what: "armature", "damping", or "dampingpoly", of which the largest size is returned.
            tendon: whether it is a tendon.
        """
        table = getattr(self.model, f"actuator_{what}", None)
        if table is None:
            return 0.0
        kinds = _ON_TENDONS if tendon else _ON_JOINTS
        of_kind = np.isin(self.model.actuator_trntype, kinds)
        those = of_kind & (self.model.actuator_trnid[:, 0] == which)
        first = getattr(self.model, "actuator_outadr", np.arange(len(those)))  # a gear per output
        gears = self.model.actuator_gear[first[those], 0]
        if table.ndim > 1:
            return float(abs(table[those]).max(initial=0.0)) if gears.any() else 0.0
        return float((gears * gears) @ table[those])

    def named(self, kind: str, which: int) -> str:
        """Return the name of an object, or its kind and number where it has none.

        Args:
            kind: "EQUALITY", "TENDON", ..., as in MuJoCo's ``mjtObj``.
            which: its number.
        """
        import mujoco

        number = getattr(mujoco.mjtObj, f"mjOBJ_{kind}")
        return mujoco.mj_id2name(self.model, number, which) or f"number {which + 1}"


def compiled(path: Path, default_name: str, notes: Notes) -> Compiled:
    """Compile an MJCF.

    Args:
        path: of the file.
        default_name: of a model that has no name.
        notes: makes the refusals.

    Raises:
        InputError: MuJoCo refuses it.
        EnvironmentFault: MuJoCo is not installed.
    """
    try:
        import mujoco
    except ImportError:
        raise EnvironmentFault(
            f"{printable(notes.file)} is MJCF, and the Python package mujoco is not installed: "
            "pip install mujoco"
        ) from None
    with _listening(mujoco, notes):
        try:
            spec = mujoco.MjSpec.from_file(os.fspath(path))
            model = spec.compile()
        except Exception as fault:  # any: this is a judgement of the file
            if not _MISSING.search(str(fault)):
                raise _refusal(str(fault), notes) from None
            spec, model = _without_pictures(mujoco, path, fault, notes)
    found = settled(model, spec, default_name)
    _check_numbers(found, notes)
    return found


@contextmanager
def _listening(mujoco: Any, notes: Notes) -> Iterator[None]:
    """Report MuJoCo's warnings; by default it would write a log into the working directory."""
    messages: list[str] = []
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(messages.append)
    try:
        with warnings.catch_warnings(record=True) as more:
            warnings.simplefilter("always")
            yield
    finally:
        mujoco.set_mju_user_warning(before)
    for line in dict.fromkeys(map(_one_line, [*messages, *(str(each.message) for each in more)])):
        notes.warn(f"MuJoCo: {line}")


_OF_BODIES = ("pos", "quat", "mass", "ipos", "iquat", "inertia")
_OF_JOINTS = ("pos", "axis", "stiffness")
_UNFIT = "is not finite or too large to compute with"
_OF_FREEDOMS = ("damping", "frictionloss", "armature")


def _check_numbers(robot: Compiled, notes: Notes) -> None:
    """Refuse numbers that nobody can compute with.

    Raises:
        InputError: one is not finite or too large; the message names its body or joint.
    """
    tables = (
        *((f"body_{name}", "body", range(len(robot.bodies)), robot.bodies) for name in _OF_BODIES),
        *((f"jnt_{name}", "joint", range(len(robot.joints)), robot.joints) for name in _OF_JOINTS),
        *((f"dof_{name}", "joint", robot.model.dof_jntid, robot.joints) for name in _OF_FREEDOMS),
    )
    for table, what, owners, names in tables:
        for row, owner in zip(getattr(robot.model, table), owners, strict=True):
            if not (abs(row) <= LARGEST).all():  # nan is not either
                name = table.partition("_")[2]
                raise notes.error(f'{what} "{names[owner]}": {name} {_UNFIT}')
    if (
        not (abs(robot.model.qpos0) <= LARGEST).all()
        or not (abs(robot.model.opt.gravity) <= LARGEST).all()
    ):
        raise notes.error(f"ref or gravity {_UNFIT}")


def _without_pictures(mujoco: Any, path: Path, fault: Exception, notes: Notes) -> tuple[Any, Any]:
    """Compile an MJCF whose meshes are not there, where no inertia is made of them.

    Raises:
        InputError: an inertia is made of one.
    """
    try:
        spec = mujoco.MjSpec.from_file(os.fspath(path))
        for geom in list(spec.geoms):
            geom.material = ""
            shown = geom.type in (mujoco.mjtGeom.mjGEOM_MESH, mujoco.mjtGeom.mjGEOM_HFIELD)
            if shown and not _gives_inertia(mujoco, spec, geom.parent):
                spec.delete(geom)
        for each in (*spec.sites, *spec.tendons):
            each.material = ""
        used = {geom.meshname for geom in spec.geoms}
        meshes = [mesh for mesh in spec.meshes if mesh.name not in used]
        for each in [*spec.skins, *meshes, *spec.hfields, *spec.materials, *spec.textures]:
            spec.delete(each)
        model = spec.compile()
    except Exception:
        raise _refusal(str(fault), notes) from None
    notes.warn(
        f"MuJoCo: {_one_line(str(fault))}: read without meshes, as no inertia is made of them"
    )
    return spec, model


def _gives_inertia(mujoco: Any, spec: Any, body: Any) -> bool:
    """Whether the inertia of a body that can move is made of its geoms."""
    if spec.compiler.inertiafromgeom == mujoco.mjtInertiaFromGeom.mjINERTIAFROMGEOM_TRUE:
        return True
    if body.explicitinertial:
        return False
    while body.name != "world":
        if body.joints:
            return True
        body = body.parent
    return False


def settled(model: Any, spec: Any, default_name: str) -> Compiled:
    """Return a compiled MJCF with names, those that it lacks made of what they belong to.

    Args:
        model: an ``MjModel``.
        spec: the ``MjSpec`` that it was compiled of.
        default_name: of a model that has no name.
    """
    bodies = [body.name for body in sorted(spec.bodies, key=lambda body: int(body.id))]
    joints = [joint.name for joint in sorted(spec.joints, key=lambda joint: int(joint.id))]
    known = _unique([name or f"body{k}" for k, name in enumerate(bodies)], bodies)
    joint_names = _unique(
        [name or _default(model, k, known) for k, name in enumerate(joints)], joints
    )
    lines = Lines(
        None,
        {joint_names[int(joint.id)]: _line(joint) for joint in spec.joints},
        {known[int(body.id)]: _line(body) for body in spec.bodies},
    )
    name = spec.modelname if spec.modelname != _UNNAMED else default_name
    tensors = {
        int(body.id): tuple(map(float, body.fullinertia))
        for body in spec.bodies
        if all(map(math.isfinite, body.fullinertia))
    }
    return Compiled(model, name or default_name, known, joint_names, lines, tensors)


def _default(model: Any, joint: int, bodies: Sequence[str]) -> str:
    """Return a name for a joint that has none."""
    if model.jnt_type[joint] == FREE and sum(model.jnt_type == FREE) == 1:
        return BASE
    body = int(model.jnt_bodyid[joint])
    place = joint - int(model.body_jntadr[body]) + 1
    return f"{bodies[body]}_joint{place if model.body_jntnum[body] > 1 else ''}"


def _unique(wanted: Sequence[str], given: Sequence[str]) -> tuple[str, ...]:
    """Return names, those that were not given changed where they are in use."""
    taken = set(filter(None, given))
    result = []
    for name, own in zip(wanted, given, strict=True):
        new = name
        while not own and new in taken:
            new += "_"
        taken.add(new)
        result.append(new)
    return tuple(result)


def _line(element: Any) -> int | None:
    found = _LINE.search(element.info or "")
    return int(found[1]) if found else None


def _one_line(text: str) -> str:
    return " ".join(text.split()).removeprefix("XML Error: ").removeprefix("Error: ")


def _refusal(text: str, notes: Notes) -> Exception:
    """Return MuJoCo's complaint in one line."""
    words = _one_line(text)
    found = _LINE.search(words)
    return notes.error(f"MuJoCo: {words}", int(found[1]) if found else None)
