"""Search for schedules by predicted time: families of candidates, and proven bounds."""

from adagen.search.best import best_schedule
from adagen.search.named import named_schedule
from adagen.search.process_count import choose_processes, predicted_time
from adagen.search.schedule_file import schedule_from_json
from adagen.search.schedules import find_schedule

__all__ = [
    "best_schedule",
    "choose_processes",
    "find_schedule",
    "named_schedule",
    "predicted_time",
    "schedule_from_json",
]
