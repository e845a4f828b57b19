"""How long a plan takes on a machine, step by step, as its cost profile tells."""

from adagen.predict.best import best_schedule
from adagen.predict.choose import choose_processes, predicted_time
from adagen.predict.features import features, step_time, work_time
from adagen.predict.simulate import predict
from adagen.predict.straight import goes_straight, is_priced

__all__ = [
    "best_schedule",
    "choose_processes",
    "features",
    "goes_straight",
    "is_priced",
    "predict",
    "predicted_time",
    "step_time",
    "work_time",
]
