"""URDF text for tests, put together from pieces."""

from __future__ import annotations

ORIGIN = '<origin xyz="0 0 0.1" rpy="0 0 0"/>'
INERTIA = '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>'
MASS = '<mass value="1"/>'
BODY = f"<inertial>{ORIGIN}{MASS}{INERTIA}</inertial>"
Y = '<axis xyz="0 1 0"/>'


def link(name: str, inside: str = BODY) -> str:
    """A link with a body, or with what is told."""
    return f'<link name="{name}">{inside}</link>\n'


def joint(
    name: str,
    parent: str,
    child: str,
    kind: str = "revolute",
    inside: str = Y,
    origin: str = '<origin xyz="0 0 0.2" rpy="0 0 0"/>',
) -> str:
    """A joint about y, 0.2 m above its parent, or as told."""
    return (
        f'<joint name="{name}" type="{kind}">{origin}<parent link="{parent}"/>'
        f'<child link="{child}"/>{inside}</joint>\n'
    )


def robot(*parts: str, attributes: str = ' name="r"', head: str = '<?xml version="1.0"?>\n') -> str:
    """A robot; links and joints start in line 3, each in a line of its own."""
    return f"{head}<robot{attributes}>\n{''.join(parts)}</robot>\n"


def pair(b: str = BODY, j: str = Y, kind: str = "revolute") -> str:
    """Links a (line 3) and b (line 4), joint j1 (line 5)."""
    return robot(link("a"), link("b", b), joint("j1", "a", "b", kind, j))


def chain(count: int) -> str:
    """Links l0 ... and continuous joints j1 ... in a row, axes in turn x, y, z, from link l0 on."""
    axes = ("1 0 0", "0 1 0", "0 0 1")
    parts = [link("l0")]
    for i in range(1, count + 1):
        parts.append(link(f"l{i}"))
        axis = f'<axis xyz="{axes[i % 3]}"/>'
        parts.append(joint(f"j{i}", f"l{i - 1}", f"l{i}", "continuous", axis))
    return robot(*parts)
