"""Which programs a calibration builds and times: few, small, and different in every coefficient.

Nearly all of its time is the compiler's, so that each program must earn its place.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from adagen.calibrate.robots import chain, prescribed, robot, squared, star, tree
from adagen.calibrate.schedules import random_schedule
from adagen.model import Mimic, Model
from adagen.plan import Plan, make_plan
from adagen.schedule import CostProfile, Topology

HALVES = ["revolute"] * 10 + ["spherical"] * 10
OTHERS = ["prismatic"] * 8 + ["planar"] * 8
ROWS = ["revolute", "revolute", "revolute", "spherical", "spherical", "prismatic"]
LIMB = ["spherical", "revolute", "spherical"]
TURNED = ["floating", *["revolute"] * 13, *["spherical"] * 5, *["prismatic"] * 5]
BODY = ["floating", *LIMB * 2, "spherical", *LIMB * 2, "spherical"]  # legs, trunk, arms, neck
MIXED = ["revolute", "spherical", "revolute", "prismatic", "planar"]


CHOSEN = (
    ("segment", "halves", 2, 1, "half"),
    ("segment", "limbs", 2, 2, "shared"),
    ("segment", "limbs", 1, 1, ""),
    ("segment", "rope", 1, 1, ""),
    ("segment", "rope", 2, 1, "gathered"),
    ("segment", "cable", 2, 1, "gathered"),
    ("segment", "legs", 1, 1, ""),
    ("segment", "paws", 1, 1, ""),
    ("segment", "wings", 1, 1, ""),
    ("segment", "feet", 1, 1, ""),
    ("segment", "arms", 1, 1, ""),
    ("segment", "body", 1, 1, ""),
    ("ada", "figure", 2, 3, "mixed"),
    ("ada", "halves", 2, 5, "half"),
    ("segment", "driven", 2, 1, "half"),
    ("ada", "driven", 2, 2, "half"),
)
"""Forms, robots, numbers of processes, seeds of schedules, and how these are drawn."""
RARE = (
    ("segment", "others", 2, 1, "half"),
    ("ada", "others", 2, 6, "half"),
    ("segment", "halves", 2, 11, "shared"),
    ("segment", "turned", 2, 2, "half"),
)
"""Likewise: what tells of rare kinds of joints."""


def calibration_plans(profile: CostProfile, quick: bool) -> list[tuple[str, Plan]]:
    """Return labels and plans, those of the slaved robot last.

    Args:
        profile: prices the schedules' nodes; of no influence on what is measured.
        quick: leave out ``RARE``: coefficients of rare joint kinds become guesses from others.
    """
    robots = {model.name: model for model in _robots()}
    chosen = CHOSEN if quick else (*CHOSEN, *RARE)
    found = [
        (f"{form} {name} P={processes}", _plan(robots[name], form, processes, seed, how, profile))
        for form, name, processes, seed, how in chosen
    ]
    slaved = _slaved(robot("slaved", chain(12), ["revolute"], 6))
    return [*found, ("segment slaved P=1", _plan(slaved, "segment", 1, 1, "", profile))]


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
    yield robot("body", [0, 1, 2, 3, 1, 5, 6, 1, 8, 9, 10, 8, 12, 13, 8], BODY, 15)
    yield robot("turned", chain(24), TURNED, 8)
    yield prescribed(robot("driven", chain(20), ROWS, 16))


def straight_plans(profile: CostProfile) -> list[tuple[str, Plan]]:
    """Return labels and plans of robots that are carried out as straight lines of statements.

    Their operations for each degree of freedom differ, and so does what waits for what; two are so
    long that their instructions are fetched anew in each evaluation.
    """
    robots = [
        robot("pair", chain(2), ["revolute"], 1),
        robot("oblique", chain(4), ["revolute"], 1),
        squared(robot("arm", chain(14), ["revolute"], 1)),
        squared(robot("hand", star(4, 3), ["revolute"], 1)),
        squared(robot("balls", chain(5), ["spherical"], 1)),
        robot("tangle", chain(16), ["revolute"], 1),
        squared(robot("line", chain(40), ["revolute"], 1)),
    ]
    return [
        (f"straight {model.name}", _plan(model, "segment", 1, 1, "", profile)) for model in robots
    ]


def _plan(
    model: Model, form: str, processes: int, seed: int, how: str, profile: CostProfile
) -> Plan:
    schedule = random_schedule(
        Topology.of(model),
        processes,
        profile,
        seed,
        share={"half": 0.45, "gathered": 0.45, "mixed": 0.3, "shared": 0.3}.get(how, 0.2),
        mixed=how == "mixed",
        shared=how == "shared",
    )
    if how == "gathered":
        schedule = replace(schedule, meeting="gather")
    return make_plan(model, schedule, form=form)


def _slaved(model: Model) -> Model:
    """Return a robot with two joints slaved to another."""
    joints = list(model.joints)
    for j in (4, 9):
        joints[j] = replace(joints[j], mimic=Mimic(1, 0.5, 0.1))
    return replace(model, joints=tuple(joints))
