"""The command line: the only package that uses all stages."""

from adagen.cli.main import main

__all__ = ["main"]
