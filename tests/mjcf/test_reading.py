"""What of an MJCF is refused, told, and how it is held."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.cli import main
from adagen.errors import EnvironmentFault, InputError, UsageError
from adagen.library import read
from adagen.library.robot import source_hash
from adagen.mjcf import is_mjcf, read_mjcf
from adagen.urdf import Reading

pytest.importorskip("mujoco")

LIMB = """<body name="limb" pos="0 0 1"><joint name="hip" axis="0 1 0"/><geom size="0.1"/>
<body name="shank" pos="0 0 -0.4"><joint name="knee" axis="0 1 0"/><geom size="0.1" pos="0 0 -.2"/>
</body></body>"""
GOOD = f"""<mujoco model="limbs"><option><flag contact="disable"/></option><worldbody>
{LIMB}
</worldbody></mujoco>
"""


@pytest.fixture
def reading(tmp_path: Path) -> Callable[..., Reading]:
    def reader(text: str, **options: Any) -> Reading:
        path = tmp_path / "robot.xml"
        path.write_text(text)
        return read_mjcf(path, **options)

    return reader


SCENE = "a scene with"
PULLED = '<joint joint="hip" coef="1"/>'
Read = Callable[..., Reading]


def beside(more: str) -> str:
    return GOOD.replace("</worldbody>", f"</worldbody>{more}")


def joints(reading: Reading) -> list[str]:
    return [joint.name for joint in reading.model.joints]


def test_a_plain_tree_says_nothing(reading: Read) -> None:
    found = reading(GOOD)
    assert joints(found) == ["hip", "knee"]
    assert found.warnings == () and found.ignored == ()
    assert found.model.name == "limbs"
    assert found.model.gravity.tolist() == [0.0, 0.0, -9.81]
    assert reading(GOOD, gravity=(0, 0, -1)).model.gravity.tolist() == [0.0, 0.0, -1.0]
    still = GOOD.replace('contact="disable"', 'contact="disable" gravity="disable"')
    assert reading(still).model.gravity.tolist() == [0.0, 0.0, 0.0]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (beside('<equality><weld name="w" body1="shank"/></equality>'), '<weld> "w" closes a loop'),
        (
            beside('<equality><connect body1="shank" anchor="0 0 0"/></equality>'),
            '"number 1" closes a loop as a soft',
        ),
        (
            beside('<equality><joint name="c" joint1="hip" joint2="knee"/></equality>'),
            'couples joints "hip" and "knee": use --mimic',
        ),
        (
            beside('<equality><joint name="c" joint1="hip"/></equality>'),
            '<joint> "c" of <equality> holds joint "hip"',
        ),
        (
            beside(f'<tendon><fixed name="t" stiffness="3">{PULLED}</fixed></tendon>'),
            'tendon "t" has stiffness: tendons are not modelled',
        ),
        (GOOD.replace('size="0.1"/>', 'siz="0.1"/>'), "unrecognized attribute: 'siz'"),
        (GOOD.replace("</body></body>", "</body>"), "MuJoCo: XML parse error"),
        (GOOD.replace('<geom size="0.1" pos="0 0 -.2"/>', ""), "mass and inertia of moving bodies"),
        ("<mujoco/>", "nothing to solve"),
        (GOOD.replace('"0.1"', '"0.1" mass="1e300"', 1), 'body "limb": mass is not finite or too'),
        (GOOD.replace('"0 0 -0.4"', '"nan 0 0"'), 'body "shank": pos is not finite or too'),
        (GOOD.replace('name="hip"', 'name="hip" damping="inf"'), 'joint "hip": damping is not'),
        (GOOD.replace('name="hip"', 'name="hip" ref="1e60"'), "ref or gravity is not finite"),
        ("<!DOCTYPE mujoco []>" + GOOD, "a DTD and its entities are not allowed"),
    ],
)
def test_what_is_no_open_chain_is_refused_by_name(text: str, said: str, tmp_path: Path) -> None:
    path = tmp_path / "robot.xml"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        read(path)
    line = str(caught.value)
    assert line.startswith(str(path)) and "\n" not in line
    assert said in line or "simulation is unstable" in line  # so MuJoCo 3 says it of itself


def test_mujoco_s_line_is_told(reading: Read, tmp_path: Path) -> None:
    wrong = GOOD.replace('<joint name="knee"', '<joint nam="knee"')
    with pytest.raises(InputError) as caught:
        reading(wrong)
    assert caught.value.line == 3
    (tmp_path / "part.xml").write_text(f"<mujocoinclude>\n\n\n{LIMB}</mujocoinclude>")
    included = GOOD.replace(LIMB, '<include file="part.xml"/>')
    assert joints(reading(included)) == ["hip", "knee"]
    (tmp_path / "part.xml").write_text(
        f"<mujocoinclude>\n\n{LIMB.replace('axis', 'axs')}</mujocoinclude>"
    )
    with pytest.raises(InputError) as caught:
        reading(included)
    assert caught.value.line is None  # it would be another file's


def test_a_coupling_is_a_mimic_where_it_is_asked_for(reading: Read) -> None:
    coupled = beside(
        '<equality><joint joint1="knee" joint2="hip" polycoef="0.25 -2 0 0 0"/></equality>'
    ).replace('<joint name="hip"', '<joint name="hip" ref="45"')
    mimic = reading(coupled, mimic=True).model.joints[1].mimic
    assert mimic is not None
    assert (mimic.source, mimic.multiplier) == (0, -2.0)
    assert mimic.offset == pytest.approx(0.25 + 2 * 0.7853981633974483, rel=1e-15)
    bent = coupled.replace("-2 0 0 0", "-2 1 0 0")
    with pytest.raises(InputError, match="as no <mimic> does"):
        reading(bent, mimic=True)
    circle = coupled.replace("</equality>", '<joint joint1="hip" joint2="knee"/></equality>')
    with pytest.raises(InputError, match='joint "knee" follows itself'):
        reading(circle, mimic=True)
    off = coupled.replace("<joint joint1", '<joint active="false" joint1')
    assert reading(off).model.joints[1].mimic is None


def test_a_joint_that_follows_a_follower_follows_its_source(reading: Read) -> None:
    foot = '<body pos="0 0 -1"><joint name="ankle" axis="0 1 0"/><geom size="0.1"/></body>'
    coupled = beside(
        '<equality><joint joint1="ankle" joint2="knee" polycoef="0.5 3 0 0 0"/>'
        '<joint joint1="knee" joint2="hip" polycoef="0.25 -2 0 0 0"/></equality>'
    ).replace("</body></body>", f"{foot}</body></body>")
    _, knee, ankle = (joint.mimic for joint in reading(coupled, mimic=True).model.joints)
    assert knee is not None and ankle is not None
    assert (knee.source, knee.multiplier, knee.offset) == (0, -2.0, 0.25)
    assert (ankle.source, ankle.multiplier, ankle.offset) == (0, -6.0, 0.5 + 3 * 0.25)


def test_inertia_is_that_of_the_file_unless_it_is_asked_to_be_changed(reading: Read) -> None:
    """MuJoCo keeps principal moments, and the axes that it finds up to rounding."""
    given = [0.7, 0.6, 0.5, 0.01, -0.02, 0.03]
    text = GOOD.replace(
        '<geom size="0.1" pos="0 0 -.2"/>',
        f'<inertial pos="0 0 -.2" mass="1" fullinertia="{" ".join(map(str, given))}"/>',
    )
    xx, yy, zz, xy, xz, yz = given
    tensor = reading(text).model.links[2].inertia.tensor
    assert tensor.tolist() == [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    bounded = text.replace("<option>", '<compiler boundinertia="1"/><option>')
    moments = np.linalg.eigvalsh(reading(bounded).model.links[2].inertia.tensor)
    assert moments == pytest.approx(np.ones(3), rel=1e-12)


def test_forces_that_are_not_modelled_are_told_once(reading: Read) -> None:
    text = (
        GOOD.replace("<option>", '<option density="1.2">')
        .replace('contact="disable"', 'energy="enable"')
        .replace('<body name="shank"', '<body name="shank" gravcomp="1"')
        .replace('name="hip"', 'name="hip" damping="1" frictionloss="2" range="-1 1"')
        .replace('name="knee"', 'name="knee" damping="1" stiffness="3" armature="0.5"')
        .replace("</mujoco>", '<actuator><motor joint="hip"/></actuator></mujoco>')
    )
    found = reading(text)
    said = [line.partition("warning: ")[2] for line in found.warnings]
    assert said == [
        'gravity compensation of body "shank" is not modelled',
        "forces of the medium (density, viscosity) are not modelled",
        "contacts of 2 geoms and 1 actuator not modelled: torques are given with each state",
        f'damping of 2 joints is not modelled ("hip", "knee"): {SCENE} damping = "urdf" models it',
        f'friction of joint "hip" is not modelled: {SCENE} friction = "urdf" models it',
        f'stiffness of joint "knee" is not modelled: {SCENE} stiffness in [joints.NAME] models it',
    ]
    assert found.ignored == ("joint limits: 1, not modelled",)
    assert [joint.passive.rotor_inertia for joint in found.model.joints] == [0.0, 0.5]


def test_a_scene_has_damping_and_springs(tmp_path: Path) -> None:
    path, scene = tmp_path / "robot.xml", tmp_path / "scene.toml"
    path.write_text(
        GOOD.replace('name="hip"', 'name="hip" damping="1" stiffness="2"').replace(
            'name="knee"', 'name="knee" armature="0.5" frictionloss="3"'
        )
    )
    scene.write_text('damping = "urdf"\nfriction = 0.5\n[joints.hip]\nstiffness = 2\n')
    robot = read(path, scene=scene)
    hip, knee = (joint.passive for joint in robot.model.joints)
    assert (hip.damping, hip.friction, hip.stiffness, hip.rotor_inertia) == (1.0, 0.5, 2.0, 0.0)
    assert (knee.damping, knee.friction, knee.rotor_inertia) == (0.0, 0.5, 0.5)
    assert robot.warnings == ()


def test_a_rotor_of_a_drive_counts_by_its_gear(reading: Read) -> None:
    text = GOOD.replace(
        "</mujoco>", '<actuator><motor joint="knee" gear="3" armature="2"/></actuator></mujoco>'
    )
    try:
        found = reading(text)
    except InputError:
        pytest.skip("actuators have an armature from MuJoCo 4 on")
    assert [joint.passive.rotor_inertia for joint in found.model.joints] == [0.0, 18.0]
    pulled = f'<tendon><fixed name="t">{PULLED}</fixed></tendon>'
    drive = '<actuator><motor tendon="t" armature="2"/></actuator>'
    with pytest.raises(InputError, match='tendon "t" has armature'):
        reading(beside(pulled + drive))


def test_drives_of_one_joint_add_up(reading: Read) -> None:
    one = '<motor joint="knee" gear="3" armature="2" damping="1 5"/>'
    two = '<motor joint="knee" gear="-2" armature="1" damping="3"/><motor joint="knee"/>'
    try:
        found = reading(beside(f"<actuator>{one}{two}</actuator>"), effects=("damping",))
    except InputError:
        pytest.skip("actuators have an armature from MuJoCo 4 on")
    knee = found.model.joints[1].passive
    assert (knee.rotor_inertia, knee.damping) == (22.0, 21.0)
    assert any('damping of higher order of joint "knee"' in line for line in found.warnings)
    tendon = f'<tendon><fixed name="t">{PULLED}</fixed></tendon>'
    drives = '<actuator><motor tendon="t"/><motor tendon="t" armature="2"/></actuator>'
    with pytest.raises(InputError, match='tendon "t" has armature'):
        reading(
            beside(
                tendon
                + drives.replace('<motor tendon="t"/>', '<motor tendon="t" gear="2" armature="1"/>')
            )
        )


def test_a_drive_of_three_forces_has_its_own_gears(reading: Read) -> None:
    balls = "".join(
        f'<body><joint name="{name}" type="ball"/><geom size="0.1"/></body>' for name in "ab"
    )
    drives = '<orientation joint="a" kp="1"/><motor joint="b" gear="3" armature="2"/>'
    try:
        found = reading(
            f"<mujoco><worldbody>{balls}</worldbody><actuator>{drives}</actuator></mujoco>"
        )
    except InputError:
        pytest.skip("actuators have several forces from MuJoCo 4 on")
    assert [joint.passive.rotor_inertia for joint in found.model.joints] == [0.0, 18.0]


@pytest.mark.parametrize(
    ("flag", "attributes"),
    [
        ("damper", "damping"),
        ("spring", "stiffness"),
        ("frictionloss", "frictionloss"),
        ("constraint", "frictionloss"),
    ],
)
def test_effects_that_the_file_switches_off_are_not_there(
    flag: str, attributes: str, reading: Read
) -> None:
    text = GOOD.replace('contact="disable"', f'contact="disable" {flag}="disable"')
    found = reading(
        text.replace('name="hip"', f'name="hip" {attributes}="2"'), effects=("damping", "friction")
    )
    passive = found.model.joints[0].passive
    assert (passive.damping, passive.friction, passive.stiffness) == (0.0, 0.0, 0.0)
    assert found.warnings == ()


def test_constraints_that_the_file_switches_off_couple_nothing(reading: Read) -> None:
    text = beside('<equality><joint joint1="knee" joint2="hip"/></equality>')
    found = reading(text.replace('contact="disable"', 'constraint="disable"'))
    assert [joint.mimic for joint in found.model.joints] == [None, None]
    assert found.warnings == ()


def test_a_rotor_of_a_free_joint_is_told(reading: Read) -> None:
    free = GOOD.replace('<joint name="hip" axis="0 1 0"/>', '<joint type="free" armature="1"/>')
    (warning,) = reading(free).warnings
    told = 'rotor inertia of joint "__base__" is not modelled: no single meaning for a joint of'
    assert told in warning


def test_how_the_base_is_held(reading: Read) -> None:
    fixed = GOOD.replace('<joint name="hip" axis="0 1 0"/>', "")
    assert joints(reading(fixed)) == ["knee"]
    floating = reading(fixed, floating=True).model
    assert floating.floating and [j.name for j in floating.joints] == ["__base__", "knee"]
    freed = GOOD.replace('<joint name="hip" axis="0 1 0"/>', "<freejoint/>")
    for options in ({}, {"floating": True}):
        model = reading(freed, **options).model
        assert model.floating and [j.name for j in model.joints] == ["__base__", "knee"]
        assert model.joints[0].translation.tolist() == [0.0, 0.0, 0.0]  # q is a place in the world
    named = reading(freed.replace("<freejoint/>", '<freejoint name="root"/>')).model
    assert not named.floating and named.joints[0].name == "root"
    asked = reading(freed.replace("<freejoint/>", '<freejoint name="root"/>'), floating=True).model
    assert asked.floating and asked.joints[0].name == "__base__"
    with pytest.raises(InputError, match='"limb" has joint "hip" to the world'):
        reading(GOOD, floating=True)
    table = '<body name="table"><geom size="1"/><body><geom size="0.2"/></body></body>'
    beside_it = reading(fixed.replace("<worldbody>", f"<worldbody>{table}"), floating=True).model
    assert [j.name for j in beside_it.joints] == ["__base__", "knee"]
    another = LIMB.replace('name="', 'name="other_')
    two = fixed.replace("</worldbody>", f"{another}</worldbody>")
    with pytest.raises(InputError, match="sets one body free"):
        reading(two, floating=True)
    with pytest.raises(InputError, match="the scene holds it"):
        reading(freed, held=True)


def test_names_are_made_where_there_are_none(reading: Read) -> None:
    text = GOOD.replace('name="hip" ', "").replace('name="knee" ', "").replace('name="shank" ', "")
    more = text.replace("<joint axis", '<joint type="slide"/><joint axis', 1)
    found = reading(more)
    assert joints(found) == ["limb_joint1", "limb_joint2", "body2_joint"]
    taken = text.replace('"limb"', '"body2_joint"', 1)
    assert joints(reading(taken)) == ["body2_joint_joint", "body2_joint"]


def test_a_default_namespace_changes_nothing(reading: Read, tmp_path: Path) -> None:
    found = reading(GOOD.replace("<mujoco", '<mujoco xmlns="http://mujoco.org"', 1))
    assert repr(found.model) == repr(reading(GOOD).model) and found.warnings == ()
    (tmp_path / "named.xml").write_text('<mujoco xmlns="http://mujoco.org"/>')
    assert is_mjcf(tmp_path / "named.xml")


def test_what_is_mjcf(tmp_path: Path, shared: Path) -> None:
    for name, text, expected in (
        ("a.xml", GOOD, True),
        ("a.mjcf", "<!-- x -->\n<mujoco>", True),
        ("a.urdf", GOOD, False),
        ("b.xml", '<robot name="mujoco"/>', False),
        ("c.xml", "<mujocoinclude/>", False),
        ("d.xml", "\0\0", False),
    ):
        (tmp_path / name).write_text(text)
        assert is_mjcf(tmp_path / name) is expected
    assert not is_mjcf(tmp_path / "none.xml")
    with pytest.raises(InputError, match=r"this is MJCF, .* end in .xml"):
        read(shared / "bad" / "mjcf.urdf")


def test_without_the_package_its_name_is_said(
    reading: Read, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "mujoco", None)
    with pytest.raises(EnvironmentFault, match="pip install mujoco"):
        reading(GOOD)


def test_xacro_s_arguments_are_refused(reading: Read) -> None:
    with pytest.raises(UsageError, match=r"end in \.xacro"):
        reading(GOOD, arguments={"a": "1"})


def test_a_solver_is_emitted_and_made_again(tmp_path: Path) -> None:
    path, out = tmp_path / "robot.xml", tmp_path / "out"
    path.write_text(GOOD)
    assert main([str(path), "--procs", "1", "--out", str(out)]) == 0
    assert (out / "robot_p1.cpp").is_file()
    assert main(["verify", str(out)]) == 0


MESHES = """<asset><texture name="t" type="2d" file="no.png"/><material name="m" texture="t"/>
<mesh name="skin" file="no.obj"/></asset>"""
BODY = '<inertial pos="0 0 -.2" mass="1" diaginertia="1 1 1"/>'


def test_meshes_that_are_not_there_are_needed_for_inertias_alone(reading: Read) -> None:
    mesh = '<geom type="mesh" mesh="skin" material="m"/>'
    given = LIMB.replace('<geom size="0.1"/>', BODY + mesh)
    text = GOOD.replace(LIMB, f"{mesh}<body>{mesh}</body>{given}").replace(
        "<worldbody>", f"{MESHES}<worldbody>"
    )
    found = reading(text)
    (warning,) = found.warnings
    assert "no.obj" in warning and "read without meshes" in warning
    plain = reading(GOOD.replace('<geom size="0.1"/>', BODY))
    assert repr(found.model.joints) == repr(plain.model.joints)
    assert repr(found.model.links[1:]) == repr(plain.model.links[1:])
    with pytest.raises(InputError, match=r"no\.obj"):
        reading(text.replace(BODY, ""))
    with pytest.raises(InputError, match=r"none\.xml"):
        reading(GOOD.replace("<worldbody>", '<include file="none.xml"/><worldbody>'))


def test_what_mujoco_warns_of_is_passed_on(
    reading: Read, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    text = GOOD.replace("<option>", '<compiler settotalmass="3"/><option>')
    found = reading(text)
    assert sum(link.inertia.mass for link in found.model.links) == pytest.approx(3.0, rel=1e-12)
    assert all("settotalmass" in line for line in found.warnings)
    with pytest.raises(InputError, match=r"not finite|unstable"):
        reading(GOOD.replace('"0 0 -0.4"', '"nan 0 0"'))
    assert [path.name for path in tmp_path.iterdir()] == ["robot.xml"]  # and no log


def test_the_hash_is_of_what_is_included_too(tmp_path: Path) -> None:
    path, part = tmp_path / "robot.xml", tmp_path / "part.xml"
    path.write_text(GOOD.replace(LIMB, '<include file="part.xml"/>'))
    part.write_text(f"<mujocoinclude>{LIMB}</mujocoinclude>")
    before = source_hash(read(path).origin)
    assert before == source_hash(read(path).origin) == read(path).source_hash
    part.write_text(f"<mujocoinclude>{LIMB.replace('0.1', '0.2')}</mujocoinclude>")
    assert source_hash(read(path).origin) != before
