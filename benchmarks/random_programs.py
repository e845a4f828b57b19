"""Random robots with random options, emitted, built and checked as a user would.

    python -m benchmarks.random_programs [FILE ...] [--minutes 15] [--seed 1] [--keep DIR]

A third are real robots (package example-robot-data), the others trunks with alike arms, fingers on
these, and links that other arms hang on; with files, all robots are of these. Options are drawn
from those of tests/options.py, scenes from those and from many more (random_scenes.py).
Generation has to end in 0, or refuse the input (1) or the options (2) in words; `make check` has to
end in 0, and the compiler must not warn. CXXFLAGS is passed on. Whatever fails is told at once with
its command and kept in DIR, and the status is 1.
"""

from __future__ import annotations

import argparse
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from adagen.errors import AdagenError
from adagen.library import read
from benchmarks.random_scenes import scene
from benchmarks.real_robots import DATA, FIXED, FLOATING
from tests.options import COMPANIONS, OPTIONS, names_of, typed

LIMIT = 400.0
"""Seconds that a command may take."""
_SCENES = 0.5
"""Share of cases with a scene at random."""
_AXES = ("1 0 0", "0 1 0", "0 0 1")
_INERTIA = '<inertia ixx="{0}" iyy="{1}" izz="{2}" ixy="0.0001" ixz="0" iyz="0"/>'


def humanoid(draw: random.Random) -> str:
    """Return the URDF of a trunk with alike limbs, some with alike fingers."""
    parts = [_link("base", 5.0)]
    trunk = ["base", *_chain(parts, draw, "base", "t", _rows(draw, draw.randrange(8)), 3.0)]
    for group in range(draw.choice((1, 1, 2, 2, 3))):
        limb, fingers = _rows(draw, draw.randint(1, 7)), _rows(draw, draw.randint(1, 4))
        hands, at = draw.choice((0, 2, 3, 5)), draw.choice(trunk)
        for side in range(draw.choice((1, 2, 2, 2, 3, 4))):
            place = at if draw.random() < 0.85 else draw.choice(trunk)
            # By their names they come before the trunk's next joint, or after it.
            name = f"{draw.choice('bcxz')}{group}{side}"
            links = _chain(parts, draw, place, name, limb, 2.0)
            palm = links[-1] if draw.random() < 0.7 else draw.choice(links)
            for finger in range(hands):
                _chain(parts, draw, palm, f"{name}f{finger}", fingers, 0.2)
    return '<robot name="humanoid">\n' + "\n".join(parts) + "\n</robot>\n"


def _rows(draw: random.Random, count: int) -> list[tuple[str, str, str]]:
    """Kind, axis and place of the joints of a limb, which its copies have, too."""
    kinds = ("revolute", "continuous", "prismatic")
    return [
        (
            draw.choices(kinds, (8, 1, 1))[0],
            draw.choice(_AXES),
            f"{draw.uniform(-0.1, 0.1):.2f} 0 {draw.uniform(0.05, 0.3):.2f}",
        )
        for _ in range(count)
    ]


def _chain(
    parts: list[str],
    draw: random.Random,
    parent: str,
    name: str,
    rows: list[tuple[str, str, str]],
    mass: float,
) -> list[str]:
    """Add links one on the other; return their names."""
    names = []
    for k, (kind, axis, place) in enumerate(rows):
        own, turned = f"{name}_{k}", draw.choice(("0 0 0", "0 0 0", "0.3 0 0"))
        parts.append(_link(own, mass * 0.8**k))
        parts.append(
            f'<joint name="j{own}" type="{kind}"><parent link="{parent}"/><child link="{own}"/>'
            f'<origin xyz="{place}" rpy="{turned}"/><axis xyz="{axis}"/>'
            '<limit lower="-2" upper="2" effort="9" velocity="9"/></joint>'
        )
        names.append(own)
        parent = own
    return names


def _link(name: str, mass: float) -> str:
    inertia = _INERTIA.format(*(f"{share * mass:.5f}" for share in (0.01, 0.012, 0.008)))
    return (
        f'<link name="{name}"><inertial><origin xyz="0.01 0.02 0.05"/><mass value="{mass:.3f}"/>'
        f"{inertia}</inertial></link>"
    )


def words(draw: random.Random, robot: Path, folder: Path) -> list[str]:
    """Return a robot and some options, as they are typed; a scene is written into the folder.

    Raises:
        AdagenError: the robot cannot be read.
    """
    case: dict[str, str] = {}
    offered = sorted(set(OPTIONS) - {"--target"})  # what is embedded has no program to check
    model, own = read(robot).model, ""
    staged = draw.random() < _SCENES
    for option in draw.sample(offered, draw.randint(0, 3) if staged else draw.randint(1, 5)):
        value = draw.choice(OPTIONS[option][1:])
        case |= {**COMPANIONS.get((option, value), {}), option: value}
    if staged:
        case.pop("--scene", None)
        own = scene(draw, model, floating="--floating" in case)
    return typed(robot, names_of(robot), case, folder, own)


def outcome(case: list[str], folder: Path) -> tuple[str, str]:
    """Return what became of a command: in a word, and what was said if that is a fault."""
    try:
        command = [sys.executable, "-m", "adagen", *case, "--out", str(folder)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT)
        if done.returncode in (1, 2):
            return "refused", ""
        if done.returncode:
            return "not generated", done.stderr
        done = subprocess.run(
            ["make", "-C", str(folder), "check"], capture_output=True, text=True, timeout=LIMIT
        )
    except subprocess.TimeoutExpired as late:
        return "late", str(late)
    if done.returncode:
        return "not right", done.stdout + done.stderr
    return ("warned of", done.stderr) if "warning:" in done.stderr else ("right", "")


def cases(seed: int, folder: Path, robots: Sequence[Path] = ()) -> Iterator[list[str]]:
    """Yield commands without end; the files they name are in the folder, or are these robots."""
    draw = random.Random(seed)
    real = robots or [DATA / path for path in (*FIXED.values(), *FLOATING.values())]
    while True:
        robot = draw.choice(real)
        if not robots and (draw.random() > 1 / 3 or not robot.is_file()):
            robot = folder / "humanoid.urdf"
            robot.write_text(humanoid(draw))
        try:
            yield words(draw, robot, folder)
        except AdagenError:
            continue


def readable(files: Sequence[Path]) -> list[Path]:
    """Return those of some robots that can be read; what is said of the others is told."""
    kept = []
    for file in files:
        try:
            read(file)
            kept.append(file)
        except AdagenError as error:
            print(f"left out: {error}", flush=True)
    return kept


def main() -> int:
    """Run random cases until the time is over; return 1 if any failed."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("robots", nargs="*", type=Path, metavar="FILE")
    parser.add_argument("--minutes", type=float, default=15.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=Path, default=Path("build", "random_programs"))
    options = parser.parse_args()
    robots = readable(options.robots)
    if options.robots and not robots:
        parser.error("no robot that can be read")
    end, counts = time.monotonic() + 60 * options.minutes, Counter[str]()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for number, case in enumerate(cases(options.seed, folder, robots)):
            if time.monotonic() > end:
                break
            emitted = folder / "emitted"
            shutil.rmtree(emitted, ignore_errors=True)
            found, said = outcome(case, emitted)
            counts[found] += 1
            if said:
                kept = options.keep / f"{options.seed}_{number}"
                shutil.copytree(folder, kept, dirs_exist_ok=True)
                print(f"{found}: adagen {' '.join(case)}\n{said[-1000:]}\nkept: {kept}", flush=True)
    print(", ".join(f"{count} {found}" for found, count in counts.most_common()))
    return int(bool(set(counts) - {"right", "refused"}))


if __name__ == "__main__":
    raise SystemExit(main())
