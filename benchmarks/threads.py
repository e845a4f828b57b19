"""Threads of one program beside MPI processes with a window: ``python -m benchmarks.threads``.

    python -m benchmarks.threads [--rounds 9] [--page]

Each robot is solved on two processes by one plan, as threads and as MPI processes that exchange
through a window, timed by turns; state and accelerations go through process 0 in both. Then a
program calls the threads at 1 kHz: what processor time they take between calls is read from the
kernel's clock of each thread, and the calls are timed, with what it takes to wake the threads up.
Nothing is asserted: figures of one machine are no test.
--page writes the tables into docs/records/threads.md.
"""

from __future__ import annotations

import os
import subprocess
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from statistics import median

from adagen.build import Toolchain, build_executable, find_toolchain
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.types import THREADS
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule
from adagen.studies.bench.contest import Times
from adagen.studies.bench.machine import machine
from adagen.studies.bench.report import table
from adagen.urdf import read_robot
from benchmarks.page import MODELS, command, publish
from benchmarks.solvers import by_turns, contestant, source_of

ROBOTS = {"arm7": False, "humanoid": True, "human40": False, "chain16": False}
"""Shipped robots, and whether they stand on a floating base."""

CALLS = 3000
_LOOP = """
#include <time.h>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>
#include <dirent.h>
#include <unistd.h>

namespace {

// Nanoseconds that all threads of this program but the first have run.
long long of_others() {
  long long sum = 0;
  char path[100];
  DIR* const tasks = opendir("/proc/self/task");
  while (const dirent* const task = readdir(tasks)) {
    if (task->d_name[0] == '.' || std::atoi(task->d_name) == getpid()) continue;
    std::snprintf(path, sizeof path, "/proc/self/task/%s/schedstat", task->d_name);
    long long own = 0;
    if (FILE* const file = std::fopen(path, "r")) {
      if (std::fscanf(file, "%lld", &own) == 1) sum += own;
      std::fclose(file);
    }
  }
  closedir(tasks);
  return sum;
}

// Nanoseconds between two times.
long long between(const timespec& a, const timespec& b) {
  return (b.tv_sec - a.tv_sec) * 1000000000LL + b.tv_nsec - a.tv_nsec;
}

}  // namespace

// A loop of 1 kHz: prints the share of a core, in per cent, that each further thread takes, and the
// median time of a call, in us.
int main(int, char** words) {
  static Number q[kNq], v[kNv], tau[kNtau], qdd[kNqdd];
  for (const JointConstants& joint : kJoints)
    if (joint.nq > joint.nv) q[joint.q + joint.nq - 1] = 1;
  static Solver solver;
  if (!solver.open(nullptr, 10).empty()) return 1;
  std::vector<long long> times;
  timespec next, start, end;
  clock_gettime(CLOCK_MONOTONIC, &next);
  const int calls = std::atoi(words[1]);
  const long long before = of_others();
  for (int k = 0; k < calls; ++k) {
    clock_gettime(CLOCK_MONOTONIC, &start);
    if (solver.solve(q, v, tau, qdd) != kFine) return 2;
    clock_gettime(CLOCK_MONOTONIC, &end);
    times.push_back(between(start, end));
    next.tv_nsec += 1000000;
    if (next.tv_nsec >= 1000000000) next.tv_nsec -= 1000000000, ++next.tv_sec;
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, nullptr);
  }
  std::printf("%.9g ", double(of_others() - before) / (kProcesses - 1) / calls / 1e4);
  std::sort(times.begin(), times.end());
  std::printf("%.9g\\n", double(times[times.size() / 2]) / 1e3);
  return 0;
}
"""


def plan_of(model: Model) -> Plan:
    """Return the plan of a robot on two processes, whose work is cut in halves."""
    schedule = named_schedule("balanced", Topology.of(model), 2, profile=load_profile("default"))
    return make_plan(model, schedule)


def latency(
    models: dict[str, Model], rounds: int, toolchain: Toolchain
) -> Iterator[tuple[str, ...]]:
    """Yield the rows of the table of times."""
    contestants = []
    for name, model in models.items():
        plan = plan_of(model)
        for what, own in (("window", plan), ("threads", replace(plan, channel=THREADS))):
            text = source_of(own)
            contestants.append(contestant(f"{name} {what}", model, own, text, toolchain))
    times = by_turns(contestants, rounds)
    for name in models:
        window = times[f"{name} window"]["through_root"]
        threads = times[f"{name} threads"]["in_place"]
        yield _row(name, window, threads)


def _row(name: str, window: Times, threads: Times) -> tuple[str, ...]:
    above = median(b - a for a, b in zip(window.turns, threads.turns, strict=True))
    medians = f"{window.median / 1e3:.2f}", f"{threads.median / 1e3:.2f}", f"{above / 1e3:+.2f}"
    return name, *medians, f"{window.least / 1e3:.2f}", f"{threads.least / 1e3:.2f}"


def idle(model: Model, toolchain: Toolchain) -> tuple[float, float]:
    """Return the share of a core, in per cent, that a thread takes at 1 kHz, and us of a call."""
    plan = replace(plan_of(model), channel=THREADS)
    source = f"#define ADAGEN_NO_MAIN\n{source_of(plan)}{_LOOP}"
    threaded = replace(toolchain, flags=(*toolchain.flags, "-pthread"))
    program = build_executable(source, "idle", threaded)
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [program, str(CALLS)], capture_output=True, text=True, cwd=folder, check=True
        )
    share, call = map(float, done.stdout.split())
    return share, call


def main() -> None:
    """Measure, and print or write what came of it."""
    parser = command(__doc__, "records/threads.md")
    parser.add_argument("--rounds", type=int, default=9)
    options = parser.parse_args()
    toolchain = find_toolchain()
    models = {
        name: read_robot(MODELS / f"{name}.urdf", floating=floating).model
        for name, floating in ROBOTS.items()
    }
    rows = list(latency(models, options.rounds, toolchain))
    scheduling = "real-time priority" if os.sched_getscheduler(0) else "ordinary priority"
    idle_rows = []
    for name, model in models.items():
        share, call = idle(model, toolchain)
        idle_rows.append((name, f"{share:.1f} %", f"{call:.1f}"))
    least = ("window, least", "threads, least")
    at_1_khz = "a core at 1 kHz, each further thread"
    text = "\n".join(
        [
            f"Machine: virtual, 2 cores of an {machine()['processor']}, {scheduling}.",
            "",
            *table(("robot", "window, us", "threads, us", "threads above", *least), rows),
            "",
            *table(("robot", f"share of {at_1_khz}", "a call, us"), idle_rows),
        ]
    )
    publish(options, "threads", text)


if __name__ == "__main__":
    main()
