"""Emitted solvers and other people's, side by side: one run, one machine, the same states."""

from adagen.bench.answers import Errors, Judge
from adagen.bench.contest import Contestant, Rules, Times, hold
from adagen.bench.machine import machine

__all__ = [
    "Contestant",
    "Errors",
    "Judge",
    "Rules",
    "Times",
    "hold",
    "machine",
]
