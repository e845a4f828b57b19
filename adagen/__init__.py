"""adagen: a compiler from a robot description to parallel forward-dynamics code."""

__version__ = "0.1.0"
