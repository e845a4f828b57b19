"""From a path to text: only a regular file of reasonable size and known encoding is read."""

from __future__ import annotations

import codecs
import errno
import os
import re
import stat
from pathlib import Path

from adagen.urdf.notes import Notes

LARGEST_FILE = 16 * 2**20
"""Bytes; real robot descriptions have a tenth of it, 10000 links without visuals a fifth."""

_DECLARED = re.compile(rb"^\s*<\?xml[^>]{0,200}?encoding\s*=\s*[\"']([A-Za-z0-9._-]{1,40})[\"']")
_BOMS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
_ENCODINGS = {
    name: codec
    for names, codec in (
        (("utf-8", "utf8"), "utf-8"),
        (("us-ascii", "ascii"), "ascii"),
        (("iso-8859-1", "latin1", "latin-1"), "latin-1"),
        (("iso-8859-15",), "iso-8859-15"),
        (("windows-1252", "cp1252"), "cp1252"),
    )
    for name in names
}
_OTHER_KINDS = (
    (b"\x1f\x8b", "a gzip archive: unpack it first (gunzip)"),
    (b"PK\x03\x04", "a zip archive: unpack it first"),
    (b"BZh", "a bzip2 archive: unpack it first"),
    (b"\xfd7zXZ\x00", "an xz archive: unpack it first"),
    (b"version https://git-lfs", "a git-lfs pointer, not the file itself: run git lfs pull"),
)


def model_stem(path: str | Path) -> str:
    """Return a file's name without its endings: "arm" of "arm.urdf" and of "arm.urdf.xacro"."""
    return Path(Path(path).name.removesuffix(".xacro")).stem


def read_text(path: str | Path, notes: Notes) -> str:
    """Return the text of the file at ``path``.

    Raises:
        InputError: the path names no readable regular file, or the file holds no text.
    """
    data = _read_bytes(path, notes)
    if not data.strip():
        raise notes.error("the file is empty: give a URDF file")
    for magic, what in _OTHER_KINDS:
        if data.startswith(magic):
            raise notes.error(f"not XML but {what}", 1)
    return _decode(data, notes)


def _read_bytes(path: str | Path, notes: Notes) -> bytes:
    file_path = Path(path)
    try:
        # A FIFO or a device must neither block nor notice: look before opening, and again after.
        _check_kind(file_path.stat(), notes)
        descriptor = os.open(file_path, os.O_RDONLY | os.O_CLOEXEC | getattr(os, "O_NONBLOCK", 0))
        with os.fdopen(descriptor, "rb") as file:
            _check_kind(os.fstat(descriptor), notes)
            data = file.read(LARGEST_FILE + 1)
    except (OSError, ValueError) as fault:
        raise notes.error(_reason(file_path, fault)) from None
    if len(data) > LARGEST_FILE:
        raise notes.error(f"larger than {LARGEST_FILE // 2**20} MiB, the limit for a URDF file")
    return data


def _check_kind(status: os.stat_result, notes: Notes) -> None:
    if stat.S_ISDIR(status.st_mode):
        raise notes.error("is a directory: give the URDF file inside it")
    if not stat.S_ISREG(status.st_mode):
        raise notes.error("is not a regular file (a pipe, socket or device): give a URDF file")


def _reason(path: Path, fault: OSError | ValueError) -> str:
    code = fault.errno if isinstance(fault, OSError) else None
    if code == errno.ENOENT:
        if path.is_symlink():
            return "is a symbolic link to a file that does not exist"
        return "no such file"
    if code == errno.ELOOP:
        return "symbolic links form a loop: give the file itself"
    if code == errno.EACCES:
        return "permission denied: make the file readable"
    reason = fault.strerror if isinstance(fault, OSError) else str(fault)
    return f"cannot be read: {reason}"


def _decode(data: bytes, notes: Notes) -> str:
    encoding = _encoding(data, notes)
    try:
        text = data.decode(encoding)
    except UnicodeDecodeError as fault:
        line = data.count(b"\n", 0, fault.start) + 1 if "16" not in encoding else None
        if encoding == "utf-8" and _looks_binary(data):
            raise notes.error("not XML but binary data: give a URDF file", 1) from None
        byte = f"byte 0x{data[fault.start]:02x}" if fault.start < len(data) else "end of file"
        raise notes.error(
            f"invalid {encoding.upper()}: {byte} at offset {fault.start}: save the file as UTF-8",
            line,
        ) from None
    text = text.removeprefix("\ufeff")
    if text.endswith("\0") and "\0" not in text.rstrip("\0"):
        text = text.rstrip("\0")
        notes.slip("the file ends in a zero byte", "left out", text.count("\n") + 1)
    if "\0" in text:
        raise notes.error("not XML but binary data: give a URDF file", 1)
    return text


def _encoding(data: bytes, notes: Notes) -> str:
    for bom, encoding in _BOMS:
        if data.startswith(bom):
            return encoding
    declared = _DECLARED.match(data[:300])
    if declared is None:
        return "utf-8"
    name = declared.group(1).decode("ascii").lower()
    if name not in _ENCODINGS:
        raise notes.error(f'declared encoding "{name}" is not supported: save it as UTF-8', 1)
    return _ENCODINGS[name]


def _looks_binary(data: bytes) -> bool:
    return b"\0" in data[:4096] or data.lstrip()[:1] != b"<"
