"""The covering set of generated_examples, in one table, and what each folder holds."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from adagen.drawing import draw
from adagen.emit import emit, program_of
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.schedule import Schedule, Topology, load_profile, schedule_to_json
from adagen.search import best_schedule, named_schedule
from adagen.urdf import read_robot
from tests.golden.make_models import MODELS, ROBOTS

FOLDER = MODELS.parent
KEPT = ("Makefile", "README.md", "models/arm7_payload.toml", "models/humanoid_legs.toml")
"""Files of the folder that are written by hand."""


@dataclass(frozen=True)
class Example:
    """A robot, how it is read, and how it is emitted."""

    name: str
    robot: str
    processes: int
    floating: bool = False
    mimic: bool = False
    form: str = "segment"
    scalar: str = "double"
    channel: str = "auto"
    shape: str = "auto"
    batch: bool = False
    balanced: bool = False  # by Featherstone's schedule, where the best one leaves processes idle

    @property
    def stem(self) -> str:
        """The name of its folder, and of the files in it without their endings."""
        return f"{self.name}_p{self.processes}"

    @property
    def urdf(self) -> Path:
        """The robot description."""
        return MODELS / f"{self.robot}.urdf"

    def model(self) -> Model:
        """Read the robot."""
        return _model(self.urdf, self.floating, self.mimic)


EXAMPLES = (
    Example("arm7", "arm7", 1, shape="joints"),
    Example("arm7", "arm7", 2, shape="kernels", balanced=True),
    Example("arm7_unrolled", "arm7", 1, shape="unrolled"),
    Example("arm7_unrolled", "arm7", 2, form="ada", shape="unrolled"),
    Example("arm7_slaved", "arm7", 2, mimic=True, form="ada"),
    Example("arm7_float", "arm7", 2, scalar="float", shape="kernels", balanced=True),
    Example("arm7_mixed", "arm7", 2, scalar="mixed", balanced=True),
    Example("arm7_batch", "arm7", 2, batch=True),
    Example("humanoid_batch", "humanoid", 2, floating=True, shape="kernels", batch=True),
    Example("humanoid", "humanoid", 1, floating=True, shape="kernels"),
    Example("humanoid", "humanoid", 2, floating=True, shape="kernels"),
    Example("humanoid", "humanoid", 3, floating=True, form="ada"),
    Example("humanoid_lanes", "humanoid", 1, floating=True, shape="unrolled"),
    Example("human40", "human40", 1, form="ada", shape="joints"),
    Example("human40", "human40", 4, shape="kernels", balanced=True),
    Example("chain16", "chain16", 3, shape="kernels", balanced=True),
    Example("chain16", "chain16", 4, form="ada", channel="message"),
    Example("mobile", "mobile", 1),
    Example("mobile", "mobile", 3, form="ada"),
)


@cache
def _model(urdf: Path, floating: bool, mimic: bool) -> Model:
    return read_robot(urdf, floating=floating, mimic=mimic).model


def stages(example: Example) -> tuple[Schedule, Plan]:
    """Return the schedule and the plan of an example."""
    model = example.model()
    processes = 1 if example.batch else example.processes
    profile = load_profile("default")
    if example.balanced:
        schedule = named_schedule("balanced", Topology.of(model), processes, profile=profile)
    else:
        schedule = best_schedule(model, processes, profile, example.form)
    plan = make_plan(
        model,
        schedule,
        form=example.form,
        scalar=example.scalar,
        channel=example.channel,
        source_hash=hashlib.sha256(example.urdf.read_bytes()).hexdigest(),
    )
    return schedule, plan


def files_of(example: Example) -> dict[str, str]:
    """Return the files of an example, file name to text."""
    schedule, plan = stages(example)
    topology = Topology.of(example.model())
    program = program_of(plan, example.shape, batch=example.batch)
    svg = draw(schedule, topology, program, load_profile("default"), example.model().name)
    batch = example.processes if example.batch else 0
    files = emit(plan, name=example.name, svg=svg, shape=example.shape, batch=batch)
    files[f"{example.stem}.schedule.json"] = schedule_to_json(schedule, topology) + "\n"
    return files


def golden_files() -> dict[str, bytes]:
    """Return all files of generated_examples but the hand-written, path to content."""
    texts = {f"models/{name}.urdf": make() for name, make in ROBOTS.items()}
    for example in EXAMPLES:
        for name, text in files_of(example).items():
            texts[f"{example.stem}/{name}"] = text
    return {path: text.encode() for path, text in sorted(texts.items())}
