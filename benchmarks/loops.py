"""Mechanisms with closed loops: an emitted solver beside Pinocchio, and beside its own open tree.

    python -m benchmarks.loops [ROBOT.urdf ...] [--only NAME ...] [--rounds 5]
        [--write docs/records/loops.md]

A ROBOT.urdf is a mechanism of one's own; its loops are in it, or beside it in ROBOT.toml,
ROBOT.scene.toml or ROBOT.yaml (frame pairs). --only chooses among the mechanisms that are here.

Pinocchio is its constraintDynamics and lcaba, instantiated from the headers of its wheel; of its
builds (g++ and clang++, native and portable) the fastest counts. Programs run by turns; the least
median of all rounds counts. Where Pinocchio has no such loops (couplings), its cells are "-";
states are closed. The tree is the same robot with its loops left out.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from adagen.build import build_executable, find_toolchain
from adagen.emit import emit, stem_of
from adagen.errors import EnvironmentFault
from adagen.model import Model
from adagen.plan import make_plan
from adagen.reference.closed import closed_forward_dynamics, closed_states
from adagen.run import launch
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import States, write_states
from adagen.studies.bench.machine import machine
from adagen.studies.bench.peers import contestants
from benchmarks.closed_robots import MECHANISMS, of_file
from benchmarks.page import write_between_marks

STATES, REPEAT = 32, 200


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
        peers = f"{self.factors:.0f} | {self.lcaba:.0f} | {best / self.ours:.1f}"
        return (
            f"| {self.name} | {self.freedoms} | {self.rows} | {self.ours:.0f} | {self.tree:.0f} |"
            f" {self.ours / self.tree:.2f} | {peers if np.isfinite(best) else '- | - | -'} |"
            f" {self.error:.0e} |"
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
    rows = sum(loop.kind.rows for loop in model.loops) + len(model.couplings)
    row = Row(name, model.nv, rows)
    stem = "".join(c if c.isalnum() else "_" for c in name)
    ours = _executable(model, stem)
    tree = _executable(replace(model, loops=(), couplings=()), f"{stem}_tree")
    q, v = closed_states(model, STATES, starts=20 * STATES)
    tau = np.random.default_rng(1).uniform(-1, 1, (len(q), model.ntau))
    states = States(q, v, tau)
    row.error = _error(ours, model, states, folder)
    try:
        peers = contestants("pinocchio", model, states, folder)
    except EnvironmentFault as fault:  # loops or couplings that it has not
        print(f"{name}: Pinocchio: {fault}", file=sys.stderr)
        peers = []
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
    parser.add_argument("robots", nargs="*", type=Path, metavar="ROBOT.urdf")
    parser.add_argument("--only", nargs="*", choices=list(MECHANISMS), default=list(MECHANISMS))
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
    for name, make in {
        **{name: MECHANISMS[name] for name in options.only},
        **{p.stem: partial(of_file, p) for p in options.robots},
    }.items():
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
