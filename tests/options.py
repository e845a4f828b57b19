"""Cases of the command line: documented options, their values, and robots to try them on."""

from __future__ import annotations

import itertools
import random
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

import adagen
from tests.real import real_robot

EXAMPLES = Path(__file__).resolve().parents[1] / "generated_examples" / "models"
ROBOTS = {
    "arm7": "",
    "humanoid": "",
    "mobile": "",
    "fourbar": "",
    "double_pendulum": "double_pendulum_description/urdf/double_pendulum.urdf",
    "panda": "panda_description/urdf/panda.urdf",
    "solo12": "solo_description/robots/solo12.urdf",
    "allegro": "allegro_hand_description/urdf/allegro_right_hand.urdf",
    "talos_arm": "talos_data/robots/talos_left_arm.urdf",
}
"""Path among real robots, or "" for a model of this project."""
CLOSED = "fourbar"
"""The robot whose own scene closes a loop."""

SCENES = {
    "effects": 'damping = "urdf"\nfriction = 0.1\n',
    "planar": 'base = {{ kind = "planar", axis = [0, 0, 1] }}\n',
    "moon": "gravity = [0, 0, -1.62]\n",
    "rest": "at_rest = true\n",
    "first": 'accelerations = ["{first}"]\n',
    "pushed": 'forces = ["{link}"]\n',
    "outputs": '[outputs]\nlink_accelerations = ["{link}"]\nreaction_forces = ["{last}"]\n',
    "inverse": '[outputs]\ninverse_inertia = ["{link}"]\n',
    "held": '[lock]\n"{last}" = 0.1\n',
    "driven": '[joints."{first}"]\nprescribed = true\n',
    "geared": '[joints."{first}"]\nrotor_inertia = 0.01\nstiffness = 3.0\n',
}
"""Texts of scenes; the robot's first and last joint and its last link are filled in."""

OPTIONS: dict[str, tuple[str, ...]] = {
    "--procs": ("1", "2", "3", "4", "auto"),
    "--form": ("segment", "ada"),
    "--scalar": ("double", "float"),
    "--refine": ("", "0", "1", "2"),
    "--residual": ("", "own", "wide"),
    "--certify": ("", "yes"),
    "--reproducible": ("", "yes"),
    "--shape": ("auto", "unrolled", "kernels", "joints"),
    "--batch": ("", "yes"),
    "--schedule": ("auto", "balanced", "sequential", "middle-out"),
    "--objective": ("", "time", "accuracy"),
    "--split": ("", "free", "any"),
    "--strategy": ("", "astar", "paper"),
    "--tie": ("", "lex"),
    "--channel": ("", "window", "message", "threads"),
    "--scene": ("", *SCENES),
    "--floating": ("", "yes"),
    "--mimic": ("", "yes"),
    "--profile": ("", "paper"),
    "--target": ("", "embedded"),
    "--runtime": ("", "gravity", "mass:{link}"),
    "--single-file": ("", "yes"),
    "--loop-forces": ("", "yes"),
    "--parts": ("", "none"),
}
"""Values of each option, the default first; "" leaves it out, "yes" is that of a flag."""

FLAGS = {name for name, values in OPTIONS.items() if values[1:] == ("yes",)}
EMITTED = {
    *("--refine", "--residual", "--certify", "--shape", "--batch", "--channel"),
    *("--target", "--runtime", "--single-file", "--loop-forces"),
}
"""Options that say how code is emitted: what only schedules does not know them."""
COMPANIONS = {
    ("--shape", "joints"): {"--form": "ada"},
    ("--residual", "own"): {"--refine": "1", "--procs": "1"},
    ("--residual", "wide"): {"--refine": "1"},
}
"""What a value needs beside it."""

Case = Mapping[str, str]
"""A robot, and values of options; those left out are defaults."""


def values() -> list[tuple[str, str]]:
    """All values of options but the defaults."""
    return [(name, value) for name, known in OPTIONS.items() for value in known[1:]]


def alone() -> list[Case]:
    """Every value by itself, on one robot after the other that has a use for it."""
    turns = itertools.cycle(robot for robot in ROBOTS if robot != CLOSED)
    cases: list[Case] = []
    for name, value in values():
        robot = CLOSED if name == "--loop-forces" else next(turns)
        cases.append({**COMPANIONS.get((name, value), {}), "robot": robot, name: value})
    return cases


def pairs() -> Iterator[Case]:
    """Every pair of values of two options, on one robot after the other."""
    turns = itertools.cycle(ROBOTS)
    for one, other in itertools.combinations(values(), 2):
        if one[0] == other[0]:
            continue
        needed = {**COMPANIONS.get(one, {}), **COMPANIONS.get(other, {})}
        yield {**needed, "robot": next(turns), one[0]: one[1], other[0]: other[1]}


def drawn(count: int, seed: int) -> list[Case]:
    """Cases of three or four values at random, which may exclude each other."""
    draw = random.Random(seed)
    cases: list[Case] = []
    for _ in range(count):
        names = draw.sample(sorted(OPTIONS), draw.choice((3, 4)))
        some = {name: draw.choice(OPTIONS[name][1:]) for name in names}
        cases.append({"robot": draw.choice(tuple(ROBOTS)), **some})
    return cases


def path_of(robot: str) -> Path:
    """Return the file of a robot; tests that need one that is not here skip."""
    return real_robot(ROBOTS[robot]) if ROBOTS[robot] else EXAMPLES / f"{robot}.urdf"


@cache
def _names(robot: str) -> dict[str, str]:
    return names_of(path_of(robot))


def names_of(robot: Path) -> dict[str, str]:
    """Return the names that values of options ask for, of the robot in a file."""
    model = adagen.read(robot).model
    joints = [joint.name for joint in model.joints]
    return {"first": joints[0], "last": joints[-1], "link": model.links[-1].name}


def words_of(case: Case, folder: Path, *, emitted: bool = True) -> list[str]:
    """Return the words of the command line; a scene is written into the folder."""
    robot = case["robot"]
    known = {name: x for name, x in case.items() if emitted or name not in EMITTED}
    closed = (EXAMPLES / f"{robot}.toml").read_text() if robot == CLOSED else ""
    return typed(path_of(robot), _names(robot), known, folder, closed)


def typed(
    robot: Path, names: Mapping[str, str], case: Case, folder: Path, scene: str = ""
) -> list[str]:
    """Return a robot and options as they are typed; the folder has the scene, if there is one.

    Args:
        robot: its file.
        names: of its first and last joint and its last link, which values may ask for.
        case: values of options.
        folder: where a scene is written.
        scene: what stands in it at the end.
    """
    words = [str(robot)]
    for name, value in case.items():
        if name == "robot" or value == "":
            continue
        if name == "--scene":
            scene = SCENES[value].format(**names) + scene
        else:
            words += [name] if name in FLAGS else [name, value.format(**names)]
    if scene:
        file = folder / f"{robot.stem}.toml"
        file.write_text(scene)
        words += ["--scene", str(file)]
    return words
