"""Loops and couplings of a URDF: <loop>, <coupling> (URDF+), <loop_joint>, second parent joints."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from adagen.jsonfile import nearest
from adagen.model import (
    LOOP_WORDS,
    LoopEnd,
    Model,
    NamedCoupling,
    NamedLoop,
    closed,
    places,
    with_loops_checked,
)
from adagen.urdf.description import (
    SCALAR_TYPES,
    Description,
    JointElement,
    Triple,
    read_origin,
)
from adagen.urdf.elements import (
    Element,
    attribute,
    check_attributes,
    children,
    only,
    scalar,
    vector,
)
from adagen.urdf.mimics import Followed
from adagen.urdf.notes import Notes, line_of, quoted
from adagen.urdf.passive import is_zero
from adagen.urdf.tree import Tree

_KIND_OF_JOINT = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "weld",
    "planar": "planar",
    "spherical": "spherical",
    "ball": "spherical",
}
_KIND_OF_LOOP = {**_KIND_OF_JOINT, **{word: word for word in ("weld", "point", "cylindrical")}}
_ROLLING = "rolling"


@dataclass(frozen=True)
class _Notation:
    """How an element closes a loop.

    Attributes:
        ends: elements of the link that has frame 1, and of the other one.
        inside: whether their frames are in an <origin>, not in attributes of their own.
        axis: that of an element without one; None: it must have one.
    """

    ends: tuple[str, str]
    inside: bool
    axis: Triple | None


_NOTATIONS = {
    "loop": _Notation(("predecessor", "successor"), True, None),
    "loop_joint": _Notation(("link1", "link2"), False, (1.0, 0.0, 0.0)),
}
"""URDF+, and Drake and Isaac Sim."""


@dataclass(frozen=True)
class Closing:
    """What closes the tree, by names.

    Attributes:
        loops: <loop> and <loop_joint> elements in file order, then joints to links that have
            another parent joint.
        couplings: <coupling> elements.
        lines: of the loops, by name.
        subjects: what refusals of the loops begin with, by name.
    """

    loops: tuple[NamedLoop, ...]
    couplings: tuple[NamedCoupling, ...]
    lines: Mapping[str, int | None]
    subjects: Mapping[str, str]


def read_closing(
    root: Element, description: Description, tree: Tree, mimics: Followed, notes: Notes
) -> Closing:
    """Return what closes the tree; a second parent joint is a warning, the rest is mentioned.

    Args:
        root: the element <robot>.
        description: its links and joints.
        tree: that they form.
        mimics: what each slaved joint follows.
        notes: takes the remarks.

    Raises:
        InputError: an element is incomplete, of an unknown type, or names what does not exist.
    """
    found = children(root, {*_NOTATIONS, "coupling"}, "<robot>", notes)
    elements = [element for element in found if element.tag in _NOTATIONS]
    loops = [_loop(element, description, notes) for element in elements]
    lines = [line_of(element) for element in elements]
    subjects = {loop.name: f'loop "{loop.name}"' for loop in loops}
    for joint in _closing_joints(tree, mimics, notes):
        loops.append(_second_parent(joint))
        lines.append(joint.line)
        subjects[joint.name] = f'{_held_twice(joint, tree)}: loop "{joint.name}"'
    gears = [element for element in found if element.tag == "coupling"]
    couplings = [_coupling(element, description, tree, notes) for element in gears]
    _check_unique("loop", loops, lines, notes)
    _check_unique("coupling", couplings, [line_of(element) for element in gears], notes)
    read = {element: loop.name for element, loop in zip(elements, loops, strict=False)}
    read |= {element: gear.name for element, gear in zip(gears, couplings, strict=True)}
    for what in (*_NOTATIONS, "coupling"):
        names = [name for element, name in read.items() if element.tag == what]
        if names:
            notes.mention(f"<{what}> elements: {len(names)}, read: {quoted(names)}")
    at = {loop.name: line for loop, line in zip(loops, lines, strict=True)}
    return Closing(tuple(loops), tuple(couplings), at, subjects)


def warn_effects(root: Element, tree: Tree, notes: Notes) -> None:
    """Warn of what <dynamics> says of joints that close loops: they have no coordinate."""
    closing = {joint.name for joint in tree.closing}
    found: list[tuple[str, str, int | None]] = []
    for joint in root.iterchildren("joint"):
        name = joint.get("name", "")
        for element in joint.iterchildren("dynamics") if name in closing else ():
            if not all(is_zero(str(value)) for value in element.attrib.values()):
                text = f'joint "{name}": <dynamics> of a joint that closes a loop is not modelled'
                found.append((name, text, line_of(element)))
    notes.warn_each(found, "joints that close loops have <dynamics>, not modelled")


def with_closing(model: Model, found: Closing, notes: Notes) -> Model:
    """Return the model with its loops and couplings; loops that hold by themselves are left out.

    Raises:
        InputError: a loop cannot close.
    """
    joints = {joint.name: j for j, joint in enumerate(model.joints)}
    whole = closed(
        model, found.loops, found.couplings, places(model).__getitem__, joints.__getitem__
    )
    return with_loops_checked(
        whole,
        lambda loop, why: notes.error(f"{found.subjects[loop.name]} {why}", found.lines[loop.name]),
    )


def _check_unique(
    what: str,
    things: Sequence[NamedLoop] | Sequence[NamedCoupling],
    lines: Sequence[int | None],
    notes: Notes,
) -> None:
    names = [thing.name for thing in things]
    for k, name in enumerate(names):
        if name in names[:k]:
            raise notes.error(f'{what} name "{name}" is used twice: rename one', lines[k])


def _closing_joints(tree: Tree, mimics: Followed, notes: Notes) -> list[JointElement]:
    """Return the second parent joints that hold something, and warn of all.

    Raises:
        InputError: a joint is slaved to one, or one to a joint.
    """
    closing: list[tuple[str, str, int | None]] = []
    slaved = set(mimics) | {source for source, _, _ in mimics.values()}
    for joint in tree.closing:
        if joint.name in slaved:
            raise notes.error(
                f'joint "{joint.name}" closes a loop and has no coordinate that mimics: '
                "leave out --mimic, or write its <mimic> as a coupling of other joints",
                joint.line,
            )
        kind = _KIND_OF_JOINT.get(joint.type)
        done = f"closes a loop ({kind})" if kind else f"is {joint.type} and constrains nothing"
        text = f'{_held_twice(joint, tree)}: "{joint.name}" {done}'
        closing.append((joint.name, text, joint.line))
    notes.warn_each(closing, "joints close loops")
    return [joint for joint in tree.closing if joint.type in _KIND_OF_JOINT]


def _held_twice(joint: JointElement, tree: Tree) -> str:
    """Say what a joint that closes a loop leads to."""
    above = tree.above.get(joint.child)
    if above is None:
        return f'joint "{joint.name}" leads back to the root link "{joint.child}"'
    return f'link "{joint.child}" has two parent joints, "{above.name}" and "{joint.name}"'


def _second_parent(joint: JointElement) -> NamedLoop:
    origin = joint.origin
    first, second = LoopEnd(joint.parent, origin.xyz, origin.rpy), LoopEnd(joint.child)
    return NamedLoop(joint.name, _KIND_OF_JOINT[joint.type], first, second, joint.axis)


def _loop(element: Element, description: Description, notes: Notes) -> NamedLoop:
    written = _NOTATIONS[element.tag]
    name = attribute(element, "name", f"a <{element.tag}>", notes)
    where = f'loop "{name}"'
    found = children(element, {*written.ends, "axis"}, where, notes)
    kind = _type(element, where, _KIND_OF_LOOP, "or [[loops]] in a scene", notes)

    def end(tag: str) -> LoopEnd:
        part, link = _end(found, tag, element, where, description, notes)
        if written.inside:
            inside = children(part, {"origin"}, where, notes)
            origin = read_origin(only(inside, "origin", where, notes), where, notes)
        else:
            origin = read_origin(part, where, notes, beside=("link",))
        return LoopEnd(link, origin.xyz, origin.rpy)

    first, second = map(end, written.ends)
    if not LOOP_WORDS[kind].axes:
        return NamedLoop(name, kind, first, second)
    axis = only(found, "axis", where, notes)
    if axis is None and written.axis is not None:
        return NamedLoop(name, kind, first, second, written.axis)
    return NamedLoop(name, kind, first, second, _axis(axis, element, where, notes))


def _axis(axis: Element | None, element: Element, where: str, notes: Notes) -> Triple:
    xyz = None
    if axis is not None:
        check_attributes(axis, ("xyz",), where, notes)
        xyz = vector(axis, "xyz", 3, where, notes)
    if xyz is None:
        raise notes.error(f'{where} has no <axis xyz="...">: add one', line_of(element))
    if not any(xyz):
        raise notes.error(
            f"{where}: the axis has length zero: give it a direction", line_of(element)
        )
    return (xyz[0], xyz[1], xyz[2])


def _type(element: Element, where: str, known: Mapping[str, str], others: str, notes: Notes) -> str:
    kind = element.get("type")
    types = f"known types are {', '.join(known)} ({others})"
    if kind is None:
        raise notes.error(f'{where} has no type="...": {types}', line_of(element))
    if kind not in known:
        raise notes.error(f'{where}: unknown type "{kind}": {types}', line_of(element))
    return known[kind]


def _end(
    found: list[Element],
    tag: str,
    element: Element,
    where: str,
    description: Description,
    notes: Notes,
) -> tuple[Element, str]:
    """Return an element for an end of a loop or coupling, and the link that it names."""
    part = only(found, tag, where, notes)
    if part is None:
        raise notes.error(f"{where} has no <{tag}>: add one", line_of(element))
    link = attribute(part, "link", where, notes)
    if link not in description.link_names:
        hint = nearest(link, description.link_names) or ""
        raise notes.error(f'{where}: {tag} link "{link}" is not declared{hint}', line_of(part))
    return part, link


def _coupling(
    element: Element, description: Description, tree: Tree, notes: Notes
) -> NamedCoupling:
    """Return ratio * (joints up from the predecessor) = joints up from the successor."""
    name = attribute(element, "name", "a <coupling>", notes)
    where = f'coupling "{name}"'
    found = children(element, {"predecessor", "successor", "ratio"}, where, notes)
    if element.get("type") is not None:
        _type(element, where, {_ROLLING: _ROLLING}, "or none", notes)
    ends = [
        _end(found, tag, element, where, description, notes)[1]
        for tag in ("successor", "predecessor")
    ]
    given = only(found, "ratio", where, notes)
    ratio = None if given is None else scalar(given, "value", where, notes)
    if not ratio:
        problem = 'has no <ratio value="...">' if ratio is None else "has ratio zero"
        raise notes.error(f"{where} {problem}: give it one", line_of(element))

    def refuse(joint: JointElement) -> Exception:
        return notes.error(
            f'{where}: joint "{joint.name}" between its links is {joint.type}: only joints of one '
            "degree of freedom can be coupled",
            line_of(element),
        )

    paths = _apart(*(_upwards(link, tree) for link in ends))
    terms = [
        (joint.name, factor)
        for path, factor in zip(paths, (1.0, -ratio), strict=True)
        for joint in _scalar(path, refuse)
    ]
    if not terms:
        raise notes.error(f"{where}: no joint moves its links against each other", line_of(element))
    return NamedCoupling(name, tuple(terms))


def _upwards(link: str, tree: Tree) -> list[JointElement]:
    """Return the joints from a link to the root."""
    path = []
    while link in tree.above:
        path.append(tree.above[link])
        link = path[-1].parent
    return path


def _apart(
    one: list[JointElement], other: list[JointElement]
) -> tuple[list[JointElement], list[JointElement]]:
    """Return two ways to the root up to where they meet."""
    while one and other and one[-1].name == other[-1].name:
        one, other = one[:-1], other[:-1]
    return one, other


def _scalar(
    path: list[JointElement], refuse: Callable[[JointElement], Exception]
) -> list[JointElement]:
    """Return the joints of a way that move; all of them have to have one degree of freedom."""
    moving = [joint for joint in path if joint.type != "fixed"]
    for joint in moving:
        if joint.type not in SCALAR_TYPES:
            raise refuse(joint)
    return moving
