"""Schedules searched at the price that is played: families of candidates, and what is proven."""

from adagen.search.best import best_schedule
from adagen.search.choose import choose_processes, predicted_time

__all__ = ["best_schedule", "choose_processes", "predicted_time"]
