"""generated_examples holds what is emitted now, byte for byte."""

from __future__ import annotations

import pickle
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from adagen.cli import main
from adagen.emit.runtime import runtime_files
from adagen.emit.solver_program import PROGRAM_FILE
from adagen.plan import FORMS
from tests.emitted import WRITTEN
from tests.golden.directory import HINT, differences, held, update
from tests.golden.examples import EXAMPLES, FOLDER, KEPT, golden_files


@pytest.fixture(scope="module")
def emitted() -> dict[str, bytes]:
    return golden_files()


@pytest.mark.golden
def test_the_examples_are_what_is_emitted_now(
    emitted: dict[str, bytes], request: pytest.FixtureRequest
) -> None:
    if request.config.getoption("--update-golden"):
        update(FOLDER, emitted, KEPT)
    told = differences(FOLDER, emitted, KEPT)
    if told:
        pytest.fail(told, pytrace=False)


def test_the_table_covers_what_it_should() -> None:
    processes: dict[str, set[int]] = {}
    for example in EXAMPLES:
        if example.closed:  # they are for one process
            continue
        processes.setdefault(example.robot, set()).add(example.processes)
    assert any(example.closed for example in EXAMPLES)
    assert all(len(counts) >= 2 for counts in processes.values())
    assert set.union(*processes.values()) == {1, 2, 3, 4}
    assert len({example.stem for example in EXAMPLES}) == len(EXAMPLES)
    kinds = {joint.kind.name for example in EXAMPLES for joint in example.model().joints}
    assert kinds == {"revolute", "prismatic", "spherical", "planar", "floating"}
    assert {example.form for example in EXAMPLES} == set(FORMS)
    assert {example.scalar for example in EXAMPLES} == {"double", "float"}
    assert {example.model().floating for example in EXAMPLES} == {True, False}
    assert any(joint.mimic for example in EXAMPLES for joint in example.model().joints)


OTHER_SUM = """
import builtins, math, pickle, sys
plain, compensates = builtins.sum, sum([0.1] * 10) == 1.0

def other(values, start=0):
    values = list(values)
    if not any(type(x) is float for x in values):
        return plain(values, start)
    if not compensates:
        return plain([start, math.fsum(values)]) if start else math.fsum(values)
    for value in values:
        start = start + value
    return start

builtins.sum = other
from tests.golden.examples import golden_files
sys.stdout.buffer.write(pickle.dumps(golden_files()))
"""
"""Emits the examples with sums of floats as in Python before 3.12, or as since: these carry what is
rounded off."""


def test_emitting_again_by_another_python_gives_the_same_bytes(emitted: dict[str, bytes]) -> None:
    root = str(FOLDER.parent)
    command = [sys.executable, "-c", OTHER_SUM]
    again = subprocess.run(command, cwd=root, capture_output=True, timeout=300)
    assert again.returncode == 0, again.stderr.decode()
    assert pickle.loads(again.stdout) == emitted


def test_nothing_is_dated_measured_or_of_this_machine(emitted: dict[str, bytes]) -> None:
    home, checkout = str(Path.home()), str(FOLDER.parent)
    for name, data in emitted.items():
        text = data.decode("ascii" if name.endswith(".cpp") else "utf-8")
        assert text.endswith("\n") and "\r" not in text, name
        assert not re.search(r"\b20[2-9]\d-\d\d-\d\d\b|__DATE__|__TIME__", text), name
        assert checkout not in text and (home == "/" or f"{home}/" not in text), name


def test_the_command_line_writes_the_same(emitted: dict[str, bytes], tmp_path: Path) -> None:
    (example,) = (e for e in EXAMPLES if e.stem == "mobile_p3")
    robot, out = tmp_path / "models" / example.urdf.name, tmp_path / example.stem
    robot.parent.mkdir()
    shutil.copy(example.urdf, robot)
    words = [str(robot), "--procs", "3", "--form", example.form]
    assert main([*words, "--out", str(out)]) == 0
    files = {f"{example.stem}/{name}": data for name, data in held(out).items()}
    shared = {PROGRAM_FILE, *runtime_files()}
    assert len(files) == WRITTEN - 1 + len(runtime_files())
    assert all(files.pop(f"{example.stem}/{name}") == emitted[name] for name in shared)
    assert files == {name: emitted[name] for name in files}


EXPECTED = {"a/x.cpp": b"one\ntwo\n", "b.json": b"{}\n"}


class TestDirectory:
    def test_an_update_makes_it_hold_what_is_expected_and_nothing_else(
        self, tmp_path: Path
    ) -> None:
        (tmp_path / "old").mkdir()
        for name in ("old/stale.cpp", "a", "Makefile"):
            (tmp_path / name).write_text("old")
        (tmp_path / "a").unlink()
        update(tmp_path, EXPECTED, ("Makefile",))
        assert held(tmp_path, ("Makefile",)) == EXPECTED
        assert differences(tmp_path, EXPECTED, ("Makefile",)) == ""
        assert sorted(path.name for path in tmp_path.iterdir()) == ["Makefile", "a", "b.json"]

    def test_missing_stale_and_different_are_told_with_the_way_out(self, tmp_path: Path) -> None:
        update(tmp_path, EXPECTED)
        (tmp_path / "b.json").unlink()
        (tmp_path / "a" / "x.cpp").write_bytes(b"one\nzwei\n")
        (tmp_path / "c.cpp").write_text("left over")
        told = differences(tmp_path, EXPECTED).splitlines()
        assert told[:3] == ["missing: b.json", "stale: c.cpp", "different: a/x.cpp"]
        assert {"-zwei", "+two"} <= set(told)
        assert told[-1] == HINT

    def test_an_empty_folder_fails_with_the_hint(self, tmp_path: Path) -> None:
        told = differences(tmp_path, EXPECTED)
        assert told.splitlines() == ["missing: a/x.cpp", "missing: b.json", HINT]

    def test_a_long_difference_is_cut(self, tmp_path: Path) -> None:
        update(tmp_path, {"x": b"old\n" * 5000})
        told = differences(tmp_path, {"x": b"new\n" * 5000}).splitlines()
        assert len(told) < 70
        assert "lines more of x" in told[-2]

    def test_line_endings_count(self, tmp_path: Path) -> None:
        update(tmp_path, {"x": b"a\r\n"})
        assert "different: x" in differences(tmp_path, {"x": b"a\n"})
