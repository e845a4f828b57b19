"""One robot after another: everybody's solvers built, timed by turns, and judged."""

from __future__ import annotations

import argparse
import dataclasses
import shlex
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from adagen.build import find_toolchain
from adagen.cli import pipeline
from adagen.cli.console import Stages, note, progress, say, speaking
from adagen.cli.options import AUTO, add_emission, add_model, add_schedule, check_emission
from adagen.cli.parser import make_parser, parse
from adagen.emit.predicted import is_priced, predict
from adagen.emit.shapes import chosen_shape
from adagen.errors import AdagenError, UsageError
from adagen.model import Model
from adagen.schedule import load_profile
from adagen.states import States
from adagen.studies.bench.answers import DIRECT, Errors, Judge
from adagen.studies.bench.contest import Contestant, Rules, Times, cores, hold
from adagen.studies.bench.emitted import Emitted
from adagen.studies.bench.machine import machine
from adagen.studies.bench.peers import PEERS, contestants, missing
from adagen.studies.bench.record import ModelRecord, Record, Row
from adagen.studies.drawn import drawn_states

VARIANTS = (
    "--procs 1",
    "--procs 2",
    "--procs 4",
    "--procs 1 --scalar float",
    "--procs 1 --shape unrolled",
    "--procs 1 --shape kernels",
    "--procs 1 --batch",
    "--procs 2 --batch",
    "--procs 1 --batch --scalar float",
)
"""What adagen is asked for, in its own command line's words; what it cannot do is skipped."""
MOST_TURNS = 16
"""Processes that are timed in turns, by their stretches, where there are fewer cores."""
MOST_TEXT = 4_000_000
"""Characters of a source that is still built: with more, a contest would be one of compilers."""


@dataclasses.dataclass(frozen=True)
class Entry:
    """A robot to be measured.

    Attributes:
        name: what tables call it.
        file: its description.
        words: options that go with it.
        without: peers that are left out, and why.
        variants: of adagen, instead of what is asked for of all robots; none for those.
    """

    name: str
    file: Path
    words: tuple[str, ...] = ()
    without: Mapping[str, str] = dataclasses.field(default_factory=dict)
    variants: tuple[str, ...] = ()


def contest(
    entries: Sequence[Entry],
    rules: Rules,
    variants: Sequence[str] = VARIANTS,
    peers: Sequence[str] = tuple(PEERS),
    done: Callable[[Record], None] = lambda _: None,
    before: Sequence[ModelRecord] = (),
    *,
    keep_going: bool = False,
) -> Record:
    """Measure robot by robot.

    Args:
        entries: the robots.
        rules: how it is done.
        variants: of adagen, as words of its command line.
        peers: who else takes part, if installed.
        done: called with the record so far after each robot.
        before: robots that have been measured already; those of an entry's name are kept.
        keep_going: whether a robot that cannot be measured is left out with a note.

    Raises:
        AdagenError: a robot is refused, or nothing of it could be timed.
    """
    known = {model.name: model for model in before}
    record = Record(machine(), rules, ())
    for k, entry in enumerate(entries, start=1):
        found = known.get(entry.name)
        if found is None:
            note(f"{entry.name}, robot {k} of {len(entries)}")
            try:
                found = measure(entry, rules, variants, peers)
            except AdagenError as error:
                if not keep_going:
                    raise
                say(f"{entry.name} is left out: {error}")
                continue
            note(f"{entry.name}: {len(found.rows)} times in {found.seconds:.0f} s")
        record = dataclasses.replace(record, models=(*record.models, found))
        done(record)
    return record


def measure(
    entry: Entry, rules: Rules, variants: Sequence[str], peers: Sequence[str]
) -> ModelRecord:
    """Return everything about one robot.

    Raises:
        AdagenError: the robot is refused, or nothing of it could be timed.
    """
    start = time.perf_counter()
    options = _options(entry, "--procs 1")
    load_profile(options.profile)  # refused before anything is built
    model = pipeline.read_model(options, Stages(), options.gravity)
    states = drawn_states(model, rules.states, rules.seed)
    judged = rules.judged if model.nv <= DIRECT else 1
    few = States(*(x[:judged] for x in (states.q, states.v, states.tau)))
    absent = {name: why for name, why in entry.without.items() if name in peers}
    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        taking_part = _emitted(entry, model, entry.variants or variants, absent)
        taking_part += _others(
            model, states, [name for name in peers if name not in absent], Path(folder), absent
        )
        if not taking_part:
            raise UsageError(f"nothing to time: {next(iter(absent.values()), 'no variant')}")
        times, gone = _timed(entry, taking_part, rules)
        absent |= gone
        rows = _judged(taking_part, times, Judge(model, few), absent)
    seconds = time.perf_counter() - start
    return ModelRecord(entry.name, len(model.joints), model.nv, rows, absent, round(seconds, 1))


def _timed(
    entry: Entry, contestants: Sequence[Contestant], rules: Rules
) -> tuple[dict[str, dict[str, Times]], dict[str, str]]:
    """Hold the contest, and show each round."""
    with speaking(f"{entry.name}: timing {len(contestants)} solvers") as on_progress:
        return hold(contestants, rules, on_progress)


def _options(entry: Entry, variant: str) -> argparse.Namespace:
    """Return a variant's options, as ``adagen MODEL`` reads them.

    Raises:
        UsageError: this adagen does not know them.
    """
    parser = make_parser("adagen", "", "")
    add_model(parser)
    add_schedule(parser)
    add_emission(parser)
    options = parse(parser, [str(entry.file), *entry.words, *shlex.split(variant)])
    check_emission(parser, options)
    options.name = None
    if options.procs == AUTO:
        raise UsageError("a variant needs a number of processes")
    return options


def _emitted(
    entry: Entry, model: Model, variants: Sequence[str], absent: dict[str, str]
) -> list[Contestant]:
    """Return adagen's contestants, built; why others are missing goes into ``absent``."""
    sources: dict[str, Emitted] = {}
    for variant in variants:
        try:
            emitted = _emit(entry, model, variant)
        except AdagenError as error:
            absent[f"adagen {variant}"] = str(error).removeprefix("error: ")
            continue
        sources.setdefault(emitted.name, emitted)  # `auto` has often chosen one of the others
    toolchain = find_toolchain()

    done = 0

    def build(emitted: Emitted) -> Contestant | str:
        nonlocal done
        try:
            return emitted.contestant(toolchain, stretches=True)
        except AdagenError as error:
            return str(error).removeprefix("error: ")
        finally:
            done += 1
            on_progress(f"compiling {done} of {len(sources)}")

    with speaking(entry.name) as on_progress, ThreadPoolExecutor(cores()) as pool:
        built = list(pool.map(build, sources.values()))
    absent |= {
        e.name: why for e, why in zip(sources.values(), built, strict=True) if isinstance(why, str)
    }
    return [contestant for contestant in built if isinstance(contestant, Contestant)]


def _emit(entry: Entry, model: Model, variant: str) -> Emitted:
    """Return a variant's source and what is predicted of it.

    Raises:
        AdagenError: this adagen cannot do it, or not for this robot.
    """
    options = _options(entry, variant)
    most = cores() if options.batch else max(cores(), MOST_TURNS)
    if options.procs > most:
        raise UsageError(f"{options.procs} processes: at most {most} are timed on {cores()} cores")
    made = pipeline.generate(model, options, Stages())
    shape = chosen_shape(made.plan, options.shape, batch=options.batch)
    profile = load_profile(options.profile)
    predicted = None
    if profile.steps is not None and not options.batch and is_priced(made.plan, shape):
        predicted = 1e3 * predict(made.plan, profile, shape).makespan
    words = shlex.split(variant)
    more = [w for k, w in enumerate(words) if not {w, *words[k - 1 : k]} & _NAMED]
    names = [shape, *([options.scalar] if options.scalar != "double" else []), *more]
    file, text = f"{made.stem}.cpp", made.source
    if len(text) > MOST_TEXT:
        raise UsageError(
            f"shape {shape}: {len(text) / 1e6:.1f} million characters of source take minutes to "
            "compile"
        )
    return Emitted(
        name=f"adagen P={options.procs}, {', '.join(names)}",
        model=model,
        file=file,
        text=text,
        build=f"form {options.form}, shape {shape}",
        processes=options.procs,
        scalar=f"{options.scalar} lanes" if options.batch else options.scalar,
        predicted=predicted,
    )


_NAMED = {"--procs", "--shape", "--scalar"}
"""Options that a contestant's name tells in its own way."""


def _others(
    model: Model, states: States, names: Sequence[str], folder: Path, absent: dict[str, str]
) -> list[Contestant]:
    """Return the peers' contestants, built; why others are missing goes into ``absent``."""
    found: list[Contestant] = []
    for name in names:
        reason = missing(name)
        if reason is None:
            try:
                with progress(f"{model.name}: compiling {name}"):
                    found += contestants(name, model, states, folder)
                continue
            except AdagenError as error:
                reason = str(error).removeprefix("error: ")
        absent[name] = reason
    return found


def _judged(
    contestants: Sequence[Contestant],
    times: Mapping[str, Mapping[str, Times]],
    judge: Judge,
    absent: dict[str, str],
) -> tuple[Row, ...]:
    """Return a row for everything that was timed, with its errors."""
    rows = []
    for one in contestants:
        if one.name not in times:
            continue
        try:
            errors = judge.errors(one.solve(judge.states))
        except AdagenError as error:
            absent[one.name] = str(error).removeprefix("error: ")
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
