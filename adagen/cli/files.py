"""Writes a file that the user named."""

from __future__ import annotations

from pathlib import Path

from adagen.atomic_files import write_whole
from adagen.errors import EnvironmentFault, printable


def write_file(path: Path, text: str) -> None:
    """Write one file that the user named, whole or not at all.

    Raises:
        EnvironmentFault: writing failed.
    """
    if path.exists() and not path.is_file():  # /dev/stdout, a named pipe
        try:
            path.write_text(text, encoding="utf-8")
        except OSError as error:
            raise EnvironmentFault(
                f"cannot write {printable(str(path))}: {error.strerror or error}"
            ) from None
    else:
        write_whole(path.resolve(), text)  # never in place of a link such as /dev/stdout
