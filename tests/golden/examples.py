"""The covering set of generated_examples, in one table, and what each folder holds."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

from adagen.emit.runtime import runtime_files
from adagen.emit.solver_program import PROGRAM_FILE
from adagen.library import Compiled, Robot, compile, read  # noqa: A004 (what it does)
from adagen.model import Model
from adagen.schedule import Topology, schedule_to_json
from tests.golden.make_models import MODELS, ROBOTS

FOLDER = MODELS.parent
AT_TORSO = "humanoid_at_torso.json"
KEPT = (
    *("Makefile", "README.md", f"models/{AT_TORSO}"),
    *("models/arm7_payload.toml", "models/humanoid_legs.toml"),
    *("models/ankle.toml", "models/fourbar.toml"),
)
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
    refine: int | None = None
    closed: bool = False  # by the scene of its name
    schedule: str = "auto"  # another one where the best leaves processes idle; a file of models/

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
        return self.read().model

    def read(self) -> Robot:
        """Read the robot, with all that was found."""
        return _robot(self.urdf, self.floating, self.mimic, closed=self.closed)


EXAMPLES = (
    Example("arm7", "arm7", 1, shape="kernels"),
    Example("arm7", "arm7", 2, shape="kernels", schedule="balanced"),
    Example("arm7_unrolled", "arm7", 1, shape="unrolled"),
    Example("arm7_unrolled", "arm7", 2, form="ada", shape="unrolled"),
    Example("arm7_slaved", "arm7", 2, mimic=True, form="ada"),
    Example("arm7_float", "arm7", 2, scalar="float", shape="kernels", schedule="balanced"),
    Example("arm7_refined", "arm7", 2, refine=1, shape="kernels", schedule="balanced"),
    Example("arm7_batch", "arm7", 2, batch=True),
    Example("humanoid_batch", "humanoid", 2, floating=True, shape="kernels", batch=True),
    Example("humanoid", "humanoid", 1, floating=True, shape="kernels"),
    Example("humanoid", "humanoid", 2, floating=True, shape="kernels", schedule=AT_TORSO),
    Example("humanoid", "humanoid", 3, floating=True, form="ada"),
    Example("humanoid_lanes", "humanoid", 1, floating=True, shape="unrolled"),
    Example("human40", "human40", 1, form="ada", shape="joints"),
    Example("human40", "human40", 4, shape="kernels", schedule="balanced"),
    Example("chain16", "chain16", 3, shape="kernels", schedule="balanced"),
    Example("chain16", "chain16", 4, form="ada", channel="message"),
    Example("fourbar", "fourbar", 1, closed=True),
    Example("ankle", "ankle", 1, closed=True),
    Example("mobile", "mobile", 1),
    Example("mobile", "mobile", 3, form="ada"),
)


@cache
def _robot(urdf: Path, floating: bool, mimic: bool, *, closed: bool) -> Robot:
    scene = urdf.with_suffix(".toml") if closed else None
    return read(urdf, floating=floating, mimic=mimic, scene=scene)


def _named_or_file(schedule: str) -> str:
    return str(MODELS / schedule) if schedule.endswith(".json") else schedule


def compiled(example: Example) -> Compiled:
    """Return what is made of an example."""
    return compile(
        example.read(),
        procs=example.processes,
        form=example.form,
        scalar=example.scalar,
        channel=example.channel,
        shape=example.shape,
        refine=example.refine,
        batch=example.batch,
        schedule=_named_or_file(example.schedule),
        name=None if example.name == example.robot else example.name,
    )


def files_of(example: Example) -> dict[str, str]:
    """Return the files of an example, file name to text."""
    made = compiled(example)
    files = made.in_folder(FOLDER / example.stem)
    topology = Topology.of(example.model())
    files[f"{example.stem}.schedule.json"] = schedule_to_json(made.schedule, topology) + "\n"
    return files


def golden_files() -> dict[str, bytes]:
    """Return all files of generated_examples but the hand-written, path to content."""
    texts = {f"models/{name}.urdf": make() for name, make in ROBOTS.items()}
    shared = {PROGRAM_FILE, *runtime_files()}
    for example in EXAMPLES:
        for name, text in files_of(example).items():
            # Runtime and program are those of all: the folders' Makefiles look above, too.
            folder = "" if name in shared else f"{example.stem}/"
            texts[f"{folder}{name}"] = text
    return {path: text.encode() for path, text in sorted(texts.items())}
