"""One robot in MJCF and in URDF has the same accelerations, and they are MuJoCo's."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator, Mapping
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from lxml import etree
from numpy.typing import NDArray

from adagen.mjcf import read_mjcf
from adagen.mjcf.compiled import compiled, settled
from adagen.mjcf.reader import reading_of
from adagen.model import Model
from adagen.reference import forward_dynamics
from adagen.states import random_states
from adagen.urdf import read_robot
from adagen.urdf.notes import Notes
from tests.mjcf.dynamics import accelerations, mjcf_of

mujoco = pytest.importorskip("mujoco")

exact = pytest.mark.skipif(
    int(mujoco.__version__.split(".")[0]) < 4,
    reason="MuJoCo 3 leaves out moments of inertia below 1e-12 kg m^2",
)
PACKAGE = "example-robot-data"
ROBOTS = {
    "arm": "talos_data/robots/talos_left_arm.urdf",
    "quadruped": "solo_description/robots/solo12.urdf",
    "humanoid": "g1_description/urdf/g1_29dof_rev_1_0.urdf",
    "slaved": "panda_description/urdf/panda.urdf",
}

EVERYTHING = """<mujoco model="everything">
<compiler angle="degree" eulerseq="xyz"/>
<option gravity="0.5 0 -3"/>
<default>
  <joint armature="0.02" damping="2"/>
  <geom density="700"/>
  <default class="light"><geom density="200"/><joint armature="0.004"/></default>
</default>
<worldbody>
  <geom type="plane" size="1 1 1"/>
  <body name="table" pos="0 0.5 0" euler="0 0 30"><geom type="box" size="0.4 0.3 0.2"/>
    <body name="column" pos="0 0 0.3" quat="0.9 0.1 0.2 -0.3">
      <joint name="turn" axis="1 2 3" pos="0.02 0 0.1" ref="35" stiffness="4"/>
      <joint name="lift" type="slide" axis="0 1 1" ref="0.25" frictionloss="0.3"/>
      <geom type="capsule" fromto="0 0 0 0.1 0.2 0.5" size="0.05"/>
      <frame pos="0 0.1 0.5" euler="10 20 30">
        <body name="hand" childclass="light"><joint type="ball" pos="0 0.05 -0.02"/>
          <geom type="ellipsoid" size="0.05 0.1 0.15" pos="0.1 0 0"/>
          <geom size="0.04" pos="0 0 0.3"/>
          <body pos="0 0 0.2"><geom type="cylinder" fromto="0 0 0 0.1 0 0.1" size="0.02"/>
            <body pos="0.1 0 0"><joint axis="0 1 0"/><geom size="0.03" pos="0.1 0 0"/></body>
          </body>
        </body>
      </frame>
    </body>
  </body>
  <body name="ball" pos="1 1 1"><freejoint/>
    <inertial pos="0.01 0.02 0.03" mass="2" fullinertia="0.02 0.022 0.03 1e-3 2e-3 -3e-3"/>
    <body name="flap" pos="0 0.1 0"><joint name="flap" axis="0 0 -2"/>
      <geom type="box" size="0.1 0.01 0.05" pos="0.1 0 0"/></body>
  </body>
</worldbody>
<actuator><motor joint="flap" gear="3"/></actuator>
</mujoco>
"""


def same(found: NDArray[np.float64], expected: NDArray[np.float64], tolerance: float) -> None:
    assert np.abs(found - expected).max() <= tolerance * np.abs(expected).max()


@pytest.fixture
def all_digits() -> Iterator[None]:
    """MuJoCo's writer with 17 digits; by default it writes 6, as in the files that it ships."""
    (path,) = Path(mujoco.__file__).parent.glob("libmujoco.so.*")
    writer = ctypes.CDLL(str(path))
    if not hasattr(writer, "_mjPRIVATE__set_xml_precision"):
        pytest.skip("this mujoco writes 6 digits only")
    before = writer._mjPRIVATE__get_xml_precision()
    writer._mjPRIVATE__set_xml_precision(17)
    yield
    writer._mjPRIVATE__set_xml_precision(before)


def compare_with_mujoco(path: Path, tolerance: float) -> Model:
    """Compare what is read of a file with MuJoCo's own accelerations of it."""
    model = read_mjcf(path).model
    robot = compiled(path, path.stem, Notes(str(path)))
    states = random_states(model, 3, 7)
    for q, v, tau in states.each:
        theirs = accelerations(robot.model, model, robot.joints, q, v, tau)
        same(forward_dynamics(model, q, v, tau), theirs, tolerance)
    return model


@exact
def test_everything_that_a_tree_can_have_is_as_mujoco_settles_it(tmp_path: Path) -> None:
    path = tmp_path / "everything.xml"
    path.write_text(EVERYTHING)
    model = compare_with_mujoco(path, 1e-12)
    assert model.name == "everything"
    assert {joint.name: joint.kind.name for joint in model.joints} == {
        "__base__": "floating",
        "flap": "revolute",
        "turn": "revolute",
        "lift": "prismatic",
        "hand_joint": "spherical",
        "body5_joint": "revolute",
    }
    rotors = {joint.name: joint.passive.rotor_inertia for joint in model.joints}
    assert (rotors["turn"], rotors["hand_joint"], rotors["__base__"]) == (0.02, 0.004, 0.0)
    assert not any(joint.passive.loads for joint in model.joints)


def test_a_model_of_mujoco_s_own(tmp_path: Path) -> None:
    path = Path(mujoco.__file__).parent / "testdata" / "model.xml"
    if not path.is_file():
        pytest.skip("this mujoco comes without its test data")
    root = etree.parse(str(path)).getroot()
    for weld in list(root.iterchildren("equality")):  # to the world: refused by name
        root.remove(weld)
    own = tmp_path / "model.xml"
    own.write_bytes(etree.tostring(root))
    model = compare_with_mujoco(own, 1e-12)
    assert len(model.joints) == 16 and model.nv == 43


@exact
@pytest.mark.parametrize("name", ROBOTS)
def test_mujoco_s_reading_of_a_urdf_is_ours(name: str) -> None:
    path = example(name)
    spec = mujoco.MjSpec.from_string(bare(path))
    theirs = spec.compile()
    robot = settled(theirs, spec, "robot")
    ours = read_robot(path, mimic=name == "slaved").model
    model = reading_of(robot, Notes("robot.urdf"), **ALIKE).model
    names = [joint.name for joint in ours.joints]
    order = [names.index(joint.name) for joint in model.joints]  # fixed joints have lost their name
    states = random_states(ours, 2, 7)
    for q, v, tau in states.each:
        expected = forward_dynamics(ours, q, v, tau)[order]
        same(forward_dynamics(model, q[order], v[order], tau[order]), expected, 1e-12)
        if name != "slaved":  # theirs are held by forces
            place = (q[order], v[order], tau[order])
            same(accelerations(theirs, model, robot.joints, *place), expected, 1e-12)


@exact
@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.usefixtures("all_digits")
def test_the_mjcf_that_mujoco_writes_of_a_urdf_is_the_same_robot(name: str, tmp_path: Path) -> None:
    source, written = example(name), tmp_path / "robot.xml"
    spec = mujoco.MjSpec.from_string(bare(source))
    spec.compile()
    written.write_text(spec.to_xml())
    ours = read_robot(source, mimic=name == "slaved").model
    model = read_mjcf(written, mimic=True).model
    names = [joint.name for joint in ours.joints]
    order = [names.index(joint.name) for joint in model.joints]
    states = random_states(ours, 2, 7)
    for q, v, tau in states.each:
        expected = forward_dynamics(ours, q, v, tau)[order]
        same(forward_dynamics(model, q[order], v[order], tau[order]), expected, 1e-12)


@pytest.mark.parametrize("floating", [False, True])
@pytest.mark.parametrize("name", [name for name in ROBOTS if name != "slaved"])
def test_an_mjcf_that_says_what_a_urdf_does_is_the_same_robot(
    name: str, floating: bool, tmp_path: Path
) -> None:
    ours = read_robot(example(name), floating=floating).model
    path = tmp_path / "robot.xml"
    path.write_text(mjcf_of(ours))
    model = read_mjcf(path).model
    assert [joint.name for joint in model.joints] == [joint.name for joint in ours.joints]
    assert model.floating == floating
    states = random_states(ours, 2, 7)
    for q, v, tau in states.each:
        expected = forward_dynamics(ours, q, v, tau)
        same(forward_dynamics(model, q, v, tau), expected, 1e-12)


ALIKE: Mapping[str, Any] = {
    "floating": False,
    "mimic": True,
    "gravity": None,
    "effects": (),
    "decided": lambda _effect, _joint: True,
    "check": True,
    "held": False,
}


def example(name: str) -> Path:
    for file in metadata.files(PACKAGE) or []:
        if str(file).endswith(ROBOTS[name]):
            return Path(str(file.locate()))
    pytest.skip(f"{PACKAGE} has no {ROBOTS[name]}")


def bare(path: Path) -> str:
    """A URDF without its pictures, and with links that stay as they are."""
    root = etree.parse(str(path)).getroot()
    for part in list(root):
        if part.tag not in ("link", "joint"):
            root.remove(part)
        for child in list(part) if part.tag == "link" else ():
            if child.tag != "inertial":
                part.remove(child)
    return etree.tostring(root).decode()
