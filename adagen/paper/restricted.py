"""Schedules of robots that must not be cut at some joints.

Where some joints have to stay inside one process (links without mass beside them, say), the beam
search follows only the cuts that are allowed, and leaves a chain without any to its first process.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from adagen.paper.beam import Beam
from adagen.paper.bounds import Rules
from adagen.paper.budget import Budget
from adagen.paper.cuts import Cuts
from adagen.paper.successors import Space
from adagen.paper.tie_break import Builder
from adagen.schedule.chains import Chain
from adagen.schedule.profile import CostProfile
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Node, postorder
from adagen.schedule.tree_draft import Draft


def joined_between_processes(root: Node) -> list[int]:
    """Return the joints of a schedule whose parts are not all computed by one process."""
    leads: dict[int, int | None] = {}  # joint -> the one process that its whole part is left to
    result = []
    for node in postorder(root):
        below = {leads[child.joint] for child in node.children}
        alone = below <= {node.processes[0]}
        leads[node.joint] = node.processes[0] if alone else None
        if not alone:
            result.append(node.joint)
    return result


class RestrictedSpace(Space):
    """A search space in which only the allowed cuts exist.

    Args:
        topology: the robot.
        profile: what a join costs.
        rules: how processes are divided.
        cuttable: for each joint whether two processes may meet there; length N.
    """

    def __init__(
        self, topology: Topology, profile: CostProfile, rules: Rules, cuttable: Sequence[bool]
    ) -> None:
        super().__init__(topology, profile, rules)
        self._allowed = np.array([cuttable[j] for j in self.chains.original], dtype=np.bool_)

    def cuts(self, chain: Chain) -> Cuts:
        """Return the allowed cuts of a chain, none perhaps."""
        cuts = self.cutter.cuts(chain)
        return cuts.take(self._allowed[cuts.position])


class RestrictedBeam(Beam):
    """The beam search over allowed cuts; equal shapes are not equal here, as joints differ."""

    def __init__(self, space: RestrictedSpace, width: int, budget: Budget) -> None:
        super().__init__(space, width, budget)
        self._numbers: dict[Chain, int] = {}

    def key(self, chain: Chain) -> int:
        """Return a number that only this very chain has."""
        return self._numbers.setdefault(chain, len(self._numbers))

    def builder(self) -> Builder:
        """Return what puts a schedule together."""
        return _LeavingIdle(self.space)


class _LeavingIdle(Builder):
    """Leaves a chain that is not cut to the first process of its range."""

    def leaf(self, chain: Chain, above: int, is_end: bool, processes: tuple[int, int]) -> None:
        """Add a chain that is not cut."""
        order = self.space.single.order(chain)
        self.draft.hang(above, self.draft.contract(self.space.topology, order), is_end)
        for joint in order:
            self.draft.ranges[joint] = processes


def restricted_draft(
    topology: Topology,
    processes: int,
    profile: CostProfile,
    rules: Rules,
    cuttable: Sequence[bool],
    expansions: int,
) -> tuple[Draft, int]:
    """Return the best of several beams of growing width, and the states expanded.

    Args:
        topology: the robot.
        processes: P.
        profile: what a join costs.
        rules: how processes are divided.
        cuttable: for each joint whether two processes may meet there; length N.
        expansions: states that may be expanded.
    """
    space = RestrictedSpace(topology, profile, rules, cuttable)
    found: list[tuple[int, RestrictedBeam]] = []
    spent = 0
    for width in (1, 4, 16):
        budget = Budget(max(64, expansions - spent))
        beam = RestrictedBeam(space, width, budget)
        found.append((beam.time(processes), beam))
        spent += budget.expanded
        if spent >= expansions:
            break
    _, beam = min(found, key=lambda pair: pair[0])
    beam.budget = Budget(1 << 30)
    return beam.draft(processes), spent
