"""Writing output: whole files or none, inside the folder that was asked for."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from adagen.errors import EnvironmentFault, UsageError, printable
from adagen.wholefile import remove, write_beside, write_whole

_SIGNATURE = b"adagen"
_HEAD_BYTES = 1000


def write_files(folder: Path, files: Mapping[str, str]) -> None:
    """Write all of ``files`` (name to text) into ``folder``, which is made where it is missing.

    Every text is first written beside its place and only then, when all are complete, renamed: a
    failure leaves what was there. A file that adagen did not write is not overwritten.

    Raises:
        UsageError: a file that is there was not written by adagen, or is a folder.
        EnvironmentFault: writing failed.
    """
    for name in files:
        if not name or name in (".", "..") or any(c in name for c in "/\\\0"):
            raise ValueError(f"not a plain file name: {name!r}")
    waiting: list[tuple[Path, Path]] = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in files.items():
            _check_ours(folder / name, text)
        for name, text in files.items():
            waiting.append((write_beside(folder, text), folder / name))
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
