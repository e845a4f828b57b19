"""What a call from Python costs beyond the C function: ``python -m benchmarks.python_call``.

One state a call, with ``out`` and without, beside one state of many, which is solved by the C
function alone; the least of several rounds, run by turns.
Many states of one call on one thread and on two. What it would cost to release the interpreter's
lock in each call: of a call alone, beside a thread that computes in Python, and of two threads that
call solvers of their own.
--page writes it into docs/how_to/python.md.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from pathlib import Path
from timeit import timeit

import numpy as np

import adagen
from adagen.states import random_states
from adagen.studies.bench.machine import machine
from benchmarks.page import MODELS, command, publish

ROUNDS, CALLS, STATES, SHARED = 15, 20_000, 1000, 20_000
SECONDS = 1.0


def measured(model: Path) -> dict[str, float]:
    """Return the least times by what is called, nanoseconds a state."""
    compiled = adagen.compile(adagen.read(model))
    solver = compiled.build()
    states = random_states(compiled.model, STATES, seed=1)
    q, v, tau = (np.ascontiguousarray(x[0]) for x in states.parts)
    out, many = np.empty_like(v), np.empty_like(states.v)
    all_q, all_v, all_tau = (np.tile(x, (SHARED // STATES, 1)) for x in states.parts)
    all_out = np.empty_like(all_v)
    calls: dict[str, tuple[Callable[[], object], int, int]] = {
        "one of many": (lambda: solver(states.q, states.v, states.tau, out=many), 20, STATES),
        "with out": (lambda: solver(q, v, tau, out=out), CALLS, 1),
        "without": (lambda: solver(q, v, tau), CALLS, 1),
        "an empty lambda": (lambda: None, CALLS, 1),
        "on one thread": (lambda: solver(all_q, all_v, all_tau, out=all_out, threads=1), 2, SHARED),
        "on two threads": (
            lambda: solver(all_q, all_v, all_tau, out=all_out, threads=2),
            2,
            SHARED,
        ),
    }
    least = dict.fromkeys(calls, float("inf"))
    for _ in range(ROUNDS):
        for name, (call, count, states_each) in calls.items():
            least[name] = min(least[name], timeit(call, number=count) / count / states_each)
    return {name: 1e9 * time for name, time in least.items()}


def calls_a_second(call: Callable[[], object], others: list[Callable[[], object]]) -> float:
    """Return how often a call returns in a second while other threads repeat others."""
    stop = threading.Event()

    def repeat(other: Callable[[], object]) -> None:
        while not stop.is_set():
            for _ in range(1000):
                other()

    threads = [threading.Thread(target=repeat, args=(other,)) for other in others]
    for thread in threads:
        thread.start()
    count, start = 0, time.perf_counter()
    while time.perf_counter() - start < SECONDS:
        call()
        count += 1
    stop.set()
    for thread in threads:
        thread.join()
    return count / SECONDS


def of_the_lock(model: Path) -> dict[str, dict[str, float]]:
    """Return what calls cost where small ones keep the interpreter's lock, and where none does.

    Returns:
        For "kept" and "released": ns a call alone; calls a second beside a thread that computes in
        Python, and beside one that calls a solver of its own.
    """
    compiled = adagen.compile(adagen.read(model))
    states = random_states(compiled.model, 1, seed=1)
    q, v, tau = (np.ascontiguousarray(x[0]) for x in states.parts)
    calls: dict[str, list[Callable[[], object]]] = {}
    for name, below in (("kept", 1000), ("released", 0)):
        pair = [(compiled.build(), np.empty_like(v)) for _ in range(2)]
        for solver, _ in pair:
            solver.keeps_lock_below = below
        calls[name] = [lambda s=s, out=out: s(q, v, tau, out) for s, out in pair]  # type: ignore[misc]
    found: dict[str, dict[str, float]] = {name: {"alone": float("inf")} for name in calls}
    for _ in range(ROUNDS):
        for name, (call, _) in calls.items():
            once = 1e9 * timeit(call, number=CALLS) / CALLS
            found[name]["alone"] = min(found[name]["alone"], once)
    for name, (call, another) in calls.items():
        found[name]["beside Python"] = calls_a_second(call, [lambda: sum(range(100))])
        found[name]["beside another"] = calls_a_second(call, [another])
    return found


def main() -> None:
    """Measure, and print or write what came of it."""
    parser = command(__doc__, "how_to/python.md")
    parser.add_argument("model", nargs="?", type=Path, default=MODELS / "arm7.urdf")
    options = parser.parse_args()
    found = measured(options.model)
    alone, lambda_ = found["one of many"], found["an empty lambda"]
    above = {name: found[name] - lambda_ - alone for name in ("with out", "without")}
    text = (
        f"`{options.model.name}`: {alone:.0f} ns a state in C; a call from Python takes "
        f"{above['with out']:.0f} ns more with `out`, {above['without']:.0f} ns without. "
        f"{SHARED} states in one call: {found['on one thread']:.0f} ns a state on one thread, "
        f"{found['on two threads']:.0f} on two "
        f"({machine()['processor']}, load before {machine()['load_before']})."
    )
    lock = of_the_lock(options.model)
    kept, released = lock["kept"], lock["released"]
    text += (
        "\n\nIf each call released the interpreter's lock, it would take "
        f"{released['alone'] - kept['alone']:.0f} ns more alone. Beside a thread that computes in "
        f"Python, there would be {released['beside Python']:.3g} calls a second instead of "
        f"{kept['beside Python']:.3g}; beside a thread that calls another solver, "
        f"{released['beside another']:.3g} instead of {kept['beside another']:.3g}."
    )
    publish(options, "python_call", text)


if __name__ == "__main__":
    main()
