"""Clusters in form `ada`: links of singular inertia with their neighbours, as articulated bodies.

A link whose inertia cannot be inverted, and which is not inside a fused run of joints, cannot be a
partial chain of its own. It forms a cluster with the link before it, and with the links beyond it
if it does not resist its own joint either. A cluster is computed by the articulated-body algorithm
like a segment, by one process; its mobility is finite where the link's own is not.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from adagen.errors import InputError
from adagen.model import Inertia, Model
from adagen.model.fuse import Run, runs_of, settled
from adagen.plan.artificial_inertia import with_artificial_inertia
from adagen.plan.constants import inverse_inertia
from adagen.plan.placement import spatial_inertia
from adagen.plan.robot import PlanJoint
from adagen.plan.segment import SegmentPlanner
from adagen.schedule import Node, Schedule, Topology
from adagen.schedule.fold import Fold, fold
from adagen.union_find import UnionFind

NOISE = 1e-10
"""Principal moments of this size beside m l^2 are noise of what has written the description."""

RESISTS = 1e-6
"""Least inertia along a joint, relative to the largest of its unit, that a link has by itself."""


def clusters_of(model: Model, runs: Sequence[Run]) -> dict[int, int]:
    """Return the cluster that each joint is inside of; joints between clusters are left out.

    Args:
        model: the robot.
        runs: its runs, which are fused where they are inside no cluster.
    """
    upright = settled(model, runs)
    run_of = {j: run for run in runs for j in run}
    inner = {j + 1 for run in runs for j in run[:-1]}
    leaders = UnionFind[int]()
    inside: set[int] = set()

    def merge(joint: int) -> None:
        run = run_of.get(joint, (joint,))
        inside.update(run)
        leaders.join(run[-1] + 1, upright.joints[run[0]].parent)

    for number, link in enumerate(upright.links[1:], start=1):
        places = [upright.joints[j].translation for j in upright.children[number]]
        if number in inner or is_solid(link.inertia, places):
            continue
        merge(number - 1)
        if not _resists(upright, number):
            for joint in upright.children[number]:
                merge(joint)
    return {j: leaders.of(run_of.get(j, (j,))[-1] + 1) for j in sorted(inside)}


def is_regular(inertia: Inertia) -> bool:
    """Return whether a link's spatial inertia can be inverted."""
    try:
        inverse_inertia(inertia, "")
    except InputError:
        return False
    return True


def is_solid(inertia: Inertia, joints: Iterable[Sequence[float] | np.ndarray]) -> bool:
    """Return whether a link's inertia can be inverted, and its moments are more than noise.

    Args:
        inertia: the link's.
        joints: places of the joints beyond it, shape (3,) each, m; noise is judged beside m l^2.
    """
    if not is_regular(inertia):
        return False
    size = inertia.mass * max(float(np.dot(p, p)) for p in (inertia.com, *joints))
    moments = np.linalg.eigvalsh(inertia.tensor)
    return bool(moments[0] > NOISE * max(size, moments[-1]))


def _resists(model: Model, number: int) -> bool:
    """Whether a link alone has inertia along each freedom of the joint before it (axis z)."""
    inertia, kind = model.links[number].inertia, model.joints[number - 1].kind
    spatial = spatial_inertia(inertia)
    scale = np.array([np.trace(spatial[:3, :3])] * 3 + [inertia.mass] * 3)[list(kind.free)]
    if not scale.all():
        return False
    along = spatial[np.ix_(kind.free, kind.free)] / np.sqrt(np.outer(scale, scale))
    return bool(np.linalg.eigvalsh(along)[0] > RESISTS)


class ClusterPlanner(SegmentPlanner):
    """Builds the processes and messages of form `ada` with clusters in place of links."""

    def __init__(
        self,
        joints: tuple[PlanJoint, ...],
        schedule: Schedule,
        runs: Sequence[Run],
        clusters: Mapping[int, int],
    ) -> None:
        self.clusters = clusters
        super().__init__(joints, schedule, runs)

    def _belongs(self, node: Node) -> bool:
        own = self.clusters.get(node.joint)
        return own is not None and all(
            self.clusters.get(child.joint) == own for child in node.children
        )


def fold_of(model: Model, form: str) -> Fold:
    """Return the robot as the schedule search of this form sees it.

    Args:
        model: the robot.
        form: "segment" or "ada".
    """
    if form == "ada":
        model = with_artificial_inertia(model)
    runs = runs_of(model)
    clusters = clusters_of(model, runs) if form == "ada" else {}
    return fold(Topology.of(model), runs, clusters.keys())
