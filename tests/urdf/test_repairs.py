"""Slips that all readers of URDF overlook: read with one warning each, refused where strict."""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest

from adagen.urdf import Reading
from tests.urdf.texts import BODY, Y, joint, link, pair, robot

Read = Callable[..., Reading]
GOOD = pair()
XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'

CASES = {
    # name: (text, line, words of the warning)
    "blank lines first": ("\n\n" + GOOD, 3, "does not stand at the start"),
    "a comment first": ("<!-- made by\nhand -->\n" + GOOD, 3, "does not stand at the start"),
    "version": (GOOD.replace('"1.0"', '"0.0"', 1), 1, 'no XML version "0.0": read as 1.0'),
    "prefixes": (
        GOOD.replace("</robot>", '<gazebo:x a="1"/><sensor:camera/></robot>'),
        6,
        'namespace prefixes "gazebo", "sensor" are not declared',
    ),
    "prefix of an attribute": (GOOD.replace("<axis", '<axis foo:bar="1"'), 5, 'prefix "foo" is'),
    "xacro left over": (GOOD.replace("<robot", f'<robot {XACRO} xacro:x="1"'), 2, '"xacro:x"'),
    "xacro left over, undeclared": (GOOD.replace("<axis", '<axis xacro:x="1"'), 5, '"xacro"'),
    "a default namespace": (
        GOOD.replace("<robot", '<robot xmlns="http://drake.mit.edu"'),
        2,
        'the default XML namespace is "http://drake.mit.edu", a URDF is in none: read as if',
    ),
    "rpy of an axis": (GOOD.replace("<axis", '<axis rpy="0 0 0"'), 5, "an <axis> has no rpy"),
    "mimics nothing": (
        pair(j=Y + '<mimic joint="jx"/>'),
        5,
        "does not exist: independent here",
    ),
    "an axis told twice": (pair(j=Y + Y), 5, "has 2 <axis>: read as one, as they agree"),
    "moments given twice": (
        pair(BODY.replace("iyy=", 'iyx="0.0" izx="-0" iyy=')),
        4,
        'link "b": an <inertia> has no iyx, izx, izy: left out, as the tensor is symmetric',
    ),
    "a zero byte at the end": (GOOD + "\0", 7, "ends in a zero byte: left out"),
}


@pytest.mark.parametrize("name", CASES)
def test_slips_are_read_with_one_warning(
    name: str, read: Read, refusal: Callable[..., str]
) -> None:
    text, line, words = CASES[name]
    reading = read(text)
    plain = read(GOOD)
    assert repr(reading.model) == repr(plain.model)
    (warning,) = reading.warnings
    assert f":{line}: warning: " in warning
    assert words in warning
    refused = refusal(text, strict=True)
    assert refused.startswith(f"robot.urdf:{line}: error: ")
    assert refused.endswith(": correct it, or leave out --strict")


def test_elements_left_out_are_named_as_the_file_writes_them(read: Read) -> None:
    reading = read(GOOD.replace("</robot>", '<gazebo:x a="1"/></robot>'))
    assert reading.ignored == ("<gazebo:x> elements: 1, not modelled",)


def test_many_slips_of_one_kind_take_one_line(read: Read, refusal: Callable[..., str]) -> None:
    turned = '<axis xyz="0 1 0" rpy="0 0 0"/>'
    loose = [turned + f'<mimic joint="x{k}"/>' for k in range(9)]
    links = "".join(link(f"l{k}") for k in range(10))
    joints = [joint(f"j{k}", f"l{k}", f"l{k + 1}", inside=loose[k]) for k in range(9)]
    text = robot(links, *joints)
    axes, mimics = read(text).warnings
    assert 'joint "j0": an <axis> has no rpy: left out, as it is zero; so are 8 more axes' in axes
    assert '"x0", which does not exist: independent here; so are 8 more that' in mimics
    assert mimics.endswith('"j1", "j2", "j3", "j4", "j5", "j6" and 2 more')
    assert 'joint "j0": an <axis> has no rpy: correct it' in refusal(text, strict=True)


def test_the_axis_of_a_fixed_joint_is_not_used(read: Read, refusal: Callable[..., str]) -> None:
    misspelt = '<axis xzy="0 0 1"/>'
    text = robot(
        link("a"), link("b"), link("c"),
        joint("j1", "a", "b"), joint("f", "b", "c", "fixed", misspelt),
    )  # fmt: skip
    (warning,) = read(text).warnings
    assert ':7: warning: joint "f": an <axis> without xyz: left out, as the joint' in warning
    assert 'unknown attribute "xzy"' in refusal(pair(j=misspelt))


def test_what_could_change_the_dynamics_is_refused(refusal: Callable[..., str]) -> None:
    turned = GOOD.replace("<axis", '<axis rpy="0 0 1"')
    assert 'unknown attribute "rpy"' in refusal(turned)
    skew = pair(BODY.replace("iyy=", 'iyx="0.001" iyy='))
    assert 'iyx="0.001" differs from ixy="0": a tensor is symmetric' in refusal(skew)
    alone = pair(BODY.replace('ixy="0"', 'iyx="0"'))
    assert "ixy of <inertia> missing" in refusal(alone)
    body = GOOD.replace("<inertial>", "<f:inertial>", 1).replace("</inertial>", "</f:inertial>", 1)
    assert "unknown element <inertial>" in refusal(body)
    joint = GOOD.replace("<joint ", "<f:joint ").replace("</joint>", "</f:joint>")
    assert "unknown element <joint>" in refusal(joint)
    element = GOOD.replace("</robot>", '<xacro:include filename="x"/></robot>')
    assert "<xacro:include> is not expanded" in refusal(element)
    late = "\n" + GOOD.replace('"1.0"', '"1.0" encoding="iso-8859-1"', 1)
    assert "not well formed" in refusal(late)
    assert "has 2 <axis>: keep one" in refusal(pair(j=Y + '<axis xyz="0 1 0.0"/>'))
    assert "binary data" in refusal(GOOD.replace("robot", "rob\0t", 1) + "\0")
    follows = pair(j=Y + '<mimic joint="jx"/>')
    assert "does not exist: correct the name" in refusal(follows, mimic=True)


def test_many_comments_and_prefixes_are_read_in_linear_time(
    read: Read, refusal: Callable[..., str]
) -> None:
    start = time.perf_counter()
    text = "<!-- a -->\n" * 2000 + GOOD.split("\n", 1)[1]
    assert read(text).warnings == ()
    many = "".join(f"<p{k}:x/>" for k in range(100))
    assert "not well formed" in refusal(GOOD.replace("</robot>", many + "</robot>"))
    assert time.perf_counter() - start < 20.0
