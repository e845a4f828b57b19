"""From a scene file to a Scene: known keys, checked types, and lines in error messages."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from adagen.errors import InputError
from adagen.jsonfile import nearest
from adagen.model import LOOP_WORDS, LoopEnd, NamedCoupling, NamedLoop
from adagen.scene.types import EFFECTS, OUTPUTS, URDF, Base, JointScene, PointMass, Scene
from adagen.tomlfile import Source, parse_toml, read_text

LARGEST = 1e40
"""SI units; products of numbers up to this stay far below overflow, as in a URDF."""

_KINDS = ("fixed", "floating", "planar", "prismatic", "revolute", "spherical")
_AXIAL = ("planar", "prismatic", "revolute")
_SIGNED = ("rest",)
_LOOP_KEYS = (
    "name", "kind", "link1", "origin1", "link2", "origin2", "axis", "axis2", "tolerance",
)  # fmt: skip
_COUPLING_KEYS = ("name", "joint", "other", "ratio", "offset", "terms", "tolerance")
_Path = tuple[str | int, ...]
Triple = tuple[float, float, float]


def read_scene(path: Path | str) -> Scene:
    """Read a scene file (docs/reference/scenes.md), strictly.

    Raises:
        InputError: it cannot be read, is not TOML, has an unknown key or a value that is none;
            the message gives file and line, and the nearest name that would be known.
    """
    text = read_text(path, "a scene file (TOML)")
    source, document = parse_toml(text, str(path), "a scene")
    reader = _Reader(source)
    reader.known(document, _FIELDS, "key")
    given = {key: _FIELDS[key](reader, value, (key,)) for key, value in document.items()}
    return Scene(source, **given.pop("outputs", {}), **given)


class _Reader:
    """Reads values of the types that scenes have."""

    def __init__(self, source: Source) -> None:
        self.source = source

    def fail(self, message: str, path: _Path) -> InputError:
        return self.source.error(message, *path)

    def known(
        self, table: Mapping[str, Any], keys: Iterable[str], what: str, *path: str | int
    ) -> None:
        for key in table:
            if key not in keys:
                names = ", ".join(sorted(keys))
                hint = nearest(key, keys) or f"; known: {names}"
                raise self.fail(f"unknown {what} '{key}'{hint}", (*path, key))

    def table(self, value: Any, path: _Path) -> dict[str, Any]:
        if not isinstance(value, dict):
            raise self.fail(f"'{path[-1]}' is not a table", path)
        return value

    def number(self, value: Any, path: _Path, *, signed: bool = True) -> float:
        what = _told(path)
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.fail(f"{what}: {value!r:.40} is not a number", path)
        if not abs(value) <= LARGEST:
            raise self.fail(f"{what}: {value!r:.40} is not a finite number to compute with", path)
        if value < 0 and not signed:
            raise self.fail(f"{what}: {value!r:.40} is negative", path)
        return float(value)

    def outputs(self, value: Any, path: _Path) -> dict[str, tuple[str, ...]]:
        table = self.table(value, path)
        self.known(table, OUTPUTS, "output", *path)
        return {key: self.names(names, (*path, key)) for key, names in table.items()}

    def boolean(self, value: Any, path: _Path) -> bool:
        if not isinstance(value, bool):
            raise self.fail(f"{_told(path)}: {value!r:.40} is neither true nor false", path)
        return value

    def numbers(self, value: Any, path: _Path, count: int | None = None) -> tuple[float, ...]:
        if not isinstance(value, list) or (count is not None and len(value) != count):
            need = "a list of numbers" if count is None else f"{count} numbers in a list"
            raise self.fail(f"{_told(path)} needs {need}", path)
        return tuple(self.number(x, path) for x in value)

    def three(self, value: Any, path: _Path) -> tuple[float, float, float]:
        x, y, z = self.numbers(value, path, 3)
        return x, y, z

    def text(self, value: Any, path: _Path) -> str:
        if not isinstance(value, str) or not value:
            raise self.fail(f"{_told(path)}: {value!r:.40} is not a name", path)
        return value

    def names(self, value: Any, path: _Path) -> tuple[str, ...]:
        if not isinstance(value, list):
            raise self.fail(f"{_told(path)} needs a list of names", path)
        found = tuple(self.text(name, path) for name in value)
        for name in found:
            if found.count(name) > 1:
                raise self.fail(f"{_told(path)} names '{name}' twice; keep one", path)
        return found

    def base(self, value: Any, path: _Path) -> Base:
        if isinstance(value, str):
            kind, table = value, {}
        else:
            table = self.table(value, path)
            self.known(table, ("kind", "axis"), "key", *path)
            if "kind" not in table:
                raise self.fail("base needs a kind, one of " + ", ".join(_KINDS), path)
            kind = self.text(table["kind"], (*path, "kind"))
        if kind not in _KINDS:
            hint = nearest(kind, _KINDS) or f"; known: {', '.join(_KINDS)}"
            raise self.fail(f"unknown base '{kind}'{hint}", path)
        if "axis" not in table:
            if kind in ("prismatic", "revolute"):
                raise self.fail(f"a {kind} base needs an axis, three numbers", path)
            return Base(kind)
        if kind not in _AXIAL:
            raise self.fail(f"a {kind} base has no axis: leave it out", (*path, "axis"))
        axis = self.three(table["axis"], (*path, "axis"))
        if math.hypot(*axis) < 1e-6:
            raise self.fail("the axis has length zero: give it a direction", (*path, "axis"))
        return Base(kind, axis)

    def lock(self, value: Any, path: _Path) -> dict[str, tuple[float, ...]]:
        result = {}
        for name, at in self.table(value, path).items():
            place = (*path, name)
            result[name] = (
                self.numbers(at, place) if isinstance(at, list) else (self.number(at, place),)
            )
        return result

    def effect(self, value: Any, path: _Path) -> float | str:
        if value == URDF:
            return URDF
        if isinstance(value, str):
            raise self.fail(f"{_told(path)}: '{value:.40}' is neither a number nor '{URDF}'", path)
        return self.number(value, path, signed=False)

    def speed(self, value: Any, path: _Path) -> float:
        speed = self.number(value, path)
        if not speed > 1e-40:
            raise self.fail(f"{_told(path)}: must be more than 0, not {value!r:.40}", path)
        return speed

    def joints(self, value: Any, path: _Path) -> dict[str, JointScene]:
        result = {}
        for name, entry in self.table(value, path).items():
            table = self.table(entry, (*path, name))
            self.known(table, (*EFFECTS, "prescribed"), f"key of joint '{name}'", *path, name)
            prescribed = table.get("prescribed", False)
            effects = {
                key: self.speed(x, (*path, name, key))
                if key == "friction_speed"
                else self.number(x, (*path, name, key), signed=key in _SIGNED)
                for key, x in table.items()
                if key != "prescribed"
            }
            if "rest" in effects and "stiffness" not in effects:
                raise self.fail(
                    f"joint '{name}' has a rest but no stiffness", (*path, name, "rest")
                )
            result[name] = JointScene(
                effects, self.boolean(prescribed, (*path, name, "prescribed"))
            )
        return result

    def point_masses(self, value: Any, path: _Path) -> tuple[PointMass, ...]:
        if not isinstance(value, list):
            raise self.fail("write [[point_masses]], a table for each mass", path)
        result = []
        for k, entry in enumerate(value):
            place = (*path, k)
            table = self.table(entry, place)
            self.known(table, ("link", "mass", "position"), "key of a point mass", *place)
            for key in ("link", "mass"):
                if key not in table:
                    raise self.fail(f"this point mass has no {key}", place)
            mass = self.number(table["mass"], (*place, "mass"), signed=False)
            if mass == 0.0:
                raise self.fail("this point mass has no mass: leave it out", (*place, "mass"))
            position = self.three(table.get("position", [0, 0, 0]), (*place, "position"))
            result.append(PointMass(self.text(table["link"], (*place, "link")), mass, position))
        return tuple(result)

    def tables(self, value: Any, path: _Path) -> list[tuple[dict[str, Any], _Path]]:
        if not isinstance(value, list):
            raise self.fail(f"write [[{path[-1]}]], a table for each", path)
        return [(self.table(entry, (*path, k)), (*path, k)) for k, entry in enumerate(value)]

    def need(self, table: Mapping[str, Any], keys: Iterable[str], what: str, at: _Path) -> None:
        for key in keys:
            if key not in table:
                raise self.fail(f"this {what} has no {key}", at)

    def direction(self, table: Mapping[str, Any], key: str, path: _Path) -> Triple:
        axis = self.three(table[key], (*path, key))
        if math.hypot(*axis) < 1e-6:
            raise self.fail("the axis has length zero: give it a direction", (*path, key))
        return axis

    def tolerance(self, table: Mapping[str, Any], path: _Path) -> dict[str, Any]:
        if "tolerance" not in table:
            return {}
        return {"tolerance": self.speed(table["tolerance"], (*path, "tolerance"))}

    def loop_end(self, table: Mapping[str, Any], end: str, path: _Path) -> LoopEnd:
        place = (*path, f"origin{end}")
        origin = self.table(table.get(f"origin{end}", {}), place)
        self.known(origin, ("xyz", "rpy"), "key of an origin", *place)
        pose = {key: self.three(value, (*place, key)) for key, value in origin.items()}
        return LoopEnd(self.text(table[f"link{end}"], (*path, f"link{end}")), **pose)

    def loops(self, value: Any, path: _Path) -> tuple[NamedLoop, ...]:
        result = []
        for k, (table, place) in enumerate(self.tables(value, path)):
            self.known(table, _LOOP_KEYS, "key of a loop", *place)
            self.need(table, ("kind", "link1", "link2"), "loop", place)
            word = self.text(table["kind"], (*place, "kind"))
            if word not in LOOP_WORDS:
                hint = nearest(word, LOOP_WORDS) or f"; known: {', '.join(LOOP_WORDS)}"
                raise self.fail(f"unknown kind of loop '{word}'{hint}", (*place, "kind"))
            axes = ("axis", "axis2")[: LOOP_WORDS[word].axes]
            given = f" '{self.text(table['name'], (*place, 'name'))}'" if "name" in table else ""
            self.need(table, axes, f"{word} loop{given}", place)
            for key in {"axis", "axis2"}.intersection(table).difference(axes):
                raise self.fail(f"a {word} loop has no {key}: leave it out", (*place, key))
            loop = NamedLoop(
                self.text(table.get("name", f"loop {k + 1}"), (*place, "name")),
                word,
                self.loop_end(table, "1", place),
                self.loop_end(table, "2", place),
                **self.tolerance(table, place),
            )
            if "axis" in axes:
                loop = replace(loop, axis=self.direction(table, "axis", place))
            if "axis2" in axes:
                loop = replace(loop, axis2=self.direction(table, "axis2", place))
            result.append(loop)
        self.unlike([loop.name for loop in result], "loops", path)
        return tuple(result)

    def unlike(self, names: Sequence[str], what: str, path: _Path) -> None:
        for k, name in enumerate(names):
            if name in names[:k]:
                raise self.fail(f"two {what} are named '{name}': rename one", (*path, k))

    def couplings(self, value: Any, path: _Path) -> tuple[NamedCoupling, ...]:
        result = []
        for k, (table, place) in enumerate(self.tables(value, path)):
            self.known(table, _COUPLING_KEYS, "key of a coupling", *place)
            terms = self.terms(table, place)
            offset = self.number(table.get("offset", 0), (*place, "offset"))
            name = self.text(table.get("name", f"coupling {k + 1}"), (*place, "name"))
            result.append(NamedCoupling(name, terms, offset, **self.tolerance(table, place)))
        self.unlike([coupling.name for coupling in result], "couplings", path)
        return tuple(result)

    def terms(self, table: Mapping[str, Any], path: _Path) -> tuple[tuple[str, float], ...]:
        """The terms of a coupling: joints with their factors, or joint = ratio * other."""
        if "terms" in table:
            for key in {"joint", "other", "ratio"}.intersection(table):
                raise self.fail(f"this coupling has terms: leave {key} out", (*path, key))
            place = (*path, "terms")
            given = self.table(table["terms"], place)
            if not given:
                raise self.fail("this coupling has no terms", place)
            terms = tuple((name, self.number(x, (*place, name))) for name, x in given.items())
            if not any(factor for _, factor in terms):
                raise self.fail("all terms of this coupling are zero", place)
            return terms
        self.need(table, ("joint", "other", "ratio"), "coupling", path)
        joint, other = (self.text(table[key], (*path, key)) for key in ("joint", "other"))
        if joint == other:
            raise self.fail(f"joint '{joint}' is coupled to itself", (*path, "other"))
        return (joint, 1.0), (other, -self.number(table["ratio"], (*path, "ratio")))


def _told(path: _Path) -> str:
    return ".".join(str(key) for key in path if isinstance(key, str))


_FIELDS: dict[str, Callable[[_Reader, Any, _Path], Any]] = {
    "gravity": _Reader.three,
    "base": _Reader.base,
    "mimic": _Reader.boolean,
    "lock": _Reader.lock,
    "lock_all_but": _Reader.names,
    "keep": _Reader.names,
    "accelerations": _Reader.names,
    "outputs": _Reader.outputs,
    "at_rest": _Reader.boolean,
    "forces": _Reader.names,
    "damping": _Reader.effect,
    "friction": _Reader.effect,
    "friction_speed": _Reader.speed,
    "joints": _Reader.joints,
    "point_masses": _Reader.point_masses,
    "loops": _Reader.loops,
    "couplings": _Reader.couplings,
}

KEYS = tuple(_FIELDS)
"""What a scene file can say, at its top."""
