"""Accuracy beside speed: work-precision diagrams of every way to compute the same accelerations."""

from adagen.studies.chart.budget import Budget, parse_budget
from adagen.studies.chart.record import (
    Chart,
    Point,
    front,
    mechanism_of,
    read_chart,
)
from adagen.studies.chart.study import Study, chart_of
from adagen.studies.chart.variants import Variant, every_variant

__all__ = [
    "Budget",
    "Chart",
    "Point",
    "Study",
    "Variant",
    "chart_of",
    "every_variant",
    "front",
    "mechanism_of",
    "parse_budget",
    "read_chart",
]
