"""Text files written completely or not at all: to a temporary file first, then renamed."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from adagen.errors import EnvironmentFault, UsageError, printable

_SIGNATURE = b"adagen"
_HEAD_BYTES = 1000


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
        reason = error.strerror or error
        raise EnvironmentFault(f"cannot write {printable(str(path))}: {reason}") from None


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


def write_files(folder: Path, files: Mapping[str, str]) -> None:
    """Write all of ``files`` (path to text) into ``folder``, which is made where it is missing.

    Every text is first written beside its place and only then, when all are complete, renamed: a
    failure leaves what was there. A file that adagen did not write is not overwritten.

    Raises:
        UsageError: a file that is there was not written by adagen, or is a folder.
        EnvironmentFault: writing failed.
    """
    for name in files:
        if any(part in ("", ".", "..") for part in name.split("/")) or any(
            c in name for c in "\\\0"
        ):
            raise ValueError(f"not a file inside a folder: {name!r}")
    waiting: list[tuple[Path, Path]] = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in files.items():
            _check_ours(folder / name, text)
        for parent in {(folder / name).parent for name in files}:
            parent.mkdir(parents=True, exist_ok=True)
        for name, text in files.items():
            if _is_right(folder / name, text):
                continue  # its time stays, and nothing that depends on it is built anew
            waiting.append((write_beside((folder / name).parent, text), folder / name))
        while waiting:
            temporary, place = waiting[0]
            os.replace(temporary, place)  # noqa: PTH105 (a symlink is replaced, not followed)
            waiting.pop(0)
    except OSError as error:
        raise EnvironmentFault(
            f"cannot write to {printable(str(folder))}: {error.strerror or error}"
        ) from None
    finally:
        for temporary, _ in waiting:
            remove(temporary)


def _is_right(path: Path, text: str) -> bool:
    """Whether a file holds a text already."""
    try:
        return not path.is_symlink() and path.read_bytes() == text.encode("utf-8")
    except OSError:
        return False


def _check_ours(path: Path, text: str) -> None:
    """Refuse to overwrite a file that lacks the signature that the new text carries."""
    if path.is_symlink() and not path.exists():
        return
    if path.is_dir():
        raise UsageError(f"{printable(str(path))} is a folder; choose another --out or --name")
    if not path.exists() or _SIGNATURE not in text[:_HEAD_BYTES].encode():
        return
    with path.open("rb") as file:
        head = file.read(_HEAD_BYTES)
    if head.strip() and _SIGNATURE not in head:
        raise UsageError(
            f"{printable(str(path))} exists and was not written by adagen; choose another --out"
        )
