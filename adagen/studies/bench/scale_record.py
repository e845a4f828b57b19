"""How far solvers scale, as plain data: kept in one JSON file, from which pictures come."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from adagen.studies.bench.contest import Rules
from adagen.studies.records import record_in

CLOCK, STRETCHES = "clock", "stretches"
PREDICTED = "predicted"


CACHED = 0.2
"""Seconds of the processor: more than it takes to find a program in the cache."""


@dataclass(frozen=True)
class ScaleRow:
    """One time of a chain's solver.

    Attributes:
        team: adagen or pinocchio.
        name: the contestant.
        joints: of the chain.
        processes: P.
        source: ``clock`` or ``stretches``.
        median: nanoseconds of an evaluation, median of the turns' medians.
        least: the fastest evaluation.
        residual: largest, of inverse dynamics, relative to the torques at work.
        predicted: nanoseconds by the cost profile; None of others' solvers.
        scaled: the same with cores that are as fast as the one on which the chain was timed on one
            process: what is left of its error does not come from the machine's speed.
        meeting: how processes meet; "alone" on one.
        generated: seconds of the processor to read, search and emit.
        compiled: seconds of the processor to compile; 0 where the program was in the cache.
        size: of the source, kB.
    """

    team: str
    name: str
    joints: int
    processes: int
    source: str
    median: float
    least: float
    residual: float
    predicted: float | None = None
    scaled: float | None = None
    meeting: str = "alone"
    generated: float = 0.0
    compiled: float = 0.0
    size: float = 0.0

    def made_as(self, earlier: Scale | None) -> ScaleRow:
        """Return the row of a program that was in the cache with what it took an earlier record."""
        same = None if earlier is None else earlier.row(self.joints, self.processes)
        if same is None or self.compiled > CACHED or self.team != "adagen":
            return self
        return dataclasses.replace(self, compiled=same.compiled)


@dataclass(frozen=True)
class BatchRow:
    """States per second of batches.

    Attributes:
        hosts: how many.
        processes: how many in all.
        source: ``clock`` or ``predicted``.
        in_place: where each process has its own states.
        distributed: where process 0 hands them out.
        limit: what limits handing out, where that is predicted.
    """

    hosts: int
    processes: int
    source: str
    in_place: float
    distributed: float
    limit: str = ""


@dataclass(frozen=True)
class Scale:
    """A whole run.

    Attributes:
        machine: processor, cores, compilers, versions.
        rules: how it was measured.
        profile: name of the cost profile that predicted.
        rows: chains, from the shortest; of each its solvers.
        robot: whose batches they are; "" where there are none.
        batches: on processes of this machine, and on hosts.
        absent: contestants that are missing, by chain and name, and why.
    """

    machine: Mapping[str, Any]
    rules: Rules
    profile: str
    rows: tuple[ScaleRow, ...] = ()
    robot: str = ""
    batches: tuple[BatchRow, ...] = ()
    absent: Mapping[str, str] = dataclasses.field(default_factory=dict)

    def row(self, joints: int, processes: int, *sources: str) -> ScaleRow | None:
        """Return adagen's row of a chain, by the first of the sources that it has a time of."""
        for source in sources or (CLOCK, STRETCHES):
            for row in self.rows:
                if (row.team, row.joints) == ("adagen", joints) and (
                    (row.processes, row.source) == (processes, source)
                ):
                    return row
        return None

    def peer(self, joints: int) -> ScaleRow | None:
        """Return the fastest of the others' rows of a chain."""
        rows = (row for row in self.rows if row.team != "adagen" and row.joints == joints)
        return min(rows, key=lambda row: row.least, default=None)

    @property
    def joints(self) -> tuple[int, ...]:
        """The chains, ascending."""
        return tuple(sorted({row.joints for row in self.rows}))

    @property
    def processes(self) -> tuple[int, ...]:
        """The numbers of processes, ascending."""
        return tuple(sorted({row.processes for row in self.rows if row.team == "adagen"}))


def read_scale(path: Path) -> Scale:
    """Return the record in a file.

    Raises:
        InputError: it cannot be read, or is not one of ours.
    """
    return record_in(path, "a record of scaling", _scale)


def _scale(data: dict[str, Any]) -> Scale:
    rows = tuple(ScaleRow(**row) for row in data.pop("rows"))
    batches = tuple(BatchRow(**row) for row in data.pop("batches"))
    return Scale(rules=Rules(**data.pop("rules")), rows=rows, batches=batches, **data)
