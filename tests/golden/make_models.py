"""Writes the robots of generated_examples/models: solids of plausible size and mass, no one's data.

``python -m tests.golden.make_models`` rewrites the files; they are kept, as a user's would be.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

MODELS = Path(__file__).resolve().parents[2] / "generated_examples" / "models"


@dataclass(frozen=True)
class Solid:
    """A homogeneous solid: mass (kg), centre (m) and principal moments along x, y, z (kg m^2)."""

    mass: float
    centre: Sequence[float]
    moments: Sequence[float]


def box(mass: float, size: Sequence[float], centre: Sequence[float]) -> Solid:
    """Return a box with the given edges (m)."""
    x, y, z = (edge**2 for edge in size)
    return Solid(mass, centre, [mass * (y + z) / 12, mass * (x + z) / 12, mass * (x + y) / 12])


def cylinder(
    mass: float, radius: float, length: float, centre: Sequence[float], along: str = "z"
) -> Solid:
    """Return a cylinder along x, y or z."""
    across = mass * (3 * radius**2 + length**2) / 12
    axial = mass * radius**2 / 2
    return Solid(mass, centre, [axial if axis == along else across for axis in "xyz"])


def ball(mass: float, radius: float, centre: Sequence[float]) -> Solid:
    """Return a ball."""
    return Solid(mass, centre, [0.4 * mass * radius**2] * 3)


class Writer:
    """Collects the elements of one robot."""

    def __init__(self, name: str, words: str) -> None:
        self.lines = ['<?xml version="1.0"?>', f"<!-- {words} -->", f'<robot name="{name}">']

    def link(self, name: str, solid: Solid | None = None) -> None:
        """Add a link; without a solid it has no mass."""
        if solid is None:
            self.lines.append(f'  <link name="{name}"/>')
            return
        ixx, iyy, izz = (_number(moment) for moment in solid.moments)
        self.lines += [
            f'  <link name="{name}">',
            "    <inertial>",
            f'      <origin xyz="{_numbers(solid.centre)}"/>',
            f'      <mass value="{_number(solid.mass)}"/>',
            f'      <inertia ixx="{ixx}" ixy="0" ixz="0" iyy="{iyy}" iyz="0" izz="{izz}"/>',
            "    </inertial>",
            "  </link>",
        ]

    def joint(
        self,
        name: str,
        kind: str,
        links: tuple[str, str],
        place: Sequence[float] = (0.0, 0.0, 0.0),
        *,
        axis: Sequence[float] | None = None,
        rpy: Sequence[float] | None = None,
        limit: tuple[float, float, float, float] | None = None,
        mimic: tuple[str, float, float] | None = None,
    ) -> None:
        """Add a joint between a parent and a child link; limit: lower, upper, effort, velocity."""
        turn = "" if rpy is None else f' rpy="{_numbers(rpy)}"'
        self.lines += [
            f'  <joint name="{name}" type="{kind}">',
            f'    <parent link="{links[0]}"/>',
            f'    <child link="{links[1]}"/>',
            f'    <origin xyz="{_numbers(place)}"{turn}/>',
        ]
        if axis is not None:
            self.lines.append(f'    <axis xyz="{_numbers(axis)}"/>')
        if limit is not None:
            lower, upper, effort, velocity = (_number(value) for value in limit)
            self.lines.append(
                f'    <limit lower="{lower}" upper="{upper}" effort="{effort}"'
                f' velocity="{velocity}"/>'
            )
        if mimic is not None:
            self.lines.append(
                f'    <mimic joint="{mimic[0]}" multiplier="{_number(mimic[1])}"'
                f' offset="{_number(mimic[2])}"/>'
            )
        self.lines.append("  </joint>")

    def text(self) -> str:
        """Return the file."""
        return "\n".join([*self.lines, "</robot>", ""])


def _number(value: float) -> str:
    return f"{value:.6g}"


def _numbers(values: Sequence[float]) -> str:
    return " ".join(_number(value) for value in values)


X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
QUARTER = 1.5707963


def arm7() -> str:
    """A seven-joint arm on a pedestal, its gripper's right finger following the left one."""
    w = Writer("arm7", "seven revolute joints and a parallel gripper; the base is fixed")
    w.link("pedestal", cylinder(6.0, 0.09, 0.16, (0, 0, 0.08)))
    above = "pedestal"
    rows = (  # joint, link, place, rpy, upper limit, effort, solid
        ("base_yaw", "turret", (0, 0, 0.16), None, 2.9, 90, cylinder(3.6, 0.07, 0.2, (0, 0, 0.1))),
        ("shoulder_pitch", "upper_arm", (0, 0, 0.18), (-QUARTER, 0, 0), 1.8, 90,
         cylinder(3.1, 0.06, 0.24, (0, -0.1, 0), "y")),
        ("upper_arm_roll", "elbow_housing", (0, -0.3, 0), (QUARTER, 0, 0), 2.9, 60,
         cylinder(2.6, 0.055, 0.18, (0, 0, -0.03))),
        ("elbow_pitch", "forearm", (0.08, 0, 0), (QUARTER, 0, 0), 2.4, 60,
         cylinder(2.2, 0.05, 0.22, (-0.05, 0.1, 0), "y")),
        ("forearm_roll", "wrist_housing", (-0.08, 0.38, 0), (-QUARTER, 0, 0), 2.9, 15,
         cylinder(1.7, 0.045, 0.16, (0, 0.01, -0.08))),
        ("wrist_pitch", "wrist", (0, 0, 0), (QUARTER, 0, 0), 1.9, 15,
         ball(1.3, 0.05, (0.04, 0.01, 0))),
        ("flange_roll", "hand", (0.09, 0, 0), (QUARTER, 0, 0), 2.9, 15,
         box(0.73, (0.06, 0.2, 0.06), (0, 0, 0.1))),
    )  # fmt: skip
    for joint, link, place, rpy, upper, effort, solid in rows:
        w.link(link, solid)
        limit = (-upper, upper, effort, 2.2)
        w.joint(joint, "revolute", (above, link), place, axis=Z, rpy=rpy, limit=limit)
        above = link
    finger = box(0.05, (0.02, 0.02, 0.06), (0, 0.01, 0.03))
    for side, axis, turn in (("left", Y, None), ("right", Y, (0, 0, 2 * QUARTER))):
        w.link(f"{side}_finger", finger)
        w.joint(f"{side}_finger_slide", "prismatic", ("hand", f"{side}_finger"), (0, 0, 0.13),
                axis=axis, rpy=turn, limit=(0, 0.04, 30, 0.2),
                mimic=("left_finger_slide", 1, 0) if side == "right" else None)  # fmt: skip
    w.link("camera", box(0.12, (0.03, 0.09, 0.03), (0, 0, 0)))
    w.joint("camera_mount", "fixed", ("hand", "camera"), (0.06, 0, 0.02), rpy=(0, -0.3, 0))
    return w.text()


def humanoid() -> str:
    """A humanoid with 29 revolute joints; give it a floating base."""
    w = Writer("humanoid", "29 revolute joints, 42 kg; meant for a floating base")
    w.link("pelvis", box(6.2, (0.14, 0.22, 0.12), (0, 0, 0.02)))

    def chain(above: str, rows: Sequence[tuple[str, str, Sequence[float], Sequence[float], Solid]]
              ) -> None:  # fmt: skip
        for joint, link, place, axis, solid in rows:
            w.link(link, solid)
            limit = (-2.0, 2.0, 120.0, 10.0)
            w.joint(joint, "revolute", (above, link), place, axis=axis, limit=limit)
            above = link

    chain("pelvis", (
        ("waist_yaw", "waist_link", (0, 0, 0.09), Z, cylinder(0.8, 0.05, 0.06, (0, 0, 0.02))),
        ("waist_roll", "abdomen", (0, 0, 0.05), X, cylinder(0.9, 0.05, 0.08, (0, 0, 0.02))),
        ("waist_pitch", "torso", (0, 0, 0.04), Y, box(9.5, (0.16, 0.28, 0.34), (0.01, 0, 0.17))),
    ))  # fmt: skip
    chain("torso", (
        ("neck_yaw", "neck", (0, 0, 0.38), Z, cylinder(0.4, 0.03, 0.06, (0, 0, 0.02))),
        ("neck_pitch", "head", (0, 0, 0.06), Y, ball(2.4, 0.09, (0.02, 0, 0.09))),
    ))  # fmt: skip
    for side, s in (("left", 1), ("right", -1)):
        chain("pelvis", (
            (f"{side}_hip_pitch", f"{side}_hip", (0, 0.09 * s, -0.05), Y,
             cylinder(1.4, 0.05, 0.09, (0, 0.03 * s, 0), "y")),
            (f"{side}_hip_roll", f"{side}_groin", (0, 0.04 * s, 0), X,
             cylinder(1.2, 0.05, 0.08, (0.02, 0, -0.04), "x")),
            (f"{side}_hip_yaw", f"{side}_thigh", (0, 0, -0.12), Z,
             cylinder(2.6, 0.06, 0.26, (0, 0, -0.1))),
            (f"{side}_knee", f"{side}_shank", (0, 0, -0.24), Y,
             cylinder(1.8, 0.045, 0.28, (0.01, 0, -0.13))),
            (f"{side}_ankle_pitch", f"{side}_ankle", (0, 0, -0.3), Y, ball(0.2, 0.03, (0, 0, 0))),
            (f"{side}_ankle_roll", f"{side}_foot", (0, 0, -0.02), X,
             box(0.8, (0.2, 0.08, 0.03), (0.03, 0, -0.03))),
        ))  # fmt: skip
        chain("torso", (
            (f"{side}_shoulder_pitch", f"{side}_shoulder", (0, 0.15 * s, 0.29), Y,
             cylinder(0.8, 0.04, 0.07, (0, 0.03 * s, 0), "y")),
            (f"{side}_shoulder_roll", f"{side}_shoulder_cap", (0, 0.05 * s, 0), X,
             ball(0.7, 0.05, (0, 0.01 * s, -0.03))),
            (f"{side}_shoulder_yaw", f"{side}_upper_arm", (0, 0, -0.1), Z,
             cylinder(0.8, 0.04, 0.14, (0, 0, -0.05))),
            (f"{side}_elbow", f"{side}_forearm", (0, 0, -0.11), Y,
             cylinder(0.7, 0.035, 0.16, (0.02, 0, -0.07))),
            (f"{side}_wrist_roll", f"{side}_wrist", (0.01, 0, -0.16), Z,
             cylinder(0.2, 0.03, 0.05, (0, 0, -0.01))),
            (f"{side}_wrist_pitch", f"{side}_hand", (0, 0, -0.04), Y,
             box(0.4, (0.05, 0.08, 0.12), (0, 0, -0.06))),
        ))  # fmt: skip
    return w.text()


def human40() -> str:
    """A human figure as the paper's first: 1 floating, 10 spherical and 4 revolute joints."""
    w = Writer("human40", "a person of 70 kg: 1 floating, 10 spherical, 4 revolute joints, 40 DOF")
    w.link("world")
    w.link("pelvis", box(9.6, (0.16, 0.3, 0.2), (0, 0, 0.03)))
    w.joint("root", "floating", ("world", "pelvis"), (0, 0, 0.95))
    w.link("trunk", box(23.0, (0.18, 0.32, 0.46), (0, 0, 0.23)))
    w.joint("spine", "spherical", ("pelvis", "trunk"), (0, 0, 0.13))
    w.link("head", ball(4.9, 0.1, (0.01, 0, 0.14)))
    w.joint("neck", "spherical", ("trunk", "head"), (0, 0, 0.48))
    for side, s in (("left", 1), ("right", -1)):
        rows = (
            ("shoulder", "spherical", "trunk", "upper_arm", (0, 0.2 * s, 0.42),
             cylinder(1.9, 0.045, 0.28, (0, 0, -0.14))),
            ("elbow", "revolute", f"{side}_upper_arm", "forearm", (0, 0, -0.29),
             cylinder(1.1, 0.035, 0.25, (0, 0, -0.12))),
            ("wrist", "spherical", f"{side}_forearm", "hand", (0, 0, -0.26),
             box(0.42, (0.03, 0.08, 0.17), (0, 0, -0.08))),
            ("hip", "spherical", "pelvis", "thigh", (0, 0.09 * s, -0.04),
             cylinder(8.4, 0.08, 0.4, (0, 0, -0.19))),
            ("knee", "revolute", f"{side}_thigh", "shank", (0, 0, -0.41),
             cylinder(3.2, 0.05, 0.4, (0, 0, -0.18))),
            ("ankle", "spherical", f"{side}_shank", "foot", (0, 0, -0.41),
             box(1.0, (0.25, 0.09, 0.07), (0.06, 0, -0.04))),
        )  # fmt: skip
        for joint, kind, above, link, place, solid in rows:
            w.link(f"{side}_{link}", solid)
            revolute = kind == "revolute"
            w.joint(f"{side}_{joint}", kind, (above, f"{side}_{link}"), place,
                    axis=Y if revolute else None,
                    limit=(-2.5, 2.5, 150, 12) if revolute else None)  # fmt: skip
    return w.text()


def chain16() -> str:
    """Sixteen equal rods end to end, turning about x, y and z by turns."""
    w = Writer("chain16", "sixteen rods of 0.4 m and 1 kg, end to end; the base is fixed")
    w.link("ceiling")
    above = "ceiling"
    for k in range(1, 17):
        w.link(f"rod{k:02d}", cylinder(1.0, 0.02, 0.4, (0, 0, -0.2)))
        place = (0, 0, 0) if k == 1 else (0, 0, -0.4)
        axis = (X, Y, Z)[(k - 1) % 3]
        w.joint(f"joint{k:02d}", "continuous", (above, f"rod{k:02d}"), place, axis=axis)
        above = f"rod{k:02d}"
    return w.text()


def snake100() -> str:
    """A snake of 101 equal links with 100 hinges, about z and y by turns; it floats."""
    w = Writer("snake100", "101 equal links of 0.2 kg, 100 hinges; meant for a floating base")
    solid = cylinder(0.2, 0.03, 0.08, (0.04, 0, 0), "x")
    w.link("link000", solid)
    for k in range(1, 101):
        w.link(f"link{k:03d}", solid)
        w.joint(f"joint{k:03d}", "revolute", (f"link{k - 1:03d}", f"link{k:03d}"), (0.08, 0, 0),
                axis=(Y, Z)[k % 2], limit=(-1.5, 1.5, 7, 6))  # fmt: skip
    return w.text()


def mobile() -> str:
    """A planar base with a lift, a short arm on an oblique axis, and a load that floats in it."""
    w = Writer("mobile", "planar base, prismatic lift, arm, and a loose load; oblique axes")
    w.link("floor")
    w.link("cart", box(28.0, (0.6, 0.45, 0.2), (0, 0, 0.12)))
    w.joint("drive", "planar", ("floor", "cart"), axis=Z)
    w.link("mast", box(7.5, (0.12, 0.16, 0.7), (0, 0, 0.35)))
    w.joint("mast_mount", "fixed", ("cart", "mast"), (-0.15, 0, 0.22), rpy=(0, 0.05, 0))
    w.link("carriage", box(4.2, (0.14, 0.2, 0.14), (0.08, 0, 0)))
    w.joint("lift", "prismatic", ("mast", "carriage"), (0.06, 0, 0.1), axis=(0, 0, 2),
            limit=(0, 0.6, 400, 0.5))  # fmt: skip
    w.link("boom", cylinder(2.4, 0.04, 0.36, (0.18, 0, 0), "x"))
    w.joint("shoulder", "revolute", ("carriage", "boom"), (0.15, 0, 0.02), axis=(0.2, 1, -0.4),
            limit=(-1.8, 1.8, 60, 3))  # fmt: skip
    w.link("bowl", box(0.9, (0.16, 0.16, 0.05), (0.1, 0, 0)))
    w.joint("wrist", "continuous", ("boom", "bowl"), (0.38, 0, 0), axis=X, rpy=(0.1, -0.2, 0.3))
    w.link("load", ball(0.6, 0.05, (0.01, -0.02, 0.015)))
    w.joint("loose", "floating", ("bowl", "load"), (0.1, 0, 0.08), rpy=(0.3, 0, -0.2))
    w.link("laser", cylinder(0.35, 0.04, 0.06, (0, 0, 0.04)))
    w.joint("laser_spin", "continuous", ("cart", "laser"), (0.22, 0, 0.23), axis=(0, 0, -1))
    return w.text()


def fourbar() -> str:
    """A crank, a coupler and a rocker; fourbar.toml closes the loop."""
    w = Writer("fourbar", "crank-rocker linkage, cut open at the coupler; fourbar.toml closes it")
    w.link("ground")
    bars = (("crank", 0.2, 0.4), ("coupler", 0.5, 1.0), ("rocker", 0.4, 0.8))
    for name, length, mass in bars:
        w.link(name, box(mass, (length, 0.03, 0.03), (length / 2, 0, 0)))
    w.joint("crank_pin", "continuous", ("ground", "crank"), axis=Y)
    w.joint("coupler_pin", "continuous", ("crank", "coupler"), (0.2, 0, 0), axis=Y)
    w.joint("rocker_pin", "continuous", ("ground", "rocker"), (0.45, 0, 0), axis=Y)
    return w.text()


def ankle() -> str:
    """A leg whose ankle is moved by two motors in the shank, by cranks and rods on balls."""
    w = Writer("ankle", "a leg with a parallel ankle; ankle.toml closes both of its rods")
    w.link("pelvis")
    w.link("thigh", cylinder(6.0, 0.07, 0.4, (0, 0, -0.2)))
    w.link("shank", cylinder(3.5, 0.05, 0.4, (0, 0, -0.2)))
    w.link("ankle_cross", ball(0.15, 0.02, (0, 0, 0)))
    w.link("foot", box(1.0, (0.22, 0.09, 0.04), (0.04, 0, -0.05)))
    w.joint("hip", "revolute", ("pelvis", "thigh"), axis=Y, limit=(-1.5, 1.5, 90, 10))
    w.joint("knee", "revolute", ("thigh", "shank"), (0, 0, -0.4), axis=Y, limit=(0, 2.4, 120, 10))
    w.joint(
        "ankle_pitch",
        "revolute",
        ("shank", "ankle_cross"),
        (0, 0, -0.4),
        axis=Y,
        limit=(-0.8, 0.8, 0, 10),
    )
    w.joint("ankle_roll", "revolute", ("ankle_cross", "foot"), axis=X, limit=(-0.5, 0.5, 0, 10))
    for side, y, above in (("left", 0.05, 0.25), ("right", -0.05, 0.17)):
        w.link(f"{side}_crank", box(0.2, (0.06, 0.01, 0.02), (-0.03, 0, 0)))
        length = 0.4 - above
        w.link(f"{side}_rod", cylinder(0.15, 0.006, length, (0, 0, -length / 2)))
        w.joint(
            f"{side}_motor",
            "revolute",
            ("shank", f"{side}_crank"),
            (0, y, -above),
            axis=Y,
            limit=(-1, 1, 60, 10),
        )
        w.joint(f"{side}_ball", "spherical", (f"{side}_crank", f"{side}_rod"), (-0.06, 0, 0))
    return w.text()


ROBOTS = {
    "ankle": ankle,
    "arm7": arm7,
    "chain16": chain16,
    "fourbar": fourbar,
    "human40": human40,
    "humanoid": humanoid,
    "mobile": mobile,
    "snake100": snake100,
}


if __name__ == "__main__":
    MODELS.mkdir(parents=True, exist_ok=True)
    for name, make in ROBOTS.items():
        (MODELS / f"{name}.urdf").write_text(make(), encoding="utf-8", newline="\n")
