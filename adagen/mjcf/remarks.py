"""Parts of an MJCF that are not modelled: refused if they connect bodies, else reported."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from adagen.mjcf.compiled import HINGE, SLIDE, Compiled
from adagen.urdf.notes import Notes, quoted

_JOINT = 2
"""mjEQ_JOINT"""
_KINDS = ("connect", "weld", "joint", "tendon")
_TENDON_EFFECTS = (
    "stiffness", "stiffnesspoly", "damping", "dampingpoly", "armature", "frictionloss"
)  # fmt: skip

_DRIVE_EFFECTS = ("armature", "damping", "dampingpoly")
"""What a tendon has of its actuators."""


def refuse_closed(robot: Compiled, notes: Notes) -> None:
    """Refuse what makes another machine of the tree of bodies.

    Raises:
        InputError: there is a flex, a tendon that pulls by itself, or an equality constraint that
            is no coupling of two joints; the message names it.
    """
    model = robot.model
    if model.nflex:
        raise notes.error(
            f"<flex> {quoted([robot.named('FLEX', 0)])}: soft bodies are not modelled"
        )
    for which in range(model.ntendon):
        found = [name for name in _TENDON_EFFECTS if _has(model, f"tendon_{name}", which)]
        found += [name for name in _DRIVE_EFFECTS if robot.of_drives(which, name, tendon=True)]
        if found:
            raise notes.error(
                f"tendon {quoted([robot.named('TENDON', which)])} has {found[0]}: tendons are not "
                "modelled; remove it, or what makes it pull by itself"
            )
    for which in active_equalities(robot):
        kind = int(model.eq_type[which])
        if kind != _JOINT:
            name = _KINDS[kind] if kind < len(_KINDS) else "equality"
            raise notes.error(
                f"<{name}> {quoted([robot.named('EQUALITY', which)])} closes a loop as a soft "
                "constraint, which is not modelled: remove it, and close the loop exactly by "
                "[[loops]] or [[couplings]] in a scene"
            )


def active_equalities(robot: Compiled) -> Iterator[int]:
    """Yield the equality constraints that hold from the start."""
    if not (robot.disabled("EQUALITY") or robot.disabled("CONSTRAINT")):
        yield from (k for k in range(robot.model.neq) if robot.model.eq_active0[k])


def remark(robot: Compiled, notes: Notes) -> None:
    """Warn of forces that are not modelled, and record what has no influence, with its number."""
    model = robot.model
    carried = [robot.bodies[k] for k in range(model.nbody) if model.body_gravcomp[k]]
    if carried:
        notes.warn(f"gravity compensation of {_bodies(carried)} is not modelled")
    if model.opt.density or model.opt.viscosity:
        notes.warn("forces of the medium (density, viscosity) are not modelled")
    if model.nplugin:
        plugins = "1 plugin is" if model.nplugin == 1 else f"{model.nplugin} plugins are"
        notes.warn(f"{plugins} not modelled")
    _warn_of_inputs(robot, notes)
    limited = int(sum(map(bool, model.jnt_limited)))
    for count, what in (
        (limited, "joint limits"),
        (model.ntendon, "tendons that do not pull by themselves"),
        (model.neq - len(list(active_equalities(robot))), "equality constraints that are off"),
        (model.nmocap, "mocap bodies, held where they are"),
        (model.nsensor, "sensors"),
        (model.nsite, "sites"),
        (model.ncam, "cameras"),
        (model.nlight, "lights"),
        (model.nkey, "keyframes"),
    ):
        if count:
            notes.ignore(f"{what}: {count}, not modelled")


def _warn_of_inputs(robot: Compiled, notes: Notes) -> None:
    """Warn of contacts and actuators: torques and outer forces come with each state."""
    model = robot.model
    touching = int(((model.geom_contype | model.geom_conaffinity) != 0).sum())
    found = []
    if touching > 1 and not (robot.disabled("CONTACT") or robot.disabled("CONSTRAINT")):
        found.append(f"contacts of {touching} geoms")
    if model.nu:
        found.append(f"{model.nu} actuator{'s' * (model.nu > 1)}")
    if found:
        notes.warn(f"{' and '.join(found)} not modelled: torques are given with each state")


def _bodies(names: list[str]) -> str:
    return (
        f"body {quoted(names)}" if len(names) == 1 else f"{len(names)} bodies ({quoted(names, 3)})"
    )


def _has(model: Any, name: str, which: int) -> bool:
    table = getattr(model, name, None)
    return table is not None and bool(abs(table[which]).max() > 0.0)


def couplings(robot: Compiled, slaved: bool, notes: Notes) -> dict[int, tuple[int, float, float]]:
    """Return what each coupled joint follows: joint, multiplier, offset, by MuJoCo's numbers.

    Args:
        robot: the compiled file, whose equality constraints are couplings of joints.
        slaved: whether the user wants joints slaved.
        notes: makes the refusals.

    Raises:
        InputError: there is a coupling and the user does not want it, or it is none of two joints
            of one degree of freedom by a straight line.
    """
    follows: dict[int, tuple[int, float, float]] = {}
    model = robot.model
    for which in active_equalities(robot):
        joint, source = int(model.eq_obj1id[which]), int(model.eq_obj2id[which])
        where = f"<joint> {quoted([robot.named('EQUALITY', which)])} of <equality>"
        data = [float(x) for x in model.eq_data[which][:5]]
        if source < 0:
            raise notes.error(
                f'{where} holds joint "{robot.joints[joint]}": remove it, and lock the joint in a '
                "scene"
            )
        pair = f'joints "{robot.joints[joint]}" and "{robot.joints[source]}"'
        if not slaved:
            raise notes.error(
                f"{where} couples {pair}: use --mimic to make the first follow, or remove it"
            )
        straight = all(model.jnt_type[j] in (SLIDE, HINGE) for j in (joint, source))
        if any(data[2:]) or joint in follows or not straight:
            raise notes.error(
                f"{where} couples {pair} as no <mimic> does: one straight line for each joint, of "
                "hinges and slides"
            )
        here, there = (float(model.qpos0[model.jnt_qposadr[j]]) for j in (joint, source))
        follows[joint] = source, data[1], here + data[0] - data[1] * there
    return {joint: _followed(robot, joint, follows, notes) for joint in follows}


def _followed(
    robot: Compiled, joint: int, follows: dict[int, tuple[int, float, float]], notes: Notes
) -> tuple[int, float, float]:
    """Return the final source of a joint, through joints that follow others."""
    source, multiplier, offset = follows[joint]
    passed = {joint}
    while source in follows:
        if source in passed:
            raise notes.error(f'joint "{robot.joints[joint]}" follows itself: remove a coupling')
        passed.add(source)
        source, factor, shift = follows[source]
        multiplier, offset = multiplier * factor, offset + multiplier * shift
    return source, multiplier, offset
