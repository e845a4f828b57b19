"""What emitted solvers keep: figures beside the truth, errors seen, results kept."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from adagen.build import Toolchain
from adagen.cli.main import main
from adagen.plan import Plan
from adagen.studies.stability import emitted, robots
from adagen.studies.stability.audit import Way, source_of
from adagen.studies.stability.draw import draw_study
from adagen.studies.stability.emitted import Study, Subject, digits, subject, suite, tables, ways
from tests.emitted import Builder

ARM = Path(__file__).resolve().parents[3] / "generated_examples" / "models" / "arm7.urdf"


@pytest.fixture(scope="module")
def quick(builder: Builder) -> Toolchain:
    return builder.quick


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What is found here is nobody else's."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


def studied(one: Subject, quick: Toolchain, *asked: Way) -> Study:
    study = Study([one], asked, quick, 600)
    study.run(lambda _: None)
    assert study.left == 0
    return study


def test_every_way_is_asked_for_once() -> None:
    every = ways()
    assert len(set(every)) == len(every)
    # six shapes alone; loops and lines by four meetings, form ada by one, on 2 and 4 threads
    assert len(every) == 2 * (6 + 2 * (2 * 4 + 1))
    assert every[0] == Way("kernels")
    assert {way.form for way in every if way.shape == "joints"} == {"ada"}
    assert len({way.words for way in every}) == len(every)


def test_robots_keep_their_digits_in_every_meeting(quick: Toolchain) -> None:
    one = subject("rods", robots.rods(7), 8)
    study = studied(
        one,
        quick,
        Way("kernels"),
        Way("unrolled", scalar="float"),
        Way("unrolled", 2, meeting="joined"),
        Way("unrolled", 2, meeting="gathered"),
    )
    for cell in study.cells:
        assert cell.verdict == "right"
        least = 11 if cell.way.scalar == "double" else 3
        assert digits(cell.error, cell.way.scalar) > least
        assert cell.executor is not None
        assert digits(cell.executor, cell.way.scalar) > least
    assert len({cell.error for cell in study.cells}) == 4


def test_a_wrong_solver_is_seen(quick: Toolchain, monkeypatch: pytest.MonkeyPatch) -> None:
    """One link of the emitted solver is another's: the joint that is farthest off is named."""

    def spoilt(plan: Plan, way: Way) -> str:
        text, count = re.subn(
            r"w\.result\[2\] = (x\d+);", r"w.result[2] = \1 * Real(1.01);", honest(plan, way)
        )
        assert count == 1
        return text

    honest = source_of
    monkeypatch.setattr(emitted, "source_of", spoilt)
    one = Subject("rods", robots.rods(4), subject("", robots.rods(4), 4).states)
    (cell,) = studied(one, quick, Way("unrolled")).cells
    assert cell.verdict == "wrong, silently"
    assert cell.joint == "j3"


def test_what_cannot_be_solved_is_refused_by_name(quick: Toolchain) -> None:
    one = subject("leaf", robots.massless_leaf(5), 3)
    (cell,) = studied(one, quick, Way("kernels")).cells
    assert (cell.verdict, cell.refused, cell.error) == ("refused", 3, None)


@pytest.mark.slow
def test_the_same_source_is_built_once_and_results_are_kept(
    quick: Toolchain, monkeypatch: pytest.MonkeyPatch
) -> None:
    one = subject("rods", robots.rods(20), 3)
    asked = Way("kernels", 2, meeting="gathered"), Way("kernels", 2, meeting="searched")
    first = studied(one, quick, Way("kernels"), *asked)
    monkeypatch.setattr(emitted, "solved", lambda *_: pytest.fail("it is solved again"))
    again = studied(one, quick, Way("kernels"), *asked)
    assert again.cells == first.cells
    monkeypatch.undo()


def test_time_is_bounded(quick: Toolchain) -> None:
    study = Study([subject("rods", robots.rods(3), 2)], ways(), quick, 0.0)
    study.run(lambda _: None)
    assert study.left >= len(ways()) - 1


def test_the_suites_robots_have_the_suites_state() -> None:
    for one in suite(3):
        assert one.states.count == 3
        if not one.model.closed:  # loops are closed first
            assert np.array_equal(one.states.q[0], robots.state(one.model)[0])


def test_a_users_robot_is_judged_by_the_command(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    words = ["stability", str(ARM), "--shape", "kernels", "--procs", "1", "--states", "4"]
    assert main([*words, "--out", str(tmp_path / "out")]) == 0
    said = capfd.readouterr().out
    assert "loops" in said
    assert "right" in said
    record = json.loads((tmp_path / "out" / "stability_emitted.json").read_text())
    assert [cell["verdict"] for cell in record] == ["right", "right"]
    picture = (tmp_path / "out" / "stability_emitted.svg").read_text()
    assert "decimal digits kept by emitted solvers" in picture
    assert main(["stability", "--emitted", str(ARM)]) == 2
    assert main(["stability", str(ARM), "--shape", "loops"]) == 2


def test_tables_and_pictures_show_all_verdicts(tmp_path: Path) -> None:
    cells = [
        emitted.Cell("a", Way("kernels"), 4, error=1e-15, executor=1e-16, predicted=1e-14),
        emitted.Cell("a", Way("unrolled"), 4, 2, error=1e-3, silent=True, state=1, joint="j"),
        emitted.Cell("b", Way("kernels"), 4, 4),
        emitted.Cell("b", Way("unrolled"), why="no"),
    ]
    rows = list(tables(cells))
    assert [row[-1] for row in rows] == [
        "right",
        "wrong, silently (2 of 4)",
        "refused",
        "no",
    ]
    assert rows[0][2:5] == ["15.0", "16.0", "14.0"]
    draw_study(cells, tmp_path / "study.svg")
    text = (tmp_path / "study.svg").read_text()
    assert "refused" in text
