"""The paper's figures, and the records behind them, are made anew to the byte."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from adagen.schedule import Topology, load_profile
from adagen.search import find_schedule
from benchmarks.paper import figures, pictures, robots, timing
from benchmarks.paper.measured import model_of
from tests.slow import all_but

DOCS = Path(__file__).resolve().parents[2] / "docs" / "records" / "pictures"
MAKERS: dict[str, Callable[[], None]] = {
    "fig3": figures.figure_3,
    "fig4_predicted": lambda: timing.figure_4(run=False),
    "fig5": figures.figure_5,
    "fig6": figures.figure_6,
    "fig7": figures.figure_7,
    "fig8": figures.figure_8,
    "fig9": figures.figure_9,
}


@pytest.mark.parametrize("name", all_but(MAKERS, "fig7"))
def test_picture(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pictures, "FOLDER", tmp_path)
    MAKERS[name]()
    for file in (f"{name}.svg", f"{name}.json"):
        made = (tmp_path / file).read_text(encoding="utf-8")
        assert made == (DOCS / file).read_text(encoding="utf-8")


def test_table_1_is_printed(capsys: pytest.CaptureFixture[str]) -> None:
    figures.table_1()
    text = capsys.readouterr().out
    for row in (("7", "141.4", "7", "3", "11", "94.8"), ("31", "525.4", "31", "17", "45", "317.4")):
        assert any(all(cell in line.split() for cell in row) for line in text.splitlines())


@pytest.mark.parametrize(
    ("dofs", "joints", "one", "two", "four"),
    [(40, 15, 253.6, 134.0, 104.0), (52, 19, 309.6, 176.0, 132.0), (161, 53, 790.2, 407.6, 275.8)],
)
def test_table_2_as_predicted(dofs: int, joints: int, one: float, two: float, four: float) -> None:
    topology = Topology.of(model_of(robots.human(dofs)))
    assert (len(topology), sum(topology.dofs)) == (joints, dofs)
    for processes, time in ((1, one), (2, two), (4, four)):
        schedule = find_schedule(topology, processes, profile=load_profile("paper"))
        assert (schedule.verdict, schedule.makespan) == ("optimal", time)
