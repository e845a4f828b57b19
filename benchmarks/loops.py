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

import tempfile
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from adagen.errors import EnvironmentFault
from adagen.model import Model
from adagen.plan import make_plan
from adagen.reference.closed import closed_forward_dynamics, closed_states
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import States
from adagen.studies.bench.contest import Contestant
from adagen.studies.bench.machine import machine
from adagen.studies.bench.peers import contestants
from adagen.studies.bench.report import table
from benchmarks.closed_robots import MECHANISMS, of_file
from benchmarks.page import command, publish
from benchmarks.solvers import by_turns, contestant, source_of, tell

STATES, REPEAT = 32, 200
HEAD = ("mechanism", "freedoms", "rows", "adagen", "its tree", "ratio", "constraintDynamics")


def _solver(name: str, model: Model) -> Contestant:
    plan = make_plan(model, best_schedule(model, 1, load_profile("default")))
    return contestant(name, model, plan, source_of(plan))


def measured(name: str, model: Model, rounds: int, folder: Path) -> tuple[object, ...]:
    """Return a mechanism's row of the table: medians, ns."""
    ours = _solver("ours", model)
    tree = _solver("tree", replace(model, loops=(), couplings=()))
    q, v = closed_states(model, STATES, starts=20 * STATES)
    tau = np.random.default_rng(1).uniform(-1, 1, (len(q), model.ntau))
    states = States(q, v, tau)
    try:
        peers = contestants("pinocchio", model, states, folder)
    except EnvironmentFault as fault:  # loops or couplings that it has not
        tell(f"{name}: Pinocchio: {fault}")
        peers = []
    times = by_turns([ours, tree, *peers], rounds, REPEAT)
    least = {who: min(found["in_place"].turns) for who, found in times.items()}
    rows = sum(loop.kind.rows for loop in model.loops) + len(model.couplings)
    cells = [name, model.nv, rows, *(f"{least[who]:.0f}" for who in ("ours", "tree"))]
    cells.append(f"{least['ours'] / least['tree']:.2f}")
    if peers:
        lcaba = min(time for who, time in least.items() if "lcaba" in who)
        factors = min(least[one.name] for one in peers if "lcaba" not in one.name)
        cells += [f"{factors:.0f}", f"{lcaba:.0f}", f"{min(factors, lcaba) / least['ours']:.1f}"]
    else:
        cells += ["-"] * 3
    return *cells, f"{_error(ours, model, states):.0e}"


def _error(solver: Contestant, model: Model, states: States) -> float:
    worst = 0.0
    for state, own in zip(states.each, solver.solve(states), strict=True):
        truth = closed_forward_dynamics(model, *state)
        worst = max(worst, float(np.abs(own - truth).max() / np.abs(truth).max()))
    return worst


def main() -> None:
    """Print the table, or put it into a document."""
    parser = command(__doc__)
    parser.add_argument("robots", nargs="*", type=Path, metavar="ROBOT.urdf")
    parser.add_argument("--only", nargs="*", choices=list(MECHANISMS), default=list(MECHANISMS))
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    here, rows = machine(), []
    asked = {name: MECHANISMS[name] for name in options.only}
    asked |= {file.stem: partial(of_file, file) for file in options.robots}
    for name, make in asked.items():
        with tempfile.TemporaryDirectory() as folder:
            rows.append(measured(name, make(), options.rounds, Path(folder)))
        tell(", ".join(map(str, rows[-1])))
    lines = [
        f"{here['processor']}, {here['cores']} cores; {options.rounds} rounds; ns, medians.",
        "",
        *table((*HEAD, "lcaba", "faster than the better", "error"), rows),
    ]
    publish(options, "loops", "\n".join(lines))


if __name__ == "__main__":
    main()
