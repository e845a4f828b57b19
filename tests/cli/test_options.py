"""Every documented option over real robots: done, or refused with a reason, and never a fault.

Every value of an option occurs alone, and every pair of values of two options that is not refused
occurs on some robot, in a design from a seeded greedy search; a few of what is emitted are built,
run and checked.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Mapping
from functools import cache
from importlib import metadata
from pathlib import Path

import pytest

from adagen.cli import main
from adagen.emit.around import PROGRAM_FILE
from tests.emitted import WRITTEN, Builder, Solver

EXAMPLES = Path(__file__).resolve().parents[2] / "generated_examples" / "models"
PACKAGE = "example-robot-data"
ROBOTS = {
    "arm7": "",
    "humanoid": "",
    "mobile": "",
    "double_pendulum": "double_pendulum_description/urdf/double_pendulum.urdf",
    "panda": "panda_description/urdf/panda.urdf",
    "solo12": "solo_description/robots/solo12.urdf",
    "allegro": "allegro_hand_description/urdf/allegro_right_hand.urdf",
    "talos_arm": "talos_data/robots/talos_left_arm.urdf",
}
"""Path in the package, or "" for a model of this project."""

SCENES = {
    "effects": 'damping = "urdf"\nfriction = 0.1\n',
    "planar": 'base = { kind = "planar", axis = [0, 0, 1] }\n',
    "moon": "gravity = [0, 0, -1.62]\n",
}

OPTIONS: dict[str, tuple[str, ...]] = {
    "robot": tuple(ROBOTS),
    "--procs": ("1", "2", "3", "4", "auto"),
    "--form": ("segment", "ada"),
    "--scalar": ("double", "float", "mixed"),
    "--refine": ("", "0", "1", "2"),
    "--shape": ("auto", "unrolled", "kernels", "joints"),
    "--batch": ("", "yes"),
    "--schedule": ("auto", "balanced", "sequential", "middle-out"),
    "--objective": ("", "time", "accuracy", "both"),
    "--split": ("", "free", "any"),
    "--channel": ("", "window", "message"),
    "--scene": ("", *SCENES),
    "--floating": ("", "yes"),
    "--mimic": ("", "yes"),
    "--profile": ("", "paper"),
}
"""Values of each option, the default first; "" leaves it out, "yes" is that of a flag."""

Case = Mapping[str, str]


def pairs_of(case: Case) -> set[tuple[tuple[str, str], tuple[str, str]]]:
    return set(itertools.combinations(sorted(case.items()), 2))


def is_refused(case: Case) -> bool:
    """Return whether options exclude each other, or do not suit the robot."""
    refined = case["--scalar"] == "mixed" or case["--refine"] in ("1", "2")
    straight, batch = case["--shape"] == "unrolled", case["--batch"] == "yes"
    searched = case["--objective"] in ("time", "accuracy") or case["--split"] != ""
    moved = case["--floating"] == "yes", case["--scene"] == "planar"
    return (
        (refined and (batch or straight or case["--shape"] == "kernels"))
        or (case["--scalar"] == "mixed" and case["--refine"] in ("0", "1"))
        or (case["--scene"] == "effects" and refined)
        or (batch and case["--shape"] == "joints")
        or (case["--form"] == "ada" and case["--shape"] == "kernels")
        or (searched and case["--schedule"] != "auto")
        or all(moved)
        or (any(moved) and case["robot"] == "mobile")
        or (case["--mimic"] == "yes" and case["robot"] == "talos_arm")
    )


def is_long(case: Case) -> bool:
    """Return whether a case is searched for longer than all others together.

    Each two of these values occur in other cases.
    """
    digits = case["--objective"] == "accuracy" and case["--form"] == "segment"
    return digits and case["robot"] == "humanoid" and case["--procs"] in ("3", "4")


def any_case(draw: random.Random, *, refused: bool) -> Case:
    while True:
        case = {name: draw.choice(values) for name, values in OPTIONS.items()}
        if is_refused(case) == refused and not is_long(case):
            return case


@cache
def design(seed: int = 0, tries: int = 50) -> list[Case]:
    """Return cases that hold every value alone, and every pair of values that is not refused."""
    draw, robots = random.Random(seed), itertools.cycle(ROBOTS)
    plain = {name: values[0] for name, values in OPTIONS.items()}
    alone = [
        {**plain, name: value, "robot": next(robots)}
        for name, values in OPTIONS.items()
        for value in values[1:]
        if name != "robot"
    ]
    wanted = {pair for _ in range(3000) for pair in pairs_of(any_case(draw, refused=False))}
    cases: list[Case] = [case for case in alone if not is_refused(case)]
    wanted -= {pair for case in cases for pair in pairs_of(case)}
    while wanted:
        few = (any_case(draw, refused=False) for _ in range(tries))
        best = max(few, key=lambda case: len(pairs_of(case) & wanted))
        if pairs_of(best) & wanted:
            cases.append(best)
            wanted -= pairs_of(best)
    return cases


FLAGS = {"--batch", "--floating", "--mimic"}
EMITTED = {"--refine", "--shape", "--batch", "--channel"}


def path_of(robot: str) -> Path:
    if not ROBOTS[robot]:
        return EXAMPLES / f"{robot}.urdf"
    try:
        package = metadata.distribution(PACKAGE)
    except metadata.PackageNotFoundError:
        pytest.skip(f"{PACKAGE} is not installed")
    folder = Path(str(package.locate_file(f"cmeel.prefix/share/{PACKAGE}/robots")))
    return folder / ROBOTS[robot]


def words_of(case: Case, folder: Path, *, emitted: bool = True) -> list[str]:
    words = []
    for name, value in case.items():
        if name == "robot" or value == "" or (name in EMITTED and not emitted):
            continue
        if name == "--scene":
            (folder / f"{value}.toml").write_text(SCENES[value])
            value = str(folder / f"{value}.toml")
        words += [name] if name in FLAGS else [name, value]
    return words


def done_or_refused(words: list[str], capsys: pytest.CaptureFixture[str]) -> bool:
    """Run the command line; whether it was done, and if it was not, said why in a line."""
    status = main(words)
    told = capsys.readouterr().err
    assert status in (0, 1, 2), f"{' '.join(words)}\n{told}"
    assert "Traceback" not in told and "internal error" not in told, told
    if status != 0:
        *_, last = told.splitlines()
        assert "error: " in last and len(last.partition("error: ")[2].split()) > 3, told
    return status == 0


def test_the_design_holds_every_value() -> None:
    for name, values in OPTIONS.items():
        assert {case[name] for case in design()} == set(values)


@pytest.mark.parametrize("robot", ROBOTS)
def test_real_robots(robot: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    cases = [case for case in design() if case["robot"] == robot]
    done = 0
    for k, case in enumerate(cases):
        out = tmp_path / str(k)
        words = words_of(case, tmp_path)
        ok = done_or_refused([str(path_of(robot)), *words, "--out", str(out)], capsys)
        assert ok == out.exists() and (not ok or len(list(out.iterdir())) == WRITTEN)
        done += ok
        if k % 3 == 0:
            assert not ok or main(["verify", str(out)]) == 0, capsys.readouterr()
            words = words_of(case, tmp_path, emitted=False)
            done_or_refused(["schedule", str(path_of(robot)), *words], capsys)
    assert done >= len(cases) // 2  # a robot may refuse a shape, for one


def test_what_excludes_each_other_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    draw = random.Random(1)
    for _ in range(25):
        case = any_case(draw, refused=True)
        words = [str(path_of(case["robot"])), *words_of(case, tmp_path)]
        assert not done_or_refused([*words, "--out", str(tmp_path / "out")], capsys), words
        assert not (tmp_path / "out").exists()


def test_shared_robots(shared: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robots = sorted(shared.glob("real/*.urdf"))
    done = [
        done_or_refused(
            [str(robot), *words_of(design()[3 * k], tmp_path), "--out", str(tmp_path / "out")],
            capsys,
        )
        for k, robot in enumerate(robots)
    ]
    assert any(done)


@pytest.mark.parametrize(
    ("robot", "asked"),
    [
        ("arm7", "--procs 2 --scalar mixed"),
        ("mobile", "--procs 2 --form ada --scalar float --schedule sequential"),
        ("double_pendulum", "--procs 2 --batch --scene effects"),
        ("mobile", "--procs 3 --schedule balanced --shape joints --refine 1"),
    ],
)
def test_a_few_are_built_and_right(
    robot: str,
    asked: str,
    builder: Builder,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    words = asked.replace("effects", str(tmp_path / "effects.toml")).split()
    (tmp_path / "effects.toml").write_text(SCENES["effects"])
    assert main([str(path_of(robot)), *words, "--out", str(tmp_path)]) == 0, capsys.readouterr().err
    (source,) = (file for file in tmp_path.glob("*.cpp") if file.name != PROGRAM_FILE)
    executable = builder.compile(source.read_text(), source.stem)
    done = Solver(executable, int(source.stem[-1]), builder.toolchain).run("--check")
    assert done.status == 0 and "right" in done.stdout, done.stderr
