"""The runtime: C++ headers that all emitted sources share, and single-file sources."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path, PurePosixPath
from posixpath import normpath

from adagen.emit.templates import templates_folder
from adagen.version import __version__

FOLDER = "adagen"
"""What the folder of the headers is called beside the sources that include them."""

INTERFACE = re.compile(r'^#include ".*\.h"\n(?=#define ADAGEN_CALL)', re.M)
"""The line by which a solver's source includes its own header."""

_OWN = re.compile(r'#include "([^"]+)"')
_SYSTEM = re.compile(r"#include <[^>]+>")
_SAMPLE = f"{FOLDER}/sample/"
_READ_ALONE = re.compile(
    r"^#if !defined\(ADAGEN_SOLVER\)\n#define ADAGEN_(?:SAMPLE|BATCH).*\n#endif\n", re.M
)


def include_folder() -> Path:
    """Return the folder to include the headers from."""
    return templates_folder() / "include"


@cache
def runtime_files() -> dict[str, str]:
    """Return the headers beside sources, path to text; the same for every robot."""
    root = include_folder()
    files = sorted((root / FOLDER).rglob("*.hpp"))
    return {file.relative_to(root).as_posix(): file.read_text(encoding="utf-8") for file in files}


def version_number(version: str = __version__) -> int:
    """Return a version as version.hpp has it."""
    major, minor, patch = (int(part) for part in re.findall(r"\d+", version)[:3])
    return 10000 * major + 100 * minor + patch


def joined(source: str, files: Mapping[str, str] | None = None) -> str:
    """Return a source with the headers that it includes inserted.

    Each comes once, where it is included first; what headers take of a sample solver when they are
    read alone is left out. Includes of the standard library come once, too, where nothing is
    conditional. The solver's own header is neither read nor needed.

    Args:
        source: what includes them.
        files: the headers, path to text; those of this version by default.
    """
    source = INTERFACE.sub("#define ADAGEN_NO_HEADER\n", source, count=1)
    return _Joining(runtime_files() if files is None else files).text(source, FOLDER)


class _Joining:
    """The headers that have been inserted so far."""

    def __init__(self, files: Mapping[str, str]) -> None:
        self.files = files
        self.seen: set[str] = set()
        self.depth = 0  # of conditions

    def text(self, text: str, folder: str) -> str:
        """Return a text whose own headers are included from a folder."""
        return "".join(self._line(line, folder) for line in text.splitlines(keepends=True))

    def _line(self, line: str, folder: str) -> str:
        directive = line.lstrip()
        if not directive.startswith("#"):
            return line
        if directive.startswith("#if"):
            self.depth += 1
        elif directive.startswith("#endif"):
            self.depth -= 1
        elif own := _OWN.match(directive):
            return self._header(line, own[1], folder)
        elif (system := _SYSTEM.match(directive)) and self.depth == 0:
            return self._once(line, system[0])
        return line

    def _once(self, line: str, name: str) -> str:
        if name in self.seen:
            return ""
        self.seen.add(name)
        return line

    def _header(self, line: str, name: str, folder: str) -> str:
        path = name if name.startswith(f"{FOLDER}/") else normpath(f"{folder}/{name}")
        text = self.files.get(path)
        if text is None:
            return line  # not ours
        if path in self.seen or path.startswith(_SAMPLE):
            return ""
        self.seen.add(path)
        text = text.partition("#pragma once\n")[2]
        text = _READ_ALONE.sub("", text)
        return self.text(text, str(PurePosixPath(path).parent))
