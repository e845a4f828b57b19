"""Passive joint forces of an MJCF: rotors always, damping and friction if a scene asks for them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from typing import Any

from adagen.mjcf.compiled import BALL, FREE, Compiled
from adagen.model import FLOATING, SPHERICAL, Passive
from adagen.urdf.notes import Notes
from adagen.urdf.passive import SEVERAL, tell_dropped

Decided = Callable[[str, str], bool]

_SEVERAL = {BALL: SPHERICAL, FREE: FLOATING}
"""Joints of several degrees of freedom."""


def passives(
    robot: Compiled, wanted: Collection[str], decided: Decided, notes: Notes
) -> dict[int, Passive]:
    """Return the passive forces of each joint, by MuJoCo's numbers, and warn about the rest.

    Args:
        robot: the compiled file.
        wanted: some of "damping", "friction".
        decided: of an effect and a joint's name, whether what the model holds is what was asked
            for, so that there is nothing to warn of.
        notes: takes the warnings.
    """
    result: dict[int, Passive] = {}
    dropped: dict[str, dict[str, int | None]] = {}
    unfit: dict[str, dict[str, int | None]] = {}
    for j, name in enumerate(robot.joints):
        kind, held = _SEVERAL.get(int(robot.model.jnt_type[j])), {}
        for effect, value in _effects(robot, j):
            field = effect.replace(" ", "_")
            if kind is not None and not kind.takes(field):
                unfit.setdefault(effect, {})[name] = robot.lines.joints.get(name)
            elif effect in wanted or effect == "rotor inertia":
                held[field] = value
            elif not decided(effect, name):
                dropped.setdefault(effect, {})[name] = robot.lines.joints.get(name)
        if held:
            result[j] = Passive(**held)
    tell_dropped(dropped, notes)
    tell_dropped(unfit, notes, why=SEVERAL)
    return result


_SWITCHES = {
    "damping": ("DAMPER",),
    "damping of higher order": ("DAMPER",),
    "stiffness": ("SPRING",),
    "stiffness of higher order": ("SPRING",),
    "friction": ("FRICTIONLOSS", "CONSTRAINT"),
}
"""Flags of <option> that switch off an effect of all joints."""


def _effects(robot: Compiled, joint: int) -> Iterator[tuple[str, float]]:
    """Name the passive forces of a joint that the file leaves on, with their sizes; SI units."""
    model = robot.model
    dof = int(model.jnt_dofadr[joint])
    found = {
        "damping": float(model.dof_damping[dof]) + robot.of_drives(joint, "damping"),
        "friction": float(model.dof_frictionloss[dof]),
        "stiffness": _first(model.jnt_stiffness[joint]),
        "rotor inertia": float(model.dof_armature[dof]) + robot.of_drives(joint, "armature"),
        "damping of higher order": max(
            _largest(model, "dof_dampingpoly", dof), robot.of_drives(joint, "dampingpoly")
        ),
        "stiffness of higher order": _largest(model, "jnt_stiffnesspoly", joint),
    }
    for effect, value in found.items():
        if value and not any(map(robot.disabled, _SWITCHES.get(effect, ()))):
            yield effect, value


def _first(value: Any) -> float:
    return float(value if getattr(value, "ndim", 0) == 0 else value[0])


def _largest(model: Any, name: str, row: int) -> float:
    table = getattr(model, name, None)
    return 0.0 if table is None else float(abs(table[row]).max(initial=0.0))
