"""Links in the documents lead somewhere, every picture is shown, and no command is left out."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from adagen.cli.main import VERBS
from tests.docs.blocks import PAGES, ROOT

PICTURES = ROOT / "docs" / "records" / "pictures"
QUOTED = r"<!-- quoted: (\S+) -->\n```cpp\n(.*?)```"
LINK = re.compile(r"\]\(([^)\s]+)\)")
FILE = re.compile(r"\b(?:adagen|templates|tests|benchmarks|generated_examples)/[\w/.*-]+\.\w+")


def anchors(page: Path) -> set[str]:
    """Return the anchors that GitHub makes of a page's headings."""
    titles = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), flags=re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_lead_somewhere(page: Path) -> None:
    for link in LINK.findall(page.read_text(encoding="utf-8")):
        if "://" in link:
            continue
        name, _, anchor = link.partition("#")
        target = (page.parent / name).resolve() if name else page
        assert target.exists(), link
        assert not anchor or anchor in anchors(target), link


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_files_that_are_named_are_there(page: Path) -> None:
    for name in FILE.findall(page.read_text(encoding="utf-8")):
        pattern = name.replace("SHAPE", "*")
        places = (ROOT, ROOT / "templates" / "include")
        assert any(any(place.glob(pattern)) for place in places), name


def test_quoted_code_is_what_is_emitted() -> None:
    quoted = 0
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for source, block in re.findall(QUOTED, text, flags=re.DOTALL):
            emitted = iter((ROOT / source).read_text(encoding="utf-8").splitlines())
            for line in block.splitlines():
                code = line.split("//")[0].rstrip()
                assert any(code == other.split("//")[0].rstrip() for other in emitted), line
            quoted += 1
    assert quoted


def test_every_picture_is_shown() -> None:
    shown = {link for page in PAGES for link in LINK.findall(page.read_text(encoding="utf-8"))}
    linked = {Path(link).name for link in shown if "pictures/" in link}
    assert {path.name for path in PICTURES.glob("*.svg")} == {
        name for name in linked if name.endswith(".svg")
    }


@pytest.mark.parametrize("picture", sorted(PICTURES.glob("*.svg")), ids=lambda path: path.stem)
def test_the_record_behind_a_picture_is_one_file(picture: Path) -> None:
    if picture.stem.startswith("bench_"):
        record = ROOT / "benchmarks" / "bench.json"
    else:
        record = picture.with_suffix(".json")
    assert json.loads(record.read_text(encoding="utf-8"))


@pytest.mark.parametrize("record", sorted(PICTURES.glob("*.json")), ids=lambda path: path.stem)
def test_no_record_is_left_of_a_picture_that_is_gone(record: Path) -> None:
    assert record.with_suffix(".svg").is_file()


def test_the_site_has_every_page_once() -> None:
    text = (ROOT / "mkdocs.yml").read_text(encoding="utf-8")
    listed = re.findall(r"^ *- (?:[^:]*: )?(\S+\.md)$", text, flags=re.MULTILINE)
    assert sorted(listed) == sorted(str(page.relative_to(ROOT / "docs")) for page in PAGES[1:])


def test_the_reference_has_the_help_of_every_command() -> None:
    page = (ROOT / "docs" / "reference" / "command_line.md").read_text(encoding="utf-8")
    assert re.findall("^<!-- help: (.*) -->$", page, flags=re.MULTILINE) == [
        "MODEL",
        *(verb for verb in re.findall(r"^## adagen ([a-z]+)$", page, flags=re.MULTILINE)),
    ]
    for verb in VERBS:
        assert f"## adagen {verb}\n\n<!-- help: {verb} -->" in page, verb


def test_the_example_of_a_simulation_runs(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    picture = tmp_path / "picture.png"
    done = subprocess.run(
        [sys.executable, str(ROOT / "docs" / "how_to" / "example_simulation.py"), str(picture)],
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert (done.returncode, done.stderr) == (0, "")
    found = re.findall(r"(?:at most|comes to rest|by|to) (\d\.\d+) rad", done.stdout)
    off, astray, *_ = map(float, found)
    assert off < 0.005  # of a motion of a radian, in steps of a millisecond
    assert 0.1 < astray < 2
    assert picture.read_bytes().startswith(b"\x89PNG")
