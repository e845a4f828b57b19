"""Accuracy beside speed: work-precision diagrams of every way to compute the same accelerations."""

from adagen.chart.budget import Budget, parse_budget
from adagen.chart.record import Chart, Point, front, read_chart, write_csv, write_json
from adagen.chart.study import Study, chart_of
from adagen.chart.variants import Variant, every_variant

__all__ = [
    "Budget",
    "Chart",
    "Point",
    "Study",
    "Variant",
    "chart_of",
    "every_variant",
    "front",
    "parse_budget",
    "read_chart",
    "write_csv",
    "write_json",
]
