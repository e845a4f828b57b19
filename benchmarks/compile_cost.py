"""What a solver costs to read, to generate and to compile: ``python -m benchmarks.compile_cost``.

    chrt -f 50 python -m benchmarks.compile_cost [--page]
    python -m benchmarks.compile_cost --large [--procs 4] [--flags="-O3 ..."]

For robots of example-robot-data on one process, in each code shape: lines of the source, how many
of them are the robot's own, and the times to generate the solver and to compile it as `make lib`
does. A line is the robot's own unless it stands in the sources of all the other robots that are
made with the same options. --large takes a figure of 161 degrees of freedom on several processes
instead, as a whole program; its aims are generation within 10 s, compilation within 60 s and 2 GiB,
and an emitted file under 2 MiB.

Nothing is asserted: figures of one machine are no test. --page writes the tables into
docs/records/compile_time.md.
"""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import adagen
from adagen.build import find_toolchain
from adagen.build.cache import uses_mpi
from adagen.emit import stem_of
from adagen.emit.runtime import joined
from adagen.plan import FORMS, make_plan
from adagen.schedule import Topology, load_profile
from adagen.search import find_schedule
from adagen.studies.bench.machine import machine
from adagen.studies.bench.report import table
from benchmarks.page import command, publish
from benchmarks.real_robots import FLOATING, file_of
from benchmarks.solvers import source_of, tell
from tests.large import human161

LIBRARY = ("-DADAGEN_NO_MAIN", "-fPIC", "-c")
ROBOTS = ("ur5", "z1", "panda", "solo12", "talos_reduced", "icub")

SHAPES = ("auto", "unrolled", "kernels", "joints")


@dataclass(frozen=True)
class Cost:
    """Wall and processor seconds, and the largest resident size in MiB, of a compilation."""

    wall: float
    processor: float
    memory: float


def compiled_in(stem: str, text: str, flags: Sequence[str], words: Sequence[str] = ()) -> Cost:
    """Return what it costs to compile a source.

    Args:
        stem: name of the file.
        text: its text.
        flags: instead of the default options; none for those.
        words: further options; none for a whole program.
    """
    toolchain = find_toolchain()
    if flags:
        toolchain = replace(toolchain, flags=("-std=c++17", *flags))
    text = joined(text)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"{stem}.cpp")
        path.write_text(text, encoding="utf-8")
        command = toolchain.compile_command(path, path.with_suffix(".o"), uses_mpi(text))
        start = time.perf_counter()
        child = subprocess.Popen([*command, *words], env=toolchain.variables(os.environ))
        _, status, used = os.wait4(child.pid, 0)
        wall = time.perf_counter() - start
        child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise SystemExit(f"{stem} does not compile")
    unit = 1 if sys.platform == "darwin" else 1024
    return Cost(wall, used.ru_utime + used.ru_stime, used.ru_maxrss * unit / 2**20)


def own_lines(name: str, sources: Mapping[str, str]) -> float:
    """Return the share of a source's lines that do not stand in all others; blank ones apart."""
    lines = [line for line in sources[name].splitlines() if line.strip()]
    others = [set(text.splitlines()) for other, text in sources.items() if other != name]
    return sum(not all(line in text for text in others) for line in lines) / len(lines)


def solvers() -> Iterator[tuple[object, ...]]:
    """Yield the rows of the table of solvers, shape by shape."""
    robots = {name: adagen.read(file_of(name), floating=name in FLOATING) for name in ROBOTS}
    for shape in SHAPES:
        sources, chosen, seconds = {}, {}, {}
        for name, robot in robots.items():
            start = time.perf_counter()
            form = "ada" if shape == "joints" else "segment"
            made = adagen.compile(robot, procs=1, shape=shape, form=form)
            seconds[name] = time.perf_counter() - start
            sources[name] = made.in_folder(".")[f"{made.stem}.cpp"]
            chosen[name] = made.program.shape
        for name, text in sources.items():
            alike = {n: other for n, other in sources.items() if chosen[n] == chosen[name]}
            share = f"{own_lines(name, alike):.0%}" if len(alike) > 1 else "-"
            cost = compiled_in(name, text, (), LIBRARY)
            shown = f"auto: `{chosen[name]}`" if shape == "auto" else f"`{shape}`"
            shown += ", form `ada`" * (shape == "joints")
            tell(f"{name}, {shown}")
            yield (
                *(name, len(robots[name].model.joints), shown, len(text.splitlines()), share),
                *(f"{seconds[name]:.1f}", f"{cost.wall:.2f}", f"{cost.memory:.0f}"),
            )


def large(processes: int, flags: Sequence[str]) -> Iterator[tuple[object, ...]]:
    """Yield the rows of the table of a large robot, form by form."""
    model = human161()
    for form in FORMS:
        start = time.perf_counter()
        schedule = find_schedule(Topology.of(model), processes, profile=load_profile("default"))
        plan = make_plan(model, schedule, form=form)
        stem = stem_of(plan)
        text = joined(source_of(plan))
        generated = time.perf_counter() - start
        cost = compiled_in(stem, text, flags)
        yield (
            *(stem, form, f"{generated:.1f}", f"{cost.wall:.1f}", f"{cost.processor:.1f}"),
            *(f"{cost.memory:.0f}", f"{len(text.encode()) / 1024:.0f}"),
        )


def main() -> None:
    """Measure what the command line names and print a table, or write it."""
    parser = command(__doc__, "records/compile_time.md")
    parser.add_argument("--large", action="store_true", help="a figure of 161 degrees of freedom")
    parser.add_argument("--procs", type=int, default=4, help="processes of --large (default: 4)")
    parser.add_argument("--flags", type=shlex.split, default=[], help="of --large: its options")
    options = parser.parse_args()
    if options.large:
        head = "file | form | generate, s | compile, s | processor s | MiB | KiB of text"
        rows = large(options.procs, options.flags)
    else:
        head = "robot | joints | shape | lines | own | generate, s | compile, s | compiler, MiB"
        rows = solvers()
    about = machine()
    compiler = about["compilers"]
    assert isinstance(compiler, dict)
    priority = "real-time" if os.sched_getscheduler(0) else "ordinary"
    head_line = f"Machine: virtual, cores of an {about['processor']}, "
    head_line += f"{compiler.get('g++', 'another compiler')}, {priority} priority."
    mark = "compile_cost --large" if options.large else "compile_cost"
    publish(options, mark, "\n".join([head_line, "", *table(head.split(" | "), rows)]))


if __name__ == "__main__":
    main()
