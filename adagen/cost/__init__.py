"""Predicted time of a program on a machine: the only price, for search, drawings and reports."""

from adagen.cost.features import Features, operation_features, step_features
from adagen.cost.lane_choice import programmed, with_recovery
from adagen.cost.simulation import Exchange, Interval, Timeline, state_time, timeline

__all__ = [
    "Exchange",
    "Features",
    "Interval",
    "Timeline",
    "operation_features",
    "programmed",
    "state_time",
    "step_features",
    "timeline",
    "with_recovery",
]
