"""A plan as JSON, one step a line, and back."""

from __future__ import annotations

import json
import types
from collections.abc import Iterable
from dataclasses import fields, is_dataclass
from typing import Any, Union, get_args, get_origin, get_type_hints

from adagen.plan.steps import Step
from adagen.plan.types import Plan

FORMAT = 1
_STEPS = {step.__name__: step for step in get_args(Step)}
_ENCODER = json.JSONEncoder(allow_nan=False)


def plan_to_json(plan: Plan) -> str:
    """Return a plan as JSON: numbers exact, one link, joint, step and message a line."""
    lines = [f'"format": {FORMAT}']
    for field in _said(plan):
        value = getattr(plan, field.name)
        if field.name == "processes":
            lines.append(f'"processes": [\n{_processes(plan)}\n]')
        elif field.name == "line":
            lines.append(f'"line": {_steps(value)}')
        elif field.name in (
            "links",
            "joints",
            "messages",
            "wrenches",
            "loops",
            "couplings",
            "outputs",
        ):
            lines.append(f'"{field.name}": {_lines(_encode(item) for item in value)}')
        else:
            lines.append(f'"{field.name}": {_dump(_encode(value))}')
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _processes(plan: Plan) -> str:
    parts = []
    for process in plan.processes:
        joints = ", ".join(
            f'"{name}": {_dump(list(getattr(process, name)))}'
            for name in ("reads", "owns", "shares")
        )
        more = f', "recovery": {_steps(process.recovery)}' if process.recovery else ""
        if process.others:
            more += f', "others": [{", ".join(map(_steps, process.others))}]'
        if process.spares:
            more += f', "spares": {_dump(list(process.spares))}'
        parts.append(f'{{{joints}, "steps": {_steps(process.steps)}{more}}}')
    return ",\n".join(parts)


def _steps(steps: Iterable[Step]) -> str:
    return _lines({"step": type(step).__name__, **_encode(step)} for step in steps)


def _lines(items: Any) -> str:
    return "[" + ",".join("\n  " + _dump(item) for item in items) + "]"


def _dump(value: Any) -> str:
    return _ENCODER.encode(value)


def _said(value: Any) -> list[Any]:
    """Return the fields of a dataclass value, without optional ones that have their default."""
    return [
        field
        for field in fields(value)
        if not (field.metadata.get("optional") and getattr(value, field.name) == field.default)
    ]


def _encode(value: Any) -> Any:
    if isinstance(value, tuple):
        return [_encode(item) for item in value]
    if is_dataclass(value):
        return {field.name: _encode(getattr(value, field.name)) for field in _said(value)}
    return value


def plan_from_json(text: str) -> Plan:
    """Return the plan that ``plan_to_json`` wrote.

    Raises:
        ValueError: it is not such a plan.
    """
    data = json.loads(text)
    if not isinstance(data, dict) or data.pop("format", None) != FORMAT:
        raise ValueError(f"not a plan of format {FORMAT}")
    data.pop("made", None)  # from what, and by which command
    plan = _decode(Plan, data)
    assert isinstance(plan, Plan)
    return plan


def _decode(kind: Any, data: Any) -> Any:
    """Return data as a value of a type made of dataclasses, tuples, unions and plain values."""
    if kind == Step:
        return _decode(_STEPS[data["step"]], {k: v for k, v in data.items() if k != "step"})
    if get_origin(kind) in (Union, types.UnionType):
        if data is None:
            return None
        return _decode(next(k for k in get_args(kind) if k is not types.NoneType), data)
    if get_origin(kind) is tuple:
        items = get_args(kind)
        if items[-1] is Ellipsis:
            return tuple(_decode(items[0], item) for item in data)
        return tuple(_decode(k, item) for k, item in zip(items, data, strict=True))
    if isinstance(kind, type) and is_dataclass(kind):
        hints = get_type_hints(kind)
        needed = {f.name for f in fields(kind) if not f.metadata.get("optional")}
        if not isinstance(data, dict) or not needed <= set(data) <= set(hints):
            raise ValueError(f"not a {getattr(kind, '__name__', kind)}: {data!r:.80}")
        return kind(**{name: _decode(hints[name], value) for name, value in data.items()})
    return data
