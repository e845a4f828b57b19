"""Rows of closed loops in any number type: J, and its change along the motion.

As in `adagen.reference.closed`, link by link in ground axes; but there in many configurations at
once, here to any precision, and with the second derivative of the gaps.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from adagen.model import Frame, Loop, Model
from adagen.reference.kinematics import orthonormal, placements
from adagen.reference.numbers import Numbers, Numeric, cross, cross_matrix

Array = NDArray[np.float64]
ROUNDING = 1e-11
"""A row so much smaller than what it is made of is rounding."""


@dataclass(frozen=True, eq=False)
class _Frame:
    """A frame on a link, in ground axes.

    Attributes:
        axes: its axes, shape (3, 3).
        place: its origin, shape (3,).
        spin: angular velocity, shape (3,).
        speed: velocity of the origin, shape (3,).
        turning: angular acceleration while all joints keep their rates, shape (3,).
        pull: acceleration of the origin likewise, shape (3,).
        angular: angular velocity by unit rates, shape (3, nv).
        linear: velocity of the origin by unit rates, shape (3, nv).
    """

    axes: Numeric
    place: Numeric
    spin: Numeric
    speed: Numeric
    turning: Numeric
    pull: Numeric
    angular: Numeric
    linear: Numeric

    def at(self, axes: Numeric, arm: Numeric) -> _Frame:
        """Return a frame that is fixed to this one, its origin an arm (ground axes) away."""
        spin, turning = self.spin, self.turning
        return _Frame(
            axes,
            self.place + arm,
            spin,
            self.speed + cross(spin, arm),
            turning,
            self.pull + cross(turning, arm) + cross(spin, cross(spin, arm)),
            self.angular,
            self.linear - cross_matrix(arm).dot(self.angular),
        )


def loop_rows(numbers: Numbers, model: Model, q: Numeric, v: Numeric) -> tuple[Numeric, Numeric]:
    """Return J and Jdot v: constraints are satisfied by accelerations with J qdd + Jdot v = 0.

    Args:
        numbers: the kind of number that q and v hold.
        model: the robot; slaved joints count as independent here.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).

    Returns:
        Shapes (rows, nv) and (rows,): rows of loops, then of couplings, as
        `adagen.reference.closed.constraints` has them.
    """
    links = _links(numbers, model, q, v)
    found = [row for loop in model.loops for row in _of_loop(numbers, loop, links)]
    for coupling in model.couplings:
        row = numbers.zeros(model.nv)
        for j, factor in coupling.terms:
            row[model.v_start[j]] += numbers.array([factor])[0]
        found.append((row, numbers.zeros(1)[0]))
    rows = np.array([row for row, _ in found]).reshape(-1, model.nv)
    return rows, np.array([drift for _, drift in found])


def _links(numbers: Numbers, model: Model, q: Numeric, v: Numeric) -> list[_Frame]:
    """Return all links, the ground first."""
    still, none = numbers.zeros(3), numbers.zeros(3, model.nv)
    links = [_Frame(numbers.array(np.eye(3)), still, still, still, still, still, none, none)]
    every = zip(model.joints, model.v_start, placements(numbers, model, q), strict=True)
    for joint, start, place in every:
        above = links[joint.parent]
        axes = above.axes.dot(place.rotation)
        carried = above.at(axes, above.axes.dot(place.position))
        own = slice(start, start + joint.kind.nv)
        turns, slides = axes.dot(place.angular), axes.dot(place.linear)
        spin, slide = turns.dot(v[own]), slides.dot(v[own])
        angular, linear = carried.angular.copy(), carried.linear.copy()
        angular[:, own], linear[:, own] = turns, slides
        links.append(
            _Frame(
                axes,
                carried.place,
                carried.spin + spin,
                carried.speed + slide,
                carried.turning + cross(carried.spin, spin),
                # The sliding velocity turns with the link above, and with the link itself.
                carried.pull + 2 * cross(carried.spin, slide) + cross(spin, slide),
                angular,
                linear,
            )
        )
    return links


def _of_loop(
    numbers: Numbers, loop: Loop, links: list[_Frame]
) -> Iterator[tuple[Numeric, Numeric]]:
    """Yield rows of a loop, (nv,) each, and how they change."""
    one, two = (_placed(numbers, links[link], frame) for link, frame in loop.ends)
    apart, parting = two.place - one.place, two.speed - one.speed
    relative = parting - cross(one.spin, apart)
    rates = two.linear - one.linear + cross_matrix(apart).dot(one.angular)
    change = two.pull - one.pull - cross(one.turning, apart) - cross(one.spin, parting)
    for k in loop.kind.linear:
        along = one.axes[:, k]
        yield along.dot(rates), cross(one.spin, along).dot(relative) + along.dot(change)
    spin, turning = two.spin - one.spin, two.turning - one.turning
    for k in loop.kind.angular:
        along = one.axes[:, k]
        moving = cross(one.spin, along)
        if loop.kind.axes == 2:  # of a universal joint: the common normal of its axes
            first, second = one.axes[:, 2], two.axes[:, 2]
            along = cross(second, first)
            moving = cross(cross(two.spin, second), first)
            moving = moving + cross(second, cross(one.spin, first))
        yield along.dot(two.angular - one.angular), moving.dot(spin) + along.dot(turning)


def _placed(numbers: Numbers, link: _Frame, frame: Frame) -> _Frame:
    axes = link.axes.dot(orthonormal(numbers, numbers.array(frame.rotation)))
    return link.at(axes, link.axes.dot(numbers.array(frame.translation)))


def size_of(model: Model) -> float:
    """Return the largest distance between joints or ends of loops on one link, m; 1 if none."""
    lengths = [float(np.linalg.norm(joint.translation)) for joint in model.joints]
    ends = (frame for loop in model.loops for _, frame in loop.ends)
    lengths += [float(np.linalg.norm(frame.translation)) for frame in ends]
    return max(lengths, default=0.0) or 1.0


def usual_sizes(model: Model) -> Array:
    """Return the size of each row of J if it is more than rounding, shape (rows,).

    Of a loop that holds nothing all rows are rounding, so that they say nothing of each other.
    """
    length = size_of(model)
    sizes = [
        [*(length for _ in loop.kind.linear), *(1.0 for _ in loop.kind.angular)]
        for loop in model.loops
    ]
    sizes += [[max(abs(factor) for _, factor in each.terms)] for each in model.couplings]
    return np.array([size for own in sizes for size in own])


def more_than_rounding(model: Model, rows: Array) -> NDArray[np.bool_]:
    """Return which rows of J in double are more than rounding, shape (..., rows).

    Args:
        model: the robot.
        rows: of all its loops and couplings, shape (..., rows, nv).
    """
    found: NDArray[np.bool_] = np.abs(rows).max(axis=-1, initial=0.0) > ROUNDING * usual_sizes(
        model
    )
    return found
