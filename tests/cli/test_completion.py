"""Symbols completed by real shells, where they are installed."""

from __future__ import annotations

import os
import pty
import re
import select
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest

from adagen.cli import main
from adagen.cli.completion import SHELLS, whole_parser
from adagen.cli.main import VERBS

CASES = [
    ("adagen sch", {"schedule"}, {"solve"}),
    ("adagen rob", {"robot.urdf"}, {"schedule"}),
    ("adagen robot.urdf --pro", {"--procs", "--profile"}, {"--form"}),
    ("adagen robot.urdf --form ", {"segment", "ada"}, {"auto"}),
    ("adagen schedule rob", {"robot.urdf"}, {"other"}),
    ("adagen schedule robot.urdf --js", {"--json"}, {"--svg"}),
    ("adagen schedule robot.urdf --tie ", {"work", "lex"}, {"auto"}),
    ("adagen completion ", {"bash", "zsh", "fish"}, {"info"}),
]
"""What is typed, some of what it may become, and some of what it may not."""

Case = tuple[str, set[str], set[str]]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "robot.urdf").touch()
    (tmp_path / "other").touch()
    return tmp_path


@pytest.fixture
def script(tmp_path: Path, capsys: pytest.CaptureFixture[str], request: object) -> Path:
    assert isinstance(request, pytest.FixtureRequest)
    shell = request.node.name.split("_")[1]
    if shutil.which(shell) is None:
        pytest.skip(f"there is no {shell}")
    assert main(["completion", shell]) == 0
    path = tmp_path / "scripts" / "_adagen"
    path.parent.mkdir()
    path.write_text(capsys.readouterr().out)
    return path


@pytest.mark.parametrize("case", CASES, ids=lambda case: case[0])
def test_bash_completes(case: Case, script: Path, folder: Path) -> None:
    typed, may, may_not = case
    words = " ".join(f'"{word}"' for word in typed.split(" "))
    program = f"""source {script}; set -- {words}; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
_shtab_adagen 2>/dev/null; printf '%s\\n' "${{COMPREPLY[@]}}"
[[ -z ${{COMPREPLY[*]}} && $(complete -p adagen) == *default* ]] && compgen -f -- "${{@: -1}}" """
    done = subprocess.run(
        ["bash", "--norc", "-c", program], capture_output=True, text=True, cwd=folder, timeout=30
    )
    said = set(done.stdout.split())
    assert may <= said and not may_not & said


@pytest.mark.parametrize("case", CASES, ids=lambda case: case[0])
def test_fish_completes(case: Case, script: Path, folder: Path) -> None:
    typed, may, may_not = case
    done = subprocess.run(
        ["fish", "--no-config", "-c", f"source {script}; complete -C '{typed}'"],
        capture_output=True,
        text=True,
        cwd=folder,
        timeout=30,
        env={**os.environ, "HOME": str(folder / "scripts")},
    )
    said = {line.partition("\t")[0] for line in done.stdout.splitlines()}
    assert may <= said and not may_not & said


@pytest.mark.parametrize("case", CASES, ids=lambda case: case[0])
def test_zsh_completes(case: Case, script: Path, folder: Path) -> None:
    typed, may, may_not = case
    before = f"fpath=({script.parent} $fpath); autoload -Uz compinit; compinit -u -D; PS1=; "
    before += "bindkey '^X' list-choices; LISTMAX=0; unset zle_bracketed_paste; print REA''DY\n"
    shown = typed_in(["zsh", "-f", "-i"], before, typed, folder, may)
    said = _words(shown)
    assert may <= said and not may_not & said


def typed_in(shell: list[str], before: str, typed: str, folder: Path, awaited: set[str]) -> str:
    """What a shell on a terminal shows after words and a tab, once all that is awaited is there."""
    child, terminal = pty.fork()
    if child == 0:
        os.chdir(folder)
        os.execvpe(shell[0], shell, {**os.environ, "TERM": "dumb", "HOME": str(folder)})
    try:
        os.write(terminal, before.encode())
        _read(terminal, {"READY"})
        # A second tab lists what is possible; after a word that the first one has completed it
        # would list what may follow that.
        os.write(terminal, typed.encode() + b"\t")
        shown = _read(terminal, awaited, 3.0)
        if not awaited <= _words(shown):
            os.write(terminal, b"\t")
            shown += _read(terminal, awaited)
        return shown
    finally:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        os.close(terminal)


def _words(text: str) -> set[str]:
    return set(re.findall(r"[\w.-]+", text))


def _read(terminal: int, awaited: set[str], patience: float = 20.0) -> str:
    text, end = "", time.monotonic() + patience
    while time.monotonic() < end and not awaited <= _words(text):
        if select.select([terminal], [], [], 0.2)[0]:
            text += os.read(terminal, 65536).decode(errors="replace")
    return text


def test_each_command_s_options_are_known() -> None:
    whole = whole_parser()
    (verbs,) = (each.choices for each in whole._actions if isinstance(each.choices, dict))
    assert set(verbs) == set(VERBS)
    for parser in (whole, *verbs.values()):
        assert "--help" in parser._option_string_actions
    assert "--procs" in whole._option_string_actions


def test_another_shell_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert SHELLS == ("bash", "zsh", "fish")
    assert main(["completion", "csh"]) == 2
    assert "choose from" in capsys.readouterr().err
