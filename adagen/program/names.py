"""Names of operations that carry out no step of their own; others have ``step.does``."""

from __future__ import annotations

PREPARES: dict[str, str] = {
    "angles": "sines, cosines and orientations of joints, several in one register",
    "place_inertia": "a link's own inertia put where others are added",
    "link_columns": "link inertias by columns, for runs that are swept by columns",
}
"""Operations that prepare steps and carry out none, or only a part of one."""

PASSING = "pass_kinematics"
"""Kinematics of joints that are only passed on the way to others."""

PREPARED = (
    "angles",
    "kinematics",
    PASSING,
    "traverse",
    "append",
    "arrive",
    "link_inertia",
    "solve_coupling",
    "apply_coupling",
)
"""What operations of loops do once, however many right-hand sides there are."""
