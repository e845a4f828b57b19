"""Programs that a calibration builds and times: few, and all different in some coefficient.

Nearly all of the time goes into compiling, so there are as few as possible.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from adagen.calibrate.robots import (
    chain,
    claws,
    crew,
    hollow,
    prescribed,
    robot,
    rubbing,
    squared,
    star,
    tree,
)
from adagen.calibrate.schedules import random_schedule
from adagen.emit.shapes import stepwise
from adagen.executor import Grouping, groupings
from adagen.executor.grouping import spared
from adagen.model import KINDS, Mimic, Model
from adagen.plan import Plan, make_plan
from adagen.plan.certificate import certified
from adagen.plan.simd_groups import COUNTS, simd_groups
from adagen.program import Program, lower
from adagen.program.strips import LANES
from adagen.schedule import CostProfile, Topology, step_costs
from adagen.schedule.costs import ASSUMED, LIMIT

HALVES = ["revolute"] * 10 + ["spherical"] * 10
OTHERS = ["prismatic"] * 8 + ["planar"] * 8
ROWS = ["revolute", "revolute", "revolute", "spherical", "spherical", "prismatic"]
LIMB = ["spherical", "revolute", "spherical"]
TURNED = ["floating", *["revolute"] * 13, *["spherical"] * 5, *["prismatic"] * 5]
BODY = ["floating", *LIMB * 2, "spherical", *LIMB * 2, "spherical"]  # legs, trunk, arms, neck
MIXED = ["revolute", "spherical", "revolute", "prismatic", "planar"]


CHOSEN = (
    ("segment", "halves", 2, 1, "half"),
    ("segment", "rope", 2, 1, "half"),
    ("segment", "rope", 2, 3, "shared"),
    ("segment", "limbs", 2, 2, "shared"),
    ("segment", "limbs", 1, 1, ""),
    ("segment", "rope", 1, 1, ""),
    ("segment", "rope", 2, 1, "gathered"),
    ("segment", "cable", 2, 1, "gathered"),
    ("segment", "cable", 2, 1, "half"),
    ("segment", "cable", 2, 1, "shared"),
    ("segment", "rope", 2, 1, "exchanged"),
    ("segment", "cable", 2, 1, "exchanged"),
    ("segment", "hawser", 1, 1, "parted"),
    ("segment", "rope", 1, 1, "parted"),
    ("segment", "legs", 1, 1, ""),
    ("segment", "paws", 1, 1, ""),
    ("segment", "wings", 1, 1, ""),
    ("segment", "feet", 1, 1, ""),
    ("segment", "arms", 1, 1, ""),
    ("segment", "wings", 2, 1, "gathered"),
    ("segment", "body", 1, 1, ""),
    ("ada", "figure", 2, 3, "mixed"),
    ("ada", "halves", 2, 5, "half"),
    ("segment", "driven", 2, 1, "half"),
    ("ada", "driven", 2, 2, "half"),
    ("segment", "legs", 2, 1, "shared"),
    ("segment", "arms", 2, 1, "shared"),
    ("segment", "arms", 2, 2, "shared"),
    ("segment", "arms", 2, 1, "gathered"),
    ("ada", "figure", 1, 7, "mixed"),
    ("ada", "fence", 2, 1, "half"),
)
"""Forms, robots, numbers of processes, seeds of schedules, and how these are drawn."""
RARE = (
    ("segment", "others", 2, 1, "half"),
    ("ada", "others", 2, 6, "half"),
    ("segment", "halves", 2, 11, "shared"),
    ("segment", "turned", 2, 2, "half"),
    ("segment", "driven", 2, 1, "shared"),
    ("segment", "others", 2, 1, "gathered"),
    ("segment", "track", 2, 1, "half"),
    ("segment", "turns", 2, 1, "shared"),
    ("segment", "vine", 2, 1, "exchanged"),
)
"""Likewise: what tells of rare kinds of joints."""


WAYS = (
    ("fingers", "each", ()),
    ("fingers", "columns", ()),
    ("fingers", "columns", (2,)),
    ("fingers", "columns", (4,)),
    ("toes", "columns", (2,)),
    ("toes", "columns", (4,)),
    ("toes", "columns", (3,)),
    ("hands", "each", ()),
    ("string", "each", ()),
    ("string", "columns", ()),
    ("claws", "columns", (2,)),
    ("claws", "columns", (2, 4)),
    ("crew", "columns", (2, 3, 4)),
    ("troop", "columns", (2, 3, 4)),
    ("mates", "columns", (3,)),
    ("wrist", "each", ()),
    ("wrists", "columns", (2,)),
    ("wrists", "columns", (4,)),
    ("slides", "each", ()),
    ("slides", "columns", ()),
    ("slides", "columns", (2,)),
    ("slides", "columns", (4,)),
    ("balls", "columns", (2,)),
    ("balls", "columns", (4,)),
    ("beads", "columns", (2,)),
    ("beads", "columns", (3,)),
    ("beads", "columns", (4,)),
    ("pearls", "each", ()),
)
"""Robots, methods and numbers of limbs side by side: whatever the price of these would choose."""

CARRIED = (
    ("rope", 1, "half"),
    ("rope", 3, "shared"),
    ("track", 1, "shared"),
    ("others", 1, "shared"),
)
"""Robots, seeds and schedules on two processes, through which unit wrenches are carried by
themselves: runs are swept inwards number by number."""

RUBBING = ("rope", "legs", "paws")
"""Robots on one process that are timed with friction, too."""

TOGETHER = (("crab", "gathered"), ("figure", "gathered"), ("line", "gathered"))
"""Robots and schedules of straight lines on two processes, which tell what it takes to meet."""

ORDERS = (LIMIT, 0.0)
"""Values of the longest line that is ordered by what waits: straight lines are timed with each
of these, since the faster order depends on how many registers hold what is alive."""


@dataclass(frozen=True)
class Wanted:
    """What is built and timed.

    Attributes:
        label: what tables call it.
        plan: its plan.
        shape: of the code.
        limbs: those that each process takes side by side; None where lanes hold states.
        profile: chooses the methods.
        batch: whether each lane holds a state.
    """

    label: str
    plan: Plan
    shape: str
    limbs: Grouping | None
    profile: CostProfile
    batch: bool = False

    @property
    def lowered(self) -> Program:
        """What runs."""
        costs = step_costs(self.profile)
        return lower(self.plan, self.shape, limbs=self.limbs, costs=costs, batch=self.batch)


def stepwise_programs(profile: CostProfile, quick: bool) -> list[Wanted]:
    """Return the programs that go step by step, those of rubbing and of slaved robots last.

    A robot with friction is one of the others for all else.

    What they do does not depend on a profile, so that the same is measured everywhere.

    Args:
        profile: prices the schedules' nodes; of no influence on what is measured.
        quick: leave out ``RARE``: coefficients of rare joint kinds become guesses from others.
    """
    robots = {model.name: model for model in _robots()}
    chosen = CHOSEN if quick else (*CHOSEN, *RARE)
    usual = by_method(profile, "usual")
    found = [
        _program(
            f"{form} {name} P={processes}{how and f', {how}'}",
            _plan(robots[name], form, processes, seed, how, profile),
            COUNTS,
            usual,
        )
        for form, name, processes, seed, how in chosen
    ]
    for name, seed, how in CARRIED:
        plan = _plan(robots[name], "segment", 2, seed, how, profile)
        label = f"segment {name} P=2, {how}, by each"
        found.append(_program(label, plan, (), by_method(profile, "each")))
    for name, method, counts in WAYS:
        plan = _plan(robots[name], "segment", 1, 1, "", profile)
        side = f", {' and '.join(map(str, counts))} side by side" if counts else ""
        label = f"{name} by {method}{side}"
        found.append(_program(label, plan, counts, by_method(profile, method)))
    for name in RUBBING:
        plan = _plan(rubbing(robots[name]), "segment", 1, 1, "", profile)
        found.append(_program(f"segment {name} P=1, with friction", plan, COUNTS, usual))
    slaved = _slaved(robot("slaved", chain(12), ["revolute"], 6))
    for form in ("segment", "ada"):
        plan = _plan(slaved, form, 1, 1, "", profile)
        found.append(_program(f"{form} slaved P=1", plan, COUNTS, usual))
    return found


def by_method(profile: CostProfile, method: str) -> CostProfile:
    """Return a profile whose prices choose a method: the one that is to be measured.

    Args:
        profile: the rest of it.
        method: "each" passes all runs number by number and joint by joint, "columns" takes by
            columns and in strips what can be; "usual" runs of four hinges or more.
    """
    costs = step_costs(profile)
    table = dict(costs.table)
    ends = {"each": LIMIT, "columns": 0.0, "usual": 3.5}[method]
    for kind in KINDS:
        table[f"articulate.{kind}"] = table[f"kinematics.{kind}"] = 1.0
        table[f"articulate_columns.{kind}"] = table[f"kinematics_strips.{kind}"] = 0.0
    table["articulate_columns.spherical"] = 2.0  # so much dearer than number by number
    table["articulate.run"] = 0.0
    table["articulate_columns.run"] = table["kinematics_strips.run"] = ends
    return replace(profile, steps=replace(costs, table=table))


def _program(label: str, plan: Plan, counts: Sequence[int], profile: CostProfile) -> Wanted:
    """A program that goes step by step, with as many limbs side by side as there can be."""
    shape = stepwise(plan)
    limbs: Grouping = tuple(() for _ in plan.processes)
    if shape == "kernels" and counts:
        limbs = tuple(
            tuple(simd_groups(plan, process, spared, counts)) for process in plan.processes
        )
    return Wanted(label, plan, shape, limbs, profile)


def _robots() -> Iterator[Model]:
    """Yield the robots of ``CHOSEN`` and ``RARE``."""
    yield robot("halves", chain(20), HALVES, 1)
    yield robot("others", chain(16), OTHERS, 2)
    yield robot("figure", tree(22, 0.3, 4), ["floating", *MIXED * 5][:22], 4)
    yield robot("limbs", [0, *tree(24, 0.3, 7)[1:]], ["floating", *["revolute"] * 23], 5)
    yield robot("legs", star(4, 8), ["floating", *["revolute"] * 32], 9)
    yield robot("paws", star(4, 3), ["floating", *["revolute"] * 12], 13)
    yield robot("wings", star(2, 9), ["revolute"], 14)
    yield robot("feet", star(4, 4), ["revolute", *ROWS[2:] * 4], 11)
    yield robot("arms", star(2, 6), ["revolute", *ROWS * 2], 10)
    yield robot("cable", chain(120), ["revolute"] * 90 + ["spherical"] * 30, 17)
    yield robot("rope", chain(40), ["revolute"], 12)
    yield robot("hawser", chain(240), ["revolute"], 38)
    yield robot("fingers", star(8, 2), ["revolute"], 18)
    yield robot("toes", star(12, 1), ["revolute"], 19)
    yield robot("hands", star(4, 5), ["revolute"], 20)
    yield robot("string", chain(12), ["revolute"], 21)
    yield robot("claws", claws(2, 6, 3, 2), ["revolute"], 23)
    yield robot("crew", crew((4, 6), (3, 2), (4, 1), (2, 1)), ["floating", *["revolute"] * 36], 26)
    yield robot("troop", crew((2, 8), (4, 2), (1, 5), (3, 1)), ["revolute"], 27)
    yield robot("mates", star(6, 3), ["floating", *["revolute"] * 18], 28)
    yield hollow(robot("wrist", star(1, 12), ["revolute"], 24))
    yield hollow(robot("wrists", star(4, 3), ["revolute"], 25))
    yield robot("body", [0, 1, 2, 3, 1, 5, 6, 1, 8, 9, 10, 8, 12, 13, 8], BODY, 15)
    yield robot("turned", chain(24), TURNED, 8)
    yield robot("slides", star(4, 6), ["revolute", *["prismatic"] * 24], 31)
    yield robot("balls", star(4, 4), ["revolute", *["spherical"] * 16], 32)
    yield robot("beads", star(4, 12), ["revolute", *["spherical"] * 48], 39)
    yield robot("pearls", chain(15), ["revolute", *["spherical"] * 14], 40)
    yield robot("track", chain(40), ["revolute", "prismatic", "spherical"], 33)
    yield robot("vine", chain(80), ["revolute", "spherical"], 36)
    yield robot("turns", chain(24), ["spherical"], 34)
    yield robot("fence", [0, 1, 0, 3, 0, 5, 0, 7, 0, 0, 0, 0], ["revolute"], 35)
    yield prescribed(robot("driven", chain(20), ROWS, 16))


def in_order(profile: CostProfile, urgent: float, cache: float) -> CostProfile:
    """Return a profile by which straight lines are in another order.

    Args:
        profile: the rest of it.
        urgent: values of the longest line that is ordered by what waits.
        cache: bytes of the first instruction cache.
    """
    costs = step_costs(profile)
    own = {"unrolled.urgent": urgent, "unrolled.ahead": ASSUMED["unrolled.ahead"]}
    table = {**costs.table, **own, "unrolled.cache": cache}
    return replace(profile, steps=replace(costs, table=table))


def straight_programs(profile: CostProfile) -> list[Wanted]:
    """Return the programs that are straight lines of statements, in the order of a profile.

    Their operations for each degree of freedom differ, and so does what waits for what; some are so
    long that their instructions are fetched anew in each evaluation, and some have limbs in lanes;
    the longest, with and without lanes, are taken in one grouping each. Limbs of single joints in
    lanes, of grippers, are mostly numbers moved. Those of ``TOGETHER`` come last.
    """
    robots = [
        robot("pair", chain(2), ["revolute"], 1),
        robot("oblique", chain(4), ["revolute"], 1),
        squared(robot("arm", chain(14), ["revolute"], 1)),
        squared(robot("hand", star(4, 3), ["revolute"], 1)),
        squared(robot("balls", chain(5), ["spherical"], 1)),
        robot("tangle", chain(16), ["revolute"], 1),
        squared(robot("line", chain(40), ["revolute"], 1)),
        robot("crab", star(4, 4), ["revolute"], 22),
        squared(robot("beast", star(4, 3), ["floating", *["revolute"] * 12], 29)),
        squared(robot("figure", crew((2, 6), (2, 7)), ["floating", *["revolute"] * 26], 30)),
        squared(robot("porter", claws(2, 7, 4, 1), ["revolute"], 31)),
        squared(robot("palm", crew((4, 5), (4, 1), (2, 1)), ["revolute"], 33)),
    ]
    long = [
        squared(robot("twine", chain(46), ["revolute"], 3)),
        squared(robot("cord", chain(64), ["revolute"], 2)),
        squared(robot("swarm", crew((4, 20), (2, 30)), ["floating", *["revolute"] * 140], 37)),
    ]
    robots += long
    by_name = {model.name: model for model in robots}
    plans = [_plan(model, "segment", 1, 1, "", profile) for model in robots]
    plans += [_plan(by_name[name], "segment", 2, 1, how, profile) for name, how in TOGETHER]
    found = []
    for plan in plans:
        offers = groupings(plan)
        if len(plan.processes) > 1:
            offers = offers[-1:]
        elif plan.name in {model.name for model in long}:
            offers = offers[1:2] or offers
        for limbs in offers:
            counts = [each.count for own in limbs for each in own]
            side = f", {' + '.join(map(str, counts))} side by side" if counts else ""
            label = f"straight {plan.name} P={len(plan.processes)}{side}"
            found.append(Wanted(label, plan, "unrolled", limbs, profile))
    return found


def batch_programs(profile: CostProfile) -> list[Wanted]:
    """Return the programs of batches: straight lines, and loops over joints of each kind.

    Some loops are over joints in their own axes, some are certified, and some with friction.
    """
    robots = {
        "unrolled": [
            robot("pair", chain(2), ["revolute"], 1),
            squared(robot("arm", chain(7), ["revolute"], 1)),
            robot("tangle", chain(16), ["revolute"], 1),
            squared(robot("balls", chain(5), ["spherical"], 1)),
            squared(robot("hand", star(4, 4), ["revolute"], 1)),
            squared(robot("beast", star(4, 3), ["floating", *["revolute"] * 12], 29)),
            squared(robot("figure", crew((2, 6), (2, 7)), ["floating", *["revolute"] * 26], 30)),
        ],
        "kernels": [
            robot("rope", chain(40), ["revolute"], 12),
            rubbing(robot("rubbing rope", chain(40), ["revolute"], 12)),
            robot("turns", chain(24), ["spherical"], 34),
            robot("others", chain(16), OTHERS, 2),
            robot("rails", chain(16), ["prismatic"], 41),
            robot("raft", [0] * 6, ["floating"], 42),
            robot("legs", star(4, 8), ["floating", *["revolute"] * 32], 9),
            hollow(robot("tails", star(4, 9), ["floating", *["revolute"] * 36], 9)),
        ],
    }
    found = [
        Wanted(
            f"batch {'of loops ' if shape == 'kernels' else ''}{model.name}",
            _plan(model, "segment", 1, 1, "", profile),
            shape,
            None,
            profile,
            batch=True,
        )
        for shape, models in robots.items()
        for model in models
    ]
    sure = [
        replace(each, label=f"{each.label}, certified", plan=certified(each.plan))
        for each in found
        if each.plan.name in ("rope", "legs")
    ]
    return found + sure


def _plan(
    model: Model, form: str, processes: int, seed: int, how: str, profile: CostProfile
) -> Plan:
    schedule = random_schedule(
        Topology.of(model),
        processes,
        profile,
        seed,
        share={"mixed": 0.3, "shared": 0.3, "": 0.2}.get(how, 0.45),
        mixed=how == "mixed",
        shared=how == "shared",
    )
    if how == "gathered":
        schedule = replace(schedule, meeting="gather")
    if how == "exchanged":
        schedule = replace(schedule, meeting="exchange")
    if how == "parted":
        schedule = replace(schedule, parts=LANES["double"])
    return make_plan(model, schedule, form=form)


def _slaved(model: Model) -> Model:
    """Return a robot with two joints slaved to another."""
    joints = list(model.joints)
    for j in (4, 9):
        joints[j] = replace(joints[j], mimic=Mimic(1, 0.5, 0.1))
    return replace(model, joints=tuple(joints))
