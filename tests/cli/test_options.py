"""Every documented option over real robots: done, or refused with a reason, and never a fault.

The cases are those of tests/options.py. Every value by itself, and some at random, run in seconds;
every pair of values, and many at random, are slow tests. A few of what is emitted are built, run
and checked.
"""

from __future__ import annotations

import subprocess
from collections.abc import Iterable
from pathlib import Path

import pytest

from adagen.cli import main
from adagen.emit.solver_program import PROGRAM_FILE
from tests.emitted import Builder, Solver, make_variables
from tests.options import (
    OPTIONS,
    ROBOTS,
    SCENES,
    Case,
    alone,
    drawn,
    pairs,
    path_of,
    words_of,
)
from tests.slow import slow, spread

PARTS, SLICES = 4, 24
"""Parts that tests of many cases have, for workers side by side, and of most cases."""


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


def generated(
    cases: Iterable[Case], folder: Path, capsys: pytest.CaptureFixture[str]
) -> list[tuple[Case, Path]]:
    """Generate all cases that are not refused; of every eighth, see the schedule, and verify it."""
    found = []
    for k, case in enumerate(cases):
        out = folder / str(k)
        done = done_or_refused([*words_of(case, folder), "--out", str(out)], capsys)
        assert done == out.exists() and (not done or any(out.glob("*.cpp")))
        if done:
            found.append((case, out))
        if k % 8 == 0:
            assert not done or main(["verify", str(out)]) == 0, capsys.readouterr()
            done_or_refused(["schedule", *words_of(case, folder, emitted=False)], capsys)
    return found


def test_cases_hold_every_value_and_robot() -> None:
    every = alone()
    for name, values in OPTIONS.items():
        assert {case[name] for case in every if name in case} >= set(values[1:])
    assert {case["robot"] for case in every} == set(ROBOTS)


@pytest.mark.parametrize("part", spread(range(PARTS), 1))
def test_every_value_alone_is_done(
    part: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cases = alone()[part::PARTS]
    assert len(generated(cases, tmp_path, capsys)) == len(cases)


@pytest.mark.parametrize("part", spread(range(PARTS), 1))
def test_some_values_at_random(
    part: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert generated(drawn(12, seed=part), tmp_path, capsys)


@pytest.mark.slow
@pytest.mark.parametrize("part", range(SLICES))
def test_every_pair_of_values(
    part: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cases = list(pairs())[part::SLICES]
    assert len(generated(cases, tmp_path, capsys)) > len(cases) // 2


@pytest.mark.slow
@pytest.mark.parametrize("part", range(2 * PARTS))
def test_many_values_at_random(
    part: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert generated(drawn(50, seed=10 + part), tmp_path, capsys)


@pytest.mark.slow
@pytest.mark.parametrize("part", range(2 * PARTS))
def test_a_sample_of_pairs_is_built_and_right(
    part: int, builder: Builder, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cases = [case for case in pairs() if "--target" not in case][45 * part :: 360]
    for case, out in generated(cases, tmp_path, capsys):
        command = ["make", "-s", "-C", str(out), *make_variables(builder.toolchain), "check"]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == 0, f"{case}\n{done.stdout}{done.stderr}"


def test_shared_robots(shared: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robots = sorted(shared.glob("real/*.urdf"))
    cases = [case for case in alone() if not {"--scene", "--runtime"} & set(case)]
    done = []
    for k, robot in enumerate(robots[::3]):
        _, *words = words_of({**cases[3 * k], "robot": "arm7"}, tmp_path)
        done.append(done_or_refused([str(robot), *words, "--out", str(tmp_path / str(k))], capsys))
    assert any(done)


@pytest.mark.parametrize(
    ("robot", "asked"),
    [
        slow("arm7", "--procs 2 --scalar float"),
        ("mobile", "--procs 2 --form ada --scalar float --schedule sequential"),
        ("double_pendulum", "--procs 2 --batch --scene effects"),
        slow("mobile", "--procs 3 --schedule balanced --form ada --shape joints --refine 1"),
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
