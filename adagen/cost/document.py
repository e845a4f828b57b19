"""The JSON file of a schedule: the choice, its program, predicted times and bounds."""

from __future__ import annotations

import math
from typing import Any

from adagen.cost.simulation import Timeline
from adagen.program import Program
from adagen.program.summary import lanes, meeting, owners
from adagen.schedule import Schedule, Topology, deepjson, schedule_to_dict


def schedule_document(
    schedule: Schedule, topology: Topology, program: Program, line: Timeline | None
) -> str:
    """Return a schedule and its program as JSON in one line, without a newline at its end.

    Given back with --schedule, it makes the same program; its tree, or where processes gather, and
    its shape may be edited.

    Args:
        schedule: as it is emitted; with where processes gather, if they do.
        topology: the robot.
        program: what is emitted of it.
        line: how that is predicted to go; None where the profile prices joins alone.
    """
    data = schedule_to_dict(schedule, topology, costs=line is None)
    tail = {key: data.pop(key) for key in ("root", "gathered") if key in data}
    names = topology.names
    if not schedule.families:
        data["families"] = ["alone" if schedule.processes == 1 else schedule.strategy]
    data["shape"] = program.shape
    if program.plan.reproducible:
        data["reproducible"] = True
    data["at_work"] = meeting(program)
    data["owners"] = owners(program)
    data["lanes"] = [
        {
            "process": p,
            "lanes": limbs.lanes,
            "limbs": [[names[j] for j in chain] for chain in zip(*limbs.rows, strict=True)],
        }
        for p, limbs in lanes(program)
    ]
    if line is not None:
        data |= _priced(schedule, line, len(program.processes))
    return deepjson.dumps(data | tail)


def _priced(schedule: Schedule, line: Timeline, processes: int) -> dict[str, Any]:
    """Predicted times and bounds, by the price that was used in the search."""
    time = line.makespan
    searched = math.isclose(time, schedule.makespan, rel_tol=1e-9)
    bound = min(schedule.lower_bound, time) if searched else 0.0
    if processes == 1 and schedule.verdict == "optimal":
        bound = time  # one candidate, in the shape of least price
    optimal = bound >= time * (1 - 1e-12)
    return {
        "makespan": time,
        "predicted": time,
        "bound": bound,
        "lower_bound": bound,
        "verdict": "optimal" if optimal else "gap",
        "gap": 0.0 if optimal else (time / bound - 1 if bound > 0 else None),
        "loads": [line.busy(p) for p in range(processes)],
    }
