"""Robots that are made to be timed: chains, and figures of joints with names, as URDF.

Bodies are of plausible size and mass.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

KINDS = {1: "revolute", 3: "spherical", 6: "floating"}
AXES = ("1 0 0", "0 1 0", "0 0 1")


class Joint(NamedTuple):
    """A joint: its name, the link above (the name of that link's own joint), its freedoms."""

    name: str
    above: str
    dofs: int


def chain(joints: int, axes: Sequence[str] = AXES) -> str:
    """Return a serial chain of hinges about axes by turns, its root link fixed (URDF)."""
    rows = [Joint(f"q{j}", f"q{j - 1}" if j else "ground", 1) for j in range(joints)]
    return urdf(f"chain{joints}", rows, axes)


def urdf(name: str, joints: list[Joint], axes: Sequence[str] = AXES) -> str:
    """Return a robot of capsule-like links, one for each joint, hinges about axes by turns (URDF).

    Args:
        name: of the robot.
        joints: its joints, after those above them.
        axes: of hinges, each as URDF writes it.
    """
    lines = ['<?xml version="1.0"?>', f'<robot name="{name}">', '  <link name="ground"/>']
    for i, joint in enumerate(joints):
        mass = 0.8 + 0.1 * (i % 5)
        length = 0.12 + 0.01 * (i % 4)
        across, along = mass * length**2 / 12 + 1e-3, mass * 4e-3
        inertia = f'ixx="{across:.6g}" iyy="{across:.6g}" izz="{along:.6g}"'
        place = f"{0.01 * (i % 3):.6g} 0 {length if joint.above != 'ground' else 0:.6g}"
        lines += [
            f'  <link name="{joint.name}_link"><inertial>',
            f'    <origin xyz="0 0 {length / 2:.6g}"/><mass value="{mass:.6g}"/>',
            f'    <inertia {inertia} ixy="0" ixz="0" iyz="0"/>',
            "  </inertial></link>",
            f'  <joint name="{joint.name}" type="{KINDS[joint.dofs]}">',
            f'    <parent link="{_link(joint.above)}"/><child link="{joint.name}_link"/>',
            f'    <origin xyz="{place}"/>',
        ]
        if joint.dofs == 1:
            lines.append(f'    <axis xyz="{axes[i % len(axes)]}"/>')
            lines.append('    <limit lower="-3" upper="3" effort="100" velocity="10"/>')
        lines.append("  </joint>")
    return "\n".join([*lines, "</robot>", ""])


def _link(joint: str) -> str:
    return joint if joint == "ground" else f"{joint}_link"
