"""Costs of messages, from messages of several sizes sent there and back.

The program uses the same channel as emitted code, window or MPI messages.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from statistics import median

import numpy as np

from adagen.build import Toolchain, build_executable
from adagen.calibrate.measure import TIMEOUT
from adagen.calibrate.nnls import nnls
from adagen.emit.templates import render
from adagen.errors import EnvironmentFault
from adagen.run import launch
from adagen.schedule.costs import CHANNELS, ChannelCosts

SIZES = (1, 6, 12, 27, 42, 78, 120, 240, 480)
"""Numbers of the messages: of a bias, of a handle's block and bias, of several handles'."""

FAR_SIZES = (1, 12, 42, 120, 480, 1920, 4096)
"""Those of messages between hosts, up to half a piece of a batch."""

_NAME = "channel_times"
_FAR_ROUNDS = 5
_FAR_RUNS = 3


@dataclass(frozen=True)
class MessageTime:
    """The measured time of one message size; microseconds.

    Attributes:
        numbers: that it holds.
        way: from when its numbers are about to be put in until they have been read.
        send: until the sender can go on.
    """

    numbers: int
    way: float
    send: float


Channels = dict[str, tuple[MessageTime, ...]]
"""By channel, a time for each of ``SIZES``."""


def channel_program(toolchain: Toolchain, sizes: Sequence[int] = SIZES) -> Path:
    """Return the program that measures messages.

    Args:
        toolchain: what to build it with.
        sizes: numbers of the messages.

    Raises:
        EnvironmentFault: the compiler failed.
    """
    messages = [
        {"source": source, "target": 1 - source, "size": size, "comment": comment}
        for size in sizes
        for source, comment in ((0, "there"), (1, "and back"))
    ]
    text = render(
        "channel_times.cpp.j2",
        mpi=True,
        threads=False,
        channel_messages=messages,
    )
    return build_executable(text, _NAME, toolchain)


def message_times(program: Path, toolchain: Toolchain, rounds: int = 100) -> Channels:
    """Return the medians over some rounds for each channel and each of ``SIZES``.

    Args:
        program: of ``channel_program``.
        toolchain: what to run it with.
        rounds: how often each size is measured.

    Raises:
        EnvironmentFault: a channel cannot be opened here, or the time is up.
    """
    done = launch(program, 2, [str(rounds)], toolchain, TIMEOUT)
    if done.status != 0:
        raise EnvironmentFault(f"messages cannot be timed: {done.stderr}")
    lines = done.stdout.splitlines()
    return {channel: _times(line) for channel, line in zip(CHANNELS, lines, strict=True)}


def _times(line: str) -> tuple[MessageTime, ...]:
    return tuple(
        MessageTime(int(row["numbers"]), row["way_ns"] / 1e3, max(0.0, row["send_ns"]) / 1e3)
        for row in json.loads(line)
    )


def times_between_hosts(toolchain: Toolchain, hosts: tuple[str, str]) -> tuple[MessageTime, ...]:
    """Return the times of messages between two hosts: the least of some runs.

    Args:
        toolchain: what to build and run with.
        hosts: their names, by which mpiexec reaches them.

    Raises:
        EnvironmentFault: the hosts cannot be reached, share memory, or the time is up.
    """
    program = channel_program(toolchain, FAR_SIZES)
    one_each = ",".join(f"{name}:1" for name in hosts)
    far = replace(toolchain, mpiexec=(*toolchain.mpiexec, "--host", one_each))
    runs = []
    for _ in range(_FAR_RUNS):
        done = launch(program, 2, [str(_FAR_ROUNDS), "far"], far, TIMEOUT)
        if done.status != 0 or not done.stdout:
            reason = done.stderr or "mpiexec ended without an answer"
            raise EnvironmentFault(f"messages between hosts cannot be timed: {reason}")
        runs.append(_times(done.stdout))
    return _least(runs)


def least_times(runs: Sequence[Channels]) -> Channels:
    """Return the least times of several runs: other work on the machine only ever adds to one.

    So does a hypervisor that moves virtual cores apart for a while.
    """
    return {channel: _least([run[channel] for run in runs]) for channel in CHANNELS}


def _least(runs: Sequence[tuple[MessageTime, ...]]) -> tuple[MessageTime, ...]:
    return tuple(
        MessageTime(same[0].numbers, min(m.way for m in same), min(m.send for m in same))
        for same in zip(*runs, strict=True)
    )


def fit_channel(times: Sequence[MessageTime]) -> ChannelCosts:
    """Return what messages over a channel cost.

    The way is the sender's time, the latency, and half of the time for its numbers at either end:
    its slope is the time for a number, and what the sender does not take of the rest is latency.
    """
    ways = np.array([m.way for m in times])
    rows = np.array([[1.0, m.numbers] for m in times])
    whole, number = (float(x) for x in nnls(rows / ways[:, None], np.ones(len(times))))
    send = median(max(0.0, m.send - m.numbers * number / 2) for m in times)
    send = min(send, whole)
    return ChannelCosts(send, whole - send, number)


def channel_errors(times: Sequence[MessageTime], costs: ChannelCosts) -> list[float]:
    """Return (predicted - measured) / measured of the way of each message."""
    return [(costs.send + costs.latency + m.numbers * costs.number) / m.way - 1 for m in times]
