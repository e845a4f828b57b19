"""Executables by content."""

from __future__ import annotations

import os
import stat
import subprocess
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import pytest

from adagen.build import Toolchain, build_executable, cache, cache_folder, find_toolchain
from adagen.errors import EnvironmentFault

COMPILER = """#!/bin/sh
case "$1" in
  --version) echo "fake compiler $(cat "$0.version")"; exit 0;;
  --showme) echo "fake -lmpi"; exit 0;;
esac
echo "$@" >> "$0.calls"
sleep 0.2
while [ "$1" != -o ]; do source="$last"; last="$1"; shift; done
{ echo "#!/bin/sh"; echo "echo $(cat "$last")"; } > "$2"
chmod 755 "$2"
"""


@pytest.fixture
def fake(tmp_path: Path) -> Toolchain:
    """A compiler that counts its calls and makes a script that says its source."""
    compiler = tmp_path / "mpicxx"
    compiler.write_text(COMPILER)
    compiler.chmod(0o755)
    Path(f"{compiler}.version").write_text("1")
    eigen = tmp_path / "eigen"
    (eigen / "Eigen").mkdir(parents=True)
    return Toolchain((str(compiler),), (str(compiler),), ("mpiexec",), eigen, ("-O1",), wheel=False)


def calls(toolchain: Toolchain) -> int:
    log = Path(f"{toolchain.mpicxx[0]}.calls")
    return len(log.read_text().splitlines()) if log.exists() else 0


def says(executable: Path) -> str:
    return subprocess.run([executable], capture_output=True, text=True).stdout.strip()


def test_the_second_build_is_found(fake: Toolchain, tmp_path: Path) -> None:
    first = build_executable("hello", "robot_p2", fake, tmp_path / "cache")
    again = build_executable("hello", "robot_p2", fake, tmp_path / "cache")
    assert first == again
    assert first.name == "robot_p2"
    assert says(first) == "hello"
    assert calls(fake) == 1


def test_the_source_is_kept_beside_the_executable(fake: Toolchain, tmp_path: Path) -> None:
    built = build_executable("hello", "robot_p2", fake, tmp_path / "cache")
    assert (built.parent / "robot_p2.cpp").read_text() == "hello"
    assert stat.S_IMODE(built.parent.stat().st_mode) == 0o755


def test_whatever_decides_on_the_executable_makes_another(fake: Toolchain, tmp_path: Path) -> None:
    folder = tmp_path / "cache"
    seen = {build_executable("hello", "robot", fake, folder)}
    seen.add(build_executable("hullo", "robot", fake, folder))
    seen.add(build_executable("hello", "rob", fake, folder))
    seen.add(build_executable("hello", "robot", replace(fake, flags=("-O2",)), folder))
    Path(f"{fake.mpicxx[0]}.version").write_text("2")
    Path(fake.mpicxx[0]).touch()  # of another version, it is another file
    seen.add(build_executable("hello", "robot", fake, folder))
    (fake.eigen / "Eigen" / "Version").write_text("#define EIGEN_MAJOR_VERSION 5\n")
    seen.add(build_executable("hello", "robot", fake, folder))
    assert len(seen) == 6
    assert calls(fake) == 6


def test_texts_that_join_to_the_same_are_told_apart(fake: Toolchain, tmp_path: Path) -> None:
    a = build_executable("ab", "c", fake, tmp_path / "cache")
    b = build_executable("a", "bc", fake, tmp_path / "cache")
    assert a.parent != b.parent


def test_concurrent_builds_of_one_source_agree(fake: Toolchain, tmp_path: Path) -> None:
    folder = tmp_path / "cache"
    with ThreadPoolExecutor(6) as pool:
        built = list(pool.map(lambda _: build_executable("hi", "r", fake, folder), range(6)))
    assert len(set(built)) == 1
    assert says(built[0]) == "hi"
    assert [entry.name for entry in folder.iterdir()] == [built[0].parent.name]


SOLVER = "// links     adagen_program.cpp -DADAGEN_FLOAT\n"


def objects(toolchain: Toolchain) -> list[str]:
    """The calls that have compiled the program around a solver."""
    log = Path(f"{toolchain.mpicxx[0]}.calls").read_text()
    return [line for line in log.splitlines() if " -c " in line]


def test_the_program_around_solvers_is_compiled_once_for_each_kind(
    fake: Toolchain, tmp_path: Path
) -> None:
    folder = tmp_path / "cache"
    for k in range(3):
        build_executable(f"{SOLVER}{k}", "robot", fake, folder)
    (call,) = objects(fake)
    assert "-O1 -DADAGEN_FLOAT -c " in call
    log = Path(f"{fake.mpicxx[0]}.calls").read_text().splitlines()
    assert len(log) == 4
    assert all("/adagen_program.o -o " in line for line in log if line != call)
    build_executable(SOLVER.replace("FLOAT", "MPI"), "robot", fake, folder)
    build_executable(SOLVER, "robot", replace(fake, flags=("-O2",)), folder)
    assert len(objects(fake)) == 3


def test_the_program_around_solvers_is_optimised_little(fake: Toolchain, tmp_path: Path) -> None:
    build_executable(SOLVER, "robot", replace(fake, flags=("-O3", "-g")), tmp_path / "cache")
    (call,) = objects(fake)
    assert "-O1 -g -DADAGEN_FLOAT -c " in call
    log = Path(f"{fake.mpicxx[0]}.calls").read_text().splitlines()
    assert all("-O3 -g " in line for line in log if line != call)


def test_what_is_a_library_or_no_solver_is_linked_with_nothing(
    fake: Toolchain, tmp_path: Path
) -> None:
    build_executable(f"#define ADAGEN_NO_MAIN\n{SOLVER}", "robot", fake, tmp_path / "cache")
    assert objects(fake) == []


def test_concurrent_builds_share_one_program(fake: Toolchain, tmp_path: Path) -> None:
    folder = tmp_path / "cache"
    with ThreadPoolExecutor(6) as pool:
        texts = [f"{SOLVER}{k}" for k in range(6)]
        built = list(pool.map(lambda text: build_executable(text, "r", fake, folder), texts))
    assert len(set(built)) == 6 and all(path.is_file() for path in built)
    assert len(list(folder.glob("*/adagen_program.o"))) == 1
    assert len(list(folder.iterdir())) == 7


def test_a_damaged_entry_is_built_anew(fake: Toolchain, tmp_path: Path) -> None:
    built = build_executable("hello", "robot", fake, tmp_path / "cache")
    built.unlink()
    assert build_executable("hello", "robot", fake, tmp_path / "cache") == built
    assert says(built) == "hello"


def test_progress_is_shown_for_a_compilation_only(fake: Toolchain, tmp_path: Path) -> None:
    shown: list[str] = []

    @contextmanager
    def progress(doing: str, size: int) -> Iterator[None]:
        assert size == len("hello")
        shown.append(doing)
        yield
        shown.append("done")

    for _ in range(2):
        build_executable("hello", "robot", fake, tmp_path / "cache", progress)
    assert shown == ["compiling robot", "done"]


@pytest.mark.parametrize("name", ["../robot", "", "a/b", "-o", ".", "a b", "a\n"])
def test_a_name_that_is_not_a_file_name_is_refused(
    fake: Toolchain, tmp_path: Path, name: str
) -> None:
    with pytest.raises(ValueError, match="not a file name"):
        build_executable("hello", name, fake, tmp_path / "cache")


def test_a_real_compiler_s_complaint_is_one_line_and_leaves_nothing(tmp_path: Path) -> None:
    source = "int main() { return nonsense; }\n"
    with pytest.raises(EnvironmentFault) as failure:
        build_executable(source, "bad", find_toolchain(), tmp_path / "cache")
    text = str(failure.value)
    assert "bad.cpp:1:" in text and "nonsense" in text
    assert "\n" not in text and str(tmp_path) not in text
    assert list((tmp_path / "cache").iterdir()) == []


def test_a_compiler_that_does_not_work_is_told(fake: Toolchain, tmp_path: Path) -> None:
    Path(fake.mpicxx[0]).write_text("#!/bin/sh\necho cannot find c++ >&2\nexit 1\n")
    with pytest.raises(EnvironmentFault, match=r"cannot find c\+\+.*g\+\+"):
        build_executable("hello", "robot", fake, tmp_path / "cache")
    Path(fake.mpicxx[0]).unlink()
    with pytest.raises(EnvironmentFault, match="cannot run"):
        build_executable("hello", "robot", fake, tmp_path / "cache")


def test_a_compiler_out_of_memory_is_told(fake: Toolchain, tmp_path: Path) -> None:
    script = Path(fake.mpicxx[0])
    script.write_text(
        script.read_text().replace(
            "sleep 0.2",
            "echo 'c++: fatal error: Killed signal terminated program cc1plus' >&2; exit 1",
        )
    )
    with pytest.raises(EnvironmentFault, match="memory ran out"):
        build_executable("hello", "robot", fake, tmp_path / "cache")


def test_a_cache_that_cannot_be_made_is_told(fake: Toolchain, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(EnvironmentFault, match="XDG_CACHE_HOME"):
        build_executable("hello", "robot", fake, tmp_path / "file" / "cache")


def test_the_cache_drops_what_was_unused_for_longest(
    fake: Toolchain, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cache, "KEEP", 2)
    folder = tmp_path / "cache"
    old = [build_executable(f"s{k}", "robot", fake, folder) for k in range(3)]
    for k, built in enumerate(old):
        then = time.time() - 10 * 86400 + k
        os.utime(built.parent, (then, then))
    build_executable("s0", "robot", fake, folder)  # a use makes it the newest
    build_executable("new", "robot", fake, folder)
    left = {entry.name for entry in folder.iterdir()}
    assert old[0].parent.name in left
    assert not {old[1].parent.name, old[2].parent.name} & left


def test_what_was_used_today_stays(
    fake: Toolchain, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cache, "KEEP", 1)
    built = [build_executable(f"s{k}", "robot", fake, tmp_path / "cache") for k in range(3)]
    assert all(executable.exists() for executable in built)


def test_where_the_cache_is(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    assert cache_folder({"XDG_CACHE_HOME": "/x"}) == Path("/x/adagen")
    assert cache_folder({}) == tmp_path / ".cache" / "adagen"
    assert cache_folder({"XDG_CACHE_HOME": "relative"}) == tmp_path / ".cache" / "adagen"
