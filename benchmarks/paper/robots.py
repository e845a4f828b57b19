"""The robots of the paper's experiments, made here: serial chains and three human figures.

The paper gives numbers of joints and freedoms only; bodies here are of plausible size and mass.
"""

from __future__ import annotations

from adagen.studies.bench.figures import Joint, chain, urdf

__all__ = ["HUMANS", "chain", "human"]


def human(dofs: int) -> str:
    """Return a human figure of 40, 52 or 161 degrees of freedom (URDF)."""
    return urdf(f"human{dofs}", HUMANS[dofs])


def _path(above: str, words: str, dofs: int = 3, hinges: str = "") -> list[Joint]:
    """Return joints one behind the other; those named in ``hinges`` have one freedom."""
    rows = []
    for name in words.split():
        rows.append(Joint(name, above, 1 if name in hinges.split() else dofs))
        above = name
    return rows


def _limbs(above: str, names: str, hinges: str) -> list[Joint]:
    """Return a left and a right limb."""
    rows = []
    for side in ("l", "r"):
        words = " ".join(f"{side}_{name}" for name in names.split())
        rows += _path(above, words, hinges=" ".join(f"{side}_{name}" for name in hinges.split()))
    return rows


def _thumbs() -> list[Joint]:
    return [Joint(f"{side}_thumb", f"{side}_hand", 3) for side in ("l", "r")]


SPINE = "T12 T11 T10 T9 T8 T7 T6 T5 T4 T3 T2 T1 C7 C6 C5 C4 C3 C2 skull"

HUMANS: dict[int, list[Joint]] = {
    # 15 joints: 1 free, 10 spherical, 4 hinges
    40: [
        Joint("pelvis", "ground", 6),
        *_path("pelvis", "torso head"),
        *_limbs("torso", "shoulder elbow wrist", "elbow"),
        *_limbs("pelvis", "hip knee ankle", "knee"),
    ],
    # 19 joints: 1 free, 14 spherical, 4 hinges
    52: [
        Joint("pelvis", "ground", 6),
        *_path("pelvis", "waist chest neck head"),
        *_limbs("chest", "clavicle shoulder elbow wrist", "elbow"),
        *_limbs("pelvis", "hip knee ankle", "knee"),
    ],
    # 53 joints: 2 free, 49 spherical, 2 hinges; with one free joint 161 freedoms in 53 joints of
    # 1, 3 and 6 are impossible, so that the spine floats on the pelvis.
    161: [
        Joint("pelvis", "ground", 6),
        Joint("L5", "pelvis", 6),
        *_path("L5", "L4 L3 L2 L1 " + SPINE),
        *_limbs("T1", "clavicle scapula shoulder elbow wrist hand fingers fingertips", ""),
        *_thumbs(),
        *_limbs("pelvis", "hip knee ankle midfoot toes", "knee"),
    ],
}
