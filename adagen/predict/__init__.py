"""How long a plan takes on a machine, step by step, as its cost profile tells."""

from adagen.predict.simulate import predict, program_of
from adagen.predict.straight import goes_straight, is_priced

__all__ = [
    "goes_straight",
    "is_priced",
    "predict",
    "program_of",
]
