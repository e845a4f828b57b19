"""The shipped profile that fits this machine."""

from __future__ import annotations

import platform
from pathlib import Path

import pytest

import adagen
from adagen.build import find_toolchain
from adagen.build.native_profile import native_profile
from adagen.cli import main
from adagen.schedule.profile import SHIPPED
from tests.cli.robots import Said

of_x86 = pytest.mark.skipif(
    platform.machine() not in {"x86_64", "AMD64"}, reason="options of x86-64"
)


@of_x86
def test_native_stands_for_the_profile_that_fits_what_is_built(
    arm: Path, tmp_path: Path, said: Said, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CXXFLAGS", "-march=x86-64-v3")
    solver = adagen.compile(adagen.read(arm), profile="native")
    assert solver.request.profile == "avx2"
    for name in ("native", "avx2"):
        assert main([str(arm), "--profile", name, "--out", str(tmp_path / name)]) == 0
        assert "this processor is more like" not in said()[1]
    first, second = ((tmp_path / name / "arm_p1.cpp") for name in ("native", "avx2"))
    assert "--profile=avx2" in first.read_text()  # so that it is made again anywhere
    assert first.read_bytes() == second.read_bytes()


@of_x86
def test_a_default_that_fits_less_is_told(
    arm: Path, tmp_path: Path, said: Said, monkeypatch: pytest.MonkeyPatch
) -> None:
    told = "this processor is more like that of profile avx2: --profile native takes it"
    words = [str(arm), "--out", str(tmp_path / "out")]
    monkeypatch.setenv("CXXFLAGS", "-march=x86-64-v3")
    assert main(words) == 0 and told in said()[1]
    assert main([*words, "--quiet"]) == 0 and told not in said()[1]
    monkeypatch.setenv("CXX", "/no/compiler")
    assert main(words) == 0 and told not in said()[1]
    assert main([*words, "--profile", "native"]) == 3
    assert "cannot run /no/compiler" in said()[1]


def test_predictions_are_by_the_profile_that_fits(arm: Path, said: Said) -> None:
    fitting = native_profile(find_toolchain())
    assert fitting in SHIPPED
    assert main(["schedule", str(arm), "--profile", "native"]) == 0
    assert f"({fitting} profile)" in said()[0]


def test_no_measured_profile_has_its_name(said: Said) -> None:
    assert main(["calibrate", "--name", "native"]) == 2
    assert "'native' names a shipped profile" in said()[1]
