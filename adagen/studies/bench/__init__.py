"""Emitted solvers and other people's, side by side: one run, one machine, the same states."""

from adagen.studies.bench.contest import Contestant, Rules, Times, hold
from adagen.studies.bench.machine import machine

__all__ = [
    "Contestant",
    "Rules",
    "Times",
    "hold",
    "machine",
]
