"""A ROS 2 workspace: one package has its solver emitted, another one finds and links it."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.end_to_end.test_folders import FAST, check, run
from tests.end_to_end.test_library import filled
from tests.golden.examples import FOLDER

PACKAGE = """\
<?xml version="1.0"?>
<package format="3">
  <name>{name}</name>
  <version>0.1.0</version>
  <description>A test of adagen</description>
  <maintainer email="nobody@example.org">nobody</maintainer>
  <license>BSD-3-Clause</license>
  <buildtool_depend>cmake</buildtool_depend>{depends}
  <export><build_type>cmake</build_type></export>
</package>
"""
SOLVER = """\
cmake_minimum_required(VERSION 3.16)
project(mobile_solver LANGUAGES CXX)
find_package(adagen REQUIRED)
adagen_add_solver(mobile MODEL mobile.urdf PROCS 1 OPTIONS --shape kernels)
"""
CONTROLLER = """\
cmake_minimum_required(VERSION 3.16)
project(controller LANGUAGES C CXX)
find_package(mobile_p1 REQUIRED)
add_executable(controller controller.c)
target_link_libraries(controller PRIVATE adagen::mobile_p1)
install(TARGETS controller DESTINATION lib/controller)
"""


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """A folder with packages of a solver and of a controller."""
    for name, depends, project in (
        ("mobile_solver", "", SOLVER),
        ("controller", "\n  <depend>mobile_solver</depend>", CONTROLLER),
    ):
        folder = tmp_path / "src" / name
        folder.mkdir(parents=True)
        (folder / "package.xml").write_text(PACKAGE.format(name=name, depends=depends))
        (folder / "CMakeLists.txt").write_text(project)
    shutil.copy(FOLDER / "models" / "mobile.urdf", tmp_path / "src" / "mobile_solver")
    text = filled("controller.c", "mobile_p1")
    (tmp_path / "src" / "controller" / "controller.c").write_text(text)
    return tmp_path


def colcon(workspace: Path) -> subprocess.CompletedProcess[str]:
    """Build a workspace as its user does, in the workspace."""
    tools = Path(sys.executable).parent
    folder = run(tools / "adagen", "--cmake-dir").strip()
    settings = (f"-Dadagen_DIR={folder}", f"-DADAGEN_PROGRAM={tools / 'adagen'}", FAST)
    words = (tools / "colcon", "build", "--base-paths", "src", "--cmake-args", *settings)
    return subprocess.run(
        [str(word) for word in words], cwd=workspace, capture_output=True, text=True, timeout=300
    )


def test_colcon_builds_a_solver_and_what_links_it(workspace: Path) -> None:
    done = colcon(workspace)
    assert done.returncode == 0, done.stdout + done.stderr
    check(workspace / "install" / "controller" / "lib" / "controller" / "controller", workspace)


@pytest.mark.slow
def test_a_project_without_cpp_is_told_what_it_lacks(workspace: Path) -> None:
    """Of a static library, which leaves the C++ library to whoever links it."""
    project = workspace / "src" / "controller" / "CMakeLists.txt"
    project.write_text(CONTROLLER.replace("LANGUAGES C CXX", "LANGUAGES C"))
    done = colcon(workspace)
    assert done.returncode != 0
    said = " ".join(done.stderr.split())  # CMake wraps lines
    assert "it is a static library of C++: say project(... LANGUAGES C CXX)" in said
