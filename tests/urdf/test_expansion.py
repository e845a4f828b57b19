"""Descriptions in xacro: expanded by ROS's package, and the same robot as the URDF it makes."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from adagen.cli import main
from adagen.errors import EnvironmentFault, InputError, UsageError
from adagen.library import read
from adagen.library.robot import source_hash
from adagen.urdf import model_stem, read_robot
from tests.urdf.texts import joint, link, robot

SPACE = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
BODY = f"""<robot {SPACE}><xacro:macro name="body" params="name mass">
<link name="${{name}}"><inertial><origin xyz="0 0 0.1"/><mass value="${{mass}}"/>
<inertia ixx="${{mass/100}}" ixy="0" ixz="0" iyy="${{mass/100}}" iyz="0" izz="0.01"/></inertial>
</link></xacro:macro></robot>
"""
ARM = f"""<?xml version="1.0"?>
<robot name="arm" {SPACE}>
<xacro:arg name="mass" default="2"/>
<xacro:include filename="parts/body.xacro"/>
<xacro:body name="a" mass="1"/>
<xacro:body name="b" mass="$(arg mass)"/>
<joint name="j1" type="revolute"><origin xyz="0 0 ${{2*0.1}}"/><parent link="a"/><child link="b"/>
<axis xyz="0 1 0"/></joint>
</robot>
"""


@pytest.fixture
def arm(tmp_path: Path) -> Path:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "body.xacro").write_text(BODY)
    path = tmp_path / "arm.urdf.xacro"
    path.write_text(ARM)
    return path


def test_it_is_the_robot_that_the_urdf_is(arm: Path, tmp_path: Path) -> None:
    pytest.importorskip("xacro")
    body = '<inertial><origin xyz="0 0 0.1"/><mass value="{0}"/><inertia ixx="{1}" ixy="0" '
    body += 'ixz="0" iyy="{1}" iyz="0" izz="0.01"/></inertial>'
    plain = tmp_path / "plain.urdf"
    for mass, arguments in (("2.0", {}), ("5.0", {"mass": "5.0"})):
        links = link("a", body.format("1", "0.01")), link("b", body.format(mass, float(mass) / 100))
        plain.write_text(robot(*links, joint("j1", "a", "b"), attributes=' name="arm"'))
        reading = read_robot(arm, arguments=arguments)
        assert repr(reading.model) == repr(read_robot(plain).model)
        assert reading.warnings == ()


def test_what_xacro_warns_of_takes_a_line_each(arm: Path) -> None:
    pytest.importorskip("xacro")
    arm.write_text(ARM.replace("<xacro:arg", '<xacro:property name="pi" value="3"/><xacro:arg', 1))
    (warning,) = read_robot(arm).warnings
    assert warning == f"{arm}: warning: xacro: redefining global symbol: pi"


def test_an_argument_that_is_none_of_the_file_s_is_refused(arm: Path, tmp_path: Path) -> None:
    pytest.importorskip("xacro")
    with pytest.raises(UsageError, match=r"has no <xacro:arg> mas \(did you mean mass\?\)"):
        read_robot(arm, arguments={"mas": "3"})
    plain = tmp_path / "r.urdf"
    plain.write_text(robot(link("a"), link("b"), joint("j", "a", "b")))
    with pytest.raises(UsageError, match="for files whose names end in"):
        read_robot(plain, arguments={"mass": "3"})


@pytest.mark.parametrize(
    ("before", "after", "said"),
    [
        ('mass="1"/>', 'mass="-1"/>', 'link "a": mass -1.0 is negative'),
        ("${2*0.1}", "${2*length}", "xacro: name 'length' is not defined"),
        ("</robot>", "</robt>", "xacro: mismatched tag"),
        ("parts/body", "parts/none", "No such file"),
        ("parts/body", "$(find other)/body", "needs ROS"),
        ("<?xml version", "<!DOCTYPE r []><?xml version", "a DTD and its entities"),
        ("<xacro:body name", "<xacro:boddy name", "unknown macro name: xacro:boddy"),
    ],
)
def test_what_xacro_refuses_is_one_line_without_lines_of_no_file(
    before: str, after: str, said: str, arm: Path
) -> None:
    pytest.importorskip("xacro")
    arm.write_text(ARM.replace(before, after))
    with pytest.raises(InputError) as caught:
        read_robot(arm)
    line = str(caught.value)
    assert said in line
    assert "\n" not in line
    assert said.startswith("a DTD") or caught.value.line is None


def test_a_fault_of_an_included_file_names_it(arm: Path) -> None:
    pytest.importorskip("xacro")
    (arm.parent / "parts" / "body.xacro").write_text(BODY.replace("</robot>", ""))
    with pytest.raises(InputError, match=r"xacro: .* \(in .*parts/body.xacro\)"):
        read_robot(arm)


def test_without_the_package_its_name_is_said(arm: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "xacro", None)
    with pytest.raises(EnvironmentFault, match="pip install xacro"):
        read_robot(arm)


def test_the_hash_is_of_what_it_expands_to(arm: Path) -> None:
    pytest.importorskip("xacro")
    plain = source_hash(read(arm).origin)
    assert source_hash(read(arm, arguments={"mass": "2"}).origin) == plain
    assert source_hash(read(arm, arguments={"mass": "3"}).origin) != plain
    (arm.parent / "parts" / "body.xacro").write_text(BODY.replace('"0.01"', '"0.02"'))
    assert source_hash(read(arm).origin) != plain


def test_the_command_line_takes_it_and_can_make_it_again(
    arm: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("xacro")
    out = tmp_path / "out"
    words = [str(arm), "--xacro-arg", "mass:=3", "--procs", "1", "--out", str(out)]
    assert main(words) == 0
    assert "--xacro-arg=mass:=3" in (out / "arm_p1.cpp").read_text()
    assert main(["verify", str(out)]) == 0
    assert main([str(arm), "--xacro-arg", "mass"]) == 2
    assert "not NAME:=VALUE" in capsys.readouterr().err


def test_stems() -> None:
    assert [model_stem(name) for name in ("a.urdf", "b/a.urdf.xacro", "a.xacro", "a")] == ["a"] * 4
