"""``make demo``: the main job on a real robot, with the commands that a user would type."""

from __future__ import annotations

import json
import os
import shlex
import subprocess
import sys
from collections.abc import Sequence
from importlib import metadata
from pathlib import Path
from typing import Any

from adagen.cli.console import note, progress
from adagen.cli.main import main as adagen
from adagen.cli.tables import table_of
from adagen.errors import AdagenError, EnvironmentFault

ROBOT = "talos_data/robots/talos_reduced.urdf"
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
        argv: a robot description instead of the usual one.
    """
    words = list(sys.argv[1:] if argv is None else argv)
    try:
        model = Path(words[0]) if words else robot_file(ROBOT)
        reports = []
        for processes in PROCESSES:
            folder = OUT / f"p{processes}"
            status = _generate(model, processes, folder)
            if status != 0:
                return status
            reports.append(_build_and_run(folder, processes))
    except AdagenError as error:
        note(str(error))
        return error.status
    _summary(model, reports)
    return 0 if all(report["check"]["ok"] for report in reports) else 1


def _generate(model: Path, processes: int, folder: Path) -> int:
    words = [str(model), "--floating", "--procs", str(processes), "--out", str(folder)]
    # The robot's own place is long; what a user would type is not.
    note(f"$ adagen {shlex.join([model.name, *words[1:]])}")
    return adagen(words)


def _build_and_run(folder: Path, processes: int) -> dict[str, Any]:
    """Build with the emitted Makefile, run with check and time, and return the report."""
    from adagen.build import find_toolchain
    from adagen.run import launch

    toolchain = find_toolchain()
    (source,) = folder.glob("*_p[0-9]*.cpp")
    note(f"$ make -C {folder}")
    with progress(f"compiling {source.stem}"):
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
    with progress(f"running {program.name}"):
        ran = launch(program, processes, ["--check", "--time", "--json"], toolchain, 120)
    if ran.status not in (0, 1) or not ran.stdout.strip():
        raise EnvironmentFault(ran.stderr.removeprefix("error: ") or f"{program.name} failed")
    report: dict[str, Any] = json.loads(ran.stdout)
    return report


def _summary(model: Path, reports: Sequence[dict[str, Any]]) -> None:
    """Print time and error for each number of processes, and where the drawing is."""
    from rich.console import Console

    columns = ("P", "channel", "median", "minimum", "99 %", "speedup", "residual", "answer")
    rows = []
    first = reports[0]["time"]["in_place"]["median_ns"]
    for report in reports:
        time, check = report["time"]["in_place"], report["check"]
        row = (
            str(report["processes"]),
            report["channel"],
            *(f"{time[key] / 1e3:.2f}" for key in ("median_ns", "min_ns", "p99_ns")),
            f"{first / time['median_ns']:.2f}",
            f"{check['residual_max']:.1e}",
            "right" if check["ok"] else "WRONG",
        )
        rows.append(row)
    title = f"forward dynamics of {model.stem}, us per evaluation"
    Console().print(table_of(columns, rows, title=title, named=False, wrap=False))
    for drawing in sorted(OUT.glob("*/*.svg")):
        print(f"schedule drawn in {drawing}")


if __name__ == "__main__":
    sys.exit(main())
