"""Robot descriptions in xacro, expanded by ROS's own package ``xacro``.

xacro computes what a file says in ${...}: expand only files that you trust.
"""

from __future__ import annotations

import difflib
import io
import os
from collections.abc import Mapping
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

from adagen.errors import EnvironmentFault, InputError, UsageError, printable
from adagen.urdf.document import check_prolog
from adagen.urdf.notes import Notes
from adagen.urdf.source import LARGEST_FILE, read_text

Arguments = Mapping[str, str]
"""Values of <xacro:arg>, by name."""


_PLACES = ("when ", "in file:", "included ", "instantiated ")
"""How lines begin in which xacro says where it was as it warned."""


def is_xacro_file(path: str | Path) -> bool:
    """Tell by its name whether a file is to be expanded."""
    return os.fspath(path).endswith(".xacro")


def description_text(path: str | Path, arguments: Arguments, notes: Notes) -> str:
    """Return the text of a URDF, expanded where it is written in xacro.

    Args:
        path: of the file.
        arguments: values of its <xacro:arg>.
        notes: takes xacro's warnings; lines of an expanded file are those of no file and left out.

    Raises:
        InputError: the file cannot be read, or xacro refuses it.
        UsageError: there is no such argument.
        EnvironmentFault: xacro is needed and not installed.
    """
    text = read_text(path, notes)
    if not is_xacro_file(path):
        if arguments:
            raise UsageError(
                f"--xacro-arg is for files whose names end in .xacro, not {printable(notes.file)}"
            )
        return text
    check_prolog(text, notes)
    notes.without_lines = True
    expanded = _expanded(Path(path), arguments, notes)
    if len(expanded) > LARGEST_FILE:
        raise notes.error(f"expands to more than {LARGEST_FILE // 2**20} MiB, the limit of a URDF")
    return expanded


def expanded_bytes(path: Path, arguments: Arguments) -> bytes:
    """Return the bytes of a description: the file's own or, in xacro, what it expands to.

    Raises:
        InputError: it cannot be read or expanded.
    """
    if is_xacro_file(path):
        return description_text(path, arguments, Notes(os.fspath(path))).encode()
    try:
        return path.read_bytes()
    except OSError as error:
        raise InputError(f"cannot read it: {error.strerror}", str(path)) from None


class _Asked(dict[str, str]):
    """Arguments, with the names that xacro asked for."""

    def __init__(self, values: Arguments) -> None:
        super().__init__(values)
        self.names: set[str] = set()

    def __contains__(self, name: object) -> bool:
        self.names.add(str(name))
        return super().__contains__(name)

    def __getitem__(self, name: str) -> str:
        self.names.add(name)
        return super().__getitem__(name)


def _expanded(path: Path, arguments: Arguments, notes: Notes) -> str:
    xacro = _package(notes)
    asked, output = _Asked(arguments), io.StringIO()
    try:
        with redirect_stdout(output), redirect_stderr(output):
            document = xacro.process_file(os.fspath(path), mappings=asked)
            # The root alone: before it stands a comment with the file's path, which may differ.
            text = f'<?xml version="1.0"?>\n{document.documentElement.toxml()}\n'
    except Exception as fault:  # any: files hold expressions of Python
        raise notes.error(f"xacro: {_reason(fault)}{_place(xacro, path)}") from None
    for name in arguments:
        if name not in asked.names:
            near = difflib.get_close_matches(name, asked.names, n=1)
            hint = f" (did you mean {near[0]}?)" if near else ""
            raise UsageError(f"{notes.file} has no <xacro:arg> {printable(name)}{hint}")
    for line in filter(None, map(str.strip, output.getvalue().splitlines())):
        if not line.startswith(_PLACES):
            notes.warn(f"xacro: {line.removeprefix('warning: ')}")
    return text


def _package(notes: Notes) -> Any:
    try:
        import xacro
    except ImportError:
        raise EnvironmentFault(
            f"{printable(notes.file)} is written in xacro, and the Python package xacro is not "
            "installed: pip install xacro, or give the URDF that xacro makes of it"
        ) from None
    return xacro


def _reason(fault: Exception) -> str:
    if "ament_index_python" in str(fault):
        return "$(find ...) needs ROS: source its setup, or write paths relative to the file"
    return " ".join(str(fault).split()) or type(fault).__name__


def _place(xacro: Any, path: Path) -> str:
    """Return in which included file xacro was, where it was in one."""
    at = [each for each in getattr(xacro, "filestack", None) or [] if each]
    return f" (in {at[-1]})" if at and Path(at[-1]) != path else ""
