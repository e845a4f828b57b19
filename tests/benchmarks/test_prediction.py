"""The tables of predicted beside measured times."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, replace
from pathlib import Path

import pytest

from adagen.calibrate.measure import Measurement
from adagen.calibrate.robots import chain, robot, squared
from adagen.cost import state_time
from adagen.emit import program_of
from adagen.emit.shapes import chosen_shape, predict
from adagen.plan import plan_to_json
from adagen.schedule import load_profile
from benchmarks.prediction import plans, programs_of
from benchmarks.prediction_report import report, spearman


def test_rank_correlation_shares_ranks_of_ties() -> None:
    assert spearman([1, 2, 3], [10, 20, 30]) == pytest.approx(1)
    assert spearman([1, 2, 3], [3, 2, 1]) == pytest.approx(-1)
    assert math.isnan(spearman([1, 1], [1, 2]))
    assert (
        spearman([1, 1, 2], [1, 2, 3]) == spearman([1, 1, 2], [2, 1, 3]) == pytest.approx(0.8660254)
    )


def test_every_distinct_plan_is_recorded_and_reported(tmp_path: Path) -> None:
    model = squared(robot("arm", chain(8), ["revolute"], 2))
    profile = load_profile("default")
    labelled = plans(model, profile)
    labels = [label for label, _ in labelled]
    assert len(labels) == len(set(labels)) and len({plan for _, plan in labelled}) == len(labels)
    assert sum("P=4" not in label for label in labels) >= 5  # P = 1 and 2
    rows = []
    for label, plan in labelled:
        shape = "unrolled" if label == "segment, P=1" else "kernels"
        time = predict(plan, profile, shape).makespan / 1.25
        measured = Measurement(time, time, (), "window", True)
        if "P=4" in label:
            measured = replace(measured, source="stretches")
        row = {"model": "arm", "label": label, "shape": shape, "plan": plan_to_json(plan)}
        rows.append({**row, "batch": False, "measured": asdict(measured)})
    alone = labelled[0][1]
    for wanted in programs_of(model, profile)[len(labelled) :]:
        assert wanted.batch and wanted.plan == alone
        shape = chosen_shape(alone, wanted.shape, batch=True, profile=profile)
        program = program_of(alone, shape, batch=True, profile=profile)
        measured = Measurement(state_time(program, profile) / 0.8, 0.1, (), "none", True)
        row = {"model": "arm", "label": wanted.label, "shape": shape, "plan": plan_to_json(alone)}
        rows.append({**row, "batch": True, "measured": asdict(measured)})
    file = tmp_path / "record.json"
    file.write_text(json.dumps(rows))
    text = report(file, "default", "a test")
    assert "Machine: a test. Profile: `default`. 1 robots" in text
    some = sum("P=4" not in label for label in labels)
    assert f"| P = 1 and 2 | {some} | 25.0% | 25.0% | 25.0% | 1.000 |" in text
    assert "| shape `unrolled` | 1 | 25.0% |" in text
    assert "| batches, of a state | 2 | 20.0% | 20.0% | 20.0% |" in text
    assert "| arm | segment, P=1 | unrolled | " in text and ", from stretches |" in text
