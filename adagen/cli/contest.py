"""Benchmarks of several robots: all solvers of each are built, timed by turns, and checked."""

from __future__ import annotations

import argparse
import dataclasses
import shlex
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from adagen.cli import pipeline
from adagen.cli.console import note, say, speaking, warn
from adagen.cli.options import AUTO, add_emission, add_model, add_schedule, check_emission
from adagen.cli.parser import make_parser, parse
from adagen.errors import AdagenError, UsageError
from adagen.library.robot import robot_of
from adagen.studies.bench.contest import Rules
from adagen.studies.bench.machine import machine
from adagen.studies.bench.peers import PEERS
from adagen.studies.bench.record import ModelRecord, Record
from adagen.studies.bench.robots import measured
from adagen.studies.bench.variants import VARIANTS, Variant


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
    options = _options(entry, "--procs 1")
    robot = robot_of(pipeline.origin_of(options, options.gravity))
    for warning in robot.warnings:
        warn(warning)
    absent = {name: why for name, why in entry.without.items() if name in peers}
    asked = []
    for words in entry.variants or variants:
        try:
            asked.append(Variant(words, pipeline.request_of(_options(entry, words))))
        except AdagenError as error:
            absent[f"adagen {words}"] = error.reason
    others = [name for name in peers if name not in absent]
    with speaking(entry.name) as on_progress:
        found = measured(robot, asked, others, rules, absent, on_progress)
    return dataclasses.replace(found, name=entry.name)


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
    if options.tune:
        raise UsageError("a variant is one solver: leave out --tune")
    return options
