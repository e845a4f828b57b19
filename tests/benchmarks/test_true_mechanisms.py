"""Mechanisms with true answers: right ones pass, wrong ones and missing refusals do not."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from benchmarks.true_mechanisms import examined, good


@pytest.mark.parametrize(
    ("answer", "found", "right"),
    [
        ("qdd", [1e-12, 1e-12, 1e-12], True),
        ("qdd", [1e-12, 1e-12, "no inertia"], True),
        ("qdd", [1e-12, "refused", 1e-12], False),
        ("qdd", [1e-12, 1e-12, 1e-8], False),
        ("qdd", [1e-12, float("nan"), 1e-12], False),
        ("refuse", ["open"] * 3, True),
        ("refuse", ["open", 1e-12, "open"], False),
        ("refuse or this", ["singular", 1e-12, 1e-12], True),
    ],
)
def test_what_is_good(answer: str, found: list[float | str], right: bool) -> None:
    assert good({"answer": answer, "errors": found, "limit": 1e-9}) == right


@pytest.mark.parametrize("name", ["fourbar", "inconsistent_velocity"])
def test_mechanisms_are_examined(shared: Path, name: str) -> None:
    folder = shared / "loops"
    told = json.loads((folder / f"{name}.json").read_text())["modes"]["fixed"]
    row = examined(folder, name, "fixed", told)
    assert good(row)
    assert all(isinstance(x, str) == (name != "fourbar") for x in row["errors"])
    wrong = {**row, "answer": "refuse" if name == "fourbar" else "qdd"}
    assert not good(wrong)
