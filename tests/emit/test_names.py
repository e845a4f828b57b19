"""The sanitiser and the escaper for names: whatever goes in, what comes out is harmless."""

from __future__ import annotations

import re

from hypothesis import example, given
from hypothesis import strategies as st

from adagen.emit.names import LONGEST, file_stem, identifiers, prefix_of, quoted

TEXTS = st.text(max_size=80) | st.text("a_-.A1*/\\\"'?\n", max_size=12)


@given(st.lists(TEXTS, max_size=12))
@example(["a", "a", "a_2", "a_2", "a 2"])
@example(["a", "A", "a_", "_a", "a__", "ä", "", " ", "__base__", "base"])
@example(["x" * 1000, "x" * 1000, "x" * 1001])
def test_identifiers_are_legal_and_distinct(names: list[str]) -> None:
    words = identifiers(names)
    assert len(set(words)) == len(words) == len(names)
    for word in words:
        assert re.fullmatch(r"[A-Za-z0-9]+(_[A-Za-z0-9]+)*", word)
        assert len(word) <= LONGEST + 1 + len(str(len(names)))
    assert identifiers(names) == words


def test_identifiers_keep_what_can_be_kept() -> None:
    assert identifiers(["left_knee", "Hüfte links", "joint-1", "joint.1"]) == (
        "left_knee",
        "H_fte_links",
        "joint_1",
        "joint_1_2",
    )


def read_literal(literal: str) -> bytes:
    """Read a C++ string literal as a compiler does."""
    assert literal[0] == literal[-1] == '"'
    result, at, body = bytearray(), 0, literal[1:-1]
    while at < len(body):
        if body[at] != "\\":
            assert body[at] != '"'
            result.append(ord(body[at]))
            at += 1
        elif octal := re.match(r"[0-7]{1,3}", body[at + 1 :]):
            result.append(int(octal.group(), 8))
            at += 1 + octal.end()
        else:
            assert body[at + 1] in '"\\?'
            result.append(ord(body[at + 1]))
            at += 2
    return bytes(result)


@given(TEXTS)
@example('"; system("true"); //')
@example("ends in \\")
@example("??/")
@example("*/ #include <x>\n")
@example("é7\x007")
def test_a_quoted_name_is_one_literal_in_ascii_that_reads_back(name: str) -> None:
    literal = quoted(name)
    assert literal.isascii() and literal.isprintable()
    assert "??" not in literal
    assert read_literal(literal) == name.encode("utf-8", errors="replace")


def test_a_lone_surrogate_is_replaced() -> None:
    assert quoted("a\ud800b") == '"a\\?b"'


@given(TEXTS)
@example("../../etc/passwd")
@example(".hidden")
@example("-rf")
@example("a__b")
@example("1st")
@example("a" * 38 + "-_-" + "b" * 40)
def test_file_stems_and_prefixes_are_harmless(name: str) -> None:
    stem = file_stem(name)
    assert re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_-]*", stem) and len(stem) <= LONGEST
    assert re.fullmatch(r"[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*", prefix_of(f"{stem}_p2"))


@given(st.text("ab_", min_size=1, max_size=8), st.text("ab_", min_size=1, max_size=8))
@example("left", "right")
def test_long_names_with_one_beginning_have_files_of_their_own(one: str, other: str) -> None:
    beginning = "robot_of_a_long_name_" * 4
    stems = {file_stem(beginning + one), file_stem(beginning + other)}
    assert len(stems) == len({one, other})
    assert all(stem.startswith("robot_of_a_long_name_") for stem in stems)


def test_a_name_within_the_limit_stays_as_it_is() -> None:
    assert file_stem("a" * LONGEST) == "a" * LONGEST
