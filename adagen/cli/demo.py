"""``make demo``: two robots, with the commands that a user would type.

A humanoid, whose limbs share SIMD lanes so that a second process does not pay, and a long snake,
for which it does.
"""

from __future__ import annotations

import json
import os
import shlex
import subprocess
import sys
from collections.abc import Mapping, Sequence
from importlib import metadata
from pathlib import Path
from typing import Any

from adagen.cli.console import note, progress
from adagen.cli.main import main as adagen
from adagen.cli.tables import table_of
from adagen.errors import AdagenError, EnvironmentFault

HUMANOID = "simple_humanoid_description/urdf/simple_humanoid.urdf"
SNAKE = Path("generated_examples", "models", "snake100.urdf")
PROCESSES = (1, 2)
OUT = Path("build", "demo")


def robot_file(name: str) -> Path:
    """Return a robot of the PyPI package example-robot-data, by its path below ``robots/``.

    Raises:
        EnvironmentFault: the package is not installed, or has no such robot.
    """
    try:
        package = metadata.distribution("example-robot-data")
    except metadata.PackageNotFoundError:
        raise EnvironmentFault(
            "the demo's robot is in the package example-robot-data: pip install 'adagen[test]'"
        ) from None
    path = Path(str(package.locate_file("cmeel.prefix/share/example-robot-data/robots"))) / name
    if not path.is_file():
        raise EnvironmentFault(f"example-robot-data {package.version} has no {name}")
    return path


def main(argv: Sequence[str] | None = None) -> int:
    """Run the demonstration and return the exit status.

    Args:
        argv: robot descriptions instead of the usual two.
    """
    words = list(sys.argv[1:] if argv is None else argv)
    try:
        models = [Path(word) for word in words] or [robot_file(HUMANOID), SNAKE]
        reports: dict[str, list[dict[str, Any]]] = {}
        for model in models:
            reports[model.stem] = []
            for processes in PROCESSES:
                folder = OUT / model.stem / f"p{processes}"
                status = _generate(model, processes, folder)
                if status != 0:
                    return status
                reports[model.stem].append(_build_and_run(folder, processes))
    except AdagenError as error:
        note(str(error))
        return error.status
    summarise(reports)
    ran = [report for of_robot in reports.values() for report in of_robot]
    return 0 if all(report["check"]["ok"] for report in ran) else 1


def _generate(model: Path, processes: int, folder: Path) -> int:
    words = [str(model), "--floating", "--procs", str(processes), "--profile", "native"]
    words += ["--out", str(folder)]
    # The robot's own path is long; the one shown is what a user would type beside the file.
    note(f"$ adagen {shlex.join([model.name, *words[1:]])}")
    return adagen(words)


def _build_and_run(folder: Path, processes: int) -> dict[str, Any]:
    """Build with the emitted Makefile, run with check and time, and return the report."""
    from adagen.build import find_toolchain
    from adagen.run import launch

    toolchain = find_toolchain()
    (source,) = folder.glob("*_p[0-9]*.cpp")
    note(f"$ make -C {folder}")
    texts = (path.read_text(encoding="utf-8") for path in folder.glob("*.cpp"))
    with progress(f"compiling {source.stem}", sum(map(len, texts))):
        done = subprocess.run(
            ["make", "-C", str(folder), f"ADAGEN={shlex.quote(sys.executable)} -m adagen"],
            capture_output=True,
            text=True,
            check=False,
            env=toolchain.variables(os.environ),
        )
    if done.returncode != 0:
        raise EnvironmentFault(f"make failed: {' '.join(done.stderr.split())[-600:]}")
    program = source.with_suffix("")
    start = f"mpiexec -n {processes} " if processes > 1 else ""  # one process needs no MPI
    note(f"$ {start}{program} --check --time")
    with progress(f"measuring {program.name}", 1):
        ran = launch(program, processes, ["--check", "--time", "--json"], toolchain, 120)
    if ran.status not in (0, 1) or not ran.stdout.strip():
        raise EnvironmentFault(ran.stderr.removeprefix("error: ") or f"{program.name} failed")
    report: dict[str, Any] = json.loads(ran.stdout)
    return report


def summarise(reports: Mapping[str, Sequence[dict[str, Any]]]) -> None:
    """Print times and errors, what they mean for each robot, and where the drawings are."""
    from rich.console import Console

    columns = ("robot", "P", "median", "minimum", "99 %", "speedup", "residual", "answer")
    rows, conclusions = [], []
    for robot, of_robot in reports.items():
        first = of_robot[0]["time"]["in_place"]["median_ns"]
        for report in of_robot:
            time, check = report["time"]["in_place"], report["check"]
            speedup = first / time["median_ns"]
            row = (
                robot,
                str(report["processes"]),
                *(f"{time[key] / 1e3:.2f}" for key in ("median_ns", "min_ns", "p99_ns")),
                f"{speedup:.2f}",
                f"{check['residual_max']:.1e}",
                "right" if check["ok"] else "WRONG",
            )
            rows.append(row)
        conclusions.append(f"{robot}: {_conclusion(of_robot[-1], speedup)}")
    title = "forward dynamics, us per evaluation"
    Console().print(table_of(columns, rows, title=title, named=True, wrap=False))
    print("\n".join(conclusions))
    for drawing in sorted(OUT.glob("*/*/*.svg")):
        print(f"schedule drawn in {drawing}")


def _conclusion(report: Mapping[str, Any], speedup: float) -> str:
    """Say in a sentence what the second process was good for."""
    if report["channel"] == "none":
        return "a second process does not pay; adagen leaves all work to one"
    return f"two processes are {speedup:.2f} times as fast as one"


if __name__ == "__main__":
    sys.exit(main())
