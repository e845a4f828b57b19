"""The documents as a site: built without a warning, read and searched without a network."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.docs.blocks import PAGES, ROOT

for module in ("mkdocs", "material", "mkdocstrings_handlers.python"):
    pytest.importorskip(module, reason="the site's generator: pip install 'adagen[docs]'")

FETCHED = re.compile(r"<(?:script|img|iframe|link)\b[^>]*?\b(?:src|href)=\W?(https?:[^\"\s>]*)")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    done = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", str(folder)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        env={**os.environ, "NO_MKDOCS_2_WARNING": "1", "PYTHONPATH": str(ROOT)},
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    return folder


def test_every_page_is_there_and_fetches_nothing(site: Path) -> None:
    for page in PAGES[1:]:
        path = (site / page.relative_to(ROOT / "docs")).with_suffix(".html")
        assert FETCHED.findall(path.read_text(encoding="utf-8")) == [], path
    assert FETCHED.findall((site / "404.html").read_text(encoding="utf-8")) == []


def test_the_search_knows_all_pages(site: Path) -> None:
    index = json.loads((site / "search" / "search_index.json").read_text(encoding="utf-8"))
    found = {entry["location"].partition("#")[0] for entry in index["docs"]}
    assert len(found) == len(PAGES) - 1
    assert any("articulated-body" in entry["text"] for entry in index["docs"])
    assert (site / "assets" / "file_worker.js").is_file()


def test_references_are_generated(site: Path) -> None:
    page = (site / "reference" / "command_line.html").read_text(encoding="utf-8")
    assert "usage: adagen verify" in page
    assert "--reproducible" in page
    page = (site / "reference" / "emitted_program.html").read_text(encoding="utf-8")
    assert "--integrator NAME" in page
    page = (site / "reference" / "c_interface.html").read_text(encoding="utf-8")
    assert "arm7_p1_open" in page
    page = (site / "reference" / "python.html").read_text(encoding="utf-8")
    assert "set_center" in page
    assert "InputError" in page


def test_search_works_from_a_disk_without_a_network(site: Path) -> None:
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="playwright is not installed: pip install 'adagen[test]'"
    )
    browser = next(filter(None, map(shutil.which, ("chromium", "chromium-browser"))), None)
    if browser is None:
        pytest.skip("no browser is installed (chromium)")
    with playwright.sync_playwright() as play:
        opened = play.chromium.launch(executable_path=browser, args=["--no-sandbox"])
        page = opened.new_context(offline=True).new_page()
        errors: list[str] = []
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.goto((site / "reference" / "files.html").as_uri())
        page.locator("input.md-search__input").focus()
        page.keyboard.type("links without mass")
        first = page.locator(".md-search-result__item a").first
        first.wait_for(state="attached", timeout=60_000)
        assert "massless_links.html" in str(first.get_attribute("href"))
        assert errors == []
        opened.close()
