"""Small robots for the command line."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

LINK = (
    '<link name="{name}"><inertial><mass value="1.5"/><origin xyz="0.01 0.02 0.1"/>'
    '<inertia ixx="0.02" iyy="0.03" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>'
)
JOINT = (
    '<joint name="{name}" type="continuous"><parent link="{parent}"/><child link="{child}"/>'
    '<axis xyz="{axis}"/><origin xyz="0 0.1 0.3"/></joint>'
)
Said = Callable[[], tuple[str, str]]


def write_arm(path: Path, joints: int = 3, name: str = "arm") -> Path:
    """Write a chain whose axes are not parallel."""
    parts = [LINK.format(name="l0")]
    for j in range(joints):
        parts.append(LINK.format(name=f"l{j + 1}"))
        axis = ("1 0 0", "0 1 0", "0 0 1")[j % 3]
        parts.append(JOINT.format(name=f"j{j}", parent=f"l{j}", child=f"l{j + 1}", axis=axis))
    path.write_text(f'<robot name="{name}">{"".join(parts)}</robot>')
    return path


def write_points(path: Path) -> Path:
    """Write a chain of six point masses at the ends of rods; axes are across the rods."""
    text = write_arm(path, 6).read_text()
    text = re.sub(r'\b(i[xyz]{2})="[^"]*"', r'\1="0"', text)
    text = text.replace("0.01 0.02 0.1", "0 0 0.3").replace("0 0.1 0.3", "0 0 0.3")
    path.write_text(text.replace('axis xyz="0 0 1"', 'axis xyz="1 0 0"'))
    return path


_BODY = (
    '<inertial><origin xyz="0 0 {}"/><mass value="{}"/>'
    '<inertia ixx="{}" iyy="{}" izz="{}" ixy="0" ixz="0" iyz="0"/></inertial>'
)
BALL = f"""<robot name="ball"><link name="base"/>
<link name="light">{_BODY.format(0, 1e-6, 1e-13, 1e-13, 1e-13)}</link>
<link name="rod">{_BODY.format(0.15, 1, 0.0075, 0.0075, 0.0002)}</link>
<link name="tip">{_BODY.format(0.15, 1, 0.0075, 0.0075, 0.0002)}</link>
<joint name="ball" type="spherical"><parent link="base"/><child link="light"/></joint>
<joint name="along" type="continuous"><parent link="light"/><child link="rod"/><axis xyz="0 0 1"/>
</joint><joint name="across" type="continuous"><parent link="rod"/><child link="tip"/>
<origin xyz="0 0 0.3"/><axis xyz="0 1 0"/></joint></robot>"""
"""A ball joint that moves hardly any mass about the axis of the next joint."""
