"""Robots of the package example-robot-data that benchmarks take, where it is installed."""

from __future__ import annotations

import sysconfig
from pathlib import Path

from adagen.model import Model
from adagen.urdf import read_robot

DATA = Path(sysconfig.get_path("purelib"), "cmeel.prefix/share/example-robot-data/robots")
FIXED = {
    "ur3": "ur_description/urdf/ur3_robot.urdf",
    "ur5": "ur_description/urdf/ur5_robot.urdf",
    "ur10": "ur_description/urdf/ur10_robot.urdf",
    "ur5_gripper": "ur_description/urdf/ur5_gripper.urdf",
    "panda": "panda_description/urdf/panda.urdf",
    "kinova": "kinova_description/robots/kinova.urdf",
    "xarm7": "xarm_description/urdf/xarm7.urdf",
    "z1": "z1_description/urdf/z1.urdf",
    "so100": "so_arm_description/urdf/so100.urdf",
    "talos_left_arm": "talos_data/robots/talos_left_arm.urdf",
    "finger_edu": "finger_edu_description/robots/finger_edu.urdf",
    "double_pendulum": "double_pendulum_description/urdf/double_pendulum.urdf",
    "allegro_right": "allegro_hand_description/urdf/allegro_right_hand.urdf",
    "allegro_left": "allegro_hand_description/urdf/allegro_left_hand.urdf",
    "baxter": "baxter_description/urdf/baxter.urdf",
    "pr2": "pr2_description/urdf/pr2.urdf",
    "tiago": "tiago_description/robots/tiago.urdf",
    "tiago_no_hand": "tiago_description/robots/tiago_no_hand.urdf",
    "tiago_dual": "tiago_description/robots/tiago_dual.urdf",
    "tiago_pro": "tiago_pro_description/robots/tiago_pro.urdf",
    "alex_nub_hands": "alex_description/urdf/alex_nub_hands.urdf",
}
"""Files in DATA of robots that stand on the ground."""
FLOATING = {
    "a1": "a1_description/urdf/a1.urdf",
    "go1": "go1_description/urdf/go1.urdf",
    "go2": "go2_description/urdf/go2.urdf",
    "b1": "b1_description/urdf/b1.urdf",
    "b1_z1": "b1_description/urdf/b1-z1.urdf",
    "laikago": "laikago_description/urdf/laikago.urdf",
    "anymal_b": "anymal_b_simple_description/robots/anymal.urdf",
    "anymal_kinova": "anymal_b_simple_description/robots/anymal-kinova.urdf",
    "anymal_c": "anymal_c_simple_description/urdf/anymal.urdf",
    "hyq": "hyq_description/robots/hyq_no_sensors.urdf",
    "solo8": "solo_description/robots/solo.urdf",
    "solo12": "solo_description/robots/solo12.urdf",
    "bolt": "bolt_description/robots/bolt.urdf",
    "quadruped": "quadruped_description/urdf/quadruped.urdf",
    "centauro": "centauro_description/urdf/centauro.urdf",
    "g1": "g1_description/urdf/g1_29dof_rev_1_0.urdf",
    "g1_hands": "g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf",
    "human": "human_description/robots/human.urdf",
    "icub": "icub_description/robots/icub.urdf",
    "icub_reduced": "icub_description/robots/icub_reduced.urdf",
    "romeo_small": "romeo_description/urdf/romeo_small.urdf",
    "talos": "talos_data/robots/talos_full_v2.urdf",
    "talos_reduced": "talos_data/robots/talos_reduced.urdf",
    "simple_humanoid": "simple_humanoid_description/urdf/simple_humanoid.urdf",
}
"""Likewise of robots whose base floats."""


def file_of(name: str) -> Path:
    """Return the file of a robot, which is there if the package is installed."""
    return DATA / (FIXED | FLOATING)[name]


def model_of(name: str, *, floating: bool | None = None) -> Model | None:
    """Return a robot by its name, None where the package is not installed.

    Args:
        name: a key of FIXED or FLOATING.
        floating: whether its base floats, if not as these say.
    """
    path = file_of(name)
    if not path.is_file():
        return None
    return read_robot(path, floating=name in FLOATING if floating is None else floating).model
