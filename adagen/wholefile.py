"""Text files written whole or not at all: beside their place first, then renamed."""

from __future__ import annotations

import os
import tempfile
from contextlib import suppress
from pathlib import Path

from adagen.errors import EnvironmentFault, printable


def write_whole(path: Path, text: str) -> None:
    """Write a text file, whole or not at all.

    Raises:
        EnvironmentFault: writing failed.
    """
    try:
        temporary = write_beside(path.parent, text)
        try:
            temporary.replace(path)
        except BaseException:
            remove(temporary)
            raise
    except OSError as error:
        said = error.strerror or error
        raise EnvironmentFault(f"cannot write {printable(str(path))}: {said}") from None


def write_beside(folder: Path, text: str) -> Path:
    """Write text to a new hidden file, to be renamed when all is well, and return where it is.

    Raises:
        OSError: writing failed; nothing is left.
    """
    handle, name = tempfile.mkstemp(prefix=".adagen-", dir=folder)
    temporary = Path(name)
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        mask = os.umask(0)
        os.umask(mask)
        temporary.chmod(0o666 & ~mask)  # mkstemp makes it private
    except BaseException:
        remove(temporary)
        raise
    return temporary


def remove(path: Path) -> None:
    """Remove a file if that can be done."""
    with suppress(OSError):
        path.unlink()
