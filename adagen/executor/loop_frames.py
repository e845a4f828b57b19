"""The two frames of a loop joint over expressions: their distance and their constrained directions.

Constrained directions are fixed in frame 1. A row constrains the distance of the two frames along
such a direction, measured between points of both links at frame 2, or the rotation about it. The
relative pose is computed along the path through the last link that both have in common.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

from numpy.typing import NDArray

from adagen.executor.frames import Transform, plus_cross
from adagen.executor.state import State
from adagen.graph import Expression, cross, dot, total
from adagen.model.kinds import KINDS
from adagen.model.loops import LOOP_KINDS
from adagen.model.paths import path_to_ground
from adagen.plan.robot import PlanLoop

Array = NDArray[Any]


class End:
    """One frame of a loop, seen from the last common link of both.

    Attributes:
        link: that it is fixed to.
        axes: as columns in that link's axes, shape (3, 3).
        place: in that link's frame, shape (3,).
        joints: between the common link and it, outwards.
    """

    def __init__(
        self, state: State, link: int, axes: Array, place: Array, joints: tuple[int, ...]
    ) -> None:
        self.state, self.link, self.joints = state, link, joints
        self.axes, self.place = axes, place
        self.transforms: list[Transform] = [state.memory["X", j] for j in joints]

    def up(self, vector: Array) -> Array:
        """Return a vector of the link in axes of the common link, shape (3,)."""
        for x in reversed(self.transforms):
            vector = x.rotation.vector(vector)
        return vector

    def down(self, vector: Array) -> Array:
        """Return a vector of the common link in axes of this one, shape (3,)."""
        for x in self.transforms:
            vector = x.rotation.transposed().vector(vector)
        return vector

    @cached_property
    def placed(self) -> Array:
        """Where the frame is in that of the common link, shape (3,)."""
        point = self.place
        for x in reversed(self.transforms):
            point = x.origin + x.rotation.vector(point)
        return point

    @cached_property
    def motion(self) -> tuple[Array, Array]:
        """Angular velocity and that of the origin relative to the common link, in own axes."""
        omega, v = self.state.zeros(3), self.state.zeros(3)
        for j, x in zip(self.joints, self.transforms, strict=True):
            back, own = x.rotation.transposed(), self.state.zeros(6)
            free = KINDS[self.state.plan.joints[j].kind].free  # whether it is prescribed or not
            own[list(free)] = self.state.configuration(j)[1]
            v = back.vector(plus_cross(v, omega, x.origin)) + own[3:]
            omega = back.vector(omega) + own[:3]
        return omega, v

    @cached_property
    def turning(self) -> Array:
        """Angular velocity relative to the common link, in its axes."""
        return self.up(self.motion[0])

    def own_speed(self, arm: Array) -> Array:
        """Return the velocity of a point of the link relative to the common one, in own axes."""
        omega, v = self.motion
        return plus_cross(v, omega, arm)

    def speed(self, arm: Array) -> Array:
        """Return the velocity of a point of the link relative to the common one, in its axes."""
        return self.up(self.own_speed(arm))


class LoopFrames:
    """Both frames of a loop.

    Args:
        state: whose process it is; kinematics of all joints between the frames are known.
        loops: the loop; or those that share code, one for each lane: what is between the frames of
            one is in a row with what is between those of the others, or is the same.
    """

    def __init__(self, state: State, loops: Sequence[PlanLoop]) -> None:
        loop = loops[0]
        self.state, self.kind = state, LOOP_KINDS[loop.kind]
        ways = [path_to_ground(state.plan.joints, link)[::-1] for link in loop.links]
        shared = sum(a == b for a, b in zip(*ways, strict=False))

        def end(side: int) -> End:
            axes = state.rows.packed([state.constants(each.rotations[side]) for each in loops])
            place = state.rows.packed([state.constants(each.translations[side]) for each in loops])
            return End(state, loop.links[side], axes, place, tuple(ways[side][shared:]))

        self.one, self.two = end(0), end(1)
        self._axes: dict[int, Array] = {}

    def axis(self, k: int) -> Array:
        """Return axis k of frame 1 in axes of the common link."""
        if k not in self._axes:
            self._axes[k] = self.one.up(self.one.axes[:, k])
        return self._axes[k]

    @cached_property
    def apart(self) -> Array:
        """From the origin of frame 1 to that of frame 2, in axes of the common link."""
        return self.two.placed - self.one.placed

    @cached_property
    def arms(self) -> tuple[Array, Array]:
        """Position of frame 2 in each link's frame; in the first as if the loop were closed."""
        arm = self.one.place
        for k in self.kind.sliding:
            arm = arm + self.one.axes[:, k] * dot(self.axis(k), self.apart)
        return arm, self.two.place

    @cached_property
    def parting(self) -> Array:
        """Velocity of link 2 at frame 2 less that of link 1 there, in axes of the common link."""
        return self.two.speed(self.arms[1]) - self.one.speed(self.arms[0])

    @cached_property
    def turning(self) -> Array:
        """Angular velocity of link 2 relative to link 1, in axes of the common link."""
        return self.two.turning - self.one.turning

    @cached_property
    def across(self) -> Array:
        """The common normal of a universal joint's axes, in axes of the common link: b x a."""
        return cross(self._other_axis, self.axis(2))

    @cached_property
    def _other_axis(self) -> Array:
        return self.two.up(self.two.axes[:, 2])

    # -- how far it is open -----------------------------------------------------------------------

    def gap(self) -> Expression:
        """Return the square of how far the loop is open, m^2 and rad^2."""
        if self.kind.sliding:
            parts = [dot(self.axis(k), self.apart) for k in self.kind.linear]
        else:
            parts = list(self.apart)
        if self.kind.axes == 2:
            parts.append(dot(self.axis(2), self._other_axis))
        elif self.kind.angular:  # two axes that agree leave the third no choice
            for k in (0, 1) if len(self.kind.angular) == 3 else (2,):
                parts += list(self.two.up(self.two.axes[:, k]) - self.axis(k))
        return total([part * part for part in parts])

    def rate(self) -> Expression:
        """Return the square of how fast it opens, m^2/s^2 and rad^2/s^2."""
        moving = [k for k, end in enumerate((self.one, self.two)) if end.joints]
        alone = (self.one, self.two)[moving[0]] if len(moving) == 1 else None  # any axes will do
        if self.kind.sliding:
            parts = [dot(self.axis(k), self.parting) for k in self.kind.linear]
        else:
            parts = list(alone.own_speed(self.arms[moving[0]]) if alone else self.parting)
        if self.kind.axes == 2:
            parts.append(dot(self.across, self.turning))
        elif len(self.kind.angular) == 3:
            parts += list(alone.motion[0] if alone else self.turning)
        else:
            parts += [dot(self.axis(k), self.turning) for k in self.kind.angular]
        return total([part * part for part in parts])

    # -- rows -------------------------------------------------------------------------------------

    def row(self, number: int) -> tuple[bool, Array, Array]:
        """Return whether a row constrains a position, and its direction in each link."""
        linear = number < len(self.kind.linear)
        if not linear and self.kind.axes == 2:
            return False, self.one.down(self.across), self.two.down(self.across)
        k = self._axis_of(number)
        if self.one.link == 0 and self._in_any_axes:
            # Any three axes will do: those of the link that moves need not be taken there.
            axis = self.two.axes[:, k]
            return True, self.one.down(self.two.up(axis)), axis
        whole = len(self.kind.angular) == 3
        if whole or (k == 2 and self.kind.angular and self.kind.axes == 1):
            return linear, self.one.axes[:, k], self.two.axes[:, k]  # they are one axis
        return linear, self.one.axes[:, k], self.two.down(self.axis(k))

    @property
    def _in_any_axes(self) -> bool:
        """Whether its rows may be along any three axes, as those of a point."""
        return not (self.kind.sliding or self.kind.angular)

    def along(self, k: int, directions: Sequence[Array], vector: Array) -> Expression:
        """Return the component of a vector of the first (0) or second link along a position row.

        Of the ground's it takes less to turn the vector than each row's direction.
        """
        own, other = (self.one, self.two) if k == 0 else (self.two, self.one)
        fixed = len(self.kind.angular) == 3 or (k == 0 and not self._in_any_axes)
        if own.link > 0 or fixed:
            return dot(directions[k], vector)
        return dot(directions[1 - k], other.down(own.up(vector)))

    def _axis_of(self, number: int) -> int:
        return (*self.kind.linear, *self.kind.angular)[number]

    def turned(self, number: int, omega1: Array, omega2: Array) -> Expression:
        """Return the term of a row's second derivative from its direction's motion with link 1.

        Args:
            number: of the row.
            omega1: angular velocity of link 1, in its axes.
            omega2: likewise of link 2.
        """
        zero: Expression = self.state.graph.constant(0)
        linear, k = number < len(self.kind.linear), self._axis_of(number)
        axes = self.one.axes
        if linear:
            slides = [
                dot(self.axis(m), self.parting) * dot(omega1, cross(axes[:, m], axes[:, k]))
                for m in self.kind.sliding
            ]
            return total(slides) * -2.0 if slides else zero
        if len(self.kind.angular) == 3:
            return zero
        if self.kind.axes == 2:
            a, b = self.axis(2), self._other_axis
            one, two = self.one.up(omega1), self.two.up(omega2)
            changing = cross(cross(two, b), a) + cross(b, cross(one, a))
            return dot(changing, self.turning)
        rate = dot(self.axis(2), self.turning)
        return -(rate * dot(omega1, cross(axes[:, 2], axes[:, k])))
