"""Names in a scene, looked up in the robot, and the keys that joint kinds accept."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence

from adagen.jsonfile import nearest
from adagen.model import BASE, REACTION_FORCE, Frame, Joint, Model, places
from adagen.scene.types import OUTPUTS, Scene


class Names:
    """The names of one robot, as one scene uses them; refusals tell the scene's line.

    Args:
        model: the robot.
        scene: the scene, whose names are looked up at once unless ``checked`` already.
    """

    def __init__(self, model: Model, scene: Scene, *, checked: bool = False) -> None:
        self.model, self.scene = model, scene
        self.joints = {joint.name: j for j, joint in enumerate(model.joints)}
        self.links = places(model)
        if not checked:
            self._look_up(scene)

    def _look_up(self, scene: Scene) -> None:
        for name in scene.joints:
            self.joint(name, "joints", name)
        for key in ("keep", "forces"):
            for k, name in enumerate(getattr(scene, key)):
                self.link(name, key, k)
        for k, name in enumerate(scene.accelerations or ()):
            self.joint(name, "accelerations", k)
        for key, what in OUTPUTS.items():
            look_up = self.joint if what == REACTION_FORCE else self.link
            for k, name in enumerate(getattr(scene, key)):
                look_up(name, "outputs", key, k)

    def joint(self, name: str, *path: str | int) -> int:
        """Return a moving joint's index.

        Raises:
            InputError: there is none of this name.
        """
        if name in self.joints:
            return self.joints[name]
        if name == BASE:
            hint = ': the base is fixed; write base = "floating" or another kind'
        else:
            hint = nearest(name, self.joints)
        raise self.scene.error(f"'{name}' is not a moving joint of the robot{hint}", *path)

    def link(self, name: str, *path: str | int) -> tuple[int, Frame | None]:
        """Return the number of the link that a name belongs to, and its frame if it is lumped.

        Raises:
            InputError: there is none of this name.
        """
        if name not in self.links:
            hint = nearest(name, self.links)
            raise self.scene.error(f"'{name}' is not a link of the robot{hint}", *path)
        return self.links[name]

    def check_effects(self, joint: Joint, effects: Mapping[str, float]) -> None:
        """Refuse effects that have no meaning for a joint's kind.

        Raises:
            InputError: it is of several degrees of freedom.
        """
        for key in effects:
            if joint.kind.takes(key):
                continue
            raise self.scene.error(
                f"joint '{joint.name}' is {joint.kind.name}: {key} has no single meaning for it",
                "joints", joint.name, key,
            )  # fmt: skip

    def check_prescribed(self, joint: Joint) -> None:
        """Refuse to prescribe the motion of a joint that is tied to another one, or locked.

        Raises:
            InputError: it is slaved or followed.
        """
        path = ("joints", joint.name, "prescribed")
        own = self.joints[joint.name]
        if joint.mimic is not None:
            source = self.model.joints[joint.mimic.source].name
            raise self.scene.error(
                f"joint '{joint.name}' follows '{source}': its motion is known", *path
            )
        for other in self.model.joints:
            if other.mimic is not None and other.mimic.source == own:
                raise self.scene.error(
                    f"joint '{other.name}' follows '{joint.name}': a joint that is followed cannot "
                    "be prescribed; leave out mimic", *path
                )  # fmt: skip

    def check_locked(self, joint: Joint, values: Sequence[float]) -> None:
        """Refuse a configuration that is none of this joint.

        Raises:
            InputError: it has other than the kind's numbers, a zero quaternion, or follows another.
        """
        path = ("lock", joint.name)
        if joint.mimic is not None:
            source = self.model.joints[joint.mimic.source].name
            raise self.scene.error(f"joint '{joint.name}' follows '{source}': lock that one", *path)
        if len(values) != joint.kind.nq:
            need = "a number" if joint.kind.nq == 1 else f"{joint.kind.nq} numbers"
            raise self.scene.error(
                f"joint '{joint.name}': {len(values)} numbers; a {joint.kind.name} joint needs "
                f"{need}",
                *path,
            )
        if joint.kind.quaternion is not None and abs(math.hypot(*values[-4:]) - 1.0) > 1e-3:
            raise self.scene.error(
                f"joint '{joint.name}': the quaternion has length {math.hypot(*values[-4:]):.6g}, "
                "not 1; no rotation is [0, 0, 0, 1] (the order is x, y, z, w)", *path
            )  # fmt: skip
        if joint.name in (self.scene.lock_all_but or ()):
            raise self.scene.error(f"joint '{joint.name}' is locked and in 'lock_all_but'", *path)

    def check_free(self, free: Collection[int]) -> None:
        """Refuse a slaved joint among those that are to stay free.

        Raises:
            InputError: one follows another joint.
        """
        for j in sorted(free):
            joint = self.model.joints[j]
            if joint.mimic is not None:
                source = self.model.joints[joint.mimic.source].name
                raise self.scene.error(
                    f"joint '{joint.name}' follows '{source}': name that one", "lock_all_but"
                )
