"""The command line: the only place that knows all stages."""

from adagen.cli.main import main

__all__ = ["main"]
