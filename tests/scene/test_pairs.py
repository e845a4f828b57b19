"""Frame pairs in YAML that close loops."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.errors import InputError
from adagen.library import Robot, read
from tests.loops import alike
from tests.urdf.texts import joint, link, robot

Read = Callable[..., Robot]

SCREW = '<origin xyz="0 0 0.3" rpy="0.1 0.2 0.3"/>'
ROBOT = robot(
    *(link(name) for name in ("a", "b", "c", "d", "e", "tip")),
    joint("j1", "a", "b"),
    joint("j2", "b", "c"),
    joint("j3", "c", "d"),
    joint("to_tip", "d", "tip", "fixed", "", SCREW),
    joint("j4", "a", "e"),
    link("far"),
    joint("to_far", "c", "far", "fixed", "", '<origin xyz="0 0 5"/>'),
)


@pytest.fixture
def closed(tmp_path: Path) -> Read:
    """Reads the robot with a file of frame pairs."""

    def reader(text: str | bytes, urdf: str = ROBOT, **options: Any) -> Robot:
        (tmp_path / "robot.urdf").write_text(urdf)
        path = tmp_path / "loops.yaml"
        path.write_bytes(text.encode() if isinstance(text, str) else text)
        return read(tmp_path / "robot.urdf", loops=path, **options)

    return reader


@pytest.mark.parametrize("frames", ["[tip, e]", "[to_tip, j4]", "['to_tip', \"e\"]"])
@pytest.mark.parametrize(
    ("kind", "name"), [("6d", "weld"), ("6D", "weld"), ("3d", "spherical"), ("'3D'", "spherical")]
)
def test_frames_are_links_or_the_child_links_of_joints(
    frames: str, kind: str, name: str, closed: Read
) -> None:
    model = closed(f"closed_loop: [{frames}]\ntype: [{kind}]\nname_mot: [j1]\n").model
    (found,) = model.loops
    ends = frames.strip("[]").replace("'", "").replace('"', "").replace(", ", "-")
    assert (found.name, found.kind.name, found.link1, found.link2) == (ends, name, 3, 4)
    frame = next(frame for frame in model.links[3].frames if frame.name == "tip")
    assert np.allclose(found.frame1.rotation, frame.rotation)
    assert np.allclose(found.frame1.translation, frame.translation)
    assert not found.frame2.translation.any()


def test_a_pair_without_a_type_is_held_in_six_directions(closed: Read) -> None:
    assert [loop.kind.name for loop in closed("closed_loop: [[tip, e]]").model.loops] == ["weld"]


def test_the_universe_is_the_ground(closed: Read) -> None:
    (found,) = closed("closed_loop: [[tip, universe]]\ntype: [3d]").model.loops
    assert found.link2 == 0


def test_what_was_read_is_told(closed: Read) -> None:
    reading = closed("closed_loop: [[tip, e]]\njoint_name: [j2]\njoint_type: [SPHERICAL]").reading
    assert [line.partition("loops.yaml: ")[2] for line in reading.mentions] == [
        'loops: 1, read: "tip-e" (weld)', 'joints of other kinds: "j2" (SPHERICAL)',
    ]  # fmt: skip


def test_joints_are_of_the_kinds_that_the_file_says(closed: Read) -> None:
    text = "joint_name: [j2, j4, to_tip]\njoint_type: [SPHERICAL, fixed, FIXED]\n"
    model = closed(text).model
    assert [(each.name, each.kind.name) for each in model.joints] == [
        ("j1", "revolute"), ("j2", "spherical"), ("j3", "revolute"),
    ]  # fmt: skip
    assert "e" in model.links[0].merged


def test_a_universal_joint_is_two_hinges_and_a_cross_without_mass(closed: Read) -> None:
    text = "closed_loop: [[j2_Z, eye], [j2, eye]]\njoint_name: [j2]\njoint_type: [ujoint_zx]"
    eye = link("eye") + joint("to_eye", "e", "eye", "fixed", "")
    model = closed(text, ROBOT.replace("</robot>", f"{eye}</robot>")).model
    _, first, second, after, _ = model.joints
    assert (first.name, second.name, after.name) == ("j2_Z", "j2_X", "j3")
    assert [each.axis.tolist() for each in (first, second)] == [[0, 0, 1], [1, 0, 0]]
    assert (first.parent, second.parent, after.parent) == (1, 2, 3)
    assert not second.translation.any() and (second.rotation == np.eye(3)).all()
    assert model.links[2].inertia.mass == 0.0 and model.links[3].name == "c"
    assert [(loop.link1, loop.link2) for loop in model.loops] == [(2, 5), (3, 5)]


def test_a_second_hinge_moves_what_hangs_on_it(closed: Read) -> None:
    """Loops, mimics and couplings go on to be between the same links and joints."""
    gear = """<coupling name="gear"><predecessor link="d"/><successor link="e"/>
      <ratio value="2"/></coupling>""".replace("\n", "")
    urdf = ROBOT.replace("</robot>", f"{gear}</robot>")
    plain = closed("closed_loop: [[tip, e]]", ROBOT).model
    assert (plain.loops[0].link1, plain.loops[0].link2) == (3, 4)
    model = closed(
        "closed_loop: [[tip, e]]\njoint_name: [j2]\njoint_type: [UJOINT_XY]", ROBOT
    ).model
    assert (model.loops[0].link1, model.loops[0].link2) == (4, 5)
    assert model.links[4].name == "d" and model.joints[4].name == "j4"
    with pytest.raises(InputError, match="joint 'j2' is coupled"):
        closed("joint_name: [j2]\njoint_type: [UJOINT_XY]", urdf)


CASES = {
    # name: (text, line, words)
    "no yaml": ("closed_loop: [", 1, "not YAML: "),
    "text": ("hello", None, "no mapping with closed_loop"),
    "empty": ("", None, "no mapping with closed_loop"),
    "binary": (b"closed_loop: \xff", 1, "not UTF-8 text"),
    "unknown key": ("closed_loops: []", 1, "unknown key 'closed_loops'; did you mean 'closed_l"),
    "key twice": ("type: []\ntype: []", 2, "'type' is given twice"),
    "no list": ("closed_loop: tip", 1, "closed_loop needs a list"),
    "no pair": ("closed_loop:\n- [tip, e]\n- [tip]", 3, "pairs of frames"),
    "no name": ("closed_loop: [[tip, [e]]]", 1, "a name is expected"),
    "pair twice": ("closed_loop:\n- [tip, e]\n- [tip, e]", 3, "pair 'tip-e' is given twice"),
    "types too few": ("closed_loop: [[tip, e], [d, e]]\ntype: [6d]", 2, "1 types for 2 pairs"),
    "unknown type": ("closed_loop: [[tip, e]]\ntype:\n- 5d", 3, "unknown type '5d' of a pair"),
    "unknown frame": ("closed_loop: [[tip,\n ee]]", 2, "'ee' is neither a link nor a joint"),
    "out of reach": (
        "closed_loop: [[far, universe]]\ntype: [3d]", 1,
        "loop 'far-universe' cannot close: one of its links spans 5 m, all others together 0.4 m",
    ),
    "open for ever": ("closed_loop: [[tip, d]]", 1, "loop 'tip-d' cannot close: its links are"),
    "unknown joint": ("joint_name: [j9]\njoint_type: [FIXED]", 1, "'j9' is not a joint"),
    "no joint types": ("joint_name: [j1]", 1, "1 names in joint_name, 0 in joint_type"),
    "cardan": (
        "joint_name: [j1]\njoint_type: [CARDAN]", 2,
        "joint 'j1' is revolute, and CARDAN is asked for",
    ),
    "one axis twice": ("joint_name: [j1]\njoint_type: [UJOINT_XX]", 2, "UJOINT_XX is asked for"),
    "cross of a fixed joint": (
        "joint_name: [to_tip]\njoint_type: [UJOINT_XY]", 2, "joint 'to_tip' is fixed",
    ),
    "ball of a fixed joint": (
        "joint_name: [to_tip]\njoint_type: [SPHERICAL]", 2, "joint 'to_tip' is fixed",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_slips_are_refused_by_line(case: str, closed: Read) -> None:
    text, line, words = CASES[case]
    with pytest.raises(InputError) as caught:
        closed(text)
    assert caught.value.line == line and str(caught.value.file).endswith("loops.yaml")
    assert words in str(caught.value) and "\n" not in str(caught.value)


def test_nesting_and_aliases_do_no_harm(closed: Read) -> None:
    for text in ("closed_loop: " + "[" * 5000, "closed_loop: &a [*a, *a]", "a: &a\n- *b"):
        with pytest.raises(InputError):
            closed(text)


def test_a_name_of_two_things_is_refused(closed: Read) -> None:
    with pytest.raises(InputError, match="'e' is a link, and a joint whose child link is 'b'"):
        closed("closed_loop: [[tip, e]]", urdf=ROBOT.replace('"j1"', '"e"'))


def test_a_mimicked_joint_stays_what_it_is(closed: Read) -> None:
    mimic = ROBOT.replace('<child link="e"/>', '<child link="e"/><mimic joint="j1"/>')
    with pytest.raises(InputError, match="joint 'j1' mimics or is mimicked"):
        closed("joint_name: [j1]\njoint_type: [FIXED]", mimic, mimic=True)


def test_a_scene_works_on_what_the_pairs_close(closed: Read, tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text("lock = { j1 = 0.5 }\n")
    model = closed("closed_loop: [[tip, e]]", scene=str(scene)).model
    assert len(model.joints) == 3 and len(model.loops) == 1
    scene.write_text('[[loops]]\nname = "tip-e"\nkind = "weld"\nlink1 = "c"\nlink2 = "e"\n')
    with pytest.raises(InputError, match="the robot has a loop 'tip-e'") as caught:
        closed("closed_loop: [[tip, e]]", scene=str(scene))
    assert caught.value.line == 1


@pytest.mark.parametrize(
    "name", ["gep_5bar", "gep_5bar3d", "gep_cassie_leg", "gep_delta", "gep_talos_2legs"]
)
def test_pairs_are_the_same_loops_as_a_scenes(name: str, shared: Path) -> None:
    stem = shared / "loops" / name
    urdf = stem.with_suffix(".urdf")
    scene = read(urdf, scene=stem.with_suffix(".scene.toml")).model
    alike(read(urdf, loops=stem.with_suffix(".yaml")).model, scene)
