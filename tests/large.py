"""A human figure of 161 degrees of freedom: 1 floating, 51 spherical and 2 revolute joints."""

from __future__ import annotations

from adagen.model import BASE, FLOATING, REVOLUTE, SPHERICAL, Model
from tests.models import AXES, Part, assemble, rod, vector


def human161() -> Model:
    """Return a figure with a spine of 25 joints, a jaw, and five fingers on each hand."""
    parts = [Part(BASE, None, FLOATING, rod(11.0, vector(0.0, 0.0, 0.15), 0.13))]

    def add(name: str, above: str, place: tuple[float, ...], tip: tuple[float, ...], mass: float,
            revolute: bool = False) -> str:  # fmt: skip
        kind, axis = (REVOLUTE, AXES["y"]) if revolute else (SPHERICAL, AXES["z"])
        body = rod(mass, vector(*tip), 0.3 * float(abs(vector(*tip)).max()))
        parts.append(Part(name, above, kind, body, vector(*place), axis=vector(*axis)))
        return name

    above = BASE
    for k in range(25):
        above = add(f"spine{k:02d}", above, (0.0, 0.0, 0.03), (0.0, 0.0, 0.03), 1.1)
    add("skull", above, (0.0, 0.0, 0.03), (0.0, 0.0, 0.2), 4.2)
    add("jaw", "skull", (0.08, 0.0, 0.02), (0.06, 0.0, -0.02), 0.3)
    for side, s in (("left", 1.0), ("right", -1.0)):
        clavicle = add(f"{side}_clavicle", "spine20", (0.0, 0.0, 0.03), (0.0, 0.17 * s, 0.02), 0.9)
        shoulder = add(f"{side}_shoulder", clavicle, (0.0, 0.17 * s, 0), (0.0, 0.0, -0.28), 1.9)
        elbow = add(f"{side}_elbow", shoulder, (0.0, 0.0, -0.28), (0.0, 0.0, -0.25), 1.1, True)
        wrist = add(f"{side}_wrist", elbow, (0.0, 0.0, -0.25), (0.0, 0.0, -0.09), 0.3)
        for finger in range(5):
            place = (0.0, 0.02 * (finger - 2), -0.09)
            add(f"{side}_finger{finger}", wrist, place, (0.0, 0.0, -0.08), 0.03)
        hip = add(f"{side}_hip", BASE, (0.0, 0.09 * s, -0.03), (0.0, 0.0, -0.41), 8.4)
        knee = add(f"{side}_knee", hip, (0.0, 0.0, -0.41), (0.0, 0.0, -0.41), 3.2)
        ankle = add(f"{side}_ankle", knee, (0.0, 0.0, -0.41), (0.15, 0.0, -0.06), 0.8)
        add(f"{side}_toes", ankle, (0.15, 0.0, -0.06), (0.06, 0.0, 0.0), 0.2)
    return assemble("human161", parts, floating=True)
