"""Mechanisms with closed loops: an emitted solver beside Pinocchio, and beside its own open tree.

    python -m benchmarks.loops [--rounds 5] [--write docs/records/loops.md]

Pinocchio is its constraintDynamics and lcaba, instantiated from the headers of its wheel; of its
builds (g++ and clang++, native and portable) the fastest counts. Programs run by turns; the least
median of all rounds counts. Loops are points and welds, which Pinocchio has too; states are
closed. The tree is the same robot with its loops left out.
"""

from __future__ import annotations

import argparse
import json
import sys
import sysconfig
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from adagen.build import build_executable, find_toolchain
from adagen.emit import emit, stem_of
from adagen.errors import EnvironmentFault
from adagen.library import read
from adagen.model import LoopEnd, Model, NamedLoop, closed
from adagen.plan import make_plan
from adagen.reference.closed import closed_forward_dynamics, closed_states, pose_of
from adagen.run import launch
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import States, write_states
from adagen.studies.bench.machine import machine
from adagen.studies.bench.peers import contestants
from benchmarks.page import write_between_marks

STATES, REPEAT = 32, 200
ROBOTS = Path(
    sysconfig.get_path("purelib"), "cmeel.prefix", "share", "example-robot-data", "robots"
)
EXAMPLES = Path(__file__).resolve().parents[1] / "generated_examples" / "models"


def _standing(file: str, *feet: str, kind: str) -> Model:
    """Return a robot on a floating base whose feet are held by the ground where they are."""
    model = read(ROBOTS / file, floating=True).model
    rest = np.zeros(model.nq)
    for j, joint in enumerate(model.joints):
        if joint.kind.quaternion is not None:
            rest[model.q_start[j] + joint.kind.nq - 1] = 1.0
    links = {link.name: (k, None) for k, link in enumerate(model.links)}
    links.update({f.name: (k, f) for k, link in enumerate(model.links) for f in link.frames})
    loops = []
    for foot in feet:
        number, frame = links[foot]
        turn, place = pose_of(model, rest, number)
        if frame is not None:
            place = place + turn @ frame.translation
        x, y, z = (float(value) for value in place)
        ends = LoopEnd(foot), LoopEnd("__world__", (x, y, z))
        loops.append(NamedLoop(foot, kind, *ends))
    return closed(model, loops, (), links.__getitem__, {}.__getitem__)


def _of_example(name: str) -> Model:
    return read(EXAMPLES / f"{name}.urdf", scene=EXAMPLES / f"{name}.toml").model


MECHANISMS: dict[str, Callable[[], Model]] = {
    "four-bar": lambda: _of_example("fourbar"),
    "leg with a parallel ankle": lambda: _of_example("ankle"),
    "g1 on both feet": lambda: _standing(
        "g1_description/urdf/g1_29dof_rev_1_0.urdf",
        "left_ankle_roll_link",
        "right_ankle_roll_link",
        kind="weld",
    ),
    "a1 on four point feet": lambda: _standing(
        "a1_description/urdf/a1.urdf", "FL_foot", "FR_foot", "RL_foot", "RR_foot", kind="point"
    ),
    "talos on both feet": lambda: _standing(
        "talos_data/robots/talos_reduced.urdf", "leg_left_6_link", "leg_right_6_link", kind="weld"
    ),
}


@dataclass
class Row:
    """Medians of a mechanism, ns."""

    name: str
    freedoms: int
    rows: int
    ours: float = np.inf
    tree: float = np.inf
    factors: float = np.inf
    lcaba: float = np.inf
    error: float = 0.0

    def cells(self) -> str:
        """Return the row of the table."""
        best = min(self.factors, self.lcaba)
        return (
            f"| {self.name} | {self.freedoms} | {self.rows} | {self.ours:.0f} | {self.tree:.0f} |"
            f" {self.ours / self.tree:.2f} | {self.factors:.0f} | {self.lcaba:.0f} |"
            f" {best / self.ours:.1f} | {self.error:.0e} |"
        )


def _executable(model: Model, name: str) -> Path:
    plan = make_plan(model, best_schedule(model, 1, load_profile("default")))
    files = emit(plan, name=name)
    stem = stem_of(plan, name)
    return build_executable(files[f"{stem}.cpp"], stem, find_toolchain())


def _ours(executable: Path) -> float:
    words = ["--time", "--json", "--repeat", str(REPEAT)]
    done = launch(executable, 1, words, find_toolchain())
    if done.status != 0:
        raise EnvironmentFault(done.stderr)
    return float(json.loads(done.stdout)["time"]["in_place"]["median_ns"])


def measured(name: str, model: Model, rounds: int, folder: Path) -> Row:
    """Return what a mechanism takes."""
    row = Row(name, model.nv, sum(loop.kind.rows for loop in model.loops))
    stem = "".join(c if c.isalnum() else "_" for c in name)
    ours = _executable(model, stem)
    tree = _executable(replace(model, loops=()), f"{stem}_tree")
    q, v = closed_states(model, STATES, starts=20 * STATES)
    tau = np.random.default_rng(1).uniform(-1, 1, (len(q), model.ntau))
    states = States(q, v, tau)
    row.error = _error(ours, model, states, folder)
    peers = contestants("pinocchio", model, states, folder)
    for _ in range(rounds):
        row.ours, row.tree = min(row.ours, _ours(ours)), min(row.tree, _ours(tree))
        for peer in peers:
            took = peer.turn(REPEAT)["in_place"].median
            if "lcaba" in peer.name:
                row.lcaba = min(row.lcaba, took)
            else:
                row.factors = min(row.factors, took)
    return row


def _error(executable: Path, model: Model, states: States, folder: Path) -> float:
    given, result = folder / "states.json", folder / "result.json"
    write_states(states, model, given)
    words = ["--states", str(given), "--result", str(result)]
    launch(executable, 1, words, find_toolchain())
    found = json.loads(result.read_text())["joints"]
    worst = 0.0
    for s, state in enumerate(zip(states.q, states.v, states.tau, strict=True)):
        truth = closed_forward_dynamics(model, *state)
        own = np.hstack([np.ravel(found[joint.name]["qdd"][s]) for joint in model.joints])
        worst = max(worst, float(np.abs(own - truth).max() / np.abs(truth).max()))
    return worst


def main() -> int:
    """Print the table, or put it into a document."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--write", type=Path)
    options = parser.parse_args()
    here = machine()
    lines = [
        f"{here['processor']}, {here['cores']} cores; {options.rounds} rounds; ns, medians.",
        "",
        "| mechanism | freedoms | rows | adagen | its tree | ratio | constraintDynamics | lcaba |"
        " faster than the better | error |",
        "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|",
    ]
    for name, make in MECHANISMS.items():
        with tempfile.TemporaryDirectory() as folder:
            row = measured(name, make(), options.rounds, Path(folder))
        print(row.cells(), file=sys.stderr)
        lines.append(row.cells())
    if options.write is None:
        print("\n".join(lines))
    else:
        write_between_marks(options.write, "loops", "\n".join(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main())
