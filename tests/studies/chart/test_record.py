"""Charts as data and as pictures."""

from __future__ import annotations

import builtins
import json
from dataclasses import fields, replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import jsonschema
import numpy as np
import pytest

from adagen.cli import main
from adagen.cli.console import speaking
from adagen.errors import EnvironmentFault, InputError
from adagen.studies.chart import Chart, Point, read_chart
from adagen.studies.chart.draw import pyplot, save, work_precision
from adagen.studies.chart.motion import MotionChart, MotionPoint
from adagen.studies.chart.record import marked
from adagen.studies.chart.variants import METHODS
from adagen.studies.records import write_record

OPTIONAL = {"type": ["number", "null"], "minimum": 0}
SCHEMA = {
    "type": "object",
    "required": ["model", "dof", "states", "digits", "rounds", "machine", "points"],
    "additionalProperties": False,
    "properties": {
        "model": {"type": "string"},
        "machine": {"type": "string"},
        "dof": {"type": "integer"},
        "states": {"type": "integer", "minimum": 1},
        "digits": {"type": "integer"},
        "rounds": {"type": "integer"},
        "mechanism": {"type": "string"},
        "points": {
            "type": "array",
            "items": {
                "type": "object",
                "required": [field.name for field in fields(Point)],
                "additionalProperties": False,
                "properties": {
                    **{n: {"type": "string"} for n in ("label", "team", "algorithm", "shape")},
                    "schedule": {"enum": ["auto", "balanced", "sequential", "random"]},
                    "scalar": {"enum": ["double", "float"]},
                    "processes": {"type": "integer", "minimum": 1},
                    "refine": {"type": "integer", "minimum": 0},
                    **dict.fromkeys(("time_ns", "ratio", "error", "residual"), OPTIONAL),
                    "predicted": OPTIONAL,
                    "batch": {"type": "boolean"},
                    "reproducible": {"type": "boolean"},
                    "lanes": {"type": "boolean"},
                    "certify": {"type": "boolean"},
                    "objective": {"enum": ["both", "time", "accuracy"]},
                    "method": {"enum": ["", *METHODS]},
                    "source": {"enum": ["clock", "stretches", None]},
                    "why": {"type": ["string", "null"]},
                    "front": {"type": "boolean"},
                },
            },
        },
    },
}


def some_chart() -> Chart:
    segment = Point("default", "adagen", "segment", "auto", "double", 1, 0, "auto", method="loops")
    points = (
        replace(segment, time_ns=900.0, ratio=1.0, error=3e-16, residual=5e-16),
        replace(segment, label="float", scalar="float", time_ns=700.0, ratio=0.8, error=2e-7,
                residual=1e-7),
        replace(segment, label="ada", algorithm="ada", method="joints", time_ns=4e3, ratio=4.4,
                error=1e-14, residual=1e-15, predicted=3e-14),
        replace(segment, label="ada refined", algorithm="ada", method="joints", refine=1,
                time_ns=6e3, ratio=6.6, error=2e-16, residual=1e-15),
        replace(segment, label="four", processes=4, time_ns=500.0, ratio=0.6, source="stretches",
                error=2e-16, residual=1e-15),
        replace(segment, label="certified", certify=True, time_ns=1200.0, ratio=1.3, error=4e-16,
                residual=5e-16),
        replace(segment, label="gone", processes=2, error=4e-16, residual=1e-15, why="no answer"),
        replace(segment, label="broken", algorithm="ada", why='joint "a": no inverse'),
    )  # fmt: skip
    return Chart("robot", 7, 20, 100, 5, "a machine", marked(points))


class TestData:
    def test_json_is_read_back_and_keeps_its_schema(self, tmp_path: Path) -> None:
        chart = some_chart()
        write_record(chart, tmp_path / "c.json")
        assert read_chart(tmp_path / "c.json") == chart
        jsonschema.validate(json.loads((tmp_path / "c.json").read_text()), SCHEMA)

    def test_the_front_is_marked(self) -> None:
        on = [p.label for p in some_chart().points if p.front]
        assert on == ["default", "float", "ada refined"]

    def test_what_adagen_does_not_emit_is_not_on_the_front(self) -> None:
        chart = some_chart()
        best = replace(chart.points[0], label="peer", team="peer", time_ns=1.0, error=1e-20)
        on = marked([*chart.points, best])
        assert [p.label for p in on if p.front] == ["default", "float", "ada refined"]

    @pytest.mark.parametrize("text", ["", "[]", '{"points": 3}', '{"points": [{"x": 1}]}'])
    def test_what_is_no_chart_is_refused(self, text: str, tmp_path: Path) -> None:
        (tmp_path / "c.json").write_text(text)
        with pytest.raises(InputError, match="not a chart"):
            read_chart(tmp_path / "c.json")


class TestPictures:
    @pytest.fixture(autouse=True)
    def _drawing(self) -> None:
        pytest.importorskip("matplotlib")

    def check(self, paths: list[Path]) -> str:
        """The PNG shows something; return the text of the SVG."""
        svg, png = paths
        image: Any = pyplot().imread(png)
        assert image.shape[0] > 400 and image.shape[1] > 800
        assert 0.02 < float((image[..., :3] < 0.9).any(axis=-1).mean()) < 0.6
        colours = np.rint(image[..., :3] * 255) @ (1, 256, 65536)
        assert len(np.unique(colours)) > 20
        ET.parse(svg)
        return svg.read_text()

    def test_a_chart_becomes_a_picture_with_all_its_marks(self, tmp_path: Path) -> None:
        text = self.check(save(work_precision(some_chart()), tmp_path / "c"))
        for words in (
            "Front of what adagen emits", "ringed: time from measured stretches",
            "default: 900 ns, 1.00x", "No answer:", "Not timed:", "loops",
            "joint by joint (the paper's form)", "rounding of",
            "refined once", "-- certified"
        ):  # fmt: skip
            assert f"<!-- {words}" in text or words in text

    def test_no_label_covers_another(self) -> None:
        """Points that lie close together, and on each other."""
        (first, *_) = some_chart().points
        front = [
            replace(first, label=f"v{k}", time_ns=time, error=error, front=True)
            for k, (time, error) in enumerate(
                [(200, 1e-6), (1400, 3.2e-15), (1401, 3.1e-15), (1450, 3e-15), (9000, 1e-16)]
                + [(9000 * 1.02**k, 10 ** (-16.1 - k / 50)) for k in range(8)]
            )
        ]
        from matplotlib.text import Text

        figure = work_precision(replace(some_chart(), points=tuple(front)))
        figure.canvas.draw()
        renderer = figure.canvas.get_renderer()
        panel = figure.axes[0]
        boxes = [Text.get_window_extent(text, renderer) for text in panel.texts]
        assert len(boxes) >= 13
        for k, box in enumerate(boxes):
            assert not any(box.overlaps(other) for other in boxes[:k])
        dots = [panel.transData.transform((p.time_ns, max(p.error or 0.0, 1e-17))) for p in front]
        numbers = [
            box for box, text in zip(boxes, panel.texts, strict=True) if text.get_text().isdecimal()
        ]
        assert not any(box.contains(*dot) for box in numbers for dot in dots)
        words = [text.get_text() for axes in figure.axes for text in axes.texts]
        (listed,) = [text for text in words if text.startswith("Front of")]
        assert "v8" in listed

    def test_axes_go_as_far_as_the_data(self) -> None:
        chart = some_chart()
        panel = work_precision(chart).axes[0]
        shown = [p for p in chart.points if p.error and p.time_ns]
        assert panel.get_xlim()[1] == pytest.approx(1.25 * max(p.time_ns or 0 for p in shown))
        assert panel.get_ylim()[0] == pytest.approx(min(p.error or 1 for p in shown) / 8)

    def test_a_record_is_drawn_anew(
        self, tmp_path: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        write_record(some_chart(), tmp_path / "chart_x.json")
        assert main(["chart", str(tmp_path / "chart_x.json"), "--out", str(tmp_path / "new")]) == 0
        assert {p.name for p in (tmp_path / "new").iterdir()} == {"chart_x.svg", "chart_x.png"}
        assert "default" in capsys.readouterr().out

    def test_a_chart_of_failures_alone_is_a_picture_too(self, tmp_path: Path) -> None:
        chart = some_chart()
        save(work_precision(replace(chart, points=chart.points[-1:])), tmp_path / "c")

    def test_a_motion_chart_becomes_a_picture(self, tmp_path: Path) -> None:
        from adagen.studies.chart.draw_motion import motion_picture

        points = tuple(
            MotionPoint(name, h, 1e-3 / h, c * h**order, c * h**order, c * h**order)
            for name, order, c in (("euler", 1, 1.0), ("rk4", 4, 1.0))
            for h in (4e-2, 2e-2, 1e-2)
        )
        chart = MotionChart("robot", 1.0, 1e-4, 1e-15, points)
        assert chart.order("rk4", "error") == pytest.approx(4)
        assert chart.order("euler", "energy") == pytest.approx(1)
        assert chart.order("rkmk4", "error") is None
        self.check(save(motion_picture(chart), tmp_path / "m"))
        damped = replace(
            chart, points=tuple(replace(p, energy=None, momentum=None) for p in points)
        )
        (panel,) = motion_picture(damped).axes
        assert "wall time" in panel.get_xlabel()


def test_progress_is_told_now_and_then_where_there_is_no_terminal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    now = 0.0
    monkeypatch.setattr("adagen.cli.console.time.monotonic", lambda: now)
    with speaking("arm") as said:
        for k in range(1, 31):
            said(f"compiling {k} of 30")
            now += 1.0
        said("round 1 of 5")
    assert capsys.readouterr().err.splitlines() == [
        f"arm: {words} ..."
        for words in (
            "compiling 1 of 30",
            "compiling 12 of 30 (about 19 s left)",
            "compiling 23 of 30 (about 8 s left)",
            "round 1 of 5",
        )
    ]


def test_without_matplotlib_it_is_said_what_to_install(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    real = builtins.__import__

    def refuse(name: str, *rest: Any, **more: Any) -> Any:
        if name.startswith("matplotlib"):
            raise ImportError(name)
        return real(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", refuse)
    with pytest.raises(EnvironmentFault, match=r"pip install 'adagen\[chart\]'"):
        pyplot()
    assert main(["chart", "none.urdf"]) == 3
    assert "--no-picture" in capsys.readouterr().err
