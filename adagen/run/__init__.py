"""Runs emitted executables, with mpiexec for several processes."""

from adagen.run.launch import Completed, launch
from adagen.run.noise import without_launcher_noise
from adagen.run.page_layout import fresh_copy

__all__ = ["Completed", "fresh_copy", "launch", "without_launcher_noise"]
