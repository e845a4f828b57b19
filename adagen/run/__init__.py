"""Runs emitted executables, with mpiexec for several processes."""

from adagen.run.launch import Completed, cores, fresh_copy, launch
from adagen.run.noise import without_launcher_noise

__all__ = ["Completed", "cores", "fresh_copy", "launch", "without_launcher_noise"]
