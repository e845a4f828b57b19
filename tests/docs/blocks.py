"""Fenced blocks of the documents' pages, and the marks in comments that stand before them.

Marks, each an HTML comment on a line of its own:

    <!-- file: NAME = PATH -->     a file of this repository that the page's commands find as NAME
    <!-- before: COMMAND -->       a command that readers have done already, run where it stands
    <!-- not run: REASON -->       the next block is not run
    <!-- slow: REASON -->          the next block is run with the slow tests alone
    <!-- needs: PROGRAM ... -->    the next block is run where there are such programs
    <!-- in: a clone -->           the next block is run in a fresh clone of this repository
    <!-- on hosts: N -->           the next block is run on the first of N hosts, node1, node2, ...
                                   (tests/network), where there can be such
    <!-- under: Slurm -->          those hosts are a cluster of Slurm's for the next block
    <!-- under: Slurm, PMIx -->    the same, where Slurm can start MPI's processes itself
    <!-- status: N -->             the next block ends with exit status N
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]

_FENCE = re.compile(r"^( *)```([a-z]*)(?: title=\"([^\"]+)\")?$")
_MARK = re.compile(r"^<!-- (file|before|not run|slow|needs|in|on hosts|under|status): (.*) -->$")


@dataclass(frozen=True)
class Block:
    """One fenced block, or one mark that acts by itself (``file``, ``before``)."""

    line: int
    language: str
    text: str
    title: str = ""
    not_run: str = ""
    slow: str = ""
    needs: str = ""
    clone: bool = False
    hosts: int = 0
    under: str = ""
    status: int = 0


def blocks(page: Path) -> list[Block]:
    """Return the blocks of a page in order."""
    found, marks = [], dict[str, str]()
    fence: re.Match[str] | None = None
    body: list[str] = []
    start = 0
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if fence is not None:
            if line.strip() == "```":
                found.append(_block(start, fence, body, marks))
                fence, marks = None, {}
            else:
                body.append(line.removeprefix(fence[1]))
        elif match := _FENCE.match(line):
            fence, body, start = match, [], number
        elif line.lstrip().startswith("```"):
            raise ValueError(f"{page}:{number}: {line} is no fence of these documents")
        elif mark := _MARK.match(line):
            if mark[1] in ("file", "before"):
                found.append(Block(number, mark[1], mark[2]))
            else:
                marks[mark[1]] = mark[2]
        elif line.strip() and marks:
            raise ValueError(f"{page}:{number}: a mark stands before no block: {marks}")
    return found


def _block(start: int, fence: re.Match[str], body: list[str], marks: dict[str, str]) -> Block:
    return Block(
        line=start,
        language=fence[2],
        text="\n".join(body) + "\n",
        title=fence[3] or "",
        not_run=marks.get("not run", ""),
        slow=marks.get("slow", ""),
        needs=marks.get("needs", ""),
        clone=marks.get("in") == "a clone",
        hosts=int(marks.get("on hosts", "0")),
        under=marks.get("under", ""),
        status=int(marks.get("status", "0")),
    )
