"""``python -m benchmarks.paper NAME``: a table or figure of the paper; ``all``: every one."""

from __future__ import annotations

import sys
from collections.abc import Callable

from benchmarks.paper import figures, timing

COMMANDS: dict[str, Callable[[], None]] = {
    "table1": figures.table_1,
    "fig3": figures.figure_3,
    "fig4": timing.figure_4,
    "fig5": figures.figure_5,
    "fig6": figures.figure_6,
    "fig7": figures.figure_7,
    "fig8": figures.figure_8,
    "fig9": figures.figure_9,
    "table2": timing.table_2,
    "fig4-predicted": lambda: timing.figure_4(run=False),
    "table2-predicted": lambda: timing.table_2(run=False),
}


def main(words: list[str]) -> int:
    """Make the tables and figures that the words name; return the exit status."""
    names = [n for n in COMMANDS if "-" not in n] if words == ["all"] else words
    if not names or any(name not in COMMANDS for name in names):
        known = " | ".join([*COMMANDS, "all"])
        print(f"usage: python -m benchmarks.paper {known}", file=sys.stderr)
        return 2
    for name in names:
        print(f"\n{name}")
        COMMANDS[name]()
    return 0


sys.exit(main(sys.argv[1:]))
