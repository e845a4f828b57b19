"""Runs of joints that a schedule joins as one.

A schedule names every joint. If the joints of a run follow each other in its tree on one process,
so that the links between them would be partial chains by themselves, the run is joined as one.
"""

from __future__ import annotations

from collections.abc import MutableMapping, Sequence
from typing import Any

from adagen.model.fuse import Run
from adagen.schedule import Node, Schedule, preorder

__all__ = ["Fusions", "Run"]


class Fusions:
    """The runs that are fused in a schedule.

    Args:
        schedule: a schedule of all joints.
        runs: the runs of the robot (``adagen.model.fuse.runs_of``).
    """

    def __init__(self, schedule: Schedule, runs: Sequence[Run]) -> None:
        self.nodes = {node.joint: node for node in preorder(schedule.root)} if runs else {}
        self.run_of: dict[int, Run] = {}  # by the joint at the top of the run's part of the tree
        for run in runs:
            top = self._top(run)
            if top is not None:
                self.run_of[top] = run
        self._inner: set[int] = {j for top, run in self.run_of.items() for j in run if j != top}

    def _top(self, run: Run) -> int | None:
        """The uppermost joint of a run whose nodes are connected on one process, else None."""
        members = set(run)
        below = {child.joint for j in run for child in self.nodes[j].children}
        tops = [j for j in run if j not in below]
        first = {self.nodes[j].processes[0] for j in run}
        if len(tops) != 1 or len(first) != 1:
            return None
        # Between the joints there must be nothing but the links without mass.
        sides = [(j, self.nodes[j].end_side) for j in run[:-1]]
        sides += [(j, self.nodes[j].root_side) for j in run[1:]]
        alone = all(side is None or side.joint in members for _, side in sides)
        return tops[0] if alone else None

    def leave_to(self, segments: MutableMapping[int, Any]) -> None:
        """Remove runs that lie completely in a segment, and keep others out of all segments.

        Args:
            segments: what is known of each joint that is treated with all below it.
        """
        self.run_of = {top: run for top, run in self.run_of.items() if top not in segments}
        self._inner = {j for top, run in self.run_of.items() for j in run if j != top}
        for j in self._inner:
            segments.pop(j, None)

    def inside(self, joint: int) -> bool:
        """Return whether a joint is joined with another one of its run."""
        return joint in self._inner

    def run_at(self, joint: int) -> Run:
        """Return the joints that are joined where the schedule has ``joint``."""
        return self.run_of.get(joint, (joint,))

    def sides(self, node: Node) -> tuple[Node | None, Node | None]:
        """Return the nodes on the root side and the end side of a node's run."""
        run = self.run_at(node.joint)
        if len(run) == 1:
            return node.root_side, node.end_side
        return self.nodes[run[0]].root_side, self.nodes[run[-1]].end_side

    @property
    def fused(self) -> tuple[Run, ...]:
        """The runs that are joined as one, in the order of their joints."""
        return tuple(sorted(self.run_of.values()))
