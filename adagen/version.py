"""The version of adagen."""

__version__ = "0.1.0"
