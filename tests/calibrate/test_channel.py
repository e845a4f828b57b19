"""The program that times messages: it goes through both channels, and is clean C++."""

from __future__ import annotations

from dataclasses import replace

from adagen.build import find_toolchain
from adagen.calibrate.channel import SIZES, channel_errors, channel_program, fit_channel
from adagen.calibrate.channel import message_times as timed
from adagen.run import launch
from adagen.schedule.costs import CHANNELS


def test_messages_of_all_sizes_are_timed_over_both_channels() -> None:
    found = find_toolchain()
    toolchain = replace(found, flags=(*found.flags, "-Werror"))
    times = timed(channel_program(toolchain), toolchain, rounds=5)
    assert tuple(times) == CHANNELS
    for rows in times.values():
        assert tuple(m.numbers for m in rows) == SIZES
        assert all(m.way > 0 and m.send >= 0 for m in rows)
        costs = fit_channel(rows)
        assert len(channel_errors(rows, costs)) == len(SIZES)


def test_a_wrong_use_is_an_error() -> None:
    toolchain = replace(find_toolchain(), flags=(*find_toolchain().flags, "-Werror"))
    done = launch(channel_program(toolchain), 2, [], toolchain, 60)
    assert done.status == 3 and "error: say how many rounds" in done.stderr
