"""What compilers and sanitizers say of emitted code: nothing."""

from __future__ import annotations

import re
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from adagen.emit.runtime import joined
from adagen.emit.solver_program import options_of, program_text
from adagen.errors import EnvironmentFault
from adagen.states import random_states
from tests.emitted import QUICK, ROUNDING, Builder, Solver, forward_error, states_text, truth_of
from tests.golden.examples import EXAMPLES, FOLDER, Example
from tests.slow import only, slow
from tests.spoilt import SPOILT, spoil

BY_STEM = {example.stem: example for example in EXAMPLES}
SAMPLE = {
    "arm7_slaved_p2": "program",
    "arm7_float_p2": "linked",
    "humanoid_p3": "linked",
    "mobile_p1": "program",
}
PARTS: dict[str, tuple[str, ...]] = {"program": (), "linked": ("-DADAGEN_NO_MAIN",)}
SANITIZED = only(BY_STEM, "arm7_slaved_p2")

clang = pytest.mark.skipif(shutil.which("clang++") is None, reason="clang++ is not installed")


def text(example: Example) -> str:
    return (FOLDER / example.stem / f"{example.stem}.cpp").read_text()


@clang
@pytest.mark.parametrize(
    ("stem", "part"),
    [
        pytest.param(stem, PARTS[part], id=f"{part}-{stem}", marks=marks)
        for stem in BY_STEM
        for part in PARTS
        for marks in [() if SAMPLE.get(stem) == part else pytest.mark.slow]
    ],
)
def test_clang_has_nothing_to_say(stem: str, part: tuple[str, ...], builder: Builder) -> None:
    # Warnings come from the front end; what the linker is told is not used here.
    quiet = ("-Wno-unused-command-line-argument", "-fsyntax-only", *part)
    builder.with_compiler("clang++").check(text(BY_STEM[stem]), stem, quiet)


KINDS = [options_of(mpi, number) for mpi in (False, True) for number in ("double", "float")]


@pytest.mark.parametrize("kind", [*(slow(kind) for kind in KINDS[:-1]), KINDS[-1]])
def test_gcc_has_nothing_to_say_of_the_program(kind: str, builder: Builder) -> None:
    """Of the kind that has most to it, in the quick tests."""
    builder.check(program_text(), "adagen_program", (*kind.split(), *QUICK))


@clang
@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_clang_has_nothing_to_say_of_the_program(kind: str, builder: Builder) -> None:
    """The same with clang++, where quick tests build one of four kinds."""
    flags = ("-Wno-unused-command-line-argument", *kind.split(), *QUICK)
    builder.with_compiler("clang++").check(program_text(), "adagen_program", flags)


def test_a_program_of_another_kind_is_not_linked(builder: Builder) -> None:
    source = text(BY_STEM["mobile_p1"])
    other = re.sub("(// links .*?[.]cpp)", r"\1 -DADAGEN_FLOAT", source, count=1)
    with pytest.raises(EnvironmentFault, match="the compiler failed"):
        builder.compile(other, "mobile_p1")


@pytest.mark.parametrize("stem", BY_STEM)
def test_solvers_of_one_name_share_nothing_in_a_program(stem: str, builder: Builder) -> None:
    """A constant of C++17 that is "unique" is that of the first library that was loaded."""
    made = builder.compile(text(BY_STEM[stem]), stem)  # as the examples are run
    lines = subprocess.run(["nm", "-gC", "--defined-only", made], capture_output=True, text=True)
    kinds = [line.split(maxsplit=2)[1:] for line in lines.stdout.splitlines()]
    assert any(name.startswith(f"{stem}_solve") for _, name in kinds)
    assert [name for kind, name in kinds if kind == "u" and stem in name] == []


@pytest.mark.parametrize("stem", BY_STEM)
def test_eigen_is_included_where_it_is_used(stem: str) -> None:
    source = joined(text(BY_STEM[stem]))
    assert ("#include <Eigen/" in source) == ("Eigen::" in source)


BUILT_BY_CLANG = ("arm7_unrolled_p1", "humanoid_lanes_p1", "fourbar_p1")
"""Straight lines, lanes, closed loops."""


@clang
@pytest.mark.parametrize(
    "stem",
    only(BY_STEM, *BUILT_BY_CLANG),
)
def test_what_clang_builds_is_right(stem: str, builder: Builder, tmp_path: Path) -> None:
    """Each program checks itself; answers of open trees are compared with exact ones, too."""
    example = BY_STEM[stem]
    executable = builder.with_compiler("clang++").compile(text(example), stem)
    assert_right(example, Solver(executable, example.processes, builder.toolchain), tmp_path)


def assert_right(example: Example, solver: Solver, folder: Path, *words: str) -> None:
    done = solver.run("--check", "--seed", "3", *words)
    assert (done.status, done.stderr) == (0, "")
    if example.closed:  # checked by what closes it
        return
    states = random_states(example.model(), 3)
    found = solver.solve(example.model(), states, folder, *words)
    scalar = "float" if example.scalar == "float" else "double"
    assert forward_error(found, truth_of(example.model(), states)) < ROUNDING[scalar]


def test_gcc_has_nothing_to_say_under_other_flags(builder: Builder) -> None:
    flags = [flag for flag in QUICK if flag not in ("-DNDEBUG", "-march=native")]
    builder.check(text(BY_STEM["arm7_slaved_p2"]), "other", ("-fmax-errors=3", *flags))


class TestSanitizers:
    """-fsanitize=address,undefined; without NDEBUG, so that Eigen's own checks speak too."""

    FLAGS = ("-O0", "-march=native", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")

    @pytest.fixture(params=SANITIZED)
    def example(self, request: pytest.FixtureRequest) -> Example:
        return BY_STEM[request.param]

    @pytest.fixture
    def solver(self, example: Example, builder: Builder) -> Solver:
        executable = builder.compile(text(example), example.stem, self.FLAGS)
        # Leaks of Open MPI's own are not of interest.
        options = ("ASAN_OPTIONS", "detect_leaks=0:abort_on_error=1")
        environment = (*builder.toolchain.environment, options)
        return Solver(
            executable, example.processes, replace(builder.toolchain, environment=environment)
        )

    @pytest.mark.parametrize("channel", ["window", "message"])
    def test_a_full_run_is_clean(
        self, example: Example, solver: Solver, channel: str, tmp_path: Path
    ) -> None:
        assert_right(example, solver, tmp_path, "--time", "--repeat", "1", "--channel", channel)

    def test_refused_states_are_refused_cleanly(
        self, example: Example, solver: Solver, tmp_path: Path
    ) -> None:
        model = example.model()
        good = states_text(model, random_states(model, 2), tmp_path)
        for case in SPOILT[::3]:
            path = spoil(case, good, model.joints[0].name, tmp_path)
            done = solver.run("--states", path)
            assert (done.status, done.stdout) == (1, ""), case.name
            assert "error: " in done.stderr and "anitizer" not in done.stderr, case.name
