"""How long a plan takes on a machine, step by step, as its cost profile tells."""

from adagen.predict.best import best_schedule
from adagen.predict.choose import choose_processes, predicted_time
from adagen.predict.features import step_time, work_time
from adagen.predict.simulate import predict, program_of
from adagen.predict.straight import goes_straight, is_priced

__all__ = [
    "best_schedule",
    "choose_processes",
    "goes_straight",
    "is_priced",
    "predict",
    "predicted_time",
    "program_of",
    "step_time",
    "work_time",
]
