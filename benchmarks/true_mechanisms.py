"""Mechanisms with true answers: the largest error of each, beside its tolerance.

    python -m benchmarks.true_mechanisms FOLDER [--kept FILE] [--from 0] [--to N]
        [--write docs/records/loops.md]

FOLDER has NAME.urdf, NAME.scene.toml and NAME.json for each: states, true accelerations and how
far they can be known (tolerance), or that it is to be refused. Plans of both forms on one and on
two processes are carried out in double as straight lines are. With --kept what
was found is added to a file, and the command again goes on from there.
"""

from __future__ import annotations

import json
import sys
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from adagen.errors import InputError, UsageError
from adagen.executor import interpret
from adagen.library import read
from adagen.model import Model
from adagen.plan import make_plan
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.studies.bench.report import table
from benchmarks.page import Record, command, publish
from benchmarks.solvers import tell

WAYS = (("segment", 1), ("segment", 2), ("ada", 1), ("ada", 2))


def _worst(model: Model, form: str, processes: int, joints: dict[str, Any]) -> float | str:
    """Return the largest error over the states, or why they are refused."""
    worst = 0.0
    try:
        schedule = best_schedule(model, processes, load_profile("default"), form)
        plan = make_plan(model, schedule, form=form)
        for s in range(len(next(iter(joints.values()))["q"])):
            q, v, tau, truth = (
                np.hstack([np.ravel(joints[j.name][key][s]) for j in model.joints])
                for key in ("q", "v", "tau", "qdd")
            )
            found = interpret(plan, q, v, tau, once=True)
            error = np.abs(found - truth).max() / max(1.0, np.abs(truth).max())
            worst = max(worst, float(error))
    except (InputError, UsageError, FloatingPointError) as refusal:
        return str(refusal).removeprefix("error: ")
    return worst


def examined(folder: Path, name: str, mode: str, expected: dict[str, Any]) -> dict[str, Any]:
    """Return what was found of a mechanism on a fixed or floating base, as JSON has it."""
    answer, joints = expected.get("answer", "qdd"), expected.get("joints") or {}
    for joint in joints.values():
        joint.setdefault("qdd", joint["v"])
    found: list[float | str] = []
    try:
        urdf, scene = folder / f"{name}.urdf", folder / f"{name}.scene.toml"
        model = read(urdf, scene=scene, floating=mode == "floating").model
        found = [_worst(model, form, count, joints) for form, count in WAYS]
    except InputError as refusal:
        found = [str(refusal).removeprefix("error: ")] * len(WAYS)
    limit = expected.get("tolerance")
    return {"answer": answer, "limit": limit, "errors": found}


def good(row: dict[str, Any]) -> bool:
    """Whether answers are right, and what must be refused is; form ada may refuse what it lacks."""
    for k, one in enumerate(row["errors"]):
        if isinstance(one, str):
            if row["answer"] == "qdd" and WAYS[k][0] == "segment":
                return False
        elif row["answer"] == "refuse" or not one <= row["limit"]:
            return False
    return True


def _cells(row: dict[str, Any]) -> tuple[str, ...]:
    limit = row["limit"]
    errors = [x for x in row["errors"] if not isinstance(x, str)]
    told = ["refused" if isinstance(x, str) else f"{x:.0e}" for x in row["errors"]]
    share = f"{max(errors) / limit:.0e}" if errors and limit else "-"
    limits = f"{limit:.0e}" if limit else "refusal"
    return limits, *told, share


def main() -> int:
    """Print the table, or put it into a document."""
    parser = command(__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--kept", type=Path)
    parser.add_argument("--from", dest="first", type=int, default=0)
    parser.add_argument("--to", type=int, default=10**6)
    options = parser.parse_args()
    record = Record(options.kept)
    scenes = sorted(options.folder.glob("*.scene.toml"))
    for scene in scenes[options.first : options.to]:
        name = scene.name.removesuffix(".scene.toml")
        modes = json.loads(scene.with_name(f"{name}.json").read_text(encoding="utf-8"))["modes"]
        for mode, expected in modes.items():
            find = partial(examined, options.folder, name, mode, expected)
            row = record.of({"name": name, "mode": mode}, find)
            tell(f"{name}, {mode}: {', '.join(_cells(row))}")
    rows = {(row["name"], row["mode"]): row["found"] for row in record.rows}
    head = ("mechanism", "base", "tolerance", "segment", "segment, P = 2", "ada", "ada, P = 2")
    lines = table(
        (*head, "error / tolerance"), [(*key, *_cells(rows[key])) for key in sorted(rows)]
    )
    publish(options, "true_mechanisms", "\n".join(lines))
    bad = [f"{name} ({mode})" for (name, mode), row in rows.items() if not good(row)]
    if bad:
        tell(f"not as they must be: {', '.join(sorted(bad))}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
