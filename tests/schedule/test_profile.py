"""Cost profiles: the shipped ones, and what a wrong file is told."""

from __future__ import annotations

from pathlib import Path

import pytest

from adagen.errors import InputError, UsageError
from adagen.schedule import Topology, load_profile
from adagen.schedule.profile import parse_profile, profile_text, shipped_for
from adagen.search import find_schedule

GOOD = 'name = "mine"\n[join]\nalpha = 1\nbeta = 0.5\ngamma = -0.1\ndelta = 2.0\n'


def test_shipped_profiles() -> None:
    paper = load_profile("paper")
    assert (paper.alpha, paper.beta, paper.gamma, paper.delta) == (1.6, 1.0, -1.0, 14.4)
    assert [paper.join(k, 1) for k in range(3)] == [13_400_000, 16_000_000, 21_800_000]
    for name in ("default", "xeon", "zen4", "avx2"):
        found = load_profile(name)
        assert found.name == name and found.steps is not None


@pytest.mark.parametrize(
    ("processor", "wide"),
    [
        (("GenuineIntel", 6), "xeon"),
        (("AuthenticAMD", 25), "zen4"),
        (("AuthenticAMD", 26), "default"),
        (("CentaurHauls", 7), "default"),
        (None, "default"),
    ],
)
def test_a_processor_has_the_profile_of_one_like_it(
    processor: tuple[str, int] | None, wide: str
) -> None:
    assert shipped_for(64, processor) == wide
    assert shipped_for(32, processor) == shipped_for(16, processor) == "avx2"


def test_a_profile_may_say_nothing_of_batches() -> None:
    """Those that were measured before batches were priced do not."""
    text, file = profile_text("default")
    start, end = text.index("[steps.batch]"), text.index("[steps.link]")
    found = parse_profile(text[:start] + text[end:], file)
    assert found == load_profile("default")  # what is assumed are its prices
    with pytest.raises(InputError, match="operations"):  # but not a part of it
        parse_profile(text.replace("[steps.batch]", "[steps.batch]\noperations = 1"), file)


def test_a_file_is_read(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text(GOOD, encoding="utf-8")
    assert find_schedule(Topology.serial(4), 2, profile=load_profile(str(file))).profile == "mine"


@pytest.mark.parametrize(
    ("old", "new", "line", "message"),
    [
        ("alpha = 1", "alpha = ", 3, "not TOML"),
        ("alpha = 1", "alpha = '1'", 3, "join.alpha must be a number"),
        ("alpha = 1", "alpha = true", 3, "join.alpha must be a number"),
        ("alpha = 1", "alpha = nan", 3, "alpha must be a finite"),
        ("alpha = 1", "alpha = 1e9", 3, "alpha must be a finite"),
        ("alpha = 1", "alpha = -1", 3, "alpha must not be negative"),
        ("alpha = 1", "alpha = 1" + "0" * 400, 3, "alpha is too large"),
        ("beta = 0.5", "", None, "join.beta is missing"),
        ("beta = 0.5", "beta = 0.5\nepsilon = 1", 5, "unknown key 'join.epsilon'"),
        ("gamma = -0.1", "gamma = -1.0", 6, "delta + 6 gamma must be positive"),
        ('name = "mine"', 'name = "a\\nb"', 1, "give the profile a name"),
        ('name = "mine"', "", None, "give the profile a name"),
        ('name = "mine"', 'name = "mine"\nlatency = 1', 2, "unknown key 'latency'"),
        ("[join]", "[joint]", 2, "unknown key 'joint'"),
    ],
)
def test_a_wrong_file_is_refused(
    tmp_path: Path, old: str, new: str, line: int | None, message: str
) -> None:
    file = tmp_path / "mine.toml"
    file.write_text(GOOD.replace(old, new), encoding="utf-8")
    with pytest.raises(InputError) as caught:
        load_profile(str(file))
    assert message in caught.value.message
    assert (caught.value.file, caught.value.line) == (str(file), line)


def test_a_missing_or_unreadable_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="default, xeon, zen4, avx2, paper"):
        load_profile(str(tmp_path / "none.toml"))
    for name in (str(tmp_path), "nul\0byte"):
        with pytest.raises(InputError):
            load_profile(name)
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe")
    with pytest.raises(InputError, match="UTF-8"):
        load_profile(str(tmp_path / "binary.toml"))
