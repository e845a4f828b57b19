"""``adagen verify``: compares emitted files with what adagen would emit now."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from adagen.atomic_files import write_whole
from adagen.cli.console import note, speaking
from adagen.cli.parser import Parser, make_parser, parse
from adagen.errors import InputError, UsageError, printable

_EPILOG = """\
The head of an emitted source holds the command that made it; robots, scenes,
loops, schedules and profiles are looked for where it names them. Prints what
is missing, stale or different, with diffs; exit status 1 if anything is.

examples:
  adagen verify solvers                 in continuous integration
  adagen verify --update solvers        after a new adagen: write, then review"""


def command_parser() -> Parser:
    """Return the parser of ``adagen verify``."""
    parser = make_parser("adagen verify", "Generate again and compare.", _EPILOG)
    parser.add_argument(
        "folders", nargs="+", type=Path, metavar="DIR", help="folder with emitted files below it"
    )
    parser.add_argument(
        "--update",
        action="store_true",
        help="write what is missing or different, remove what is stale",
    )
    return parser


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen verify`` with the arguments after the verb; return the exit status."""
    options = parse(command_parser(), argv)

    from adagen.library.comparison import differences

    sources = list(dict.fromkeys(_sources(options.folders)))
    expected: dict[str, bytes] = {}
    with speaking("generating again") as on_progress:
        for k, source in enumerate(sources, start=1):
            on_progress(f"{k} of {len(sources)}: {source.stem}")
            texts = _made_again(source)
            expected |= {
                str(_place(source.parent, name)): text.encode() for name, text in texts.items()
            }
    found = _found(options.folders, expected)
    if options.update:
        _update(found, expected)
        found = _found(options.folders, expected)
    lines = differences(found, expected)
    for line in lines:
        print(printable(line))
    note(f"{len(sources)} solver{'s' * (len(sources) > 1)}: {'not ' * bool(lines)}up to date")
    if lines:
        note("if the change is meant: adagen verify --update, then review")
    return 1 if lines else 0


_SOURCE = re.compile(r".+_p[0-9]+\.cpp")
_OURS = {
    ".cpp": b"emitted by adagen",
    ".h": b"emitted by adagen",
    ".pc": b"mitted by adagen",
    ".plan.json": b'"source_hash"',
    ".svg": b'role="img"',
}
"""Endings of a solver's files, and what their heads hold."""
_RUNTIME = b"// adagen's runtime, "  # how the headers of it begin
_HEAD_BYTES = 1000


def _sources(folders: Sequence[Path]) -> Iterator[Path]:
    """The emitted sources below some folders.

    Raises:
        UsageError: there is no such folder, or nothing emitted in it.
    """
    for folder in folders:
        if not folder.is_dir():
            raise UsageError(f"{printable(str(folder))} is not a folder")
        here = [path for path in sorted(folder.rglob("*.cpp")) if _is_ours(path)]
        if not here:
            raise UsageError(f"{printable(str(folder))} holds no source written by adagen")
        yield from here


def _is_ours(path: Path) -> bool:
    """Whether a file is one of an emitted solver's, or of the runtime."""
    if path.suffix == ".hpp":
        return path.is_file() and path.read_bytes().startswith(_RUNTIME)
    ending = next((end for end in _OURS if path.name.endswith(end)), None)
    if ending is None or not _SOURCE.fullmatch(f"{path.name.removesuffix(ending)}.cpp"):
        return False
    if not path.is_file():
        return False
    with path.open("rb") as file:
        return _OURS[ending] in file.read(_HEAD_BYTES)


def _made_again(source: Path) -> dict[str, str]:
    """The files that a source's command makes now, name to text.

    Raises:
        InputError: the source has no command, or one that makes another file.
    """
    from adagen.cli.generate import options_of
    from adagen.cli.pipeline import origin_of, request_of
    from adagen.library import compile, read  # noqa: A004 (what it does)
    from adagen.library.command import command_in

    command = command_in(source.read_text(encoding="utf-8", errors="replace"))
    if command is None:
        raise InputError(
            "its head has no command: generate it again (adagen MODEL --out DIR)",
            str(source),
        )
    place = source.parent
    options = options_of(command[1:])
    origin = origin_of(options, options.gravity)
    scene = None if origin.scene is None else _seen_here(place, str(origin.scene))
    loops = None if origin.loops is None else _seen_here(place, str(origin.loops))
    request = request_of(options)
    request = replace(
        request,
        schedule=_file_or_name(place, request.schedule),
        profile=_file_or_name(place, request.profile),
    )
    robot = read(
        _seen_here(place, options.model),
        floating=origin.floating,
        mimic=origin.mimic,
        strict=origin.strict,
        scene=scene,
        gravity=origin.gravity,
        arguments=dict(origin.arguments),
        loops=loops,
    )
    made = compile(robot, **vars(request))
    if f"{made.stem}.cpp" != source.name:
        raise InputError(f"the command in its head writes {made.stem}.cpp", str(source))
    return made.in_folder(place)


def _place(folder: Path, name: str) -> Path:
    """Where a file of a folder is: several may share the runtime and the program above them."""
    from adagen.emit.runtime import FOLDER
    from adagen.emit.solver_program import PROGRAM_FILE

    beside, above = folder / name, folder.parent / name
    shared = name == PROGRAM_FILE and not beside.exists() and above.is_file()
    if name.startswith(f"{FOLDER}/"):
        shared = not (folder / FOLDER).exists() and (folder.parent / FOLDER).is_dir()
    return above if shared else beside


def _seen_here(place: Path, path: str) -> str:
    return os.path.relpath(place / path)


def _file_or_name(place: Path, word: str) -> str:
    """A file named in a folder's command, seen from here; a word that is none stays."""
    return _seen_here(place, word) if (place / word).is_file() else word


def _found(folders: Sequence[Path], expected: Mapping[str, bytes]) -> dict[str, bytes]:
    """The files below some folders that are expected, or of emitted solvers."""
    paths = {path for folder in folders for path in folder.rglob("*") if _is_ours(path)}
    paths |= {path for path in map(Path, expected) if path.is_file()}
    return {str(path): path.read_bytes() for path in paths}


def _update(found: Mapping[str, bytes], expected: Mapping[str, bytes]) -> None:
    """Write what is missing or different, remove what is stale."""
    for name, data in expected.items():
        if found.get(name) != data:
            write_whole(Path(name), data.decode())
    for name in set(found) - set(expected):
        Path(name).unlink()
