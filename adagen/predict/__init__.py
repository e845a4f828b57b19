"""How long a plan takes on a machine, step by step, as its cost profile tells."""

from adagen.predict.features import features, step_time
from adagen.predict.simulate import predict

__all__ = ["features", "predict", "step_time"]
