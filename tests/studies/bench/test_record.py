"""The record, and the tables and pictures that are made of it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from adagen.errors import InputError
from adagen.studies.bench.contest import Rules
from adagen.studies.bench.record import ModelRecord, Record, Row, read_record
from adagen.studies.bench.report import DETAILS, PLAYED, SUMMARY, details, markdown, summary
from adagen.studies.records import write_record

MACHINE: dict[str, Any] = {
    "processor": "Abacus 3000",
    "cores": 2,
    "system": "Linux x86_64",
    "load_before": 0.0,
    "compilers": {"g++": "g++ 12"},
    "packages": {"pin": "4.1"},
}


def row(team: str, median: float, **more: Any) -> Row:
    values: dict[str, Any] = {
        "name": f"{team} {median:g}",
        "team": team,
        "build": "g++ -O3",
        "processes": 1,
        "scalar": "double",
        "what": "in_place",
        "median": median,
        "least": 0.9 * median,
        "turns": (median, 1.1 * median),
        "forward_error": 1e-15,
        "residual": 2e-16,
        **more,
    }
    return Row(**values)


def model(name: str, joints: int) -> ModelRecord:
    rows = (
        row("pinocchio", 900.0 * joints),
        row("pinocchio", 600.0 * joints),
        row("casadi", 200.0 * joints),
        row("mujoco", 700.0 * joints),
        row("adagen", 120.0 * joints, predicted=125.0 * joints),
        row("adagen", 100.0 * joints, scalar="float"),
        row("adagen", 90.0 * joints, processes=2, predicted=80.0 * joints),
        row("adagen", 96.0 * joints, processes=2, what="through_root", predicted=80.0 * joints),
        row("adagen", 87.0 * joints, processes=2, what="stretches", predicted=80.0 * joints),
        row("adagen", 60.0 * joints, processes=4, what="stretches", predicted=55.0 * joints),
    )
    return ModelRecord(name, joints, joints, rows, {"casadi, clang++": "it failed"}, 1.5)


@pytest.fixture
def record() -> Record:
    return Record(MACHINE, Rules(), (model("arm", 7), model("chain10", 10), model("chain20", 20)))


def test_a_record_reads_back_as_it_was_written(record: Record, tmp_path: Path) -> None:
    write_record(record, tmp_path / "bench.json")
    assert read_record(tmp_path / "bench.json") == record


@pytest.mark.parametrize("text", ["", "[]", '{"models": [{}], "rules": {}, "machine": {}}'])
def test_other_files_are_refused(text: str, tmp_path: Path) -> None:
    path = tmp_path / "other.json"
    path.write_text(text)
    with pytest.raises(InputError, match="not a record of measurements"):
        read_record(path)
    with pytest.raises(InputError, match="cannot read it"):
        read_record(tmp_path / "none.json")


def test_the_summary_compares_the_best_of_each(record: Record) -> None:
    cells = dict(zip(SUMMARY[:9], summary(record.models[0]), strict=False))
    assert cells["pinocchio"] == "4200" and cells["× pinocchio"] == "5.00"
    assert cells["× casadi"] == "1.67" and cells["float"] == "700"
    assert summary(record.models[0])[9:13] == ["630", "25%", "672", "20%"]


def test_times_from_stretches_are_marked(record: Record) -> None:
    assert summary(record.models[0])[13:16] == ["≈609", "≈420", "50%"]
    names = {cells[0] for cells in details(record.models[0])}
    assert {"adagen 420, from stretches", "adagen 672, through process 0"} <= names
    assert PLAYED in markdown(record)
    clock = replace(record, models=(replace(record.models[0], rows=record.models[0].rows[:6]),))
    assert PLAYED not in markdown(clock)


def test_the_clock_is_preferred_to_stretches(record: Record) -> None:
    two = record.models[0].timed("adagen", processes=2)
    four = record.models[0].timed("adagen", processes=4)
    assert two is not None and (two.what, two.played) == ("in_place", False)
    assert four is not None and (four.what, four.played) == ("stretches", True)


def test_who_is_absent_leaves_a_dash() -> None:
    alone = ModelRecord("arm", 7, 7, (row("adagen", 500.0),), {}, 1.0)
    assert summary(alone) == ["arm", "7", "–", "–", "–", "500", *["–"] * 13]
    assert details(alone) == [["adagen 500", "500", "450", "–", "", "1e-15", "2e-16"]]


def test_details_name_everyone_the_fastest_first(record: Record) -> None:
    rows = details(record.models[0])
    medians = [float(cells[1]) for cells in rows]
    assert medians == sorted(medians) and len(rows) == len(record.models[0].rows)
    assert all(len(cells) == len(DETAILS) for cells in rows)


def test_the_page_tells_machine_flags_and_who_is_missing(record: Record) -> None:
    page = markdown(record)
    for words in ("Abacus 3000, 2 cores", "g++ 12", "pin 4.1", "- casadi, clang++: it failed"):
        assert words in page
    assert "g++ -O3" in page


@pytest.mark.filterwarnings("error")
def test_every_picture_is_drawn_and_the_same_again(record: Record, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    from adagen.studies.bench.pictures import draw_all

    paths = draw_all(record, tmp_path / "a")
    names = {"bench_models", "bench_chains", "bench_processes", "bench_prediction"}
    assert {path.stem for path in paths} == names
    for first, second in zip(paths, draw_all(record, tmp_path / "b"), strict=True):
        assert first.read_text().startswith("<?xml") and first.read_text() == second.read_text()


@pytest.mark.filterwarnings("error")
def test_pictures_of_nothing_are_left_out(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    from adagen.studies.bench.pictures import draw_all

    alone = ModelRecord("arm", 7, 7, (row("pinocchio", 500.0),), {}, 1.0)
    record = Record(MACHINE, Rules(), (alone,))
    assert [path.stem for path in draw_all(record, tmp_path)] == ["bench_models"]
