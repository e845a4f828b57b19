"""What the steps of a plan mean: the one place where it is told.

The steps run over expressions (adagen/graph), one graph for each process; whoever wants numbers,
text or counts takes them from the graphs.
"""

from __future__ import annotations

from adagen.executor.checks import Check
from adagen.executor.machine import RECEIVED, Machine
from adagen.executor.run import Simulated, simulate

__all__ = ["RECEIVED", "Check", "Machine", "Simulated", "simulate"]
