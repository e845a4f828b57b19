"""One robot: everybody's solvers of it built, timed by turns, and judged."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path

from adagen.errors import AdagenError, UsageError
from adagen.library import Robot
from adagen.schedule import load_profile
from adagen.studies.bench.contest import Contestant, Progress, Rules, Times, hold
from adagen.studies.bench.peers import entered
from adagen.studies.bench.record import ModelRecord, Row
from adagen.studies.bench.variants import Variant, built
from adagen.studies.random_states import drawn_states
from adagen.studies.truth import DIRECT, DOUBLE, Errors, Truth, truth_of


def measured(
    robot: Robot,
    variants: Sequence[Variant],
    peers: Sequence[str],
    rules: Rules,
    absent: Mapping[str, str],
    on_progress: Progress,
) -> ModelRecord:
    """Return everything about one robot.

    Args:
        robot: the robot.
        variants: of adagen; what it cannot do is left out, and named.
        peers: who else takes part, if installed.
        rules: how it is done.
        absent: who has been left out already, and why.
        on_progress: told what is being done.

    Raises:
        AdagenError: nothing of it could be timed, or a profile is unknown.
    """
    start = time.perf_counter()
    for variant in variants:
        load_profile(variant.request.profile)  # refused before anything is built
    model, gone = robot.model, dict(absent)
    states = drawn_states(model, rules.states, rules.seed)
    judged = rules.judged if model.nv <= DIRECT else 1
    few = states.some(slice(judged))
    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        taking_part = built(robot, variants, gone, on_progress)
        taking_part += entered(peers, model, states, Path(folder), gone, on_progress)
        if not taking_part:
            raise UsageError(f"nothing to time: {next(iter(gone.values()), 'no variant')}")
        times, given_up = hold(
            taking_part,
            rules,
            lambda text: on_progress(f"timing {len(taking_part)} solvers: {text}"),
        )
        gone |= given_up
        truth = cache(lambda: truth_of(model, few, digits=DOUBLE))
        rows = _judged(taking_part, times, truth, gone)
    seconds = time.perf_counter() - start
    return ModelRecord(robot.name, len(model.joints), model.nv, rows, gone, round(seconds, 1))


def _judged(
    taking_part: Sequence[Contestant],
    times: Mapping[str, Mapping[str, Times]],
    truth: Callable[[], Truth],
    absent: dict[str, str],
) -> tuple[Row, ...]:
    """Return a row for everything that was timed, with its errors."""
    rows = []
    for one in taking_part:
        if one.name not in times:
            continue
        try:
            errors = truth().errors(one.solve(truth().states))
        except AdagenError as error:
            absent[one.name] = error.reason
            continue
        rows += [_row(one, what, kept, errors) for what, kept in times[one.name].items()]
    return tuple(rows)


def _row(one: Contestant, what: str, times: Times, errors: Errors) -> Row:
    return Row(
        name=one.name,
        team=one.team,
        build=one.build,
        processes=one.processes,
        scalar=one.scalar,
        what=what,
        median=times.median,
        least=times.least,
        turns=times.turns,
        forward_error=errors.forward,
        residual=errors.residual,
        predicted=one.predicted,
    )
