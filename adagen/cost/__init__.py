"""What a program takes on a machine: the one price that is searched by, drawn and printed."""

from adagen.cost.features import Features, operation_features, step_features
from adagen.cost.lanes import programmed, with_recovery
from adagen.cost.play import Exchange, Interval, Timeline, timeline

__all__ = [
    "Exchange",
    "Features",
    "Interval",
    "Timeline",
    "operation_features",
    "programmed",
    "step_features",
    "timeline",
    "with_recovery",
]
