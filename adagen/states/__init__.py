"""The states file: what to solve for, by joint name; and the result file.

States are ``{"floating": bool, "gravity": [x, y, z], "joints": {NAME: {"q": [...], "v": [...],
"tau": [...]}}}`` with one entry per state in each list: a number for one degree of freedom, a list
for more. Where a scene prescribes a joint's acceleration, its "qdd" stands in place of its "tau";
where it names links on which outer forces act, "forces": {LINK: [[fx, fy, fz, nx, ny, nz], ...]}
gives force (N) and moment (N m) at the link's origin in its axes, for each state. Results are
``{"joints": {NAME: {"qdd": [...]}}}`` likewise.
"""

from __future__ import annotations

from adagen.states.read import StatesFile, read_result, read_states
from adagen.states.sampling import hardened, random_states, resting_states
from adagen.states.types import States
from adagen.states.write import states_text, write_states

__all__ = [
    "States",
    "StatesFile",
    "hardened",
    "random_states",
    "read_result",
    "read_states",
    "resting_states",
    "states_text",
    "write_states",
]
