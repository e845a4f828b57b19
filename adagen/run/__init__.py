"""Runs emitted executables, with mpiexec for several processes."""

from adagen.run.launch import Completed, cores, launch
from adagen.run.noise import without_launcher_noise
from adagen.run.page_layout import fresh_copy

__all__ = ["Completed", "cores", "fresh_copy", "launch", "without_launcher_noise"]
