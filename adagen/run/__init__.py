"""Running an emitted executable under mpiexec."""

from adagen.run.anew import laid_anew
from adagen.run.launch import Completed, launch
from adagen.run.noise import without_launcher_noise

__all__ = ["Completed", "laid_anew", "launch", "without_launcher_noise"]
