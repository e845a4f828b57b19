"""What generating and compiling costs: time, memory and size, for a robot of 161 DOF or any URDF.

    python -m benchmarks.compile_cost [URDF ...] [--procs 4] [--form segment] [--flags="-O3 ..."]

Nothing is asserted: figures of one machine are no test. The aims are generation within 10 s,
compilation within 60 s and 2 GiB, and an emitted file under 2 MiB.
"""

from __future__ import annotations

import argparse
import os
import shlex
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from adagen.build import find_toolchain
from adagen.emit import emit, stem_of
from adagen.emit.runtime import joined
from adagen.model import Model
from adagen.plan import FORMS, make_plan
from adagen.schedule import Topology, load_profile
from adagen.search import find_schedule
from adagen.urdf import read_robot
from tests.large import human161


@contextmanager
def timed(seconds: dict[str, float], stage: str) -> Iterator[None]:
    """Note how long a stage took."""
    start = time.perf_counter()
    yield
    seconds[stage] = time.perf_counter() - start


def generate(source: str | None, processes: int, form: str) -> tuple[str, str, dict[str, float]]:
    """Return the stem, the emitted source and the seconds of each stage."""
    seconds: dict[str, float] = {}
    with timed(seconds, "read"):
        model: Model = human161() if source is None else read_robot(source).model
    with timed(seconds, "schedule"):
        topology = Topology.of(model)
        schedule = find_schedule(topology, processes, profile=load_profile("default"))
    with timed(seconds, "plan"):
        plan = make_plan(model, schedule, form=form)
    with timed(seconds, "emit"):
        stem = stem_of(plan)
        text = joined(emit(plan)[f"{stem}.cpp"])
    return stem, text, seconds


def compile_cost(stem: str, text: str, flags: Sequence[str]) -> tuple[float, float, float]:
    """Return wall and processor seconds and the largest resident size (MiB) of a compilation."""
    toolchain = find_toolchain()
    if flags:
        toolchain = replace(toolchain, flags=("-std=c++17", *flags))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"{stem}.cpp")
        path.write_text(text, encoding="utf-8")
        command = toolchain.compile_command(path, path.with_suffix(""))
        start = time.perf_counter()
        child = subprocess.Popen(command, env=toolchain.variables(os.environ))
        _, status, used = os.wait4(child.pid, 0)
        wall = time.perf_counter() - start
        child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise SystemExit(f"{stem} does not compile")
    unit = 1 if sys.platform == "darwin" else 1024
    return wall, used.ru_utime + used.ru_stime, used.ru_maxrss * unit / 2**20


def main() -> None:
    """Measure what the command line names and print a table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("urdf", nargs="*", help="robots; a figure of 161 DOF if none")
    parser.add_argument("--procs", type=int, default=4)
    parser.add_argument("--form", choices=(*FORMS,), action="append", help="default: all")
    parser.add_argument("--flags", type=shlex.split, default=[], help="instead of the default ones")
    options = parser.parse_args()
    print(
        "file                    form     generate s (schedule)   compile s (cpu)    MiB  file KiB"
    )
    for source in options.urdf or [None]:
        for form in options.form or FORMS:
            stem, text, seconds = generate(source, options.procs, form)
            wall, processor, memory = compile_cost(stem, text, options.flags)
            total = sum(seconds.values())
            print(
                f"{stem:23.23s} {form:8s} {total:10.2f} ({seconds['schedule']:.2f})"
                f" {wall:15.1f} ({processor:.1f}) {memory:8.0f} {len(text.encode()) / 1024:8.0f}"
            )


if __name__ == "__main__":
    main()
