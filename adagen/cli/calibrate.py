"""``adagen calibrate``: measures the costs of steps on this machine."""

from __future__ import annotations

import argparse
import dataclasses
import json
import re
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING

from adagen.cli.console import note, warn
from adagen.cli.parser import Parser, make_parser, parse
from adagen.cli.tables import table_of
from adagen.errors import EnvironmentFault, UsageError

if TYPE_CHECKING:
    from adagen.build import Toolchain
    from adagen.calibrate import Calibration, Progress

_EPILOG = """\
Small solvers are emitted, built and timed, and the costs of their steps are
fitted to their times. It takes five to fifteen minutes; nothing else should run
meanwhile.

examples:
  adagen calibrate                      measure, store the profile as "machine"
  adagen robot.urdf --procs 4 --profile machine     use it
  adagen calibrate --out mine.toml      write it to a file instead
  adagen calibrate --hosts hosts        add the costs of messages between hosts
                                        to "machine" (to a copy of the shipped
                                        profile, if there is none yet)
  CXXFLAGS=-march=x86-64-v3 adagen calibrate --name v3
                                        for solvers that you build with options
                                        of your own"""

_NAME = re.compile(r"[A-Za-z0-9_-][A-Za-z0-9._-]{0,63}")


def command_parser() -> Parser:
    """Return the parser of ``adagen calibrate``."""
    parser = make_parser("adagen calibrate", "Measure this machine's cost profile.", _EPILOG)
    parser.add_argument(
        "--name", type=_name, default="machine", help="of the profile (default: machine)"
    )
    parser.add_argument(
        "--quick", action="store_true", help="fewer solvers, timed a third as often"
    )
    parser.add_argument(
        "--out", type=Path, metavar="FILE", help="write here instead of storing it by name"
    )
    parser.add_argument(
        "--hosts",
        type=Path,
        metavar="FILE",
        help="measure messages between two hosts instead of this machine: the first two of FILE, "
        "a line each, as mpiexec --hostfile reads it (half a minute)",
    )
    parser.add_argument("--json", action="store_true", help="print how good the fit is as JSON")
    return parser


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen calibrate`` with the arguments after the verb; return the exit status."""
    options = parse(command_parser(), argv)

    from adagen.build import find_toolchain
    from adagen.calibrate import calibrate, profile_text
    from adagen.cli.files import write_file
    from adagen.schedule.profile import profiles_folder

    toolchain = find_toolchain()
    path = options.out or profiles_folder() / f"{options.name}.toml"
    _make_folder(path.parent, make=options.out is None)  # refused before anything is measured
    if options.hosts is not None:
        if options.quick:
            raise UsageError("--hosts measures the network alone: leave out --quick")
        return _measure_network(options, toolchain, path)
    began = time.monotonic()
    with _bar() as progress:
        found = calibrate(options.name, toolchain, quick=options.quick, progress=progress)
    write_file(path, profile_text(found.profile, _remark(found)))
    if options.json:
        print(json.dumps(_summary(found, str(path)), indent=1))
    else:
        _show(found)
    for line in _doubts(found):
        warn(line)
    word = str(path) if options.out is not None else options.name
    note(f"wrote {path} in {time.monotonic() - began:.0f} s; use it with --profile {word}")
    return 0


def _measure_network(options: argparse.Namespace, toolchain: Toolchain, path: Path) -> int:
    """Add the costs of messages between hosts to the named profile, or to a copy of the default.

    Raises:
        EnvironmentFault: the hosts cannot be reached.
        InputError: the file of hosts, or the profile, is refused.
    """
    from adagen.calibrate import calibrate_network, profile_text
    from adagen.cli.files import write_file
    from adagen.schedule import load_profile, read_hosts

    hosts = read_hosts(options.hosts)
    if len(hosts) < 2:
        raise UsageError(f"{options.hosts} names one host: messages go between two")
    base = load_profile(str(path) if path.is_file() else "default")
    base = dataclasses.replace(base, name=options.name)
    found, times = calibrate_network(base, toolchain, (hosts[0].name, hosts[1].name))
    costs = found.steps.network if found.steps is not None else None
    assert costs is not None
    remark = f"Messages between hosts measured by adagen calibrate --hosts on {_machine()}."
    write_file(path, profile_text(found, remark))
    bandwidth = 8 / costs.number if costs.number > 0 else None
    if options.json:
        report = {
            "profile": str(path),
            "send_us": costs.send,
            "latency_us": costs.latency,
            "number_us": costs.number,
            "megabytes_per_second": bandwidth,
            "messages": [dataclasses.asdict(time) for time in times],
        }
        print(json.dumps(report, indent=1))
    else:
        speed = "" if bandwidth is None else f", {bandwidth:.0f} MB/s"
        way = costs.send + costs.latency
        print(f"{hosts[0].name} to {hosts[1].name}: {way:.1f} us for a message{speed}")
    note(f"wrote {path}; use it with --profile {path if options.out else options.name}")
    return 0


def _name(text: str) -> str:
    from adagen.schedule.profile import NATIVE, SHIPPED

    if not _NAME.fullmatch(text):
        raise argparse.ArgumentTypeError(
            "must be up to 64 letters, digits, dots, hyphens and underscores, no dot first"
        )
    if text in (*SHIPPED, NATIVE):
        raise argparse.ArgumentTypeError(f"'{text}' names a shipped profile")
    return text


def _make_folder(folder: Path, *, make: bool) -> None:
    if not make:
        if not folder.is_dir():
            raise EnvironmentFault(f"cannot write to {folder}: there is no such folder")
        return
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise EnvironmentFault(
            f"cannot store profiles in {folder} ({error.strerror}); set XDG_CONFIG_HOME to a "
            "folder that can be written, or use --out FILE"
        ) from None


@contextmanager
def _bar() -> Iterator[Progress]:
    """Show a progress bar on stderr; plain lines where that is no terminal."""
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        Progress,
        TextColumn,
        TimeElapsedColumn,
        TimeRemainingColumn,
    )

    console = Console(stderr=True)
    if not console.is_terminal:
        last = ""

        def say(what: str, done: int, total: int) -> None:
            nonlocal last
            if what != last:
                note(f"{what} ... ({done} of {total})")
            last = what

        yield say
        return
    left = TimeRemainingColumn()
    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn(), left)
    with Progress(*columns, console=console, transient=True) as progress:
        task = progress.add_task("compiling", total=None)

        def show(what: str, done: int, total: int) -> None:
            progress.update(task, description=what, completed=done, total=total)

        yield show


def _remark(found: Calibration) -> str:
    lines = [
        f"Measured by adagen calibrate on {_machine()}.",
        f"Median error of a program's predicted time {_typical(found):.1%}.",
    ]
    if not found.messages_measured:
        lines.append("There was one core only: the costs of messages are the default profile's.")
    return "\n".join(lines)


def _machine() -> str:
    """Return the processor's name on a line of its own."""
    from adagen.build.processor import processor_name

    return "".join(c for c in processor_name() if c.isprintable())[:80]


def _typical(found: Calibration) -> float:
    return median(abs(predicted / measured - 1) for _, measured, predicted in found.totals)


def _summary(found: Calibration, path: str) -> dict[str, object]:
    return {
        "profile": path,
        "pinned": found.pinned,
        "messages_measured": found.messages_measured,
        "median_error": _typical(found),
        "stages": {
            what: {
                "count": len(errors),
                "median_error": median(map(abs, errors)),
                "largest_error": max(map(abs, errors)),
            }
            for what, errors in sorted(found.errors.items())
        },
        "programs": [
            {"program": label, "measured_us": measured, "predicted_us": predicted}
            for label, measured, predicted in found.totals
        ],
    }


def _show(found: Calibration) -> None:
    from rich.console import Console

    rows = (
        (label, f"{measured:.2f}", f"{predicted:.2f}", f"{predicted / measured - 1:+.1%}")
        for label, measured, predicted in found.totals
    )
    console = Console()
    console.print(table_of(("program", "measured (us)", "predicted (us)", "error"), rows))
    for what, errors in sorted(found.errors.items()):
        sizes = [abs(error) for error in errors]
        console.print(
            f"{what}: {len(sizes)} stages, median error {median(sizes):.1%}, "
            f"largest {max(sizes):.1%}"
        )


def _doubts(found: Calibration) -> Iterator[str]:
    if not found.pinned:
        yield "warning: processes could not be held to a core each: times are less certain"
    if not found.messages_measured:
        yield "warning: one core only: the costs of messages are those of the default profile"
    if (error := _typical(found)) > 0.1:
        yield (
            f"warning: predicted times are off by {error:.0%} in the median: was something else "
            "running? Measure again on an idle machine"
        )
