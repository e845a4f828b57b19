"""Tuning: every candidate is built, the fastest wins, failures are reported and passed over."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from adagen.build import Toolchain
from adagen.build.toolchain import with_compiler
from adagen.errors import EnvironmentFault
from adagen.run import Completed, tune
from adagen.run.tune import Candidate, Trial, candidates, table

TOOLS = Toolchain(("mpicxx",), ("c++",), ("mpiexec",), Path("eigen"), (), False, (("A", "1"),))
TIMES = {"slow": [90.0] * 5, "fast": [50.0, 40.0, 60.0, 80.0, 70.0]}


@pytest.fixture
def built(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Let texts be built without a compiler and run as long as TIMES says."""
    log: list[str] = []

    def build(text: str, name: str, toolchain: Toolchain) -> Path:
        log.append(f"{text} {toolchain.variables({}).get('OMPI_CXX', '')}")
        if text == "broken":
            raise EnvironmentFault("the compiler failed: no such thing")
        return Path(text, name)

    turns = {text: iter(times) for text, times in TIMES.items()}

    def launch(program: Path, processes: int, *_: object) -> Completed:
        assert processes == 2
        median = next(turns[program.parent.name])
        return Completed(
            0, json.dumps({"time": {"source": "clock", "in_place": {"median_ns": median}}}), ""
        )

    monkeypatch.setattr("adagen.run.tune.build_executable", build)
    monkeypatch.setattr("adagen.run.tune.launch", launch)
    return log


def test_the_fastest_of_all_rounds_is_first_and_failures_last(built: list[str]) -> None:
    texts = {"joints": "slow", "unrolled": "fast", "kernels": "broken"}
    tried = [Candidate(shape) for shape in texts]
    trials = tune.tune(tried, lambda c: texts[c.shape], "robot", 2, TOOLS)
    assert [(t.candidate.shape, t.nanoseconds) for t in trials] == [
        ("unrolled", 40.0),
        ("joints", 90.0),
        ("kernels", None),
    ]
    assert "no such thing" in table(trials).splitlines()[-1]
    assert len(built) == 3


def test_the_same_text_is_built_once_for_each_compiler(built: list[str]) -> None:
    tried = [Candidate("unrolled", chunk, cxx) for chunk in (250, 1000) for cxx in ("", "clang++")]
    with pytest.raises(StopIteration):  # the times of one candidate are spent by two
        tune.tune(tried, lambda _: "fast", "robot", 2, TOOLS)
    assert built == ["fast ", "fast clang++"]


def test_without_a_program_that_works_there_is_no_answer(built: list[str]) -> None:
    with pytest.raises(EnvironmentFault, match="no such thing"):
        tune.tune([Candidate("joints")], lambda _: "broken", "robot", 2, TOOLS)
    assert built == ["broken "]


def test_lengths_of_functions_are_tried_where_there_is_a_choice() -> None:
    tried = candidates(["joints", "unrolled"], ["", "clang++"])
    assert len(tried) == 2 + 2 * len(tune.CHUNKS)
    assert {c.chunk for c in tried if c.shape == "joints"} == {0}


def test_a_compiler_stands_behind_the_wrapper() -> None:
    assert with_compiler(TOOLS, "") is TOOLS
    assert with_compiler(TOOLS, "clang++").variables({}) == {
        "A": "1",
        "OMPI_CXX": "clang++",
        "MPICH_CXX": "clang++",
    }


def test_the_table_names_what_was_tried() -> None:
    lines = table([Trial(Candidate("unrolled", 250, "clang++"), 123.4, 2.0)]).splitlines()
    assert " ".join(lines[1].split()) == "123 2.0 s unrolled, functions of 250 values, clang++"
