"""Certificates of emitted solvers: bounds beside true errors, and what they take in time.

    python -m benchmarks.certificates errors [--robots 24] [--states 400] [--seed 1]
                                             [--record FILE] [--write FILE]
    python -m benchmarks.certificates balanced [the same]
    python -m benchmarks.certificates loops [the same]
    python -m benchmarks.certificates shared [the same]
    python -m benchmarks.certificates chains [the same]
    python -m benchmarks.certificates predicted [the same]
    python -m benchmarks.certificates times [ROBOT.urdf ...] [--write FILE]
    python -m benchmarks.certificates real [NAME or ROBOT.urdf ...] [--write FILE]
    python -m benchmarks.certificates mechanisms [NAME ...] [--write FILE]

Errors are those of hard states of random robots of twelve families (adagen/studies/stability), in
the energy norm against certified accelerations; "shared" takes trees whose limbs two or three
threads share, long arms that two share, and batches that two processes of MPI share; "chains" takes
long chains of hinges, whole and in parts, one in each SIMD lane; "balanced" takes torques that
balance strong dampers, springs and friction; "loops" takes
mechanisms with closed loops, half of their states as near singular ones as are found, and compares
with the plan in 400 bits: which rows are left out where they follow from others is its choice, and
a state in doubles closes loops up to rounding only. Times are minima of runs with and without
certificates by turns, of robots or, for "mechanisms", of benchmarks/closed_robots.py; loops are in
a scene of the robot's name beside it, as of other files. "real" takes robots of
benchmarks/choice.py, or files, in the shape that is chosen by the profile of this machine's
processor, and medians. "predicted" lays the largest
error of each robot of "errors" beside the one that is predicted for it in hard poses, errors above
1 counted as 1. With --record, what was found of each robot is a line of JSON in a file: the command
again goes on with the robots that are not there yet. Each table has a file of its own.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

import adagen
from adagen.build import Toolchain, find_toolchain
from adagen.build.processor import processor_family
from adagen.build.registers import widest_register
from adagen.errors import AdagenError
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.certificate import certified
from adagen.schedule import load_profile
from adagen.schedule.profile import shipped_for
from adagen.search import best_schedule
from adagen.search.objective import predicted_digits
from adagen.states import States
from adagen.studies.bench.report import table
from benchmarks.choice import ROBOTS as REAL
from benchmarks.closed_robots import MECHANISMS
from benchmarks.hard import Asked, fastest, hard_mechanisms, hard_robots, raced, study
from benchmarks.page import MODELS, Record
from benchmarks.solvers import source_of, tell
from benchmarks.stability.adversary import arms, long_chains, trees
from benchmarks.stability.balanced import balanced
from benchmarks.stability.bounds import FACTOR, Bounded, Certified, bounded, certified_plan

SIZES = 0, 7  # powers of ten between which passive forces are that torques balance
PAIRS = 21  # rounds, in each of which the plain solver and the certified one have a turn
TIMED = ("plain, ns", "certified, ns", "ratio")
EVERY = 1000  # rows that a loop sweeps: more than robots have
WAYS = [
    Certified("unrolled"),
    Certified("kernels"),
    Certified("unrolled", batch=True),
    Certified("kernels", batch=True),
    Certified("unrolled", scalar="float"),
    Certified("kernels", scalar="float"),
    Certified("unrolled", looped=EVERY),
    Certified("unrolled", scalar="float", looped=EVERY),
]
SHARED = [
    Certified("unrolled", processes=2),
    Certified("kernels", processes=2),
    Certified("kernels", processes=3),
    Certified("kernels", processes=2, scalar="float"),
    Certified("unrolled", processes=2, elsewhere=True),
    Certified("kernels", processes=2, elsewhere=True),
    Certified("kernels", processes=2, elsewhere=True, scalar="float"),
    Certified("unrolled", batch=True, processes=2),
    Certified("kernels", batch=True, processes=2),
]
PARTED = [
    Certified("kernels"),
    Certified("kernels", parts=True),
    Certified("unrolled", parts=True),
    Certified("kernels", scalar="float", parts=True),
]
LOOPED = [
    Certified("unrolled"),
    Certified("unrolled", batch=True),
    Certified("unrolled", looped=EVERY),
]
ROBOTS = [
    str(MODELS / f"{name}.urdf")
    for name in ("arm7", "chain16", "humanoid", "human40", "fourbar", "ankle")
]
SHAPES = [(shape, batch) for batch in (False, True) for shape in ("unrolled", "kernels")]


def errors_table(found: Mapping[tuple[str, str], Sequence[Bounded]]) -> list[str]:
    """Return the table of bounds and errors, by way and family."""
    rows = []
    for (way, family), parts in found.items():
        errors = np.concatenate([one.errors for one in parts])
        bounds = np.concatenate([one.bounds for one in parts])
        refused = sum(one.refused for one in parts)
        if not errors.size:
            continue
        ratios = np.concatenate([one.ratios for one in parts])
        pessimism = np.median(bounds / np.maximum(errors, 1e-300))
        cells = (
            *(way, family, errors.size, refused, f"{errors.max():.0e}", f"{bounds.max():.0e}"),
            *(f"{pessimism:.2g}", f"{ratios.max():.2f}", int((ratios > FACTOR).sum())),
        )
        rows.append(cells)
    head = ("emitted", "robots", "evaluations", "refused", "largest error", "largest bound")
    more = ("bound / error, median", "error / bound, largest", "above 3")
    lines = table((*head, *more), rows)
    evaluations = sum(one.errors.size for parts in found.values() for one in parts)
    exceeded = sum(int((one.ratios > FACTOR).sum()) for parts in found.values() for one in parts)
    return [*lines, "", f"{evaluations} evaluations, {exceeded} bounds exceeded by more than 3."]


def measured_errors(asked: Asked, record: Record, toolchain: Toolchain) -> list[str]:
    """Return the table of random robots."""
    return _measured(hard_robots(asked), WAYS, asked, record, toolchain)


def measured_balanced(asked: Asked, record: Record, toolchain: Toolchain) -> list[str]:
    """Return the table of random robots whose torques balance strong passive forces."""
    return _measured(_balanced(asked), WAYS, asked, record, toolchain)


def _balanced(asked: Asked) -> Iterator[tuple[str, Model, States]]:
    for k, (family, model, hard) in enumerate(hard_robots(asked)):
        size = 10.0 ** np.random.default_rng((asked.seed, k)).uniform(*SIZES)
        yield family, *balanced(model, hard, size, asked.seed + k)


def measured_loops(asked: Asked, record: Record, toolchain: Toolchain) -> list[str]:
    """Return the table of random mechanisms."""
    return _measured(hard_mechanisms(asked), LOOPED, asked, record, toolchain)


def measured_shared(asked: Asked, record: Record, toolchain: Toolchain) -> list[str]:
    """Return the table of trees and arms that threads share, or processes of MPI the states of."""
    return _measured(hard_robots(asked, [trees, arms]), SHARED, asked, record, toolchain)


def measured_chains(asked: Asked, record: Record, toolchain: Toolchain) -> list[str]:
    """Return the table of bounds of long chains, whole and in parts."""
    return _measured(hard_robots(asked, [long_chains]), PARTED, asked, record, toolchain)


def _measured(
    robots: Iterable[tuple[str, Model, States]],
    ways: Sequence[Certified],
    asked: Asked,
    record: Record,
    toolchain: Toolchain,
) -> list[str]:
    found: dict[tuple[str, str], list[Bounded]] = {}
    for k, (family, model, hard) in enumerate(robots):
        find = partial(_figures, model, hard, ways, toolchain)
        for way, one in record.of(asked.key(k), find).items():
            errors, bounds = np.array(one["errors"]), np.array(one["bounds"])
            parts = found.setdefault((way, family), [])
            parts.append(Bounded(errors, bounds, one["refused"]))
    order = [str(way) for way in ways]
    return errors_table(dict(sorted(found.items(), key=lambda item: order.index(item[0][0]))))


def _figures(
    model: Model, states: States, ways: Sequence[Certified], toolchain: Toolchain
) -> dict[str, dict[str, Any]]:
    """What became of a robot's states, for each way, as JSON has it."""
    return {
        str(way): {
            "errors": [float(f"{x:.4g}") for x in one.errors],
            "bounds": [float(f"{x:.4g}") for x in one.bounds],
            "refused": one.refused,
        }
        for way, one in bounded(model, states, list(ways), toolchain).items()
    }


def measured_predictions(asked: Asked, record: Record, toolchain: Toolchain) -> list[str]:
    """Return the table of largest errors beside those that are predicted in hard poses."""
    ways = [way for way in WAYS if not way.batch]
    ratios: dict[str, list[tuple[float, str]]] = {str(way): [] for way in ways}
    for k, (family, model, hard) in enumerate(hard_robots(asked)):
        found = record.of(asked.key(k), partial(_figures, model, hard, ways, toolchain))
        for way in ways:
            errors = found.get(str(way), {}).get("errors")
            if errors:
                plan = certified_plan(model, way.scalar)
                told = predicted_digits("time", model, plan, way.shape).anywhere
                found_once = min(1.0, max(max(errors), 1e-17))  # more than 1 is as wrong as 1
                decades = np.log10(found_once / max(told, 1e-17))
                ratios[str(way)].append((float(decades), family))
    lines = []
    for name, rows in ratios.items():
        decades = np.array([row[0] for row in rows])
        worst = ", ".join(f"{x:.1f} ({family})" for x, family in sorted(rows)[:-4:-1])
        near, beyond = np.mean(abs(decades) <= 1), np.mean(decades > 0.5)
        cells = (name, len(rows), f"{near:.0%}", f"{beyond:.0%}", f"{np.median(decades):.1f}")
        lines.append((*cells, worst))
    optimistic = "more than half a decade too optimistic"
    head = ("emitted", "robots", "within a decade", optimistic, "median, decades")
    return list(table((*head, "worst, decades"), lines))


def measured_times(files: Sequence[str]) -> list[str]:
    """Return the table of times of robots."""
    rows = []
    for path in map(Path, files):
        robot = _of_file(path)
        for shape, batch in SHAPES:
            try:
                plain, certified = fastest(robot.model, _made(robot, shape=shape, batch=batch))
            except AdagenError as error:
                tell(f"{path.stem}, {shape}: {error}")
                continue
            name, ratio = f"{shape}{', batch' * batch}", f"{certified / plain:.2f}"
            rows.append((path.stem, name, f"{plain:.0f}", f"{certified:.0f}", ratio))
    return list(table(("robot", "shape", *TIMED), rows))


def _of_file(path: Path) -> adagen.Robot:
    """Return the robot of a file, in the scene of its name beside it."""
    scene = path.with_suffix(".toml")
    return adagen.read(path, scene=scene if scene.exists() else None)


def measured_real(names: Sequence[str]) -> list[str]:
    """Return the table of times of real robots or files, as ``--shape auto`` emits them here.

    Medians of rounds; a ratio is the median of those of two turns of one round, between which a
    machine that others share hardly changes its speed.
    """
    profile = shipped_for(widest_register(find_toolchain()), processor_family())
    tell(f"profile {profile}")
    rows = []
    for name in names:
        if name in REAL:
            file, floating = REAL[name]
            robot = adagen.read(file, floating=floating)
        else:
            robot = _of_file(Path(name))
        cells = [Path(name).stem, str(robot.model.nv)]
        for batch in (False, True):
            plain, certified = raced(robot.model, _made(robot, profile=profile, batch=batch), PAIRS)
            ratio = median(b / a for a, b in zip(plain.turns, certified.turns, strict=True))
            cells += [f"{plain.median:.0f}", f"{certified.median:.0f}", f"{ratio:.2f}"]
        tell(" ".join(cells))
        rows.append(cells)
    head = ("robot", "DOF", *TIMED, *(f"batch: {what}" for what in TIMED))
    return list(table(head, rows))


def _made(robot: adagen.Robot, **asked: Any) -> dict[str, tuple[Plan, str]]:
    """Return a robot's plain solver and the certified one: plans and sources."""
    made = {str(k): adagen.compile(robot, certify=bool(k), **asked) for k in (0, 1)}
    return {name: (one.plan, one.source) for name, one in made.items()}


def measured_mechanisms(names: Sequence[str]) -> list[str]:
    """Return the table of times of mechanisms, plain and certified."""
    rows = []
    profile = load_profile("default")
    for name in names:
        model = MECHANISMS[name]()
        plain = make_plan(model, best_schedule(model, 1, profile))
        cells = [name]
        for batch in (0, 1):
            try:
                plans = [plain, certified(plain)]
            except AdagenError as error:
                tell(f"{name}: {error}")
                break
            sources = [source_of(each, shape="unrolled", batch=batch) for each in plans]
            solvers = {str(k): both for k, both in enumerate(zip(plans, sources, strict=True))}
            least = fastest(model, solvers)
            cells += [*(f"{x:.0f}" for x in least), f"{least[1] / least[0]:.2f}"]
        else:
            rows.append(cells)
    head = ("mechanism", "plain, ns", "certified, ns", "ratio", "batch: plain", "certified")
    return list(table((*head, "ratio"), rows))


def main() -> None:
    """Print a table, or put it into a document."""
    usual = Asked(24, 400, 1)
    tables = {
        "errors": measured_errors,
        "balanced": measured_balanced,
        "loops": measured_loops,
        "shared": measured_shared,
        "chains": measured_chains,
        "predicted": measured_predictions,
    }
    times = {
        "times": (measured_times, ROBOTS),
        "real": (measured_real, tuple(REAL)),
        "mechanisms": (measured_mechanisms, tuple(MECHANISMS)),
    }
    study("certificates", __doc__, usual, tables, times)


if __name__ == "__main__":
    main()
