"""Tables for people."""

from __future__ import annotations

import shutil
import textwrap
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import JustifyMethod
    from rich.table import Table


def wrapped(text: str, indent: int = 0) -> str:
    """Return lines that fit the terminal (80 columns where there is none).

    Args:
        text: lines, each of which goes on in further ones where it is too long.
        indent: columns that those begin behind, beside the line's own.
    """
    width = shutil.get_terminal_size().columns
    return "\n".join(
        textwrap.fill(
            line,
            max(width, 40),
            subsequent_indent=" " * (len(line) - len(line.lstrip()) + indent),
            break_long_words=False,
            break_on_hyphens=False,
        )
        for line in text.splitlines()
    )


def table_of(
    columns: Sequence[str],
    rows: Iterable[Sequence[str]],
    *,
    title: str | None = None,
    named: bool = True,
    wrap: bool = True,
    whole: bool = False,
) -> Table:
    """Return a table of figures, which stand to the right.

    Args:
        columns: their heads.
        rows: a word for each column; none of them is read as markup.
        title: what stands above.
        named: the first column holds names, which stand to the left.
        wrap: whether what is too long goes on in the next line, a long word too; else it is cut.
        whole: whether the first column alone gives way, so that all figures stay whole.
    """
    from rich import box
    from rich.markup import escape
    from rich.table import Table

    table = Table(box=box.SIMPLE, title=title and escape(title))
    for k, column in enumerate(columns):
        justify: JustifyMethod = "left" if named and k == 0 else "right"
        table.add_column(
            column,
            justify=justify,
            no_wrap=not wrap or (whole and k > 0),
            overflow="fold" if wrap else "ellipsis",
        )
    for row in rows:
        table.add_row(*map(escape, row))
    return table
