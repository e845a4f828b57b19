"""A record as tables: for people at a terminal and as Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from adagen.studies.bench.contest import WORDS
from adagen.studies.bench.record import ModelRecord, Record, Row

SUMMARY = (
    "robot",
    "DOF",
    "pinocchio",
    "casadi",
    "MuJoCo",
    "P=1",
    "× pinocchio",
    "× casadi",
    "float",
    "P=2",
    "saved",
    "through 0",
    "saved",
    "P=2 played",
    "P=4",
    "saved",
    "batch, a state",
    "× pinocchio",
    "float batch",
)
PLAYED = (
    "≈: not the clock's, but played through from measured stretches of computing, as with more "
    'processes than cores; "P=2 played" is the check of that against the clock\'s P=2.'
)
DETAILS = (
    "solver",
    "median ns",
    "least ns",
    "× pinocchio",
    "predicted ns",
    "forward error",
    "residual",
)


def summary(model: ModelRecord) -> list[str]:
    """Return a robot's row of the summary, a cell for each of SUMMARY: the best of each team."""
    pinocchio, casadi, mujoco = map(model.best, ("pinocchio", "casadi", "mujoco"))
    one, single, batch, single_batch = (
        model.best("adagen", processes=1, scalar=scalar)
        for scalar in ("double", "float", "double lanes", "float lanes")
    )
    two, four = (model.timed("adagen", processes=p, scalar="double") for p in (2, 4))
    through_root = model.timed("adagen", "through_root", processes=2, scalar="double")
    return [
        model.name,
        str(model.dofs),
        *map(_time, (pinocchio, casadi, mujoco, one)),
        _ratio(pinocchio, one),
        _ratio(casadi, one),
        _time(single),
        _time(two),
        _saved(one, two),
        _time(through_root),
        _saved(one, through_root),
        _time(model.best("adagen", "stretches", processes=2, scalar="double")),
        _time(four),
        _saved(one, four),
        _time(batch),
        _ratio(pinocchio, batch),
        _time(single_batch),
    ]


def details(model: ModelRecord) -> list[list[str]]:
    """Return a row for everything that was timed, a cell for each of DETAILS, the fastest first."""
    best = model.best("pinocchio")
    return [
        [
            row.name + WORDS[row.what],
            f"{row.median:.0f}",
            f"{row.least:.0f}",
            _ratio(best, row),
            "" if row.predicted is None else f"{row.predicted:.0f}",
            f"{row.forward_error:.0e}",
            f"{row.residual:.0e}",
        ]
        for row in sorted(model.rows, key=lambda row: row.median)
    ]


def markdown(record: Record) -> str:
    """Return the tables as Markdown, the summary first."""
    return "\n".join([*_head(record), *_summary(record), *_details(record), ""])


def _head(record: Record) -> Iterator[str]:
    machine, rules = record.machine, record.rules
    compilers = "; ".join(machine["compilers"].values())
    packages = ", ".join(f"{name} {version}" for name, version in machine["packages"].items())
    yield f"{machine['processor']}, {machine['cores']} cores, {machine['system']}; {compilers}."
    yield f"{packages}. Load before: {machine['load_before']}."
    yield (
        f"{rules.rounds} rounds by turns, {rules.repeat} evaluations of each of {rules.states} "
        f"random states in a turn; medians of the rounds' medians, ns an evaluation; errors over "
        f"{rules.judged} states. Measuring took {sum(m.seconds for m in record.models):.0f} s, "
        "compiling included where it was not cached."
    )
    if any(row.played for model in record.models for row in model.rows):
        yield PLAYED
    yield ""


def _summary(record: Record) -> Iterator[str]:
    yield from table(SUMMARY, [summary(model) for model in record.models])
    yield ""
    builds = {row.name: row.build for model in record.models for row in model.rows}
    yield "Built with:"
    yield ""
    by_build: dict[str, list[str]] = {}
    for name, build in builds.items():
        by_build.setdefault(build, []).append(name)
    yield from (f"- {'; '.join(sorted(names))}: `{build}`" for build, names in by_build.items())
    yield ""


def _details(record: Record) -> Iterator[str]:
    for model in record.models:
        yield f"### {model.name}: {model.dofs} degrees of freedom, {model.joints} joints"
        yield ""
        yield from table(DETAILS, details(model))
        yield ""
        if model.absent:
            yield from (f"- {name}: {reason}" for name, reason in model.absent.items())
            yield ""


def table(head: Sequence[str], rows: Iterable[Sequence[object]]) -> Iterator[str]:
    """Yield the lines of a Markdown table, all but the first column to the right."""
    yield f"| {' | '.join(head)} |"
    yield "|---" + "|--:" * (len(head) - 1) + "|"
    for row in rows:
        yield f"| {' | '.join(map(str, row))} |"


def _time(row: Row | None) -> str:
    if row is None:
        return "–"
    return f"{'≈' if row.played else ''}{row.median:.0f}"


def _ratio(slow: Row | None, fast: Row | None) -> str:
    return "–" if slow is None or fast is None else f"{slow.median / fast.median:.2f}"


def _saved(one: Row | None, two: Row | None) -> str:
    return "–" if one is None or two is None else f"{1 - two.median / one.median:.0%}"
