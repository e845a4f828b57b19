"""Messages of the reader: refusals, warnings and parts left out, one line each."""

from __future__ import annotations

from collections.abc import Sequence

from lxml import etree

from adagen.errors import InputError, printable

SHOWN = 5  # warnings of one kind before they are summed up in one line
LONGEST = 1000  # characters of a message
LAST_LINE = 65535  # where an older libxml2 stops counting


class Notes:
    """Collects the remarks about one file.

    Attributes:
        file: path of the file as the user gave it.
        warnings: ``file:line: warning: ...``, in the order they were found.
        ignored: what was read and is not modelled.
        mentions: what was read beside links and joints, and is modelled.
        strict: whether slips are refused that readers of URDF overlook.
        without_lines: whether lines are those of no file, and left out.
    """

    def __init__(self, file: str, *, strict: bool = False) -> None:
        self.file = file
        self.strict = strict
        self.without_lines = False
        self.warnings: list[str] = []
        self.ignored: list[str] = []
        self.mentions: list[str] = []

    def error(self, message: str, line: int | None = None) -> InputError:
        """Return (not raise) the refusal of this file."""
        return InputError(shortened(message), self.file, None if self.without_lines else line)

    def slip(self, problem: str, done: str, line: int | None = None) -> None:
        """Record a slip that changes nothing, with what was done about it.

        Raises:
            InputError: the reader is strict.
        """
        self._refuse_slip(problem, line)
        self.warn(f"{problem}: {done}", line)

    def slips(self, found: Sequence[tuple[str, str, int | None]], done: str, rest: str) -> None:
        """Record slips of one kind that change nothing, in one line.

        Args:
            found: (name, problem, line) of each.
            done: what was done about them.
            rest: what the others have in common, for the end of the line.

        Raises:
            InputError: the reader is strict.
        """
        for _, problem, line in found[:1]:
            self._refuse_slip(problem, line)
            others = quoted([name for name, _, _ in found[1:]])
            more = f"; so are {len(found) - 1} more {rest}: {others}" if others else ""
            self.warn(f"{problem}: {done}{more}", line)

    def _refuse_slip(self, problem: str, line: int | None) -> None:
        if self.strict:
            raise self.error(f"{problem}: correct it, or leave out --strict", line)

    def warn(self, message: str, line: int | None = None) -> None:
        """Record a warning."""
        shown = "" if line is None or self.without_lines else f"{line}:"
        place = f"{printable(self.file)}:{shown}"
        self.warnings.append(f"{place} warning: {printable(shortened(message))}")

    def warn_each(self, found: Sequence[tuple[str, str, int | None]], rest: str) -> None:
        """Record warnings of one kind: the first ones in full, the names of the others in one line.

        Args:
            found: (name, message, line) of each.
            rest: what the others have in common, for the line that sums them up.
        """
        for _, message, line in found[:SHOWN]:
            self.warn(message, line)
        others = found[SHOWN:]
        if others:
            names = quoted([name for name, _, _ in others])
            self.warn(f"{len(others)} more {rest}: {names}", others[0][2])

    def warn_together(self, found: Sequence[tuple[str, str, int | None]], rest: str) -> None:
        """Record warnings of one kind in one line: the first one in full, names of the others.

        Args:
            found: (name, message, line) of each.
            rest: what the others have in common.
        """
        for _, message, line in found[:1]:
            others = quoted([name for name, _, _ in found[1:]])
            self.warn(
                f"{message}; {len(found) - 1} more {rest}: {others}" if others else message, line
            )

    def ignore(self, text: str) -> None:
        """Record something that was read and is not modelled."""
        self.ignored.append(printable(shortened(text)))

    def mention(self, text: str) -> None:
        """Record something that was read beside links and joints, and is modelled."""
        self.mentions.append(printable(shortened(text)))


def shortened(text: str) -> str:
    """Return text without its middle where it is too long for one line (a name may be a book)."""
    if len(text) <= LONGEST:
        return text
    return f"{text[: LONGEST // 2]} ... {text[-LONGEST // 2 :]}"


def quoted(names: Sequence[str], shown: int = 6) -> str:
    """Return names in quotes, separated by commas, shortened where there are many."""
    text = ", ".join(f'"{name}"' for name in names[:shown])
    return text if len(names) <= shown else f"{text} and {len(names) - shown} more"


def line_of(element: etree._Element) -> int | None:
    """Return the line of an element, or None where libxml2 has lost count."""
    line = element.sourceline
    return line if isinstance(line, int) and line != LAST_LINE else None
