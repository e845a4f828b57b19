"""How far solvers scale: the record, its tables and pictures; measured on small chains."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.model import Model
from adagen.reference import forward_dynamics
from adagen.schedule import load_profile, shipped_fabric
from adagen.states import States
from adagen.studies.bench import peers as bench_peers
from adagen.studies.bench import scale as study
from adagen.studies.bench.contest import Contestant, Rules, Turn
from adagen.studies.bench.scale import Wanted, measure_chains, predicted_batches
from adagen.studies.bench.scale_record import (
    BatchRow,
    Scale,
    ScaleRow,
    read_scale,
)
from adagen.studies.bench.scale_report import BATCHES, TIMES, batches, markdown, times
from adagen.studies.records import write_record
from tests.models import serial_chain
from tests.studies.bench.test_record import MACHINE

Array = NDArray[np.float64]


def row(joints: int, processes: int, least: float, **more: object) -> ScaleRow:
    source = "clock" if processes <= 2 else "stretches"
    name = f"adagen P={processes}"
    made = ScaleRow("adagen", name, joints, processes, source, 1.1 * least, least, 1e-15, least)
    return replace(made, **more)  # type: ignore[arg-type]


@pytest.fixture
def scale() -> Scale:
    rows = tuple(
        each
        for joints in (100, 200)
        for each in (
            row(joints, 1, 40.0 * joints),
            row(
                joints, 2, 30.0 * joints, predicted=25.0 * joints, meeting="exchange", scaled=3500.0
            ),
            row(joints, 2, 24.0 * joints, source="stretches", scaled=3500.0),
            row(joints, 4, 16.0 * joints, predicted=20.0 * joints),
            row(joints, 1, 150.0 * joints, team="pinocchio", name="pinocchio LOCAL"),
        )
    )
    held = (
        BatchRow(1, 1, "clock", 1e7, 9e6),
        BatchRow(1, 2, "clock", 2e7, 1e7),
        BatchRow(2, 64, "predicted", 6e8, 3e7, "the link of process 0's host"),
    )
    return Scale(MACHINE, Rules(rounds=2), "default", rows, "arm", held, {"a": "b"})


def test_a_record_reads_back_as_it_was_written(scale: Scale, tmp_path: Path) -> None:
    write_record(scale, tmp_path / "scale.json")
    assert read_scale(tmp_path / "scale.json") == scale


@pytest.mark.parametrize("text", ["", "[]", '{"rows": [{}], "rules": {}, "machine": {}}'])
def test_other_files_are_refused(text: str, tmp_path: Path) -> None:
    (tmp_path / "other.json").write_text(text)
    with pytest.raises(InputError, match="not a record of scaling"):
        read_scale(tmp_path / "other.json")
    with pytest.raises(InputError, match="cannot read it"):
        read_scale(tmp_path / "none.json")


def test_tables_tell_what_is_saved_beside_the_ideal(scale: Scale) -> None:
    cells = [dict(zip(TIMES, each, strict=True)) for each in times(scale)[:5]]
    assert [each["P"] for each in cells] == ["1", "2", "2", "4", "pinocchio"]
    assert [each["us"] for each in cells] == ["4", "3", "≈2.4", "≈1.6", "15"]
    assert [each["saved"] for each in cells] == ["", "25%", "40%", "60%", "3.8 x"]
    assert [each["ideal"] for each in cells] == ["", "50%", "50%", "75%", ""]
    assert [each["off"] for each in cells] == ["+0%", "+20%", "+0%", "-20%", "+0%"]
    assert [each["at speed"] for each in cells] == ["", "-14%", "-31%", "", ""]


def test_batches_of_hosts_are_marked_as_predicted(scale: Scale) -> None:
    assert [each[:2] for each in batches(scale)] == [["1", "1"], ["1", "2"], ["≈2", "64"]]
    assert all(len(each) == len(BATCHES) for each in batches(scale))
    page = markdown(scale)
    for words in ("Abacus 3000, 2 cores", "Batches of arm", "| exchange |", "≈2.4"):
        assert words in page


def test_the_pictures_hold_every_line_and_the_ideal_ones(scale: Scale, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    from adagen.studies.bench.scale_pictures import draw_scale

    paths = draw_scale(scale, tmp_path)
    assert [path.name for path in paths] == ["scale_joints.svg", "scale_batches.svg"]
    joints, held = (path.read_text() for path in paths)
    lines = points(joints)
    wanted = {"adagen P=1", "adagen P=2", "adagen P=4 (from stretches)"}
    wanted |= {"ideal P=2", "ideal P=4", "pinocchio ABA, best build"}
    assert set(lines) == wanted
    assert all(len(line) == 2 for line in lines.values())  # a point for each chain
    # Downwards is faster: pinocchio above P=1 above P=2 above its ideal line.
    order = ["pinocchio ABA, best build", "adagen P=1", "adagen P=2", "ideal P=2"]
    heights = [lines[name][0][1] for name in order]
    assert heights == sorted(heights)
    assert "Abacus 3000, 2 cores" in joints
    batched = points(held)
    assert len(batched["distributed, measured"]) == 2
    assert len(batched["each process its own, predicted"]) == 1
    assert "2 hosts" in held


def points(svg: str) -> dict[str, list[tuple[float, float]]]:
    """Return the points of the lines of a picture that have a name, by it."""
    found = {}
    for name, path in re.findall(
        r'<g id="((?:adagen|ideal|pin|each|distributed)[^"]*)">\s*<path d="([^"]*)"', svg
    ):
        pairs = re.findall(r"[ML] ([-\d.]+) ([-\d.]+)", path)
        found[name] = [(float(x), float(y)) for x, y in pairs]
    return found


@pytest.mark.slow
def test_small_chains_are_built_timed_and_right() -> None:
    """Real builds: two chains on one process and on two. Quick tests build by the command."""
    said: list[str] = []
    wanted = Wanted([(8, (1, 2)), (16, (2,))], Rules(rounds=1, repeat=1), peer=False)
    kept: list[int] = []
    found = measure_chains(wanted, said.append, lambda so_far: kept.append(len(so_far.joints)))
    assert found.joints == (8, 16) and found.processes == (1, 2) and kept == [1, 2]
    assert {(r.processes, r.source) for r in found.rows} >= {(1, "clock"), (2, "stretches")}
    for each in found.rows:
        assert each.residual < 1e-12
        assert 0 < each.least <= each.median
        assert each.predicted is not None and each.predicted > 0 and each.size > 1
        if each.processes == 1:  # by which it is scaled
            assert each.scaled == pytest.approx(each.least)
    assert any("building 2 of 2 (P=2)" in text for text in said)
    again = measure_chains(
        Wanted([(8, (1,))], Rules(rounds=1), peer=False), said.append, before=found
    )
    assert again.rows == found.rows  # what was measured is kept


def test_the_fastest_peer_stands_beside_and_long_chains_go_without(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def peers(_name: str, model: Model, _states: States, _folder: Path) -> list[Contestant]:
        def solve(states: States) -> Array:
            return np.array([forward_dynamics(model, *state) for state in states.each])

        return [
            Contestant(
                name=f"pinocchio {ns}",
                team="pinocchio",
                build="",
                processes=1,
                scalar="double",
                solve=solve,
                turn=lambda _repeat, ns=ns: {"in_place": Turn(1.1 * ns, ns)},  # type: ignore[misc]
            )
            for ns in (900.0, 800.0)
        ]

    monkeypatch.setattr(bench_peers, "missing", lambda _name: None)
    monkeypatch.setattr(bench_peers, "contestants", peers)
    monkeypatch.setattr(study, "MOST_OF_PEER", 8)
    wanted = Wanted([(8, (1,)), (16, (1,))], Rules(rounds=1, repeat=1))
    found = measure_chains(wanted, lambda _text: None)
    best = found.peer(8)
    assert best is not None and (best.name, best.least) == ("pinocchio 800.0", 800.0)
    assert best.residual < 1e-12 and best.predicted is None
    assert found.peer(16) is None
    assert "16^3" in found.absent["chain of 16, pinocchio"]


def test_batches_on_hosts_grow_until_handing_out_limits() -> None:
    fabric = shipped_fabric()
    costs = load_profile("default").steps
    assert costs is not None
    slow = predicted_batches(serial_chain(4), fabric, costs, 100.0)
    assert [(one.hosts, one.processes) for one in slow][-1] == (32, 1024)
    assert slow[-1].distributed > 2 * slow[0].distributed  # long states: hosts pay
    fast = predicted_batches(serial_chain(4), fabric, costs, 0.1)
    assert fast[-1].distributed < 2 * fast[0].distributed
    assert "process 0" in fast[-1].limit
    assert all(one.distributed <= one.in_place for one in (*slow, *fast))


def test_programs_from_the_cache_keep_what_they_took_to_compile(scale: Scale) -> None:
    earlier = replace(scale, rows=(row(100, 4, 1600.0, compiled=9.0),))
    assert row(100, 4, 1500.0).made_as(earlier) == row(100, 4, 1500.0, compiled=9.0)
    assert row(100, 4, 1500.0, compiled=0.04).made_as(earlier).compiled == 9.0  # looked up
    assert row(100, 4, 1500.0, compiled=8.0).made_as(earlier).compiled == 8.0
    assert row(100, 2, 1500.0).made_as(earlier).compiled == 0.0
    assert row(100, 4, 1500.0).made_as(None).compiled == 0.0
