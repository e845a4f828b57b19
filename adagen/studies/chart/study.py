"""Building, solving and timing every variant of a robot, by turns."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from statistics import median

from adagen.build import Toolchain
from adagen.build.processor import processor_name
from adagen.emit import stem_of
from adagen.errors import AdagenError
from adagen.executor.join_digits import predicted_growth
from adagen.model import Model
from adagen.studies.bench.contest import Contestant, Rules, Times, from_stretches, hold
from adagen.studies.bench.emitted import Emitted, all_built
from adagen.studies.chart.record import Chart, Point, marked, mechanism_of
from adagen.studies.chart.variants import REFERENCE, Variant
from adagen.studies.truth import Truth

Progress = Callable[[str], None]


@dataclass(frozen=True)
class Study:
    """How a chart is measured.

    Attributes:
        variants: what is built; the reference is always among it.
        rounds: in which everything is timed by turns.
        repeat: evaluations of each of 64 states in a turn.
    """

    variants: Sequence[Variant]
    rounds: int = 5
    repeat: int = 20


def chart_of(
    model: Model,
    truth: Truth,
    study: Study,
    toolchain: Toolchain,
    others: Sequence[Contestant] = (),
    on_progress: Progress = lambda _: None,
) -> Chart:
    """Return a robot's chart.

    Args:
        model: the robot.
        truth: of the states that errors are computed in.
        study: what is measured and how.
        toolchain: what to build and run with.
        others: peers, built, whose points go beside.
        on_progress: called with messages about progress.

    Raises:
        EnvironmentFault: not even the reference could be timed.
    """
    variants = list(dict.fromkeys([REFERENCE, *study.variants]))
    points, contestants = _built(model, variants, toolchain, on_progress)
    for contestant in others:
        points[contestant.name] = _peer(contestant)
        contestants[contestant.name] = contestant
    for k, (name, contestant) in enumerate(contestants.items(), start=1):
        on_progress(f"solving {truth.states.count} states: {k} of {len(contestants)}")
        points[name] = _judged(points[name], contestant, truth)
    solved = [c for name, c in contestants.items() if not points[name].failed]
    times, gone = hold(solved, Rules(study.rounds, study.repeat), on_progress)
    for name, reason in gone.items():
        points[name] = replace(points[name], why=reason)
    with_times = [_timed(point, times) for point in points.values()]
    count, digits = truth.states.count, truth.digits
    return Chart(
        model.name,
        model.nv,
        count,
        digits,
        study.rounds,
        processor_name(),
        marked(with_times),
        mechanism_of(model),
    )


def _built(
    model: Model, variants: Sequence[Variant], toolchain: Toolchain, on_progress: Progress
) -> tuple[dict[str, Point], dict[str, Contestant]]:
    """Return a point for each variant, and contestants of those that could be built."""
    points: dict[str, Point] = {}
    sources: dict[str, Emitted] = {}
    texts: set[str] = set()
    for k, variant in enumerate(variants, start=1):
        on_progress(f"planning {k} of {len(variants)}")
        point = _point(variant)
        try:
            _, plan = variant.plan(model)
            if any(not process.owns for process in plan.processes):
                continue  # on so many processes it is what it is on fewer
            stem = stem_of(plan)
            text = variant.files(plan)[f"{stem}.cpp"]
            if text in texts:
                continue  # another variant's program
            texts.add(text)
            point = replace(point, method=variant.method(plan))
            if not variant.baseline and not model.closed:  # what is predicted is of joins
                growth = predicted_growth(plan).error
                point = replace(point, predicted=growth if math.isfinite(growth) else None)
            sources[point.label] = Emitted(
                point.label, model, f"{stem}.cpp", text, "", variant.processes, variant.scalar, None
            )
        except (AdagenError, FloatingPointError) as error:
            point = replace(point, why=_reason(error))
        points[point.label] = point
    built, gone = all_built(sources, toolchain, on_progress)
    for name, why in gone.items():
        points[name] = replace(points[name], why=_line(why))
    return points, built


def _point(variant: Variant) -> Point:
    team = "baseline" if variant.baseline else "adagen"
    return Point(label=variant.label, team=team, **vars(variant))


def _peer(contestant: Contestant) -> Point:
    return Point(
        label=contestant.name,
        team=contestant.team,
        algorithm=contestant.team,
        schedule="auto",
        scalar=contestant.scalar,
        processes=contestant.processes,
        refine=0,
        shape="auto",
        method=contestant.team,
    )


NO_DIGIT = 0.1
"""Forward errors above this are no answers."""


def _judged(point: Point, contestant: Contestant, truth: Truth) -> Point:
    """Return the point with its errors, or with the reason why it gives no answer."""
    try:
        error, residual = truth.errors(contestant.solve(truth.states))
    except AdagenError as failure:
        return replace(point, why=_reason(failure))
    if not math.isfinite(error):
        return replace(point, why="its answer is not finite")
    if error > NO_DIGIT:
        return replace(point, why=f"not one digit of its answer is right: its error is {error:.2g}")
    return replace(point, error=error, residual=residual)


def _timed(point: Point, times: dict[str, dict[str, Times]]) -> Point:
    """Return the point with its time, and its ratio to the reference round by round."""
    kinds = times.get(point.label, {})
    source = "clock" if "in_place" in kinds else "stretches"
    mine = kinds.get("in_place", kinds.get(from_stretches("in_place")))
    if mine is None:
        return point
    base = times.get(REFERENCE.label, {}).get("in_place")
    ratio = None
    if base is not None and len(base.turns) == len(mine.turns):
        ratio = median(a / b for a, b in zip(mine.turns, base.turns, strict=True))
    return replace(point, time_ns=mine.median, source=source, ratio=ratio)


def _reason(error: Exception) -> str:
    """Return in a line why something failed, without its place in a temporary file."""
    return _line(str(error)) or type(error).__name__


def _line(text: str) -> str:
    return next(iter(text.strip().splitlines()), "").rpartition("error: ")[2]
