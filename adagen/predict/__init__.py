"""How long a plan takes on a machine, step by step, as its cost profile tells."""

from adagen.predict.features import features, step_time, work_time
from adagen.predict.simulate import predict
from adagen.predict.straight import goes_straight, is_priced

__all__ = [
    "features",
    "goes_straight",
    "is_priced",
    "predict",
    "step_time",
    "work_time",
]
