"""What pip installs, and the files that make the project one."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

import adagen

ROOT = Path(__file__).resolve().parents[1]
pytestmark = pytest.mark.skipif(
    not (ROOT / "pyproject.toml").is_file(), reason="not run from a checkout"
)


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(out)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    (built,) = out.glob("*.whl")
    return built


def tracked(pattern: str) -> list[str]:
    """Return the sources below the checkout that match, as paths relative to it."""
    found = (path.relative_to(ROOT).as_posix() for path in ROOT.glob(pattern) if path.is_file())
    return sorted(path for path in found if "__pycache__" not in path)


def test_the_wheel_has_every_stage_template_and_profile(wheel: Path) -> None:
    inside = set(zipfile.ZipFile(wheel).namelist())
    sources = tracked("adagen/**/*")
    templates = [f"adagen/{path}" for path in tracked("templates/**/*")]
    assert any(path.startswith("adagen/build/") for path in sources)
    assert any(path.endswith(".j2") for path in templates)
    assert any(path.endswith("profiles/default.toml") for path in sources)
    assert {*sources, *templates} <= inside
    others = {path for path in inside if ".dist-info/" not in path} - {*sources, *templates}
    assert others == set()


def test_the_wheel_knows_its_version_licence_and_command(wheel: Path) -> None:
    package = zipfile.ZipFile(wheel)
    name = f"adagen-{adagen.__version__}.dist-info"
    metadata = package.read(f"{name}/METADATA").decode()
    assert f"\nVersion: {adagen.__version__}\n" in metadata
    assert "\nLicense-Expression: MIT\n" in metadata
    assert f"{name}/licenses/LICENSE" in package.namelist()
    assert "adagen = adagen.cli:main" in package.read(f"{name}/entry_points.txt").decode()


def test_the_unpacked_wheel_finds_its_own_templates(wheel: Path, tmp_path: Path) -> None:
    zipfile.ZipFile(wheel).extractall(tmp_path)
    code = (
        "import adagen.emit.templates as t; from adagen.schedule import load_profile;"
        "print(t.templates_folder()); load_profile('paper')"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
    )
    assert done.returncode == 0, done.stderr
    assert Path(done.stdout.strip()) == tmp_path / "adagen" / "templates"


def test_emitted_code_belongs_to_its_user() -> None:
    text = " ".join((ROOT / "LICENSE").read_text().split())
    assert text.startswith("MIT License")
    assert "belongs to that user" in text


def test_the_linters_are_pinned() -> None:
    """A newer linter must not fail a commit that passed: see pyproject.toml."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    test = {re.split(r"[<>=]", line)[0]: line for line in project["optional-dependencies"]["test"]}
    for linter in ("ruff", "mypy", "clang-format"):
        assert "==" in test[linter]


@pytest.mark.skipif(shutil.which("make") is None, reason="make is not installed")
def test_make_lists_its_targets_by_default() -> None:
    done = subprocess.run(["make", "-C", str(ROOT)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    for target in ("setup", "demo", "test", "golden", "clean"):
        assert f"make {target} " in done.stdout
