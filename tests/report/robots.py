"""Robots to report on, and what was made of them."""

from __future__ import annotations

from pathlib import Path

from adagen.library import Compiled, compile, read  # noqa: A004
from adagen.studies.chart import Chart, Point
from tests.urdf.texts import Y, joint, link, robot

HOSTILE = "</script><img src=x onerror=alert(1)>&'"


def every_kind() -> str:
    """A robot with a joint of each kind, and one that follows another."""
    z = '<axis xyz="1 2 -3"/>'
    turned = '<origin xyz="0.1 -0.2 0.3" rpy="0.4 -0.5 0.6"/>'
    escaped = HOSTILE.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    parts = [link(name) for name in "abcdefgh"]
    kinds = ("revolute", "prismatic", "spherical", "planar", "floating", "continuous", "revolute")
    for k, kind in enumerate(kinds):
        name = escaped if k == 0 else f"j{k}"
        follows = '<mimic joint="j5" multiplier="-2" offset="0.25"/>' if k == 6 else ""
        axis = z if kind in ("revolute", "planar", "prismatic") else Y
        inside = axis + follows if kind not in ("spherical", "floating") else ""
        parts.append(joint(name, "abcdefgh"[k], "abcdefgh"[k + 1], kind, inside, turned))
    return robot(*parts, attributes=f' name="{escaped}"')


def compiled(folder: Path, text: str, **words: object) -> Compiled:
    """Compile a URDF's text."""
    path = folder / "robot.urdf"
    path.write_text(text)
    return compile(read(path, mimic="<mimic" in text), **words)  # type: ignore[arg-type]


def chart(name: str, dof: int = 9, mechanism: str = "") -> Chart:
    """A record of six variants, three of them on the front."""
    points = [
        Point(
            f"variant {k}", ("adagen", "baseline")[k % 2], "aba", "auto", "double", 1, 0, "auto",
            time_ns=200.0 + 100 * k, source="clock", error=10.0 ** -(9 + k - 3 * (k % 2)),
            front=k % 2 == 0,
        )
        for k in range(6)
    ]  # fmt: skip
    failed = Point("none", "adagen", "aba", "auto", "float", 1, 0, "auto", why="it fails")
    return Chart(name, dof, 20, 100, 5, "a machine", (*points, failed), mechanism)
