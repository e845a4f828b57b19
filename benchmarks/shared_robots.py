"""Robots with tens of joints on several processes: what that is predicted to save, and saves.

    python -m benchmarks.shared_robots [MODEL ...] [--human] [--pair] [--processes P ...]
                                       [--profile NAME] [--rounds R] [--priority N] [--write PAGE]

Each MODEL (a URDF) floats. --human adds the paper's figure of 161 degrees of freedom. --pair adds
two talos of example-robot-data that carry a bar: a body in one's left hand that the other's left
hand holds by a ball joint, 100 degrees of freedom. All programs of a robot are timed by turns. With
more processes than cores, times are from stretches of computing, played through with what messages
cost in the profile.
"""

from __future__ import annotations

import re
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from adagen.build import find_toolchain
from adagen.cli.console import speaking
from adagen.errors import AdagenError
from adagen.library import Robot, read
from adagen.reference.closed import pose_of
from adagen.states import resting_states
from adagen.studies.bench.contest import Progress, Rules, hold
from adagen.studies.bench.machine import machine
from adagen.studies.bench.report import table
from adagen.studies.bench.scale import at_priority, made
from benchmarks.page import command, publish
from benchmarks.paper.robots import human
from benchmarks.real_robots import file_of

HEAD = ("robot", "DOF", "P", "meeting", "us", "saved", "predicted, us", "saved as predicted")
HAND = "arm_left_7_link"
_LEFT_OUT = re.compile(r"<(visual|collision|transmission|gazebo)\b.*?</\1>", re.DOTALL)
_BAR = (
    '<link name="bar"><inertial><origin xyz="0 0 -0.5"/><mass value="4"/>'
    '<inertia ixx="0.4" iyy="0.4" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>'
    f'<joint name="held" type="fixed"><parent link="a_{HAND}"/><child link="bar"/></joint>'
)


def pair(folder: Path) -> Robot:
    """Return two talos that carry a bar; what they are read from is written into a folder."""
    body = _LEFT_OUT.sub("", file_of("talos").read_text(encoding="utf-8"))
    body = body[body.index("<link") : body.rindex("</robot>")]
    parts = ['<robot name="two_talos"><link name="world"/>']
    for name, x in (("a", 0.0), ("b", 1.2)):
        parts.append(re.sub(r'\b(name|link|joint)="', rf"\g<0>{name}_", body))
        parts.append(
            f'<joint name="{name}" type="floating"><parent link="world"/>'
            f'<child link="{name}_base_link"/><origin xyz="{x} 0 0"/></joint>'
        )
    file, scene = folder / "two_talos.urdf", folder / "two_talos.toml"
    file.write_text("".join([*parts, _BAR, "</robot>"]), encoding="utf-8")
    model = read(file).model
    (pose,) = resting_states(model, 1).q
    links = {link.name: k for k, link in enumerate(model.links)}
    turn, own = pose_of(model, pose, links[f"a_{HAND}"])
    other = pose_of(model, pose, links[f"b_{HAND}"])[1]
    place = ", ".join(repr(float(x)) for x in turn.T @ (other - own))
    scene.write_text(
        f'[[loops]]\nname = "grasp"\nkind = "point"\nlink1 = "a_{HAND}"\n'
        f'origin1 = {{ xyz = [{place}] }}\nlink2 = "b_{HAND}"\n',
        encoding="utf-8",
    )
    return read(file, scene=scene)


def measured(
    name: str,
    robot: Robot,
    processes: Sequence[int],
    profile: str,
    rules: Rules,
    priority: int,
    on_progress: Progress,
) -> Iterator[tuple[object, ...]]:
    """Yield a row of HEAD for each number of processes, one among them."""
    toolchain, solvers = find_toolchain(), []
    for count in sorted({1, *processes}):
        on_progress(f"{name}: building P={count}")
        solvers.append(made(robot, count, profile, toolchain))
    held = [solver.contestant for solver in solvers]
    with at_priority(priority):
        times, gone = hold(held, rules, lambda text: on_progress(f"{name}: {text}"))
    for what, why in gone.items():
        on_progress(f"{name}, {what}: {why}")
    alone = solvers[0].contestant
    for solver in solvers:
        one = solver.contestant
        found = times.get(one.name, {})
        for source in ("in_place", "stretches"):
            if source in found:
                saved = 1 - found[source].least / times[alone.name]["in_place"].least
                played = source == "stretches"
                yield (
                    name,
                    robot.model.nv,
                    one.processes,
                    solver.meeting,
                    f"{'≈' * played}{found[source].least / 1e3:.3g}",
                    "" if one is alone else f"{saved:.0%}",
                    "" if one.predicted is None else f"{one.predicted / 1e3:.3g}",
                    ""
                    if one is alone or not one.predicted or not alone.predicted
                    else f"{1 - one.predicted / alone.predicted:.0%}",
                )


def main(words: Sequence[str] | None = None) -> int:
    """Measure what the command line names, print the table, and return the exit status."""
    parser = command(__doc__)
    parser.add_argument("models", type=Path, nargs="*", metavar="MODEL")
    parser.add_argument("--human", action="store_true", help="the figure of 161 freedoms, too")
    parser.add_argument("--pair", action="store_true", help="two talos that carry a bar, too")
    parser.add_argument("--profile", default="default", help="what operations and messages cost")
    parser.add_argument("--processes", type=int, nargs="+", default=(2, 4))
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--priority", type=int, default=0, help="real-time, of what is timed")
    options = parser.parse_args(words)
    rules = Rules(rounds=options.rounds, repeat=20)
    rows: list[tuple[object, ...]] = []
    try:
        with (
            speaking("robots") as on_progress,
            tempfile.TemporaryDirectory(prefix="adagen-") as folder,
        ):
            robots = [(file.stem, read(file, floating=True)) for file in options.models]
            if options.human:
                file = Path(folder) / "human161.urdf"
                file.write_text(human(161), encoding="utf-8")
                robots.append(("figure of 161", read(file)))
            if options.pair:
                robots.append(("two talos, a bar", pair(Path(folder))))
            for name, robot in robots:
                how = options.profile, rules, options.priority, on_progress
                rows += measured(name, robot, options.processes, *how)
    except AdagenError as error:
        print(error, file=sys.stderr)
        return error.status
    about: Mapping[str, Any] = machine()
    compilers = "; ".join(about["compilers"].values())
    text = "\n".join(
        [
            f"{about['processor']}, {about['cores']} cores, {about['system']}; {compilers}. "
            f"Profile: {options.profile}. {rules.rounds} rounds by turns; the fastest evaluation. "
            "≈: from stretches.",
            "",
            *table(HEAD, rows),
            "",
        ]
    )
    publish(options, "shared_robots", text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
