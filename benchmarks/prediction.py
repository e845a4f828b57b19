"""Predicted against measured times, over models and schedules, at P = 1 and 2.

    python benchmarks/prediction.py measure FILE.json      builds and times; takes half an hour
    python benchmarks/prediction.py report FILE.json [--profile NAME] [--out docs/prediction.md]

Programs of one model are timed in turn, several times over, and the least median is kept: other
work on the machine only ever adds to a time.
"""

from __future__ import annotations

import argparse
import dataclasses
import json
import sys
import sysconfig
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from adagen.build import find_toolchain
from adagen.calibrate.measure import Measurement, Program, least
from adagen.calibrate.robots import chain, robot, star, tree
from adagen.calibrate.schedules import random_schedule
from adagen.errors import AdagenError
from adagen.model import Model
from adagen.plan import make_plan, plan_to_json
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
    for seed, share in ((1, 0.35), (2, 0.25), (3, 0.15), (4, 0.0)):
        yield f"segment, P=2, random {seed}", made(seed, 2, share, False)
    yield "ada, P=1, searched", single
    yield "ada, P=1, random", made(5, 1, 0.0, True)
    yield "ada, P=2, searched", best
    yield "ada, P=2, random", made(6, 2, 0.2, False)
    yield "ada, P=2, random orders", made(7, 2, 0.3, True)


def measure(path: Path) -> None:
    """Build and time all, appending to the file model by model."""
    toolchain = find_toolchain()
    rows: list[dict[str, Any]] = json.loads(path.read_text()) if path.exists() else []
    done = {row["model"] for row in rows}
    for model in models():
        if model.name in done:
            continue
        programs: list[tuple[str, Program]] = []
        for label, schedule in schedules(model):
            print(f"{model.name}: {label}", file=sys.stderr, flush=True)
            try:
                plan = make_plan(model, schedule, form=label.split(",")[0])
                programs.append((label, Program(plan, toolchain)))
            except AdagenError as error:
                print(f"{model.name}: {label}: {error}", file=sys.stderr)
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


def main() -> None:
    """Carry out the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("what", choices=("measure", "report"))
    parser.add_argument("file", type=Path)
    options = parser.parse_args()
    if options.what == "measure":
        measure(options.file)


if __name__ == "__main__":
    main()
