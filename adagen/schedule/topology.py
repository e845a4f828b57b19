"""The topology of a robot: the links that each joint connects."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from adagen.model import Model
from adagen.schedule.costs import PRESCRIBED


@dataclass(frozen=True)
class Topology:
    """A kinematic tree of N joints and N + 1 links; link 0 is the ground.

    Joint j joins link ``parents[j]`` to link j + 1, and parents come before children.

    Attributes:
        parents: parent link of each joint, ``0 <= parents[j] <= j``; length N.
        dofs: degrees of freedom n_i of each joint, 1 to 6; length N.
        names: name of each joint, all different; length N.
        kinds: name of each joint's kind; length N, or empty where only degrees of freedom matter.
        prescribed: joints of known acceleration: what they cost is another matter.
        tangents: hyperbolic tangents that the friction of each joint takes in an evaluation;
            length N, or empty for none.
    """

    parents: tuple[int, ...]
    dofs: tuple[int, ...]
    names: tuple[str, ...]
    kinds: tuple[str, ...] = ()
    prescribed: frozenset[int] = frozenset()
    tangents: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        if not len(self.parents) == len(self.dofs) == len(self.names):
            raise ValueError("parents, dofs and names must be equally long")
        if self.kinds and len(self.kinds) != len(self.parents):
            raise ValueError("there must be as many kinds as joints, or none")
        if self.tangents and len(self.tangents) != len(self.parents):
            raise ValueError("there must be as many tangents as joints, or none")
        for j, (parent, dofs) in enumerate(zip(self.parents, self.dofs, strict=True)):
            if not 0 <= parent <= j:
                raise ValueError(f"joint {j}: parent link {parent} is not one of 0..{j}")
            if not 1 <= dofs <= 6:
                raise ValueError(f"joint {j}: {dofs} degrees of freedom, not 1 to 6")
        if len(set(self.names)) != len(self.names):
            raise ValueError("joint names must be unique")

    @staticmethod
    def of(model: Model) -> Topology:
        """Return the topology of a model."""
        return Topology(
            tuple(joint.parent for joint in model.joints),
            tuple(joint.kind.nv for joint in model.joints),
            tuple(joint.name for joint in model.joints),
            tuple(joint.kind.name for joint in model.joints),
            frozenset(j for j, joint in enumerate(model.joints) if joint.prescribed),
            tuple(joint.passive.tangents for joint in model.joints),
        )

    @staticmethod
    def bare(parents: tuple[int, ...], dofs: tuple[int, ...] | None = None) -> Topology:
        """Return a topology with joints named ``j0``, ``j1``, ... (of one degree of freedom)."""
        names = tuple(f"j{j}" for j in range(len(parents)))
        return Topology(parents, (1,) * len(parents) if dofs is None else dofs, names)

    @staticmethod
    def serial(joints: int) -> Topology:
        """Return the serial chain of joints of one degree of freedom (Section IV-B)."""
        return Topology.bare(tuple(range(joints)))

    @property
    def is_chain(self) -> bool:
        """Whether each joint is on the link of the one before."""
        return all(parent == j for j, parent in enumerate(self.parents))

    def kind(self, joint: int) -> str:
        """Return the name of a joint's kind; if none was given, a common one of its freedoms."""
        if self.kinds:
            return self.kinds[joint]
        dofs = self.dofs[joint]
        return "revolute" if dofs == 1 else "spherical" if dofs < 6 else "floating"

    def priced_as(self, joint: int) -> str:
        """Return the kind by which a joint is priced, apart from kinematics, or prescribed."""
        return PRESCRIBED if joint in self.prescribed else self.kind(joint)

    def tangents_of(self, joint: int) -> int:
        """Return how many hyperbolic tangents the friction of a joint takes in an evaluation."""
        return self.tangents[joint] if self.tangents else 0

    def __len__(self) -> int:
        """Return N, the number of joints."""
        return len(self.parents)

    @cached_property
    def degrees(self) -> tuple[int, ...]:
        """Number of joints that touch each link; length N + 1."""
        degrees = [0] * (len(self) + 1)
        for j, parent in enumerate(self.parents):
            degrees[parent] += 1
            degrees[j + 1] += 1
        return tuple(degrees)

    @cached_property
    def intervals(self) -> tuple[tuple[int, int], ...]:
        """Depth-first position of each joint and one past the last position below it; length N."""
        below: list[list[int]] = [[] for _ in range(len(self) + 1)]
        for j, parent in enumerate(self.parents):
            below[parent].append(j)
        start, size = [0] * len(self), [1] * len(self)
        for j in reversed(range(len(self))):
            size[j] += sum(size[child] for child in below[j + 1])
        stack, count = below[0][::-1], 0
        while stack:
            j = stack.pop()
            start[j] = count
            count += 1
            stack.extend(reversed(below[j + 1]))
        return tuple((a, a + n) for a, n in zip(start, size, strict=True))

    def is_below(self, above: int, joint: int) -> bool:
        """Return whether ``joint`` is on the end side of the joint ``above``."""
        start, stop = self.intervals[above]
        return start < self.intervals[joint][0] < stop
