"""Frame pairs that close loops, in the YAML of example-parallel-robots.

``closed_loop`` lists pairs of frames, ``type`` how each is held together, "6d" or "3d";
``joint_name`` and ``joint_type`` say which joints of the URDF are of another kind than it says.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from adagen.errors import InputError
from adagen.jsonfile import nearest
from adagen.model import (
    REVOLUTE,
    SPHERICAL,
    WORLD,
    Inertia,
    Joint,
    Link,
    LoopEnd,
    Model,
    NamedLoop,
    Passive,
    closed,
    places,
    with_loops_checked,
)
from adagen.scene.lock import lock
from adagen.tomlfile import read_text

_KEYS = ("closed_loop", "type", "joint_name", "joint_type", "name_mot")
_KINDS = {"6d": "weld", "3d": "point"}
_GROUND = "universe"
"""What Pinocchio calls the frame of the ground."""
_UNIVERSAL = re.compile(r"UJOINT_(?!(.)\1)([XYZ]{2})")
"""A universal joint, with the axes of its two hinges."""


@dataclass(frozen=True)
class _Word:
    """A word of the file, and its line."""

    word: str
    line: int


@dataclass(frozen=True)
class _Pair:
    first: _Word
    second: _Word
    kind: str

    @property
    def name(self) -> str:
        return f"{self.first.word}-{self.second.word}"


@dataclass(frozen=True)
class Pairs:
    """What a file of frame pairs says; names are not yet looked up in a robot.

    Attributes:
        file: its path.
        pairs: of frames.
        kinds: joints, each with the kind that it is instead of the URDF's.
    """

    file: str
    pairs: tuple[_Pair, ...]
    kinds: tuple[tuple[_Word, _Word], ...]

    def error(self, message: str, at: _Word) -> InputError:
        """Return (not raise) a refusal of what the file says."""
        return InputError(message, self.file, at.line)

    def mentions(self) -> list[str]:
        """Return lines on what was read, for people."""
        loops = [f'"{pair.name}" ({pair.kind})' for pair in self.pairs]
        joints = [f'"{name.word}" ({kind.word})' for name, kind in self.kinds]
        lines = [f"{self.file}: loops: {len(loops)}, read: {', '.join(loops)}"] * bool(loops)
        if joints:
            lines.append(f"{self.file}: joints of other kinds: {', '.join(joints)}")
        return lines


def read_pairs(path: Path | str) -> Pairs:
    """Read a file of frame pairs, strictly.

    Raises:
        InputError: it cannot be read, is not YAML, or has an unknown key or type; with the line.
    """
    file, text = str(path), read_text(path, "a file of frame pairs (YAML)")
    try:
        root = yaml.compose(text, Loader=yaml.SafeLoader)
    except yaml.MarkedYAMLError as fault:
        at = fault.problem_mark
        line = None if at is None else at.line + 1
        raise InputError(f"not YAML: {fault.problem or fault.context}", file, line) from None
    except (yaml.YAMLError, RecursionError, ValueError) as fault:
        raise InputError(f"not YAML: {str(fault).splitlines()[0]}", file) from None
    return _Reader(file).pairs(root)


class _Reader:
    """Reads the nodes of a document, which know their lines."""

    def __init__(self, file: str) -> None:
        self._file = file

    def _fail(self, message: str, node: Any) -> InputError:
        return InputError(message, self._file, node.start_mark.line + 1)

    def pairs(self, root: Any) -> Pairs:
        if not isinstance(root, yaml.MappingNode):
            message = "no mapping with closed_loop: give a file of frame pairs (YAML)"
            raise InputError(message, self._file)
        found: dict[str, Any] = {}
        for key, value in root.value:
            if key.value not in _KEYS:
                hint = nearest(str(key.value), _KEYS) or f"; known: {', '.join(_KEYS)}"
                raise self._fail(f"unknown key '{key.value}'{hint}", key)
            if key.value in found:
                raise self._fail(f"'{key.value}' is given twice", key)
            found[key.value] = value
        ends = [self._pair(node) for node in self._list(found, "closed_loop")]
        words = self._words(found, "type")
        if "type" in found and len(words) != len(ends):
            raise self._fail(f"{len(words)} types for {len(ends)} pairs of frames", found["type"])
        kinds = [self._kind(word) for word in words] or [_KINDS["6d"]] * len(ends)
        result = [_Pair(*pair, kind) for pair, kind in zip(ends, kinds, strict=True)]
        for k, pair in enumerate(result):
            if pair.name in [other.name for other in result[:k]]:
                raise InputError(f"pair '{pair.name}' is given twice", self._file, pair.first.line)
        return Pairs(self._file, tuple(result), self._joints(found))

    def _joints(self, found: Mapping[str, Any]) -> tuple[tuple[_Word, _Word], ...]:
        names, kinds = self._words(found, "joint_name"), self._words(found, "joint_type")
        if len(names) != len(kinds):
            raise self._fail(
                f"{len(names)} names in joint_name, {len(kinds)} in joint_type",
                found.get("joint_type", found.get("joint_name")),
            )
        return tuple(zip(names, kinds, strict=True))

    def _kind(self, entry: _Word) -> str:
        kind = _KINDS.get(entry.word.lower())
        if kind is None:
            message = f"unknown type '{entry.word}' of a pair: known are 6d and 3d"
            raise InputError(message, self._file, entry.line)
        return kind

    def _pair(self, node: Any) -> tuple[_Word, _Word]:
        if not isinstance(node, yaml.SequenceNode) or len(node.value) != 2:
            raise self._fail("closed_loop needs pairs of frames: [[frame1, frame2], ...]", node)
        first, second = (self._word(each) for each in node.value)
        return first, second

    def _words(self, found: Mapping[str, Any], key: str) -> list[_Word]:
        return [self._word(node) for node in self._list(found, key)]

    def _list(self, found: Mapping[str, Any], key: str) -> Sequence[Any]:
        node = found.get(key)
        if node is None or (isinstance(node, yaml.ScalarNode) and node.value in ("", "null")):
            return []
        if not isinstance(node, yaml.SequenceNode):
            raise self._fail(f"{key} needs a list", node)
        values: Sequence[Any] = node.value
        return values

    def _word(self, node: Any) -> _Word:
        if not isinstance(node, yaml.ScalarNode) or not node.value:
            raise self._fail("a name is expected here", node)
        return _Word(node.value, node.start_mark.line + 1)


def with_pairs(model: Model, children: Mapping[str, str], pairs: Pairs) -> Model:
    """Return a robot closed by frame pairs, and with joints of the kinds that their file says.

    Args:
        model: the robot.
        children: the child link of each joint; those of moving joints may be left out.
        pairs: what closes it.

    Raises:
        InputError: a name is none of the robot's, or two of it; a joint cannot be of a kind; a loop
            cannot close.
    """
    moving = {joint.name: model.links[j + 1].name for j, joint in enumerate(model.joints)}
    below = {**children, **moving}
    known = {loop.name for loop in model.loops}
    robot = _of_other_kinds(model, below, pairs)
    hinges = {joint.name: robot.links[j + 1].name for j, joint in enumerate(robot.joints)}
    below, at = {**below, **hinges}, places(robot)

    def end(entry: _Word) -> LoopEnd:
        name, link = entry.word, below.get(entry.word)
        if name in at and link not in (None, name):
            raise pairs.error(
                f"'{name}' is a link, and a joint whose child link is '{link}': rename one", entry
            )
        if name in at or link in at:
            return LoopEnd(name if name in at else str(link))
        if name == _GROUND:
            return LoopEnd(WORLD)
        hint = nearest(name, {*at, *below})
        raise pairs.error(f"'{name}' is neither a link nor a joint of the robot{hint}", entry)

    for pair in pairs.pairs:
        if pair.name in known:
            raise pairs.error(f"the robot has a loop '{pair.name}' already", pair.first)
    loops = [
        NamedLoop(pair.name, pair.kind, end(pair.first), end(pair.second)) for pair in pairs.pairs
    ]
    lines = {pair.name: pair.first for pair in pairs.pairs}

    def refusal(loop: Any, why: str) -> InputError:
        message = f"loop '{loop.name}' {why}"
        return pairs.error(message, lines[loop.name]) if loop.name in lines else InputError(message)

    joints = {joint.name: j for j, joint in enumerate(robot.joints)}
    whole = closed(robot, loops, (), at.__getitem__, joints.__getitem__)
    return with_loops_checked(whole, refusal)


def _of_other_kinds(model: Model, below: Mapping[str, str], pairs: Pairs) -> Model:
    """Make joints balls or universal joints, or fix them where they are at zero."""
    index = {joint.name: j for j, joint in enumerate(model.joints)}
    joints, fixed, crosses = list(model.joints), dict[int, Sequence[float]](), dict[int, str]()
    for name, kind in pairs.kinds:
        if name.word not in below:
            hint = nearest(name.word, below)
            raise pairs.error(f"'{name.word}' is not a joint of the robot{hint}", name)
        word, j = kind.word.upper(), index.get(name.word)
        universal = _UNIVERSAL.fullmatch(word)
        now = "fixed" if j is None else joints[j].kind.name
        if now == {"SPHERICAL": "spherical", "FIXED": "fixed"}.get(word):
            continue
        known = universal or word in ("SPHERICAL", "FIXED")
        if j is None or now != "revolute" or not known:
            raise pairs.error(
                f"joint '{name.word}' is {now}, and {kind.word} is asked for: only revolute joints "
                "can be made SPHERICAL, FIXED or UJOINT_XY (any two axes) here; write what it is "
                "in the URDF", kind
            )  # fmt: skip
        if joints[j].mimic is not None or any(
            other.mimic is not None and other.mimic.source == j for other in joints
        ):
            raise pairs.error(f"joint '{name.word}' mimics or is mimicked: leave out mimic", name)
        if any(j == tied for coupling in model.couplings for tied, _ in coupling.terms):
            raise pairs.error(f"joint '{name.word}' is coupled: it has to stay {now}", name)
        if universal:
            crosses[j] = universal[2]
        elif word == "FIXED":
            fixed[j] = (0.0,)
        else:
            joints[j] = replace(
                joints[j], kind=SPHERICAL, axis=np.array([0.0, 0.0, 1.0]), passive=Passive()
            )
    robot = replace(model, joints=tuple(joints))
    if fixed:
        robot = lock(robot, fixed)
        left = {joint.name: j for j, joint in enumerate(robot.joints)}
        crosses = {left[joints[j].name]: axes for j, axes in crosses.items()}
    return with_universal_joints(robot, crosses) if crosses else robot


AXES = "XYZ"


def with_universal_joints(model: Model, crosses: Mapping[int, str]) -> Model:
    """Return a robot in which some joints are universal.

    A joint NAME becomes two, NAME_X about the first axis of its frame, NAME_Y about the second; the
    cross between them is a link NAME_cross, whose frame is its child link's at rest.

    Args:
        model: the robot; its wrenches and outputs are not yet known.
        crosses: for each joint two different letters of ``AXES``: the hinges' axes in its frame.
    """
    before = [sum(j < k for j in crosses) for k in range(len(model.links))]  # by link
    links, joints = [model.links[0]], list[Joint]()
    for j, joint in enumerate(model.joints):
        parent = joint.parent + before[joint.parent]
        mimic = joint.mimic
        if mimic is not None:
            mimic = replace(mimic, source=mimic.source + before[mimic.source + 1])
        last = replace(joint, parent=parent, mimic=mimic)
        if j in crosses:
            first, last = _hinges(last, crosses[j], len(links))
            joints.append(first)
            links.append(Link(f"{joint.name}_cross", Inertia.zero()))
        joints.append(last)
        links.append(model.links[j + 1])
    return replace(
        model,
        links=tuple(links),
        joints=tuple(joints),
        loops=tuple(
            replace(
                loop,
                link1=loop.link1 + before[loop.link1],
                link2=loop.link2 + before[loop.link2],
            )
            for loop in model.loops
        ),
        couplings=tuple(
            replace(one, terms=tuple((j + before[j + 1], factor) for j, factor in one.terms))
            for one in model.couplings
        ),
    )


def _hinges(joint: Joint, letters: str, cross: int) -> tuple[Joint, Joint]:
    """Return the two hinges of a joint; the link between them has a number."""
    first, second = (np.eye(3)[AXES.index(letter)] for letter in letters)
    hinge = replace(joint, kind=REVOLUTE, passive=Passive())
    return (
        replace(hinge, name=f"{joint.name}_{letters[0]}", axis=first),
        replace(
            hinge,
            name=f"{joint.name}_{letters[1]}",
            parent=cross,
            rotation=np.eye(3),
            translation=np.zeros(3),
            axis=second,
        ),
    )
