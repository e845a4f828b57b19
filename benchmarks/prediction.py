"""Predicted against measured times, over models and schedules, at P = 1, 2 and 4.

    python benchmarks/prediction.py measure FILE.json      builds and times; takes long
    python benchmarks/prediction.py report FILE.json [--profile NAME] > docs/prediction.md

Programs of one model are timed in turn, several times over, and the least median is kept: other
work on the machine only ever adds to a time. Where there are more processes than cores, times are
from measured stretches of computing (docs/benchmarks.md); the report says so of each.
"""

from __future__ import annotations

import argparse
import dataclasses
import json
import sys
import sysconfig
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from adagen.build import Toolchain, find_toolchain
from adagen.calibrate.measure import Measurement, Program, least
from adagen.calibrate.robots import chain, robot, star, tree
from adagen.calibrate.schedules import random_schedule
from adagen.errors import AdagenError
from adagen.model import Model
from adagen.plan import make_plan, plan_from_json, plan_to_json
from adagen.predict import best_schedule, predict
from adagen.schedule import Schedule, Topology, find_schedule, load_profile
from adagen.urdf import read_robot

ROUNDS = 5
REPEAT = 30
EXAMPLES = (
    ("ur5", "ur_description/urdf/ur5_robot.urdf", False),
    ("panda", "panda_description/urdf/panda.urdf", False),
    ("anymal", "anymal_b_simple_description/robots/anymal.urdf", True),
    ("g1", "g1_description/urdf/g1_29dof_rev_1_0.urdf", True),
    ("talos", "talos_data/robots/talos_reduced.urdf", True),
    ("icub", "icub_description/robots/icub.urdf", True),
    ("simple_humanoid", "simple_humanoid_description/urdf/simple_humanoid.urdf", True),
)


def models() -> Iterator[Model]:
    """Yield the robots; those of example-robot-data where it is installed."""
    yield robot("chain24", chain(24), ["revolute"], 11)
    yield robot("spherical16", chain(16), ["spherical"], 12)
    yield robot("star5x5", star(5, 5), ["revolute"], 13)
    yield robot("tree30", tree(30, 0.3, 5), ["revolute", "revolute", "prismatic"], 14)
    yield robot("figure", [0, *tree(20, 0.25, 9)[1:]], ["floating", *["spherical"] * 15], 15)
    yield robot("chain48", chain(48), ["revolute"], 16)
    folder = Path(sysconfig.get_path("purelib"), "cmeel.prefix/share/example-robot-data/robots")
    for name, path, floating in EXAMPLES:
        if (folder / path).is_file():
            reading = read_robot(str(folder / path), floating=floating)
            yield dataclasses.replace(reading.model, name=name)


def schedules(model: Model) -> Iterator[tuple[str, Schedule]]:
    """Yield the schedules that are compared, each with a label: form, processes, how it is made."""
    topology, profile = Topology.of(model), load_profile("default")
    best = find_schedule(topology, 2, profile=profile)
    single = find_schedule(topology, 1, profile=profile)

    def made(seed: int, processes: int, share: float, mixed: bool) -> Schedule:
        return random_schedule(topology, processes, profile, seed, share=share, mixed=mixed)

    yield "segment, P=1", single
    yield "segment, P=2, searched", best
    yield "segment, P=2, gathered", best_schedule(model, 2, profile)
    for seed, share in ((1, 0.35), (2, 0.25), (3, 0.0)):
        yield f"segment, P=2, random {seed}", made(seed, 2, share, False)
    yield "segment, P=4, searched", find_schedule(topology, 4, profile=profile)
    yield "segment, P=4, gathered", best_schedule(model, 4, profile)
    yield "ada, P=1, random", made(5, 1, 0.0, True)
    yield "ada, P=2, searched", best
    yield "ada, P=2, random orders", made(7, 2, 0.3, True)


def build(
    model: Model, toolchain: Toolchain, labelled: tuple[str, Schedule]
) -> tuple[str, Program] | None:
    """Return a schedule's program; None where its form cannot treat the robot."""
    label, schedule = labelled
    try:
        plan = make_plan(model, schedule, form=label.split(",")[0])
        return label, Program(plan, toolchain)
    except AdagenError as error:
        print(f"{model.name}: {label}: {str(error)[:200]}", file=sys.stderr)
        return None


def measure(path: Path) -> None:
    """Build and time all, appending to the file model by model."""
    toolchain = find_toolchain()
    rows: list[dict[str, Any]] = json.loads(path.read_text()) if path.exists() else []
    done = {row["model"] for row in rows}
    for model in models():
        if model.name in done:
            continue
        print(model.name, file=sys.stderr, flush=True)
        with ThreadPoolExecutor(2) as pool:
            built = list(pool.map(partial(build, model, toolchain), schedules(model)))
        programs = [pair for pair in built if pair is not None]
        found: list[list[Measurement]] = [[] for _ in programs]
        for _ in range(ROUNDS):
            for (_, program), all_of_it in zip(programs, found, strict=True):
                all_of_it.append(program.measure(repeat=REPEAT))
        for (label, program), all_of_it in zip(programs, found, strict=True):
            rows.append(
                {
                    "model": model.name,
                    "label": label,
                    "plan": plan_to_json(program.plan),
                    "measured": dataclasses.asdict(least(all_of_it)),
                }
            )
        path.write_text(json.dumps(rows))


@dataclasses.dataclass(frozen=True)
class Row:
    """A program's measured and predicted time, microseconds; ``played`` if from stretches."""

    model: str
    label: str
    measured: float
    predicted: float
    fastest: float
    played: bool

    @property
    def error(self) -> float:
        """Relative error of the prediction."""
        return self.predicted / self.measured - 1


def spearman(a: Sequence[float], b: Sequence[float]) -> float:
    """Return the rank correlation of two lists without many ties."""
    ranks = [np.argsort(np.argsort(x, kind="stable"), kind="stable") for x in (a, b)]
    return float(np.corrcoef(ranks[0], ranks[1])[0, 1])


def report(path: Path, profile: str, machine: str) -> str:
    """Return docs/prediction.md."""
    costs = load_profile(profile)
    rows = [
        Row(
            row["model"],
            row["label"],
            row["measured"]["time"],
            predict(plan_from_json(row["plan"]), costs).makespan,
            row["measured"]["best"],
            row["measured"]["source"] == "stretches",
        )
        for row in json.loads(path.read_text())
    ]
    names = list(dict.fromkeys(row.model for row in rows))
    lines = [*_summary(rows, names, costs.name, machine), *_by_model(rows, names), *_all(rows)]
    return "\n".join(lines) + "\n"


def _summary(rows: list[Row], names: list[str], profile: str, machine: str) -> Iterator[str]:
    yield "# Predicted against measured times\n"
    yield f"Machine: {machine}. Profile: `{profile}`. {len(names)} robots, {len(rows)} programs.\n"
    yield (
        "Made by `python benchmarks/prediction.py measure FILE` and `... report FILE`: every "
        "schedule is emitted, built\nand timed with state and result in place (median over 64 "
        "random states, the least of several interleaved\nruns); the prediction plays the steps of "
        "its plan through ([profiles](profiles.md)). No measured time is used to\npredict: the "
        "profile comes from `adagen calibrate`, whose robots are others.\n"
    )
    yield "| programs | count | median error | 90 % below | largest | rank correlation |"
    yield "|---|---|---|---|---|---|"
    for title, wanted in (
        ("all", ""),
        ("form segment", "segment"),
        ("form segment, P = 1", "segment, P=1"),
        ("form segment, P = 2", "segment, P=2"),
        ("form segment, P = 4", "segment, P=4"),
        ("form ada", "ada"),
    ):
        some = [row for row in rows if row.label.startswith(wanted)]
        if not some:
            continue
        title += ", from stretches" if all(row.played for row in some) else ""
        sizes = sorted(abs(row.error) for row in some)
        rank = spearman([r.predicted for r in some], [r.measured for r in some])
        yield (
            f"| {title} | {len(some)} | {median(sizes):.1%} | "
            f"{sizes[int(0.9 * (len(sizes) - 1))]:.1%} | {sizes[-1]:.1%} | {rank:.3f} |"
        )
    some = [abs(row.predicted / row.fastest - 1) for row in rows]
    rank = spearman([r.predicted for r in rows], [r.fastest for r in rows])
    yield (
        f"| all, against the fastest evaluation | {len(rows)} | {median(some):.1%} | "
        f"{sorted(some)[int(0.9 * (len(some) - 1))]:.1%} | {max(some):.1%} | {rank:.3f} |"
    )
    yield ""
    yield (
        "The fastest evaluation is what the machine does undisturbed: with two processes on two "
        "cores, whatever else\nruns delays one of them in many evaluations, and the median too.\n"
    )
    if any(row.played for row in rows):
        yield (
            "≈: more processes than cores. A wall time means nothing then; what each process "
            "computes between messages is\nmeasured by itself, and played through with what the "
            "shipped profile says of messages ([benchmarks](benchmarks.md)).\n"
        )


def _by_model(rows: list[Row], names: list[str]) -> Iterator[str]:
    yield "## The order of schedules\n"
    yield (
        "For each robot: the rank correlation over all of its programs, and how much slower the "
        "schedule that is\npredicted to be the fastest really is than the fastest one.\n"
    )
    yield "| robot | programs | median error | rank correlation | lost by trusting the prediction |"
    yield "|---|---|---|---|---|"
    for name in names:
        some = [row for row in rows if row.model == name]
        rank = spearman([r.predicted for r in some], [r.measured for r in some])
        chosen = min(some, key=lambda r: r.predicted).measured
        lost = chosen / min(r.measured for r in some) - 1
        typical = median(abs(r.error) for r in some)
        yield f"| {name} | {len(some)} | {typical:.1%} | {rank:.2f} | {lost:.1%} |"
    yield ""


def _all(rows: list[Row]) -> Iterator[str]:
    yield "## All programs\n"
    yield "| robot | schedule | measured (µs) | fastest (µs) | predicted (µs) | error |"
    yield "|---|---|---|---|---|---|"
    for r in rows:
        yield (
            f"| {r.model} | {r.label} | {'≈' if r.played else ''}{r.measured:.2f} | "
            f"{r.fastest:.2f} | {r.predicted:.2f} | {r.error:+.1%} |"
        )


def main() -> None:
    """Carry out the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("what", choices=("measure", "report"))
    parser.add_argument("file", type=Path)
    parser.add_argument("--profile", default="default")
    parser.add_argument("--machine", default="this one", help="what the report calls it")
    options = parser.parse_args()
    if options.what == "measure":
        measure(options.file)
    else:
        print(report(options.file, options.profile, options.machine), end="")


if __name__ == "__main__":
    main()
