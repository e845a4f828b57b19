"""What benchmarks share: their command lines, the pages that hold their tables, and records."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
MODELS = ROOT / "generated_examples" / "models"
_END = "<!-- end -->"


def command(about: str | None, page: str | None = None) -> argparse.ArgumentParser:
    """Return the parser of a benchmark's command line, with the option for its page.

    Args:
        about: the module's docstring, which --help prints.
        page: that --page writes, a path in docs; without one --write PAGE names it.
    """
    parser = argparse.ArgumentParser(
        description=about, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    add = parser.add_argument
    if page is None:
        add("--write", type=Path, metavar="PAGE", help="put the tables there, too")
    else:
        path = ROOT / "docs" / page
        add("--page", dest="write", action="store_const", const=path, help=f"write docs/{page}")
    return parser


def publish(options: argparse.Namespace, benchmark: str, text: str) -> None:
    """Print tables, and put them into the page that the command line names, if it does.

    Args:
        options: of a parser that ``command`` has made.
        benchmark: as in ``write_between_marks``.
        text: the tables.
    """
    print(text)
    if options.write is not None:
        write_between_marks(options.write, benchmark, text)


def write_between_marks(page: Path, benchmark: str, text: str) -> None:
    """Put text between a page's ``<!-- benchmarks.NAME -->`` and ``<!-- end -->``.

    Args:
        page: the document (Markdown), which has these marks.
        benchmark: NAME.
        text: what takes the place of what stands there.

    Raises:
        ValueError: the page has no such marks.
    """
    begin = f"<!-- benchmarks.{benchmark} -->"
    held = page.read_text(encoding="utf-8")
    head, tail = held[: held.index(begin)], held[held.index(_END, held.index(begin)) :]
    page.write_text(f"{head}{begin}\n{text}\n{tail}", encoding="utf-8")


class Record:
    """A file of what was found, a line of JSON for each: a benchmark can go on with it.

    Args:
        path: of the file, which need not be there yet; without it nothing is kept.
    """

    def __init__(self, path: Path | None) -> None:
        lines = path.read_text(encoding="utf-8").splitlines() if path and path.exists() else ()
        self.path, rows = path, map(json.loads, lines)
        self._known = {
            _key({name: row[name] for name in row.keys() - {"found"}}): row for row in rows
        }

    def of(self, key: Mapping[str, Any], find: Callable[[], Any]) -> Any:
        """Return what the record has of something, or find it and keep that.

        Args:
            key: members of its line that tell it from others, as JSON has them.
            find: returns what is kept, as JSON has it.
        """
        row = self._known.get(_key(key))
        if row is None:
            row = self._known[_key(key)] = {**key, "found": find()}
            if self.path is not None:
                with self.path.open("a", encoding="utf-8") as file:
                    file.write(json.dumps(row) + "\n")
        return row["found"]

    @property
    def rows(self) -> list[dict[str, Any]]:
        """Its lines: what tells each from others, and what was found."""
        return list(self._known.values())


def _key(members: Mapping[str, Any]) -> str:
    return json.dumps(members, sort_keys=True)
