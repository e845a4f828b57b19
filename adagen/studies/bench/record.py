"""What was measured, as plain data: kept in one JSON file, from which tables and pictures come."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from adagen.studies.bench.contest import Rules, from_stretches
from adagen.studies.records import record_in

Numbers = tuple[float, ...]


@dataclass(frozen=True)
class Row:
    """One thing that was timed; nanoseconds of an evaluation.

    Attributes:
        name: the contestant.
        team: whose it is.
        build: compiler and options, code shape.
        processes: how many it ran on.
        scalar: number type.
        what: a key of ``WORDS`` (contest.py): where states and results are, and whether
            the time is the clock's or from stretches.
        median: median of the turns' medians.
        least: the fastest evaluation.
        turns: each turn's median, in the order of the rounds.
        forward_error: the largest over the judged states, in the energy norm.
        residual: likewise, of inverse dynamics.
        predicted: what the cost profile says of the schedule; None for others' solvers.
    """

    name: str
    team: str
    build: str
    processes: int
    scalar: str
    what: str
    median: float
    least: float
    turns: Numbers
    forward_error: float
    residual: float
    predicted: float | None = None

    @property
    def played(self) -> bool:
        """Whether the time is from stretches, not the clock's."""
        return self.what.startswith(from_stretches("in_place"))


@dataclass(frozen=True)
class ModelRecord:
    """All rows of one robot, measured in one run.

    Attributes:
        name: the robot.
        joints: how many there are.
        dofs: degrees of freedom.
        rows: what was timed.
        absent: contestants that are missing, and why.
        seconds: what building and measuring took.
    """

    name: str
    joints: int
    dofs: int
    rows: tuple[Row, ...]
    absent: Mapping[str, str]
    seconds: float

    def best(self, team: str, what: str = "in_place", **wanted: Any) -> Row | None:
        """Return a team's fastest row by median, among those with the wanted attributes."""
        rows = [
            row
            for row in self.rows
            if row.team == team
            and row.what == what
            and all(getattr(row, key) == value for key, value in wanted.items())
        ]
        return min(rows, key=lambda row: row.median, default=None)

    def timed(self, team: str, what: str = "in_place", **wanted: Any) -> Row | None:
        """Return the same by the clock, or else, with more processes than cores, from stretches."""
        return self.best(team, what, **wanted) or self.best(team, from_stretches(what), **wanted)


@dataclass(frozen=True)
class Record:
    """A whole run.

    Attributes:
        machine: processor, cores, compilers, versions.
        rules: how it was measured.
        models: robot by robot.
    """

    machine: Mapping[str, Any]
    rules: Rules
    models: tuple[ModelRecord, ...]


def read_record(path: Path) -> Record:
    """Return the record in a file.

    Raises:
        InputError: it cannot be read, or is not one of ours.
    """
    return record_in(path, "a record of measurements", _record)


def _record(data: dict[str, Any]) -> Record:
    models = tuple(map(_model, data["models"]))
    return Record(data["machine"], Rules(**data["rules"]), models)


def _model(data: dict[str, Any]) -> ModelRecord:
    rows = data.pop("rows")
    made = tuple(Row(**{**row, "turns": tuple(row["turns"])}) for row in rows)
    return ModelRecord(rows=made, **data)
