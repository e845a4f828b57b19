"""Embedded solvers: no heap, no C++ runtime, memory of the caller's, and the same answers."""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import adagen
from adagen.atomic_files import write_files
from adagen.cli import main
from adagen.emit.runtime import runtime_files
from adagen.errors import UsageError
from adagen.states import States, random_states
from tests.emitted import EXACT, ROUNDING, Builder, Solver, forward_error, truth_of
from tests.end_to_end.test_library import HERE, STRICT, filled, run
from tests.golden.make_models import MODELS
from tests.real import real_robot
from tests.slow import all_but, only, slow

ALLOWED = {
    "memcpy",
    "memmove",
    "memset",
    "sin",
    "cos",
    "sincos",  # what g++ makes of both where the C library is glibc
    "sqrt",
    "floor",
    "copysign",
    "_GLOBAL_OFFSET_TABLE_",
}
"""What a solver may ask of others: copies, and functions of libm."""
ALONE = (
    "-fno-delete-null-pointer-checks",
    "-ffreestanding",
    "-fno-exceptions",
    "-fno-rtti",
    "-fno-threadsafe-statics",
)
CASES: dict[str, tuple[str, dict[str, Any]]] = {
    "arm": ("arm7", {"shape": "unrolled"}),
    "arm of floats": ("arm7", {"shape": "unrolled", "scalar": "float"}),
    "humanoid in lanes": ("humanoid", {"shape": "unrolled"}),
    "quaternions": ("mobile", {"shape": "kernels"}),
    "quaternions of floats": ("mobile", {"shape": "kernels", "scalar": "float"}),
    "parameters": ("mobile", {"shape": "unrolled", "runtime": "gravity,mass:lifted"}),
    "panda": ("panda_description/urdf/panda.urdf", {"shape": "unrolled"}),
    "panda of floats": ("panda_description/urdf/panda.urdf", {"scalar": "float"}),
    "talos": ("talos_data/robots/talos_reduced.urdf", {"shape": "kernels"}),
    "solo12": ("solo_description/robots/solo12.urdf", {"shape": "unrolled", "scalar": "float"}),
}


def robot(case: str) -> adagen.Robot:
    path = CASES[case][0]
    floating = path.startswith(("talos", "solo", "human"))
    if "/" in path:
        return adagen.read(real_robot(path), floating=floating)
    return adagen.read(MODELS / f"{path}.urdf", floating=floating)


def compiled_for(target: str, case: str) -> adagen.Compiled:
    asked = dict(CASES[case][1])
    if "runtime" in asked:
        links = robot(case).model.links
        asked["runtime"] = f"gravity,mass:{links[-1].name},center:{links[-1].name}"
    return adagen.compile(robot(case), target=target, name="own", **asked)


def object_of(compiled: adagen.Compiled, builder: Builder, folder: Path) -> Path:
    """Return the object of an embedded solver, compiled as for a machine without a system."""
    write_files(folder, compiled.files)
    made = folder / "own_p1.o"
    flags = ("-std=c++17", *STRICT, *EXACT, *ALONE, "-Wno-psabi")
    run(*builder.toolchain.cxx, *flags, "-c", folder / "own_p1.cpp", "-o", made)
    return made


@pytest.mark.parametrize("case", all_but(CASES, "panda", "talos"))
def test_it_stands_alone_and_answers_as_ever(case: str, builder: Builder, tmp_path: Path) -> None:
    compiled = compiled_for("embedded", case)
    own = {f"own_p1.{end}" for end in ("cpp", "h", "plan.json", "svg")}
    assert set(compiled.files) == own | set(runtime_files())
    made = object_of(compiled, builder, tmp_path)
    wanted = {line.split()[-1] for line in run("nm", "-u", made).splitlines()}
    real = "float" if CASES[case][1].get("scalar") == "float" else "double"
    assert {name.removesuffix("f") if real == "float" else name for name in wanted} <= ALLOWED
    assert not re.search(r"_GLOBAL__sub_I|_ZGV", run("nm", made))  # nothing runs before main

    (tmp_path / "main.c").write_text(filled("embedded.c", "own_p1", NUMBER=real))
    program = tmp_path / "program"
    run("cc", "-std=c99", *STRICT, tmp_path / "main.c", made, "-lm", "-o", program)
    model = compiled.model
    states = random_states(model, 4, seed=8)
    rows = [np.concatenate(row) for row in states.each]
    spoilt = rows[0].copy()
    spoilt[-1] = np.nan
    far = rows[0].copy()  # an angle that is left to the C library
    turned = next(
        start
        for joint, start in zip(model.joints, model.q_start, strict=True)
        if joint.kind.name == "revolute"
    )
    far[turned] = 3e5
    np.savetxt(tmp_path / "states", [*rows, spoilt, far], fmt="%.17g")
    small, *lines, said, beyond = run(program, tmp_path / "states").splitlines()
    assert small == "the memory is too small for a solver"
    assert said == (
        f'1 {len(model.joints) - 1} joint "{model.joints[-1].name}": '
        "its q, v or tau is not a finite number"
    )
    found = np.array([line.split() for line in [*lines, beyond]], dtype=float)
    everything = States(*(np.vstack([part, part[:1]]) for part in states.parts))
    everything.q[-1, turned] = 3e5
    everything = everything.read_in(real)
    enough = (40 if "/" in CASES[case][0] else 4) * ROUNDING[real]
    assert forward_error(found, truth_of(model, everything)) < enough
    if real == "double":
        assert np.array_equal(found, of_host(case, builder).solve(model, everything, tmp_path))


BARE = ("-O2", *ALONE, "-ffunction-sections")
CORTEX_M7 = ("-mcpu=cortex-m7", "-mthumb", "-mfpu=fpv5-d16", "-mfloat-abi=hard")


@pytest.mark.parametrize(
    "case",
    only(CASES, "arm"),
)
def test_a_cortex_m7_answers_as_the_host_does(case: str, builder: Builder, tmp_path: Path) -> None:
    """Emulated, with newlib below it: what it reads and prints are files of the host."""
    for tool in ("arm-none-eabi-g++", "qemu-system-arm"):
        if shutil.which(tool) is None:
            pytest.skip(f"{tool} is not installed: see docs/how_to/embedded.md")
    compiled = compiled_for("embedded", case)
    write_files(tmp_path, compiled.files)
    real = "float" if CASES[case][1].get("scalar") == "float" else "double"
    (tmp_path / "main.c").write_text(filled("embedded.c", "own_p1", NUMBER=real))
    made = (tmp_path / "own_p1.o", tmp_path / "own_host.o")
    strict = ("-std=c++17", *STRICT, "-Wno-psabi", *BARE, "-ffp-contract=off", "-c")
    run("arm-none-eabi-g++", *strict, *CORTEX_M7, tmp_path / "own_p1.cpp", "-o", made[0])
    run(*builder.toolchain.cxx, *strict, tmp_path / "own_p1.cpp", "-o", made[1])
    board = HERE / "cortex_m7"
    start = (board / "start.c", f"-T{board / 'board.ld'}", "--specs=rdimon.specs")
    image, program = tmp_path / "image", tmp_path / "program"
    given = ("-std=c99", "-O1", f"-I{tmp_path}", tmp_path / "main.c")
    run("arm-none-eabi-gcc", *CORTEX_M7, *given, made[0], *start, "-lm", "-o", image)
    run("cc", *given, made[1], "-lm", "-o", program)

    states = random_states(compiled.model, 8, seed=8)
    rows = [np.concatenate(row) for row in states.each]
    spoilt = rows[0].copy()
    spoilt[-1] = np.nan
    np.savetxt(tmp_path / "states", [*rows, spoilt], fmt="%.17g")
    words = f"enable=on,target=native,arg=image,arg={tmp_path / 'states'}"
    machine = ("qemu-system-arm", "-M", "mps2-an500", "-nographic", "-monitor", "none")
    said = run(*machine, "-serial", "none", "-semihosting-config", words, "-kernel", image)
    assert len(said.splitlines()) == 10
    assert said == run(program, tmp_path / "states")


def of_host(case: str, builder: Builder) -> Solver:
    """Return the same solver for a host."""
    compiled = compiled_for("host", case)
    executable = builder.compile(compiled.source, compiled.stem, EXACT)
    return Solver(executable, 1, builder.toolchain)


def test_friction_in_floats_takes_tangents_of_floats(builder: Builder, tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text("friction = 0.1\n")
    whole = adagen.read(MODELS / "arm7.urdf", scene=scene)
    rubbing = adagen.compile(whole, target="embedded", name="own", scalar="float", shape="unrolled")
    wanted = run("nm", "-u", object_of(rubbing, builder, tmp_path)).split()
    assert "tanhf" in wanted and "tanh" not in wanted


def test_friction_in_doubles_takes_tangents_of_its_own(builder: Builder, tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text("friction = 0.1\n")
    whole = adagen.read(MODELS / "arm7.urdf", scene=scene)
    for shape in ("unrolled", "kernels"):
        rubbing = adagen.compile(whole, target="embedded", name="own", shape=shape)
        assert (
            set(run("nm", "-u", object_of(rubbing, builder, tmp_path)).split()) - {"U"} <= ALLOWED
        )


def test_floats_compute_in_floats_alone(builder: Builder, tmp_path: Path) -> None:
    made = object_of(compiled_for("embedded", "panda of floats"), builder, tmp_path)
    assert not re.search(r"cvtss2sd|mulsd|fcvt\s+d", run("objdump", "-d", made))


@pytest.mark.parametrize("case", ["arm", "humanoid in lanes", "quaternions", slow("talos")])
def test_its_memory_is_what_the_head_says(case: str, builder: Builder) -> None:
    compiled = compiled_for("embedded", case)
    found = re.search(r"at most (\d+) bytes", compiled.source)
    assert found
    assert f"OWN_P1_BYTES = {found[1]}" in compiled.header
    probe = "int main() { return sizeof(own_p1_solver) * 4 < 3 * OWN_P1_BYTES; }\n"
    program = builder.compile(f"{compiled.header}{compiled.source}{probe}", "probe", EXACT)
    run(program)  # no more is asked for than four thirds of what is needed


@pytest.mark.parametrize("scalar", ["double", "float"])
def test_there_is_memory_for_a_body_and_what_a_scene_wants_of_it(
    scalar: str, builder: Builder, tmp_path: Path
) -> None:
    """Without an angle, and with results that fill whole lines: the source tells if it is short."""
    inertia = '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
    body = f'<link name="body"><inertial><mass value="1"/>{inertia}</inertial></link>'
    path, scene = tmp_path / "body.urdf", tmp_path / "scene.toml"
    path.write_text(f'<robot name="body">{body}</robot>')
    scene.write_text('[outputs]\nreaction_forces = ["__base__"]\ninverse_inertia = ["body"]\n')
    alone = adagen.read(path, floating=True, scene=scene)
    asked: dict[str, Any] = {
        "target": "embedded",
        "scalar": scalar,
        "name": "own",
        "shape": "unrolled",
    }
    for runtime in ("", "gravity"):
        object_of(adagen.compile(alone, runtime=runtime, **asked), builder, tmp_path)


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ({"procs": 2}, "one process and one state at a time"),
        ({"batch": True}, "one process and one state at a time"),
        ({"refine": 1}, "does not refine"),
        ({"single_file": True}, "has no program around it"),
        ({"form": "ada", "shape": "joints"}, "needs Eigen here"),
        ({"target": "moon"}, "target is one of host, embedded"),
    ],
)
def test_what_cannot_be_had_is_told(asked: dict[str, Any], said: str) -> None:
    with pytest.raises(UsageError, match=said):
        adagen.compile(adagen.read(MODELS / "arm7.urdf"), **{"target": "embedded", **asked})


def test_the_command_line_writes_one_and_verifies_it(tmp_path: Path) -> None:
    asked = [str(MODELS / "arm7.urdf"), "--target", "embedded", "--out", str(tmp_path)]
    assert main(asked) == 0
    written = {path.name for path in tmp_path.iterdir()}
    assert written == {"adagen", *(f"arm7_p1.{end}" for end in ("cpp", "h", "plan.json", "svg"))}
    assert main(["verify", str(tmp_path)]) == 0
    assert main([*asked, "--procs", "2"]) == 2


def test_cmake_makes_a_library_and_make_leaves_it_alone(tmp_path: Path) -> None:
    shutil.copy(MODELS / "chain16.urdf", tmp_path)
    (tmp_path / "main.c").write_text(filled("embedded.c", "arm_p1", NUMBER="double"))
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.16)\nproject(controller LANGUAGES C CXX)\n"
        "find_package(adagen REQUIRED)\n"
        "adagen_add_solver(arm MODEL chain16.urdf OPTIONS --target embedded)\n"
        "add_executable(controller main.c)\ntarget_link_libraries(controller PRIVATE arm m)\n"
    )
    command = Path(sys.executable).with_name("adagen")
    folder, build = run(command, "--cmake-dir").strip(), tmp_path / "build"
    words = ("-DADAGEN_FLAGS=-O1;-fno-exceptions", f"-DADAGEN_PROGRAM={command}")
    run("cmake", "-S", tmp_path, "-B", build, f"-Dadagen_DIR={folder}", *words)
    run("cmake", "--build", build)
    (tmp_path / "states").write_text("0 " * 48)
    told, found = run(build / "controller", tmp_path / "states").splitlines()
    assert told == "the memory is too small for a solver"
    assert len(found.split()) == 16

    assert main([str(MODELS / "mobile.urdf"), "--procs", "1", "--out", str(build / "arm")]) == 0
    said = run("make", "-C", build / "arm", "-n", "all")
    assert "mobile_p1" in said
    assert "arm_p1" not in said
