"""Predicted against measured times, over models and schedules, at P = 1, 2 and 4, and of batches.

    python -m benchmarks.prediction measure FILE.json [--profile NAME] [--priority N]
    python -m benchmarks.prediction report FILE.json [--profile NAME]
                                                      [--write docs/records/prediction.md]

The first builds what --shape auto emits and times it, about a quarter of an hour on two idle cores;
after each robot the record so far is kept, and it goes on from there. The second prints tables, or
writes them into a page between its markers: what is written there by hand stays.

Programs of one model are timed in turn, several times over, and the least median is kept: other
work on the machine only ever adds to a time. Where there are more processes than cores, times are
from measured stretches of computing (docs/records/benchmarks.md); the report says so of each.
"""

from __future__ import annotations

import dataclasses
import json
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from adagen.build import Toolchain, find_toolchain
from adagen.calibrate.measure import Built, Measurement, combined
from adagen.calibrate.robots import chain, robot, squared, star, tree
from adagen.calibrate.schedules import random_schedule
from adagen.cli.console import note
from adagen.emit.shapes import chosen_shape
from adagen.errors import AdagenError
from adagen.executor.join_digits import predicted_growth
from adagen.model import Model
from adagen.plan import Plan, make_plan, plan_to_json
from adagen.run.launch import cores
from adagen.schedule import CostProfile, Schedule, Topology, load_profile
from adagen.search import best_schedule, find_schedule
from adagen.studies.bench.scale import at_priority
from benchmarks.page import command, publish
from benchmarks.prediction_report import report
from benchmarks.real_robots import model_of

ROUNDS = 4
REPEAT = 30
EXAMPLES = ("ur5", "panda", "anymal_b", "g1", "talos_reduced", "icub", "simple_humanoid")


def models() -> Iterator[Model]:
    """Yield the robots; those of example-robot-data where it is installed."""
    yield robot("chain24", chain(24), ["revolute"], 11)
    yield robot("spherical16", chain(16), ["spherical"], 12)
    yield robot("star5x5", star(5, 5), ["revolute"], 13)
    yield robot("tree30", tree(30, 0.3, 5), ["revolute", "revolute", "prismatic"], 14)
    yield robot("figure", [0, *tree(20, 0.25, 9)[1:]], ["floating", *["spherical"] * 15], 15)
    yield squared(robot("arm9", chain(9), ["revolute"], 17))
    yield robot("chain48", chain(48), ["revolute"], 16)
    for name in EXAMPLES:
        model = model_of(name)
        if model is not None:
            yield dataclasses.replace(model, name=name)


def schedules(model: Model, profile: CostProfile) -> Iterator[tuple[str, Schedule]]:
    """Yield the schedules that are compared, each with a label: form, processes, how it is made."""
    topology = Topology.of(model)
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


def plans(model: Model, profile: CostProfile) -> list[tuple[str, Plan]]:
    """Return labels and plans that differ; without those whose form cannot treat the robot."""
    found: dict[Plan, str] = {}
    for label, schedule in schedules(model, profile):
        try:
            plan = make_plan(model, schedule, form=label.split(",")[0])
            predicted_growth(plan)
        except (AdagenError, FloatingPointError) as error:
            note(f"{model.name}: {label}: {str(error)[:200] or 'a factorization fails'}")
            continue
        found.setdefault(plan, label)
    return [(label, plan) for plan, label in found.items()]


@dataclasses.dataclass(frozen=True)
class Wanted:
    """A program that is built and timed.

    Attributes:
        label: what tables call it.
        plan: what its processes compute.
        shape: of the code.
        batch: whether each SIMD lane holds a state.
    """

    label: str
    plan: Plan
    shape: str = "auto"
    batch: bool = False


def programs_of(model: Model, profile: CostProfile) -> list[Wanted]:
    """Return a robot's programs: one for each plan, and batches of the first in two shapes."""
    found = [Wanted(label, plan) for label, plan in plans(model, profile)]
    alone = found[0].plan
    found.append(Wanted("batch", alone, batch=True))
    if chosen_shape(alone, batch=True, profile=profile) != "kernels":
        found.append(Wanted("batch of loops", alone, "kernels", batch=True))
    return found


def measured(
    model: Model,
    profile: CostProfile,
    toolchain: Toolchain,
    priority: int,
    say: Callable[[str], None],
) -> list[dict[str, Any]]:
    """Build and time a robot's programs; return what is recorded of them."""
    wanted = programs_of(model, profile)
    say(f"compiling {len(wanted)} programs")

    def build(one: Wanted) -> Built:
        return Built(one.plan, toolchain, one.shape, profile, batch=one.batch)

    with ThreadPoolExecutor(2) as pool:
        programs = list(pool.map(build, wanted))
    say("timing")
    found: list[list[Measurement]] = [[] for _ in programs]
    for _ in range(ROUNDS):
        for program, times in zip(programs, found, strict=True):
            # At a real-time priority processes without a core of their own would wait for ever.
            fits = len(program.plan.processes) <= cores()
            with at_priority(priority if fits else 0):
                times.append(program.measure(repeat=REPEAT))
    return [
        {
            "model": model.name,
            "label": one.label,
            "shape": program.shape,
            "batch": one.batch,
            "plan": plan_to_json(one.plan),
            "measured": dataclasses.asdict(combined(times)),
        }
        for one, program, times in zip(wanted, programs, found, strict=True)
    ]


def measure(path: Path, profile: CostProfile, priority: int) -> None:
    """Build and time all, keeping the file up to date robot by robot."""
    toolchain = find_toolchain()
    rows: list[dict[str, Any]] = json.loads(path.read_text()) if path.exists() else []
    done = {row["model"] for row in rows}
    every, start = list(models()), time.monotonic()
    for k, model in enumerate(every):
        if model.name in done:
            continue

        def say(what: str, place: str = f"{k + 1} of {len(every)}: {model.name}") -> None:
            note(f"{time.monotonic() - start:4.0f} s  robot {place}: {what}")

        rows += measured(model, profile, toolchain, priority, say)
        path.write_text(json.dumps(rows))


def main() -> None:
    """Carry out the command line."""
    parser = command(__doc__)
    parser.add_argument("what", choices=("measure", "report"))
    parser.add_argument("file", type=Path)
    parser.add_argument("--profile", default="default", help="the machine's cost profile")
    parser.add_argument("--priority", type=int, default=0, help="real-time, of what is timed")
    parser.add_argument("--machine", default="this one", help="what the report calls it")
    options = parser.parse_args()
    if options.what == "measure":
        measure(options.file, load_profile(options.profile), options.priority)
        return
    publish(options, "prediction", report(options.file, options.profile, options.machine))


if __name__ == "__main__":
    main()
