"""--stretches of an emitted program: each process's computing by itself, played through."""

from __future__ import annotations

import json
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from adagen.plan import Plan
from adagen.schedule import load_profile
from tests.emitted import Builder, Solver, cores, plan_of, text_of
from tests.models import serial_chain
from tests.slow import slow

HOP = (3.0, 50.0, 2.0)  # send, latency, a number
HARNESS = """
#include <algorithm>
#include <cstdio>
#include <vector>
#include "adagen/makespan.hpp"
using namespace adagen;
// Cases from standard input: processes, messages (source, target, size), then for each process its
// messages and stretches; a makespan each.
int main() {{
  int processes, count, k;
  while (std::scanf("%d %d", &processes, &count) == 2) {{
    std::vector<Message> messages(static_cast<std::size_t>(count));
    for (Message& m : messages)
      if (std::scanf("%d %d %d", &m.source, &m.target, &m.size) != 3) return 1;
    std::vector<Part> parts(static_cast<std::size_t>(processes));
    for (Part& part : parts) {{
      if (std::scanf("%d", &count) != 1) return 1;
      for (int i = 0; i < count && std::scanf("%d", &k) == 1; ++i) part.messages.push_back(k);
      double ns;
      for (int i = 0; i <= count && std::scanf("%lf", &ns) == 1; ++i) part.stretches.push_back(ns);
    }}
    std::printf("%.17g\\n", makespan(parts, messages, Hop{{{hop}}}));
  }}
}}
"""


@pytest.fixture(scope="module")
def harness(builder: Builder) -> Path:
    source = HARNESS.format(hop=", ".join(map(str, HOP)))
    return builder.compile(source, "makespan")


@st.composite
def plays(draw: st.DrawFn) -> tuple[list[tuple[int, int, int]], list[list[tuple[int, float]]]]:
    """Messages, some used more than once, and what each process does: messages, each after ns."""
    processes = draw(st.integers(1, 5))
    pairs = [(a, b) for a in range(processes) for b in range(processes) if a != b]
    kinds = draw(st.lists(st.sampled_from(pairs), max_size=5)) if pairs else []
    messages = [(a, b, draw(st.integers(0, 40))) for a, b in kinds]
    done: list[list[tuple[int, float]]] = [[] for _ in range(processes)]
    waiting: list[int] = []
    length = st.integers(0, 200).map(float)
    for _ in range(draw(st.integers(0, 12)) if messages else 0):
        arrives = draw(st.booleans())
        if waiting and arrives:
            k = waiting.pop(draw(st.integers(0, len(waiting) - 1)))
            done[messages[k][1]].append((k, draw(length)))
        else:
            k = draw(st.integers(0, len(messages) - 1))
            done[messages[k][0]].append((k, draw(length)))
            waiting.append(k)
    for k in waiting:
        done[messages[k][1]].append((k, draw(length)))
    return messages, [[*own, (-1, draw(length))] for own in done]


def longest(messages: list[tuple[int, int, int]], plays: list[list[tuple[int, float]]]) -> float:
    """Return the makespan: when each process is done with its first things, by recursion."""
    send, latency, number = HOP

    @cache
    def done(p: int, at: int) -> float:
        if at == 0:
            return 0.0
        k, length = plays[p][at - 1]
        ready = done(p, at - 1) + length
        if k < 0:
            return ready
        source, _, size = messages[k]
        if source == p:
            return ready + send + number * size / 2
        nth = sum(k == other for other, _ in plays[p][:at])
        uses = [i for i, (other, _) in enumerate(plays[source], start=1) if other == k]
        return max(ready, done(source, uses[nth - 1]) + latency) + number * size / 2

    return max(done(p, len(own)) for p, own in enumerate(plays))


@settings(max_examples=15, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(cases=st.lists(plays(), min_size=1, max_size=10))
def test_known_stretches_are_played_through(harness: Path, cases: list[Any]) -> None:
    words: list[object] = []
    for messages, parts in cases:
        words += [len(parts), len(messages), *(x for message in messages for x in message)]
        for part in parts:
            words += [len(part) - 1, *(k for k, _ in part[:-1]), *(ns for _, ns in part)]
    done = subprocess.run(
        [harness], input=" ".join(map(str, words)), capture_output=True, text=True, check=True
    )
    expected = [longest(messages, parts) for messages, parts in cases]
    assert [float(line) for line in done.stdout.split()] == pytest.approx(expected, rel=1e-12)


def report(solver: Solver, *words: str | Path) -> dict[str, Any]:
    done = solver.run("--json", "--repeat", "3", *words)
    assert (done.status, done.stderr) == (0, "")
    told = json.loads(done.stdout)
    assert isinstance(told, dict)
    return told


def check_told(time: dict[str, Any], plan: Plan) -> None:
    """Check what is said of times that are from stretches: a process without steps has no time."""
    assert (time["source"], time["evaluations"], time["pinned"]) == ("stretches", 192, False)
    for ns, process in zip(time["work_ns"], plan.processes, strict=True):
        assert ns > 0 if process.steps else ns >= 0
    for way in ("in_place", "through_root"):
        figures = time[way]
        assert 0 < figures["min_ns"] <= figures["median_ns"] <= figures["p99_ns"]
    assert time["through_root"]["median_ns"] < 1e6  # stretches of computing, no waiting


@pytest.mark.slow
@pytest.mark.parametrize("channel", ["window", "message"])
def test_refined_answers_on_four_processes(builder: Builder, channel: str, tmp_path: Path) -> None:
    """Messages are used more than once in an evaluation; afterwards the channel is as it was."""
    plan = plan_of(serial_chain(8), 4)
    solver = builder.solver(plan, refine=1)
    words = ("--check", "--stretches", "--channel", channel, "--trace", tmp_path / "t.json")
    told = report(solver, *words)
    assert told["check"]["ok"]
    check_told(told["time"], plan)
    assert json.loads((tmp_path / "t.json").read_text())["evaluations"] == 192


@pytest.mark.parametrize("processes", [4, slow(8)])
def test_more_processes_than_cores(processes: int, builder: Builder) -> None:
    plan = plan_of(serial_chain(8), processes, form="ada")
    solver = builder.solver(plan)
    told = report(solver, "--time")
    assert told["time"]["source"] == ("stretches" if cores() < processes else "clock")
    if cores() < processes:
        check_told(told["time"], plan)
        text = solver.run("--time", "--repeat", "1").stdout
        assert f"{cores()} cores for {processes} processes: a wall time would mean nothing" in text


def test_the_source_holds_what_messages_are_taken_to_cost() -> None:
    text = text_of(plan_of(serial_chain(3), 2))
    costs = load_profile("default").steps
    assert costs is not None
    told = (
        ", ".join(f"{1e3 * x:g}" for x in (hop.send, hop.latency, hop.number))
        for hop in (costs.window, costs.message)
    )
    assert "Hops kHops = {{" + "}, {".join(told) + "}};" in text
