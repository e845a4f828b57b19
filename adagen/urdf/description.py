"""Links and joints of a URDF, element by element, with their line numbers."""

from __future__ import annotations

from dataclasses import dataclass, field

from adagen.urdf.elements import (
    Element,
    attribute,
    check_attributes,
    children,
    only,
    scalar,
    vector,
)
from adagen.urdf.notes import Notes, line_of
from adagen.urdf.numbers import SMALLEST_MASS

Triple = tuple[float, float, float]

TYPES = (
    "revolute", "continuous", "prismatic", "fixed", "floating", "planar", "spherical", "ball",
)  # fmt: skip
WITH_AXIS = frozenset({"revolute", "continuous", "prismatic", "planar"})
SCALAR_TYPES = frozenset({"revolute", "continuous", "prismatic"})
MOMENTS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
LIMIT = 20000
"""Links at most."""


@dataclass(frozen=True)
class Origin:
    """Where a frame is: ``xyz`` (m) and ``rpy`` (rad, fixed axes) in the frame before it."""

    xyz: Triple = (0.0, 0.0, 0.0)
    rpy: Triple = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Inertial:
    """The <inertial> of a link: mass (kg) and the moments MOMENTS (kg m^2) in the frame origin."""

    origin: Origin
    mass: float
    moments: tuple[float, ...]
    line: int | None


@dataclass(frozen=True)
class LinkElement:
    """A <link>; ``inertial`` is None where it has none, which means no mass."""

    name: str
    inertial: Inertial | None
    line: int | None


@dataclass(frozen=True)
class MimicElement:
    """A <mimic>: q = multiplier * q[joint] + offset."""

    joint: str
    multiplier: float
    offset: float
    line: int | None


@dataclass(frozen=True)
class JointElement:
    """A <joint>; ``axis`` is as written, not normalised, (1, 0, 0) where none is written."""

    name: str
    type: str
    parent: str
    child: str
    origin: Origin
    axis: Triple
    mimic: MimicElement | None
    line: int | None


@dataclass(frozen=True)
class Description:
    """A whole <robot>, names unique, every number finite; links and joints in file order."""

    name: str
    links: tuple[LinkElement, ...]
    joints: tuple[JointElement, ...]
    line: int | None
    link_names: frozenset[str] = field(repr=False)


def describe(root: Element, default_name: str, notes: Notes) -> Description:
    """Return what <robot> says.

    Args:
        root: the element <robot>.
        default_name: the name of a robot that has none.
        notes: takes the warnings.

    Raises:
        InputError: an element is missing, repeated, misspelt or holds no proper value.
    """
    name = root.get("name")
    if name is None or not name.strip():
        notes.warn(f'<robot> has no name: using "{default_name}"', line_of(root))
        name = default_name
    parts = children(root, {"link", "joint"}, "<robot>", notes)
    if sum(part.tag == "link" for part in parts) > LIMIT:
        raise notes.error(f"more than {LIMIT} links: the limit of this reader", line_of(root))
    links = tuple(_link(part, notes) for part in parts if part.tag == "link")
    joints = tuple(_joint(part, notes) for part in parts if part.tag == "joint")
    _tell_turned_axes(parts, notes)
    _tell_moments_given_twice(parts, notes)
    if not links:
        raise notes.error("<robot> has no <link>: give a robot with links", line_of(root))
    _check_unique("link", links, notes)
    _check_unique("joint", joints, notes)
    link_names = frozenset(link.name for link in links)
    return Description(name, links, joints, line_of(root), link_names)


def _check_unique(
    what: str, things: tuple[LinkElement, ...] | tuple[JointElement, ...], notes: Notes
) -> None:
    first: dict[str, int | None] = {}
    for thing in things:
        if thing.name in first:
            before = first[thing.name]
            place = "" if before is None else f", first in line {before}"
            raise notes.error(
                f'{what} name "{thing.name}" is used twice{place}: rename one', thing.line
            )
        first[thing.name] = thing.line


def _name(element: Element, notes: Notes) -> str:
    return attribute(element, "name", f"a <{element.tag}>", notes)


def _link(element: Element, notes: Notes) -> LinkElement:
    name = _name(element, notes)
    where = f'link "{name}"'
    found = children(element, {"inertial"}, where, notes)
    inertial = only(found, "inertial", where, notes)
    return LinkElement(
        name, None if inertial is None else _inertial(inertial, where, notes), line_of(element)
    )


def _inertial(element: Element, where: str, notes: Notes) -> Inertial:
    found = children(element, {"origin", "mass", "inertia"}, where, notes)
    mass_element = only(found, "mass", where, notes)
    inertia = only(found, "inertia", where, notes)
    if mass_element is None:
        raise notes.error(
            f"{where}: <inertial> without <mass>: add one, or remove <inertial>", line_of(element)
        )
    if inertia is None:
        raise notes.error(
            f"{where}: <inertial> without <inertia>: add one (zeros for a point mass)",
            line_of(element),
        )
    check_attributes(mass_element, ("value",), where, notes)
    attribute(mass_element, "value", where, notes)
    mass = scalar(mass_element, "value", where, notes) or 0.0
    if mass < 0.0:
        raise notes.error(f"{where}: mass {mass!r} is negative", line_of(mass_element))
    if 0.0 < mass < SMALLEST_MASS:
        raise notes.error(
            f"{where}: mass {mass!r} is too small to compute with: write 0", line_of(mass_element)
        )
    origin = read_origin(only(found, "origin", where, notes), where, notes)
    return Inertial(origin, mass, _moments(inertia, where, notes), line_of(element))


_MIRRORED = {"iyx": "ixy", "izx": "ixz", "izy": "iyz"}


def _moments(element: Element, where: str, notes: Notes) -> tuple[float, ...]:
    check_attributes(element, (*MOMENTS, *_MIRRORED), where, notes)
    values = {key: scalar(element, key, where, notes) for key in MOMENTS}
    missing = [key for key, value in values.items() if value is None]
    if missing:
        raise notes.error(
            f"{where}: {', '.join(missing)} of <inertia> missing: give all six moments",
            line_of(element),
        )
    for key, same in _MIRRORED.items():
        if scalar(element, key, where, notes) not in (None, values[same]):
            raise notes.error(
                f'{where}: {key}="{element.get(key)}" differs from {same}="{element.get(same)}": '
                f"a tensor is symmetric, leave out {key}",
                line_of(element),
            )
    return tuple(value for value in values.values() if value is not None)


def read_origin(
    element: Element | None, where: str, notes: Notes, *, beside: tuple[str, ...] = ()
) -> Origin:
    """Return what an <origin> says; a missing one is that of the frame before it.

    Args:
        element: it, or another one with its attributes.
        where: whose it is, for messages.
        notes: takes the remarks.
        beside: other attributes that the element has.
    """
    if element is None:
        return Origin()
    check_attributes(element, ("xyz", "rpy", *beside), where, notes)
    xyz = vector(element, "xyz", 3, where, notes) or (0.0, 0.0, 0.0)
    rpy = vector(element, "rpy", 3, where, notes) or (0.0, 0.0, 0.0)
    if max(map(abs, rpy)) > 13.0:
        notes.warn(
            f"{where}: rpy of <{element.tag}> is more than two turns: angles are in radians",
            line_of(element),
        )
    return Origin((xyz[0], xyz[1], xyz[2]), (rpy[0], rpy[1], rpy[2]))


_JOINT_PARTS = frozenset({"parent", "child", "origin", "axis", "mimic"})


def _joint(element: Element, notes: Notes) -> JointElement:
    name = _name(element, notes)
    where = f'joint "{name}"'
    found = children(element, _JOINT_PARTS, where, notes)
    kind = _type(element, where, notes)

    def end(tag: str) -> str:
        part = only(found, tag, where, notes)
        if part is None:
            raise notes.error(f"{where} has no <{tag}>: add one", line_of(element))
        return attribute(part, "link", where, notes)

    return JointElement(
        name,
        kind,
        end("parent"),
        end("child"),
        read_origin(only(found, "origin", where, notes), where, notes),
        _axis(_one_axis(found, where, notes), kind, where, notes),
        _mimic(only(found, "mimic", where, notes), where, notes),
        line_of(element),
    )


def _type(element: Element, where: str, notes: Notes) -> str:
    kind = element.get("type")
    known = f"known types are {', '.join(TYPES)}"
    if kind is None:
        raise notes.error(f'{where} has no type="...": {known}', line_of(element))
    if kind not in TYPES:
        raise notes.error(f'{where}: unknown type "{kind}": {known}', line_of(element))
    return kind


def _one_axis(found: list[Element], where: str, notes: Notes) -> Element | None:
    """Return the <axis> of a joint; several that say the same are one, written twice."""
    axes = [element for element in found if element.tag == "axis"]
    if len(axes) < 2 or len({tuple(sorted(axis.attrib.items())) for axis in axes}) > 1:
        return only(found, "axis", where, notes)
    notes.slip(f"{where} has {len(axes)} <axis>", "read as one, as they agree", line_of(axes[1]))
    return axes[0]


def _axis(element: Element | None, kind: str, where: str, notes: Notes) -> Triple:
    if element is None:
        return (1.0, 0.0, 0.0)
    if kind == "fixed" and "xyz" not in element.attrib:
        notes.slip(
            f"{where}: an <axis> without xyz", "left out, as the joint is fixed", line_of(element)
        )
        return (1.0, 0.0, 0.0)
    if any(vector(element, "rpy", 3, where, notes) or ()):
        check_attributes(element, ("xyz",), where, notes)  # whoever wrote it meant to turn the axis
    check_attributes(element, ("xyz", "rpy"), where, notes)
    xyz = vector(element, "xyz", 3, where, notes)
    if xyz is None:
        raise notes.error(f'{where}: xyz="..." of <axis> is missing: add it', line_of(element))
    if kind in WITH_AXIS and not any(xyz):
        raise notes.error(
            f"{where}: the axis has length zero: give it a direction", line_of(element)
        )
    return (xyz[0], xyz[1], xyz[2])


def _tell_turned_axes(parts: list[Element], notes: Notes) -> None:
    """Axes have no rpy, and many a tool writes a zero one."""
    found: list[tuple[str, str, int | None]] = []
    for part in parts:
        axis = part.find("axis") if part.tag == "joint" else None
        if axis is not None and "rpy" in axis.attrib:
            name = part.get("name", "")
            found.append((name, f'joint "{name}": an <axis> has no rpy', line_of(axis)))
    notes.slips(found, "left out, as it is zero", "axes")


def _tell_moments_given_twice(parts: list[Element], notes: Notes) -> None:
    """An <inertia> has six moments; some tools write all nine entries of the tensor."""
    found: list[tuple[str, str, int | None]] = []
    for part in parts:
        inertia = part.find("inertial/inertia") if part.tag == "link" else None
        if inertia is not None and any(key in inertia.attrib for key in _MIRRORED):
            name = part.get("name", "")
            problem = f'link "{name}": an <inertia> has no {", ".join(_MIRRORED)}'
            found.append((name, problem, line_of(inertia)))
    notes.slips(found, "left out, as the tensor is symmetric", "links")


def _mimic(element: Element | None, where: str, notes: Notes) -> MimicElement | None:
    if element is None:
        return None
    check_attributes(element, ("joint", "multiplier", "offset"), where, notes)
    source = attribute(element, "joint", where, notes)
    multiplier = scalar(element, "multiplier", where, notes)
    offset = scalar(element, "offset", where, notes)
    return MimicElement(
        source, 1.0 if multiplier is None else multiplier, offset or 0.0, line_of(element)
    )
