"""The shared files: malformed ones get what EXPECT.md says, robots their true accelerations."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.errors import InputError
from adagen.model import Model
from adagen.reference import forward_dynamics, joint_space_inertia
from adagen.urdf import read_robot

EXPECTED = {
    # name: ("line" | None, words) of the refusal; or the degrees of freedom and words of a warning
    "truncated": (7, "not well formed"),
    "truncated_between": (7, "not well formed"),
    "truncated_attr": (7, "not well formed"),
    "bomb_entities": (2, "DTD"),
    "cycle_detached": (9, '"c", "d" form a loop'),
    "stray_link": (5, '"stray"'),
    "two_parents": (8, 'link "c" has two parent joints, "j2" and "j3"'),
    "dup_joint": (7, '"j1"'),
    "inf_inertia": (4, "iyy"),
    "overflow_number": (4, "1e400"),
    "gigantic": (4, "1e300"),
    "nan_axis": (5, "finite"),
    "inertia_negative": (4, "not positive definite"),
    "unknown_type": (5, '"hinge"'),
    "type_case": (5, '"Revolute"'),
    "type_missing": (5, "no type"),
    "mimic_self": (5, "mimics itself"),
    "massless_leaf": (7, 'joint "j2" moves no mass'),
    "coaxial_massless": (6, 'joint "j1" can move together with "j2"'),
    "one_link": (2, "nothing to solve"),
    "one_link_massless": (2, "nothing to solve"),
    "sdf": (2, "SDF"),
    "mjcf": (1, "MJCF"),
    "html": (1, "<html> is not <robot>"),
    "gitlfs": (1, "git-lfs"),
    "binary": (1, "not XML"),
    "gzip": (1, "gzip"),
    "bad_utf8": (5, "invalid UTF-8"),
    "num_underscore": (3, "1_000"),
    "num_fullwidth": (3, "not a number"),
    "rpy_four": (3, "4 numbers"),
    "inertia_partial": (4, "iyy, izz"),
    "inertial_no_mass": (4, "without <mass>"),
    "two_inertials": (4, "2 <inertial>"),
    "many_attributes": (1, "nothing to solve"),
    "does_not_exist": (None, "no such file"),
}
ACCEPTED = {
    "inertia_triangle": (1, "triangle inequality"),
    "ok_axis_missing": (1, None),
    "robot_no_name": (2, 'no name: using "robot_no_name"'),
    "names_cpp_injection": (6, None),
    "names_path_traversal": (1, None),
    "names_cpp_keywords": (4, None),
    "ok_utf16": (2, None),
    "num_newline": (2, None),
    "limit_reversed": (2, "lower limit 1 is above the upper one -1"),
    "chain5000": (5000, None),
    "xmlns_default": (2, "the default XML namespace is"),
}


@pytest.mark.parametrize("name", EXPECTED)
def test_malformed_files_are_refused(name: str, shared: Path) -> None:
    line, words = EXPECTED[name]
    with pytest.raises(InputError) as caught:
        read_robot(shared / "bad" / f"{name}.urdf")
    assert caught.value.line == line
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("name", ACCEPTED)
def test_odd_files_are_accepted(name: str, shared: Path) -> None:
    freedom, words = ACCEPTED[name]
    reading = read_robot(shared / "bad" / f"{name}.urdf")
    assert reading.model.nv == freedom
    if words is None:
        assert reading.warnings == ()
    else:
        assert any(words in warning for warning in reading.warnings)


def test_every_file_that_is_expected_something_of_is_tested(shared: Path) -> None:
    table = (shared / "bad" / "EXPECT.md").read_text()
    named = set(re.findall(r"^\| (\w+)\.urdf \|", table, re.MULTILINE))
    assert named == set(EXPECTED) | set(ACCEPTED)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("drakemodels_pr2_simplified", 'parent link "world" is not declared'),
        ("erdgit_falcon", 'child link "Z_propeller" is not declared'),
    ],
)
def test_real_files_that_must_be_refused(name: str, words: str, shared: Path) -> None:
    with pytest.raises(InputError, match=words):
        read_robot(shared / "real" / "refuse" / f"{name}.urdf")


def test_real_and_generated_robots(shared: Path) -> None:
    """Each robot is read or refused as its truth file says, and moves as it says."""
    files = sorted((*shared.glob("real/*.json"), *shared.glob("param/*.json")))
    assert len(files) > 50
    wrong = []
    for file in files:
        for mode, truth in json.loads(file.read_text())["modes"].items():
            problem = _compare(file.with_suffix(".urdf"), mode == "floating", truth)
            if problem:
                wrong.append(f"{file.stem} {mode}: {problem}")
    assert wrong == []


def _compare(path: Path, floating: bool, truth: dict[str, Any]) -> str:
    try:
        model = read_robot(path, floating=floating).model
    except InputError as refusal:
        said = str(refusal)
        if truth["status"].startswith("singular"):
            return "" if "joint-space inertia is singular" in said else said
        if truth["status"] == "no dof":
            return "" if "nothing to solve" in said else said
        return said
    if truth["status"] != "ok":
        return f"accepted, but {truth['status']}"
    if {joint.name for joint in model.joints} != set(truth["joints"]):
        return "joint names differ"
    error = _error(model, truth["joints"])
    reached = truth["check"].get("rel_pin_crba_solve")
    allowed = max(1e-9, 1000 * min(1e-6, reached if isinstance(reached, float) else 0.0))
    return "" if error <= allowed else f"error {error}"


def _error(model: Model, truth: dict[str, Any]) -> float:
    def gather(key: str) -> Any:
        parts = [np.ravel(truth[joint.name][key][0]) for joint in model.joints]
        return np.concatenate(parts).astype(float)

    found = forward_dynamics(model, gather("q"), gather("v"), gather("tau"))
    true = gather("qdd")
    return float(np.max(np.abs(found - true)) / max(1.0, float(np.max(np.abs(true)))))


def test_inertia_is_positive_definite_where_accepted(shared: Path) -> None:
    model = read_robot(shared / "param" / "sem_massless_mid.urdf").model
    q = 0.3 + 0.1 * np.arange(model.nq)
    assert np.linalg.eigvalsh(joint_space_inertia(model, q))[0] > 0
