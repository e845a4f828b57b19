"""The page in a real browser: no errors, all by the keyboard, dark and light, on paper.

Needs Chromium (Debian: chromium), which pip does not install.
"""

from __future__ import annotations

import math
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.library import compile, read  # noqa: A004
from adagen.model import Model, Pose
from adagen.model.placement import placed
from adagen.report import Accuracy, Measured, Scene, document, page
from tests.report.robots import chart, compiled, every_kind

playwright = pytest.importorskip(
    "playwright.sync_api", reason="playwright is not installed: pip install 'adagen[test]'"
)
MODELS = Path(__file__).resolve().parents[2] / "generated_examples" / "models"
NAMES = ("chromium", "chromium-browser", "google-chrome")
PATH = next(filter(None, map(shutil.which, NAMES)), None)
if PATH is None:
    pytest.skip(f"no browser is installed ({', '.join(NAMES)})", allow_module_level=True)


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with playwright.sync_playwright() as play:
        found = play.chromium.launch(executable_path=PATH, args=["--no-sandbox"])
        yield found
        found.close()


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Model]:
    folder = tmp_path_factory.mktemp("report")
    made = compiled(folder, every_kind(), procs=1)
    run = Measured(0.5, 0.4, "clock", 1e-15, 14.5, True, made.timeline)
    scene = Scene("s.toml", ("two joints locked",))
    commands = dict.fromkeys(
        ("page", "robot", "program", "measured", "accuracy", "scene", "chart"), "adagen x"
    )
    told = document(
        made,
        commands,
        measured=run,
        accuracy=Accuracy((1e-15, 0.0, 3e-15), (4e-15, None, 5e-15), 2e-15, 25),
        scene=scene,
        chart=chart("robot"),
        remarks=["<b>odd</b>"],
    )
    path = folder / "report.html"
    path.write_text(page(told), encoding="utf-8")
    return path, made.model


def opened(browser: Any, path: Path, **options: Any) -> tuple[Any, list[str]]:
    """A tab with the page, and all that it complains of or asks the network for."""
    tab = browser.new_page(**options)
    said: list[str] = []

    def refused(dialog: Any) -> None:
        said.append(dialog.message)
        dialog.dismiss()

    tab.on("console", lambda message: said.append(message.text))
    tab.on("pageerror", lambda error: said.append(str(error)))
    tab.on("dialog", refused)
    tab.on("request", lambda asked: said.append(asked.url) if asked.url != path.as_uri() else None)
    tab.goto(path.as_uri())
    return tab, said


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [1200, 390])
def test_it_is_shown_without_a_complaint(
    scheme: str, width: int, browser: Any, report: tuple[Path, Model]
) -> None:
    tab, said = opened(
        browser, report[0], color_scheme=scheme, viewport={"width": width, "height": 800}
    )
    for part in ("robot", "program", "figures", "accuracy", "chart", "scene", "remarks"):
        assert tab.locator(f"#{part}").is_visible()
    assert tab.locator("#skeleton circle").count() == len(report[1].joints)
    assert tab.locator("#tree li").count() == len(report[1].joints)
    assert tab.locator("#tree li strong").all_text_contents() == [
        joint.name for joint in report[1].joints
    ]
    assert tab.locator("#timelines figure").count() == 2
    assert tab.locator("#chart-d circle").count() == 6 + 2  # and two in the legend
    assert tab.locator("#accuracy-d circle.error").count() == 3 + 1
    assert tab.locator("#accuracy-d line.bound").count() == 2 + 1
    assert "no error exceeds its bound" in tab.locator("#accuracy-d p").inner_text()
    assert tab.locator("#remarks-l li").inner_text() == "<b>odd</b>"
    assert tab.evaluate("document.documentElement.scrollWidth <= innerWidth")
    ink, paper = tab.evaluate(
        "(s => [s.color, s.backgroundColor])(getComputedStyle(document.body))"
    )
    assert contrast(ink, paper) >= 7.0
    assert (luminance(paper) > 0.5) == (scheme == "light")
    muted = tab.evaluate("getComputedStyle(document.querySelector('figcaption')).color")
    assert contrast(muted, paper) >= 4.5
    assert said == []
    tab.close()


def overlapping(tab: Any, chosen: str) -> list[list[str]]:
    """Pairs of texts of one picture that lie on each other, by more than a hair."""
    found = tab.evaluate(OVERLAPPING, chosen)
    assert isinstance(found, list)
    return found


OVERLAPPING = """(chosen) => [...document.querySelectorAll(chosen)].flatMap((svg) => {
  const texts = [...svg.querySelectorAll("text")].filter((t) => t.textContent);
  const boxes = texts.map((t) => t.getBoundingClientRect());
  return texts.flatMap((one, i) => texts.slice(i + 1).flatMap((other, k) => {
    const a = boxes[i], b = boxes[i + 1 + k];
    const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
    const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
    return across > 1 && down > 3 ? [[one.textContent, other.textContent]] : [];
  }));
})"""
"""Boxes of texts have some room above and below their letters."""

REACHED = 'a, input, button, summary, main [tabindex="0"]'


@pytest.mark.parametrize("width", [1200, 390])
def test_no_label_lies_on_another(width: int, browser: Any, report: tuple[Path, Model]) -> None:
    tab, said = opened(browser, report[0], viewport={"width": width, "height": 800})
    assert overlapping(tab, "figure svg, .wide svg") == []
    assert tab.locator("#chart-d text.label").count() == 3  # of the front
    for text in tab.locator(".wide svg text").all()[:20]:
        assert text.bounding_box()["height"] >= 8.0  # to be read on a telephone, too
    assert said == []
    tab.close()


def luminance(colour: str) -> float:
    parts = [int(x) / 255 for x in re.findall(r"\d+", colour)[:3]]
    linear = [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in parts]
    return float(np.dot(linear, [0.2126, 0.7152, 0.0722]))


def contrast(one: str, other: str) -> float:
    low, high = sorted(map(luminance, (one, other)))
    return (high + 0.05) / (low + 0.05)


def test_everything_is_reached_by_the_keyboard(browser: Any, report: tuple[Path, Model]) -> None:
    tab, said = opened(browser, report[0])
    wanted = tab.evaluate(f"document.querySelectorAll('{REACHED}').length")
    seen = set()
    for _ in range(wanted):
        tab.keyboard.press("Tab")
        seen.add(
            tab.evaluate(
                f"[...document.querySelectorAll('{REACHED}')].indexOf(document.activeElement)"
            )
        )
        outline = tab.evaluate("getComputedStyle(document.activeElement).outlineStyle")
        assert outline != "none"
    assert seen - {-1} == set(range(wanted))
    unnamed = "[...document.querySelectorAll('input')].filter(i => !i.labels.length).length"
    assert tab.evaluate(unnamed) == 0
    assert said == []
    tab.close()


def test_a_slider_moves_the_robot_and_a_button_brings_it_back(
    browser: Any, report: tuple[Path, Model]
) -> None:
    tab, said = opened(browser, report[0])
    drawn = "document.getElementById('skeleton').innerHTML"
    before = tab.evaluate(drawn)
    slider = tab.locator("#joint-0-0")
    slider.focus()
    for _ in range(20):
        tab.keyboard.press("ArrowRight")
    assert tab.locator("output[for=joint-0-0]").inner_text() == "0.31 rad"
    assert tab.evaluate(drawn) != before
    tab.locator("#home").press("Enter")
    assert tab.evaluate(drawn) == before
    box = tab.locator("#skeleton").bounding_box()
    tab.mouse.move(box["x"] + 50, box["y"] + 50)
    tab.mouse.down()
    tab.mouse.move(box["x"] + 120, box["y"] + 80)
    tab.mouse.up()
    assert tab.evaluate(drawn) != before
    assert said == []
    tab.close()


def test_the_chart_zooms_shows_a_budget_s_pick_and_what_is_pointed_at(
    browser: Any, report: tuple[Path, Model]
) -> None:
    tab, said = opened(browser, report[0])
    box = tab.locator("#chart-d")
    assert box.locator("path.front").count() == 1
    labels = box.locator("svg text").all_inner_texts()
    box.get_by_role("button", name="Zoom in").press("Enter")
    assert box.locator("svg text").all_inner_texts() != labels
    box.get_by_role("button", name="Whole chart").press("Enter")
    assert box.locator("svg text").all_inner_texts() == labels
    for end, found in (("Home", "Nothing keeps this budget."), ("End", "No budget.")):
        for name in ("budget-error", "budget-time"):
            box.locator(f"#{name}").press(end)
        assert box.locator("#budget").inner_text() == found
    box.locator("#budget-error").press("ArrowLeft")
    points = tab.evaluate("data.chart.points.filter((p) => p.emitted)")
    fastest = min((p["time"], p["label"]) for p in points)[1]
    assert f"(ringed) {fastest}:" in box.locator("#budget").inner_text()
    assert box.locator("svg ellipse").count() == 1
    box.locator("svg circle").first.hover(force=True)
    assert "µs, error" in box.locator("p[aria-live]").first.inner_text()
    assert said == []
    tab.close()


def test_links_are_where_the_model_has_them(browser: Any, report: tuple[Path, Model]) -> None:
    path, model = report
    tab, said = opened(browser, path)
    rng = np.random.default_rng(3)
    sizes = tab.evaluate("data.robot.joints.map((joint) => SLIDERS[joint.kind].length)")
    pose = [rng.uniform(-1, 1, size).tolist() for size in sizes]
    found = tab.evaluate("(pose) => placed(data.robot, pose)", pose)
    at = [Pose.home()]
    for j, joint in enumerate(model.joints):
        q = pose[j]
        if joint.mimic is not None:
            q = [joint.mimic.multiplier * pose[joint.mimic.source][0] + joint.mimic.offset]
        elif joint.kind.quaternion is not None:
            q = [*q[:-3], *quaternion(q[-3:])]
        moved = placed(joint, q)
        at.append(at[joint.parent].then(moved.rotation, moved.translation))
    for pose_of_link, link in zip(at, found, strict=True):
        expected = pose_of_link.frame("")
        assert np.abs(np.array(link["rotation"]) - expected.rotation).max() < 1e-12
        assert np.abs(np.array(link["origin"]) - expected.translation).max() < 1e-12
    assert said == []
    tab.close()


def quaternion(vector: list[float]) -> list[float]:
    angle = math.hypot(*vector)
    return [*(x / angle * math.sin(angle / 2) for x in vector), math.cos(angle / 2)]


def test_loops_are_drawn_and_close_again(browser: Any, tmp_path: Path) -> None:
    scene = MODELS / "fourbar.toml"
    made = compile(read(MODELS / "fourbar.urdf", scene=scene), procs=1)
    path = tmp_path / "fourbar.html"
    path.write_text(page(document(made, {"run": "adagen x --run"})), encoding="utf-8")
    tab, said = opened(browser, path)
    assert tab.locator("#skeleton circle.ring").count() == 1
    closed = tab.locator("#loops").inner_text()
    assert "they are closed" in closed
    tab.locator("#joints input").first.press("End")
    assert "open by up to" in tab.locator("#loops").inner_text()
    tab.get_by_role("button", name="Close all loops").press("Enter")
    assert tab.locator("#loops").inner_text() == closed
    assert "adagen x --run" in tab.locator("#accuracy-d").inner_text()  # what is missing, and how
    assert said == []
    tab.close()


@pytest.mark.slow
def test_it_is_printed_on_a4(browser: Any, report: tuple[Path, Model]) -> None:
    tab, said = opened(browser, report[0], color_scheme="dark")
    paper = tab.pdf(prefer_css_page_size=True)
    boxes = re.findall(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", paper)
    assert 1 <= len(boxes) <= 4
    for width, height in boxes:
        assert (round(float(width)), round(float(height))) == (595, 842)
    tab.emulate_media(media="print")
    assert not tab.locator("#pose").is_visible() and not tab.locator("nav").is_visible()
    assert tab.locator("#skeleton").is_visible()
    background = tab.evaluate("getComputedStyle(document.body).backgroundColor")
    assert background == "rgb(255, 255, 255)"
    assert said == []
    tab.close()
