"""Form `ada` of a robot with closed loops: the tree joint by joint, its loops at the end.

The tree is assembled and disassembled as without loops, with one more right-hand side for each
constraint: the response to a unit of its force. Process 0 then solves for the forces that keep all
loops closed, as it does for the torques of slaved joints. So loops may pass through any chains on
any processes, and no other step is affected. Links whose inertia cannot be inverted are joined in
runs and clusters, as without loops. Motions that only loops resist get an artificial inertia
(artificial_inertia.py).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from adagen.model.fuse import Run
from adagen.plan import steps as do
from adagen.plan.closures import Closure
from adagen.plan.clusters import ClusterPlanner
from adagen.plan.edges import on_the_way
from adagen.plan.messages import Message
from adagen.plan.robot import PlanCoupling, PlanJoint, PlanLoop, first_rows
from adagen.plan.steps import Step
from adagen.plan.types import Process
from adagen.schedule import Schedule


class ClosedAdaPlanner(ClusterPlanner):
    """Builds the processes of form `ada` of a robot with loops.

    Args:
        joints: the robot's joints.
        schedule: a schedule of its joints.
        runs: its runs, which are fused where they are inside no cluster.
        clusters: the number of the cluster that each joint is inside of.
        closures: its closures.
        loops: its loop joints.
        couplings: its couplings.
    """

    def __init__(
        self,
        joints: tuple[PlanJoint, ...],
        schedule: Schedule,
        runs: Sequence[Run],
        clusters: Mapping[int, int],
        closures: Sequence[Closure],
        loops: Sequence[PlanLoop],
        couplings: Sequence[PlanCoupling],
    ) -> None:
        super().__init__(joints, schedule, runs, clusters)
        self.closures, self.loops, self.couplings = closures, loops, couplings
        rows = sorted(row for closure in closures for row in closure.rows)
        self._number = {row: number for number, row in enumerate(rows)}
        self._firsts = first_rows(loops)

    def tied_rows(self) -> tuple[int, ...]:
        """Return the independent constraints, by number."""
        kept = (row for closure in self.closures for row in closure.choices[0].rows)
        return tuple(sorted(self._number[row] for row in kept))

    def coupled(self) -> set[int]:
        """Return the joints whose accelerations depend on each other."""
        lent = {j for j, joint in enumerate(self.joints) if joint.lent}
        return super().coupled().union(lent, *(closure.path for closure in self.closures))

    def plan(self) -> tuple[tuple[Process, ...], tuple[Message, ...]]:
        """Return every process's steps, and the messages between them."""
        processes, messages = super().plan()
        closed = (self._with_loops(process, p == 0) for p, process in enumerate(processes))
        return tuple(closed), messages

    def _with_loops(self, process: Process, all_of_them: bool) -> Process:
        """A process with the constraints at its links and joints before they are needed."""
        if not process.steps:
            return process
        links = {step.link for step in process.steps_of(do.LinkBias, do.StartLink)}
        joined = _joined(process.steps)
        steps: list[Step] = []
        passed = set(process.reads)
        for k, loop in enumerate(self.loops):
            ends = set(loop.links)
            if all_of_them or links & ends:
                rows = range(self._firsts[k], self._firsts[k + 1])
                steps.append(do.CloseLoop.of(k, 0, rows, self._number))
                passed |= {link - 1 for link in ends if link > 0}
        for k, coupling in enumerate(self.couplings):
            tied = {j for j, _ in coupling.terms}
            if all_of_them or joined & tied:
                unknown = self._number.get(self._firsts[-1] + k)
                steps.append(do.CloseCoupling(k, 0, unknown))
                passed |= tied
        reads = on_the_way(self.joints, passed)
        rest = [step for step in process.steps if not isinstance(step, do.Kinematics)]
        moved = [do.Kinematics(j) for j in reads]
        return Process((*moved, *steps, *rest), reads, process.owns, process.shares)


def _joined(steps: Sequence[Step]) -> set[int]:
    """The joints whose torques a process needs."""
    joined: set[int] = set()
    for step in steps:
        match step:
            case do.FusedJoin():
                joined.update(step.run)
            case do.Join() | do.Articulate():
                joined.add(step.joint)
    return joined
