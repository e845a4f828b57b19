"""Every command in the documents runs, with the files that its page shows."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections import Counter
from contextlib import ExitStack
from pathlib import Path

import pytest

from adagen.build import find_toolchain
from adagen.cli import main
from adagen.cli.main import VERBS
from tests.docs.blocks import PAGES, ROOT, Block, blocks
from tests.network import Network, network, why_no_hosts
from tests.network.slurm import slurm, why_no_slurm
from tests.slow import slow

RUN = ("sh", "python")
SHOWN = ("text", "c", "cpp", "cmake", "toml", "json", "xml", "yaml")
COMMAND = re.compile(
    r"^(\$ |adagen (?!MODEL|COMMAND)|(make|python3?|pip|mpiexec|cmake|cc|c\+\+|g\+\+) [-\w./])"
)

# How many blocks are not run, and why: who adds one changes this table.
NOT_RUN: dict[str, int] = {}
SLOTS = 4  # processes that a host takes under Slurm, as the pages say

INLINE = re.compile(r"`((?:adagen |python -m benchmarks\.)[^`\n]*)`")


def name(page: Path) -> str:
    return str(page.relative_to(ROOT))


def has_commands(page: Path) -> bool:
    return any(b.language in RUN and not b.not_run for b in blocks(page))


WITH_COMMANDS = [page for page in PAGES if has_commands(page)]
QUICK = {
    *("README.md", "docs/reference/python.md"),
    *(f"docs/how_to/{page}.md" for page in ("embedded", "library", "python")),
}
"""Pages for those who begin, and of each way to build: the other ones take long."""
WITH_SLOW = [page for page in WITH_COMMANDS if any(b.slow for b in blocks(page))]


@pytest.mark.parametrize(
    "page", [page if name(page) in QUICK else slow(page) for page in WITH_COMMANDS], ids=name
)
def test_commands_run(page: Path, tmp_path: Path) -> None:
    run_and_tell(page, tmp_path, slow=False)


@pytest.mark.slow
@pytest.mark.parametrize("page", WITH_SLOW, ids=name)
def test_slow_commands_run(page: Path, tmp_path: Path) -> None:
    run_and_tell(page, tmp_path, slow=True)


def test_what_a_machine_cannot_run_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (page,) = (page for page in PAGES if page.name == "hosts.md")
    (first, *_) = (block for block in blocks(page) if block.under)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert lacking(first).startswith("needs ")
    assert lacking(Block(7, "sh", "true", needs="no-such-tool")) == "needs no-such-tool"
    assert lacking(Block(7, "sh", "true")) == ""


def test_what_is_not_run_is_counted() -> None:
    skipped = Counter(b.not_run for page in PAGES for b in blocks(page) if b.not_run)
    assert dict(skipped) == NOT_RUN
    commands = sum(b.language in RUN and not b.not_run for page in PAGES for b in blocks(page))
    assert commands > 2 * sum(NOT_RUN.values())


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_no_command_hides_in_a_block_that_is_not_run(page: Path) -> None:
    for block in blocks(page):
        assert block.language in (*RUN, *SHOWN, "file", "before"), (block.line, block.language)
        if block.language == "text":
            hidden = [line for line in block.text.splitlines() if COMMAND.match(line)]
            assert not hidden, (block.line, hidden)


def test_commands_within_lines_name_what_there_is(capsys: pytest.CaptureFixture[str]) -> None:
    wrong = []
    for page in PAGES:
        for words in INLINE.findall(page.read_text(encoding="utf-8")):
            options = set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", words.split('"')[0]))
            known = known_options(words.split(), capsys)
            if known is None or options - known:
                wrong.append((name(page), words))
    assert not wrong


def known_options(words: list[str], capsys: pytest.CaptureFixture[str]) -> set[str] | None:
    """Return the options of the command that words begin, None where there is no such one."""
    if words[0] == "adagen":
        verb = words[1:2] if words[1:2] and words[1] in VERBS else []
        main([*verb, "--help-all"]) if verb not in SHORT else main([*verb, "--help"])
        return set(re.findall(r"--[a-z][a-z-]*", capsys.readouterr().out))
    if words[2] == "benchmarks.NAME":
        return set()
    folder = ROOT / words[2].replace(".", "/")
    sources = [folder.with_suffix(".py"), *folder.glob("*.py"), *ROOT.glob("benchmarks/*.py")]
    if not sources[0].is_file() and not folder.is_dir():
        return None
    return {
        option
        for source in sources
        if source.is_file()
        for option in re.findall(r"--[a-z][a-z-]*", source.read_text(encoding="utf-8"))
    }


SHORT = [[verb] for verb in ("info", "verify", "calibrate", "stability", "completion")] + [["env"]]


def run_page(page: Path, folder: Path, *, slow: bool) -> None:
    """Run the blocks of a page in order in a folder of its own.

    Raises:
        AssertionError: a command ends with another status than the page says.
    """
    everything = blocks(page)
    with ExitStack() as stack:
        hosts = max((block.hosts for block in everything if is_run(block, slow=slow)), default=0)
        net = stack.enter_context(network(hosts, find_toolchain(), folder)) if hosts else None
        for block in everything:
            if block.language == "file":
                target, _, source = block.text.partition(" = ")
                (folder / target).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / source, folder / target)
            elif block.title:
                (folder / block.title).parent.mkdir(parents=True, exist_ok=True)
                (folder / block.title).write_text(block.text, encoding="utf-8")
            elif block.language in (*RUN, "before") and is_run(block, slow=slow):
                run_block(page, block, folder, net if block.hosts else None)


def is_run(block: Block, *, slow: bool) -> bool:
    """Whether a block is run here."""
    return not block.not_run and (slow or not block.slow) and not lacking(block)


def lacking(block: Block) -> str:
    """Return why a block cannot run on this machine; nothing if it can."""
    missing = [program for program in block.needs.split() if shutil.which(program) is None]
    if missing:
        return f"needs {' '.join(missing)}"
    if block.under:
        return why_no_slurm(pmix="PMIx" in block.under)
    return why_no_hosts() if block.hosts else ""


def run_and_tell(page: Path, folder: Path, *, slow: bool) -> None:
    """Run what can be run of a page; the test is skipped at its end if something could not."""
    run_page(page, folder, slow=slow)
    wanted = [b for b in blocks(page) if b.language in RUN and not b.not_run]
    left = [f"line {b.line} {why}" for b in wanted if slow or not b.slow if (why := lacking(b))]
    if left:
        pytest.skip(f"all but: {'; '.join(left)}")


def run_block(page: Path, block: Block, folder: Path, net: Network | None) -> None:
    """Run one block, on the first host of a network if there is one."""
    place = clone_in(folder) if block.clone else folder
    words = ["bash", "-eu", "-o", "pipefail", "-c", block.text]
    if block.language == "python":
        words = [sys.executable, "-c", block.text]
    own = {} if block.clone else {"PYTHONPATH": str(ROOT)}
    with ExitStack() as stack:
        under = stack.enter_context(slurm(net, SLOTS)) if block.under and net else ()
        done = subprocess.run(
            words if net is None else net.command(*words),
            capture_output=True,
            text=True,
            timeout=1800 if block.slow else 600,
            cwd=place,
            env={
                **os.environ,
                **dict(find_toolchain().environment),  # root has to allow Open MPI to run
                **({} if net is None else on_one_core(net)),
                **dict(under),
                "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
                "XDG_CONFIG_HOME": str(folder / "config"),
                **own,
            },
        )
    what = f"{name(page)}:{block.line}: status {done.returncode}\n{block.text}\n{done.stderr}"
    assert done.returncode == block.status, what


def on_one_core(net: Network) -> dict[str, str]:
    """Return what lets mpiexec start several processes on hosts that have a core each."""
    return {**dict(net.environment()), "PRTE_MCA_hwloc_default_binding_policy": "none"}


def clone_in(folder: Path) -> Path:
    """Return a clone of this repository in a folder, made where there is none yet."""
    clone = folder / "clone"
    if not clone.exists():
        subprocess.run(["git", "clone", "--quiet", str(ROOT), str(clone)], check=True)
    return clone
