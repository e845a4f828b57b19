"""Comparison with yourdfpy's reading of the same robot, which must agree in every number.

yourdfpy alone is too trusting: it recovers from broken XML and keeps the first half, fills a
missing ixx with 1, and accepts unknown joint types, loops, nan and duplicate names. It is therefore
given a document that has been validated and cut down to the dynamics (no visuals, no meshes), and
its result is compared with the validated values. It is imported without the libraries for meshes,
which take longer than to read a robot.
"""

from __future__ import annotations

import builtins
import functools
import importlib
import importlib.util
import io
import sys
from copy import deepcopy
from dataclasses import replace
from types import ModuleType
from typing import Any

import numpy as np
from lxml import etree

from adagen.exact import Matrix, rotation_from_rpy, rounded
from adagen.urdf.description import (
    Description,
    Inertial,
    JointElement,
    LinkElement,
    MimicElement,
    Origin,
)
from adagen.urdf.elements import Element
from adagen.urdf.notes import Notes

ROTATION_TOLERANCE = 1e-12
"""yourdfpy's rotations go through the C library; ours are exact."""

_LINK_PARTS = frozenset({"inertial"})
_JOINT_PARTS = frozenset({"parent", "child", "origin", "axis", "mimic"})


def agreed(root: Element, description: Description, notes: Notes) -> Description:
    """Return the description with all values from yourdfpy's objects.

    Raises:
        InputError: yourdfpy reads something else than what was validated.
    """
    robot = _load(_cut_down(root, description), notes)
    if len(robot.links) != len(description.links) or len(robot.joints) != len(description.joints):
        raise notes.error(
            f"yourdfpy reads {len(robot.links)} links and {len(robot.joints)} joints of "
            f"{len(description.links)} and {len(description.joints)}: please report this",
            description.line,
        )
    links = tuple(_link(o, p, notes) for o, p in zip(description.links, robot.links, strict=True))
    joints = tuple(
        _joint(o, p, notes) for o, p in zip(description.joints, robot.joints, strict=True)
    )
    return replace(description, links=links, joints=joints)


def _cut_down(root: Element, description: Description) -> bytes:
    """Return a document with the links, inertials and joints of ``root`` alone."""
    robot = etree.Element("robot", {"name": description.name})
    for part in root:
        if part.tag not in ("link", "joint"):
            continue
        is_link = part.tag == "link"
        keys = ("name",) if is_link else ("name", "type")
        copy = etree.SubElement(robot, str(part.tag), {key: part.get(key, "") for key in keys})
        for child in part:
            if child.tag in (_LINK_PARTS if is_link else _JOINT_PARTS):
                copy.append(deepcopy(child))
    return etree.tostring(robot, encoding="utf-8", xml_declaration=True)


def _load(document: bytes, notes: Notes) -> Any:
    try:
        return (
            urdf_class()
            .load(
                io.BytesIO(document),
                build_scene_graph=False,
                build_collision_scene_graph=False,
                load_meshes=False,
                load_collision_meshes=False,
            )
            .robot
        )
    except Exception as fault:  # any: the document is valid, so that this is a defect, not a slip
        raise notes.error(
            f"yourdfpy cannot read this file ({type(fault).__name__}: {fault}): please report this"
        ) from fault


def _differs(where: str, line: int | None, ours: object, theirs: object, notes: Notes) -> Exception:
    return notes.error(
        f"{where}: validated as {ours!r}, read by yourdfpy as {theirs!r}: please report this", line
    )


def _link(ours: LinkElement, theirs: Any, notes: Notes) -> LinkElement:
    where = f'link "{ours.name}"'
    if theirs.name != ours.name or (theirs.inertial is None) != (ours.inertial is None):
        raise _differs(where, ours.line, ours.name, theirs.name, notes)
    if ours.inertial is None:
        return ours
    tensor = np.asarray(theirs.inertial.inertia, dtype=np.float64)
    moments = tuple(float(tensor[i, k]) for i in range(3) for k in range(i, 3))
    if not np.array_equal(tensor, tensor.T):
        raise _differs(where, ours.line, ours.inertial.moments, tensor.tolist(), notes)
    read = Inertial(
        _origin(where, ours.inertial.origin, theirs.inertial.origin, ours.inertial.line, notes),
        float(theirs.inertial.mass),
        moments,
        ours.inertial.line,
    )
    if read != ours.inertial:
        raise _differs(where, ours.line, ours.inertial, read, notes)
    return replace(ours, inertial=read)


def _joint(ours: JointElement, theirs: Any, notes: Notes) -> JointElement:
    where = f'joint "{ours.name}"'
    axis = tuple(float(x) for x in theirs.axis)
    mimic = None
    if theirs.mimic is not None:
        mimic = MimicElement(
            theirs.mimic.joint,
            float(theirs.mimic.multiplier),
            float(theirs.mimic.offset),
            None if ours.mimic is None else ours.mimic.line,
        )
    read = JointElement(
        theirs.name,
        theirs.type,
        theirs.parent,
        theirs.child,
        _origin(where, ours.origin, theirs.origin, ours.line, notes),
        (axis[0], axis[1], axis[2]),
        mimic,
        ours.line,
    )
    if read != ours:
        raise _differs(where, ours.line, ours, read, notes)
    return read


def _origin(
    where: str, ours: Origin, theirs: Matrix | None, line: int | None, notes: Notes
) -> Origin:
    """Return our origin (xyz and rpy say more than a matrix), compared with yourdfpy's matrix."""
    if theirs is None:
        theirs = np.eye(4)
    apart = np.abs(theirs[:3, :3] - rounded(rotation_from_rpy(ours.rpy))).max()
    if theirs[:3, 3].tolist() != list(ours.xyz) or not apart <= ROTATION_TOLERANCE:
        raise _differs(where, line, ours, theirs.tolist(), notes)
    return ours


@functools.cache
def urdf_class() -> Any:
    """Return yourdfpy's class ``URDF``, which reads descriptions that name no mesh.

    What is imported for it has names of its own: whoever imports yourdfpy or trimesh gets all of
    them. Where a release of them has changed its parts, this takes yourdfpy as it is.
    """
    if "yourdfpy" not in sys.modules:
        try:
            return _without_meshes()
        except (ImportError, AttributeError):
            pass
    from yourdfpy import URDF

    return URDF


def _without_meshes() -> Any:
    trimesh = _parts_of("trimesh", _Trimesh)
    trimesh.transformations = importlib.import_module(f"{trimesh.__name__}.transformations")
    yourdfpy = _parts_of("yourdfpy", ModuleType)
    spec = importlib.util.find_spec(f"{yourdfpy.__name__}.urdf")
    if spec is None or spec.loader is None:
        raise ImportError("yourdfpy has no part urdf")

    def imported(name: str, *rest: Any, **more: Any) -> Any:
        if name.partition(".")[0] == "trimesh":
            return trimesh
        return builtins.__import__(name, *rest, **more)

    module = importlib.util.module_from_spec(spec)
    module.__dict__["__builtins__"] = {**vars(builtins), "__import__": imported}
    spec.loader.exec_module(module)
    return module.URDF


def _parts_of(name: str, kind: type[ModuleType]) -> Any:
    """Return a package under another name, from which parts are imported without the whole."""
    spec = importlib.util.find_spec(name)
    if spec is None or spec.submodule_search_locations is None:
        raise ImportError(f"{name} is no package")
    package = kind(f"_adagen_{name}")
    package.__path__ = list(spec.submodule_search_locations)
    sys.modules[package.__name__] = package
    return package


class _Trimesh(ModuleType):
    """Stands for trimesh: any name that yourdfpy's signatures mention is there."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return Any
