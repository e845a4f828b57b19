"""The default schedule: the fastest of all families by predicted time."""

from __future__ import annotations

from typing import Any

from adagen.model import Model
from adagen.paper.search import EXPANSIONS
from adagen.plan import can_gather
from adagen.plan.clusters import fold_of
from adagen.plan.cuts import cuttable_joints
from adagen.program.strips import LANES
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.fold import Fold
from adagen.search.ada_search import played_schedule
from adagen.search.chain_parts import certifies, parted
from adagen.search.closed_loops import closed_schedule
from adagen.search.families import Families, scaled
from adagen.search.schedules import find_schedule

_USUAL = {"strategy": "exact", "split": "always", "tie": "work", "improved": True}
"""The options of a search by default; with any others the search is the paper's."""


def best_schedule(
    model: Model,
    processes: int,
    profile: CostProfile,
    form: str = "segment",
    scalar: str = "double",
    limit: float | None = None,
    gather: bool = True,
    shape: str = "auto",
    in_parts: bool = False,
    certify: bool = False,
    **search: Any,
) -> Schedule:
    """Return a schedule for a form of the algorithm.

    Where the profile has costs of steps, both forms are searched at the price that is played, form
    `ada` from the schedule on that is best by Eq. (11) (ada_search.py), form `segment` by families
    (families.py), at joints alone where cuts lose no digits. By another strategy, split or tie
    than the usual one, and by the paper's profile, Eq. (11) alone counts.

    Args:
        model: the robot.
        processes: P.
        profile: the costs.
        form: of the algorithm.
        scalar: "double" or "float".
        limit: largest growth g at a cut of form `segment`, instead of what suits the scalar.
        gather: whether processes may gather at a core instead of being joined.
        shape: of the code that is emitted, as ``adagen.emit.emit`` takes it.
        in_parts: whether a process may sweep a long chain in parts, one in each SIMD lane.
        certify: whether one process bounds its errors, which only some parts allow, none in float.
        search: further arguments of ``find_schedule``.

    Raises:
        InputError: the robot has no joint, or costs are too large.
        UsageError: an argument is out of range.
    """
    topology, costs = Topology.of(model), profile
    if form == "ada":
        profile = profile.joins_only()
    if model.outputs:  # one process has it all
        search["cuttable"] = [False] * len(topology)
    if model.outputs or model.closed:
        return _held_together(model, processes, profile, form, scalar, **search)
    in_parts = in_parts and profile.steps is not None and not (certify and scalar == "float")
    parts = LANES[scalar] if in_parts else 0
    if form == "segment" and processes == 1:
        whole = find_schedule(topology, 1, profile=profile, **search)
        return _alone(model, whole, profile, scalar, limit, shape, parts, certify)
    seen = fold_of(model, form)
    if form == "segment" and len(seen.topology):
        rules = scalar, limit, gather, shape, parts
        return _by_families(model, seen, processes, profile, *rules, **search)
    best = _joined(seen, processes, profile, **search)
    alone = not len(seen.topology)
    if alone or costs.steps is None or any(search.get(k, v) != v for k, v in _USUAL.items()):
        return best
    return played_schedule(model, best, costs, scalar)


def _alone(
    model: Model,
    whole: Schedule,
    profile: CostProfile,
    scalar: str,
    limit: float | None,
    shape: str,
    parts: int,
    certify: bool,
) -> Schedule:
    """The schedule of one process, with its chain in parts where that is predicted to pay."""
    seen = fold_of(model, "segment")
    found = parted(whole, model, parts if seen.trivial else 0)
    if found is None or (certify and not certifies(found, model)):
        return whole
    families = Families(
        model, seen, whole.processes, profile, 0, scalar, shape, parts, certify=certify
    )
    families.consider(whole, "alone")
    families.part(cuttable_joints(model, scalar, None, limit))
    found = families.taken()
    return found if found.parts else whole


def in_parts_alone(
    model: Model, alone: Schedule, profile: CostProfile, scalar: str, shape: str
) -> Schedule:
    """Return a certified schedule of one process that works, in parts where that pays.

    Args:
        model: the robot.
        alone: the schedule by which one of some processes does everything.
        profile: the costs.
        scalar: "double" or "float"; in float parts lose too many digits to bound errors.
        shape: of the code that is emitted.
    """
    parts = LANES[scalar] if profile.steps is not None and scalar == "double" else 0
    return _alone(model, alone, profile, scalar, None, shape, parts, certify=True)


def _by_families(
    model: Model,
    seen: Fold,
    processes: int,
    profile: CostProfile,
    scalar: str,
    limit: float | None,
    gather: bool,
    shape: str,
    parts: int,
    expansions: int = EXPANSIONS,
    **search: Any,
) -> Schedule:
    """The fastest schedule of form `segment`; by Eq. (11) alone that of joined processes."""
    cuttable = cuttable_joints(model, scalar, seen.joints, limit)
    if profile.steps is None:
        return _joined(seen, processes, profile, cuttable=cuttable, expansions=expansions, **search)
    search["expansions"] = scaled(expansions, len(model.joints))
    parts *= seen.trivial
    families = Families(model, seen, processes, profile, expansions, scalar, shape, parts)
    nowhere = [False] * len(seen.topology)
    families.consider(_joined(seen, processes, profile, cuttable=nowhere, **search), "alone")
    families.part(cuttable)
    if families.settled:
        return families.taken()
    families.consider(_joined(seen, processes, profile, cuttable=cuttable, **search), "joined")
    families.exchange(cuttable)
    families.name(cuttable)
    if gather and can_gather(model):
        alike = seen.trivial and limit is None
        shown = cuttable if alike else cuttable_joints(model, scalar)
        families.halve(shown)
        families.gather(shown)
    families.bound_joined(cuttable)
    return families.taken()


def _joined(seen: Fold, processes: int, profile: CostProfile, **search: Any) -> Schedule:
    """The best schedule of all joints by Eq. (11); of one process where nothing can be cut."""
    if not len(seen.topology):  # all one cluster
        search["cuttable"] = [False] * len(seen.full)
        return find_schedule(seen.full, processes, profile=profile, **search)
    return seen.unfold(find_schedule(seen.topology, processes, profile=profile, **search), profile)


def _held_together(
    model: Model, processes: int, profile: CostProfile, form: str, scalar: str, **search: Any
) -> Schedule:
    """The schedule of a robot with outputs, or with closed loops."""
    if model.outputs:
        return find_schedule(Topology.of(model), processes, profile=profile, **search)
    if form == "ada":  # loops are solved for at the end, whatever the order
        return _joined(fold_of(model, form), processes, profile, **search)
    return closed_schedule(model, processes, profile, scalar, **search)
