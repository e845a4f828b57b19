"""``adagen completion``: a completion script for a shell."""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from importlib import import_module
from typing import Any

from adagen.cli.parser import Parser, make_parser, parse

SHELLS = ("bash", "zsh", "fish")

_EPILOG = """\
examples:
  source <(adagen completion bash)                         for this shell
  adagen completion bash > ~/.local/share/bash-completion/completions/adagen
  adagen completion zsh > ~/.zfunc/_adagen                 fpath has ~/.zfunc
  adagen completion fish > ~/.config/fish/completions/adagen.fish"""

_FILES = {"MODEL", "FILE", "NAME|FILE", "TRACE"}
_FOLDERS = {"DIR"}
_FISH_FILES = "complete -c adagen -n 'test (count (commandline -opc)) -eq 1' -F\n"
_ZSH_WORDS = "  _describe 'adagen commands' _commands\n"
_FILES_FIRST = {
    "bash": [("complete -o bashdefault -F", "complete -o bashdefault -o default -F")],
    "zsh": [
        (_ZSH_WORDS, f"{_ZSH_WORDS}  _files\n"),
        ("      esac\n", "        *) _arguments -C -s $_shtab_adagen_options ;;\n      esac\n"),
    ],
    "fish": [("complete -c adagen -f\n", f"complete -c adagen -f\n{_FISH_FILES}")],
}
"""What is replaced in shtab's scripts: the first word may be a command, and may be a file."""


def command_parser() -> Parser:
    """Return the parser of ``adagen completion``."""
    parser = make_parser("adagen completion", "Print a completion script for a shell.", _EPILOG)
    parser.add_argument("shell", choices=SHELLS, metavar="SHELL", help=", ".join(SHELLS))
    return parser


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen completion`` with the arguments after the verb; return the status."""
    options = parse(command_parser(), argv)
    import shtab

    text = shtab.complete(whole_parser(), options.shell)
    for before, after in _FILES_FIRST[options.shell]:
        text = text.replace(before, after)
    print(text)
    return 0


def whole_parser() -> argparse.ArgumentParser:
    """Return one parser of all commands, which completes and does not parse."""
    from adagen.cli.main import VERBS

    whole = argparse.ArgumentParser(prog="adagen", add_help=False)
    first = whole.add_subparsers(metavar="MODEL")
    for verb in VERBS:
        own = import_module(f"adagen.cli.{verb}").command_parser()
        _copy(own, first.add_parser(verb, help=own.description, add_help=False))
    from adagen.cli.generate import command_parser

    _copy(command_parser(), whole)
    return whole


def _copy(parser: Parser, to: argparse.ArgumentParser) -> None:
    """Copy the options of one parser to another."""
    for action in parser._actions:
        if action.dest == "model" and to.prog == "adagen":
            continue
        metavar = action.metavar if isinstance(action.metavar, str) else ""
        words: Any = None
        if metavar in _FILES or action.dest == "model":
            words = _files()
        elif metavar in _FOLDERS:
            import shtab

            words = shtab.DIRECTORY
        if words is not None:
            action.complete = words  # type: ignore[attr-defined]
        if action.help is not None and action.help != argparse.SUPPRESS:
            action.help = _first_clause(action.help)
        to._add_action(action)


def _files() -> Any:
    import shtab

    return shtab.FILE


def _first_clause(text: str) -> str:
    """Return the beginning of a help, which says what an option is for."""
    return re.split(r"[;:(]", text, maxsplit=1)[0].strip()
