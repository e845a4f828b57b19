"""Hostile names neither break emitted code nor enter it."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.emit import emit
from adagen.emit.names import identifiers
from adagen.emit.runtime import runtime_files
from adagen.model import Model
from adagen.plan import FORMS, Plan, make_plan
from adagen.states import random_states, write_states
from adagen.urdf import read_robot
from tests.emitted import ROUNDING, Builder, plan_of
from tests.models import random_tree
from tests.schedules import random_schedule
from tests.slow import all_but, slow

NAMES = (
    'quote"; int evil = 1; //',
    "ends in a backslash \\",
    "/* opens */ and closes */",
    "new\nline\r\n#include <cstdlib>\n",
    "class",
    "EOF",
    "linux",
    "MPI_COMM_WORLD",
    "Knöchel 関節 \U0001f9be",
    "what??/",
    "A",  # kernels and joints call a side so
    "B",
    "a",
    "b",
    "a_b",  # meets the block between a and b
    "OK",  # F_OK and R_OK are macros of unistd.h
    "x" * 300,
    "x" * 300 + "y",  # meets the one before once it is cut
    "{{ jinja }} {% raw %}",
    "%s%n %d",
    "tab\tbell\a\x7f",
    "..",
    "_",
    "__base__2",
)
LINKS = (*NAMES[10:], *NAMES[:10], "errno")


def hostile(names: tuple[str, ...] = NAMES, links: tuple[str, ...] = LINKS) -> Model:
    """Return a tree whose joints and links have the names."""
    model = random_tree(np.random.default_rng(8), len(names), branching=0.5)
    return replace(
        model,
        name='robot "\\',
        joints=tuple(replace(j, name=n) for j, n in zip(model.joints, names, strict=True)),
        links=tuple(replace(k, name=n) for k, n in zip(model.links, links, strict=True)),
    )


def plan(model: Model, form: str = "ada") -> Plan:
    return make_plan(model, random_schedule(model, 2, np.random.default_rng(2)), form=form)


def bare(text: str) -> list[str]:
    """Return the lines of a source without what string literals and comments hold.

    Comments are left out whole: how many lines names fill in them depends on their length.
    """
    literal = r'"(?:\\.|[^"\\\n])*"'
    lines = []
    for line in text.splitlines():
        code = re.sub(rf"({literal})|//.*", lambda m: '""' if m.group(1) else "//", line)
        if code.strip() != "//":
            lines.append(code)
    return lines


def joining(text: str) -> list[str]:
    """Return the lines that go on in the next one: a macro of the runtime, and no others."""
    return [line for line in text.splitlines() if line.endswith("\\")]


@pytest.mark.parametrize("form", FORMS)
def test_of_a_name_nothing_but_its_cleaned_word_is_code(form: str) -> None:
    wild = emit(plan(hostile(), form), name="same")["same_p2.cpp"]
    tame = emit(plan(hostile(identifiers(NAMES), identifiers(LINKS)), form), name="same")[
        "same_p2.cpp"
    ]
    assert bare(wild) == bare(tame)
    assert wild.isascii() and "??" not in wild
    assert joining(wild) == joining(tame)  # a backslash joins lines, comments too


@pytest.mark.parametrize("form", all_but(FORMS, "ada"))
def test_a_robot_of_hostile_names_is_built_and_solved(
    form: str, builder: Builder, tmp_path: Path
) -> None:
    model = hostile()
    solver = builder.solver(plan(model, form), name="hostile")
    states = random_states(model, 2, seed=4)
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]


def test_a_failure_names_a_hostile_joint_in_one_line(builder: Builder, tmp_path: Path) -> None:
    model = hostile()
    states = random_states(model, 1)
    turning = next(j for j, joint in enumerate(model.joints) if joint.kind.name == "spherical")
    states.v[0, model.v_start[turning]] = 1e300
    write_states(states, model, tmp_path / "s.json")
    done = builder.solver(plan(model), name="hostile").run("--states", tmp_path / "s.json")
    assert done.status == 1
    assert done.stdout == ""
    (line,) = done.stderr.splitlines()
    assert line.startswith(f"{tmp_path}/s.json: error: state 1: joint ")


@pytest.mark.parametrize("name", ["cpp_injection", slow("cpp_keywords"), "path_traversal"])
def test_the_shared_hostile_robots_are_built_and_right(
    name: str, shared: Path, builder: Builder, tmp_path: Path
) -> None:
    model = read_robot(shared / "bad" / f"names_{name}.urdf").model
    made = plan_of(model, 2)
    for file in emit(made).keys() - runtime_files().keys():
        assert re.fullmatch(r"Makefile|[A-Za-z0-9][A-Za-z0-9_-]*(\.[a-z]+)+", file)
    states = random_states(model, 2)
    solver = builder.solver(made)
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]
    assert not Path("/tmp/adagen_pwned").exists()
