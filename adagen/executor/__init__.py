"""Definition of a plan's steps: each step's meaning is defined here, and only here.

The steps run over expressions (adagen/graph), one graph for each process. Numbers, text and
operation counts are all taken from the graphs.
"""

from __future__ import annotations

from adagen.executor.checks import SINGULAR, Check
from adagen.executor.lanes import Grouping
from adagen.executor.machine import RECEIVED, Machine
from adagen.executor.run import PlanError, Simulated
from adagen.executor.solve import Run, interpret
from adagen.executor.straight import (
    chosen_grouping,
    counted_stretches,
    groupings,
    simulate,
    straight_line,
)
from adagen.executor.stretches import Stretch, at_once, stretches, work_of
from adagen.executor.swept import KEPT, Swept

__all__ = [
    "KEPT",
    "RECEIVED",
    "SINGULAR",
    "Check",
    "Grouping",
    "Machine",
    "PlanError",
    "Run",
    "Simulated",
    "Stretch",
    "Swept",
    "at_once",
    "chosen_grouping",
    "counted_stretches",
    "groupings",
    "interpret",
    "simulate",
    "straight_line",
    "stretches",
    "work_of",
]
