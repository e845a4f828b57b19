"""The scene stage: from a robot and a scene to the reduced robot."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Set
from dataclasses import dataclass, field, replace

import numpy as np
from flint import arb

from adagen.exact import exact, rounded
from adagen.model import (
    BASE,
    FLOATING,
    KINDS,
    REACTION_FORCE,
    WORLD,
    Joint,
    Model,
    Output,
    Part,
    Passive,
    Pose,
    Wrench,
    closed,
    with_loops_checked,
)
from adagen.model.paths import path_to_ground, paths_to_ground
from adagen.scene.lock import lock, select
from adagen.scene.names import Names
from adagen.scene.types import OUTPUTS, Scene


@dataclass(frozen=True)
class Reduction:
    """A robot reduced to what a scene needs.

    Attributes:
        model: the smaller robot.
        full: the robot that it was made from, its loops closed as the scene says.
        locked: joints that were locked, by name, with their configurations.
        dropped: joints that were left out because nothing wanted depends on them.
    """

    model: Model
    full: Model
    locked: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    dropped: tuple[str, ...] = ()

    @property
    def all_left(self) -> bool:
        """Whether the scene takes nothing from the robot; loops, forces and effects only add."""
        model, full = self.model, self.full
        return (
            (len(model.joints), model.nv) == (len(full.joints), full.nv)
            and np.array_equal(model.gravity, full.gravity)
            and not (model.wanted or model.at_rest)
            and not any(joint.prescribed for joint in model.joints)
        )

    def why_missing(self, joint: str) -> str | None:
        """Return in words why a joint of the robot is not in the smaller one; None if it is."""
        if joint in self.locked:
            return "the scene locks it"
        if joint in self.dropped:
            return "nothing that the scene wants depends on it"
        return None


def apply_scene(model: Model, scene: Scene) -> Reduction:
    """Return the robot that a scene needs, and what was left out.

    Args:
        model: the robot, read with a joint ``__base__`` where ``scene.floating`` says so, and with
            mimic joints slaved where it says so.
        scene: what is wanted of it.

    Raises:
        InputError: the scene names what the robot does not have, gives a joint what its kind cannot
            have, or leaves nothing to solve; with the line of the scene file.
    """
    if scene.floating and not model.floating:
        raise ValueError("the robot has to be read on a floating base for this scene")
    names = Names(model, scene)
    robot = _with_base(model, scene)
    robot = _with_effects(robot, scene, names)
    if scene.gravity is not None:
        robot = robot.with_gravity(np.array(scene.gravity) + 0.0)
    robot = _closed(robot, scene, names)
    masses = _masses(scene, names)
    values = _locked(robot, scene, names)
    robot = _without_still_loops(lock(robot, values, masses), scene)
    locked = {model.joints[j].name: tuple(map(float, q)) for j, q in values.items()}
    if not robot.joints:
        raise scene.error(
            "the scene leaves no joint that can move",
            "lock_all_but" if scene.lock_all_but is not None else "lock",
        )
    _check_forces(robot, scene)
    dropped: tuple[str, ...] = ()
    if scene.accelerations is not None:
        robot, dropped = _pruned(robot, scene, locked)
    robot = replace(
        _with_forces(robot, scene), outputs=_outputs(robot, scene, locked), at_rest=scene.at_rest
    )
    if all(joint.prescribed for joint in robot.joints):
        raise scene.error("nothing to solve: every joint's acceleration is prescribed", "joints")
    return Reduction(robot, _closed(model, scene, names), locked, dropped)


def _with_base(model: Model, scene: Scene) -> Model:
    """Restrict what the base joint lets the root link do."""
    if scene.base is None or scene.base.kind in ("fixed", "floating"):
        return model
    axis = exact(scene.base.axis)
    base = replace(
        model.joints[0],
        kind=KINDS[scene.base.kind],
        axis=rounded(axis / axis.dot(axis).sqrt()),
    )
    return replace(model, joints=(base, *model.joints[1:]), floating=False)


def _with_effects(model: Model, scene: Scene, names: Names) -> Model:
    """Give joints their damping, friction, springs and rotor inertias, and prescribe motions."""
    joints = []
    for joint in model.joints:
        entry = scene.joints.get(joint.name)
        effects = {} if joint.kind.nv > 1 else _defaults(scene)
        own = dict(entry.effects) if entry is not None else {}
        names.check_effects(joint, own)
        passive = replace(joint.passive, **{**effects, **own})
        prescribed = entry is not None and entry.prescribed
        if prescribed:
            names.check_prescribed(joint)
            passive = Passive()  # they change its torque, which nobody asks for
        joints.append(replace(joint, passive=passive, prescribed=prescribed))
    return replace(model, joints=tuple(joints))


def _defaults(scene: Scene) -> dict[str, float]:
    """Return the scene's values for every joint of one degree of freedom; the URDF's own."""
    found = {"damping": scene.damping, "friction": scene.friction}
    numbers = {key: value for key, value in found.items() if isinstance(value, float) and value}
    if scene.friction_speed is not None:
        numbers["friction_speed"] = scene.friction_speed
    return numbers


def _closed(model: Model, scene: Scene, names: Names) -> Model:
    """Add the scene's loops and couplings."""
    known = {loop.name for loop in model.loops}
    for k, loop in enumerate(scene.loops):
        if loop.name in known:
            raise scene.error(f"the robot has a loop '{loop.name}': rename this one", "loops", k)
        for end, key in ((loop.end1, "link1"), (loop.end2, "link2")):
            if end.link != WORLD:
                names.link(end.link, "loops", k, key)
    for k, coupling in enumerate(scene.couplings):
        for name, _ in coupling.terms:
            joint = model.joints[names.joint(name, "couplings", k)]
            if joint.kind.nv > 1:
                raise scene.error(
                    f"joint '{name}' is {joint.kind.name}: only joints of one degree of freedom "
                    "can be coupled", "couplings", k
                )  # fmt: skip
    return closed(model, scene.loops, scene.couplings, names.link, names.joint)


def _without_still_loops(model: Model, scene: Scene) -> Model:
    """Leave out loops between links that locked joints hold together, if they are closed.

    Raises:
        InputError: locked joints hold a loop or a coupling open.
    """
    for coupling in model.couplings:
        if not coupling.terms:
            raise scene.error(
                f"coupling '{coupling.name}' cannot hold: its joints are locked, and off by "
                f"{abs(coupling.offset):.2g}", "couplings"
            )  # fmt: skip
    return with_loops_checked(
        model, lambda loop, why: scene.error(f"loop '{loop.name}' {why}", "loops")
    )


def _masses(scene: Scene, names: Names) -> dict[int, list[Part]]:
    result: dict[int, list[Part]] = {}
    for k, point in enumerate(scene.point_masses):
        number, frame = names.link(point.link, "point_masses", k, "link")
        if number == 0:
            raise scene.error(
                f"link '{point.link}' is fixed to the ground: a mass there has no effect",
                "point_masses", k, "link",
            )  # fmt: skip
        position = exact(point.position)
        if frame is not None:
            position = exact(frame.rotation).dot(position) + exact(frame.translation)
        part = (arb(point.mass), position, exact(np.zeros((3, 3))))
        result.setdefault(number, []).append(part)
    return result


def _locked(model: Model, scene: Scene, names: Names) -> dict[int, list[arb]]:
    """Return the configuration of every joint that is locked, slaved ones with their source."""
    values: dict[int, list[arb]] = {}
    if scene.lock_all_but is not None:
        free = {names.joint(name, "lock_all_but", k) for k, name in enumerate(scene.lock_all_but)}
        names.check_free(free)
        for j, joint in enumerate(model.joints):
            if j not in free and joint.mimic is None and joint.name != BASE:
                values[j] = [arb(x) for x in _neutral(joint)]
    for name, given in scene.lock.items():
        j = names.joint(name, "lock", name)
        names.check_locked(model.joints[j], given)
        values[j] = [arb(x) for x in given]
    for j, joint in enumerate(model.joints):
        if joint.mimic is not None and joint.mimic.source in values:
            source = values[joint.mimic.source][0]
            values[j] = [source * arb(joint.mimic.multiplier) + arb(joint.mimic.offset)]
    for name in scene.joints:
        if names.joints[name] in values:
            message = f"joint '{name}' is locked: it can have no other keys"
            raise scene.error(message, "joints", name)
    return values


def _neutral(joint: Joint) -> list[float]:
    result = [0.0] * joint.kind.nq
    if joint.kind.quaternion is not None:
        result[-1] = 1.0
    return result


def _check_forces(model: Model, scene: Scene) -> None:
    """Refuse forces on what is held by the ground."""
    names = Names(model, scene, checked=True)
    for k, name in enumerate(scene.forces):
        if names.link(name, "forces", k)[0] == 0:
            message = f"link '{name}' is fixed to the ground: a force there has no effect"
            raise scene.error(message, "forces", k)


def _with_forces(model: Model, scene: Scene) -> Model:
    names = Names(model, scene, checked=True)
    here = Pose.home().frame
    wrenches = []
    for k, name in enumerate(scene.forces):
        number, frame = names.link(name, "forces", k)
        wrenches.append(Wrench(number, here(name) if frame is None else frame))
    return replace(model, wrenches=tuple(wrenches))


def _outputs(model: Model, scene: Scene, locked: Mapping[str, object]) -> tuple[Output, ...]:
    """What the scene asks for beside accelerations, in its order."""
    names = Names(model, scene, checked=True)
    here = Pose.home().frame
    found = []
    for key, what in OUTPUTS.items():
        for k, name in enumerate(getattr(scene, key)):
            if what == REACTION_FORCE:
                if name in locked:
                    message = f"joint '{name}' is locked: the force through it is not computed"
                    raise scene.error(message, "outputs", key, k)
                number, frame = names.joint(name, "outputs", key, k) + 1, None
            else:
                number, frame = names.link(name, "outputs", key, k)
            if number == 0:
                message = f"link '{name}' is fixed to the ground: nothing is computed for it"
                raise scene.error(message, "outputs", key, k)
            found.append(Output(what, number, here(name) if frame is None else frame, name))
    return tuple(found)


def _wanting(model: Model, wanted: Set[str], scene: Scene) -> Model:
    """Ask for accelerations of some joints only, and of those that move the links kept.

    Where joints are tied to each other, all are computed.
    """
    if model.closed or any(joint.mimic for joint in model.joints):
        return model
    names = Names(model, scene, checked=True)
    found = {names.joints[name] for name in wanted}
    for k, name in enumerate(scene.keep):
        found |= set(path_to_ground(model.joints, names.link(name, "keep", k)[0]))
    every = len(found) == len(model.joints)
    return replace(model, wanted=() if every else tuple(sorted(found)))


def _pruned(
    model: Model, scene: Scene, locked: Mapping[str, object]
) -> tuple[Model, tuple[str, ...]]:
    """Leave out the limbs in which nothing is wanted."""
    names = Names(model, scene, checked=True)
    wanted = set()
    for k, name in enumerate(scene.accelerations or ()):
        if name in locked:
            message = f"joint '{name}' is locked: its acceleration cannot be asked for"
            raise scene.error(message, "accelerations", k)
        wanted.add(names.joint(name, "accelerations", k))
    kept = {names.link(name, "keep", k)[0] for k, name in enumerate(scene.keep)}
    if not wanted:
        raise scene.error(
            "'accelerations' names no joint: leave it out to get all", "accelerations"
        )
    outputs = {names.joints[name] for name in scene.reaction_forces if name in names.joints} | {
        names.link(name, "outputs", key, k)[0] - 1
        for key in ("link_accelerations", "inverse_inertia")
        for k, name in enumerate(getattr(scene, key))
    }
    stay = influential(model, wanted, kept | {j + 1 for j in outputs})
    smaller = _wanting(select(model, stay), {model.joints[j].name for j in wanted}, scene)
    dropped = tuple(j.name for k, j in enumerate(model.joints) if k not in set(stay))
    still = {link.name for link in smaller.links} | {
        name for link in smaller.links for name in link.merged
    }
    for k, name in enumerate(scene.forces):
        if name not in still:
            message = f"a force on link '{name}' changes nothing that the scene asks for"
            raise scene.error(message, "forces", k)
    return replace(smaller, floating=model.floating and smaller.joints[0].kind is FLOATING), dropped


def influential(model: Model, wanted: Collection[int], kept: Collection[int]) -> list[int]:
    """Return the joints that have to stay, ascending: all that can influence what is wanted.

    Some links have a known motion: the ground, and links that only prescribed joints connect to it.
    Limbs on such links are independent of each other, so that a limb without wanted accelerations
    can be left out, exactly. Inside a limb everything influences everything through forces.

    Args:
        model: the robot; a limb with a slaved joint stays with the limb of its source.
        wanted: joints whose accelerations are wanted.
        kept: links whose motion is wanted.
    """
    known = {0}  # links of known motion
    limb: dict[int, int] = {}  # the first joint of each other joint's limb
    for j, joint in enumerate(model.joints):
        if joint.parent in known and joint.prescribed:
            known.add(j + 1)
        else:
            limb[j] = j if joint.parent in known else limb[joint.parent - 1]
    stay = {limb[j] for j in {*wanted, *(link - 1 for link in kept)} if j in limb}
    grown = True
    ties = [{limb[j] for j in tied if j in limb} for tied in _tied(model)]
    while grown:  # they tie limbs together
        more = {one for tie in ties if tie & stay for one in tie} - stay
        stay |= more
        grown = bool(more)
    result = {j for j, first in limb.items() if first in stay}
    needed = [*stay, *wanted, *(link - 1 for link in kept)]  # by prescribed joints on the way
    return sorted(result | paths_to_ground(model.joints, needed))


def _tied(model: Model) -> list[set[int]]:
    """Joints that do not move apart: slaved ones and their sources, ends of loops, couplings."""
    slaved = [
        {j, joint.mimic.source} for j, joint in enumerate(model.joints) if joint.mimic is not None
    ]
    loops = [{link - 1 for link, _ in loop.ends} for loop in model.loops]
    return [*slaved, *loops, *({j for j, _ in c.terms} for c in model.couplings)]
