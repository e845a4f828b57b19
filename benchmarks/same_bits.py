"""Reproducible solvers by several compilers: ``python -m benchmarks.same_bits URDF ... [--page]``.

Each robot's solver on 1, 2 and 4 threads, with limbs side by side and one by one, and of batches;
each compiled by g++ and by clang++ for x86-64, x86-64-v3 and x86-64-v4, and run on the same states:
ordinary ones, one with angles of a million turns, and one with angles of 1e21. Answers are compared
as they are written, to the last bit. A robot whose links do not hang on the ground is named as
FILE:floating, one in float as FILE:float, one with a scene as FILE:SCENE.toml. Of robots with
closed loops, states are closed, and processes have the layout that is predicted to be fastest.
--page writes docs/records/reproducible.md.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import adagen
from adagen.build import build_executable, find_toolchain
from adagen.build.toolchain import STANDARD, Toolchain, with_compiler
from adagen.emit import emit, stem_of
from adagen.executor import groupings
from adagen.model import Model
from adagen.plan import Plan
from adagen.plan.constants import joints_of
from adagen.plan.types import THREADS
from adagen.reference.closed import closed_states
from adagen.run import launch
from adagen.schedule import load_profile
from adagen.schedule.tree import Gathered
from adagen.search.base_gathering import reproducible_schedule
from adagen.states import States, random_states, write_states
from adagen.studies.bench.report import table
from benchmarks.page import command, publish
from benchmarks.solvers import tell
from tests.gathered import distributed, reproducible_plan

COMPILERS = ("g++", "clang++")
FLAGS = (
    ("-O2", "-march=x86-64"),
    ("-O3", "-march=x86-64-v3"),
    ("-O3", "-march=x86-64-v4"),
    ("-O1", "-march=native"),
)
"""What each source is compiled with: by themselves, compilers fuse for the last three."""
AROUND = ("-O1",)
"""For the program around a solver, which computes nothing of the answer."""
HEAD = ("robot", "number", "sources", "programs", "states", "different answers")


@dataclass(frozen=True)
class Source:
    """A text that is compiled, and how it is run."""

    what: str
    stem: str
    text: str
    processes: int


def sources(model: Model, scalar: str) -> Iterator[Source]:
    """Yield what is emitted for a robot: on 1, 2 and 4 threads in lanes and not, and batches."""

    def made(plan: Plan, what: str, batch: int = 0, **how: object) -> Source:
        stem = stem_of(plan, "same", batch)
        text = emit(plan, name="same", batch=batch, **how)[f"{stem}.cpp"]  # type: ignore[arg-type]
        return Source(what, stem, text, batch or plan.launched)

    alone = reproducible_plan(model, scalar=scalar)
    yield made(alone, "a batch", batch=1)
    for processes in (1, 2, 4):
        plan = alone
        if processes > 1:
            shares = layout(model, processes)
            if shares is None:
                continue
            plan = replace(reproducible_plan(model, shares, scalar=scalar), channel=THREADS)
        for k, grouping in enumerate(groupings(plan)):
            yield made(plan, f"P = {processes}, {'lanes' if k else 'no lanes'}", limbs=grouping)


def layout(model: Model, processes: int) -> Gathered | None:
    """Return limbs given to processes at random; closures as is fastest, None where one has all."""
    if model.closed:
        return reproducible_schedule(model, processes, load_profile("default")).gathered
    return distributed(model, processes, np.random.default_rng(processes))


def write_spread(model: Model, path: Path) -> int:
    """Write 12 states, two of them with angles that are large, and return how many.

    Of robots with closed loops, they are closed ones.
    """
    states = random_states(model, 12, seed=2)
    if model.closed:
        q, v = closed_states(model, 12, starts=240)
        states = States(q, v, states.tau[: len(q)])
    for joint in () if model.closed else joints_of(model):
        if joint.kind == "revolute":
            states.q[-2, joint.q] *= 3.1e6
            states.q[-1, joint.q] *= 2.7e21
    write_states(states, model, path)
    return len(states.q)


def answers(
    found: Sequence[Source], given: Path, toolchains: Sequence[tuple[str, Toolchain]]
) -> Iterator[tuple[str, str]]:
    """Yield what each source answers when compiled in each way, and which that is."""

    def answer(source: Source, name: str, toolchain: Toolchain) -> tuple[str, str]:
        program = build_executable(source.text, source.stem, toolchain)
        with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
            result = Path(folder, "result.json")
            words = ["--states", str(given), "--result", str(result)]
            done = launch(program, source.processes, words, toolchain, 120.0)
            said = result.read_text(encoding="utf-8") if done.status == 0 else done.stderr
        return f"{source.what}, {name}", said

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        ways = [(source, *way) for source in found for way in toolchains]
        yield from pool.map(lambda way: answer(*way), ways)


def ways() -> list[tuple[str, Toolchain]]:
    """Return how each source is compiled, as far as compilers and processor are there."""
    wide = "avx512f" in Path("/proc/cpuinfo").read_text(encoding="utf-8")
    own, found = find_toolchain(), []
    for compiler in filter(shutil.which, COMPILERS):
        for flags in FLAGS:
            if wide or "-march=x86-64-v4" not in flags:
                changed = replace(
                    own, flags=(*STANDARD, *flags, "-DNDEBUG"), program_flags=(*STANDARD, *AROUND)
                )
                name = f"{compiler} {' '.join(flags)}"
                found.append((name, with_compiler(changed, compiler)))
    return found


def main() -> None:
    """Build and run all, and print or write what came of it."""
    parser = command(__doc__, "records/reproducible.md")
    parser.add_argument("urdf", nargs="+", help="robots, FILE[:floating][:float][:SCENE.toml]")
    options = parser.parse_args()
    toolchains = ways()
    rows: list[tuple[object, ...]] = []
    others: list[str] = []
    for word in options.urdf:
        path, *how = word.split(":")
        scalar = "float" if "float" in how else "double"
        scene = next((each for each in how if each.endswith(".toml")), None)
        model = adagen.read(path, floating="floating" in how, scene=scene).model
        found = list(sources(model, scalar))
        with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
            given = Path(folder, "states.json")
            states = write_spread(model, given)
            said = dict(answers(found, given, toolchains))
        (expected, agreeing), *_ = Counter(said.values()).most_common(1)
        others += [f"{word}, {name}" for name, text in said.items() if text != expected]
        numbers = (len(found), len(said), states, len(said) - agreeing)
        rows.append((Path(path).stem, scalar, *numbers))
        tell(", ".join(map(str, rows[-1])))
    compiled = [f"`{name}`" for name, _ in toolchains]
    lines = [*table(HEAD, rows), "", f"Compiled with {', '.join(compiled)}."]
    publish(options, "same_bits", "\n".join(lines))
    tell("\n".join(others))


if __name__ == "__main__":
    main()
