"""<loop> and <coupling> of URDF+, and joints to links that have a parent joint already."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from adagen.library import read as read_with_scene
from adagen.urdf import Reading, read_robot
from tests.loops import alike
from tests.urdf.texts import Y, joint, link, robot

Read = Callable[..., Reading]
Refusal = Callable[..., str]

LINKS = [link(name) for name in "abcd"]
CHAIN = [joint("j1", "a", "b"), joint("j2", "b", "c"), joint("j3", "a", "d")]
"""Links in lines 3 to 6, joints in lines 7 to 9: a carries b, which carries c; and d."""


def chain(*more: str) -> str:
    """The robot, with elements from line 10 on."""
    return robot(*LINKS, *CHAIN, *more)


def loop(
    said: str = 'name="l" type="revolute"',
    first: str = '<predecessor link="c"><origin xyz="0 0 0.3"/></predecessor>',
    second: str = '<successor link="d"><origin xyz="0.1 0 0.2" rpy="0 0.5 0"/></successor>',
    axis: str = Y,
) -> str:
    return f"<loop {said}>{first}{second}{axis}</loop>\n"


def coupling(
    said: str = 'name="k"', first: str = "c", second: str = "d", ratio: str = '<ratio value="6"/>'
) -> str:
    ends = f'<predecessor link="{first}"/><successor link="{second}"/>'
    return f"<coupling {said}>{ends}{ratio}</coupling>\n"


@pytest.mark.parametrize(
    ("said", "kind"),
    [
        ("revolute", "revolute"), ("continuous", "revolute"), ("prismatic", "prismatic"),
        ("fixed", "weld"), ("weld", "weld"), ("spherical", "spherical"), ("ball", "spherical"),
        ("point", "spherical"), ("planar", "planar"), ("cylindrical", "cylindrical"),
    ],
)  # fmt: skip
def test_a_loop_is_a_joint_between_two_frames(said: str, kind: str, read: Read) -> None:
    reading = read(chain(loop(f'name="l" type="{said}"')))
    (found,) = reading.model.loops
    assert (found.name, found.kind.name, found.link1, found.link2) == ("l", kind, 2, 3)
    assert found.frame1.translation.tolist() == [0.0, 0.0, 0.3]
    assert found.frame2.translation.tolist() == [0.1, 0.0, 0.2]
    turned = [np.sin(0.5), 0.0, np.cos(0.5)]  # what was z
    assert np.allclose(found.frame2.rotation @ found.frame1.rotation.T @ [0, 0, 1], turned)
    if found.kind.axes:
        assert np.allclose(found.frame1.rotation[:, 2], [0.0, 1.0, 0.0])
    assert reading.mentions == ('<loop> elements: 1, read: "l"',)
    assert reading.warnings == () and reading.ignored == ()


@pytest.mark.parametrize("kind", ["", ' type="rolling"'])
def test_a_coupling_ties_the_joints_between_its_links(kind: str, read: Read) -> None:
    reading = read(chain(coupling(f'name="k"{kind}')))
    (found,) = reading.model.couplings
    assert dict(found.terms) == {2: 1.0, 1: -6.0, 0: -6.0} and found.offset == 0.0
    assert reading.mentions == ('<coupling> elements: 1, read: "k"',)


def test_a_coupling_leaves_out_what_both_links_hang_on(read: Read) -> None:
    side = (
        link("e"),
        joint("j4", "b", "e", "prismatic"),
        link("f"),
        joint("j5", "e", "f", "fixed"),
    )
    (found,) = read(chain(*side, coupling(first="c", second="f"))).model.couplings
    names = {"j2": -6.0, "j4": 1.0}
    model = read(chain(*side)).model
    assert {model.joints[j].name: factor for j, factor in found.terms} == names


def test_loops_are_told_in_the_frame_of_the_link_that_moves(read: Read) -> None:
    fixed = (link("e"), joint("j4", "c", "e", "fixed"))
    end = '<predecessor link="e"><origin xyz="0 0 0.1"/></predecessor>'
    (found,) = read(chain(*fixed, loop(first=end))).model.loops
    assert found.link1 == 2
    assert np.allclose(found.frame1.translation, [0.0, 0.0, 0.3])


@pytest.mark.parametrize(
    ("kind", "loop_kind"),
    [
        ("revolute", "revolute"), ("continuous", "revolute"), ("prismatic", "prismatic"),
        ("fixed", "weld"), ("spherical", "spherical"), ("ball", "spherical"), ("planar", "planar"),
    ],
)  # fmt: skip
def test_the_later_of_two_parent_joints_closes_a_loop(
    kind: str, loop_kind: str, read: Read
) -> None:
    reading = read(chain(joint("close", "c", "d", kind)))
    plain = read(chain())
    assert [j.name for j in reading.model.joints] == [j.name for j in plain.model.joints]
    (found,) = reading.model.loops
    assert (found.name, found.kind.name, found.link1, found.link2) == ("close", loop_kind, 2, 3)
    assert np.allclose(found.frame1.translation, [0.0, 0.0, 0.2])
    assert not found.frame2.translation.any()
    (said,) = reading.warnings
    assert ':10: warning: link "d" has two parent joints, "j3" and "close": ' in said
    assert said.endswith(f'"close" closes a loop ({loop_kind})')


def test_which_joint_closes_is_a_matter_of_order(read: Read) -> None:
    joints = [joint("close", "c", "d"), *CHAIN]
    model = read(robot(*LINKS, *joints)).model
    assert [each.name for each in model.loops] == ["j3"]
    assert [each.name for each in model.joints] == ["j1", "j2", "close"]


def test_a_floating_second_parent_holds_nothing(read: Read) -> None:
    reading = read(chain(joint("free", "c", "d", "floating", "")))
    assert reading.model.loops == ()
    assert reading.warnings[0].endswith('"free" is floating and constrains nothing')


def test_a_ring_hangs_on_the_link_that_its_last_joint_leads_back_to(read: Read) -> None:
    reading = read(chain(joint("close", "c", "a")))
    (found,) = reading.model.loops
    assert (found.link1, found.link2) == (2, 0)
    assert 'joint "close" leads back to the root link "a"' in reading.warnings[0]
    floating = read(chain(joint("close", "c", "a")), floating=True).model
    assert (floating.loops[0].link1, floating.loops[0].link2) == (3, 1)


def test_a_loop_between_links_that_are_fixed_together_is_left_out(read: Read) -> None:
    same = '<successor link="c"><origin xyz="0 0 0.3"/></successor>'
    assert read(chain(loop(second=same))).model.loops == ()


def test_dynamics_of_a_joint_that_closes_a_loop_are_told(read: Read) -> None:
    damped = joint("close", "c", "d", inside=f'{Y}<dynamics damping="0.1"/>')
    for effects in ((), ("damping",)):
        reading = read(chain(damped), effects=effects)
        assert reading.warnings[1].endswith(
            'joint "close": <dynamics> of a joint that closes a loop is not modelled'
        )
        assert len(reading.warnings) == 2


@pytest.mark.parametrize(
    ("said", "kind", "axis"),
    [("continuous", "revolute", Y), ("revolute", "revolute", ""), ("spherical", "spherical", Y)],
)
def test_a_loop_joint_is_a_loop_in_other_words(said: str, kind: str, axis: str, read: Read) -> None:
    """Its axis is along x where none is given, as Drake and Isaac Sim read it."""
    named = f'name="l" type="{said}"'
    same = read(chain(loop(named, axis=axis or '<axis xyz="1 0 0"/>'))).model
    ends = '<link1 link="c" xyz="0 0 0.3"/><link2 link="d" xyz="0.1 0 0.2" rpy="0 0.5 0"/>'
    reading = read(chain(f"<loop_joint {named}>{ends}{axis}</loop_joint>\n"))
    assert reading.model.loops[0].kind.name == kind
    alike(reading.model, same)
    assert reading.mentions == ('<loop_joint> elements: 1, read: "l"',)


CASES = {
    "no name": (loop('type="fixed"'), 'a <loop>: name="..." of <loop> is missing'),
    "no type": (loop('name="l"'), 'loop "l" has no type="...": known types are revolute,'),
    "unknown type": (loop('name="l" type="rolling"'), 'loop "l": unknown type "rolling": known'),
    "no axis": (loop(axis=""), 'loop "l" has no <axis xyz="...">'),
    "zero axis": (loop(axis='<axis xyz="0 0 0"/>'), 'loop "l": the axis has length zero'),
    "no predecessor": (loop(first=""), 'loop "l" has no <predecessor>'),
    "two successors": (loop(first='<successor link="d"/>'), 'loop "l" has no <predecessor>'),
    "undeclared link": (
        loop(first='<predecessor link="x"/>'), 'loop "l": predecessor link "x" is not declared',
    ),
    "no number": (
        loop(first='<predecessor link="c"><origin xyz="0 0"/></predecessor>'),
        "xyz of <origin> has 2 numbers",
    ),
    "out of reach": (
        loop(first='<predecessor link="c"><origin xyz="0 0 3"/></predecessor>'),
        'loop "l" cannot close: one of its links spans 3 m, all others together 0.424 m',
    ),
    "open for ever": (
        loop(first='<predecessor link="d"/>'), 'loop "l" cannot close: its links are locked',
    ),
    "in capitals": ("<Loop/>", "unknown element <Loop>: write <loop>"),
    "in a namespace": ('<x:loop xmlns:x="http://x"/>', "remove the namespace"),
    "of Drake, in one link": (
        '<loop_joint name="l" type="continuous"><link1 link="c"/></loop_joint>',
        'loop "l" has no <link2>',
    ),
    "of Drake, misspelt": (
        '<loop_joint name="l" type="ball"><link1 link="c" pos="0 0 1"/></loop_joint>',
        'loop "l": <link1> has an unknown attribute "pos"',
    ),
    "coupling of nothing": (coupling(first="d"), 'coupling "k": no joint moves its links'),
    "no ratio": (coupling(ratio=""), 'coupling "k" has no <ratio value="...">'),
    "ratio zero": (coupling(ratio='<ratio value="0"/>'), 'coupling "k" has ratio zero'),
    "unknown coupling": (
        coupling('name="k" type="screw"'), 'coupling "k": unknown type "screw": known types are',
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_what_cannot_be_is_refused_by_name(case: str, refusal: Refusal) -> None:
    text, words = CASES[case]
    said = refusal(chain(text))
    assert said.startswith("robot.urdf:10: error: ") and words in said


def test_names_are_used_once(refusal: Refusal) -> None:
    said = refusal(chain(loop(), loop()))
    assert said.startswith("robot.urdf:11:") and 'loop name "l" is used twice' in said
    assert 'loop name "l" is used twice' in refusal(chain(loop(), joint("l", "c", "d")))


def test_only_joints_of_one_freedom_are_coupled(refusal: Refusal) -> None:
    ball = (link("e"), joint("j4", "d", "e", "spherical", ""))
    said = refusal(chain(*ball, coupling(second="e")))
    assert said.startswith("robot.urdf:12:")
    assert 'coupling "k": joint "j4" between its links is spherical' in said


def test_a_joint_that_closes_a_loop_cannot_be_slaved(refusal: Refusal) -> None:
    mimic = joint("close", "c", "d", inside=f'{Y}<mimic joint="j1"/>')
    assert 'joint "close" closes a loop' in refusal(chain(mimic), mimic=True)


SAME = [
    *(f"{name}.orig" for name in (
        "grb_four_bar", "grb_six_bar", "grb_mini_cheetah_leg", "grb_chains_explicit_d5_l4",
        "grb_chains_implicit_d5_l5", "grb_mit_humanoid_leg",
    )),
    *(f"{name}.twoparents" for name in (
        "fourbar_twoparents", "ring4", "ring16", "slider_crank", "slider_crank_prismatic",
    )),
]  # fmt: skip


@pytest.mark.parametrize("name", SAME)
def test_all_notations_of_a_mechanism_are_one_model(name: str, shared: Path) -> None:
    folder = shared / "loops"
    stem = name.partition(".")[0]
    scene = read_with_scene(folder / f"{stem}.urdf", scene=folder / f"{stem}.scene.toml").model
    alike(read_robot(folder / f"{name}.urdf").model, scene)
