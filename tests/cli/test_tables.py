"""Tables for people: words as they are, names to the left, figures to the right."""

from __future__ import annotations

import pytest

from adagen.cli.tables import table_of, wrapped


def printed(width: int, *rows: tuple[str, ...], wrap: bool = True, named: bool = True) -> list[str]:
    from rich.console import Console

    console = Console(width=width)
    with console.capture() as said:
        console.print(table_of(("robot", "us"), rows, title="[a] title", wrap=wrap, named=named))
    return [line.strip() for line in said.get().splitlines() if line.strip()]


def test_words_are_no_markup() -> None:
    title, head, _, row = printed(40, ("arm [red] 7[/]", "0.5"))
    assert title == "[a] title"
    assert head.split() == ["robot", "us"]
    assert row.split() == ["arm", "[red]", "7[/]", "0.5"]


def test_names_stand_to_the_left_and_figures_to_the_right() -> None:
    first, second = printed(40, ("a", "1"), ("longer", "1234"))[-2:]
    assert (first.index("a"), first.index("1") + 1) == (0, second.index("1234") + 4)
    first, second = printed(40, ("1", "1"), ("1234", "1234"), named=False)[-2:]
    assert len(first) == len(second) - 3


def test_what_is_too_long_is_cut_where_lines_do_not_wrap() -> None:
    assert len(printed(30, ("a name " * 9, "1"))) > len(
        printed(30, ("a name " * 9, "1"), wrap=False)
    )


def test_lines_go_on_where_the_terminal_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "40")
    name = "a_name_that_is_longer_than_a_terminal_is_wide"
    text = wrapped(f"process 0\n  left-hip, left_knee, left_ankle, left_toe\n{name}", 2)
    assert text.splitlines() == [
        "process 0",
        "  left-hip, left_knee, left_ankle,",
        "    left_toe",
        name,
    ]
